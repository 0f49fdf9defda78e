//! Tables of the effects of an impact on ground: mass above a speed, a map of the bowl, pores over depth below the point of impact.

use std::fmt::Write;

use super::target_particle::TargetParticle;
use crate::domain::comm::Comm;
use crate::math::ExactSum;

/// Bins of speed per factor of ten.
const PER_DECADE: i32 = 10;
/// The slowest and the fastest edge, powers of ten of m/s.
const SLOWEST: i32 = -2;
const FASTEST: i32 = 5;
/// Bins of a profile at most.
const MOST_BINS: usize = 1 << 16;
/// Cells along the side of a map at most.
const MOST_CELLS: usize = 1 << 10;
/// Width of a map's cells and radius of the column below the point of impact, in spacings.
const WIDTH: f64 = 2.0;

/// Mass and volume above upward speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct Ejecta {
    pub rows: Vec<EjectaRow>,
}

/// Matter that is faster than `speed`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EjectaRow {
    /// m/s.
    pub speed: f64,
    /// kg.
    pub mass: f64,
    /// Volume before the impact, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Mass of the part that has risen above the face, kg.
    pub mass_above_face: f64,
    /// Upward momentum of the matter above the face, the projectile's included, kg m/s.
    pub momentum: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Mean depth below the face and mean distance from the axis of impact at the start, m.
    pub start: [f64; 2],
    /// Mass of the part without pores left, kg.
    pub crushed_mass: f64,
}

/// Sums of a bin: mass, volume, mass above the face, momentum, energy, mass times depth and distance at the start, mass without pores.
const SUMS: usize = 8;

impl Ejecta {
    /// Collective.
    pub fn count(comm: &Comm, particles: impl Iterator<Item = TargetParticle>) -> Self {
        let edge = |k: i32| libm::exp10(k as f64 / PER_DECADE as f64);
        let edges: Vec<f64> = (SLOWEST * PER_DECADE..=FASTEST * PER_DECADE).map(edge).collect();
        let mut sums = vec![ExactSum::new(); SUMS * edges.len()];
        for particle in particles {
            // Bin k holds speeds above edge k, up to the next.
            let Some(bin) = edges.partition_point(|edge| *edge < particle.speed).checked_sub(1) else { continue };
            let above = if particle.height > 0.0 { particle.mass } else { 0.0 };
            let mass = if particle.of_projectile { 0.0 } else { particle.mass };
            let share = mass / particle.mass;
            let crushed = if particle.is_crushed() { mass } else { 0.0 };
            let [depth, range] = particle.start.map(|length| mass * length);
            let (volume, energy) = (share * particle.volume, share * particle.energy);
            let shares = [mass, volume, share * above, above * particle.speed, energy, depth, range, crushed];
            sums[SUMS * bin..][..SUMS].iter_mut().zip(shares).for_each(|(sum, share)| sum.add(share));
        }
        comm.sum_exactly(&mut sums);
        let mut faster = [const { ExactSum::new() }; SUMS];
        let mut rows = Vec::new();
        for (bin, shares) in sums.chunks_exact(SUMS).enumerate().rev() {
            faster.iter_mut().zip(shares).for_each(|(sum, share)| sum.merge(share));
            let [mass, volume, mass_above_face, momentum, energy, depth, range, crushed_mass] =
                std::array::from_fn(|k| faster[k].value());
            if mass > 0.0 {
                let start = [depth / mass, range / mass];
                let speed = edges[bin];
                rows.push(EjectaRow { speed, mass, volume, mass_above_face, momentum, energy, start, crushed_mass });
            }
        }
        rows.reverse();
        Self { rows }
    }

    /// `ejecta.csv`. `impulse`: momentum of the projectile along the normal, kg m/s.
    pub fn table(&self, impulse: f64) -> String {
        let mut text = String::from(
            "speed_above_m_s,mass_kg,volume_before_m3,mass_above_face_kg,momentum_above_face_kg_m_s,momentum_enhancement,\
             kinetic_energy_J,start_depth_m,start_distance_m,crushed_mass_kg\n",
        );
        for row in &self.rows {
            let [depth, distance] = row.start;
            let enhancement = 1.0 + row.momentum / impulse;
            let numbers = [
                row.speed,
                row.mass,
                row.volume,
                row.mass_above_face,
                row.momentum,
                enhancement,
                row.energy,
                depth,
                distance,
                row.crushed_mass,
            ];
            let numbers: Vec<String> = numbers.iter().map(|x| format!("{x:e}")).collect();
            let _ = writeln!(text, "{}", numbers.join(","));
        }
        text
    }
}

/// How high dense matter reaches, on a map of the face.
#[derive(Debug, Clone, PartialEq)]
pub struct Bowl {
    /// m.
    spacing: f64,
    /// Cells along x, as many or one across.
    side: usize,
    /// Highest place in each cell, m above the face; negative infinity without matter.
    levels: Vec<f64>,
}

