//! Curves through points that never overshoot them: cubics whose slopes are limited (Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5,
//! 300).

/// The slope at each of the points, by weighted harmonic means of the secants beside it; zero where they differ in sign. `x` rises.
pub fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    if n < 2 {
        return vec![0.0; n];
    }
    let steps: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let secants: Vec<f64> = y.windows(2).zip(&steps).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    let mut slopes = vec![0.0; n];
    for k in 1..n - 1 {
        let ([before, after], [h_before, h_after]) = ([secants[k - 1], secants[k]], [steps[k - 1], steps[k]]);
        if before * after > 0.0 {
            let (w, v) = (2.0 * h_after + h_before, h_after + 2.0 * h_before);
            slopes[k] = (w + v) / (w / before + v / after);
        }
    }
    slopes[0] = at_end(&secants, &steps, [0, 1]);
    slopes[n - 1] = at_end(&secants, &steps, [n - 2, n.saturating_sub(3)]);
    slopes
}

/// The slope at an end from the parabola through three points, limited as the others; `nearest` are the secants beside it.
fn at_end(secants: &[f64], steps: &[f64], nearest: [usize; 2]) -> f64 {
    let d = secants[nearest[0]];
    let Some((&next, &h_next)) = secants.get(nearest[1]).zip(steps.get(nearest[1])).filter(|_| secants.len() > 1)
    else {
        return d;
    };
    let h = steps[nearest[0]];
    let slope = ((2.0 * h + h_next) * d - h * next) / (h + h_next);
    match () {
        () if slope * d <= 0.0 => 0.0,
        () if d * next <= 0.0 && slope.abs() > 3.0 * d.abs() => 3.0 * d,
        () => slope,
    }
}

/// Weights of the values and of the slopes (per step) at both ends of an interval, at the share `t` of it.
#[inline]
pub fn weights(t: f64) -> [f64; 4] {
    let (s, u) = (t * t, 1.0 - t);
    [u * u * (1.0 + 2.0 * t), s * (3.0 - 2.0 * t), t * u * u, -s * u]
}

/// Derivatives of the [`weights`] by t.
#[inline]
pub fn slope_weights(t: f64) -> [f64; 4] {
    let bow = 6.0 * t * (1.0 - t);
    [-bow, bow, (1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0)]
}

/// A curve at a place within its points, and along the secant of its last slope beyond them.
pub fn at(x: &[f64], y: &[f64], slopes: &[f64], place: f64) -> f64 {
    let last = x.len() - 1;
    if place <= x[0] {
        return y[0] + (place - x[0]) * slopes[0];
    }
    if place >= x[last] {
        return y[last] + (place - x[last]) * slopes[last];
    }
    let k = x.partition_point(|&x| x <= place) - 1;
    let h = x[k + 1] - x[k];
    let w = weights((place - x[k]) / h);
    w[0] * y[k] + w[1] * y[k + 1] + h * (w[2] * slopes[k] + w[3] * slopes[k + 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Third order where the curve is smooth, and no overshoot where it has a corner.
    #[test]
    fn curves_are_smooth_and_stay_between_their_points() {
        let error = |n: usize| {
            let x: Vec<f64> = (0..=n).map(|k| k as f64 / n as f64).collect();
            let y: Vec<f64> = x.iter().map(|x| libm::exp(2.0 * x)).collect();
            let m = slopes(&x, &y);
            let off = |k: usize| {
                let place = (k as f64 + 0.37) / 1000.0;
                (at(&x, &y, &m, place) - libm::exp(2.0 * place)).abs()
            };
            (0..1000).map(off).fold(0.0, f64::max)
        };
        assert!(error(20) < 1e-3 && error(40) < error(20) / 6.0, "{} {}", error(20), error(40));
        let (x, y) = ([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 0.0, 0.0, 5.0, 5.0]);
        let m = slopes(&x, &y);
        let values: Vec<f64> = (0..=400).map(|k| at(&x, &y, &m, 0.01 * k as f64)).collect();
        let rounding = 1e-14;
        assert!(values.windows(2).all(|pair| pair[0] <= pair[1] + rounding));
        assert!(values.iter().all(|y| (-rounding..=5.0 + rounding).contains(y)));
        assert_eq!(slopes(&[1.0, 3.0], &[0.0, 4.0]), [2.0, 2.0]);
    }

    #[test]
    fn weights_have_their_slopes() {
        for t in [0.0, 0.2, 0.9, 1.0] {
            let (a, b, d) = (weights(t - 1e-6), weights(t + 1e-6), slope_weights(t));
            (0..4).for_each(|k| assert!(((b[k] - a[k]) / 2e-6 - d[k]).abs() < 1e-8, "{t} {k}"));
        }
    }
}
