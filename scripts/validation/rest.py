"""Bodies at rest: a ball, a pile of sand and a rubble pile that must keep still, and slopes that begin to slide at their angle."""

import csv
import math

from common import page
from common.runs import Run

TITLE = "At rest"

STILL, PRESSURE = 1e-3, 0.02
"""Asked for: rms speed over that of free fall; error of the pressure in a tenth of the depth, over that at the bottom."""
ANGLE = 2.0
"""Degrees by which the angle at which a slope begins to slide may miss atan(friction)."""

FRICTIONS = {0.5: [22, 24, 25, 26, 26.5, 27, 28, 30], 0.35: [17, 18, 19, 20, 21, 22], 0.7: [32, 33, 34, 35, 36, 37]}
"""Angles of the slope for each friction, degrees; around atan(friction)."""
FINER = (0.5, [25, 26, 26.5, 27, 28])
"""The same slope at half the spacing."""

RESTING = {
    "ball": ("ball", "rest_sphere.toml", []),
    "ball, twice the particles": ("ball_fine", "rest_sphere.toml", ["ball.particles=16000"]),
    "pile of sand, 5 mm": ("pile", "rest_pile.toml", []),
    "pile of sand, 2.5 mm": ("pile_fine", "rest_pile.toml", ["sand.spacing=0.0025", "floor.spacing=0.0025"]),
    "rubble pile, half the particles": ("rubble_coarse", "rest_rubble.toml", ["pile.particles=1000"]),
    "rubble pile": ("rubble", "rest_rubble.toml", []),
    "rubble pile, twice the particles": ("rubble_fine", "rest_rubble.toml", ["pile.particles=4000"]),
}
WITHOUT = {
    "rubble pile, half the particles, whose forces exert a torque": ("rubble_turning_coarse", "rest_rubble.toml", ["pile.particles=1000", "numerics.angular_momentum=false"]),
    "rubble pile whose forces exert a torque: it rotates, ever faster": ("rubble_turning", "rest_rubble.toml", ["numerics.angular_momentum=false"]),
    "ball that starts without load": ("ball_unloaded", "rest_sphere.toml", ["ball.start=unloaded"]),
    "pile that is not damped at first": ("pile_undamped", "rest_pile.toml", ["sand.motion=false"]),
    "pile without friction (damage weakens shear)": ("pile_smooth", "rest_pile.toml", ["material.sand.strength.drucker_prager=false"]),
    "pile with friction 0.3, its flanks too steep": ("pile_slippery", "rest_pile.toml", ["material.sand.strength.drucker_prager.friction=0.3"]),
}


def resting(case):
    name, scene, settings = case
    return Run(f"rest/{name}", scene, settings)


def slope(friction, angle, finer=False):
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    settings = [f"gravity.uniform=[{9.81 * sine:.9g}, {-9.81 * cosine:.9g}]", f"material.sand.strength.drucker_prager.friction={friction}"]
    if finer:
        settings.append("sand.spacing=0.0025")
    return Run(f"rest/slope_{friction:g}_{angle:g}" + ("_fine" if finer else ""), "slope.toml", settings + ["output.picture=false"])


def runs():
    cases = [resting(case) for case in (*RESTING.values(), *WITHOUT.values())]
    cases += [slope(friction, angle) for friction, angles in FRICTIONS.items() for angle in angles]
    return cases + [slope(FINER[0], angle, True) for angle in FINER[1]]


def slides(run):
    """Whether it goes faster and faster: speed (over that of free fall) at half the time and at the end."""
    with open(run.folder / "history.csv") as file:
        rows = list(csv.DictReader(file))
    times, energies = ([float(row[name]) for row in rows] for name in ("time [s]", "kinetic_energy [J]"))
    half = next(k for k, time in enumerate(times) if time >= 0.5 * times[-1])
    end = run.result()["errors"]["speed"]
    early = end * math.sqrt(energies[half] / energies[-1])
    return end > 5 * STILL and end > 1.2 * early, early, end


