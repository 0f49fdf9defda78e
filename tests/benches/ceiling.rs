//! How fast a stripped pair loop is on this processor, and which share of that the loops of the program reach, on one core.
//!
//! The ceiling is a stripped loop that does the work of a gas: f64 in eight lanes, a list without skin, records of two
//! cache lines, 14 sums (force, velocity gradient, heating, signal speed), reciprocals from the processor's estimates with
//! two Newton steps. The program's own loops divide and take roots as IEEE wants it, carry stress and correction, and walk
//! lists with a skin. It is a yardstick and no bound: it weighs force and gradient with different slopes, as most gas codes
//! do, where the program's sums share one, so that its gas loop without skin can come out above 1.
//! Interactions are directed pairs inside the support, whatever the list holds.
//!
//! `cargo bench --bench ceiling -- [PARTICLES PER EDGE] [REPETITIONS]`, 59 and 9 if not given.

use std::arch::x86_64::*;
use std::hint::black_box;

use sph_mpi::kernel::{CubicSpline, Kernel, SUPPORT, Shape};
use sph_mpi::math::lanes::{Avx2, Avx512, LANES, Lanes, Portable, Width, width};
use sph_mpi::neighbours::NeighbourList;
use sph_mpi::pair::record::{PressureGradient, StressTerm, TensorGradient, ViscousTerm, set_half};
use sph_mpi::pair::rows::Constants;
use sph_mpi::pair::{Layout, PairLoop, RowSums, Rows, Terms, artificial_stress};
use sph_mpi::particles::chunk::CHUNK;
use sph_mpi::particles::{Lattice, Local, Site};
use sph_mpi::random::uniform;
use sph_mpi::step::workers::start_threads;

/// Neighbours of a particle far from the surface.
const NEIGHBOURS: f64 = 55.0;
/// The margin that scenes have if they do not say otherwise.
const SKIN: f64 = 0.1;

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|argument| argument.parse::<usize>().ok());
    let (edge, repetitions) = (numbers.next().unwrap_or(59), numbers.next().unwrap_or(9));
    start_threads(1).expect("nothing has used the pool yet");
    let particles = jittered_lattice(edge);
    let mut plain = Neighbourhood::new(&particles, 0.0);
    let mut skinned = Neighbourhood::new(&particles, SKIN);
    let interactions = plain.list.pairs as f64;

    let gas = gas_records(&particles, &plain);
    check_against_exact_lanes(&gas, &plain.list);
    let mut gas_sums = vec![[0.0; GAS_SUMS]; particles.len()];
    let loops: Vec<ProgramLoop> = program_loops(&particles, [&plain, &skinned]);
    let mut seconds = vec![f64::INFINITY; 1 + 2 * loops.len() + 2];
    for _ in 0..repetitions {
        let mut row = 0;
        let mut time = |pass: &mut dyn FnMut()| {
            let start = thread_seconds();
            pass();
            seconds[row] = seconds[row].min(thread_seconds() - start);
            row += 1;
        };
        time(&mut || sum_gas(&gas, &plain.list, black_box(&mut gas_sums)));
        for program_loop in &loops {
            time(&mut || program_loop.pass(0, &plain));
            time(&mut || program_loop.pass(1, &skinned));
        }
        time(&mut || plain.build());
        time(&mut || skinned.build());
    }

    let per_particle = |x: f64| x / particles.len() as f64;
    println!("{} particles, {:.1} neighbours each, {:?}", particles.len(), per_particle(interactions), width());
    let entries = [&plain, &skinned].map(|n| per_particle(n.list.entries.len() as f64));
    println!("list entries per particle: {:.1}, with skin {:.1}; best of {repetitions}\n", entries[0], entries[1]);
    let mut names = vec!["ceiling".to_string()];
    for name in loops.iter().map(|l| l.name).chain(["list building"]) {
        names.extend([name.to_string(), format!("{name}, skin {SKIN}")]);
    }
    println!("| {:<38} | 1e6 interactions/s | share of ceiling |", "loop, one core");
    println!("|:{:-<38}-|-------------------:|-----------------:|", "");
    for (name, time) in names.iter().zip(&seconds) {
        println!("| {name:<38} | {:>18.1} | {:>16.3} |", 1e-6 * interactions / time, seconds[0] / time);
    }
}

