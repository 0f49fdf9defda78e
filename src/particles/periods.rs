//! Periodic domains: along a periodic axis positions are in one period, and a particle that leaves it on one side re-enters
//! on the other.

/// The period of each axis; without limits along open ones.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Periods {
    /// Where the period begins, m.
    pub low: [f64; 3],
    /// m; zero along open axes.
    pub length: [f64; 3],
}

impl Periods {
    /// No axis is periodic.
    pub const OPEN: Self = Self { low: [0.0; 3], length: [0.0; 3] };

    pub fn closed(&self, axis: usize) -> bool {
        self.length[axis] > 0.0
    }

    pub fn any(&self) -> bool {
        (0..3).any(|axis| self.closed(axis))
    }

    /// Length of the shortest period, m; infinite without any.
    pub fn shortest(&self) -> f64 {
        (0..3).filter(|&axis| self.closed(axis)).map(|axis| self.length[axis]).fold(f64::INFINITY, f64::min)
    }

    /// The coordinate within its period. A coordinate that is not finite stays as it is.
    pub fn wrapped(&self, axis: usize, x: f64) -> f64 {
        let (low, length) = (self.low[axis], self.length[axis]);
        if !self.closed(axis) || (low..low + length).contains(&x) {
            return x;
        }
        let inside = x - length * ((x - low) / length).floor();
        // Rounding may end on the far edge, which is the near one.
        if inside >= low + length || inside < low { low } else { inside }
    }

    /// How many periods a coordinate lies beyond that of [`Periods::wrapped`]; whole.
    pub fn rounds(&self, axis: usize, x: f64) -> f64 {
        if self.closed(axis) { ((x - self.wrapped(axis, x)) / self.length[axis]).round() } else { 0.0 }
    }

    /// Shifts from a particle to its nearest images, m: zero first, then one period along one or more axes.
    pub fn shifts<const D: usize>(&self) -> Vec<[f64; D]> {
        let mut shifts = vec![[0.0; D]];
        for axis in (0..D).filter(|&axis| self.closed(axis)) {
            for sign in [-1.0, 1.0] {
                for known in 0..shifts.len() {
                    let mut shift = shifts[known];
                    if shift[axis] == 0.0 {
                        shift[axis] = sign * self.length[axis];
                        shifts.push(shift);
                    }
                }
            }
        }
        shifts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TUBE: Periods = Periods { low: [0.0, -1.0, 0.0], length: [0.0, 3.0, 0.5] };

    #[test]
    fn positions_come_back_on_the_other_side() {
        assert_eq!([-7.0, 7.0].map(|x| TUBE.wrapped(0, x)), [-7.0, 7.0]);
        assert_eq!([-1.0, 2.0, 1.75, -1.5, 8.25].map(|x| TUBE.wrapped(1, x)), [-1.0, -1.0, 1.75, 1.5, -0.75]);
        // Just below the edge would round to the far one.
        assert_eq!(TUBE.wrapped(2, -1e-30), 0.0);
        assert_eq!([-1.0, 2.0, 1.75, -1.5, 8.25].map(|x| TUBE.rounds(1, x)), [0.0, 1.0, 0.0, -1.0, 3.0]);
        assert_eq!([TUBE.rounds(0, 7.0), TUBE.rounds(2, -1e-30)], [0.0, 0.0]);
        assert!(TUBE.wrapped(1, f64::NAN).is_nan());
    }

    #[test]
    fn a_particle_has_one_image_per_side_edge_and_corner() {
        let shifts = TUBE.shifts::<3>();
        assert_eq!((shifts.len(), shifts[0]), (9, [0.0; 3]));
        let mut seen = shifts.clone();
        seen.sort_by(|a, b| a.partial_cmp(b).unwrap());
        seen.dedup();
        assert_eq!(seen.len(), 9);
        assert_eq!(Periods::OPEN.shifts::<2>(), [[0.0; 2]]);
        assert!(TUBE.any() && !Periods::OPEN.any());
        assert_eq!((TUBE.shortest(), Periods::OPEN.shortest()), (0.5, f64::INFINITY));
    }
}
