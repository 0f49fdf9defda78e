//! What the laws have in common: pressure with its derivatives, bounds of the speed of sound, and tension that fades.

/// Pressure and its partial derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// Pa.
    pub p: f64,
    /// dP/drho at constant energy, m^2/s^2.
    pub by_rho: f64,
    /// dP/du at constant density, kg/m^3.
    pub by_u: f64,
}

impl Slopes {
    /// c^2 = dP/drho + P / rho^2 dP/du, m^2/s^2.
    #[inline]
    pub fn sound2(&self, rho: f64) -> f64 {
        self.by_rho + self.p * self.by_u / (rho * rho)
    }
}

/// The speed of sound of a solid, m/s, whose square is at least a quarter of that at rest, `rest2`.
#[inline]
pub fn bounded_sound(sound2: f64, rest2: f64) -> f64 {
    let lowest = 0.25 * rest2;
    if sound2 < lowest { lowest } else { sound2 }.sqrt()
}

/// Where tension begins to fade, and where it has gone, as rho / rho_0.
pub(super) const TENSION_FADES: f64 = 0.95;
pub(super) const TENSION_GONE: f64 = 0.85;

/// Tension of matter that has expanded too far to bear it: it fades linearly between eta = 0.95 and 0.85. The largest tension that
/// is left, 0.056 A at most, is a few times the spall strength of metals, and rock breaks at strains of 1e-3, so that solids
/// are limited by their own fracture and never by this.
#[inline]
pub(super) fn fading(state: Slopes, eta: f64, inverse_rho_0: f64) -> Slopes {
    if !(state.p < 0.0 && eta < TENSION_FADES) {
        return state;
    }
    let slope = 1.0 / (TENSION_FADES - TENSION_GONE);
    if eta <= TENSION_GONE {
        return Slopes { p: 0.0, by_rho: 0.0, by_u: 0.0 };
    }
    let share = (eta - TENSION_GONE) * slope;
    Slopes {
        p: share * state.p,
        by_rho: share * state.by_rho + state.p * slope * inverse_rho_0,
        by_u: share * state.by_u,
    }
}
