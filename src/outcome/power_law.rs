//! Masses of fragments as a power law (Geretshauser et al. 2010, A&A 513, A58, Sects. 3.3 and 5.3, eq. 24, as a cumulative distribution).
//!
//! ```text
//! F(m)         mass of all pieces up to m, that of m included, over the mass of all
//! power law    F = (m / mu)^alpha            mu: where it reaches one, over the mass of all
//! fit          ln F = alpha ln m + b by least squares, one point per fragment of enough particles; mu = exp(-b / alpha)
//! errors       standard errors of that fit, from the scatter around it
//! scatter      of alpha, if every tenth fragment, ordered by mass, is left out in turn (jackknife): points of a cumulative distribution
//!              are not independent of each other, and the standard error does not know
//! ```

/// Groups of the jackknife.
const GROUPS: usize = 10;
/// Points of a fit at least.
pub const FEWEST: usize = 3;

/// A fitted power law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    pub slope: f64,
    pub slope_error: f64,
    /// Over the mass of all.
    pub largest: f64,
    pub largest_error: f64,
    /// None of fewer than two fragments per group.
    pub scatter: Option<f64>,
}

impl PowerLaw {
    /// F at this mass over that of all.
    pub fn at(&self, mass: f64) -> f64 {
        libm::pow(mass / self.largest, self.slope)
    }
}

/// Masses over that of all, and F at each: `masses` falls, kg; `total`: of all pieces, smaller ones included, kg.
pub fn cumulative(masses: &[f64], total: f64) -> Vec<[f64; 2]> {
    let mut below = total;
    let row = |mass: &f64| {
        let share = below / total;
        below -= mass;
        [mass / total, share]
    };
    masses.iter().map(row).collect()
}

/// The power law of these fragments; none of fewer than [`FEWEST`], or where all are alike.
pub fn fit(masses: &[f64], total: f64) -> Option<PowerLaw> {
    let law = least_squares(&cumulative(masses, total))?;
    let without = |group: usize| {
        let left_out = |k: &usize| k % GROUPS == group;
        let kept: Vec<f64> = (0..masses.len()).filter(|k| !left_out(k)).map(|k| masses[k]).collect();
        let lost: f64 = (0..masses.len()).filter(left_out).map(|k| masses[k]).sum();
        least_squares(&cumulative(&kept, total - lost)).map(|law| law.slope)
    };
    let slopes: Vec<f64> = (0..GROUPS).filter(|_| masses.len() >= 2 * GROUPS).filter_map(without).collect();
    let mean = slopes.iter().sum::<f64>() / slopes.len() as f64;
    let squares: f64 = slopes.iter().map(|slope| (slope - mean) * (slope - mean)).sum();
    let scatter = (slopes.len() == GROUPS).then(|| ((GROUPS - 1) as f64 / GROUPS as f64 * squares).sqrt());
    Some(PowerLaw { scatter, ..law })
}

fn least_squares(points: &[[f64; 2]]) -> Option<PowerLaw> {
    let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(libm::log)).collect();
    let n = points.len() as f64;
    let mean = |k: usize| points.iter().map(|point| point[k]).sum::<f64>() / n;
    let [x, y] = [mean(0), mean(1)];
    let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|[a, b]| of(a - x, b - y)).sum::<f64>();
    let (xx, xy) = (sum(&|a, _| a * a), sum(&|a, b| a * b));
    // NaN: pieces of more than all.
    if points.len() < FEWEST || xx.is_nan() || xx <= 1e-12 * n || xy.is_nan() || xy <= 0.0 {
        return None;
    }
    let slope = xy / xx;
    let variance = sum(&|a, b| (b - slope * a) * (b - slope * a)) / (n - 2.0);
    // ln mu = x - y / slope; slope and y have independent errors.
    let largest = libm::exp(x - y / slope);
    let slope_error = (variance / xx).sqrt();
    let of_log = (variance / n + (y / slope * slope_error) * (y / slope * slope_error)).sqrt() / slope;
    Some(PowerLaw { slope, slope_error, largest, largest_error: largest * of_log, scatter: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Masses whose F is that of the law times exp(noise) exactly; the mass of all is one. From the largest down, F falls by the mass.
    fn masses(slope: f64, noise: impl Fn(usize) -> f64, number: usize) -> Vec<f64> {
        let mut left = 1.0;
        let mass = |k: usize| {
            // F(m) = left = (m / mu)^slope exp(noise) with mu = 0.2.
            let m = 0.2 * libm::pow(left * libm::exp(-noise(k)), 1.0 / slope);
            left -= m;
            m
        };
        (0..number).map(mass).collect()
    }

    #[test]
    fn a_power_law_gives_back_its_slope() {
        let found = fit(&masses(0.67, |_| 0.0, 40), 1.0).unwrap();
        assert!((found.slope - 0.67).abs() < 1e-10 && (found.largest - 0.2).abs() < 1e-10, "{found:?}");
        assert!(found.slope_error < 1e-10 && found.largest_error < 1e-10, "{found:?}");
        // Leaving fragments out changes the law itself, but little.
        assert!(found.scatter.is_some_and(|scatter| scatter < 0.1), "{found:?}");
    }

    /// The errors are those of the textbook's formulae, and cover what a known scatter does to the slope.
    #[test]
    fn errors_follow_the_scatter() {
        let draw = |seed: u64| move |k: usize| 0.1 * (crate::random::uniform(seed, k as u64, 0) - 0.5);
        let found: Vec<PowerLaw> = (0..200).map(|seed| fit(&masses(0.67, draw(seed), 40), 1.0).unwrap()).collect();
        let spread = |value: fn(&PowerLaw) -> f64| {
            let mean = found.iter().map(value).sum::<f64>() / 200.0;
            (found.iter().map(|law| (value(law) - mean) * (value(law) - mean)).sum::<f64>() / 199.0).sqrt()
        };
        let mean = |value: fn(&PowerLaw) -> f64| found.iter().map(value).sum::<f64>() / 200.0;
        let (slope, error) = (spread(|law| law.slope), mean(|law| law.slope_error));
        assert!((error / slope - 1.0).abs() < 0.3, "{error} {slope}");
        let (largest, error) = (spread(|law| law.largest), mean(|law| law.largest_error));
        assert!((error / largest - 1.0).abs() < 0.4, "{error} {largest}");
    }

    #[test]
    fn too_few_or_equal_fragments_have_no_law() {
        assert_eq!(fit(&[0.5, 0.3], 1.0), None);
        assert_eq!(fit(&[0.1; 9], 1.0), None);
        assert_eq!(cumulative(&[0.5, 0.25], 1.0), [[0.5, 1.0], [0.25, 0.5]]);
        assert!(fit(&masses(0.67, |_| 0.0, 12), 1.0).unwrap().scatter.is_none());
    }
}
