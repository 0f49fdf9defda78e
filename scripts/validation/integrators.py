"""What accuracy in time costs, and how long steps may be: the integrators on a vibration, which nothing but time steps damps, and on small
impacts.

Another problem is a line of `PROBLEMS`.
"""

import csv
import dataclasses
import math

import h5py
import numpy

from common import page
from common.runs import Run
from validation.dust import price

PAGE = "integrators.md"

EXACT = ["dimension=2", "output.snapshots=1", "output.precision=f64", "output.picture=false"]
IMPACT = [*EXACT, "target.particles=4000", "material.basalt.fracture=false", "run.until=1 s"]
DUST = [
    *EXACT, 'dust.spacing="100 um"', 'bead.spacing="100 um"', 'layer.0.outer="560 um"', 'bead.position=[0,"0.65 mm"]', 'run.until="1 ms"',
]


@dataclasses.dataclass(frozen=True)
class Way:
    """An integrator, its Courant number and what it tolerates."""

    integrator: str
    cfl: float
    tolerance: str = None

    KEYS = {"Heun": "runge_kutta", "Cash-Karp": "cash_karp"}

    def settings(self):
        key = self.KEYS.get(self.integrator)
        return [f"numerics.cfl={self.cfl}"] + ([f"numerics.integrator.{key}.tolerance={self.tolerance}"] if key else [])

    def name(self):
        return f"{self.integrator}, CFL {self.cfl:g}" + (f", {self.tolerance}" if self.tolerance else "")

    def word(self):
        return "_".join(filter(None, [self.integrator.lower().replace("-", "_"), str(self.cfl), self.tolerance]))

    def curve(self):
        return f"{self.integrator} by CFL" if self.tolerance in (None, "1") else f"{self.integrator} by tolerance, CFL {self.cfl:g}"


@dataclasses.dataclass
class Problem:
    title: str
    scene: str
    settings: list
    references: list
    """The most accurate way, and one with steps twice as long, whose distance says how good it is."""


PROBLEMS = {
    "vibration": Problem("vibration of an elastic disc", "exact/sphere_radial.toml", [*EXACT, "sphere.spacing=4 cm"],
                         [Way("Cash-Karp", cfl, "1e-10") for cfl in (0.05, 0.1)]),
    "fluid": Problem("impact, no strength", "impact.toml", [*IMPACT, "material.basalt.strength=false"],
                     [Way("Cash-Karp", cfl, "1e-8") for cfl in (0.05, 0.1)]),
    "impact": Problem("impact, rock that yields", "impact.toml", IMPACT, [Way("predictor-corrector", cfl) for cfl in (0.005, 0.01)]),
    "dust": Problem("a rigid bead falls into dust", "dust_compaction_2d.toml", DUST, [Way("predictor-corrector", cfl) for cfl in (0.005, 0.01)]),
}


WAYS = (
    [Way("predictor-corrector", cfl) for cfl in (0.5, 0.25, 0.12, 0.06, 0.03)]
    + [Way("Heun", 1, tolerance) for tolerance in ("1e-3", "1e-4", "1e-5")]
    + [Way("Cash-Karp", cfl, "1") for cfl in (2, 1.5, 1, 0.5, 0.25)]
    + [Way("Cash-Karp", 2, tolerance) for tolerance in ("1e-2", "1e-3", "1e-4", "1e-5", "1e-6")]
    + [Way("Cash-Karp", 1, tolerance) for tolerance in ("1e-3", "1e-4", "1e-5")]
)


def run(problem, way):
    return Run(f"integrators/{problem}_{way.word()}", PROBLEMS[problem].scene, PROBLEMS[problem].settings + way.settings(), guess=3)


def references(problem):
    return [run(problem, way) for way in PROBLEMS[problem].references]


# Long enough for an instability to grow out of the noise of a lattice.
LONG = {
    "vibration, 20 periods": ("exact/sphere_radial.toml", [*EXACT, "sphere.spacing=8 cm", "run.until=11.5 ms"]),
    "impact": ("impact.toml", IMPACT),
}
BOUNDS = {"predictor-corrector": (0.25, 0.4, 0.5, 0.6, 0.7, 0.8, 1), "Cash-Karp": (0.25, 0.5, 0.7, 1, 1.25, 1.5, 1.75, 2)}
STABLE = 1e-2
"""Energy drift, over the kinetic energy at the start, of a run whose steps are not too long."""


def bound(case, integrator, cfl):
    scene, settings = LONG[case]
    way = Way(integrator, cfl, None if integrator == "predictor-corrector" else "1")
    return Run(f"integrators/long_{case.split(',')[0]}_{way.word()}", scene, settings + way.settings(), guess=1)


