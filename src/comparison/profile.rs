//! Errors of fields along a coordinate. With V the volume of a particle and q* the solution at its place:
//!
//! ```text
//! L1 error of q      sum V |q - q*| / sum V / max |q*|         over particles within the stretch that counts
//! plateau            mean of q by mass over its middle, over q*, less one
//! front              where the velocity (or the density, in matter at rest) crosses half of its jump: its distance from
//!                    where it started over that of the solution, less one
//! ```
//! Plateaus and fronts are read off the solution itself: stretches where nothing changes, and jumps. All sums are exact, so
//! errors are the same on any number of ranks.

use super::pictures::Pictures;
use super::solution::{Place, Profile};
use crate::domain::comm::Comm;
use crate::error::Result;
use crate::exact::State;
use crate::material::eos::INTERNAL_ENERGY;
use crate::material::porosity::DISTENTION;
use crate::material::strength::DEVIATORIC_STRESS;
use crate::math::{Deviator, ExactSum, Vec3};
use crate::output::agree;
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::summary::Figures;
use crate::particles::Column;
use crate::random::uniform_pair;
use crate::step::Stepper;

const FIELDS: [(&str, &str); 5] =
    [("density", "kg/m^3"), ("velocity", "m/s"), ("stress", "Pa"), ("internal_energy", "J/kg"), ("distention", "")];
const FIELD_COUNT: usize = FIELDS.len();

/// Points at which the solution is evaluated.
const POINTS: usize = 4001;
/// Particles in a figure, about.
const SHOWN: f64 = 3000.0;
/// Plateaus and fronts are measured this many smoothing lengths away from others.
const MARGIN: f64 = 4.0;

fn fields(state: &State) -> [f64; FIELD_COUNT] {
    [state.density, state.velocity, state.stress, state.internal_energy, state.distention]
}

/// A particle along the coordinate.
struct Sample {
    s: f64,
    mass: f64,
    state: State,
}

/// Columns that samples are read from.
struct Reader<'a, 'c, const D: usize> {
    stepper: &'a Stepper<'c, D>,
    deviator: Option<Column<Deviator>>,
    energy: Option<Column<f64>>,
    distention: Option<Column<f64>>,
    place: Place,
}

impl<const D: usize> Reader<'_, '_, D> {
    /// Whether a particle is near enough to the coordinate's axis to count.
    fn is_in_core(&self, i: usize, core: Option<f64>) -> bool {
        let (Some(core), Place::Axis { along, .. }) = (core, self.place) else { return true };
        let mut across = self.stepper.columns.get(self.stepper.settings.view.core.position, i);
        across[along] = 0.0;
        across.norm() <= core
    }

    fn sample(&self, i: usize) -> Sample {
        let (columns, core) = (&self.stepper.columns, &self.stepper.settings.view.core);
        let (x, v) = (columns.get(core.position, i), columns.get(core.velocity, i));
        let pressure = columns.get(core.pressure, i);
        let (s, velocity, stress) = match self.place {
            Place::Axis { along, moves } => {
                let s = self.deviator.map_or(Deviator::default(), |column| columns.get(column, i));
                let normal = [s.xx, s.yy, -s.xx - s.yy][along];
                (x[along], v[moves], pressure - normal)
            }
            Place::Around(centre) => {
                let r = x - Vec3::from(centre);
                let length = libm::hypot(r.x, r.y);
                (length, if length > 0.0 { (r.x * v.y - r.y * v.x) / length } else { 0.0 }, pressure)
            }
            Place::Radius(centre) => {
                let r = x - Vec3::from(centre);
                let length = r.norm();
                (length, if length > 0.0 { r.dot(&v) / length } else { 0.0 }, pressure)
            }
        };
        let mass = self.stepper.settings.view.constants[columns.get(core.id, i).body()].particle_mass;
        let read = |column: Option<Column<f64>>| column.map_or(f64::NAN, |column| columns.get(column, i));
        let (internal_energy, distention) = (read(self.energy), read(self.distention));
        Sample {
            s,
            mass,
            state: State { density: columns.get(core.density.value, i), velocity, stress, internal_energy, distention },
        }
    }
}

