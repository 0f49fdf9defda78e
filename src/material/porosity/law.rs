//! The state of porous matter from its density, its energy and its remaining pores.
//!
//! ```text
//! P = P_s(alpha rho, u) / alpha                                    Jutzi et al. 2008, eq. 3 (Carroll & Holt 1972)
//! P-alpha      alpha = alpha_crush(P) on first loading             rho-alpha: with P at u = 0    epsilon-alpha: alpha(rho)
//! f = 1 + rho / alpha d alpha / d rho                              eq. 53
//! ```
//! P-alpha is solved for alpha, as the return to a yield surface is: a trial state with the previous pores; where it lies beyond
//! the crush curve, the state on the curve that has this density and energy. So alpha is on the curve whatever the step,
//! unloading and loading again change nothing, and P >= P_s leaves alpha = 1 exactly. Rates (eqs 24-25) drift off the curve, and
//! ratchet where loading is inferred from the sign of dP/dt alone.
//!
//! f for P-alpha without a division by the rate of density, with du = P / rho^2 drho:
//!
//! ```text
//! f = { alpha + alpha' P [1 + P_u / (alpha rho)] } / { alpha + alpha' [P - rho P_rho] }      alpha' = d alpha / dP
//! ```
//! Sound travels with the speed of unloading and of the elastic branch. Compression that crushes pores is much slower,
//!
//! ```text
//! c_load^2 = dP/drho = f P_rho + P_u P / (alpha rho^2) + (1 - f) P / rho
//! ```
//! with f bounded from below by 0. Viscosity may use this speed (`viscosity.speed = "loading"`): with c_s it spreads a weak wave of
//! compaction over many times its width.
//!
//! P_u, P_rho derivatives of the matrix pressure P_s. f may be negative: then the matrix expands while the body is compressed
//! (alpha_0 above (c + 2) / c). No density is bounded from below here.

use super::crush_curve::CrushCurve;
use super::elastic::Elastic;
use super::strain_law::StrainLaw;
use crate::material::eos::Eos;
use crate::material::eos::slopes::{Slopes, bounded_sound};

/// How distention follows compression.
#[derive(Debug, Clone, PartialEq)]
pub enum Compaction {
    Pressure {
        curve: CrushCurve,
        elastic: Option<Elastic>,
    },
    ColdPressure(CrushCurve),
    Strain(StrainLaw),
    /// Constant, in the late stage.
    Kept,
}

/// Whether the pressure of a crush curve includes heat.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Heat {
    Counts,
    Ignored,
}

/// Distention as it is, and as it would be without load.
#[derive(Debug, Clone, Copy)]
struct Pores {
    now: f64,
    unloaded: f64,
}

impl Pores {
    /// Load does not change them, unless it crushes them.
    #[inline]
    fn rigid(distention: f64) -> Self {
        Self { now: distention, unloaded: distention }
    }
}

/// Porous matter of one body.
#[derive(Debug, Clone, PartialEq)]
pub struct Porous {
    pub compaction: Compaction,
    /// Equation of state of the matrix.
    pub eos: Eos,
    /// Square of the matrix's bulk speed of sound at rest, m^2/s^2.
    pub sound2_at_rest: f64,
    /// Distention that the body starts with.
    pub initial: f64,
}

/// State of porous matter at a density and energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    pub distention: f64,
    /// Distention it would have without load: that of rigid pores.
    pub unloaded: f64,
    /// Pa.
    pub pressure: f64,
    /// Bulk speed of sound, m/s.
    pub sound_speed: f64,
    /// c_load, m/s.
    pub loading_speed: f64,
    /// f, not bounded; 1 where no pore collapses.
    pub stress_factor: f64,
}

impl Porous {
    /// State at density `rho`, kg/m^3, and internal energy `u`, J/kg, of matter whose pores were `unloaded` without load.
    #[inline]
    pub fn state(&self, rho: f64, u: f64, unloaded: f64) -> State {
        if unloaded <= 1.0 {
            return self.with(rho, u, Pores::rigid(1.0), |_| 1.0);
        }
        match &self.compaction {
            Compaction::Pressure { curve, elastic: None } => self.crushed(rho, u, curve, Heat::Counts, unloaded),
            Compaction::Pressure { curve, elastic: Some(elastic) } => self.elastic(rho, u, curve, elastic, unloaded),
            Compaction::ColdPressure(curve) => self.crushed(rho, u, curve, Heat::Ignored, unloaded),
            Compaction::Kept => self.with(rho, u, Pores::rigid(unloaded), |_| 1.0),
            Compaction::Strain(law) => {
                let (alpha, by_strain) = law.at(rho);
                if alpha < unloaded {
                    self.with(rho, u, Pores::rigid(alpha), |_| 1.0 - by_strain / alpha)
                } else {
                    self.with(rho, u, Pores::rigid(unloaded), |_| 1.0)
                }
            }
        }
    }

