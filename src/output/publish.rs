//! Files appear whole or not at all: they are written under a temporary name, brought to disk, and renamed.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use super::collective::CollectiveFile;
use super::moment::{self, Moment};
use super::on_root;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};

/// The name under which a file is written before it is whole.
pub fn temporary(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".tmp");
    PathBuf::from(name)
}

/// Lets `fill` write the file that [`publish`] is to name `path`; where it fails, nothing of that file stays. Collective.
pub fn prepare<T>(path: &Path, comm: &Comm, fill: impl FnOnce(&CollectiveFile) -> Result<T>) -> Result<T> {
    let write = |file: CollectiveFile| {
        let filled = fill(&file);
        let closed = file.close();
        filled.and_then(|value| closed.map(|()| value))
    };
    CollectiveFile::create(&temporary(path), comm).and_then(write).map_err(|error| {
        if comm.is_root() {
            // On a full disk this frees space; where not even this works, the error to be reported is the first one.
            let _ = fs::remove_file(temporary(path));
        }
        error.allowed("room on the disk, and no lower limit on the size of a file")
    })
}

/// Gives the file written as [`temporary`] its name, once it is on disk. Rank 0 acts; all ranks return the same.
pub fn publish(path: &Path, comm: &Comm) -> Result<()> {
    moment::reach(Moment::Written);
    on_root(comm, || rename(path))
}

/// Replaces a small file by `text`; for one rank.
pub fn replace_text(path: &Path, text: &str) -> Result<()> {
    replace(path, text.as_bytes())
}

/// Replaces a small file by `bytes`; for one rank.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<()> {
    let written = fs::write(temporary(path), bytes).map_err(|e| cannot("write", path, e)).and_then(|()| rename(path));
    written.inspect_err(|_| {
        // On a full disk this frees space; the first error is the one to be reported.
        let _ = fs::remove_file(temporary(path));
    })
}

fn rename(path: &Path) -> Result<()> {
    let from = temporary(path);
    File::open(&from).and_then(|f| f.sync_all()).map_err(|e| cannot("bring to disk", &from, e))?;
    fs::rename(&from, path).map_err(|e| cannot("rename", &from, e))?;
    sync_directory_of(path)
}

/// A rename is permanent only once its directory is on disk.
pub fn sync_directory_of(path: &Path) -> Result<()> {
    let directory = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    File::open(directory).and_then(|d| d.sync_all()).map_err(|e| cannot("bring to disk", directory, e))
}

/// An error of the file system, with the action that failed.
pub fn cannot(verb: &str, path: &Path, error: std::io::Error) -> Error {
    Error::new(format!("cannot {verb}: {error}")).at(path.display().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_and_leaves_no_temporary_file() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("a.json");
        replace_text(&path, "one").unwrap();
        replace_text(&path, "two").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert!(!temporary(&path).exists());
        let error = replace_text(&directory.path().join("missing/a.json"), "x").unwrap_err();
        assert!(error.what.starts_with("cannot write") && error.place.ends_with("a.json"));
        // A folder in the way.
        fs::create_dir_all(directory.path().join("b.json/c")).unwrap();
        let path = directory.path().join("b.json");
        assert!(replace_text(&path, "x").is_err() && !temporary(&path).exists());
    }
}
