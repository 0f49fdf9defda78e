//! Detects a collapse of the time step, which one particle can cause. Then the log names the particle, once, and again whenever
//! the step has fallen much farther; the run goes on, unless energy has come from nowhere and steps are so short that it would never end.
//! This follows from the steps alone, so that the log is the same on any ranks.

/// A step below this share of the largest so far has collapsed.
const COLLAPSED: f64 = 1e-3;
/// A further fall by this factor is logged again.
const FARTHER: f64 = 0.1;
/// Steps so much shorter than the largest lead nowhere, where energy is off by so much of what there is.
const HOPELESS: f64 = 1e-6;
const OFF: f64 = 0.1;

/// The largest step so far, and the last one that was logged.
#[derive(Debug, Default)]
pub struct Collapse {
    largest: f64,
    warned: Option<f64>,
}

impl Collapse {
    /// Records a step's limit, s; where a collapse is to be logged, returns its ratio to the largest so far.
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

/// Whether a run has blown up: `ratio`: of the step to the largest; `drift`: of energy, over what there is.
pub fn is_hopeless(ratio: f64, drift: f64) -> bool {
    ratio < HOPELESS && drift > OFF
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collapse_is_noted_once_and_again_when_it_gets_much_worse() {
        let mut collapse = Collapse::default();
        let noted = |collapse: &mut Collapse, dt: f64| collapse.note(dt).is_some();
        // A shock shortens steps, which is not a collapse.
        assert!([1.0, 2.0, 0.1, 0.01, 0.0021].iter().all(|&dt| !noted(&mut collapse, dt)));
        assert_eq!(collapse.note(1e-3), Some(5e-4));
        assert!([1e-3, 9e-4, 1.0, 5e-4, 2e-4].iter().all(|&dt| !noted(&mut collapse, dt)));
        assert!(noted(&mut collapse, 9e-5));
        assert!(!noted(&mut collapse, 8e-5));
        assert!(is_hopeless(9e-7, 0.11) && !is_hopeless(1e-12, 0.09) && !is_hopeless(2e-6, 5.0));
    }
}
