"""Columns of sand that collapse in a channel or on all sides, against the laws that experiments found (Lube et al. 2004, 2005;
Lajeunesse et al. 2005)."""

import math

import matplotlib.pyplot as plt
import numpy as np

from common import page
from common.runs import Run
from validation.plates import vector

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

ROUND = {0.5: 10, 1.0: 8, 1.5: 7, 3.0: 6, 5.0: 5, 10.0: 4}
"""Round columns: height over radius, and particles along the radius."""
ROUND_FINER = (1.0, 12)
SLAB = {0.5: 12, 1.0: 10, 3.0: 7, 5.0: 6}
"""The channel in three dimensions, with a period across."""
ROWS = 7
"""Particles across that period."""
SOUND_3D = 20


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
        'deposit.body="sand"',
    ]
    return Run(f"granular/{aspect:g}_{across}_{friction:g}", "column_collapse.toml", settings)


def round_law(aspect):
    """As [`law`], of columns that spread on all sides (Lube et al. 2004)."""
    return 1.24 * aspect if aspect < 1.7 else 1.6 * aspect**0.5, aspect if aspect < 1.0 else 0.88 * aspect ** (1 / 6)


def in_space(aspect, across, is_round):
    height, spacing = aspect * HALF_WIDTH, HALF_WIDTH / across
    reach = HALF_WIDTH * (1.4 + (round_law if is_round else law)(aspect)[0])
    bulk, deep = DENSITY * SOUND_3D**2 * G * height, 3.5 * spacing
    settings = ["dimension=3", f"gravity.uniform=[0, 0, {-G}]"]
    if is_round:
        settings += [f"sand.shape={{ cylinder = {{ radius = {HALF_WIDTH}, height = {height} }} }}"]
        settings += [f"floor.shape={{ cylinder = {{ radius = {reach}, height = {deep} }} }}"]
    else:
        width = ROWS * spacing
        settings += [f"domain={{ periodic = {{ y = [{-0.5 * width}, {0.5 * width}] }} }}"]
        settings += [f"sand.size=[{2 * HALF_WIDTH}, {width}, {height}]", f"floor.size=[{2 * reach}, {width}, {deep}]"]
    settings += [
        f"sand.position=[0, 0, {0.5 * height}]",
        f"floor.position=[0, 0, {-0.5 * deep}]",
        f"sand.spacing={spacing}",
        f"floor.spacing={spacing}",
        f"material.sand.eos.simplified_tillotson.A={bulk}",
        f"material.sand.strength.shear_modulus={0.43 * bulk}",
        f"run.until={5 * math.sqrt(height / G)}",
        "output.snapshots=0",
        'deposit.body="sand"',
    ]
    return Run(f"granular/{'round' if is_round else 'slab'}_{aspect:g}_{across}", "column_collapse.toml", settings)


def law(aspect):
    """Run-out of the foot and height at the end, over the half width (Lube et al. 2005; between the two laws their mean in logarithms)."""
    low, high = 1.2 * aspect, 1.9 * aspect ** (2 / 3)
    runout = low if aspect < 1.8 else high if aspect > 2.8 else math.sqrt(low * high)
    return runout, aspect if aspect < 1.15 else 0.65 * aspect**0.4


def runs():
    aspect, resolutions = RESOLUTION
    columns = [column(a, n) for a, n in ASPECTS.items()] + [column(aspect, n) for n in resolutions]
    columns += [column(a, ASPECTS[a], mu) for a, friction in [FRICTION] for mu in friction]
    columns += [in_space(a, n, True) for a, n in [*ROUND.items(), ROUND_FINER]] + [in_space(a, n, False) for a, n in SLAB.items()]
    return list({run.name: run for run in columns}.values())


def measure(run, summary):
    """Foot, height (both over the half width), slope of the flank in degrees, rms speed over sqrt(g H), and the profile, m."""
    heap = summary["deposit"]
    profile = np.loadtxt(run.folder / "deposit.csv", delimiter=",", skiprows=1, ndmin=2).T
    # In space, where two layers are a large part of the deposit, the foot is the distance within which 99 of 100 particles lie.
    foot = "run_out_99" if "dimension=3" in run.settings else "run_out"
    slope = math.nan if heap["flank_angle"] is None else heap["flank_angle"]
    return heap[foot], heap["height_over_half_width"], slope, heap["speed_over_fall"], profile


def exponent(points):
    logs = np.log(np.array(points))
    return np.polyfit(logs[:, 0], logs[:, 1], 1)[0] if len(points) > 1 else math.nan


