#!/usr/bin/env python3
"""Gathers the runs of a campaign, one row for each line of its table, into results.csv and results.md of its folder.

    cluster/gather.py runs/radii

A task without a whole summary.json is a row too, with the reason in the column `state`; then the exit code is 1.
"""
import csv
import json
import pathlib
import shlex
import sys

# Columns of results.md, where any run has them; results.csv has all.
SHOWN = [
    "threshold.q_star_d",
    "threshold.uncertainty",
    "threshold.ratio_to_reference",
    "outcome.largest_remnant_fraction",
    "particles",
    "steps",
    "core_seconds",
    "energy_drift",
]
LEFT_OUT = ("phases.", "effects.", "threshold.impacts")


def flat(tree, prefix=""):
    """Dotted keys of all that is no list."""
    for key, value in tree.items():
        if isinstance(value, dict):
            yield from flat(value, f"{prefix}{key}.")
        elif not isinstance(value, list):
            yield prefix + key, value


def why_missing(out, task):
    """What a task without a summary says of itself: the last error of its log."""
    log = out / f"{task}.log"
    if not log.exists():
        return "not started"
    lines = log.read_text(errors="replace").splitlines()
    # The program's own word first, then Slurm's.
    for found in ([line for line in lines if line.startswith("error: ")], [line for line in lines if "error: " in line]):
        if found:
            return f"missing: {found[-1].strip()}"
    return "missing: not done"


def row_of(out, task, line):
    """Name, state, options, and every figure of one task."""
    name, *options = shlex.split(line)
    row = {"task": task, "name": name, "state": "done", "options": shlex.join(options)}
    try:
        summary = json.loads((out / str(task) / "summary.json").read_text())
    except FileNotFoundError:
        return row | {"state": why_missing(out, task)}
    except (OSError, ValueError) as error:
        return row | {"state": f"unreadable: {error}"}
    return row | {key: value for key, value in flat(summary) if not key.startswith(LEFT_OUT)}


def text(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def main(out):
    rows = [row_of(out, task, line) for task, line in enumerate((out / "table.txt").read_text().splitlines(), 1)]
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with open(out / "results.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)
    shown = ["task", "name", "state"] + [key for key in SHOWN if key in columns]
    lines = ["| " + " | ".join(key.split(".")[-1] for key in shown) + " |", "|" + "---|" * len(shown)]
    lines += ["| " + " | ".join(text(row.get(key, "")).replace("|", "\\|") for key in shown) + " |" for row in rows]
    lost = [f"{row['task']} ({row['name']})" for row in rows if row["state"] != "done"]
    lines += ["", f"Without a result: {', '.join(lost)}." if lost else f"All {len(rows)} tasks are done."]
    (out / "results.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return 1 if lost else 0


if len(sys.argv) != 2:
    sys.exit(__doc__)
sys.exit(main(pathlib.Path(sys.argv[1])))
