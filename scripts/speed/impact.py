"""Whole runs of inputs/impact.toml: what they reach, and what they cost a particle."""

import dataclasses
import shutil
import sys

from common.runs import ROOT, Run

FOLDER = ROOT / "runs" / "bench"
COMMON = ["target.particles=100000", "run.steps=200", "output.snapshots=0", "output.picture=false"]

RUNS = {
    # Ranks, threads, and what is set.
    "single": (1, 1, []),
    "ranks": (2, 1, []),
    "threads": (1, 2, []),
    # For the cost of a particle's step and the memory of a particle.
    "small": (1, 1, ["target.particles=10000", "run.steps=400"]),
    # Steps enough that the first lists and the first touch of all memory, once in a run, weigh little.
    "large": (1, 1, ["target.particles=1000000", "run.steps=72"]),
}


@dataclasses.dataclass
class Timed(Run):
    """A run that is made each time."""

    @property
    def folder(self):
        return FOLDER / self.name


def timed(name, settings, ranks=1, threads=1):
    """Summary of an impact."""
    print(f"bench: impact on {ranks} rank(s) x {threads} thread(s): {name}", file=sys.stderr)
    run = Timed(name, "impact.toml", COMMON + settings, ranks=ranks, threads=threads)
    shutil.rmtree(run.folder, ignore_errors=True)
    run.make()
    return run.result()


def measure(settings):
    """Summaries by name; `settings` go over every impact."""
    runs = {name: timed(name, own + settings, ranks, threads) for name, (ranks, threads, own) in RUNS.items()}
    if len({runs[name]["state_hash"] for name in ("single", "ranks", "threads")}) != 1:
        sys.exit("error: the three runs ended in different states")
    return runs


def step_seconds(run, phases=None):
    """Core-seconds of a particle's step: of these phases, or of all but what comes at the end of a run."""
    end = ("outcome", "output")
    share = sum(s for name, s in run["phases"].items() if (name in phases if phases else name not in end))
    return share * run["core_seconds"] / (run["steps"] * run["particles"])


def interactions(run):
    """Of a particle in a step."""
    return run["pair_interactions"] / (run["steps"] * run["particles"])


def speedup(single, double):
    """Of two ranks or threads: by core-seconds, as if nobody had waited, and by wall time."""
    by_core = 2 * single["core_seconds"] / double["core_seconds"]
    return f"{by_core:.2f} by core-seconds, {single['wall_seconds'] / double['wall_seconds']:.2f} by wall time"


def rates(run, ceiling):
    """Interactions per core-second, and their share of the ceiling where that is known."""
    whole = 1e-6 * run["pair_interactions"] / run["core_seconds"]
    pair_share = next(share for name, share in run["phases"].items() if name.startswith("pairs"))
    # The pair pass reads what packing has laid out: both belong to it.
    packed = pair_share + run["phases"].get("pack", 0.0)
    per_core = "1e6 interactions per core-second"
    for what, rate in (
        (f"pair phase with rates and corrector, {per_core}", whole / pair_share),
        ("the same with packing", whole / packed),
        (f"whole run, {per_core}", whole),
    ):
        yield what, f"{rate:.1f}"
        if ceiling:
            yield "share of the ceiling", f"{rate / ceiling:.3f}"


def table(runs, ceiling=None, gravity=None):
    """Markdown; with what is compared to the stripped loop where that was measured."""
    run, small, large = runs["single"], runs["small"], runs["large"]
    rows = [("ceiling, 1e6 interactions per core-second", f"{ceiling:.1f}")] if ceiling else []
    rows += [
        *rates(run, ceiling),
        ("updates per core-second", f"{run['updates_per_core_second']:.3g}"),
        ("interactions per update", f"{interactions(run):.1f}"),
        (f"bytes per particle, {run['particles']} particles", f"{run['bytes_per_particle']:.0f}"),
        ("of these, lists", f"{run['list_bytes_per_particle']:.0f}"),
        (f"bytes per particle, {large['particles']} particles", f"{large['bytes_per_particle']:.0f}"),
        ("of these, lists", f"{large['list_bytes_per_particle']:.0f}"),
        ("microseconds of a particle's step, 1e4 particles", f"{1e6 * step_seconds(small):.3f}"),
        ("microseconds of a particle's step, 1e6 particles", f"{1e6 * step_seconds(large):.3f}"),
        ("their ratio", f"{step_seconds(large) / step_seconds(small):.2f}"),
    ]
    if ceiling and gravity:
        accuracy, error, cost = gravity
        what = f"microseconds of a body in an evaluation of self-gravity, 1e5 bodies, median error {error:.1e} (accuracy {accuracy:g})"
        rows += [(what, f"{cost:.2f}"), ("the same in interactions of the ceiling (required: at most 650)", f"{cost * ceiling:.0f}")]
    rows += [
        ("life of a list, steps", f"{run['steps'] / run['list_builds']:.1f}"),
        ("two ranks against one", speedup(run, runs["ranks"])),
        ("two threads against one", speedup(run, runs["threads"])),
        ("wait of two ranks, exposed", f"{runs['ranks']['mpi_wait_seconds'] / 2 / runs['ranks']['wall_seconds']:.3f} of wall time"),
    ]
    width = max(len(name) for name, _ in rows)
    return "\n".join([f"| {'':{width}} | |", f"|:{'-' * width}-|---:|", *(f"| {name:{width}} | {value} |" for name, value in rows)])