    /// Rigid pores.
    #[inline]
    fn crushed(&self, rho: f64, u: f64, curve: &CrushCurve, heat: Heat, unloaded: f64) -> State {
        let u_curve = if heat == Heat::Counts { u } else { 0.0 };
        let trial = self.pressure(rho, u_curve, unloaded);
        if curve.at(trial).0 >= unloaded {
            return self.with(rho, u, Pores::rigid(unloaded), |_| 1.0);
        }
        let alpha = self.on_curve(rho, u_curve, curve, unloaded);
        self.with(rho, u, Pores::rigid(alpha), |hot| {
            if heat == Heat::Counts {
                return self.factor(rho, alpha, curve.at(hot.p / alpha).1, hot, hot.by_u);
            }
            let cold = self.eos.slopes(alpha * rho, u_curve);
            self.factor(rho, alpha, curve.at(cold.p / alpha).1, &cold, 0.0)
        })
    }

    /// Elastic pores: first along the elastic line, then, where this ends beyond the crush curve, on the curve.
    fn elastic(&self, rho: f64, u: f64, curve: &CrushCurve, elastic: &Elastic, unloaded: f64) -> State {
        if self.pressure(rho, u, unloaded) <= 0.0 {
            return self.with(rho, u, Pores::rigid(unloaded), |_| 1.0);
        }
        // Beyond the first digits above 1 the line is as stiff as the matrix.
        let lowest = 1.0 + 1e-12 * (unloaded - 1.0);
        let without_load = elastic.level(unloaded);
        let alpha = solve(lowest, unloaded, |alpha| {
            let (p, by_alpha) = self.pressure_and_slope(rho, u, alpha);
            (p - (elastic.level(alpha) - without_load), by_alpha - 1.0 / elastic.slope(alpha))
        });
        let p = elastic.level(alpha) - without_load;
        if p <= curve.elastic_limit() || curve.at(p).0 >= alpha {
            return self
                .with(rho, u, Pores { now: alpha, unloaded }, |hot| {
                    self.factor(rho, alpha, elastic.slope(alpha), hot, hot.by_u)
                })
                .slowed(rho, elastic.slope(alpha));
        }
        let alpha = self.on_curve(rho, u, curve, alpha);
        if alpha <= 1.0 {
            return self.with(rho, u, Pores::rigid(1.0), |_| 1.0);
        }
        let p = self.pressure(rho, u, alpha);
        // The line that leads back from here: its pressure at alpha is p.
        let wanted = elastic.level(alpha) - p;
        let left = solve(alpha, unloaded, |left| (wanted - elastic.level(left), -1.0 / elastic.slope(left)));
        self.with(rho, u, Pores { now: alpha, unloaded: left }, |hot| {
            self.factor(rho, alpha, curve.at(p).1, hot, hot.by_u)
        })
        .slowed(rho, elastic.slope(alpha))
    }

    /// The distention below `unloaded` at which the crush curve has this density and energy.
    fn on_curve(&self, rho: f64, u: f64, curve: &CrushCurve, unloaded: f64) -> f64 {
        if self.pressure(rho, u, 1.0) >= curve.solid_pressure() {
            return 1.0;
        }
        solve(1.0, unloaded, |alpha| {
            let (p, by_alpha) = self.pressure_and_slope(rho, u, alpha);
            let (crushed, by_p) = curve.at(p);
            (alpha - crushed, 1.0 - by_p * by_alpha)
        })
    }

    #[inline]
    fn pressure(&self, rho: f64, u: f64, alpha: f64) -> f64 {
        self.eos.slopes(alpha * rho, u).p / alpha
    }

    /// P and dP/dalpha at constant density and energy.
    fn pressure_and_slope(&self, rho: f64, u: f64, alpha: f64) -> (f64, f64) {
        let matrix = self.eos.slopes(alpha * rho, u);
        let p = matrix.p / alpha;
        (p, (rho * matrix.by_rho - p) / alpha)
    }