/// Processor time of this thread, s.
fn thread_seconds() -> f64 {
    // SAFETY: `clock_gettime` fills the structure it is given.
    let time = unsafe {
        let mut time: libc::timespec = std::mem::zeroed();
        libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &mut time);
        time
    };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Units: spacing, sound speed and density of about 1.
struct Particle {
    position: [f64; 3],
    velocity: [f64; 3],
    smoothing_length: f64,
    density: f64,
    pressure: f64,
    sound_speed: f64,
}

/// A cubic lattice, every site moved by up to 0.4 of the spacing, in random order.
fn jittered_lattice(edge: usize) -> Vec<Particle> {
    let support = (NEIGHBOURS / (4.0 / 3.0 * std::f64::consts::PI)).cbrt();
    let particle = |site: usize| {
        let draw = |k: u64| uniform(42, site as u64, k);
        let lattice = [site / (edge * edge), site / edge % edge, site % edge];
        Particle {
            position: std::array::from_fn(|a| lattice[a] as f64 + 0.8 * (draw(a as u64) - 0.5)),
            velocity: std::array::from_fn(|a| 2.0 * draw(3 + a as u64) - 1.0),
            smoothing_length: support / SUPPORT * (0.97 + 0.06 * draw(6)),
            density: 0.9 + 0.2 * draw(7),
            pressure: 0.9 + 0.2 * draw(8),
            sound_speed: 1.0 + 0.1 * draw(9),
        }
    };
    let mut order: Vec<usize> = (0..edge.pow(3)).collect();
    order.sort_by_key(|&site| uniform(43, site as u64, 0).to_bits());
    order.into_iter().map(particle).collect()
}

/// Particles in the program's order (cells along the curve, and random order inside a cell) and their lists.
struct Neighbourhood {
    local: Local<3>,
    list: NeighbourList<3>,
}

impl Neighbourhood {
    fn new(particles: &[Particle], skin: f64) -> Self {
        let radius = |p: &Particle| SUPPORT * (1.0 + skin) * p.smoothing_length;
        let lattice = Lattice::new(particles.iter().map(radius).fold(0.0, f64::max));
        let site = |(id, p): (usize, &Particle)| Site { id: id as u64, position: p.position, radius: radius(p) };
        let mut sites: Vec<Site<3>> = particles.iter().enumerate().map(site).collect();
        sites.sort_by_cached_key(|site| lattice.place(site));
        let mut local = Local::default();
        local.build(&lattice, &sites, &[]);
        let mut neighbourhood = Self { local, list: NeighbourList::default() };
        neighbourhood.build();
        neighbourhood
    }

    fn build(&mut self) {
        self.list.build(&self.local);
    }

    /// Numbers of the particles, in order.
    fn order(&self) -> impl Iterator<Item = usize> + '_ {
        self.local.places.iter().map(|place| place.id as usize)
    }
}

/// What a neighbour's loop reads in the ceiling, on two cache lines.
#[derive(Clone, Copy)]
#[repr(C, align(128))]
struct GasRecord([f64; 16]);

/// Behind position and velocity: mass, 1/h, s/h^4 of the kernel's slope, P/rho^2, density, speed of sound, and the factor of
/// viscosity.
const MASS: usize = 6;
const H_INVERSE: usize = 7;
const SLOPE: usize = 8;
const PRESSURE: usize = 9;
const DENSITY: usize = 10;
const SOUND: usize = 11;
const VISCOSITY: usize = 12;
const GAS_WORDS: usize = 13;

/// Force (3), velocity gradient (9), heating, signal speed.
const GAS_SUMS: usize = 14;
const GRADIENT: usize = 3;
const HEATING: usize = 12;

