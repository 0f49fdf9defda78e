//! The sums of the pair loop on random states: they conserve momentum and energy, agree with a plain double loop, and have
//! the same bits on every instruction set.

use sph_mpi::kernel::{CubicSpline, Kernel, Shape, WendlandC2};
use sph_mpi::math::lanes::Width;
use sph_mpi::pair::artificial_stress;
use sph_mpi::pair::record::{PressureGradient, StressTerm, TensorGradient, ViscousTerm, half, set_half};
use sph_mpi::pair::rows::Constants;
use sph_mpi::pair::{Layout, PairLoop, RowSums, Rows, Terms, angular_momentum};
use sph_mpi::random::uniform;

/// A random cloud, every particle a neighbour of every other.
struct Cloud {
    layout: Layout,
    records: Vec<f64>,
    offsets: Vec<usize>,
    entries: Vec<u32>,
    slots: Vec<u32>,
    mass: Vec<f64>,
}

fn cloud(dimension: usize, terms: Terms, count: usize, seed: u64) -> Cloud {
    let layout = Layout { dimension, terms };
    let stride = layout.stride();
    let mut records = vec![0.0; (count + 1) * stride];
    let mut mass = Vec::new();
    for i in 0..count {
        let record = &mut records[i * stride..(i + 1) * stride];
        let mut draw = 0;
        let mut next = |low: f64, high: f64| {
            draw += 1;
            low + (high - low) * uniform(seed, i as u64, draw)
        };
        for a in 0..dimension {
            record[a] = next(0.0, 3.0);
            record[dimension + a] = next(-1.0, 1.0);
        }
        for k in 0..layout.stress_words() {
            record[layout.stress() + k] = next(-2.0, 2.0);
        }
        record[layout.volume()] = next(0.1, 0.4);
        set_half(record, layout.density(), next(0.5, 3.0));
        set_half(record, layout.h_inverse(), next(0.8, 1.3));
        if terms.viscosity != ViscousTerm::Off {
            set_half(record, layout.alpha_c(), next(0.5, 2.0));
        }
        if matches!(terms.viscosity, ViscousTerm::OwnBeta | ViscousTerm::Reconstructed) {
            set_half(record, layout.beta(), next(1.0, 4.0));
        }
        if terms.reconstructs() {
            for k in 0..layout.tensor_words() {
                set_half(record, layout.slope() + k, next(-1.0, 0.5));
            }
        }
        if terms.artificial_stress() {
            for k in 0..layout.tensor_words() {
                set_half(record, layout.artificial() + k, next(-1.0, 1.0));
            }
        }
        for k in 0..layout.axial_words() {
            set_half(record, layout.axial() + k, next(-1.0, 1.0));
        }
        mass.push(record[layout.volume()] * half(record, layout.density()));
    }
    layout.padding(&mut records[count * stride..]);
    let (mut offsets, mut entries) = (vec![0], Vec::new());
    for i in 0..count {
        entries.extend((0..count as u32).filter(|&j| j != i as u32));
        while entries.len() % 8 != 0 {
            entries.push(count as u32);
        }
        offsets.push(entries.len());
    }
    Cloud { layout, records, offsets, entries, slots: (0..count as u32).collect(), mass }
}

impl Cloud {
    fn rows(&self) -> Rows<'_> {
        Rows { records: &self.records, offsets: &self.offsets, entries: &self.entries, slots: &self.slots }
    }

    fn sums(&self, kernel: Kernel, width: Width) -> Vec<RowSums> {
        let constants = Constants { beta: 3.0, artificial_reference: artificial_stress::reference(kernel, 1.2) };
        let pair_loop = PairLoop::with_width(self.layout.dimension, self.layout.terms, kernel, constants, width);
        let mut out = vec![RowSums::default(); self.mass.len()];
        pair_loop.sum(&self.rows(), 0..self.mass.len(), &mut out);
        out
    }

    /// The records, made for another layout, in the order of this one: all but slopes, in pairs of a pressure or a tensor.
    fn records_in(&self, from: &Layout) -> Vec<f64> {
        let to = &self.layout;
        let mut records = vec![0.0; self.records.len() / from.stride() * to.stride()];
        for (old, new) in self.records.chunks_exact(from.stride()).zip(records.chunks_exact_mut(to.stride())) {
            new[..=to.volume()].copy_from_slice(&old[..=from.volume()]);
            let mut copy = |to: usize, from: usize, count: usize| {
                (0..count).for_each(|k| set_half(new, to + k, half(old, from + k)));
            };
            copy(to.density(), from.density(), 4);
            copy(to.axial(), from.axial(), to.axial_words());
            if to.terms.reconstructs() {
                copy(to.slope(), from.slope(), to.tensor_words());
            }
        }
        records
    }

    fn record(&self, i: usize) -> &[f64] {
        &self.records[i * self.layout.stride()..(i + 1) * self.layout.stride()]
    }
}

