"""What accuracy costs: error against core-seconds over kernel, neighbours, time step and viscosity, by two studies of inputs/studies/."""

import math

from common import page
from common.runs import Study

TITLE = "Price of accuracy"

SEDOV, WAVE = Study("price/sedov", "studies/sedov.toml"), Study("price/wave", "studies/wave_longitudinal.toml")

PROBLEMS = [
    # Its study, title, the scene's own settings, what counts as the error, and errors for which the cheapest setting is named.
    (SEDOV, "Sedov, 3D: density, L1", "spline, eta 1.2, CFL 0.15, alpha 2, beta 4", lambda e: e["density_l1"], [0.1, 0.08, 0.07]),
    (WAVE, "longitudinal wave, 3D: frequency and damping", "Wendland, eta 1.4, CFL 0.25, no viscosity",
     lambda e: math.hypot(e["frequency"], e["damping"]), [0.02, 0.01, 0.005]),
]


def runs():
    return [SEDOV, WAVE]


def curves(study, own, measure):
    """(spacing, core-seconds, error) of each run, by setting."""
    found = {}
    for name, row, summary in study.points():
        label = f"as in the scene: {own}" if name == "as the scene" else name
        found.setdefault(label, []).append((row["spacing"], summary["core_seconds"], measure(summary["errors"])))
    return found


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


def cheapest(settings, error):
    costs = {label: cost_at([(cost, e) for _, cost, e in points], error) for label, points in settings.items()}
    best = min(costs, key=costs.get)
    return f"{page.percent(error)}: {best}, {costs[best]:.2g} core-s" if costs[best] < math.inf else f"{page.percent(error)}: none of these"


def write(found):
    parts, panels = [], {}
    for study, title, own, measure, given in PROBLEMS:
        settings = curves(study, own, measure)
        spacings = [spacing for spacing, *_ in next(iter(settings.values()))]
        panels[title] = {label: [(cost, error) for _, cost, error in points] for label, points in settings.items()}
        head = ["setting", *(f"error at {d:g} m" for d in spacings), *(f"core-s at {d:g} m" for d in spacings), "order"]
        lines = [
            [label, *(page.percent(e) for *_, e in points), *(f"{c:.2f}" for _, c, _ in points), f"{page.order(spacings, [e for *_, e in points]):.1f}"]
            for label, points in settings.items()
        ]
        parts.append(f"**{title}** (`inputs/{study.file}`)\n\n{page.table(head, lines)}\n\n"
                     f"Cheapest for an error of {'; '.join(cheapest(settings, error) for error in given)}.")
    page.plot("price", panels, "core-seconds")
    text = "\n\n".join(parts) + f"\n\n{NOTES}\n![Error against cost](price.png)"
    return text, []


NOTES = """One setting is changed at a time. The error of the wave is that of its complex frequency, so that damping counts. Where sums over
the lattice are too large (spline, eta 1.2) their error cancels that of the resolution at one spacing; the error does not stay
that small at finer ones.
"""
