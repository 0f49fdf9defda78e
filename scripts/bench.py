"""The table of scripts/bench from what it left in a directory: ceiling.txt and runs of one impact."""

import json
import os
import sys
from pathlib import Path


def ceiling_of(text):
    """Millions of interactions per second of the stripped loop."""
    row = next(line for line in text.splitlines() if line.startswith("| ceiling "))
    return float(row.split("|")[2])


def gravity_of(text):
    """Accuracy, median error and microseconds per body of the cheapest evaluation with a median error of 1e-3 or less."""
    rows = [line.split("|")[1:-1] for line in text.splitlines() if line.startswith("|") and "us per body" not in line and "---" not in line]
    cases = [(float(row[0]), float(row[2]), float(row[6])) for row in rows]
    return min((case for case in cases if case[1] <= 1e-3), key=lambda case: case[2])


def processor():
    """Model and number of usable cores."""
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    model = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")
    return f"{model}, {len(os.sched_getaffinity(0))} cores"


def speedup(single, double):
    """Of two ranks or threads: by core-seconds, as if nobody had waited, and by wall time."""
    by_core = 2 * single["core_seconds"] / double["core_seconds"]
    return f"{by_core:.2f} by core-seconds, {single['wall_seconds'] / double['wall_seconds']:.2f} by wall time"


def step_seconds(run, phases=None):
    """Core-seconds of a particle's step: of these phases, or of all but what comes at the end of a run."""
    end = ("outcome", "output")
    share = sum(s for name, s in run["phases"].items() if (name in phases if phases else name not in end))
    return share * run["core_seconds"] / (run["steps"] * run["particles"])


def interactions(run):
    """Of a particle in a step."""
    return run["pair_interactions"] / (run["steps"] * run["particles"])


def effects(directory):
    """What each effect costs: runs with it and without."""
    runs = {path.name[7:]: json.loads((path / "summary.json").read_text()) for path in directory.glob("effect_*")}
    base = runs.pop("none")
    pairs = next(name for name in base["phases"] if name.startswith("pairs"))
    added = ("artificial_stress", "friction", "porosity", "elastic_pores", "smoothing_length", "gravity", "gravity_every_step")
    lines = ["| effect | pair phase with it / without | whole step with it / without | interactions per update with it / without |", "|---|---:|---:|---:|"]
    for name in ("viscosity", "corrected_gradient", "angular_momentum", "record", "fracture", "strength", *added):
        other, reference = runs[name], runs["fracture"] if name == "strength" else base
        ratios = [step_seconds(other, part) / step_seconds(reference, part) for part in ((pairs,), None)]
        # An effect that changes the flow changes the number of neighbours, too.
        ratios.append(interactions(other) / interactions(reference))
        ratios = ratios if name in added else [1 / ratio for ratio in ratios]
        lines.append(f"| {name} | {' | '.join(f'{ratio:.2f}' for ratio in ratios)} |")
    return "\n".join(lines)


def main(directory, options):
    ceiling_text = (directory / "ceiling.txt").read_text()
    runs = {name: json.loads((directory / name / "summary.json").read_text()) for name in ("single", "ranks", "threads", "small", "large")}
    if len({runs[name]["state_hash"] for name in ("single", "ranks", "threads")}) != 1:
        sys.exit("error: the three runs ended in different states")

    ceiling = ceiling_of(ceiling_text)
    run = runs["single"]
    whole = 1e-6 * run["pair_interactions"] / run["core_seconds"]
    pair_share = next(share for name, share in run["phases"].items() if name.startswith("pairs"))
    pairs = whole / pair_share
    particles, steps = run["particles"], run["steps"]
    # The pair pass reads what packing has laid out: both belong to it.
    pack = run["phases"].get("pack", 0.0)
    small, large = runs["small"], runs["large"]
    accuracy, error, gravity = gravity_of((directory / "gravity.txt").read_text())
    rows = [
        ("ceiling, 1e6 interactions per core-second", f"{ceiling:.1f}"),
        ("pair phase with rates and corrector, 1e6 interactions per core-second", f"{pairs:.1f}"),
        ("share of the ceiling", f"{pairs / ceiling:.3f}"),
        ("the same with packing", f"{whole / (pair_share + pack):.1f}"),
        ("share of the ceiling", f"{whole / (pair_share + pack) / ceiling:.3f}"),
        ("whole run, 1e6 interactions per core-second", f"{whole:.1f}"),
        ("share of the ceiling", f"{whole / ceiling:.3f}"),
        ("updates per core-second", f"{run['updates_per_core_second']:.3g}"),
        ("interactions per update", f"{interactions(run):.1f}"),
        (f"bytes per particle, {particles} particles", f"{run['bytes_per_particle']:.0f}"),
        ("of these, lists", f"{run['list_bytes_per_particle']:.0f}"),
        (f"bytes per particle, {large['particles']} particles", f"{large['bytes_per_particle']:.0f}"),
        ("of these, lists", f"{large['list_bytes_per_particle']:.0f}"),
        ("microseconds of a particle's step, 1e4 particles", f"{1e6 * step_seconds(small):.3f}"),
        ("microseconds of a particle's step, 1e6 particles", f"{1e6 * step_seconds(large):.3f}"),
        ("their ratio", f"{step_seconds(large) / step_seconds(small):.2f}"),
        (f"microseconds of a body in an evaluation of self-gravity, 1e5 bodies, median error {error:.1e} (accuracy {accuracy:g})", f"{gravity:.2f}"),
        ("the same in interactions of the ceiling (asked for: at most 650)", f"{gravity * ceiling:.0f}"),
        ("life of a list, steps", f"{steps / run['list_builds']:.1f}"),
        ("two ranks against one", speedup(run, runs["ranks"])),
        ("two threads against one", speedup(run, runs["threads"])),
        ("wait of two ranks, exposed", f"{runs['ranks']['mpi_wait_seconds'] / 2 / runs['ranks']['wall_seconds']:.3f} of wall time"),
    ]
    print("# Speed\n")
    print(f"{processor()}. Impact with strength, damage and corrected gradient: {particles} particles, {steps} steps,")
    print(f"on one rank and one thread unless stated. By `scripts/bench{' ' + options if options else ''}`.\n")
    width = max(len(name) for name, _ in rows)
    print(f"| {'':{width}} | |\n|:{'-' * width}-|---:|")
    for name, value in rows:
        print(f"| {name:{width}} | {value} |")
    phases = [f"{name} {100 * share:.1f}" for name, share in run["phases"].items() if share >= 0.0005]
    print(f"\nPhases in per cent: {', '.join(phases)}.\n\n## What each effect costs\n")
    print(effects(directory))
    print("\nThe impact has viscosity, corrected gradient and forces without torque (which go with it), records, fracture and strength; the last rows, from artificial stress on, add what it does not have.\n")
    print("Pores change the flow, not only what a particle costs: the goal is 1.3 on the whole step.")
    print("\n## Pair loops beside the ceiling\n")
    print(ceiling_text.strip())


main(Path(sys.argv[1]), sys.argv[2])
