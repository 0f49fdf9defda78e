"""The page tests/validation/README.md: one block per section, each section one file beside this one.

A section is a module with
    TITLE                  heading of its block
    runs()                 list of `Run`
    write(found)           text of its block from the summaries of these runs, by name; draws its figures
                           and gives the list of what is outside its tolerance: (text, failures)
"""

import sys

import compaction
import contacts
import convergence
import crush
import granular
import gravity
import hugoniots
import page
import price
import rest
from runs import perform, show

SECTIONS = {"convergence": convergence, "hugoniots": hugoniots, "compaction": compaction, "crush": crush, "gravity": gravity, "rest": rest, "contacts": contacts, "granular": granular, "price": price}


def main(words):
    listed = "--list" in words
    words = [word for word in words if word != "--list"]
    wanted = {}
    for name, section in SECTIONS.items():
        runs = section.runs()
        wanted[name] = [run for run in runs if not words or name in words or run.name.startswith(tuple(words))]
    if not any(wanted.values()):
        sys.exit(f"error: nothing is called {', '.join(words)} (allowed: {', '.join(SECTIONS)}, or the beginning of a run's name)")
    if listed:
        return show([run for runs in wanted.values() for run in runs])
    failures = []
    for name, section in SECTIONS.items():
        found = perform(wanted[name])
        # A section is written when all of it is there, whoever asked for it.
        if wanted[name] and all((run.folder / "summary.json").exists() for run in section.runs()):
            text, failed = section.write({run.name: run.summary() for run in section.runs()})
            page.replace(name, section.TITLE, text, list(SECTIONS))
            failures += failed
        elif wanted[name]:
            for run, summary in found.items():
                print(run, {key: float(f"{value:.3g}") for key, value in summary["errors"].items()})
    for failure in failures:
        print(f"outside its tolerance: {failure}", file=sys.stderr)
    sys.exit(1 if failures else 0)


main(sys.argv[1:])
