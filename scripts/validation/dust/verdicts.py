"""Ours, the paper's and the experiments' figures side by side, with a verdict for each."""

import numpy

from common import page
from validation.dust import bouncing, compaction, fragmentation, price
from validation.dust.compaction import TO_SPACE, stopped

CLOSE = 0.1
"""A difference that counts as agreement: the paper's own spread over resolution and domain."""


def of(known, run, key):
    fall = stopped(known.get(run.name))
    return fall.get(key) if fall else None


def finest(known, runs, key):
    """Of the last of these runs that is there."""
    return next((value for value in (of(known, run, key) for run in reversed(runs)) if value is not None), None)


def ratio(a, b):
    return a / b if a and b else None


def judge(ours, others):
    """How far ours is from each of the others, {name: value}."""
    if ours is None:
        return "not run"
    off = {name: ours / value - 1 for name, value in others.items() if value}
    words = ", ".join(f"{100 * x:+.0f} % of the {name}" for name, x in off.items())
    if not off:
        return ""
    return ("agrees: " if min(abs(x) for x in off.values()) <= CLOSE else "differs: ") + words


def line(what, ours, paper, experiment, scale=1.0, digits=3, unit="", why=""):
    def show(value):
        return "–" if value is None else f"{value:.{digits}f} {unit}".strip()

    mine = None if ours is None else scale * ours
    others = {"experiment": experiment, "paper": paper}
    verdict = judge(mine, others)
    if mine is not None and why and verdict.startswith("differs"):
        verdict += f"; {why}"
    return [what, "not run" if mine is None else show(mine), show(paper), show(experiment), verdict]


def slope(points):
    """Of y over x in logarithms, by least squares."""
    points = [(x, y) for x, y in points if y]
    return float(numpy.polyfit(*numpy.log(numpy.array(points)).T, 1)[0]) if len(points) > 2 else None


