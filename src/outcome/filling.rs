//! What a body has left of the dust that it fell into: the filling factor along the line of its fall, and how much dust is filled how
//! densely (Geretshauser et al. 2010, A&A 513, A58, Figs 5, 6, 12, 14, 15).
//!
//! ```text
//! profile        phi(x) = sum over j of V_j phi_j W(|x - x_j|, h_j)        V_j = m_j / rho_j, with and without the body's particles
//! by the peak    where phi without the body is largest, below the body's centre
//! by the gap     where phi with the body is least between its centre and that peak
//! volumes        sum of V_j over dust with phi_j > phi, over the body's volume
//! ```
//! Dust compacted by the fall lies at the peak; body and dust keep apart by about the kernel's support, which is the gap. Both places are
//! those of parabolas through three points. Sums are exact: no order of particles or ranks changes a bit.

use serde::{Deserialize, Serialize};
use std::fmt::Write;

use crate::domain::comm::Comm;
use crate::kernel::{Kernel, SUPPORT};
use crate::math::{ExactSum, Vec3};

/// Points of a profile per spacing of the dust.
const POINTS: f64 = 4.0;
/// Width of a row of the table of volumes.
const WIDTH: f64 = 0.005;
/// Rows of the table of volumes: up to a filling factor of one.
const ROWS: usize = 200;

/// A particle as the profile sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Filled {
    /// m.
    pub position: Vec3,
    /// m^3 (m^2 in 2D).
    pub volume: f64,
    pub filling_factor: f64,
    /// m.
    pub smoothing_length: f64,
    pub of: Of,
}

/// What a particle belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    Body,
    /// The dust that it falls into.
    Dust,
    Other,
}

/// The line of a fall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// A point of it, m.
    pub through: Vec3,
    pub axis: usize,
    /// Whether the fall leads up the axis (1) or down (-1).
    pub sign: f64,
    /// The undisturbed surface of the dust along the fall, m.
    pub surface: f64,
    /// Depths of its ends, m.
    pub ends: [f64; 2],
    /// Of the dust, m.
    pub spacing: f64,
    pub kernel: Kernel,
    pub dimension: usize,
}

impl Line {
    fn step(&self) -> f64 {
        self.spacing / POINTS
    }

    /// Depth of a point, m.
    pub fn depth(&self, point: &Vec3) -> f64 {
        self.sign * point[self.axis] - self.surface
    }

    fn points(&self) -> usize {
        ((self.ends[1] - self.ends[0]) / self.step()).floor().max(0.0) as usize + 1
    }

    fn depth_of(&self, point: usize) -> f64 {
        self.ends[0] + point as f64 * self.step()
    }
}

/// A point of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfileRow {
    /// Below the undisturbed surface, m.
    pub depth: f64,
    /// Filling factor without the body's particles, and with them.
    pub dust: f64,
    pub all: f64,
}

/// The filling factor along a line.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    pub rows: Vec<ProfileRow>,
}

impl Profile {
    /// Collective.
    pub fn measure(comm: &Comm, particles: impl Iterator<Item = Filled>, line: &Line) -> Self {
        Self::of(&comm.sum_exactly(&mut Self::sums(particles, line)), line)
    }

    /// Sums over these particles, two per point.
    fn sums(particles: impl Iterator<Item = Filled>, line: &Line) -> Vec<ExactSum> {
        let points = line.points();
        let mut sums = vec![ExactSum::new(); 2 * points];
        for particle in particles {
            let Filled { position, smoothing_length: h, .. } = particle;
            let mut aside = position - line.through;
            aside[line.axis] = 0.0;
            let (aside, reach) = (aside.norm_squared(), SUPPORT * h);
            if aside >= reach * reach {
                continue;
            }
            let depth = line.depth(&position);
            let place = |depth: f64| ((depth - line.ends[0]) / line.step()).clamp(0.0, points as f64);
            for point in place(depth - reach).floor() as usize..(place(depth + reach).ceil() as usize + 1).min(points) {
                let along = line.depth_of(point) - depth;
                let weight = line.kernel.value((aside + along * along).sqrt(), h, line.dimension);
                let share = particle.volume * particle.filling_factor * weight;
                sums[2 * point + 1].add(share);
                if particle.of != Of::Body {
                    sums[2 * point].add(share);
                }
            }
        }
        sums
    }

    fn of(values: &[f64], line: &Line) -> Self {
        let row =
            |(point, value): (usize, &[f64])| ProfileRow { depth: line.depth_of(point), dust: value[0], all: value[1] };
        Self { rows: values.chunks_exact(2).enumerate().map(row).collect() }
    }