def write(found):
    lines, measured, failures = compared("column of sand", [(a, n, column(a, n), law(a)) for a, n in ASPECTS.items()], found)
    round_lines, rounds, failed = compared("round column of sand", [(a, n, in_space(a, n, True), round_law(a)) for a, n in ROUND.items()], found)
    finer, *_ = compared("", [(a, n, in_space(a, n, True), round_law(a)) for a, n in [ROUND_FINER]], found)
    slab_lines, slabs, failed_too = compared("channel in 3D", [(a, n, in_space(a, n, False), law(a)) for a, n in SLAB.items()], found)
    failures += failed + failed_too
    low, high = exponents(measured)
    round_low, round_high = exponents(rounds)
    others = []
    aspect, resolutions = RESOLUTION
    for across in resolutions:
        run = column(aspect, across)
        runout, height, slope, *_ = measure(run, found[run.name])
        others.append([f"{across} particles along the half width", f"{runout:.3g}", f"{height:.3g}", f"{slope:.0f}"])
    aspect, frictions = FRICTION
    for friction in frictions:
        run = column(aspect, ASPECTS[aspect], friction)
        runout, height, slope, *_ = measure(run, found[run.name])
        others.append([f"friction {friction:g} for 0.5", f"{runout:.3g}", f"{height:.3g}", f"{slope:.0f}"])
    draw({"channel": measured, "channel in 3D": slabs, "round": rounds})
    head = ["a", "run-out", "law", "off by", "height", "law", "off by", "slope, deg", "foot to top, deg", "rms v / sqrt(g H)", "energy drift", "particles", "core-s"]
    text = f"""`inputs/column_collapse.toml`, a the height over the half width, lengths in half widths: a channel, Drucker and Prager's law with a friction of
0.5 in sqrt(J2), which is 30 degrees for shear in the plane. Laws as Lube et al. 2005 give them for channels: run-out 1.2 a (a < 1.8) and
1.9 a^(2/3) (a > 2.8), height a (a < 1.15) and 0.65 a^(2/5), to {page.percent(TOLERANCE)} (their scatter, and grains of other friction). Five times
sqrt(H / g) after the start, long after experiments have come to rest.

{page.table(head, lines)}

The run-out goes as a^{low:.2f} in low columns and as a^{high:.2f} in high ones (experiments: 1 and 2/3).

**Repose.** Two slopes are given: that of the flank between a fifth and four fifths of the height, and that from the foot to the top. A slope
without end holds up to atan(0.5) = 26.6 degrees (section *At rest*). Heaps that have flowed to where they lie are flatter, the flatter the higher they fell
from.

The foot is where less than two layers of particles are left, and the last of the flank is thin: with finer particles it reaches
farther out. Heights beyond a = 1.15 are a quarter to a third above the law, whose own height jumps there; deposits here have no such jump.
With a = 1:

{page.table(["changed", "run-out", "height", "slope, deg"], others)}

**On all sides.** Round columns, radius for half width, after Lube et al. 2004: run-out 1.24 a (a < 1.7) and 1.6 a^(1/2), height a (a < 1) and
0.88 a^(1/6). Sound is {SOUND_3D} times as fast as sqrt(g H). In three dimensions particles are few (along the radius {", ".join(f"{n} at a = {a:g}" for a, n in ROUND.items())}),
and two layers of them would be a large part of the deposit: here the foot is the circle beyond which a hundredth of the sand lies. Of a cone that
is 0.94 of its radius. Low columns run less far than the law; half as many particles again along the radius take much of that away (below), as
more of them make the channel's run-out longer, too. Heaps are lower than the law: a friction of 0.5 in sqrt(J2) is 30 degrees for shear in the plane, but
22 in triaxial compression, which presumably is nearer to the stress state of spreading on all sides.

{page.table(head, round_lines)}

With {ROUND_FINER[1]} particles along the radius:

{page.table(head, finer)}

The run-out goes as a^{round_low:.2f} in low columns and as a^{round_high:.2f} in high ones (experiments: 1 and 1/2).

**The channel in three dimensions**, {ROWS} particles across a period (along the half width {", ".join(f"{n} at a = {a:g}" for a, n in SLAB.items())}), where grains may move across; the foot as of round ones:

{page.table(head, slab_lines)}

![Deposits](granular.png)"""
    return text, failures


def compared(what_it_is, cases, found):
    """Rows of the table, what was measured by height over half width, and what is outside its tolerance."""
    failures, lines, measured = [], [], {}
    for aspect, across, run, laws in cases:
        summary = found[run.name]
        runout, height, slope, speed, profile = measured[aspect] = measure(run, summary)
        cells = []
        for what, value, expected in (("run-out", runout, laws[0]), ("height", height, laws[1])):
            off = value / expected - 1
            missed = abs(off) > TOLERANCE
            if missed:
                failures.append(f"{what_it_is}, a = {aspect:g}: {what} {value:.3g}, {expected:.3g} expected (allowed: {page.percent(TOLERANCE)})")
            cells += [f"{value:.3g}", f"{expected:.3g}", page.percent(off) + (" **missed**" if missed else "")]
        repose = math.degrees(math.atan(height / (1 + runout)))
        lines.append([f"{aspect:g}", *cells, f"{slope:.0f}", f"{repose:.0f}", f"{speed:.1e}", f"{summary['energy_drift']:.1e}", summary["particles"], f"{summary['core_seconds']:.3g}"])
    return lines, measured, failures


def exponents(measured):
    """Of the run-out over the height, in low and in high columns."""
    return exponent([(a, m[0]) for a, m in measured.items() if a < 1.8]), exponent([(a, m[0]) for a, m in measured.items() if a > 2.8])


def draw(cases):
    figure, (profiles, laws) = plt.subplots(1, 2, figsize=(12, 4.6))
    for aspect, (_, _, _, _, (x, heights)) in cases["channel"].items():
        profiles.plot(x / HALF_WIDTH, heights / HALF_WIDTH, label=f"a = {aspect:g}")
    profiles.set(xlabel="distance / half width", ylabel="height / half width")
    profiles.legend()
    aspects = np.geomspace(0.4, 12, 100)
    for colour, (name, of) in enumerate({"channel": law, "round": round_law}.items()):
        for number, (what, style) in enumerate([("run-out", "-"), ("height", "--")]):
            laws.loglog(aspects, [of(a)[number] for a in aspects], f"C{colour}{style}", lw=1, label=f"{what}, {name}, Lube et al.")
    for name, colour in {"channel": "C0", "channel in 3D": "C2", "round": "C1"}.items():
        for number, (what, mark) in enumerate([("run-out", "o"), ("height", "s")]):
            laws.loglog(list(cases[name]), [m[number] for m in cases[name].values()], colour + mark, label=f"{what}, {name}, here")
    laws.set(xlabel="height / half width", ylabel="over half width")
    laws.legend(fontsize=7)
    page.save(figure, "granular.png")