/// Records in the order of the list, and one far away without mass that pads rows.
fn gas_records(particles: &[Particle], neighbourhood: &Neighbourhood) -> Vec<GasRecord> {
    let record = |(number, p): (usize, &Particle)| {
        let mut words = [0.0; 16];
        words[..3].copy_from_slice(&p.position);
        words[3..6].copy_from_slice(&p.velocity);
        words[MASS] = 1.0;
        words[H_INVERSE] = 1.0 / p.smoothing_length;
        words[SLOPE] = CubicSpline::normalisation::<3>() / p.smoothing_length.powi(4);
        words[PRESSURE] = p.pressure / (p.density * p.density);
        words[DENSITY] = p.density;
        words[SOUND] = p.sound_speed;
        words[VISCOSITY] = uniform(44, number as u64, 0);
        GasRecord(words)
    };
    let mut padding = [0.0; 16];
    padding[..3].fill(1e6);
    padding[H_INVERSE] = 1.0;
    padding[DENSITY] = 1.0;
    padding[SOUND] = -1e30;
    let ordered = neighbourhood.order().map(|number| record((number, &particles[number])));
    ordered.chain([GasRecord(padding)]).collect()
}

/// Lanes that need not give the same bits on every processor.
trait FastLanes: Lanes {
    /// 1 / x.
    #[inline(always)]
    unsafe fn reciprocal(self) -> Self {
        // SAFETY: the caller's.
        unsafe { Self::splat(1.0).div(self) }
    }
    /// 1 / sqrt(x).
    #[inline(always)]
    unsafe fn fast_inverse_root(self) -> Self {
        // SAFETY: the caller's.
        unsafe { self.sqrt().reciprocal() }
    }
}

impl FastLanes for Portable {}
impl FastLanes for Avx2 {}

/// Estimates of 14 bits; each Newton step doubles them.
impl FastLanes for Avx512 {
    #[inline(always)]
    unsafe fn reciprocal(self) -> Self {
        // SAFETY: the caller's.
        unsafe {
            let mut y = Avx512(_mm512_rcp14_pd(self.0));
            for _ in 0..2 {
                y = self.fnma(y, Self::splat(1.0)).fma(y, y);
            }
            y
        }
    }
    #[inline(always)]
    unsafe fn fast_inverse_root(self) -> Self {
        // SAFETY: the caller's.
        unsafe {
            let half = self.mul(Self::splat(0.5));
            let mut y = Avx512(_mm512_rsqrt14_pd(self.0));
            for _ in 0..2 {
                y = y.mul(half.mul(y).fnma(y, Self::splat(1.5)));
            }
            y
        }
    }
}

/// The ceiling: sums of the first `out.len()` rows.
fn sum_gas(records: &[GasRecord], list: &NeighbourList<3>, out: &mut [[f64; GAS_SUMS]]) {
    // SAFETY: `width` names only what the processor has; entries of the list are numbers of records.
    unsafe {
        match width() {
            Width::Portable => gas_rows::<Portable>(records, list, out),
            Width::Avx2 => gas_rows_avx2(records, list, out),
            Width::Avx512 => gas_rows_avx512(records, list, out),
        }
    }
}

#[target_feature(enable = "avx2,fma")]
unsafe fn gas_rows_avx2(records: &[GasRecord], list: &NeighbourList<3>, out: &mut [[f64; GAS_SUMS]]) {
    // SAFETY: the caller's.
    unsafe { gas_rows::<Avx2>(records, list, out) }
}

#[target_feature(enable = "avx512f,avx512vl,avx2,fma")]
unsafe fn gas_rows_avx512(records: &[GasRecord], list: &NeighbourList<3>, out: &mut [[f64; GAS_SUMS]]) {
    // SAFETY: the caller's.
    unsafe { gas_rows::<Avx512>(records, list, out) }
}