    /// f on a path with the slope `by_p`, 1/Pa.
    fn factor(&self, rho: f64, alpha: f64, by_p: f64, matrix: &Slopes, by_u: f64) -> f64 {
        let p = matrix.p / alpha;
        (alpha + by_p * p * (1.0 + by_u / (alpha * rho))) / (alpha + by_p * (p - rho * matrix.by_rho))
    }

    #[inline]
    fn with(&self, rho: f64, u: f64, pores: Pores, factor: impl Fn(&Slopes) -> f64) -> State {
        let Pores { now: alpha, unloaded } = pores;
        let matrix_density = alpha * rho;
        let matrix = self.eos.slopes(matrix_density, u);
        let (pressure, stress_factor) = (matrix.p / alpha, factor(&matrix));
        let sound_speed = bounded_sound(matrix.sound2(matrix_density), self.sound2_at_rest);
        let loading_speed = if stress_factor < 1.0 {
            let share = stress_factor.max(0.0);
            let heat = matrix.by_u * pressure / (matrix_density * rho);
            (share * matrix.by_rho + heat + (1.0 - share) * pressure / rho).max(0.0).sqrt().min(sound_speed)
        } else {
            sound_speed
        };
        State { distention: alpha, unloaded, pressure, sound_speed, loading_speed, stress_factor }
    }
}

impl State {
    /// This state with the speed of sound of elastic pores: dP/drho on the line.
    fn slowed(self, rho: f64, by_p: f64) -> Self {
        let c2 = self.sound_speed * self.sound_speed;
        let give = 1.0 - by_p * (c2 * rho - self.pressure) / self.distention;
        Self { sound_speed: (c2 / give.max(1.0)).sqrt(), ..self }
    }
}

/// The root of `f`, which gives its value and slope, between `low`, where it is at most zero, and `high`, where it is above:
/// Newton's steps from above, halved where they would leave the bracket.
fn solve(mut low: f64, mut high: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    /// Enough to halve the bracket down to neighbouring numbers.
    const MOST: usize = 64;
    const NOISE: f64 = 32.0 * f64::EPSILON;
    let mut x = high;
    for _ in 0..MOST {
        let (value, slope) = f(x);
        if value == 0.0 {
            return x;
        }
        if value > 0.0 {
            high = x
        } else {
            low = x
        }
        let newton = x - value / slope;
        // The last digits of distention are noise of the equation of state. This comes before the bracket, as a root that noise
        // has put just beyond it would be halved away from, and found again in some twenty steps.
        if (newton - x).abs() <= NOISE * x {
            return newton.clamp(low, high);
        }
        x = if newton > low && newton < high { newton } else { low + 0.5 * (high - low) };
    }
    x
}

#[cfg(test)]
mod tests {
    use super::super::testing::{aluminium, ice, simple};
    use super::*;

    /// alpha is on the curve after any step, the pressure is the matrix's over alpha, and nothing changes when the same
    /// state is evaluated again.
    #[test]
    fn states_lie_on_or_below_the_crush_curve() {
        for porous in [simple(3.0, 2.0), aluminium(1.275), ice(3.0)] {
            let Compaction::Pressure { curve, .. } = &porous.compaction else { unreachable!() };
            let rho_0 = porous.eos.reference_density().unwrap() / porous.initial;
            let mut crushed = 0;
            for k in 0..400 {
                let rho = rho_0 * (1.0 + 1e-4 * f64::from(k * k));
                for u in [0.0, 1e3, 1e5] {
                    let state = porous.state(rho, u, porous.initial);
                    assert!(state.distention >= 1.0 && state.distention <= state.unloaded);
                    let p = porous.eos.slopes(state.distention * rho, u).p / state.distention;
                    assert_eq!(state.pressure, p);
                    let bound = curve.at(p).0;
                    let elastic = p <= curve.elastic_limit();
                    assert!(elastic || state.distention <= bound * (1.0 + 1e-9), "{rho} {u} {state:?} {bound}");
                    if state.unloaded < porous.initial {
                        crushed += 1;
                        assert!((state.distention - bound).abs() < 1e-9, "{rho} {u} {state:?} {bound}");
                        assert_eq!(state.distention == 1.0, p >= curve.solid_pressure());
                    }
                    let again = porous.state(rho, u, state.unloaded);
                    assert!((again.distention - state.distention).abs() < 1e-11, "{again:?} {state:?}");
                    assert!((again.unloaded - state.unloaded).abs() < 1e-11);
                }
            }
            assert!(crushed > 300, "{crushed}");
        }
    }

