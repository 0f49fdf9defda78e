"""The page tests/validation/q_star.md: Q*_D over radius, resolution, angle, flaw seed and orientation of the lattice, by the searches
of inputs/campaigns/qd_star.toml."""

import math

from common import page
from common.runs import Study

PAGE = "q_star.md"
BY_NAME = True
"""0.7 core-hours."""

STUDY = Study("q_star", "campaigns/qd_star.toml", guess=2500)
OWN = "as the scene"


def runs():
    return [STUDY]


HEAD = ["Q*_D (J/kg)", "/ BA99", "Q*_RD (J/kg)", "slope s", "impacts", "core-s per impact", "core-s", "pair interactions", "energy drift", "momentum drift"]


def table(what, searches):
    """Rows of label and summary."""
    return page.table([what, *HEAD], [row(label, found) for label, found in searches])


def row(label, found):
    t = found["threshold"]
    impacts = len(t["impacts"])
    return [
        label, f"{t['q_star_d']:.3e} ± {t['uncertainty']:.1e}", f"{t['ratio_to_reference']:.2f}", f"{t['q_star_rd']:.3e}", f"{t['slope']:.2f}", impacts,
        f"{found['core_seconds'] / impacts:.0f}", f"{found['core_seconds']:.0f}", f"{found['pair_interactions']:.2e}", f"{found['energy_drift']:.1e}",
        f"{found['momentum_drift']:.1e}",
    ]


def spread(label, searches):
    values = [found["threshold"]["q_star_d"] for found in searches]
    mean = sum(values) / len(values)
    deviation = math.sqrt(sum((x - mean) ** 2 for x in values) / (len(values) - 1))
    return f"{label}: mean {mean:.3e} J/kg, standard deviation {deviation:.1e} J/kg ({100 * deviation / mean:.1f} %)"


def share(found, q):
    """M_lr / M_T at `q`, straight lines in log Q through a search's impacts."""
    points = sorted((i["q"], i["largest_remnant_fraction"]) for i in found["threshold"]["impacts"])
    if q <= points[0][0]:
        return points[0][1]
    for (q_0, m_0), (q_1, m_1) in zip(points, points[1:]):
        if q_0 <= q <= q_1 and q_1 > q_0:
            return m_0 + (m_1 - m_0) * math.log(q / q_0) / math.log(q_1 / q_0)
    return points[-1][1]


def half_of_mean(searches, weights):
    """The Q at which the weighted mean of M_lr / M_T is one half."""
    low, high = 1e4, 2e6
    for _ in range(60):
        q = math.sqrt(low * high)
        mean = sum(w * share(found, q) for w, found in zip(weights, searches)) / sum(weights)
        low, high = (q, high) if mean > 0.5 else (low, q)
    return q


def over_angles(searches):
    """What the fit of Benz & Asphaug 1999 stands for, from searches by their angle (degrees)."""
    # Impacts come at angle theta with probability sin(2 theta) d theta; each angle stands for 15 degrees around it.
    weights = [math.sin(math.radians(2 * angle)) for angle in searches]
    found = list(searches.values())
    fit = found[0]["threshold"]["reference"]
    mean = sum(w * search["threshold"]["q_star_d"] for w, search in zip(weights, found)) / sum(weights)
    half = half_of_mean(found, weights)
    return [
        f"Mean weighted with sin(2 theta): {mean:.3e} J/kg, {mean / fit:.2f} of the fit ({fit:.3e} J/kg), which averages over angles.",
        f"Q at which M_lr / M_T, averaged over angles with the same weights, is one half: {half:.3e} J/kg, {half / fit:.2f} of the fit. "
        "This is the average that the fit stands for: grazing impacts need far more energy and pull the mean of Q*_D up.",
    ]


def write(found):
    q = {name: summary for name, _, summary in STUDY.points()}
    flaws = [q[name] for name in (OWN, "flaw seed 2", "flaw seed 3")]
    lattices = [q[f"orientation seed {k}"] for k in (1, 2, 3)]
    angles = {15: q["15 deg"], 30: q["30 deg"], 45: q[OWN], 60: q["60 deg"]}
    chance = [(f"flaw seed {k}", found) for k, found in enumerate(flaws, 1)]
    chance += [(f"lattice turned, orientation seed {k}", found) for k, found in enumerate(lattices, 1)]
    return [
        "# Q*_D of basalt at 5 km/s",
        f"Written by `scripts/validate q_star`, by the searches of `inputs/{STUDY.file}`; drifts are the largest of any impact of a search.",
        "## Radius, 45 degrees, 2e4 particles",
        table("radius", [("10 km", q["10 km"]), ("50 km", q[OWN]), ("100 km", q["100 km"])]),
        "## Resolution, 50 km, 45 degrees",
        table("particles", [("2e4", q[OWN]), *((n, q[f"{n} particles"]) for n in ("4e4", "8e4", "1.6e5"))]),
        "## Scatter at 2e4 particles, 50 km, 45 degrees",
        table("what differs", chance),
        spread("flaw seeds", flaws), spread("orientations", lattices), spread("all six", flaws + lattices),
        "## Angle, 50 km, 2e4 particles",
        table("angle from the normal", [(f"{angle} deg", found) for angle, found in angles.items()]),
        *over_angles(angles),
    ], []