/// Every combination that can be said.
fn all_terms() -> Vec<Terms> {
    let mut all = Vec::new();
    for viscosity in [ViscousTerm::Off, ViscousTerm::SameBeta, ViscousTerm::OwnBeta, ViscousTerm::Reconstructed] {
        let mut add = |stress: StressTerm| {
            let terms = Terms { stress, viscosity };
            all.extend((terms.corrects() || !terms.reconstructs()).then_some(terms));
        };
        add(StressTerm::Pressure { gradient: PressureGradient::Plain });
        for contrast in [false, true] {
            add(StressTerm::Pressure { gradient: PressureGradient::Corrected { contrast } });
        }
        for artificial in [false, true] {
            add(StressTerm::Tensor { artificial, gradient: TensorGradient::Plain });
            for (contrast, angular_momentum) in [(false, false), (false, true), (true, false), (true, true)] {
                let gradient = TensorGradient::Corrected { contrast, angular_momentum };
                add(StressTerm::Tensor { artificial, gradient });
            }
        }
    }
    all
}

/// The layout is that of the loop that was compiled for the terms.
#[test]
fn loops_read_the_records_of_their_terms() {
    for dimension in [2, 3] {
        for terms in all_terms() {
            let constants = Constants { beta: 3.0, artificial_reference: 1.0 };
            let pair_loop = PairLoop::new(dimension, terms, Kernel::CubicSpline, constants);
            assert_eq!(*pair_loop.layout(), Layout { dimension, terms });
        }
    }
}

fn widths() -> Vec<Width> {
    let mut widths = vec![Width::Portable];
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        widths.push(Width::Avx2);
    } else {
        println!("skipped: no AVX2 here");
    }
    if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl") {
        widths.push(Width::Avx512);
    } else {
        println!("skipped: no AVX-512 here");
    }
    widths
}

#[test]
fn every_width_gives_the_same_bits() {
    for dimension in [2, 3] {
        for terms in all_terms() {
            let cloud = cloud(dimension, terms, 37, 5);
            for kernel in [Kernel::CubicSpline, Kernel::WendlandC2] {
                let expected: Vec<_> = cloud.sums(kernel, Width::Portable).iter().map(bits).collect();
                for width in widths() {
                    let found: Vec<_> = cloud.sums(kernel, width).iter().map(bits).collect();
                    assert_eq!(found, expected, "{dimension}D {terms:?} {kernel:?} {width:?}");
                }
            }
        }
    }
}

fn bits(s: &RowSums) -> Vec<u64> {
    let numbers = s.force.iter().chain(&s.gradient).chain(&s.moment).chain([&s.dissipation, &s.approach]);
    numbers.map(|x| x.to_bits()).chain([s.neighbours as u64]).collect()
}

/// Force of a row times its volume is m a; power is v . m a plus m du/dt.
#[test]
fn momentum_and_energy_are_conserved_and_viscosity_heats() {
    for dimension in [2, 3] {
        for terms in all_terms() {
            for kernel in [Kernel::CubicSpline, Kernel::WendlandC2] {
                let cloud = cloud(dimension, terms, 60, 11);
                let layout = cloud.layout;
                let sums = cloud.sums(kernel, Width::Portable);
                let (mut momentum, mut force_size) = ([0.0; 3], 0.0);
                let (mut power, mut power_size) = (0.0, 0.0);
                for (i, s) in sums.iter().enumerate() {
                    let record = cloud.record(i);
                    let volume = record[layout.volume()];
                    let work = work(&layout, record, s);
                    let mut kinetic = 0.0;
                    for a in 0..dimension {
                        momentum[a] += volume * s.force[a];
                        force_size += (volume * s.force[a]).abs();
                        kinetic += volume * s.force[a] * record[dimension + a];
                    }
                    let heating = volume * (work + 0.5 * s.dissipation);
                    power += kinetic + heating;
                    power_size += kinetic.abs() + heating.abs();
                    if !terms.artificial_stress() {
                        assert!(s.dissipation >= -1e-13 * power_size, "viscosity cools: {}", s.dissipation);
                    }
                }
                // Rounding only: 60 rows of 59 terms.
                assert!(momentum.iter().all(|p| p.abs() < 1e-13 * force_size), "{terms:?} {momentum:?}");
                assert!(power.abs() < 1e-13 * power_size, "{terms:?} {power} of {power_size}");
            }
        }
    }
}