    /// Load, unload, load again, ten times between 2.0e8 and 3.5e8 Pa: alpha stays where the largest pressure put it. Inferring
    /// loading from the sign of dP/dt alone would end at alpha = 1.
    #[test]
    fn cycles_of_load_do_not_ratchet() {
        let porous = simple(3.0, 2.0);
        let Compaction::Pressure { curve, .. } = &porous.compaction else { unreachable!() };
        let at_pressure = |p: f64, unloaded: f64| {
            let (mut low, mut high) = (800.0, 3000.0);
            while high - low > 1e-12 * high {
                let middle = 0.5 * (low + high);
                if porous.state(middle, 0.0, unloaded).pressure < p { low = middle } else { high = middle }
            }
            porous.state(high, 0.0, unloaded)
        };
        let mut unloaded = at_pressure(3.5e8, 3.0).unloaded;
        let first = curve.at(3.5e8).0;
        assert!((unloaded - first).abs() < 1e-9 && (first - 1.637).abs() < 1e-3, "{unloaded} {first}");
        for _ in 0..10 {
            for share in 0..=20 {
                let p = 2.0e8 + 1.5e8 * f64::from(share) / 20.0;
                unloaded = at_pressure(p, unloaded).unloaded;
            }
        }
        assert!((unloaded - first).abs() < 1e-8, "{unloaded} {first}");
    }

    /// Newton's steps are few, so that pores cost little: with the bracket tested before convergence they were 16 in the mean, and
    /// up to 50.
    #[test]
    fn roots_are_found_in_few_steps() {
        let porous = aluminium(1.275);
        let Compaction::Pressure { curve, elastic: Some(elastic) } = &porous.compaction else { unreachable!() };
        let (mut most, mut sum, mut count) = (0, 0, 0);
        let mut solved = |low: f64, high: f64, f: &dyn Fn(f64) -> (f64, f64)| {
            let steps = std::cell::Cell::new(0);
            let root = solve(low, high, |x| {
                steps.set(steps.get() + 1);
                f(x)
            });
            (most, sum, count) = (most.max(steps.get()), sum + steps.get(), count + 1);
            root
        };
        for k in 0..4000 {
            let unloaded = 1.02 + 0.255 * f64::from(k * 7919 % 1000) / 1000.0;
            let rho = 2700.0 / unloaded * (1.0 + 1e-7 * libm::exp10(5.5 * f64::from(k * 104729 % 997) / 997.0));
            if porous.pressure(rho, 0.0, 1.0) >= curve.solid_pressure() {
                continue;
            }
            let line = |alpha: f64| {
                let (p, by_alpha) = porous.pressure_and_slope(rho, 0.0, alpha);
                (p - elastic.pressure(alpha, unloaded), by_alpha - 1.0 / elastic.slope(alpha))
            };
            let alpha = solved(1.0 + 1e-12 * (unloaded - 1.0), unloaded, &line);
            if curve.at(elastic.pressure(alpha, unloaded)).0 < alpha {
                solved(1.0, alpha, &|alpha| {
                    let (p, by_alpha) = porous.pressure_and_slope(rho, 0.0, alpha);
                    let (crushed, by_p) = curve.at(p);
                    (alpha - crushed, 1.0 - by_p * by_alpha)
                });
            }
        }
        let mean = f64::from(sum) / f64::from(count);
        assert!(count > 2000 && most <= 20 && mean < 5.0, "{count} roots, {mean} steps each, {most} at most");
    }

