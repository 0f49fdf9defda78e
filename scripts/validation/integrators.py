"""What accuracy in time costs: the three integrators on a vibration, which nothing but time steps damps, and on small impacts."""

import math

import h5py
import numpy

from common import page
from common.runs import Run

TITLE = "Integrators"

EXACT = ["output.snapshots=1", "output.precision=f64", "output.picture=false"]
PLANE = ["dimension=2", *EXACT]
IMPACT = [*PLANE, "target.particles=4000", "material.basalt.fracture=false", "run.until=1 s"]

PROBLEMS = {
    # Scene and settings, what it is, and the tolerance of the reference.
    "vibration": ("exact/sphere_radial.toml", [*PLANE, "sphere.spacing=4 cm"], "vibration of a disc, elastic, without viscosity, two periods", "1e-10"),
    "fluid": ("impact.toml", [*IMPACT, "material.basalt.strength=false"], "impact at 5 km/s without strength", "1e-7"),
    "impact": ("impact.toml", IMPACT, "impact at 5 km/s into rock that yields", "1e-7"),
}

SETTINGS = {
    "predictor-corrector, CFL 0.5": ["numerics.cfl=0.5"],
    "predictor-corrector, CFL 0.25": [],
    "predictor-corrector, CFL 0.12": ["numerics.cfl=0.12"],
    "predictor-corrector, CFL 0.06": ["numerics.cfl=0.06"],
    **{f"Heun, {tolerance}": ["numerics.cfl=1", f"numerics.integrator.runge_kutta.tolerance={tolerance}"] for tolerance in ("1e-3", "1e-4", "1e-5")},
    **{
        f"Cash-Karp, CFL {cfl}, {tolerance}": [f"numerics.cfl={cfl}", f"numerics.integrator.cash_karp.tolerance={tolerance}"]
        for cfl, tolerance in ((2, "1e-3"), (1.5, "1e-3"), (1, "1e-3"), (1, "1e-4"), (1, "1e-5"), (1, "1e-6"), (0.5, "1e-3"))
    },
}


def run(problem, setting):
    scene, settings, *_ = PROBLEMS[problem]
    word = setting.lower().replace(", ", "_").replace(" ", "_").replace("-", "_")
    return Run(f"integrators/{problem}_{word}", scene, settings + SETTINGS[setting], guess=2)


def reference(problem):
    scene, settings, _, tolerance = PROBLEMS[problem]
    return Run(f"integrators/{problem}_reference", scene, [*settings, "numerics.cfl=0.1", f"numerics.integrator.cash_karp.tolerance={tolerance}"], guess=10)


def runs():
    return [one for problem in PROBLEMS for one in (reference(problem), *(run(problem, setting) for setting in SETTINGS))]


def velocities(one):
    """Of all particles at the end, in the order of ids."""
    with h5py.File(sorted(one.folder.glob("snapshot_*.vtkhdf"))[-1]) as file:
        data = file["VTKHDF/PointData"]
        return data["velocity"][:][numpy.argsort(data["id"][:])]


def rms(values):
    return math.sqrt(float((values**2).sum()) / len(values))


def evaluations(summary):
    return summary["updates_per_core_second"] * summary["core_seconds"] / summary["particles"]


def write(found):
    parts, panels = [], {}
    for problem, (scene, _, title, tolerance) in PROBLEMS.items():
        exact = velocities(reference(problem))
        rows, series = [], {}
        for setting in SETTINGS:
            one = run(problem, setting)
            summary = found[one.name]
            error = rms(velocities(one) - exact) / rms(exact)
            kind, rest = setting.split(", ", 1)
            series.setdefault(kind + (", " + rest.split(",")[0] if kind == "Cash-Karp" else ""), []).append((summary["core_seconds"], error))
            rows.append([setting, page.percent(error), f"{summary['energy_drift']:.1e}", summary["steps"], summary["refused_steps"],
                         f"{evaluations(summary):.0f}", f"{summary['core_seconds']:.2f}"])
        panels[title.split(",")[0]] = series
        head = ["integrator", "error of velocities", "energy drift", "steps", "refused", "evaluations", "core-s"]
        parts.append(f"**{title[0].upper()}{title[1:]}** (`inputs/{scene}` in the plane, {found[reference(problem).name]['particles']} particles; reference: Cash-Karp, CFL 0.1, {tolerance})\n\n{page.table(head, rows)}")
    page.plot("integrators", panels, "core-seconds")
    return INTRODUCTION + "\n\n".join(parts) + f"\n\n{NOTES}\n![Error against cost](integrators.png)", []


INTRODUCTION = """Errors of time steps alone, at one spacing: rms difference of all velocities to a reference with much shorter steps, over the rms
velocity. Numbers behind a name are tolerances. `inputs/studies/integrators.toml` is a study of the same kind.

"""

NOTES = """NOTES"""