def rows(known):
    space = compaction.IN_SPACE
    hard_plane, hard_space = compaction.CONVERGENCE_FIRST, compaction.IN_SPACE_FIRST
    yield line("3D: depth of the peak", finest(known, space, "peak_depth"), 1.02, 1.07, 1e3, 2, "mm")
    yield line("3D: depth of the lowest point", finest(known, space, "depth"), None, 1.005, 1e3, 2, "mm")
    yield line("3D: stopping time", finest(known, space, "stopping_time"), 2.42, 3.0, 1e3, 2, "ms")
    yield line("3D: peak of the filling factor", finest(known, space, "peak_filling_factor"), 0.29, 0.3, 1, 2)
    yield line("3D: filling factor that a bead's volume exceeds", finest(known, space, "filling_factor_of_body_volume"), 0.24, 0.23, 1, 2)
    yield line("table 1, 2D: depth of the peak", finest(known, hard_plane, "peak_depth"), 0.9, None, 1e3, 2, "mm")
    yield line("table 1, 3D: depth of the peak", finest(known, hard_space, "peak_depth"), 0.65, None, 1e3, 2, "mm")
    yield line("table 1: depth in 3D over 2D", ratio(finest(known, hard_space, "peak_depth"), finest(known, hard_plane, "peak_depth")), 0.65 / 0.9, None,
               why=f"8 / (3 pi) = {TO_SPACE:.3f} of eq. 26 is that of equal deceleration by area")
    soft, stiff = (of(known, compaction.MODULUS[k], "peak_depth") for k in (2, 300))
    inviscid = ratio(*(of(known, compaction.MODULUS_INVISCID[k], "depth") for k in (300, 2)))
    why = "viscosity grows with the sound of the dust" + (f"; without any the depths differ by {100 * (inviscid - 1):+.0f} %" if inviscid else "")
    yield line("2D: depth of the peak with K_0 = 300 kPa over 2 kPa", ratio(stiff, soft), 1.0, None, why=why)
    at_once, late = (of(known, run, "peak_depth") for run in (compaction.plane("calibrated", compaction.FINE), compaction.FINE_VARIANT))
    yield line("2D: depth of the peak, plasticity after unloading over at once", ratio(late, at_once), 1.0, None)
    thin, thick = (of(known, compaction.HARD_VISCOSITY[a], "peak_depth") for a in (0, 2))
    yield line("table 1, 2D: depth of the peak with alpha = 2 over 0", ratio(thick, thin), 0.62 / 0.92, None)
    yield line("2D: power of depth over speed", slope([(v, of(known, run, "peak_depth")) for v, run in compaction.SPEED.items()]), 1.0, 1.0)
    slow, fast = (of(known, compaction.SPEED[v], "stopping_time") for v in (0.25, 1))
    lowest = slope([(v, of(known, run, "depth")) for v, run in compaction.SPEED.items()])
    yield line("2D: stopping time at 1 m/s over 0.25 m/s", ratio(fast, slow), 1.0, 1.0,
               why=f"the depth of the lowest point goes as v^{lowest:.2f}, and time as depth over speed" if lowest else "")
    small, large = (of(known, compaction.RADIUS[r], "stopping_time") for r in (0.5, 1.5))
    yield line("2D: stopping time, bead of 3 mm over 1 mm", ratio(large, small), None, 6.2 / 3.0,
               why="the depth of eq. 23 and the sine of eq. 22 make it 3 in theory")
    bounce = known.get(bouncing.SPACINGS[12.5].name) or known.get(bouncing.SPACINGS[25].name) or {}
    yield line("restitution, K_0 = 5 kPa", (bounce.get("restitution") or {}).get("coefficient"), 0.19, 0.2)
    for (p_m, modulus), paper in bouncing.PAPER.items():
        if (p_m, modulus) != (0.26, 5):
            bounce = known.get(bouncing.SWEEP[p_m, modulus].name) or {}
            yield line(f"restitution, p_m = {p_m} kPa, K_0 = {modulus} kPa", (bounce.get("restitution") or {}).get("coefficient"), float(paper), None)
    broken = next((known[run.name]["fragments"] for run in reversed(fragmentation.SPACINGS.values()) if run.name in known), {})
    soft, stiff = (((known.get(fragmentation.GAMMA[gamma].name) or {}).get("fragments") or {}) for gamma in (4, 6))
    found = lambda key: f": {soft[key]:.2f}, with gamma = 6 {stiff[key]:.2f} at {fragmentation.COARSE} um" if soft.get(key) and stiff.get(key) else ""
    why = "with gamma = 4, which the paper does not print, compacted dust is soft and spreads along the plate before it tears"
    yield line("fragments: slope", broken.get("slope"), 0.673, 0.67, why=why + found("slope"))
    yield line("fragments: mu, the share of the largest", broken.get("mu"), 0.234, 0.22, why=why + found("mu"))
    for name, sweep, goal in (("300 kPa", price.HARD, 400), ("4.5 kPa", price.SOFT, 2500)):
        yield core_time(f"core-time, paper's over ours, h / l_c = 5, {name} (goal {goal})", known.get(sweep[5].name), goal)


def core_time(what, row, goal):
    """How often the paper's core-time is ours, and how fast pairs were and would have to be."""
    gain = 3600 * 4 * price.PAPER[5][0] / row["core_seconds"] if row else None
    cells = line(what, gain, None, None, digits=0)
    if row:
        speed = 1e-6 * row["pair_interactions"] / row["core_seconds"]
        cells[-1] = (
            f"{'reached' if gain >= goal else 'not reached'}: {speed:.0f} million interactions per core-second, where the goal takes {speed * goal / gain:.0f}; "
            f"the ceiling of a core with AVX-512 is 161 ([bench](bench.md)), and one without it makes about half"
        )
    return cells


def runs():
    return []


def write(known):
    return [TEXT, page.table(["figure", "ours", "paper", "experiment", "verdict"], rows(known))], []


TEXT = f"""## Verdicts

Ours beside the paper and the experiments. Within {100 * CLOSE:.0f} % of one of them counts as agreement."""
