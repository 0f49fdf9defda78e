//! A heap on level ground: how far its matter lies from the line of the fall through the middle of the body, and how high (columns of sand
//! of Lube et al. 2004, J. Fluid Mech. 508, 175; 2005, Phys. Rev. E 72, 041301).
//!
//! ```text
//! out       distance from that line; where an axis is periodic, across it
//! heights   over out, in bins of two spacings: of the highest particle, the mean of both sides of a channel, or of eight sectors
//! height    the largest of them
//! foot      the outer end of the last bin that is higher than two layers of particles
//! foot_99   within which 99 of 100 particles lie: better where two layers are a large part of the heap
//! flank     slope of heights between a fifth and four fifths of the height, by least squares
//! ```

use super::particle::Particle;
use crate::domain::comm::Comm;
use crate::math::{ExactSum, Line, Vec3};

/// Width of a bin and thickness of two layers, in spacings.
const WIDTH: f64 = 2.0;
/// Parts of a bin, for the quantile.
const PARTS: usize = 64;
const QUANTILE: f64 = 0.99;
const SECTORS: usize = 8;
/// Bins at most: what flies farther lies in the last one.
const MOST_BINS: usize = 1 << 14;
/// The flank, over the height.
const FLANK: [f64; 2] = [0.2, 0.8];

/// What is asked.
#[derive(Debug, Clone, Copy)]
pub struct Question {
    /// A point on the ground below the middle of the body at the start, m.
    pub origin: Vec3,
    /// Upwards.
    pub up: Vec3,
    /// The axes along which matter runs out: one or two.
    pub out: [Option<usize>; 2],
    /// m.
    pub spacing: f64,
}

/// A heap.
#[derive(Debug, Clone, PartialEq)]
pub struct Deposit {
    /// Heights over distance, m, from the middle outwards; distances are those of the middles of bins.
    pub profile: Vec<[f64; 2]>,
    /// m; NaN where nothing is as high as two layers.
    pub foot: f64,
    /// m.
    pub foot_99: f64,
    /// m.
    pub height: f64,
    /// Rise over run, positive; NaN where fewer than three bins belong to the flank.
    pub flank: f64,
    /// Root of the mean square of speeds, m/s.
    pub speed: f64,
}

impl Deposit {
    /// Of all ranks' particles, which have one mass. Collective.
    pub fn measure(comm: &Comm, particles: &[Particle], question: &Question) -> Self {
        let width = WIDTH * question.spacing;
        let mut farthest = [particles.iter().map(|particle| question.out(particle)).fold(0.0, f64::max)];
        comm.all_max(&mut farthest);
        let bins = ((farthest[0] / width) as usize + 1).min(MOST_BINS);
        let sectors = if question.out[1].is_some() { SECTORS } else { 2 };
        let mut tops = vec![0.0; bins * sectors];
        let mut counts = vec![0i64; bins * PARTS];
        let mut squares = [ExactSum::new()];
        for particle in particles {
            let place = question.out(particle) / width;
            let bin = (place as usize).min(bins - 1);
            let top = &mut tops[bin * sectors + question.sector(particle)];
            *top = question.height(particle).max(*top);
            counts[((place * PARTS as f64) as usize).min(bins * PARTS - 1)] += 1;
            squares[0].add(particle.velocity.norm_squared());
        }
        comm.all_max(&mut tops);
        comm.all_sum(&mut counts);
        let all = counts.iter().sum::<i64>() as f64;
        let of_bin =
            |(bin, tops): (usize, &[f64])| [(bin as f64 + 0.5) * width, tops.iter().sum::<f64>() / sectors as f64];
        let profile: Vec<[f64; 2]> = tops.chunks_exact(sectors).enumerate().map(of_bin).collect();
        let height = profile.iter().map(|[_, height]| *height).fold(0.0, f64::max);
        let thick = profile.iter().rev().find(|[_, height]| *height > width);
        Self {
            foot: thick.map_or(f64::NAN, |[out, _]| out + 0.5 * width),
            foot_99: width / PARTS as f64 * quantile(&counts, QUANTILE * all),
            height,
            flank: flank(&profile, height),
            speed: (comm.sum_exactly(&mut squares)[0] / all).sqrt(),
            profile,
        }
    }

    /// deposit.csv
    pub fn table(&self) -> String {
        let rows = self.profile.iter().map(|[out, height]| format!("{out:e},{height:e}\n"));
        std::iter::once("distance_m,height_m\n".to_string()).chain(rows).collect()
    }
}

impl Question {
    fn offset(&self, particle: &Particle) -> Vec3 {
        particle.position - self.origin
    }

    fn out(&self, particle: &Particle) -> f64 {
        let x = self.offset(particle);
        self.out.iter().flatten().map(|&axis| x[axis] * x[axis]).sum::<f64>().sqrt()
    }

    fn height(&self, particle: &Particle) -> f64 {
        self.offset(particle).dot(&self.up)
    }

    fn sector(&self, particle: &Particle) -> usize {
        let x = self.offset(particle);
        match self.out {
            [Some(a), Some(b)] => {
                let turn = libm::atan2(x[b], x[a]) / std::f64::consts::TAU;
                ((turn - turn.floor()) * SECTORS as f64) as usize % SECTORS
            }
            [Some(a), None] | [None, Some(a)] => (x[a] > 0.0) as usize,
            [None, None] => 0,
        }
    }
}

/// Where so many are counted, in classes; evenly spread within the one in which that is.
fn quantile(counts: &[i64], wanted: f64) -> f64 {
    let mut below = 0.0;
    for (class, count) in counts.iter().enumerate() {
        let count = *count as f64;
        if below + count >= wanted && count > 0.0 {
            return class as f64 + (wanted - below) / count;
        }
        below += count;
    }
    f64::NAN
}

fn flank(profile: &[[f64; 2]], height: f64) -> f64 {
    let is_flank = |z: f64| z > FLANK[0] * height && z < FLANK[1] * height;
    let points: Vec<(f64, f64)> = profile.iter().filter(|[_, z]| is_flank(*z)).map(|&[out, z]| (out, z)).collect();
    Line::through(&points).filter(|_| points.len() > 2).map_or(f64::NAN, |line| -line.slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantile_lies_within_its_class() {
        assert_eq!(quantile(&[10, 0, 80, 10], 95.0), 3.5);
        assert_eq!(quantile(&[10, 0, 80, 10], 50.0), 2.5);
        assert!(quantile(&[], 0.0).is_nan());
    }

    #[test]
    fn the_flank_is_what_lies_between_top_and_foot() {
        let cone: Vec<[f64; 2]> = (0..20).map(|k| [k as f64, (10.0 - 0.5 * k as f64).max(0.0)]).collect();
        assert!((flank(&cone, 10.0) - 0.5).abs() < 1e-14);
        assert!(flank(&cone[..5], 10.0).is_nan());
    }
}