def critical(friction, angles, finer=False):
    """Between the steepest slope that holds and the first that slides, and a row for each; holds below all that slide or fails."""
    rows, held, slid = [], [], []
    for angle in angles:
        moves, early, end = slides(slope(friction, angle, finer))
        (slid if moves else held).append(angle)
        rows.append([f"{friction:g}", "2.5 mm" if finer else "5 mm", f"{angle:g}", f"{early:.1e}", f"{end:.1e}", "slides" if moves else "holds"])
    orderly = held and slid and max(held) < min(slid)
    return (0.5 * (max(held) + min(slid)) if orderly else math.nan), rows


def write(found):
    failures, still, without, tables, angles = [], [], [], [], []
    for title, case in RESTING.items():
        summary = found[resting(case).name]
        errors = summary["errors"]
        pressure = errors.get("pressure")
        missed = errors["speed_largest"] > STILL or (pressure or 0) > PRESSURE
        if missed:
            failures.append(f"at rest, {title}: speed {errors['speed_largest']:.1e}, pressure {pressure} (allowed: {STILL:g}, {PRESSURE:g})")
        cells = [f"{errors['speed_largest']:.1e}", f"{errors['speed']:.1e}", page.percent(pressure) if pressure is not None else "", f"{summary['energy_drift']:.1e}"]
        still.append([title + (" **missed**" if missed else ""), *cells, summary["particles"], summary["steps"], f"{summary['core_seconds']:.3g}"])
    for title, case in WITHOUT.items():
        errors = found[resting(case).name]["errors"]
        without.append([title, f"{errors['speed_largest']:.1e}", f"{errors['speed']:.1e}"])
    for friction, tried, finer in [*((f, a, False) for f, a in FRICTIONS.items()), (*FINER, True)]:
        angle, rows = critical(friction, tried, finer)
        expected = math.degrees(math.atan(friction))
        missed = not abs(angle - expected) <= ANGLE
        if missed:
            failures.append(f"slope of friction {friction:g}: slides at {angle:.3g} degrees, {expected:.3g} expected (allowed: {ANGLE:g})")
        tables += rows
        angles.append([f"{friction:g}", rows[0][1], f"{angle:.2f}" + (" **missed**" if missed else ""), f"{expected:.2f}", f"{math.degrees(math.asin(friction)):.2f}"])
    return f"""Nothing may move: fully damaged matter with friction for two free-fall times and ten crossings of sound or more, at moduli with which
sound is 25 times as fast as free fall. `inputs/rest_sphere.toml` starts under its own weight, `inputs/rest_pile.toml` is damped for 0.3 s
before speeds count, and the blocks of `inputs/rest_rubble.toml` have fallen together by 3600 s. Rms speeds over sqrt(G M / R) or sqrt(g H), required: {STILL:g}; pressure in a tenth of the depth against
2/3 pi G rho^2 (R^2 - r^2), over that in the middle, required: {page.percent(PRESSURE)}. Softened gravity is weaker by (h / R)^2, 0.9
and 0.6 per cent here, and the last tenth of the depth is one or two spacings of particles: their pressure is a little too large.

{page.table(["", "largest speed", "at the end", "pressure off by", "energy drift", "particles", "steps", "core-s"], still)}

What is necessary; each of these variants moves:

{page.table(["", "largest speed", "at the end"], without)}

**Slopes.** An infinite layer, 10 cm thick, on a rough floor (`inputs/slope.toml`), tilted by gravity, which acts along the period, too. Friction
bounds sqrt(J2) by mu P. Along such a slope nothing stretches (plane strain, translational symmetry), so that plastic flow is
pure shear and turns the deviator until the shear stress is its only component: normal stresses are then all P, in the plane and
across it, and the slope slides where tan(angle) = mu, whatever the stress was at first. It is *not* the angle whose sine is mu, for which a
plane with free normal stresses would take it. A slope slides here if it is faster at the end, half a second, than at half of it by a fifth, and above {5 * STILL:g};
within some tenths of a degree of its angle it keeps about the speed that it got at the start, when the tilt begins at once.

{page.table(["friction mu", "spacing", "begins to slide at, deg", "atan(mu)", "asin(mu)"], angles)}

{page.table(["friction", "spacing", "angle, deg", "v / v_ff at half the time", "at the end", ""], tables)}""", failures