/// # Safety
/// As for [`Lanes`]; entries of the list are numbers of records.
#[inline(always)]
unsafe fn gas_rows<L: FastLanes>(records: &[GasRecord], list: &NeighbourList<3>, out: &mut [[f64; GAS_SUMS]]) {
    unsafe {
        let base = records.as_ptr().cast::<f64>();
        for (row, out) in out.iter_mut().enumerate() {
            let mut i = [L::splat(0.0); GAS_WORDS];
            for (lanes, number) in i.iter_mut().zip(&records[row].0) {
                *lanes = L::splat(*number);
            }
            let mut sums = [L::splat(0.0); GAS_SUMS];
            for eight in list.row(row).chunks_exact(LANES) {
                let mut offsets = [0; LANES];
                for k in 0..LANES {
                    offsets[k] = eight[k] as usize * 16;
                }
                let mut j = [L::splat(0.0); 16];
                for quad in 0..4 {
                    let four = L::read_quad(base.add(4 * quad), &offsets);
                    j[4 * quad..4 * quad + 4].copy_from_slice(&four);
                }
                gas_pairs(&i, &j, &mut sums);
            }
            let s = sums;
            out[..8].copy_from_slice(&L::fold([s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7]]));
            let rest = L::fold([s[8], s[9], s[10], s[11], s[12], s[12], s[12], s[12]]);
            out[8..13].copy_from_slice(&rest[..5]);
            out[13] = s[13].fold_max();
        }
    }
}

/// Eight pairs of a gas (Monaghan 1992, ARA&A 30, 543; viscosity by signal speed, Monaghan 1997, J. Comp. Phys. 136, 298):
///
///   m_j [P_i/rho_i^2 W_i' + P_j/rho_j^2 W_j' + Pi (W_i' + W_j')/2] / r       Pi = -f mu (c_i + c_j - 3 mu) / (rho_i + rho_j)
///
/// with mu = min(v.x, 0) / r; the velocity gradient is summed with the slope of i alone.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn gas_pairs<L: FastLanes>(i: &[L; GAS_WORDS], j: &[L; 16], sums: &mut [L; GAS_SUMS]) {
    unsafe {
        let x = [i[0].sub(j[0]), i[1].sub(j[1]), i[2].sub(j[2])];
        let v = [i[3].sub(j[3]), i[4].sub(j[4]), i[5].sub(j[5])];
        let r2 = x[2].fma(x[2], x[1].fma(x[1], x[0].mul(x[0]))).max(L::splat(1e-30));
        let v_dot_x = v[2].fma(x[2], v[1].fma(x[1], v[0].mul(x[0])));
        let r_inverse = r2.fast_inverse_root();
        let r = r2.mul(r_inverse);
        let slope_i = CubicSpline::slope_lanes(r.mul(i[H_INVERSE])).mul(i[SLOPE]);
        let slope_j = CubicSpline::slope_lanes(r.mul(j[H_INVERSE])).mul(j[SLOPE]);

        let mu = v_dot_x.min(L::splat(0.0)).mul(r_inverse);
        let signal = mu.fma(L::splat(-3.0), i[SOUND].add(j[SOUND]));
        sums[13] = sums[13].max(signal);
        let f = i[VISCOSITY].add(j[VISCOSITY]).mul(L::splat(-0.25));
        let viscous = f.mul(mu).mul(signal).mul(i[DENSITY].add(j[DENSITY]).reciprocal()).mul(slope_i.add(slope_j));

        let weight = j[MASS].mul(r_inverse);
        let own = i[PRESSURE].mul(slope_i);
        let force = weight.mul(j[PRESSURE].fma(slope_j, own.add(viscous)));
        for a in 0..3 {
            sums[a] = force.fnma(x[a], sums[a]);
        }
        sums[HEATING] = weight.mul(viscous.fma(L::splat(0.5), own)).fma(v_dot_x, sums[HEATING]);
        let slope = weight.mul(slope_i);
        let gradient = [slope.mul(x[0]), slope.mul(x[1]), slope.mul(x[2])];
        for a in 0..3 {
            for b in 0..3 {
                sums[GRADIENT + 3 * a + b] = v[a].fma(gradient[b], sums[GRADIENT + 3 * a + b]);
            }
        }
    }
}