/// A stretch of the solution where nothing changes, or a jump.
enum Feature {
    Plateau { low: f64, high: f64, state: State },
    Front { at: f64, behind: State, ahead: State },
}

/// One field at a front of the solution.
struct Jump {
    /// Its number among the fields.
    field: usize,
    /// Where, m.
    at: f64,
    behind: f64,
    ahead: f64,
}

/// A solution at a time, and this rank's particles where both count.
struct Compared<'a> {
    profile: &'a Profile,
    /// s.
    time: f64,
    /// Coordinates of the first and the last particle of all ranks, m; the wrong way round without any.
    ends: [f64; 2],
    samples: &'a [Sample],
}

/// The errors, and one figure per field. Collective.
pub fn compare<const D: usize>(
    profile: &Profile,
    stepper: &Stepper<D>,
    time: f64,
    pictures: Option<Pictures>,
    comm: &Comm,
) -> Result<Figures> {
    let registry = &stepper.columns.registry;
    let reader = Reader {
        stepper,
        deviator: registry.find(DEVIATORIC_STRESS),
        energy: registry.find(INTERNAL_ENERGY),
        distention: registry.find(DISTENTION),
        place: profile.place,
    };
    let counts = |s: f64| (profile.within[0]..=profile.within[1]).contains(&s);
    let near_axis = (0..stepper.columns.len()).filter(|&i| reader.is_in_core(i, profile.core));
    let samples: Vec<Sample> = near_axis.map(|i| reader.sample(i)).filter(|p| counts(p.s)).collect();
    let mut ends = samples.iter().fold([f64::NEG_INFINITY; 2], |[a, b], p| [a.max(-p.s), b.max(p.s)]);
    comm.all_max(&mut ends);
    let ends = [-ends[0], ends[1]];
    let compared = Compared { profile, time, ends, samples: &samples };
    let mut errors = norms(&compared, comm);
    if ends[0] < ends[1] {
        let h = stepper.settings.view.constants.iter().map(|body| body.smoothing_length).fold(0.0, f64::max);
        errors.extend(features(&compared, MARGIN * h, comm));
    }
    if let Some(pictures) = pictures {
        draw(&compared, pictures, comm)?;
    }
    Ok(Figures(errors))
}

fn norms(compared: &Compared, comm: &Comm) -> Vec<(String, f64)> {
    let &Compared { profile, time, samples, .. } = compared;
    let mut sums = vec![ExactSum::new(); 2 * FIELD_COUNT];
    let mut scale = [0.0; FIELD_COUNT];
    for p in samples {
        let (exact, found) = (fields(&(profile.at)(p.s, time)), fields(&p.state));
        let volume = p.mass / p.state.density;
        for (k, (q, e)) in found.iter().zip(exact).enumerate().filter(|(_, (q, e))| q.is_finite() && e.is_finite()) {
            scale[k] = f64::max(scale[k], e.abs());
            sums[2 * k].add(volume * (q - e).abs());
            sums[2 * k + 1].add(volume);
        }
    }
    comm.all_max(&mut scale);
    let sums = comm.sum_exactly(&mut sums);
    let named = FIELDS.iter().enumerate().filter(|(k, _)| sums[2 * k + 1] > 0.0 && scale[*k] > 0.0);
    named.map(|(k, (name, _))| (format!("{name}_l1"), sums[2 * k] / sums[2 * k + 1] / scale[k])).collect()
}