impl Bowl {
    /// The map of these particles. Collective.
    pub fn measure(
        comm: &Comm,
        dense: impl Iterator<Item = TargetParticle>,
        spacing: f64,
        extent: f64,
        dimension: usize,
    ) -> Self {
        let side = bins(extent, WIDTH * spacing).min(MOST_CELLS);
        let across = if dimension == 3 { side } else { 1 };
        let mut levels = vec![f64::NEG_INFINITY; side * across];
        let cells = |middle: f64, half: f64, count: usize| {
            let at = |x: f64| (x / (WIDTH * spacing) + 0.5 * count as f64).floor();
            let (first, last) = (at(middle - half).max(0.0), at(middle + half).min(count as f64 - 1.0));
            first as usize..(last + 1.0).max(first) as usize
        };
        for particle in dense {
            // A particle fills a cube around it, which may be wider than a cell.
            let half = 0.5 * if dimension == 3 { libm::cbrt(particle.volume) } else { particle.volume.sqrt() };
            for y in cells(particle.aside[1], half, across) {
                for level in &mut levels[y * side..][cells(particle.aside[0], half, side)] {
                    *level = level.max(particle.height + half);
                }
            }
        }
        comm.all_max(&mut levels);
        Self { spacing, side, levels }
    }

    /// Depth, to within a spacing, and radius, m, of the part that lies a spacing or more below the face.
    pub fn size(&self) -> [f64; 2] {
        let hollow = self.levels.iter().filter(|level| level.is_finite() && **level < -self.spacing);
        let (cells, lowest) = hollow.fold((0, 0.0), |(n, low): (usize, f64), level| (n + 1, low.min(*level)));
        let cell = WIDTH * self.spacing;
        let planar = self.levels.len() == self.side;
        let area = cells as f64 * if planar { cell } else { cell * cell };
        [-lowest, if planar { 0.5 * area } else { (area / std::f64::consts::PI).sqrt() }]
    }

    /// `crater.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("x_m,y_m,surface_m\n");
        let across = self.levels.len() / self.side;
        let middle = |k: usize, cells: usize| (k as f64 + 0.5 - 0.5 * cells as f64) * WIDTH * self.spacing;
        for (k, level) in self.levels.iter().enumerate().filter(|(_, level)| level.is_finite()) {
            let (x, y) = (middle(k % self.side, self.side), middle(k / self.side, across));
            let _ = writeln!(text, "{x:e},{y:e},{level:e}");
        }
        text
    }
}

/// Distention over depth, in a column below the point of impact.
#[derive(Debug, Clone, PartialEq)]
pub struct Pores {
    pub rows: Vec<PoresRow>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoresRow {
    /// Middle of the bin, m below the face.
    pub depth: f64,
    /// Mean by mass.
    pub mean: f64,
    pub least: f64,
    pub largest: f64,
}

impl Pores {
    /// Collective.
    pub fn measure(comm: &Comm, particles: impl Iterator<Item = TargetParticle>, spacing: f64, extent: f64) -> Self {
        let bins = bins(extent, spacing);
        let mut sums = vec![ExactSum::new(); 2 * bins];
        let mut ends = vec![f64::INFINITY; 2 * bins];
        for particle in particles.filter(|particle| from_axis(particle) < WIDTH * spacing && particle.height <= 0.0) {
            let (Some([now, _]), bin) = (particle.distention, (-particle.height / spacing) as usize) else { continue };
            if bin < bins {
                sums[2 * bin].add(particle.mass);
                sums[2 * bin + 1].add(particle.mass * now);
                ends[2 * bin] = ends[2 * bin].min(now);
                ends[2 * bin + 1] = ends[2 * bin + 1].min(-now);
            }
        }
        comm.all_min(&mut ends);
        let values = comm.sum_exactly(&mut sums);
        let value = |k: usize| values[k];
        let filled = (0..bins).filter(|bin| ends[2 * bin].is_finite());
        let row = |bin: usize| PoresRow {
            depth: (bin as f64 + 0.5) * spacing,
            mean: value(2 * bin + 1) / value(2 * bin),
            least: ends[2 * bin],
            largest: -ends[2 * bin + 1],
        };
        Self { rows: filled.map(row).collect() }
    }

    /// `distention.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("depth_m,distention,least,largest\n");
        for row in &self.rows {
            let _ = writeln!(text, "{:e},{:e},{:e},{:e}", row.depth, row.mean, row.least, row.largest);
        }
        text
    }
}

/// Distance from the axis through the point of impact, m.
fn from_axis(particle: &TargetParticle) -> f64 {
    (particle.aside[0] * particle.aside[0] + particle.aside[1] * particle.aside[1]).sqrt()
}

fn bins(extent: f64, width: f64) -> usize {
    ((extent / width).ceil() as usize).clamp(1, MOST_BINS)
}