/// Velocities v = G x that all particles carry along G: nothing is left of them, and all where one of a pair carries nothing.
#[test]
fn a_linear_flow_is_not_resisted() {
    for terms in all_terms().into_iter().filter(|terms| terms.reconstructs() && !terms.artificial_stress()) {
        for dimension in [2, 3] {
            let inward = |carried: fn(usize) -> f64, viscosity: ViscousTerm| {
                let mut cloud = cloud(dimension, terms, 30, 8);
                let (stride, layout) = (cloud.layout.stride(), cloud.layout);
                for i in 0..30 {
                    let record = &mut cloud.records[i * stride..(i + 1) * stride];
                    for a in 0..dimension {
                        record[dimension + a] = -(0.5 + a as f64) * record[a];
                        set_half(record, layout.slope() + a, -(0.5 + a as f64) * carried(i));
                    }
                    (dimension..layout.tensor_words()).for_each(|k| set_half(record, layout.slope() + k, 0.0));
                }
                let mut plain = Cloud { layout: Layout { dimension, terms: Terms { viscosity, ..terms } }, ..cloud };
                plain.records = plain.records_in(&layout);
                plain.sums(Kernel::CubicSpline, Width::Portable).iter().map(|s| s.dissipation).collect::<Vec<_>>()
            };
            let whole = inward(|_| 0.0, ViscousTerm::OwnBeta);
            assert_eq!(inward(|_| 0.0, ViscousTerm::Reconstructed), whole);
            let left = inward(|_| 1.0, ViscousTerm::Reconstructed);
            let half = inward(|i| (i % 2) as f64, ViscousTerm::Reconstructed);
            let sum = |rows: &[f64]| rows.iter().sum::<f64>();
            assert!(sum(&left) < 1e-5 * sum(&whole), "{} of {}", sum(&left), sum(&whole));
            assert!((0.5..0.9).contains(&(sum(&half) / sum(&whole))), "{} of {}", sum(&half), sum(&whole));
        }
    }
}

/// A light particle beside a heavy one: no kernel of the pair is narrower than two thirds of the other.
#[test]
fn the_kernels_of_unlike_particles_are_wide() {
    let terms = all_terms()[0];
    let force = |h_inverse: [f64; 2]| {
        let mut cloud = cloud(3, terms, 2, 1);
        let (stride, layout) = (cloud.layout.stride(), cloud.layout);
        for (i, g) in h_inverse.into_iter().enumerate() {
            set_half(&mut cloud.records[i * stride..(i + 1) * stride], layout.h_inverse(), g);
            cloud.records[i * stride] = 0.1 * i as f64;
            cloud.records[i * stride + 1..i * stride + 3].fill(0.0);
        }
        cloud.sums(Kernel::CubicSpline, Width::Portable).iter().map(|s| s.force).collect::<Vec<_>>()
    };
    assert_eq!(force([8.0, 0.25]), force([0.375, 0.25]));
    assert_eq!(force([0.25, 8.0]), force([0.25, 0.375]));
    assert_ne!(force([0.3125, 0.25]), force([0.375, 0.25]));
    assert_ne!(force([0.25, 0.25]), force([0.375, 0.25]));
}

