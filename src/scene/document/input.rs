//! Text from outside. Only what ends is read: files and pipes, up to a size that no scene has; a device, a folder, or a pipe
//! into which nobody writes is refused.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::os::fd::AsFd;
use std::os::unix::fs::{FileTypeExt, OpenOptionsExt};
use std::path::Path;
use std::time::{Duration, Instant};

/// The largest text, bytes.
const LARGEST: usize = 16 << 20;
/// How long a pipe may stand open without anybody at its other end.
const PATIENCE: Duration = Duration::from_secs(3);
const PAUSE: Duration = Duration::from_millis(5);

/// The largest table of numbers, bytes.
const LARGEST_TABLE: usize = 512 << 20;

/// The text of a file or a pipe; what is wrong where there is none.
pub fn read(path: &Path) -> Result<String, String> {
    read_up_to(path, LARGEST)
}

/// Like [`read`], of a table of numbers.
pub fn read_large(path: &Path) -> Result<String, String> {
    read_up_to(path, LARGEST_TABLE)
}

fn read_up_to(path: &Path, most: usize) -> Result<String, String> {
    let file = open(path).map_err(|e| e.to_string())?;
    let kind = file.metadata().map_err(|e| e.to_string())?.file_type();
    if kind.is_dir() {
        return Err("it is a folder".into());
    }
    if !(kind.is_file() || kind.is_fifo() || kind.is_socket()) {
        return Err("it is neither a regular file nor a pipe".into());
    }
    let bytes = contents(file, most)?;
    String::from_utf8(bytes)
        .map_err(|e| format!("it is no text in UTF-8 from byte {} on", e.utf8_error().valid_up_to()))
}

/// Whether a path stands for something that another program hands on: `/dev/stdin`, or `/dev/fd/63` of `<(...)`.
pub fn is_passed_on(path: &Path) -> bool {
    path.starts_with("/dev") || path.starts_with("/proc")
}

/// Standard input may be a socket, which cannot be opened by name. A named pipe is opened whether or not somebody writes.
fn open(path: &Path) -> std::io::Result<File> {
    if path == Path::new("/dev/stdin") {
        return std::io::stdin().as_fd().try_clone_to_owned().map(File::from);
    }
    File::options().read(true).custom_flags(libc::O_NONBLOCK).open(path)
}

fn contents(mut file: File, most: usize) -> Result<Vec<u8>, String> {
    let started = Instant::now();
    let (mut bytes, mut part) = (Vec::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut part) {
            // A writer may be on its way.
            Ok(0) if bytes.is_empty() && is_pipe(&file) && started.elapsed() < PATIENCE => std::thread::sleep(PAUSE),
            Ok(0) if bytes.is_empty() && is_pipe(&file) => return Err("nothing comes out of the pipe".into()),
            Ok(0) => return Ok(bytes),
            Ok(count) => bytes.extend_from_slice(&part[..count]),
            Err(e) if e.kind() == ErrorKind::WouldBlock => std::thread::sleep(PAUSE),
            Err(e) if e.kind() == ErrorKind::Interrupted => {}
            Err(e) => return Err(e.to_string()),
        }
        if bytes.len() > most {
            return Err(format!("it is longer than {} MiB", most >> 20));
        }
    }
}

fn is_pipe(file: &File) -> bool {
    file.metadata().is_ok_and(|about| about.file_type().is_fifo())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[test]
    fn only_what_ends_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("scene"), "title = \"µ\"").unwrap();
        assert_eq!(read(&path("scene")).unwrap(), "title = \"µ\"");
        std::fs::write(path("empty"), "").unwrap();
        assert_eq!(read(&path("empty")).unwrap(), "");
        std::fs::write(path("bytes"), [b'a', 0xff]).unwrap();
        assert!(read(&path("bytes")).unwrap_err().contains("UTF-8 from byte 1"));
        // Without blocks on the disk.
        File::create(path("long")).unwrap().set_len(1 << 40).unwrap();
        assert!(read(&path("long")).unwrap_err().contains("longer than 16 MiB"));
        assert!(read(folder.path()).unwrap_err().contains("folder"));
        for device in ["/dev/zero", "/dev/null"] {
            assert!(read(Path::new(device)).unwrap_err().contains("neither a regular file nor a pipe"));
        }
        assert!(read(&path("nowhere")).unwrap_err().contains("No such file"));
    }

    /// A pipe is read to the end of what is written, however slowly; one without a writer is given up.
    #[test]
    fn pipes_are_read_to_their_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("pipe");
        let name = std::ffi::CString::new(path.to_str().unwrap()).unwrap();
        // SAFETY: a path that ends with a NUL.
        assert_eq!(unsafe { libc::mkfifo(name.as_ptr(), 0o600) }, 0);
        let to = path.clone();
        let writer = std::thread::spawn(move || {
            std::thread::sleep(20 * PAUSE);
            let mut file = File::options().write(true).open(to).unwrap();
            for part in ["title", " = ", "\"slow\""] {
                file.write_all(part.as_bytes()).unwrap();
                std::thread::sleep(10 * PAUSE);
            }
        });
        assert_eq!(read(&path).unwrap(), "title = \"slow\"");
        writer.join().unwrap();
        assert!(read(&path).unwrap_err().contains("nothing comes out of the pipe"));
    }
}
