//! One particle can make the time step collapse, and a run with it. Then the log names the particle, once, and again whenever
//! the step has fallen much farther; the run goes on. Follows from the steps alone, so that any ranks log the same.

/// A step this small against the largest so far has collapsed.
const COLLAPSED: f64 = 1e-3;
/// A further fall worth another line.
const FARTHER: f64 = 0.1;

/// The largest step so far, and the last one that was warned of.
#[derive(Debug, Default)]
pub struct Collapse {
    largest: f64,
    warned: Option<f64>,
}

impl Collapse {
    /// Takes note of a step's limit, s; where it has collapsed and that is news, how large it is against the largest so far.
    pub fn note(&mut self, dt: f64) -> Option<f64> {
        self.largest = self.largest.max(dt);
        let least = self.warned.map_or(COLLAPSED * self.largest, |warned| FARTHER * warned);
        if dt >= least {
            return None;
        }
        self.warned = Some(dt);
        Some(dt / self.largest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collapse_is_told_once_and_again_when_it_gets_much_worse() {
        let mut collapse = Collapse::default();
        let told = |collapse: &mut Collapse, dt: f64| collapse.note(dt).is_some();
        // A shock shortens steps, and that is no collapse.
        assert!([1.0, 2.0, 0.1, 0.01, 0.0021].iter().all(|&dt| !told(&mut collapse, dt)));
        assert_eq!(collapse.note(1e-3), Some(5e-4));
        assert!([1e-3, 9e-4, 1.0, 5e-4, 2e-4].iter().all(|&dt| !told(&mut collapse, dt)));
        assert!(told(&mut collapse, 9e-5));
        assert!(!told(&mut collapse, 8e-5));
    }
}