/// Of a pair the light one strains by all of the motion, and its pressure alone acts on both.
#[test]
fn of_a_pair_the_light_one_gives_way() {
    let with_stress_alone = |terms: &Terms| {
        let plain = !terms.artificial_stress() && !terms.angular_momentum();
        terms.contrast() && terms.viscosity == ViscousTerm::Off && plain
    };
    for terms in all_terms().into_iter().filter(with_stress_alone) {
        let mut contrast = cloud(3, terms, 2, 4);
        let (stride, density, volume) = (contrast.layout.stride(), contrast.layout.density(), contrast.layout.volume());
        for a in 0..3 {
            contrast.records[stride + a] = contrast.records[a] + 0.4;
        }
        let ratios = |with: &Cloud, width: Width| {
            let mut plain = cloud(3, without_contrast(&terms), 2, 4);
            plain.records.clone_from(&with.records);
            let [a, b] = [with, &plain].map(|cloud| cloud.sums(Kernel::CubicSpline, width));
            [0, 1].map(|i| [a[i].gradient[0] / b[i].gradient[0], a[i].force[0] / b[i].force[0]])
        };
        for (heavy, shares) in [(1.0, [1.0, 1.0]), (1e6, [2e-6, 2.0])] {
            set_half(&mut contrast.records[..stride], density, heavy);
            set_half(&mut contrast.records[stride..], density, 1.0);
            (contrast.records[volume], contrast.records[stride + volume]) = (0.3, 0.2);
            let stress = contrast.layout.stress();
            // Ten times the pressure in the heavy one.
            for (record, p) in [(0, 10.0), (stride, 1.0)] {
                contrast.records[record + stress..record + stress + contrast.layout.stress_words()].fill(0.0);
                let diagonal = if terms.tensor() { 3 } else { 1 };
                contrast.records[record + stress..record + stress + diagonal].fill(-p);
            }
            for width in widths() {
                let found = ratios(&contrast, width);
                let force = (10.0 * shares[0] + shares[1]) / 11.0;
                for (found, share) in found.iter().zip(shares) {
                    assert!(
                        (found[0] / share - 1.0).abs() < 2e-6 && (found[1] / force - 1.0).abs() < 2e-6,
                        "{found:?}"
                    );
                }
            }
        }
    }
}

fn without_contrast(terms: &Terms) -> Terms {
    let stress = match terms.tensor() {
        false => StressTerm::Pressure { gradient: PressureGradient::Corrected { contrast: false } },
        true => StressTerm::Tensor {
            artificial: false,
            gradient: TensorGradient::Corrected { contrast: false, angular_momentum: false },
        },
    };
    Terms { stress, ..*terms }
}

fn work(layout: &Layout, record: &[f64], s: &RowSums) -> f64 {
    let d = layout.dimension;
    let g = &s.gradient;
    let t = &record[layout.stress()..];
    let diagonal: f64 = (0..d).map(|a| g[a * d + a] * if layout.terms.tensor() { t[a] } else { t[0] }).sum();
    let w: Vec<f64> = (0..layout.axial_words()).map(|k| half(record, layout.axial() + k)).collect();
    let diagonal = match w.len() {
        0 => diagonal,
        1 => diagonal + angular_momentum::heating::<2>(&w, g),
        _ => diagonal + angular_momentum::heating::<3>(&w, g),
    };
    if !layout.terms.tensor() {
        diagonal
    } else if d == 2 {
        diagonal + t[2] * (g[1] + g[2])
    } else {
        diagonal + t[3] * (g[1] + g[3]) + t[4] * (g[2] + g[6]) + t[5] * (g[5] + g[7])
    }
}

/// A solid with all that acts between its particles but the antisymmetric stress.
fn tensile() -> Terms {
    let gradient = TensorGradient::Corrected { contrast: false, angular_momentum: false };
    Terms { stress: StressTerm::Tensor { artificial: true, gradient }, viscosity: ViscousTerm::SameBeta }
}

