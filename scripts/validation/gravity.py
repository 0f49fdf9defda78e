"""Self-gravity: forces against sums over all bodies, and what conserves in a collapse and in a planet at rest."""

import re

from common import page
from common.runs import Run, Tables

TITLE = "Self-gravity"

ACCURACIES = [0.03, 0.01, 0.002, 1e-4]
INTERVALS = [0.02, 0.05, 0.1]
"""Of the collapse, whose steps are a hundredth of the free-fall time long."""
RESTING = [0, 3e-3, 1e-2, 3e-2]
"""Of the planet, whose steps are a sixhundredth of it long."""
CEILING_INTERACTIONS = 650
"""What an evaluation may cost a body at a median error of 1e-3, in interactions of the stripped pair loop."""


FORCES = Tables(
    "gravity/forces",
    ["sh", "-c", "cargo bench --quiet --locked --bench gravity && cargo bench --quiet --locked --bench ceiling -- 59 3"],
    ["tests/benches/gravity.rs", "tests/benches/ceiling.rs", "src/gravity/*.rs"],
    guess=60,
)
"""And the ceiling, as processors differ from day to day."""


def collapse(accuracy, interval):
    settings = [f"gravity.self={{ accuracy = {accuracy}, interval = {interval} }}"]
    return Run(f"gravity/collapse_{accuracy:g}_{interval:g}", "collapse.toml", settings)


def planet(interval):
    """None: without gravity, and without the weight."""
    if interval is None:
        return Run("gravity/planet_without", "planet.toml", ["gravity=false", "planet.start=unloaded"])
    return Run(f"gravity/planet_{interval:g}", "planet.toml", [f"gravity.self.interval={interval}"])


def runs():
    cases = [collapse(a, 0) for a in ACCURACIES] + [collapse(0.01, i) for i in INTERVALS]
    return cases + [planet(i) for i in (None, *RESTING)] + [FORCES]


def cells(text):
    """Rows of numbers of a table."""
    rows = [[cell.strip() for cell in line.strip("|\n ").split("|")] for line in text.splitlines() if line.startswith("|")]
    return [[float(cell) for cell in row] for row in rows if re.match(r"^[\d.e-]+$", row[0])]


def per_step(summary):
    return summary["core_seconds"] / summary["steps"] / summary["particles"]


def write(found):
    failures = []
    text = found[FORCES.name]
    ceiling = next(float(line.split("|")[2]) for line in text.splitlines() if line.startswith("| ceiling "))
    forces = cells(text)
    head = ["accuracy", "order", "median error", "99 %", "largest", "forces add up to", "us per body", "in interactions of the ceiling"]
    rows = [[f"{a:g}", int(p), *(f"{x:.1e}" for x in (median, most, worst, drift)), f"{us:.2f}", f"{us * ceiling:.0f}"] for a, p, median, most, worst, drift, us in forces]
    good = [us * ceiling for _, _, median, _, _, _, us in forces if median <= 1e-3]
    if min(good) > CEILING_INTERACTIONS:
        failures.append(f"self-gravity: {min(good):.0f} interactions at a median error of 1e-3 (allowed: {CEILING_INTERACTIONS})")
    series = {"median": 2, "99 %": 3, "largest": 4}
    page.plot("gravity", {"an even ball of 1e5 bodies": {name: [(row[6], row[column]) for row in forces] for name, column in series.items()}}, "us per body and evaluation", "error of the acceleration")
    falls = [[f"{a:g}", f"{i:g}", f"{found[collapse(a, i).name]['energy_drift']:.1e}", f"{found[collapse(a, i).name]['momentum_drift']:.1e}", found[collapse(a, i).name]["steps"], f"{found[collapse(a, i).name]['core_seconds']:.3g}"]
             for a, i in [*((a, 0) for a in ACCURACIES), *((0.01, i) for i in INTERVALS)]]
    without = per_step(found[planet(None).name])
    rests = []
    for interval in RESTING:
        summary = found[planet(interval).name]
        rests.append([f"{interval:g}", f"{summary['energy_drift']:.1e}", f"{summary['momentum_drift']:.1e}", f"{100 * summary['phases']['gravity']:.1f} %", f"{per_step(summary) / without:.2f}"])
    return f"""Forces in an even ball against sums over all bodies (`cargo bench --bench gravity`), one core; the ceiling, the stripped pair loop of
`tests/benches/ceiling.rs`, made {ceiling:.0f} million interactions per second in the same run. Required: at most {CEILING_INTERACTIONS} interactions per
body at a median error of 1e-3 or less.

{text.split(chr(10))[0]}

{page.table(head, rows)}

![Error against cost](gravity.png)

A cold cloud that collapses, up to 0.86 of the free-fall time (`inputs/collapse.toml`, 5000 particles); drift of energy over the
largest sum of the magnitudes of its kinds. Its radius is compared in `tests/gravity.rs`.

{page.table(["accuracy", "interval", "drift of energy", "of momentum", "steps", "core-s"], falls)}

A small planet that starts under its own weight, for three crossings of sound (`inputs/planet.toml`, 8000 particles): drift of energy over the
same, and what gravity costs. Its pressure is compared in `tests/gravity.rs`.

{page.table(["interval", "drift of energy", "of momentum", "share of gravity", "core-seconds per step, over those without gravity"], rests)}""", failures
