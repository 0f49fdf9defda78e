//! How much farther than its support each particle's list reaches: its skin, in units of the support. A scene gives one number for all, or
//! leaves it to be chosen with each list.
//!
//! Lists are built anew, all of them, when somewhere two particles have used up their skin (`domain::watch`). A wide skin makes rows
//! long, a narrow one makes lists last a step or two; and matter that is hit moves a hundred times as far in a step as what lies still
//! around it. With delta_i, by how much matter around particle i moved against each other in an evaluation since the last build, over its
//! support, lists that shall last for n evaluations take
//!
//! ```text
//! s_i = LEAST + MARGIN n delta_i     at most the widest
//! ```
//! and n is that of the least work in an evaluation, in units of the sums over pairs without a skin,
//!
//! ```text
//! mean over particles of (1 + s_i)^d  +  [ ORDER + SEARCH mean of 2^(d level_i) ] / n
//! ```
//! level: of the cells that hold the list radius, each level twice as wide as the one below and with 2^d times the candidates. "Around"
//! is all that the watch compares, two cells and more to each side, so that a front is expected before it arrives. What counts are
//! particles by their delta, in eighths of an octave: integers, so that any ranks choose the same n.

use crate::domain::comm::Comm;
use crate::particles::{Column, ColumnInfo, Columns, Life, Registry};

/// Room for what begins to move.
const LEAST: f64 = 0.01;
/// For motion that becomes faster.
const MARGIN: f64 = 1.2;
/// Time to bring particles into a new order, and to search their neighbours, over that of the sums over their pairs: measured for solids.
const ORDER: f64 = 0.3;
const SEARCH: f64 = 0.75;

/// The longest life asked for, as a power of two, and the steps in which lives are tried.
const LONGEST: i32 = 9;
const TRIALS: i32 = 4;

/// Skins of lists.
#[derive(Debug, Clone, Copy)]
pub enum Skin {
    Fixed(f64),
    /// Each particle's own.
    Own(OwnSkin),
}

#[derive(Debug, Clone, Copy)]
pub struct OwnSkin {
    column: Column<f64>,
    pub limits: Limits,
}

/// What bounds the skins of particles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Of the first list.
    pub first: f64,
    /// The widest of particles in the cells of their smoothing length.
    pub of_cells: f64,
    pub widest: f64,
    /// 2 or 3.
    pub dimension: usize,
}

impl Skin {
    /// Skins that are each particle's own.
    pub fn own(limits: Limits, registry: &mut Registry) -> Self {
        registry.owner("lists");
        let info = ColumnInfo {
            name: "skin",
            unit: "",
            about: "Margin of the particle's neighbour list over the support, at the last list build.",
            life: Life::Kept,
            snapshot: false,
        };
        Skin::Own(OwnSkin { column: registry.column(info), limits })
    }

    /// Of a particle at the last list build.
    #[inline]
    pub fn at_build(&self, columns: &Columns, i: usize) -> f64 {
        match self {
            Skin::Fixed(skin) => *skin,
            Skin::Own(own) => columns.get(own.column, i),
        }
    }

    /// That for which cells are made.
    pub fn of_cells(&self) -> f64 {
        match self {
            Skin::Fixed(skin) => *skin,
            Skin::Own(own) => own.limits.of_cells,
        }
    }
}

impl OwnSkin {
    /// The skins of the first list.
    pub fn begin(&self, columns: &mut Columns) {
        (0..columns.len()).for_each(|i| columns.set(self.column, i, self.limits.first));
    }

    /// The skins of the next list. `moved`: of each particle, by how much matter around it moved against each other since the last build,
    /// over its support, in so many `evaluations`. Collective.
    pub fn choose(&self, columns: &mut Columns, moved: &[f64], evaluations: u64, comm: &Comm) {
        let delta = |moved: f64| moved / evaluations as f64;
        let mut counts = [0; BINS];
        moved.iter().for_each(|&moved| counts[bin(delta(moved))] += 1);
        comm.all_sum(&mut counts);
        let life = self.limits.life(&counts);
        for (i, &moved) in moved.iter().enumerate() {
            columns.set(self.column, i, self.limits.skin(life, delta(moved)));
        }
    }
}

/// Particles are counted by their delta in eighths of octaves, from 2^-26 to 2^6.
const BINS: usize = 8 * 32;
/// The first of them, as eighths of octaves by the bits of a number.
const FIRST_BIN: i64 = (1023 - 26) << 3;

fn bin(delta: f64) -> usize {
    ((delta.to_bits() >> 49) as i64 - FIRST_BIN).clamp(0, BINS as i64 - 1) as usize
}

/// Where a bin ends.
fn end(bin: usize) -> f64 {
    f64::from_bits(((bin as i64 + 1 + FIRST_BIN) as u64) << 49)
}