/// The first rows once more with divisions and roots as IEEE wants them: the ceiling must not be fast by being wrong.
fn check_against_exact_lanes(records: &[GasRecord], list: &NeighbourList<3>) {
    let rows = (list.offsets.len() - 1).min(2048);
    let (mut fast, mut exact) = (vec![[0.0; GAS_SUMS]; rows], vec![[0.0; GAS_SUMS]; rows]);
    sum_gas(records, list, &mut fast);
    // SAFETY: portable lanes need no instruction set; entries of the list are numbers of records.
    unsafe { gas_rows::<Portable>(records, list, &mut exact) };
    for k in 0..GAS_SUMS {
        let largest = exact.iter().map(|sums| sums[k].abs()).fold(0.0, f64::max);
        for (fast, exact) in fast.iter().zip(&exact) {
            // Two Newton steps make 14 bits 53: what is left is the rounding of some 50 terms.
            assert!((fast[k] - exact[k]).abs() <= 1e-13 * largest, "sum {k}: {} and {}", fast[k], exact[k]);
        }
    }
}

/// A pair loop of the program with records for both lists.
struct ProgramLoop {
    name: &'static str,
    pair_loop: PairLoop,
    records: [Vec<f64>; 2],
}

fn program_loops(particles: &[Particle], neighbourhoods: [&Neighbourhood; 2]) -> Vec<ProgramLoop> {
    let viscosity = ViscousTerm::SameBeta;
    let terms = |stress| Terms { stress, viscosity };
    let gas = terms(StressTerm::Pressure { gradient: PressureGradient::Plain });
    let gradient = TensorGradient::Corrected { contrast: false, angular_momentum: false };
    let [solid, tensile] = [false, true].map(|artificial| terms(StressTerm::Tensor { artificial, gradient }));
    let kernel = Kernel::CubicSpline;
    let constants = Constants { beta: 3.0, artificial_reference: artificial_stress::reference(kernel, 1.2) };
    let program_loop = |(name, terms)| {
        let pair_loop = PairLoop::new(3, terms, kernel, constants);
        let records = neighbourhoods.map(|n| program_records(pair_loop.layout(), particles, n));
        ProgramLoop { name, pair_loop, records }
    };
    [("gas", gas), ("solid, corrected", solid), ("the same, artificial stress", tensile)].map(program_loop).into()
}

fn program_records(layout: &Layout, particles: &[Particle], neighbourhood: &Neighbourhood) -> Vec<f64> {
    let stride = layout.stride();
    let mut records = vec![0.0; (particles.len() + 1) * stride];
    for (number, record) in neighbourhood.order().zip(records.chunks_exact_mut(stride)) {
        let p = &particles[number];
        record[..3].copy_from_slice(&p.position);
        record[layout.velocity()..][..3].copy_from_slice(&p.velocity);
        let draw = |k: usize| uniform(45, number as u64, k as u64) - 0.5;
        for k in 0..layout.stress_words() {
            record[layout.stress() + k] = if k < 3 { -p.pressure } else { draw(k) };
        }
        record[layout.volume()] = 1.0 / p.density;
        set_half(record, layout.density(), p.density);
        set_half(record, layout.h_inverse(), 1.0 / p.smoothing_length);
        set_half(record, layout.alpha_c(), 1.5 * p.sound_speed);
        if layout.terms.artificial_stress() {
            (0..layout.tensor_words()).for_each(|k| set_half(record, layout.artificial() + k, 0.2 * draw(8 + k)));
        }
    }
    layout.padding(&mut records[particles.len() * stride..]);
    records
}

impl ProgramLoop {
    /// One pass over all rows, chunk by chunk as in a step.
    fn pass(&self, nth: usize, neighbourhood: &Neighbourhood) {
        let Neighbourhood { local, list } = neighbourhood;
        let rows = Rows {
            records: &self.records[nth],
            offsets: &list.offsets,
            entries: &list.entries,
            slots: &local.slot_of_owned,
        };
        let mut sums = [RowSums::default(); CHUNK];
        for start in (0..local.owned()).step_by(CHUNK) {
            self.pair_loop.sum(&rows, start..(start + CHUNK).min(local.owned()), &mut sums);
            black_box(&mut sums);
        }
    }
}
