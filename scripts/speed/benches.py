"""cargo's benches, and what is read from their tables."""

import os
import pathlib
import subprocess
import sys

from common.runs import ROOT


def run(name):
    """What it prints."""
    print(f"bench: {name}", file=sys.stderr)
    command = ["cargo", "bench", "--quiet", "--locked", "--bench", name]
    return subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout


def ceiling(text):
    """Millions of interactions per second of the stripped loop."""
    row = next(line for line in text.splitlines() if line.startswith("| ceiling "))
    return float(row.split("|")[2])


def gravity(text):
    """(accuracy, median error, microseconds per body) of the cheapest evaluation with a median error of 1e-3 or less."""
    rows = [line.split("|")[1:-1] for line in text.splitlines() if line.startswith("|") and "us per body" not in line and "---" not in line]
    cases = [(float(row[0]), float(row[2]), float(row[6])) for row in rows]
    return min((case for case in cases if case[1] <= 1e-3), key=lambda case: case[2])


def processor():
    """Model and number of usable cores."""
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    model = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")
    return f"{model}, {len(os.sched_getaffinity(0))} cores"