DEEP_IMPACT = ['run.until="2 ms"', "output.snapshots=1"]
RATES = {
    "an elastic bead falls into dust": ("intrusion.depth", {
        "one": price.bead("elastic, predictor-corrector", "4.5 kPa", 100), "two": price.bead("elastic, two rates", "4.5 kPa", 100)}),
    "Deep Impact, 2 ms": ("outcome.ejected_mass", {
        "one": Run("integrators/deep_impact_one", "deep_impact.toml", DEEP_IMPACT, guess=115),
        "two": Run("integrators/deep_impact_two", "deep_impact.toml", [*DEEP_IMPACT, 'two_rates.fast=["projectile"]'], guess=60),
        "two, wider lists": Run("integrators/deep_impact_wide", "deep_impact.toml", [*DEEP_IMPACT, 'two_rates.fast=["projectile"]', "numerics.skin=0.25"], guess=60)}),
}
"""Scenes of bodies with two rates, what is compared, and runs."""


def runs():
    accurate = [one for problem in PROBLEMS for one in (*references(problem), *(run(problem, way) for way in WAYS))]
    accurate += [run for _, ways in RATES.values() for run in ways.values()]
    return accurate + [bound(case, integrator, cfl) for case in LONG for integrator, all in BOUNDS.items() for cfl in all]


def velocities(one):
    """Of all particles at the end, in the order of ids."""
    with h5py.File(sorted(one.folder.glob("snapshot_*.vtkhdf"))[-1]) as file:
        data = file["VTKHDF/PointData"]
        return data["velocity"][:][numpy.argsort(data["id"][:])]


def rms(values):
    return math.sqrt(float((values**2).sum()) / len(values))


def measured(found):
    """A row of the table, {column: value}, of each run that is compared with its reference."""
    for problem in PROBLEMS:
        exact = velocities(references(problem)[0])
        for way in WAYS:
            one = run(problem, way)
            summary = found[one.name]
            yield {
                "problem": problem, "integrator": way.integrator, "cfl": way.cfl, "tolerance": way.tolerance or "",
                "error": distance(one, exact), "energy_drift": summary["energy_drift"], "steps": summary["steps"],
                "refused": summary["refused_steps"], "evaluations": round(evaluations(summary)), "core_seconds": summary["core_seconds"],
            }, way


def distance(one, exact):
    """Of velocities from the reference's, over these."""
    return rms(velocities(one) - exact) / rms(exact)


def evaluations(summary):
    """Of a particle."""
    return summary["updates_per_core_second"] * summary["core_seconds"] / summary["particles"]


def keep(rows):
    with open(page.FOLDER / "integrators.csv", "w", newline="") as file:
        table = csv.DictWriter(file, rows[0], lineterminator="\n")
        table.writeheader()
        table.writerows({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()} for row in rows)


def accuracy(rows, found):
    """Error against cost: a table and a panel for each problem, and what should hold and does not."""
    parts, panels, failures = [], {}, []
    for key, problem in PROBLEMS.items():
        series, lines, errors = {}, [], {}
        for row, way in rows:
            if row["problem"] == key:
                errors[way] = row["error"]
                series.setdefault(way.curve(), []).append((row["core_seconds"], row["error"]))
                lines.append([way.name(), page.percent(row["error"]), f"{row['energy_drift']:.1e}", row["steps"], row["refused"], row["evaluations"], f"{row['core_seconds']:.2f}"])
        best, second = references(key)
        sure = distance(second, velocities(best))
        panels[problem.title] = series
        head = ["integrator", "error", "energy drift", "steps", "refused", "evaluations", "core-s"]
        parts.append(f"**{problem.title[0].upper()}{problem.title[1:]}** (`inputs/{problem.scene}` in the plane, {found[best.name]['particles']} particles; the reference, {problem.references[0].name()}, is {page.percent(sure)} from one with steps twice as long)"
                     f"\n\n{page.table(head, lines)}\n\nOrder in the Courant number: {', '.join(orders(errors))}.")
        gain = errors[Way("predictor-corrector", 0.25)] / errors[Way("Cash-Karp", 1, "1e-4")]
        if key not in ("impact", "dust") and gain < 10:
            failures.append(f"integrators: Cash-Karp is {gain:.1f} times as accurate as the predictor-corrector in {problem.title}")
    page.plot("integrators", panels, "core-seconds", "rms error of velocities")
    return parts, failures


def orders(errors):
    """What a halved Courant number takes from the error, without control of it."""
    for integrator in ("predictor-corrector", "Cash-Karp"):
        points = [(way.cfl, error) for way, error in errors.items() if way.integrator == integrator and way.tolerance in (None, "1") and way.cfl <= 1]
        yield f"{page.order(*zip(*points)):.1f} {integrator}"


