"""Columns of sand that collapse in a channel, against the laws that experiments found (Lube et al. 2005; Lajeunesse et al. 2005)."""

import math

import h5py
import matplotlib.pyplot as plt
import numpy as np

import page
from runs import Run
from scenes import vector

TITLE = "Columns of sand"

# Height over half width: particles along the half width.
ASPECTS = {0.5: 32, 1.0: 25, 1.5: 20, 3.0: 14, 5.0: 12, 10.0: 10}
RESOLUTION = (1.0, [12, 25, 50])
"""One column at three spacings."""
FRICTION = (1.0, [0.35, 0.7])
"""The same with other friction than the scene's 0.5: sin(20 deg) and sin(44 deg)."""
HALF_WIDTH, G, DENSITY = 0.1, 9.81, 1500.0
SOUND = 25
"""Speed of sound over sqrt(g H)."""
TOLERANCE = 0.2


def column(aspect, across, friction=0.5):
    height, spacing = aspect * HALF_WIDTH, HALF_WIDTH / across
    reach = HALF_WIDTH * (2 + 2 * law(aspect)[0])
    bulk = DENSITY * SOUND**2 * G * height
    settings = [
        f"sand.spacing={spacing}",
        f"sand.size={vector([2 * HALF_WIDTH, height], 2)}",
        f"sand.position={vector([0, 0.5 * height], 2)}",
        f"floor.spacing={spacing}",
        f"floor.size={vector([2 * reach, 5 * spacing], 2)}",
        f"floor.position={vector([0, -2.5 * spacing], 2)}",
        f"material.sand.eos.simplified_tillotson.A={bulk}",
        f"material.sand.strength.shear_modulus={0.43 * bulk}",
        f"material.sand.strength.drucker_prager.friction={friction}",
        f"run.until={5 * math.sqrt(height / G)}",
        "output.snapshots=0",
    ]
    return Run(f"granular/{aspect:g}_{across}_{friction:g}", "column_collapse.toml", settings)


def law(aspect):
    """Run-out of the foot and height at the end, over the half width (Lube et al. 2005; between the two laws their mean in logarithms)."""
    low, high = 1.2 * aspect, 1.9 * aspect ** (2 / 3)
    runout = low if aspect < 1.8 else high if aspect > 2.8 else math.sqrt(low * high)
    return runout, aspect if aspect < 1.15 else 0.65 * aspect**0.4


def runs():
    aspect, resolutions = RESOLUTION
    columns = [column(a, n) for a, n in ASPECTS.items()] + [column(aspect, n) for n in resolutions]
    columns += [column(a, ASPECTS[a], mu) for a, friction in [FRICTION] for mu in friction]
    return list({run.name: run for run in columns}.values())


def deposit(run):
    """Heights over distance from the middle, the mean of both sides; speed of the mean square, over sqrt(g H)."""
    with h5py.File(run.folder / "checkpoint.h5") as file:
        columns = file["columns"]
        sand = columns["id"][:].ravel().view(np.uint64) >> 48 == 0
        x, v = columns["position"][:][sand], columns["velocity"][:][sand]
    return x, v


def measure(run, aspect, across):
    """Foot, height (both over the half width), slope of the flank in degrees, rms speed over sqrt(g H), and the profile."""
    x, v = deposit(run)
    spacing = HALF_WIDTH / across
    edges = np.arange(0, np.abs(x[:, 0]).max() + 2 * spacing, 2 * spacing)
    heights = np.array([top(x, low, low + 2 * spacing) for low in edges[:-1]])
    middle = 0.5 * (edges[:-1] + edges[1:])
    # The foot is where less than two layers of particles are left: beyond it grains lie singly.
    thick = np.nonzero(heights > 2 * spacing)[0]
    foot = edges[thick[-1] + 1]
    height = heights.max()
    flank = (heights > 0.2 * height) & (heights < 0.8 * height)
    slope = math.degrees(math.atan(-np.polyfit(middle[flank], heights[flank], 1)[0])) if flank.sum() > 2 else math.nan
    speed = math.sqrt((v**2).sum(axis=1).mean() / (G * aspect * HALF_WIDTH))
    return foot / HALF_WIDTH - 1, height / HALF_WIDTH, slope, speed, (middle, heights)


def top(x, low, high):
    """Height within a stretch of the distance from the middle: the highest particles of both sides, their mean."""
    found = []
    for side in (1, -1):
        inside = (side * x[:, 0] >= low) & (side * x[:, 0] < high)
        found.append(x[inside, 1].max() if inside.any() else 0.0)
    return sum(found) / 2


