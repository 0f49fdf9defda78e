#!/usr/bin/env python3
"""Tables and curves of what cluster/scaling.sh left in a folder.

    cluster/scaling.py OUT         prints the tables and writes OUT/curves.csv, and OUT/scaling.png where matplotlib is there

Speed counts the seconds that cores worked, apart from waits inside MPI: the waits stand beside it. So it does not depend on
what else the machine did, and says what a core achieves; wall time says what came of it.
"""
import csv
import json
import os
import pathlib
import re
import sys

UNITS = {"bytes": 1, "kB": 1e3, "MB": 1e6, "GB": 1e9, "TB": 1e12}


def number(pattern, text):
    """The number, with its unit of bytes if there is one, that a line of --check gives."""
    found = re.search(pattern, text, re.MULTILINE)
    if not found:
        sys.exit(f"error: --check says nothing of {pattern}")
    return float(found[1]) * (UNITS[found[2]] if found.re.groups > 1 else 1)


class Run:
    """One run, measured and predicted; everything for a step."""

    def __init__(self, folder):
        self.name, self.count = folder.name.rsplit("_", 1)
        found = json.loads((folder / "summary.json").read_text())
        self.ranks, self.threads, self.particles = found["ranks"], found["threads_per_rank"], found["particles"]
        self.hash = found["state_hash"]
        # What comes once at the end of a run is no part of a step.
        steps = found["steps"] / (1 - found["phases"]["outcome"] - found["phases"]["output"])
        self.wall = found["wall_seconds"] / steps
        self.core = found["core_seconds"] / steps
        self.wait = found["mpi_wait_seconds"] / (found["wall_seconds"] * self.ranks)
        self.speed = found["particles"] / self.core * min(self.ranks * self.threads, cores())
        self.memory = found["bytes_per_particle"] * found["particles"] / self.ranks
        self.ghosts = found["ghost_fraction"] * found["particles"] / self.ranks
        self.life = found["steps"] / found["list_builds"]
        self.shared = max(1.0, self.ranks * self.threads / cores())
        text = folder.with_suffix(".check").read_text()
        wall = number(r"^  a step +(\S+) s", text)
        efficiency = number(r"^  parallel efficiency +(\S+)", text)
        idle = sum(number(rf"^  {part} +(\S+) s", text) for part in ("exposed messages", "reductions", "uneven loads"))
        self.predicted = {
            "wall": wall,
            "core": self.ranks * (wall - idle),
            "speedup": efficiency * self.ranks,
            "memory": number(r"^  memory +(\S+) (\S+) per rank", text),
            "ghosts": number(r"^  particles per rank +\d+, and (\d+) ghosts", text),
            "life": number(r"^  life of a list +(\S+) steps", text),
        }


def cores():
    return int(os.environ.get("CORES") or len(os.sched_getaffinity(0)))


def mark(run):
    """More ranks and threads than cores."""
    return " \\*" if run.shared > 1 else ""


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---:|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def speeds(runs, first):
    """Rows of measured speeds, against the first run."""
    for run in runs:
        # In a weak sweep all is relative to a particle.
        size = run.particles / first.particles
        yield [
            f"{run.ranks} x {run.threads}{mark(run)}",
            str(run.particles),
            f"{1e3 * run.wall:.1f}",
            f"{1e3 * run.core:.1f}",
            f"{100 * run.wait:.0f} %",
            f"{1e-6 * run.speed:.2f}",
            f"{run.speed / first.speed:.2f}",
            f"{size * first.wall / run.wall:.2f}",
        ]


SPEEDS = ["ranks x threads", "particles", "wall ms", "core ms", "waits", "1e6 updates/s", "speed-up by core", "by wall"]


def off(measured, predicted):
    return f"{100 * (predicted / measured - 1):+.0f} %" if measured else ("0 %" if predicted == 0 else "-")


