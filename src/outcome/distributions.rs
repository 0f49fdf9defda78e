//! Size and velocity distributions of the pieces after an impact, as CSV. The largest fragments are listed one by one; all
//! pieces, loose particles apart from fragments, are counted in bins. Only the list and the bins reach rank 0.

use std::fmt::Write;

use super::evaluation::Evaluation;
use super::piece::Piece;
use crate::domain::comm::Comm;
use crate::math::ExactSum;

/// Fragments listed one by one.
pub const MAX_LISTED: u64 = 10_000;
/// Bins; each spans a factor of two in mass, or of the square root of two in speed.
const BINS: usize = 64;
/// Lower edge of the slowest bin but the last, m/s: 2^-14. Slower pieces count in the last bin.
const SLOWEST_EXPONENT: f64 = -14.0;

/// The contents of three files; empty on all ranks but rank 0.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Distributions {
    /// `fragments.csv`: the largest intact fragments.
    pub fragments: String,
    /// `sizes.csv`: number and mass above a mass.
    pub sizes: String,
    /// `velocities.csv`: number and mass above a speed.
    pub velocities: String,
}

/// The distributions of all pieces; equivalent diameters are those of spheres, in `dimension` 2 of circles. Collective.
pub fn distributions(comm: &Comm, evaluation: &Evaluation, dimension: usize) -> Distributions {
    let listed = list(comm, evaluation, dimension);
    let total = evaluation.mass;
    // Bin k holds (2^-(k + 1), 2^-k] of the total mass; a mass rounded above the total belongs to the first.
    let by_size = |piece: &Piece| -libm::log2(piece.mass / total);
    let sizes = Bins::count(comm, &evaluation.pieces, by_size);
    let fastest = 0.5 * BINS as f64 + SLOWEST_EXPONENT;
    let by_speed = |piece: &Piece| 2.0 * (fastest - libm::log2((piece.velocity - evaluation.centre.velocity).norm()));
    let velocities = Bins::count(comm, &evaluation.pieces, by_speed);
    if !comm.is_root() {
        return Distributions::default();
    }
    let mass_edge = |k: usize| total * libm::exp2(-(k as f64) - 1.0);
    let speed_edge = |k: usize| libm::exp2(fastest - 0.5 * (k as f64 + 1.0));
    Distributions {
        fragments: listed,
        sizes: sizes.table("mass_above_kg", mass_edge),
        velocities: velocities.table("speed_above_m_s", speed_edge),
    }
}

/// Number and mass per bin, fragments and loose particles apart.
struct Bins {
    counts: [Vec<i64>; 2],
    masses: [Vec<f64>; 2],
}

impl Bins {
    /// `place`: a piece's bin as a real number, growing from the first bin of the table to the last.
    fn count(comm: &Comm, pieces: &[Piece], place: impl Fn(&Piece) -> f64) -> Self {
        let mut counts = vec![0i64; 2 * BINS];
        let mut masses = vec![ExactSum::new(); 2 * BINS];
        for piece in pieces {
            let bin = place(piece).clamp(0.0, (BINS - 1) as f64) as usize;
            let row = if piece.count > 1 { bin } else { BINS + bin };
            counts[row] += 1;
            masses[row].add(piece.mass);
        }
        comm.all_sum(&mut counts);
        let masses = comm.sum_exactly(&mut masses);
        Self {
            counts: [counts[..BINS].to_vec(), counts[BINS..].to_vec()],
            masses: [masses[..BINS].to_vec(), masses[BINS..].to_vec()],
        }
    }