impl Limits {
    fn skin(&self, life: f64, delta: f64) -> f64 {
        (LEAST + MARGIN * life * delta).min(self.widest)
    }

    /// The life, in evaluations, that costs least where so many particles have a delta of each bin.
    fn life(&self, counts: &[i64; BINS]) -> f64 {
        let Some(most) = counts.iter().rposition(|&count| count > 0) else { return 1.0 };
        // Beyond it somebody's skin would be used up earlier.
        let longest = ((self.widest - LEAST) / (MARGIN * end(most))).max(1.0);
        let (mut least, mut best) = (f64::INFINITY, 1.0);
        for trial in 0..=LONGEST * TRIALS {
            let life = libm::exp2(trial as f64 / TRIALS as f64).min(longest);
            let work = self.work(life, counts);
            if work < least {
                (least, best) = (work, life);
            }
            if life == longest {
                break;
            }
        }
        best
    }

    /// Work of an evaluation where lists live that long.
    fn work(&self, life: f64, counts: &[i64; BINS]) -> f64 {
        let power = |x: f64| if self.dimension == 2 { x * x } else { x * x * x };
        let (mut pairs, mut search, mut all) = (0.0, 0.0, 0.0);
        for (bin, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            let (count, skin) = (count as f64, self.skin(life, end(bin)));
            let mut cells = 1.0;
            while cells * (1.0 + self.of_cells) < 1.0 + skin {
                cells *= 2.0;
            }
            all += count;
            pairs += count * power(1.0 + skin);
            search += count * power(cells);
        }
        pairs / all + (ORDER + SEARCH * search / all) / life
    }

    /// The life of lists, in evaluations, where a `share` of all particles moves by `delta` in one, and the rest a hundredth of that.
    pub fn expected_life(&self, share: f64, delta: f64) -> f64 {
        let mut counts = [0; BINS];
        counts[bin(delta)] += (1000.0 * share) as i64;
        counts[bin(0.01 * delta)] += 1000 - (1000.0 * share) as i64;
        self.life(&counts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OPEN: Limits = Limits { first: 0.05, of_cells: 0.1, widest: 1.2, dimension: 3 };

    fn counts(of: &[(f64, i64)]) -> [i64; BINS] {
        let mut counts = [0; BINS];
        of.iter().for_each(|&(delta, count)| counts[bin(delta)] += count);
        counts
    }

    #[test]
    fn bins_hold_their_numbers() {
        for delta in [1e-7, 0.003, 0.0625, 0.99, 1.0, 17.0] {
            let end = end(bin(delta));
            assert!(delta < end && end <= 1.126 * delta, "{delta} {end}");
        }
        assert_eq!((bin(0.0), bin(1e-300), bin(f64::INFINITY)), (0, 0, BINS - 1));
    }

    /// Even motion: 3 s (1 + s)^2 = (ORDER + SEARCH) / n with s = LEAST + MARGIN n delta.
    #[test]
    fn even_motion_has_its_best_skin() {
        for delta in [1e-4, 1e-3, 1e-2] {
            let life = OPEN.life(&counts(&[(delta, 1000)]));
            let s = MARGIN * life * delta;
            let best = ((ORDER + SEARCH) * MARGIN * delta / 3.0).sqrt();
            assert!((s / best - 1.0).abs() < 0.25, "{delta}: {life} {s} {best}");
        }
    }

    /// Few particles that move fast get wide skins, and lists last several times as long as with one skin for all.
    #[test]
    fn the_few_do_not_decide_for_the_many() {
        let one = OPEN.life(&counts(&[(0.04, 1000)]));
        let few = OPEN.life(&counts(&[(0.04, 20), (4e-4, 980)]));
        assert!(one < 4.0 && few > 3.0 * one, "{one} {few}");
        assert!(OPEN.skin(few, 0.04) > 0.3 && OPEN.skin(few, 4e-4) < 0.02);
        // Nobody outlives the widest skin.
        let fastest = OPEN.life(&counts(&[(1.0, 1), (1e-6, 1_000_000)]));
        assert_eq!(fastest, 1.0);
        let fastest = OPEN.life(&counts(&[(0.2, 1), (1e-6, 1_000_000)]));
        assert!((LEAST + MARGIN * fastest * 0.2) <= 1.2 && fastest > 4.0, "{fastest}");
        assert_eq!(OPEN.life(&counts(&[(50.0, 1)])), 1.0);
        assert_eq!(OPEN.life(&[0; BINS]), 1.0);
        // In a period all stay in their cells.
        let period = Limits { widest: 0.1, ..OPEN };
        assert!(period.skin(period.life(&counts(&[(0.04, 20), (4e-4, 980)])), 0.04) <= 0.1);
    }
}
