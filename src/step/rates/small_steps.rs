//! How many small steps make a large one, and how long they are.

/// More small steps than this are not made in a large one, which is shortened instead.
pub const MOST_STEPS: u32 = 1 << 14;

/// The small steps of a large one: even parts of it, halved where their limit falls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmallSteps {
    /// Of the next one, s.
    pub length: f64,
    /// Those that are made, and all, as if all had this length.
    done: u32,
    all: u32,
    /// Whether the scene says how many.
    fixed: bool,
}

impl SmallSteps {
    /// Steps that add up to `dt`, none longer than `limit`, s; or a `given` number of them.
    pub fn new(dt: f64, limit: f64, given: Option<u32>) -> Self {
        let needed = ((dt / limit).ceil() as u32).clamp(1, MOST_STEPS);
        let all = given.unwrap_or(needed);
        Self { length: dt / f64::from(all), done: 0, all, fixed: given.is_some() }
    }

    /// How many are left.
    pub fn left(&self) -> u32 {
        self.all - self.done
    }

    /// Makes one; returns the time since the beginning of the large step, s.
    pub fn advance(&mut self) -> f64 {
        self.done += 1;
        f64::from(self.done) * self.length
    }

    /// Those that are left must not be longer than `limit`, s.
    pub fn shorten(&mut self, limit: f64) {
        while !self.fixed && self.length > limit && self.all < MOST_STEPS {
            self.length *= 0.5;
            self.done *= 2;
            self.all *= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_steps_add_up_and_keep_their_limit() {
        assert_eq!(SmallSteps::new(1.0, f64::INFINITY, None).left(), 1);
        assert_eq!(SmallSteps::new(0.0, 1.0, None).left(), 1);
        assert_eq!(SmallSteps::new(1.0, 0.3, None), SmallSteps { length: 0.25, done: 0, all: 4, fixed: false });
        assert_eq!(SmallSteps::new(1.0, 0.19, None).left(), 6);
        assert_eq!(SmallSteps::new(1.0, 0.0, None).left(), MOST_STEPS);
        let dt = 0.1 + 0.2;
        let mut steps = SmallSteps::new(dt, dt / 7.0, None);
        let (mut sum, mut elapsed) = (0.0, 0.0);
        for limit in [1.0, 0.03, 0.5, 0.01] {
            sum += steps.length;
            elapsed = steps.advance();
            assert!((elapsed - sum).abs() < 1e-15);
            steps.shorten(limit);
            assert!(steps.length <= limit);
        }
        assert!(elapsed < dt);
        while steps.left() > 0 {
            elapsed = steps.advance();
        }
        assert!((elapsed - dt).abs() < 1e-15);
        let mut given = SmallSteps::new(1.0, 1e-9, Some(4));
        given.shorten(1e-9);
        assert_eq!((given.left(), given.length), (4, 0.25));
    }
}
