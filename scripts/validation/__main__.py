"""usage: scripts/validate [TOPIC...] [--list] [--page] [--most SECONDS]

Makes what is missing under runs/validate/, and writes the pages of tests/validation/ that follow from it. Without a topic: all
but dust, q_star and campaigns, which take core-hours.

    TOPIC            one of those below, or the beginning of a run's name (`sod`, `craters/compaction`)
    --list           what is there, and the core-seconds that the rest will take; of a topic, each of its runs
    --page           runs nothing and writes the pages from what is there
    --most SECONDS   only runs that take at most so many core-seconds

JOBS=2 makes runs side by side, one core each; RANKS=2 gives studies so many ranks. Neither changes a result.
"""

import argparse
import sys

from common import page
from common.runs import expected, missing, perform, show
from validation import campaigns, compaction, contacts, convergence, craters, crush, dissipation, dust, fracture, granular, gravity, hugoniots, integrators, price, q_star, rest

TOPICS = {
    "convergence": convergence,
    "hugoniots": hugoniots,
    "compaction": compaction,
    "crush": crush,
    "gravity": gravity,
    "rest": rest,
    "contacts": contacts,
    "granular": granular,
    "price": price,
    "integrators": integrators,
    "dissipation": dissipation,
    "fracture": fracture,
    "craters": craters,
    "dust": dust,
    "q_star": q_star,
    "campaigns": campaigns,
}
"""A topic is a module with

    TITLE          of its block in tests/validation/README.md, or
    PAGE           the name of its own page
    runs()         what it needs: a list of common.runs.Run, Study or Tables
    write(found)   text of its block, or a list of the parts of its page, from the results of these by name; draws its figures
                   and gives the list of what is outside its tolerance: (text, failures)
    BY_NAME        true where it must be asked for, as it takes long
    FROM_SOME      true where it can be written from a part of its runs: `found` holds those that are there
"""


def options(words):
    topics = "\n".join(f"    {name:12} {place(topic)}" for name, topic in TOPICS.items())
    parser = argparse.ArgumentParser(usage=argparse.SUPPRESS, description=f"{__doc__}\n{topics}", formatter_class=argparse.RawDescriptionHelpFormatter, add_help=False)
    parser.add_argument("-h", "--help", action="help", help=argparse.SUPPRESS)
    parser.add_argument("topics", nargs="*", help=argparse.SUPPRESS)
    parser.add_argument("--list", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--page", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--most", type=float, default=float("inf"), help=argparse.SUPPRESS)
    return parser.parse_args(words)


def place(topic):
    return "tests/validation/" + (topic.PAGE if hasattr(topic, "PAGE") else f"README.md, {topic.TITLE}")


def is_by_name(topic):
    return getattr(topic, "BY_NAME", False)


def chosen(words):
    """Runs that are asked for, by topic."""
    if not words:
        return {name: topic.runs() for name, topic in TOPICS.items() if not is_by_name(topic)}
    wanted = {}
    for name, topic in TOPICS.items():
        if runs := [run for run in topic.runs() if name in words or run.name.startswith(tuple(words))]:
            wanted[name] = runs
    if not wanted:
        sys.exit(f"error: nothing is called {', '.join(words)} (allowed: {', '.join(TOPICS)}, or the beginning of a run's name)")
    return wanted


def list_topics(words):
    wanted = chosen(words) if words else {name: topic.runs() for name, topic in TOPICS.items()}
    for name, runs in wanted.items():
        count, seconds, unknown = missing(runs)
        rest = f"{count} missing: {seconds:.0f} core-s" + (f" and {unknown} of unknown cost" if unknown else "") if count else "all there"
        print(f"{name:12} {len(runs):3} runs, {rest}{', only by name' if is_by_name(TOPICS[name]) else ''}")
        if words:
            show(runs)


def write(name):
    """Writes a topic's page if its runs are there, whoever asked for them; gives what is outside its tolerance."""
    topic = TOPICS[name]
    runs = topic.runs()
    found = {run.name: run.result() for run in runs if run.is_there()}
    if len(found) < len(runs) and not (found and getattr(topic, "FROM_SOME", False)):
        print(f"{name}: {len(runs) - len(found)} of {len(runs)} runs are not there, {place(topic)} stays as it is")
        return []
    text, failures = topic.write(found)
    if hasattr(topic, "PAGE"):
        page.write(topic.PAGE, text)
    else:
        page.replace_block(name, topic.TITLE, text, list(TOPICS))
    return failures


def main():
    given = options(sys.argv[1:])
    if given.list:
        return list_topics(given.topics)
    failures = []
    for name, runs in chosen(given.topics).items():
        if not given.page:
            perform([run for run in runs if (expected(run) or 0.0) <= given.most])
        failures += write(name)
    for failure in failures:
        print(f"outside its tolerance: {failure}", file=sys.stderr)
    return 1 if failures else 0


sys.exit(main())