    /// Depth and filling factor of the peak of the dust below the depth of the body's centre, m.
    pub fn peak(&self, centre: f64) -> Option<[f64; 2]> {
        let below = (0..self.rows.len()).filter(|&k| self.rows[k].depth >= centre);
        let k = below.max_by(|&a, &b| self.rows[a].dust.total_cmp(&self.rows[b].dust).then(b.cmp(&a)))?;
        self.extremum(k, |row| row.dust)
    }

    /// Depth and filling factor of the gap between the depths of the body's centre and of the peak, m.
    pub fn gap(&self, centre: f64, peak: f64) -> Option<[f64; 2]> {
        let between = (0..self.rows.len()).filter(|&k| (centre..peak).contains(&self.rows[k].depth));
        let k = between.min_by(|&a, &b| self.rows[a].all.total_cmp(&self.rows[b].all))?;
        self.extremum(k, |row| row.all)
    }

    /// The vertex of the parabola through a point and its neighbours, if it is an extremum among them.
    fn extremum(&self, k: usize, value: impl Fn(&ProfileRow) -> f64) -> Option<[f64; 2]> {
        let [a, b, c] = [k.checked_sub(1)?, k, k + 1].map(|k| self.rows.get(k));
        let (depth, step) = (b?.depth, c?.depth - b?.depth);
        let [a, b, c] = [value(a?), value(b?), value(c?)];
        let (slope, bend) = (0.5 * (c - a), a - 2.0 * b + c);
        let share = if bend != 0.0 { -slope / bend } else { 0.0 };
        (share.abs() <= 1.0).then_some([depth + share * step, b + 0.5 * share * slope])
    }

    /// `filling_profile.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("depth_m,filling_factor_of_dust,filling_factor_with_body\n");
        for row in &self.rows {
            let _ = writeln!(text, "{:e},{:e},{:e}", row.depth, row.dust, row.all);
        }
        text
    }
}

/// Cumulative volume over filling factor: (phi, volume of dust filled more densely over that of the body).
#[derive(Debug, Clone, PartialEq)]
pub struct Volumes {
    pub rows: Vec<[f64; 2]>,
}

impl Volumes {
    /// `body`: the body's volume, m^3 (m^2 in 2D). Collective.
    pub fn measure(comm: &Comm, particles: impl Iterator<Item = Filled>, body: f64) -> Self {
        Self::of(&comm.sum_exactly(&mut Self::sums(particles)), body)
    }

    /// Sums over these particles, one per row.
    fn sums(particles: impl Iterator<Item = Filled>) -> Vec<ExactSum> {
        let mut sums = vec![ExactSum::new(); ROWS];
        particles.filter(|particle| particle.of == Of::Dust).for_each(|particle| {
            if let Some(row) = row_of(particle.filling_factor) {
                sums[row].add(particle.volume);
            }
        });
        sums
    }

    fn of(volumes: &[f64], body: f64) -> Self {
        let filled = volumes.iter().rposition(|volume| *volume > 0.0).map_or(0, |last| last + 2).min(ROWS);
        let mut above = 0.0;
        let mut rows: Vec<[f64; 2]> = Vec::new();
        for k in (0..filled).rev() {
            above += volumes[k];
            rows.push([WIDTH * k as f64, above / body]);
        }
        rows.reverse();
        Self { rows }
    }

    /// The filling factor that a volume as large as the body's exceeds, on straight lines between rows; none where there is less dust.
    pub fn of_one_body(&self) -> Option<f64> {
        let pair = self.rows.windows(2).find(|pair| pair[0][1] >= 1.0 && pair[1][1] < 1.0)?;
        Some(pair[0][0] + WIDTH * (pair[0][1] - 1.0) / (pair[0][1] - pair[1][1]))
    }

    /// `filling_volumes.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("filling_factor,volume_above_over_body\n");
        for [phi, volume] in &self.rows {
            let _ = writeln!(text, "{phi:e},{volume:e}");
        }
        text
    }
}

/// The highest row whose filling factor this one exceeds.
fn row_of(phi: f64) -> Option<usize> {
    let mut row = ((phi / WIDTH).ceil().max(0.0) as usize).min(ROWS - 1);
    while WIDTH * row as f64 >= phi {
        row = row.checked_sub(1)?;
    }
    Some(row)
}

/// Figures of a profile, m where they are depths; none where there is no peak or gap.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Marks {
    pub peak_depth: Option<f64>,
    pub peak: Option<f64>,
    pub gap_depth: Option<f64>,
    pub gap: Option<f64>,
}