def gain(one):
    """Of total energy over a run, J."""
    with open(one.folder / "history.csv") as file:
        total = [float(row["total_energy [J]"]) for row in csv.DictReader(file)]
    return total[-1] - total[0]


def stability(found):
    """Energy drift over Courant numbers, and the largest of these that are stable."""
    numbers = sorted({cfl for all in BOUNDS.values() for cfl in all})
    columns = [(case, integrator) for case in LONG for integrator in BOUNDS]
    drift = {(*column, cfl): found[bound(*column, cfl).name]["energy_drift"] for column in columns for cfl in BOUNDS[column[1]]}

    def cell(key):
        if key not in drift:
            return ""
        return "**unstable**" if drift[key] > 1 else f"{math.copysign(drift[key], gain(bound(*key))):+.1e}"

    lines = [[f"{cfl:g}", *(cell((*column, cfl)) for column in columns)] for cfl in numbers]
    most = {column: max(cfl for cfl in BOUNDS[column[1]] if drift[*column, cfl] < STABLE) for column in columns}
    failures = [f"integrators: {integrator} is unstable above CFL {most[case, integrator]} in {case}"
                for (case, integrator), least in SENSIBLE.items() if most[case, integrator] < least]
    text = "; ".join(f"{integrator}, {case}: {most[case, integrator]:g}" for case, integrator in columns)
    return f"{page.table(['CFL', *(f'{case}: {integrator}' for case, integrator in columns)], lines)}\n\nLargest Courant number with a drift below {STABLE:g}: {text}.", failures


def rates(found):
    """A table: one rate beside two."""
    lines = []
    for scene, (figure, ways) in RATES.items():
        for way, run in ways.items():
            row = found[run.name]
            value = row
            for key in figure.split("."):
                value = value[key]
            small = row.get("small_steps") or row["steps"]
            lines.append([scene, way, row["steps"], small, f"{evaluations(row):.0f}", row["list_builds"], f"{row['core_seconds']:.0f}", f"{row['momentum_drift']:.0e}", f"{figure.split('.')[1]} {value:.5g}"])
    return page.table(["scene", "rates", "steps", "small steps", "evaluations of a particle", "lists", "core-s", "momentum drift", "figure"], lines)


SENSIBLE = {("vibration, 20 periods", "Cash-Karp"): 1, ("impact", "Cash-Karp"): 1}
"""Courant numbers that should be stable."""

def write(found):
    rows = list(measured(found))
    keep([row for row, _ in rows])
    parts, failures = accuracy(rows, found)
    bounds, unstable = stability(found)
    text = [INTRODUCTION, *parts, NOTES, "![Error against cost](integrators.png)", STABILITY, bounds, TWO_RATES, rates(found)]
    return text, failures + unstable


INTRODUCTION = """# Integrators

Written by `scripts/validate integrators`; nothing is edited by hand. All rows, with more digits: [integrators.csv](integrators.csv).

## Error against cost

Errors of time steps alone, at one spacing: the rms difference of all velocities at the end to those of a reference with much shorter steps,
over the rms velocity. What stands behind an integrator is the Courant number, which bounds all steps, and the error of a step that is
tolerated; at a tolerance of 1 nothing is refused. An evaluation is one of all forces; Heun's scheme makes two in a step and
Cash and Karp's six, five in a step that is refused."""

NOTES = """Where nothing but elastic waves and flow goes on, Cash and Karp's scheme gains most, and long steps with little control are its best use.
Viscosity has kinks in time (it acts on what approaches only), which end its fifth order in an impact, and forces without torque follow
their moments to the second order of the step. Where rock yields, it is of first order, as stress returns to the yield surface once
per step, and what counts is the number of steps, of which the predictor-corrector makes most for its cost. Tight tolerances refuse steps
there and gain little: kinks in time do not become smooth in shorter ones."""

STABILITY = """## How long steps may be

Energy gained (+) or lost (-) over the kinetic energy at the start. The vibration has no viscosity: what a step amplifies grows for twenty
periods, and what it damps is missed. The impact has the usual viscosity. No error is controlled (a tolerance of 1). The largest
Courant number that a scene may have is 1 for the predictor-corrector and 2 for the others; error control then shortens what is too long."""

TWO_RATES = """## Two rates

What is stiff or small takes small steps of its own, `[two_rates]`; by one rate all take them. In dust the bead and the dust that touches
it are 6 % of the particles. In Deep Impact the projectile, hot and torn, limits all from the first step to the last; lists must then be
built in each large step, as fast matter crosses their skin, and a wider one costs less."""