def predictions(runs):
    for run in runs:
        said = run.predicted
        wall = said["wall"] * run.shared
        yield [
            f"{run.name} {run.ranks}{mark(run)}",
            f"{1e3 * wall:.1f} / {1e3 * run.wall:.1f}",
            off(run.wall, wall),
            f"{1e3 * said['core']:.1f} / {1e3 * run.core:.1f}",
            off(run.core, said["core"]),
            f"{1e-6 * said['memory']:.0f} / {1e-6 * run.memory:.0f}",
            off(run.memory, said["memory"]),
            f"{said['ghosts']:.0f} / {run.ghosts:.0f}",
            off(run.ghosts, said["ghosts"]),
            f"{said['life']:.1f} / {run.life:.1f}",
        ]


PREDICTIONS = ["run", "wall ms", "off", "core ms", "off", "MB per rank", "off", "ghosts per rank", "off", "life of a list"]


def curves(strong, weak):
    """Rows of (series, mark, x, y) for the figure of speed-ups."""
    ranks = sorted({run.ranks for run in strong + weak})
    yield from (("as many as cores", "dashed", n, min(n, cores())) for n in ranks)
    yield from (("strong, as predicted", "line", run.ranks, run.predicted["speedup"] / run.shared) for run in strong)
    for name, runs in (("strong", strong), ("weak", weak)):
        first = runs[0]
        yield from ((f"{name}, by core-seconds", "points", run.ranks, run.speed / first.speed) for run in runs)
        size = [run.particles / first.particles for run in runs]
        yield from ((f"{name}, by wall time", "points", run.ranks, s * first.wall / run.wall) for run, s in zip(runs, size))


def draw(points, path):
    """The figure of speed-ups; without matplotlib there is the table of its points."""
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 6))
    styles = {"line": "-", "dashed": "k--", "points": "o"}
    for name, style in dict.fromkeys((name, style) for name, style, *_ in points):
        axes.loglog(*zip(*((x, y) for series, _, x, y in points if series == name)), styles[style], label=name)
    axes.set(title="Speed-up of an impact", xlabel="ranks of one thread", ylabel="speed-up")
    axes.legend()
    figure.savefig(path, dpi=100, bbox_inches="tight")
    plt.close(figure)


def main(out):
    runs = [Run(path.parent) for path in sorted(out.glob("*_*/summary.json"))]
    runs.sort(key=lambda run: (run.name, run.ranks, run.threads))
    kinds = {name: [run for run in runs if run.name == name] for name in dict.fromkeys(run.name for run in runs)}
    strong, weak = kinds.get("strong", []), kinds.get("weak", [])
    if not strong or not weak:
        sys.exit(f"error: {out}: strong_1 and weak_1 are not there")
    others = [run for name, runs in kinds.items() if name != "weak" for run in runs]
    if len({run.hash for run in others}) != 1:
        sys.exit("error: runs of the same scene ended in different states")
    titles = {"strong": "Strong scaling", "weak": "Weak scaling", "srun": "Layouts, by srun", "mpirun": "Layouts, by mpirun"}
    lines = []
    for name in sorted(kinds, key=list(titles).index):
        first = next((run for run in kinds[name] if run.ranks * run.threads == 1), kinds[name][0])
        lines += [f"## {titles[name]}", ""] + table(SPEEDS, speeds(kinds[name], first))
    lines += ["## Predicted / measured", ""] + table(PREDICTIONS, predictions(strong + weak))
    if any(run.shared > 1 for run in runs):
        note = "which count once in the speed; wall times are predicted for as many turns as ranks share a core"
        lines += [f"\\* more than the {cores()} cores, {note}.", ""]
    print("\n".join(lines))
    points = list(curves(strong, weak))
    with open(out / "curves.csv", "w", newline="") as file:
        csv.writer(file).writerows(points)
    draw(points, out / "scaling.png")


if len(sys.argv) != 2:
    sys.exit(__doc__)
main(pathlib.Path(sys.argv[1]))