impl Marks {
    /// `centre`: depth of the body's centre, m.
    pub fn of(profile: &Profile, centre: f64) -> Self {
        let peak = profile.peak(centre);
        let gap = peak.and_then(|[depth, _]| profile.gap(centre, depth));
        let part = |found: Option<[f64; 2]>, k: usize| found.map(|found| found[k]);
        Self { peak_depth: part(peak, 0), peak: part(peak, 1), gap_depth: part(gap, 0), gap: part(gap, 1) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line() -> Line {
        let (through, ends) = (Vec3::new(0.5, 0.0, 0.0), [-1.0, 3.0]);
        let kernel = Kernel::CubicSpline;
        Line { through, axis: 1, sign: -1.0, surface: 0.0, ends, spacing: 0.1, kernel, dimension: 2 }
    }

    /// Below y = 0 a lattice filled by `phi(depth)`, above it a body of filling factor 1 down to y = `gap`.
    fn lattice(gap: f64, phi: impl Fn(f64) -> f64) -> Vec<Filled> {
        let place = |k: usize| [(k % 20) as f64 * 0.1 - 0.45, 1.95 - (k / 20) as f64 * 0.1];
        let particle = |k: usize| {
            let [x, y] = place(k);
            let (filling_factor, of) = if y > 0.0 { (1.0, Of::Body) } else { (phi(-y), Of::Dust) };
            Filled { position: Vec3::new(x, y, 0.0), volume: 0.01, filling_factor, smoothing_length: 0.2, of }
        };
        (0..1200).map(particle).filter(|p| p.of == Of::Dust || p.position.y > gap).collect()
    }

    fn values(sums: Vec<ExactSum>) -> Vec<f64> {
        sums.iter().map(ExactSum::value).collect()
    }

    fn profile(particles: Vec<Filled>) -> Profile {
        Profile::of(&values(Profile::sums(particles.into_iter(), &line())), &line())
    }

    #[test]
    fn a_profile_is_that_of_the_particles() {
        let profile = profile(lattice(0.0, |_| 0.2));
        assert_eq!(profile.rows.len(), 161);
        for row in &profile.rows {
            let (dust, all) = match row.depth {
                depth if depth < -0.41 => (0.0, 1.0),
                depth if depth > 0.41 => (0.2, 0.2),
                _ => continue,
            };
            assert!((row.dust - dust).abs() < 0.01 && (row.all - all).abs() < 0.01, "{row:?}");
        }
        // A point in the middle of the surface sees half of each.
        let middle = profile.rows[40];
        assert!(middle.depth.abs() < 1e-12 && (middle.dust - 0.1).abs() < 0.003, "{middle:?}");
    }

    /// Dust is densest 0.8 deep, and the body ends 0.4 above the surface.
    #[test]
    fn peak_and_gap_are_found_between_points() {
        let phi = |depth: f64| (0.3 - 0.5 * (depth - 0.81) * (depth - 0.81)).max(0.05);
        let profile = profile(lattice(0.4, phi));
        let marks = Marks::of(&profile, -0.9);
        assert!((marks.peak_depth.unwrap() - 0.81).abs() < 0.02, "{marks:?}");
        assert!((marks.peak.unwrap() - 0.3).abs() < 0.01, "{marks:?}");
        // Between the last particles of both, at 0.45 above and at 0.05 below; nearer to the less filled.
        let gap = marks.gap_depth.unwrap();
        assert!((-0.2..0.0).contains(&gap) && marks.gap.unwrap() < 0.05, "{marks:?}");
    }

    #[test]
    fn volumes_are_summed_from_the_top() {
        let particle = |k: usize, of| Filled { filling_factor: 0.15 + 0.01 * k as f64, of, ..lattice(9.0, |_| 0.0)[0] };
        let particles = (0..10).map(|k| particle(k, Of::Dust)).chain([particle(85, Of::Body)]);
        let volumes = Volumes::of(&values(Volumes::sums(particles)), 0.02);
        let above = |phi: f64| volumes.rows.iter().find(|row| (row[0] - phi).abs() < 1e-9).unwrap()[1];
        assert!((above(0.0) - 5.0).abs() < 1e-12 && (above(0.145) - 5.0).abs() < 1e-12);
        // As filled as that is not filled more.
        assert!((above(0.15) - 4.5).abs() < 1e-12 && (above(0.2) - 2.0).abs() < 0.5 + 1e-12);
        assert_eq!((above(0.24), volumes.rows.len()), (0.0, 49));
    }
}