/// The full solid kernel against its formulas, pair by pair.
#[test]
fn sums_agree_with_a_plain_double_loop() {
    let terms = tensile();
    let cloud = cloud(3, terms, 25, 3);
    let layout = cloud.layout;
    for (kernel, spline) in [(Kernel::CubicSpline, true), (Kernel::WendlandC2, false)] {
        let sums = cloud.sums(kernel, Width::Portable);
        for i in 0..25 {
            let (mut force, mut gradient, mut moment, mut dissipation, mut approach) =
                ([0.0; 3], [0.0; 9], [0.0; 9], 0.0, 0.0f64);
            let a = cloud.record(i);
            for j in (0..25).filter(|&j| j != i) {
                let b = cloud.record(j);
                let x: Vec<f64> = (0..3).map(|k| a[k] - b[k]).collect();
                let v: Vec<f64> = (0..3).map(|k| a[3 + k] - b[3 + k]).collect();
                let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
                let vx: f64 = x.iter().zip(&v).map(|(x, v)| x * v).sum();
                let (g_i, g_j) = (half(a, layout.h_inverse()), half(b, layout.h_inverse()));
                let wide = g_i.min(g_j);
                let (g_i, g_j) = (g_i.min(1.5 * wide), g_j.min(1.5 * wide));
                let slope = 0.5 * (slope(spline, r, 1.0 / g_i) + slope(spline, r, 1.0 / g_j)) / r;
                let h = 2.0 / (g_i + g_j);
                let g: Vec<f64> = x.iter().map(|x| slope * x * b[layout.volume()]).collect();
                let mu = if vx < 0.0 { h * vx / (r * r + 0.01 * h * h) } else { 0.0 };
                let (rho_i, rho_j) = (half(a, layout.density()), half(b, layout.density()));
                let alpha_c = 0.5 * (half(a, layout.alpha_c()) + half(b, layout.alpha_c()));
                let p = rho_i * rho_j * (-alpha_c * mu + 3.0 * mu * mu) / (0.5 * (rho_i + rho_j));
                let w = |q: f64| if spline { CubicSpline::value(q) } else { WendlandC2::value(q) };
                let f4 = (w(r / h) / w(1.0 / 1.2)).powi(4);
                let index = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];
                for c in 0..3 {
                    for d in 0..3 {
                        let at = |record: &[f64], from: usize| record[from + index[c][d]];
                        let s = at(a, layout.stress()) + at(b, layout.stress());
                        let half_at = |record: &[f64]| half(record, layout.artificial() + index[c][d]);
                        let r = f4 * (half_at(a) + half_at(b));
                        force[c] += (s + r - if c == d { p } else { 0.0 }) * g[d];
                        dissipation -= v[c] * r * g[d];
                        gradient[3 * c + d] -= v[c] * g[d];
                        moment[3 * c + d] -= x[c] * g[d];
                    }
                    dissipation += p * v[c] * g[c];
                }
                if r * wide < 2.0 {
                    approach = approach.max(-mu);
                }
            }
            let s = &sums[i];
            let m = &s.moment;
            let pairs = [
                (m[0], moment[0]),
                (m[1], moment[4]),
                (m[2], moment[8]),
                (m[3], moment[1]),
                (m[4], moment[2]),
                (m[5], moment[5]),
            ];
            let others = [(s.dissipation, dissipation), (s.approach, approach)];
            let all = s.force.into_iter().zip(force).chain(s.gradient.into_iter().zip(gradient));
            for (found, expected) in all.chain(pairs).chain(others) {
                // Different order and association of about 25 terms.
                assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{found} {expected}");
            }
        }
    }
}

fn slope(spline: bool, r: f64, h: f64) -> f64 {
    let (q, pi) = (r / h, std::f64::consts::PI);
    let unit = if spline {
        let (a, b) = ((2.0 - q).max(0.0), (1.0 - q).max(0.0));
        (-0.75 * a * a + 3.0 * b * b) / pi
    } else {
        -5.0 * q * (1.0 - 0.5 * q).max(0.0).powi(3) * 21.0 / (16.0 * pi)
    };
    unit / h.powi(4)
}

/// Coincident particles, an isolated one and padding leave finite numbers, and no force where there is no direction.
#[test]
fn coincident_particles_are_harmless() {
    let terms = tensile();
    let mut cloud = cloud(3, terms, 3, 9);
    let stride = cloud.layout.stride();
    let first: Vec<f64> = cloud.records[..3].to_vec();
    cloud.records[stride..stride + 3].copy_from_slice(&first);
    cloud.records[2 * stride] = 1e3;
    for width in widths() {
        for (i, s) in cloud.sums(Kernel::CubicSpline, width).iter().enumerate() {
            assert!(s.force.iter().chain(&s.gradient).chain(&s.moment).all(|x| *x == 0.0), "{i} {s:?}");
            assert_eq!(s.neighbours, if i < 2 { 1 } else { 0 });
        }
    }
}
