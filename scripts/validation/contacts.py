"""What meets: fast into soft, light beside heavy, heavy into light, slow and elastic, large and spinning; each as it was and as it is."""

from common import page
from common.runs import Run

TITLE = "Hard contacts"

DRIFT = 1e-3
"""Asked for: drift of the energy over the initial kinetic energy."""

BEFORE = {
    "fast_into_soft": (78, 4.6e2, 2.9e-17, 5e-17, 0.2, "the projectile is inside the target after one step"),
    "gas_clouds_meet": (1, 1.7e-16, 3.6e-18, 5.5e-20, 0.04, "through each other after one step"),
    "spacecraft_on_moonlet": (6557, 0.054, 4.5e-16, 1.4e-3, 14, "gains a twentieth of the total energy in two steps"),
    "unequal_particles": (5271, 8.3e-3, 3e-16, 1.9e-3, 2.9, "energy drifts steadily, more with smaller steps"),
    "slow_balls": (44413, 6.1e-6, 3.7e-16, 0.039, 20, "each rotates ever faster after they have parted"),
    "iron_into_ice": (687, 2.7e-4, 2e-16, 4.8e-6, 2, "iron at 12.9 of its density, 1.9e14 Pa"),
    "large_planet": (218, 3.4e-6, 4.1e-15, 1.7e-3, 2.3, "starts at 6 times its density without the energy of compression, falls to -3.3 MJ/kg"),
    "spinning_pile": (9087, 0.016, 2.9e-16, 6.1e-3, 5.1, "gains spin: gravity of the last evaluation points to where the centre was"),
}
"""Steps, drifts of energy, momentum and angular momentum, core-seconds, and what was seen, before the cures: measured once, at the
commit before them."""

CURES = {
    "fast_into_soft": "time steps are limited by approaching matter (`src/domain/closing.rs`)",
    "gas_clouds_meet": "the same",
    "spacecraft_on_moonlet": "the narrower kernel of a pair counts as two thirds of the wider at least (`src/pair/rows.rs`)",
    "unequal_particles": "the same",
    "slow_balls": "forces without torque are the default of solids (`src/pair/angular_momentum.rs`)",
    "iron_into_ice": "both, and a density contrast by default (`src/pair/contrast.rs`)",
    "large_planet": "it starts with the energy of its compression (`src/scene/hydrostatic/isentrope.rs`)",
    "spinning_pile": "gravity between evaluations follows the particles (`src/gravity/attraction.rs`)",
}

RATIOS = [
    # target's spacing over the projectile's, radius of the projectile (m), its spacing (m), end (s)
    (1, 26, 13, 0.1),
    (2, 13, 6.5, 0.1),
    (8, 4, 1.6, 0.05),
    (30, 2, 0.43, 0.03),
    (60, 1, 0.215, 0.025),
]
MATERIALS = {"aluminium": [], "iron": ["material.aluminium.base=iron"], "with fracture": ["material.aluminium.fracture=true"]}
COURANT = [0.25, 0.1]


def case(name):
    return Run(f"contacts/{name}", f"cases/{name}.toml", ["output.picture=false"])


def pair(ratio, material, courant):
    _, radius, spacing, end = ratio
    settings = [f"dart.radius={radius}", f"dart.spacing={spacing}", f"run.until={end}", f"numerics.cfl={courant}", "output.snapshots=0", "output.picture=false"]
    name = f"contacts/spacing_{ratio[0]}_{material.replace(' ', '_')}_{courant}"
    return Run(name, "cases/unequal_particles.toml", settings + MATERIALS[material])


def runs():
    cases = [case(name) for name in BEFORE]
    return cases + [pair(ratio, material, courant) for ratio in RATIOS for material in MATERIALS for courant in COURANT]


def figures(summary):
    drifts = (summary["energy_drift"], summary["momentum_drift"], summary["angular_momentum_drift"])
    return [summary["steps"], *(f"{drift:.1e}" for drift in drifts), f"{summary['core_seconds']:.2g}"]


def write(found):
    failures, rows = [], []
    for name, (steps, energy, momentum, spin, cost, seen) in BEFORE.items():
        now = found[case(name).name]
        rows.append([f"`{name}`", "before", steps, f"{energy:.1e}", f"{momentum:.1e}", f"{spin:.1e}", cost, seen])
        rows.append(["", "now", *figures(now), CURES[name]])
        if not now["energy_drift"] < DRIFT:
            failures.append(f"{name}: energy drifts by {now['energy_drift']:.1e} (asked: {DRIFT})")
    text = "Scenes of `inputs/cases/`; drifts of energy over the initial kinetic energy (where there is none, over the largest sum of any kind), of momentum over sum m |v|, "
    text += "of angular momentum over sum m |x| |v|; cost in seconds of one core.\n\n"
    text += page.table(["case", "", "steps", "energy", "momentum", "angular momentum", "core-s", "seen, and the cure"], rows)
    rows = []
    for ratio in RATIOS:
        for material in MATERIALS:
            both = [found[pair(ratio, material, courant).name] for courant in COURANT]
            rows.append([ratio[0], f"{ratio[0] ** 3:.0f}", material, *(f"{summary[key]:.1e}" for summary in both for key in ("energy_drift", "angular_momentum_drift"))])
            failures += [f"spacing ratio {ratio[0]}, {material}: {s['energy_drift']:.1e} (asked: {DRIFT})" for s in both if not s["energy_drift"] < DRIFT]
    text += "\n\nA ball on the moonlet of `unequal_particles`, whose particles are so many times as wide as the ball's (and, at equal density, as many times cubed "
    text += "as heavy); from contact until the ball has gone in, at two Courant numbers.\n\n"
    text += page.table(["ratio of spacings", "of masses", "ball", "energy, CFL 0.25", "angular momentum", "energy, CFL 0.1", "angular momentum"], rows)
    return text, failures