    /// Cumulative figures at the lower edge of each bin, from the first bin with anything in it to the last.
    fn table(&self, edge_name: &str, edge: impl Fn(usize) -> f64) -> String {
        let mut text = format!("{edge_name},fragments,fragments_mass_kg,loose_particles,loose_mass_kg\n");
        let filled = |k: &usize| self.counts[0][*k] + self.counts[1][*k] > 0;
        let (Some(first), Some(last)) = ((0..BINS).find(filled), (0..BINS).rfind(filled)) else { return text };
        for k in first..=last {
            let number = |kind: usize| self.counts[kind][..=k].iter().sum::<i64>();
            let mass = |kind: usize| self.masses[kind][..=k].iter().fold(0.0, |sum, m| sum + m);
            let edge = if k == BINS - 1 { 0.0 } else { edge(k) };
            let _ = writeln!(text, "{edge:e},{},{:e},{},{:e}", number(0), mass(0), number(1), mass(1));
        }
        text
    }
}

/// Words of a listed fragment: label, particles, mass, diameter, velocity (3), distance, membership.
const RECORD: usize = 9;

fn record(evaluation: &Evaluation, i: usize, dimension: usize) -> [u64; RECORD] {
    let piece = &evaluation.pieces[i];
    let velocity = piece.velocity - evaluation.centre.velocity;
    let distance = (piece.position - evaluation.centre.position).norm();
    let numbers = [piece.mass, diameter(piece.volume, dimension), velocity.x, velocity.y, velocity.z, distance];
    let mut words = [piece.label, piece.count, 0, 0, 0, 0, 0, 0, u64::from(evaluation.in_largest[i])];
    words[2..8].iter_mut().zip(numbers).for_each(|(word, number)| *word = number.to_bits());
    words
}

/// The table of the largest fragments, on rank 0.
fn list(comm: &Comm, evaluation: &Evaluation, dimension: usize) -> String {
    let fragments: Vec<usize> = (0..evaluation.pieces.len()).filter(|&i| evaluation.pieces[i].count > 1).collect();
    let ranking = |i: usize| rank_of(&evaluation.pieces[i]);
    let least = least_listed(comm, fragments.iter().map(|&i| ranking(i)).collect(), MAX_LISTED);
    let chosen = fragments.into_iter().filter(|&i| ranking(i) >= least);
    let words: Vec<u64> = chosen.flat_map(|i| record(evaluation, i, dimension)).collect();
    let received = comm.sparse_exchange(if words.is_empty() { Vec::new() } else { vec![(0, words)] });
    if !comm.is_root() {
        return String::new();
    }
    let mut records: Vec<&[u64]> = received.iter().flat_map(|(_, words)| words.chunks_exact(RECORD)).collect();
    records.sort_by_key(|r| (std::cmp::Reverse(r[2]), r[0]));
    let mut text = String::from(
        "label,particles,mass_kg,diameter_m,velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,distance_m,in_largest_remnant\n",
    );
    for record in records {
        let numbers: Vec<String> = record[2..8].iter().map(|&bits| format!("{:e}", f64::from_bits(bits))).collect();
        let _ = writeln!(text, "{},{},{},{}", record[0], record[1], numbers.join(","), record[8]);
    }
    text
}

/// Diameter of the sphere (in 2D the circle) of this volume, m.
fn diameter(volume: f64, dimension: usize) -> f64 {
    let pi = std::f64::consts::PI;
    if dimension == 3 { libm::cbrt(6.0 * volume / pi) } else { (4.0 * volume / pi).sqrt() }
}

/// Larger for more massive pieces, and for smaller labels among equals: positive numbers order as their bits do.
pub(super) fn rank_of(piece: &Piece) -> u128 {
    (piece.mass.to_bits() as u128) << 64 | !piece.label as u128
}

/// The least ranking such that at most `most` of all ranks' pieces reach it, by bisection over its bits.
pub(super) fn least_listed(comm: &Comm, mut rankings: Vec<u128>, most: u64) -> u128 {
    rankings.sort_unstable();
    // Invariant: at most `most` reach `high`, and more than that reach every value below `low`.
    let (mut low, mut high) = (0u128, u128::MAX);
    while low < high {
        let middle = low + (high - low) / 2;
        let mut count = [(rankings.len() - rankings.partition_point(|r| *r < middle)) as i64];
        comm.all_sum(&mut count);
        if count[0] as u64 <= most {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    high
}
