//! Where a run writes. A run that stands there is renamed, never overwritten.

use std::path::{Path, PathBuf};

use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::output::agree;
use crate::output::checkpoint::{NEWEST, PREVIOUS};

/// `runs/<name of the scene file>`.
pub fn default_directory(scene: &Path) -> PathBuf {
    Path::new("runs").join(scene.file_stem().unwrap_or_default())
}

/// Makes the directory; what stands there under that name is renamed to `.1`, `.2`, ... unless the run is resumed. Collective.
pub fn prepare(path: &Path, resume: bool, comm: &Comm) -> Result<()> {
    agree(comm, if comm.is_root() { prepare_alone(path, resume) } else { Ok(()) })
}

/// Fails where there is nothing to go on from: a checkpoint, or one in a folder of the directory, as a search has one for
/// each impact, or in a folder of that, as campaigns have for each search. Collective.
pub fn require_checkpoint(path: &Path, comm: &Comm) -> Result<()> {
    let look = || {
        if holds_checkpoint(path, 2) {
            return Ok(());
        }
        Err(Error::new("there is no checkpoint to go on from").at(path.display().to_string()))
    };
    agree(comm, if comm.is_root() { look() } else { Ok(()) })
}

/// Whether a checkpoint lies in the folder, or in one of those so many levels below.
fn holds_checkpoint(folder: &Path, levels: usize) -> bool {
    let entries = || std::fs::read_dir(folder).into_iter().flatten().flatten();
    [NEWEST, PREVIOUS].iter().any(|name| folder.join(name).exists())
        || levels > 0 && entries().any(|entry| entry.path().is_dir() && holds_checkpoint(&entry.path(), levels - 1))
}

fn prepare_alone(path: &Path, resume: bool) -> Result<()> {
    let place = |e: std::io::Error| Error::new(format!("cannot write here: {e}")).at(path.display().to_string());
    let occupied = std::fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_some());
    if occupied && !resume {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let free = (1..).map(|n| path.with_file_name(format!("{name}.{n}"))).find(|p| !p.exists());
        std::fs::rename(path, free.unwrap_or_default()).map_err(place)?;
    }
    std::fs::create_dir_all(path).map_err(place)?;
    let probe = path.join(".probe.tmp");
    std::fs::write(&probe, b"").and_then(|()| std::fs::remove_file(&probe)).map_err(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_renamed_and_never_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("impact");
        for round in 0..3 {
            prepare_alone(&path, false).unwrap();
            std::fs::write(path.join("summary.json"), round.to_string()).unwrap();
        }
        let read = |name: &str| std::fs::read_to_string(folder.path().join(name).join("summary.json")).unwrap();
        assert_eq!((read("impact.1"), read("impact.2"), read("impact")), ("0".into(), "1".into(), "2".into()));
        prepare_alone(&path, true).unwrap();
        assert_eq!(read("impact"), "2");
    }
}
