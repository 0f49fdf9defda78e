"""What accuracy costs: error against core-seconds over kernel, neighbours, time step and viscosity."""

import math

import page
from runs import Run
from scenes import wave

TITLE = "Price of accuracy"

WENDLAND = "numerics.kernel=wendland_c2"
SPLINE = "numerics.kernel=cubic_spline"


def kernel(name, eta):
    return [f"numerics.kernel={name}", f"numerics.eta={eta}"]


def viscosity(material, alpha, beta):
    return ["numerics.viscosity=true", f"material.{material}.viscosity={{ alpha = {alpha:.3f}, beta = {beta:.3f} }}"]


SEDOV = {
    "as in the scene: spline, eta 1.2, CFL 0.15, alpha 2, beta 4": [],
    "spline, eta 1.4": kernel("cubic_spline", 1.4),
    "Wendland, eta 1.2": kernel("wendland_c2", 1.2),
    "Wendland, eta 1.4": kernel("wendland_c2", 1.4),
    "Wendland, eta 1.6": kernel("wendland_c2", 1.6),
    "CFL 0.25": ["numerics.cfl=0.25"],
    "CFL 0.08": ["numerics.cfl=0.08"],
    "alpha 1, beta 2": viscosity("gas", 1, 2),
    "alpha 3, beta 6": viscosity("gas", 3, 6),
    "no corrected gradient": ["numerics.corrected_gradient=false"],
}

WAVE = {
    "as in the scene: Wendland, eta 1.4, CFL 0.25, no viscosity": [],
    "Wendland, eta 1.2": kernel("wendland_c2", 1.2),
    "Wendland, eta 1.6": kernel("wendland_c2", 1.6),
    "Wendland, eta 1.8": kernel("wendland_c2", 1.8),
    "spline, eta 1.2": kernel("cubic_spline", 1.2),
    "spline, eta 1.4": kernel("cubic_spline", 1.4),
    "spline, eta 1.7": kernel("cubic_spline", 1.7),
    "CFL 0.5": ["numerics.cfl=0.5"],
    "CFL 0.1": ["numerics.cfl=0.1"],
    "alpha 0.1, beta 0": viscosity("basalt", 0.1, 0),
    "alpha 1.5, beta 3": viscosity("basalt", 1.5, 3),
    "no corrected gradient": ["numerics.corrected_gradient=false"],
}

PROBLEMS = {
    "sedov": ("Sedov, 3D: density, L1", SEDOV, [0.1, 0.07, 0.05], "exact/sedov.toml",
              lambda d: [f"gas.spacing={d}", f"gas.blast={{ energy = 1, radius = {4 * d:g} }}"], lambda e: e["density_l1"]),
    "wave": ("longitudinal wave, 3D: frequency and damping", WAVE, [0.05, 0.025, 0.0125], "exact/wave_longitudinal.toml",
             lambda d: wave(d, 3, rows=10), lambda e: math.hypot(e["frequency"], e["damping"])),
}
GIVEN = {"sedov": [0.1, 0.08, 0.07], "wave": [0.02, 0.01, 0.005]}
"""Errors for which the cheapest setting is named."""


def batch(problem):
    """(setting, spacing) -> run."""
    _, settings, spacings, scene, at, _ = PROBLEMS[problem]
    numbered = enumerate(settings.items())
    return {(label, d): Run(f"price_{problem}/{k}_{d:g}", scene, at(d) + more + ["output.picture=false"]) for k, (label, more) in numbered for d in spacings}


def runs():
    return [run for problem in PROBLEMS for run in batch(problem).values()]


def cost_at(points, error):
    """Cost at which a setting reaches an error, on straight lines in the logarithms; nothing is extrapolated."""
    points = sorted(points)
    if points[0][1] <= error:
        return points[0][0]
    for (c_0, e_0), (c_1, e_1) in zip(points, points[1:]):
        if e_1 <= error < e_0:
            share = math.log(e_0 / error) / math.log(e_0 / e_1)
            return c_0 * (c_1 / c_0) ** share
    return math.inf


def write(found):
    parts, panels = [], {}
    for problem, (title, settings, spacings, _, _, measure) in PROBLEMS.items():
        all_runs = batch(problem)
        curves = {
            label: [(found[all_runs[label, d].name]["core_seconds"], measure(found[all_runs[label, d].name]["errors"])) for d in spacings]
            for label in settings
        }
        panels[title] = curves
        head = ["setting", *(f"error at {d:g} m" for d in spacings), *(f"core-s at {d:g} m" for d in spacings), "order"]
        lines = [
            [label, *(page.percent(e) for _, e in points), *(f"{c:.2f}" for c, _ in points), f"{page.order(spacings, [e for _, e in points]):.1f}"]
            for label, points in curves.items()
        ]
        cheapest = []
        for error in GIVEN[problem]:
            costs = {label: cost_at(points, error) for label, points in curves.items()}
            best = min(costs, key=costs.get)
            cheapest.append(f"{page.percent(error)}: {best}, {costs[best]:.2g} core-s" if costs[best] < math.inf else f"{page.percent(error)}: none of these")
        parts.append(f"**{title}**\n\n{page.table(head, lines)}\n\nCheapest for an error of " + "; ".join(cheapest) + ".")
    page.plot("price", panels, "core-seconds")
    text = "\n\n".join(parts) + f"\n\n{NOTES}\n![Error against cost](price.png)"
    return text, []


NOTES = """One setting is changed at a time. The error of the wave is that of its complex frequency, so that damping counts. Where sums over
the lattice are too large (spline, eta 1.2) their error cancels that of the resolution at one spacing; the error does not stay
that small at finer ones.
"""
