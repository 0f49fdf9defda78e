//! trace.json: what each rank does when, as Chrome (`chrome://tracing`) and Perfetto show it. Format: Trace Event Format, "complete events".

use std::fmt::Write;

use crate::error::Result;
use crate::output::on_root;
use crate::output::publish::replace_text;
use crate::simulation::run::Run;
use crate::step::phases::{NAMES, Span};

/// The name of the file.
const NAME: &str = "trace.json";
/// Words of a span in a message.
const WORDS: usize = 3;

impl<const D: usize> Run<'_, D> {
    /// Writes the trace, where it was asked for. Collective.
    pub(in crate::simulation) fn write_trace(&self) -> Result<()> {
        let Some(trace) = &self.stepper.phases.trace else { return Ok(()) };
        let words = |span: &Span| [span.phase as u64, span.begin.to_bits(), span.length.to_bits()];
        let mine: Vec<u64> = trace.spans.iter().flat_map(words).collect();
        let received = self.comm.sparse_exchange(if mine.is_empty() { Vec::new() } else { vec![(0, mine)] });
        if trace.is_full() {
            tracing::warn!("{NAME} has the first {} phases of each rank only", trace.spans.len());
        }
        on_root(self.comm, || replace_text(&self.options.directory.join(NAME), &text(&received)))
    }
}

/// The events of all ranks; times in us.
fn text(spans: &[(usize, Vec<u64>)]) -> String {
    let mut text = String::from("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[");
    for (rank, words) in spans {
        let _ = write!(
            text,
            "{}\n{{\"name\":\"thread_name\",\"ph\":\"M\",\"pid\":0,\"tid\":{rank},\"args\":{{\"name\":\"rank {rank}\"}}}}",
            if text.ends_with('[') { "" } else { "," }
        );
        for span in words.chunks_exact(WORDS) {
            let [begin, length] = [1, 2].map(|k| 1e6 * f64::from_bits(span[k]));
            let name = NAMES[span[0] as usize];
            let _ = write!(
                text,
                ",\n{{\"name\":\"{name}\",\"ph\":\"X\",\"ts\":{begin:.3},\"dur\":{length:.3},\"pid\":0,\"tid\":{rank}}}"
            );
        }
    }
    text + "\n]}\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_are_those_of_the_format() {
        let span = |phase: u64, begin: f64, length: f64| [phase, begin.to_bits(), length.to_bits()];
        let text = text(&[(0, span(6, 0.5, 0.25).to_vec()), (1, [span(7, 0.0, 1e-6), span(6, 1.0, 2.0)].concat())]);
        let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let events = json["traceEvents"].as_array().expect("events");
        assert_eq!(events.len(), 5);
        assert_eq!(
            (&events[1]["name"], &events[1]["ts"], &events[1]["dur"]),
            (&NAMES[6].into(), &5e5.into(), &2.5e5.into())
        );
        assert_eq!((&events[4]["tid"], &events[2]["args"]["name"]), (&1.into(), &"rank 1".into()));
    }
}