    /// f against its definition, 1 + rho / alpha d alpha / d rho with du = P / rho^2 drho, by differences, in all laws.
    #[test]
    fn the_factor_is_that_of_its_definition() {
        for porous in [
            simple(3.0, 2.0),
            aluminium(1.275),
            ice(3.0),
            super::super::testing::cold(3.0),
            super::super::testing::strained(3.0),
        ] {
            let rho_0 = porous.eos.reference_density().unwrap() / porous.initial;
            for compression in [1.003, 1.05, 1.2, 1.7] {
                let (rho, u) = (rho_0 * compression, 2e4);
                let here = porous.state(rho, u, porous.initial);
                if here.unloaded == porous.initial || here.distention == 1.0 {
                    continue;
                }
                let d = 1e-6 * rho;
                let side =
                    |d: f64| porous.state(rho + d, u + here.pressure / (rho * rho) * d, porous.initial).distention;
                let by_rho = (side(d) - side(-d)) / (2.0 * d);
                let expected = 1.0 + rho / here.distention * by_rho;
                assert!((here.stress_factor - expected).abs() < 2e-5, "{compression} {here:?} {expected}");
                let pressure =
                    |d: f64| porous.state(rho + d, u + here.pressure / (rho * rho) * d, porous.initial).pressure;
                let loading = ((pressure(d) - pressure(-d)) / (2.0 * d)).sqrt();
                if expected > 0.01 {
                    assert!((here.loading_speed / loading - 1.0).abs() < 1e-3, "{compression} {here:?} {loading}");
                }
            }
        }
    }

    /// rho-alpha does not include heat, and so its factor is the same whatever the energy, cold matter included.
    #[test]
    fn the_factor_of_rho_alpha_does_not_depend_on_heat() {
        let porous = super::super::testing::cold(3.0);
        let [cold, hot] = [0.0, 2e4].map(|u| porous.state(1200.0, u, 3.0));
        assert!(cold.unloaded < 3.0 && cold.stress_factor < 1.0, "{cold:?}");
        assert_eq!((cold.distention, cold.stress_factor), (hot.distention, hot.stress_factor));
    }

    /// Without pores everything is as in the solid, bit for bit.
    #[test]
    fn no_pores_are_a_solid() {
        let porous = ice(1.0);
        for rho in [850.0, 917.0, 1300.0] {
            let state = porous.state(rho, 3e5, porous.initial);
            assert_eq!((state.pressure, state.sound_speed), porous.eos.pressure(rho, 3e5));
            assert_eq!((state.distention, state.unloaded, state.stress_factor), (1.0, 1.0, 1.0));
        }
    }

    /// Under tension and far expansion pores stay as they are, and all values stay finite.
    #[test]
    fn expansion_leaves_pores_alone() {
        for porous in [simple(3.0, 2.0), aluminium(1.275), ice(3.0)] {
            let rho_0 = porous.eos.reference_density().unwrap() / porous.initial;
            for eta in [1e-6, 1e-3, 0.5, 0.9, 0.999] {
                for unloaded in [porous.initial, 1.0 + 0.3 * (porous.initial - 1.0), 1.0] {
                    let state = porous.state(eta * rho_0, 0.0, unloaded);
                    assert_eq!(state.distention, unloaded);
                    assert!(state.pressure <= 0.0 && state.sound_speed > 0.0 && state.stress_factor == 1.0);
                }
            }
        }
    }

    /// The elastic line: slower sound, and back to alpha_0 without load.
    #[test]
    fn elastic_pores_come_back() {
        let porous = aluminium(1.275);
        let rho_0 = 2700.0 / 1.275;
        let pressed = porous.state(rho_0 * 1.001, 0.0, 1.275);
        assert!(pressed.distention < 1.275 && pressed.unloaded == 1.275 && pressed.pressure < 8e7);
        // dP/drho by differences; cold, the matrix's own speed is sqrt(A / rho_0) = 5277 m/s.
        let work = pressed.pressure / (rho_0 * 1.001 * 1.001);
        let side = |d: f64| porous.state(rho_0 * (1.001 + d), work * d, 1.275).pressure;
        let slope = (side(1e-6) - side(-1e-6)) / (2e-6 * rho_0);
        assert!((pressed.sound_speed / slope.sqrt() - 1.0).abs() < 2e-4, "{} {}", pressed.sound_speed, slope.sqrt());
        assert!((pressed.sound_speed - 4080.0).abs() < 20.0, "{}", pressed.sound_speed);
        assert_eq!(porous.state(rho_0, 0.0, 1.275).distention, 1.275);
        // Unloaded from the curve, it ends at a smaller distention, and loads again up to where it was.
        let crushed = porous.state(rho_0 * 1.1, 0.0, 1.275);
        let back = porous.state(crushed.unloaded.recip() * 2700.0, 0.0, crushed.unloaded);
        assert!(back.pressure.abs() < 1e-3 * 8e7 && crushed.unloaded > crushed.distention && crushed.unloaded < 1.275);
    }
}
