//! Boxes around shapes, upright, in the body's frame.

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    /// m.
    pub middle: [f64; 3],
    /// Half extents, m.
    pub half: [f64; 3],
    pub dimension: usize,
}

/// Bodies whose surfaces touch to this relative precision do not overlap.
pub const TOUCHING: f64 = 1e-9;

impl BoundingBox {
    /// What two boxes share; none where they touch at most.
    pub fn common(&self, other: &Self) -> Option<Self> {
        let mut common = *self;
        for k in 0..self.dimension {
            let low = (self.middle[k] - self.half[k]).max(other.middle[k] - other.half[k]);
            let high = (self.middle[k] + self.half[k]).min(other.middle[k] + other.half[k]);
            if high - low <= TOUCHING * (self.half[k] + other.half[k]) {
                return None;
            }
            (common.middle[k], common.half[k]) = (0.5 * (low + high), 0.5 * (high - low));
        }
        Some(common)
    }

    /// Points of a regular grid, the middle of each cell.
    pub fn grid(self) -> impl Iterator<Item = [f64; 3]> {
        let layers = if self.dimension == 3 { POINTS } else { 1 };
        (0..POINTS * POINTS * layers).map(move |n| {
            let index = [n % POINTS, n / POINTS % POINTS, n / (POINTS * POINTS)];
            std::array::from_fn(|k| self.middle[k] + self.half[k] * ((2 * index[k] + 1) as f64 / POINTS as f64 - 1.0))
        })
    }
}

/// Points of a grid along each axis.
const POINTS: usize = 48;