/// Plateaus and fronts of the solution where there are particles.
fn found(compared: &Compared) -> Vec<Feature> {
    let &Compared { profile, time, ends, .. } = compared;
    let step = (ends[1] - ends[0]) / (POINTS - 1) as f64;
    let points: Vec<(f64, State)> = (0..POINTS)
        .map(|k| ends[0] + k as f64 * step)
        .map(|s| (s, (profile.at)(s, time)))
        .filter(|(_, state)| state.density.is_finite())
        .collect();
    let same = |a: &State, b: &State| fields(a).iter().zip(fields(b)).all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs());
    let largest = |k: usize| points.iter().map(|(_, state)| fields(state)[k].abs()).fold(0.0, f64::max);
    let (densest, fastest) = (largest(0), largest(1));
    let mut features = Vec::new();
    let mut start = 0;
    for k in 1..=points.len() {
        if k < points.len() && same(&points[k - 1].1, &points[k].1) {
            continue;
        }
        if k - start > POINTS / 100 {
            features.push(Feature::Plateau { low: points[start].0, high: points[k - 1].0, state: points[start].1 });
        }
        start = k;
        let Some(pair) = points.get(k - 1..=k) else { continue };
        let [(a, behind), (b, ahead)] = [pair[0], pair[1]];
        let jumps = (behind.density - ahead.density).abs() > 0.02 * densest
            || (behind.velocity - ahead.velocity).abs() > 0.02 * fastest;
        // Neighbouring points of the solution, not ends of a stretch where it is undefined.
        if jumps && b - a < 1.5 * step {
            features.push(Feature::Front { at: 0.5 * (a + b), behind, ahead });
        }
    }
    features
}

fn features(compared: &Compared, margin: f64, comm: &Comm) -> Vec<(String, f64)> {
    let &Compared { profile, samples, .. } = compared;
    let (mut errors, mut plateaus, mut fronts) = (Vec::new(), 0, 0);
    for feature in found(compared) {
        match feature {
            Feature::Plateau { low, high, state } => {
                plateaus += 1;
                let inset = margin.max(0.15 * (high - low));
                let means = means(samples, low + inset, high - inset, comm);
                let Some(means) = means else { continue };
                for ((name, _), (mean, exact)) in FIELDS.iter().zip(means.iter().zip(fields(&state))) {
                    if exact != 0.0 && mean.is_finite() {
                        errors.push((format!("plateau_{plateaus}_{name}"), mean / exact - 1.0));
                    }
                }
            }
            Feature::Front { at, behind, ahead } => {
                fronts += 1;
                let field = if (behind.velocity - ahead.velocity).abs() > 0.0 { 1 } else { 0 };
                let jump = Jump { field, at, behind: fields(&behind)[field], ahead: fields(&ahead)[field] };
                let travelled = at - profile.origin;
                if let Some(crossing) = crossing(samples, &jump, margin, comm)
                    && travelled.abs() > margin
                {
                    errors.push((format!("front_{fronts}_speed"), (crossing - profile.origin) / travelled - 1.0));
                }
            }
        }
    }
    errors
}

/// Means by mass of all fields between two places; `None` where there is no particle. Collective.
fn means(samples: &[Sample], low: f64, high: f64, comm: &Comm) -> Option<[f64; FIELD_COUNT]> {
    let mut sums = vec![ExactSum::new(); FIELD_COUNT + 1];
    for p in samples.iter().filter(|p| (low..=high).contains(&p.s)) {
        sums[FIELD_COUNT].add(p.mass);
        fields(&p.state).iter().zip(&mut sums).filter(|(q, _)| q.is_finite()).for_each(|(q, sum)| sum.add(p.mass * q));
    }
    let sums = comm.sum_exactly(&mut sums);
    (sums[FIELD_COUNT] > 0.0).then(|| std::array::from_fn(|k| sums[k] / sums[FIELD_COUNT]))
}

