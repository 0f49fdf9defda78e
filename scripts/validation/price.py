"""What accuracy costs: error against core-seconds over schemes of viscosity, kernels and spacings, for nine kinds of scene, by the studies of
inputs/studies/price/."""

import math

import matplotlib.pyplot as plt

from common import kept, page
from common.runs import Study

PAGE = "price.md"
FROM_SOME = True

KEPT = page.FOLDER / "price.json"
PLAIN = "as the scene"
TARGETS = (0.1, 0.03, 0.01, 0.003)

KINDS = {
    # Of inputs/studies/price/: title, what counts as the error, core-seconds.
    "shock": ("Shock in gas: density, L1", 10),
    "blast": ("Blast: density, L1", 130),
    "wave": ("Elastic wave: frequency and damping", 40),
    "plastic": ("Plastic wave: stress, L1", 500),
    "compaction": ("Compaction wave: stress, L1", 630),
    "vortex": ("Vortex: velocity, L1", 700),
    "sand": ("Column of sand: run-out", 200),
    "impact": ("Small impact: largest remnant", 1000),
    "q_star": ("Search of Q*_D: the threshold", 1000),
}
STUDIES = {kind: Study(f"price/{kind}", f"studies/price/{kind}.toml", guess) for kind, (_, guess) in KINDS.items()}


def runs():
    return list(STUDIES.values())


def figures(study):
    """(spacing, core-seconds, error) of each run, by setting."""
    names, curves = [setting["name"] for setting in study["settings"]], {}
    for row in study["points"]:
        curves.setdefault(names[row["setting"]], []).append([row["spacing"], row["core_seconds"], row["error"]])
    return {"curves": curves}


def with_both_errors(study, result):
    """Of a wave the error of its complex frequency counts: that of the frequency, and the damping."""
    both = {row["number"]: math.hypot(summary["errors"]["frequency"], summary["errors"]["damping"]) for _, row, summary in study.points()}
    return {**result, "points": [{**row, "error": both.get(row["number"])} for row in result["points"]]}


def cost_at(curve, error):
    """Core-seconds from which on all finer runs are within an error, on straight lines in the logarithms; nothing is extrapolated."""
    points = [(cost, off) for _, cost, off in curve if off is not None]
    good = len(points)
    while good > 0 and points[good - 1][1] <= error:
        good -= 1
    if good == len(points):
        return math.inf
    if good == 0:
        return points[0][0]
    (c_0, e_0), (c_1, e_1) = points[good - 1], points[good]
    return c_0 * (c_1 / c_0) ** (math.log(e_0 / error) / math.log(e_0 / max(e_1, 1e-12)))


def cheapest(curves, error):
    """(core-seconds, setting) of the cheapest way to an error, and those of the scene as it is."""
    costs = {name: cost_at(curve, error) for name, curve in curves.items()}
    best = min(costs, key=costs.get)
    return costs[best], best, costs[PLAIN]


def goal(curves):
    """(error of the scene as it is at its finest spacing, its cost, cost of the cheapest other setting that has this error, that setting)."""
    _, cost, error = next(row for row in reversed(curves[PLAIN]) if row[2] is not None)
    others = {name: cost_at(curve, error) for name, curve in curves.items() if name != PLAIN}
    best = min(others, key=others.get)
    return error, cost, others[best], best


def section(kind, curves):
    head = ["setting", *(f"error at {row[0]:.3g} m" for row in curves[PLAIN]), "core-s", *(f"core-s to {page.percent(t)}" for t in TARGETS)]
    number = lambda cost: f"{cost:.2g}" if cost < math.inf else "–"
    off = lambda error: "the reference" if error is None else page.percent(error)
    lines = [[name, *(off(e) for *_, e in curve), ", ".join(number(c) for _, c, _ in curve), *(number(cost_at(curve, t)) for t in TARGETS)]
             for name, curve in curves.items()]
    words = []
    for target in TARGETS:
        cost, best, plain = cheapest(curves, target)
        if cost < math.inf:
            factor = "which the scene as it is does not reach" if plain == math.inf else f"{plain / cost:.2g} times cheaper than the scene as it is" if best != PLAIN else "the cheapest"
            words.append(f"{page.percent(target)}: {best}, {factor}")
    return f"## {KINDS[kind][0]}\n\n`inputs/studies/price/{kind}.toml`\n\n{page.table(head, lines)}\n\n{'; '.join(words)}."


def write(found):
    wave = STUDIES["wave"]
    found = {name: with_both_errors(wave, result) if name == wave.name else result for name, result in found.items()}
    rows = kept.known(KEPT, runs(), found, figures)
    known = {kind: rows[study.name]["curves"] for kind, study in STUDIES.items() if study.name in rows}
    lines, reached = [], 0
    for kind, curves in known.items():
        error, cost, other, best = goal(curves)
        reached += cost / other >= 3
        lines.append([KINDS[kind][0], page.percent(error), f"{cost:.2g}", best if other < math.inf else "none", f"{other:.2g}" if other < math.inf else "–", f"{cost / other:.2g}"])
    head = ["scene", "its error at the finest spacing", "core-s", "cheapest other way to that", "core-s", "times cheaper"]
    draw(known)
    text = [TEXT, page.table(head, lines), f"Three times and more: {reached} of {len(known)}.", "![Error against cost](price.png)",
            *(section(kind, curves) for kind, curves in known.items())]
    return text, []


def draw(known):
    figure, axes = plt.subplots(3, 3, figsize=(15, 14))
    for axis, (kind, curves) in zip(axes.flat, known.items()):
        for number, (name, curve) in enumerate(curves.items()):
            points = [(cost, off) for _, cost, off in curve if off]
            if points:
                axis.loglog(*zip(*points), "k-o" if name == PLAIN else f"C{number}-" + "osv^D"[number % 5], markersize=4, label=name)
        axis.set(title=KINDS[kind][0], xlabel="core-seconds", ylabel="error")
        axis.grid(True, which="both", alpha=0.2)
        axis.legend(fontsize=7)
    for axis in axes.flat[len(known):]:
        axis.axis("off")
    figure.tight_layout()
    page.save(figure, "price.png")


TEXT = """# What accuracy costs

Written by `scripts/validate price`; nothing is edited by hand. Error against core-seconds, on one rank of one thread, for each kind of scene with its viscosity as it
is, and one thing changed at a time: limited reconstruction (`numerics.reconstruction`), a switch per particle (`numerics.viscosity_switch`), both, both with
`numerics.density_relaxation`; a lower alpha; other kernels. A run counts as accurate only if all finer runs of its setting are; nothing is extrapolated.
`sph-mpi --accuracy` chooses by such a study."""
