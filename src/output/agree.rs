//! One result on all ranks: an operation that fails on one of them fails on all, so that none waits in a collective for a rank that
//! has left it.

use crate::domain::comm::Comm;
use crate::error::{Error, Result};

/// Bytes of an error's text that are sent; longer texts are cut.
const TEXT: usize = 1024;
/// Separates the parts of an error in a message.
const SEPARATOR: char = '\u{1f}';
/// First part where [`Error::bad_input`] is set.
const BAD_INPUT: &str = "bad input";

/// The result that all ranks share: their own value where every rank succeeded, else the error of the lowest rank that
/// failed. Collective.
pub fn agree<T>(comm: &Comm, result: Result<T>) -> Result<T> {
    let mut failed = [if result.is_err() { comm.rank() as f64 } else { comm.size() as f64 }];
    comm.all_min(&mut failed);
    let source = failed[0] as usize;
    if source == comm.size() {
        return result;
    }
    let mut text = [0u8; TEXT];
    if let Err(error) = &result {
        encode(error, &mut text);
    }
    let all = comm.all_gather(&text);
    Err(decode(&all[source * TEXT..(source + 1) * TEXT]))
}

/// What rank 0 alone does; all ranks share whether it succeeded. Collective.
pub fn on_root(comm: &Comm, work: impl FnOnce() -> Result<()>) -> Result<()> {
    let mine = if comm.is_root() { work() } else { Ok(()) };
    agree(comm, mine)
}

fn encode(error: &Error, text: &mut [u8; TEXT]) {
    let kind = if error.bad_input { BAD_INPUT } else { "" };
    let parts = [kind, &error.place, &error.allowed, &error.what];
    let joined = parts.map(|part| part.replace(['\0', SEPARATOR], " ")).join(&SEPARATOR.to_string());
    let length = (0..=TEXT.min(joined.len())).rfind(|&end| joined.is_char_boundary(end)).unwrap_or(0);
    text[..length].copy_from_slice(&joined.as_bytes()[..length]);
}

fn decode(text: &[u8]) -> Error {
    let end = text.iter().position(|&byte| byte == 0).unwrap_or(text.len());
    let text = String::from_utf8_lossy(&text[..end]);
    let mut parts = text.split(SEPARATOR);
    let mut next = || parts.next().unwrap_or_default().to_string();
    let (kind, place, allowed, what) = (next(), next(), next(), next());
    Error { what, place, allowed, bad_input: kind == BAD_INPUT }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_survive_the_way_and_long_ones_are_cut() {
        let error = Error::new("no room for 3 m³").at("runs/a").allowed("a disk").bad_input();
        let mut text = [0; TEXT];
        encode(&error, &mut text);
        assert_eq!(decode(&text), error);
        let long = Error::new("³".repeat(TEXT)).at("here");
        let mut text = [0; TEXT];
        encode(&long, &mut text);
        let back = decode(&text);
        assert!(back.place == "here" && back.what.chars().all(|c| c == '³') && back.what.len() >= TEXT - 8);
    }
}
