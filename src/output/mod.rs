//! The files of a run: snapshots, checkpoints, history, summary, figures. Columns come from the registry; nothing here
//! knows an effect.

pub mod agree;
pub mod checkpoint;
pub mod collective;
pub mod figures;
pub mod history;
pub mod moment;
pub mod publish;
pub mod snapshot;
pub mod state_hash;
pub mod summary;
pub mod text;

pub use agree::{agree, on_root};
pub use checkpoint::{Checkpoint, CheckpointMeta};
pub use history::{Cell, History};
pub use snapshot::{Snapshot, Storage};
pub use state_hash::state_hash;
pub use summary::Summary;