/// Where the mean of a field over slabs crosses the middle of its jump, nearest to where the solution has it. Collective.
fn crossing(samples: &[Sample], jump: &Jump, margin: f64, comm: &Comm) -> Option<f64> {
    let &Jump { field, at, behind, ahead } = jump;
    const SLABS: usize = 48;
    let width = 2.0 * 3.0 * margin / SLABS as f64;
    let low = at - 3.0 * margin;
    let mut sums = vec![ExactSum::new(); 2 * SLABS];
    for p in samples {
        let slab = ((p.s - low) / width).floor();
        if (0.0..SLABS as f64).contains(&slab) {
            let slab = slab as usize;
            sums[2 * slab].add(p.mass * fields(&p.state)[field]);
            sums[2 * slab + 1].add(p.mass);
        }
    }
    let sums = comm.sum_exactly(&mut sums);
    let filled = (0..SLABS).filter(|k| sums[2 * k + 1] > 0.0);
    let means: Vec<(f64, f64)> =
        filled.map(|k| (low + (k as f64 + 0.5) * width, sums[2 * k] / sums[2 * k + 1])).collect();
    let middle = 0.5 * (behind + ahead);
    let crossings = means.windows(2).filter_map(|pair| {
        let [(a, q), (b, r)] = [pair[0], pair[1]];
        let downwards = behind > ahead;
        let through = if downwards { q >= middle && r < middle } else { q <= middle && r > middle };
        through.then(|| a + (b - a) * (middle - q) / (r - q))
    });
    crossings.min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs()))
}

/// Particles over the exact curve, one picture per field.
fn draw(compared: &Compared, pictures: Pictures, comm: &Comm) -> Result<()> {
    let &Compared { profile, time, ends, samples } = compared;
    let mut count = [samples.len() as i64];
    comm.all_sum(&mut count);
    let share = SHOWN / count[0].max(1) as f64;
    // A random sample by the rank's own numbering: it depends on ranks, but only in the picture.
    let shown = samples.iter().zip(0u64..).filter(|(_, k)| uniform_pair(comm.rank() as u64, *k, 0)[0] < share);
    let words: Vec<u64> =
        shown.flat_map(|(p, _)| [p.s].into_iter().chain(fields(&p.state)).map(f64::to_bits)).collect();
    let received = comm.sparse_exchange(vec![(0, words)]);
    if !comm.is_root() {
        return agree(comm, Ok(()));
    }
    let rows: Vec<[f64; FIELD_COUNT + 1]> = received
        .iter()
        .flat_map(|(_, words)| {
            words.chunks_exact(FIELD_COUNT + 1).map(|w| std::array::from_fn(|k| f64::from_bits(w[k])))
        })
        .collect();
    let (radius, step) = (!matches!(profile.place, Place::Axis { .. }), (ends[1] - ends[0]) / (POINTS - 1) as f64);
    let curve: Vec<(f64, [f64; FIELD_COUNT])> =
        (0..POINTS).map(|k| ends[0] + k as f64 * step).map(|s| (s, fields(&(profile.at)(s, time)))).collect();
    let draw = |(k, (name, unit)): (usize, &(&str, &str))| {
        let series = |label: &str, points: Vec<(f64, f64)>, mark| Series {
            label: label.into(),
            points: points.into_iter().filter(|(_, q)| q.is_finite()).collect(),
            errors: Vec::new(),
            mark,
        };
        let particles = series("particles", rows.iter().map(|row| (row[0], row[k + 1])).collect(), Mark::Points);
        let exact = series("exact", curve.iter().map(|(s, q)| (*s, q[k])).collect(), Mark::Line);
        if particles.points.is_empty() || exact.points.is_empty() {
            return Ok(());
        }
        let axis = |label: String| Axis { label, logarithmic: false };
        let figure = Figure {
            title: format!("{} (t = {time:.4e} s)", pictures.title),
            x: axis(if radius { "distance from the centre (m)".into() } else { "x (m)".into() }),
            y: axis(if unit.is_empty() { name.to_string() } else { format!("{} ({unit})", name.replace('_', " ")) }),
            series: vec![particles, exact],
        };
        figure.draw(&pictures.directory.join(format!("compare_{name}.png")))
    };
    agree(comm, FIELDS.iter().enumerate().try_for_each(draw))
}