def exponent(points):
    logs = np.log(np.array(points))
    return np.polyfit(logs[:, 0], logs[:, 1], 1)[0] if len(points) > 1 else math.nan


def write(found):
    failures, lines, measured = [], [], {}
    for aspect, across in ASPECTS.items():
        run = column(aspect, across)
        summary = found[run.name]
        runout, height, slope, speed, profile = measured[aspect] = measure(run, aspect, across)
        laws = law(aspect)
        cells = []
        for what, value, expected in (("run-out", runout, laws[0]), ("height", height, laws[1])):
            off = value / expected - 1
            missed = abs(off) > TOLERANCE
            if missed:
                failures.append(f"column of sand, a = {aspect:g}: {what} {value:.3g}, {expected:.3g} expected (allowed: {page.percent(TOLERANCE)})")
            cells += [f"{value:.3g}", f"{expected:.3g}", page.percent(off) + (" **missed**" if missed else "")]
        lines.append([f"{aspect:g}", *cells, f"{slope:.0f}", f"{speed:.1e}", f"{summary['energy_drift']:.1e}", summary["particles"], f"{summary['core_seconds']:.3g}"])
    low = exponent([(a, m[0]) for a, m in measured.items() if a < 1.8])
    high = exponent([(a, m[0]) for a, m in measured.items() if a > 2.8])
    others = []
    aspect, resolutions = RESOLUTION
    for across in resolutions:
        runout, height, slope, *_ = measure(column(aspect, across), aspect, across)
        others.append([f"{across} particles along the half width", f"{runout:.3g}", f"{height:.3g}", f"{slope:.0f}"])
    aspect, frictions = FRICTION
    for friction in frictions:
        runout, height, slope, *_ = measure(column(aspect, ASPECTS[aspect], friction), aspect, ASPECTS[aspect])
        others.append([f"friction {friction:g} for 0.5", f"{runout:.3g}", f"{height:.3g}", f"{slope:.0f}"])
    draw(measured)
    head = ["a", "run-out", "law", "off by", "height", "law", "off by", "slope, deg", "rms v / sqrt(g H)", "energy drift", "particles", "core-s"]
    text = f"""`inputs/column_collapse.toml`, a the height over the half width, lengths in half widths: a channel, Drucker and Prager's law with a friction of
0.5 in sqrt(J2), which is 30 degrees for shear in the plane. Laws as Lube et al. 2005 give them for channels: run-out 1.2 a (a < 1.8) and
1.9 a^(2/3) (a > 2.8), height a (a < 1.15) and 0.65 a^(2/5), to {page.percent(TOLERANCE)} (their scatter, and grains of other friction). Five times
sqrt(H / g) after the start, when experiments have come to rest for long.

{page.table(head, lines)}

The run-out goes as a^{low:.2f} in low columns and as a^{high:.2f} in high ones (experiments: 1 and 2/3).

The foot is where less than two layers of particles are left, and the last of the flank is thin: with finer particles it reaches
farther out. Heights beyond a = 1.15 are a quarter to a third above the law, whose own height jumps there; the deposits here have none such.
With a = 1:

{page.table(["changed", "run-out", "height", "slope, deg"], others)}

![Deposits](granular.png)"""
    return text, failures


def draw(measured):
    figure, (profiles, laws) = plt.subplots(1, 2, figsize=(12, 4.6))
    for aspect, (_, _, _, _, (x, heights)) in measured.items():
        profiles.plot(x / HALF_WIDTH, heights / HALF_WIDTH, label=f"a = {aspect:g}")
    profiles.set(xlabel="distance / half width", ylabel="height / half width")
    profiles.legend()
    aspects = np.geomspace(0.4, 12, 100)
    laws.loglog(aspects, [law(a)[0] for a in aspects], "C0-", lw=1, label="run-out, Lube et al. 2005")
    laws.loglog(aspects, [law(a)[1] for a in aspects], "C1-", lw=1, label="height")
    laws.loglog(list(measured), [m[0] for m in measured.values()], "C0o", label="run-out here")
    laws.loglog(list(measured), [m[1] for m in measured.values()], "C1s", label="height here")
    laws.set(xlabel="height / half width", ylabel="over half width")
    laws.legend()
    figure.savefig(page.FOLDER / "granular.png", dpi=110, bbox_inches="tight")
    plt.close(figure)
