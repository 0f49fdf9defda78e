"""The table of scripts/bench from what it left in a directory: ceiling.txt and three runs of one impact."""

import json
import os
import sys
from pathlib import Path


def ceiling_of(text):
    """Millions of interactions per second of the stripped loop."""
    row = next(line for line in text.splitlines() if line.startswith("| ceiling "))
    return float(row.split("|")[2])


def processor():
    """Model and number of usable cores."""
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    model = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")
    return f"{model}, {len(os.sched_getaffinity(0))} cores"


def speedup(single, double):
    """Of two ranks or threads: by core-seconds, as if nobody had waited, and by wall time."""
    by_core = 2 * single["core_seconds"] / double["core_seconds"]
    return f"{by_core:.2f} by core-seconds, {single['wall_seconds'] / double['wall_seconds']:.2f} by wall time"


def main(directory, options):
    ceiling_text = (directory / "ceiling.txt").read_text()
    runs = {name: json.loads((directory / name / "summary.json").read_text()) for name in ("single", "ranks", "threads")}
    if len({run["state_hash"] for run in runs.values()}) != 1:
        sys.exit("error: the three runs ended in different states")

    ceiling = ceiling_of(ceiling_text)
    run = runs["single"]
    whole = 1e-6 * run["pair_interactions"] / run["core_seconds"]
    pair_share = next(share for name, share in run["phases"].items() if name.startswith("pairs"))
    pairs = whole / pair_share
    particles, steps = run["particles"], run["steps"]
    rows = [
        ("ceiling, 1e6 interactions per core-second", f"{ceiling:.1f}"),
        ("pair phase with rates and corrector, 1e6 interactions per core-second", f"{pairs:.1f}"),
        ("share of the ceiling", f"{pairs / ceiling:.3f}"),
        ("whole run, 1e6 interactions per core-second", f"{whole:.1f}"),
        ("share of the ceiling", f"{whole / ceiling:.3f}"),
        ("updates per core-second", f"{run['updates_per_core_second']:.3g}"),
        ("interactions per update", f"{run['pair_interactions'] / (steps * particles):.1f}"),
        ("bytes per particle", f"{run['bytes_per_particle']:.0f}"),
        ("of these, lists", f"{run['list_bytes_per_particle']:.0f}"),
        ("life of a list, steps", f"{steps / run['list_builds']:.1f}"),
        ("two ranks against one", speedup(run, runs["ranks"])),
        ("two threads against one", speedup(run, runs["threads"])),
    ]
    print("# Speed\n")
    print(f"{processor()}. Impact with strength, damage and corrected gradient: {particles} particles, {steps} steps,")
    print(f"on one rank and one thread unless stated. By `scripts/bench{' ' + options if options else ''}`.\n")
    width = max(len(name) for name, _ in rows)
    print(f"| {'':{width}} | |\n|:{'-' * width}-|---:|")
    for name, value in rows:
        print(f"| {name:{width}} | {value} |")
    phases = [f"{name} {100 * share:.1f}" for name, share in run["phases"].items() if share >= 0.0005]
    print(f"\nPhases in per cent: {', '.join(phases)}.\n\n## Pair loops beside the ceiling\n")
    print(ceiling_text.strip())


main(Path(sys.argv[1]), sys.argv[2])
