//! Studies: the cost of accuracy. A file with a `[study]` table names a scene, what is varied of it, and the measure of its
//! error. Every setting is run at every resolution; the results are a table, figures of error against cost with the Pareto front,
//! orders of convergence, figures at zero spacing, and the cheapest setting for a given error. `--accuracy` later takes the
//! setting of a run from there. Where the scene has a `[threshold]`, each point is a search, and the results are its table and Q*_D
//! over the target's radius.

pub mod analysis;
pub mod check;
mod combine;
pub mod keys;
pub mod limit;
pub mod measure;
pub mod order;
pub mod pareto;
pub mod points;
pub mod record;
mod report;
pub mod settings;
pub mod stored;
pub mod sweep;
pub mod thresholds;
mod words;

pub use points::{Sources, Study};
pub use sweep::{Part, run};
