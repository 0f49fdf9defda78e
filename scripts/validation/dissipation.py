"""How much viscosity takes from flows without shocks, and whether shocks stay, with each scheme of viscosity."""

from common import page
from common.runs import Run

PAGE = "dissipation.md"

SCHEMES = {
    "plain": [],
    "reconstruction": ["numerics.reconstruction=true"],
    "switch": ["numerics.viscosity_switch=true"],
    "both": ["numerics.reconstruction=true", "numerics.viscosity_switch=true"],
}

IN_SHOCKS = {**SCHEMES, "density": ["numerics.density_relaxation=true"], "all": [*SCHEMES["both"], "numerics.density_relaxation=true"]}

FLAT = "exact/shear_decay.toml"
CLOSE_PACKED = ["dimension=3", 'domain.periodic={ x = ["-0.5 m", "0.5 m"], y = ["-0.21650635 m", "0.21650635 m"], z = ["-0.20412415 m", "0.20412415 m"] }',
                'fluid.shape={ box = { size = ["1 m", "0.4330127 m", "0.40824829 m"] } }']
DISORDERED = ["fluid.disorder.shift=0.2"]
FINE = ['fluid.spacing="31.25 mm"']
WENDLAND = ["numerics.kernel=wendland_c2", "numerics.eta=1.6"]

SHEAR = {
    "2D lattice, 16": [],
    "2D lattice, 32": FINE,
    "2D disordered, 16": DISORDERED,
    "2D disordered, 32": [*FINE, *DISORDERED],
    "2D disordered, 32, Wendland, eta 1.6": [*FINE, *DISORDERED, *WENDLAND],
    "3D lattice, 16": CLOSE_PACKED,
    "3D disordered, 16": [*CLOSE_PACKED, *DISORDERED],
}
"""Arrangement and spacings per wavelength."""

VORTEX = {25: 0.5, 12.5: 4, 6.25: 30}
LAYER = {12.5: 4, 6.25: 30}
"""Spacing, mm: core-seconds."""


def rows_of(spacing, width):
    """A height that the rows of a lattice fill, an even number of them."""
    return 2 * round(0.5 * width / (0.8660254037844386 * spacing)) * 0.8660254037844386 * spacing


def plane(scene, body, spacing, width, height):
    """A box of a periodic plane."""
    y = 1e-3 * rows_of(spacing, 1e3 * height)
    return [f'domain.periodic={{ x = ["{-0.5 * width} m", "{0.5 * width} m"], y = ["{-0.5 * y:.10g} m", "{0.5 * y:.10g} m"] }}',
            f'{body}.shape={{ box = {{ size = ["{width} m", "{y:.10g} m"] }} }}', f'{body}.spacing="{spacing} mm"']


SHOCKS = {
    "Sod, 2D": ("exact/sod.toml", ["dimension=2", "numerics.corrected_gradient=true"], ("density_l1", "velocity_l1", "plateau_3_density", "front_2_speed"), 1),
    "Noh, 2D": ("exact/noh.toml", ["dimension=2"], ("density_l1", "velocity_l1"), 1),
    "Noh, 2D, fine, alpha 1": ("exact/noh.toml", ["dimension=2", 'gas.spacing="1.25 cm"', "material.gas.viscosity.alpha=1", "material.gas.viscosity.beta=2"], ("density_l1", "velocity_l1", "plateau_1_density", "front_1_speed"), 12),
    "Sedov, 2D": ("exact/sedov.toml", ["dimension=2"], ("density_l1", "velocity_l1", "stress_l1", "front_1_speed"), 0.1),
    "Noh, 3D": ("exact/noh.toml", [], ("density_l1", "velocity_l1"), 10),
    "Sedov, 3D": ("exact/sedov.toml", [], ("density_l1", "velocity_l1", "stress_l1", "front_1_speed"), 8),
    "flyer, aluminium": ("exact/flyer_aluminium.toml", [], ("stress_l1", "velocity_l1", "plateau_1_density", "plateau_2_stress", "front_2_speed"), 1),
    "flyer, basalt": ("exact/flyer_basalt.toml", [], ("stress_l1", "velocity_l1", "plateau_1_density", "plateau_2_stress", "front_2_speed"), 1),
    "piston, aluminium": ("exact/piston_aluminium.toml", [], ("stress_l1", "velocity_l1", "plateau_1_stress", "plateau_2_stress", "front_1_speed", "front_2_speed"), 2),
}


def run(name, scene, scheme, settings=(), guess=1.0):
    word = name.lower().replace(",", "").replace(" ", "_")
    return Run(f"dissipation/{word}_{scheme}", scene, [*settings, *IN_SHOCKS[scheme], "output.picture=false"], guess=guess)


def shear(name, scheme):
    return run(f"shear {name}", FLAT, scheme, SHEAR[name], 1 if name.startswith("2D") else 3)


def vortex(spacing, scheme):
    return run(f"vortex {spacing}", "exact/vortex.toml", scheme, plane("vortex", "gas", spacing, 1, 0.99592920), VORTEX[spacing])


def layer(spacing, scheme):
    return run(f"layer {spacing}", "exact/shear_layer.toml", scheme, plane("layer", "fluid", spacing, 0.5, 0.99592920), LAYER[spacing])


def shock(name, scheme):
    scene, settings, _, guess = SHOCKS[name]
    return run(f"shock {name}", scene, scheme, [*settings, *(["numerics.corrected_gradient=true"] if scheme != "plain" else [])], guess)


def runs():
    smooth = [one for scheme in SCHEMES for one in (
        *(shear(name, scheme) for name in SHEAR), *(vortex(spacing, scheme) for spacing in VORTEX), *(layer(spacing, scheme) for spacing in LAYER))]
    return smooth + [shock(name, scheme) for scheme in IN_SHOCKS for name in SHOCKS]


def write(found):
    return [INTRODUCTION, shear_table(found), VORTEX_TEXT, vortex_table(found), LAYER_TEXT, layer_table(found), SHOCK_TEXT, shock_table(found)], []


def shear_table(found):
    lines = []
    for name in SHEAR:
        nu = {scheme: found[shear(name, scheme).name]["errors"]["viscosity"] / 1.5 for scheme in SCHEMES}
        lines.append([name, *(f"{value:.5f} (1 / {nu['plain'] / value:.0f})" if scheme != "plain" else f"{value:.4f}" for scheme, value in nu.items())])
    return page.table(["arrangement, spacings per wave", *SCHEMES], lines)


def vortex_table(found):
    lines, orders = [], {scheme: [] for scheme in SCHEMES}
    for spacing in VORTEX:
        errors = {scheme: found[vortex(spacing, scheme).name]["errors"]["velocity_l1"] for scheme in SCHEMES}
        for scheme, error in errors.items():
            orders[scheme].append(error)
        lines.append([f"{spacing} mm", *(page.percent(error) for error in errors.values())])
    lines.append(["order", *(f"{page.order(list(VORTEX), errors):.1f}" for errors in orders.values())])
    return page.table(["spacing", *SCHEMES], lines)


def layer_table(found):
    return page.table(["spacing", *SCHEMES], [
        [f"{spacing} mm", *(f"{100 * found[layer(spacing, scheme).name]['errors']['growth']:+.1f} %" for scheme in SCHEMES)] for spacing in LAYER])


def shock_table(found):
    lines = []
    for name, (_, _, keys, _) in SHOCKS.items():
        summaries = [found[shock(name, scheme).name] for scheme in IN_SHOCKS]
        for key in keys:
            errors = [summary["errors"].get(key) for summary in summaries]
            lines.append([name if key == keys[0] else "", key.replace("_", " "), *("–" if e is None else page.percent(e) for e in errors)])
        lines.append(["", "density off mass over volume", *(page.percent(summary["density_drift"]) for summary in summaries)])
        lines.append(["", "steps, core-s", *(f"{summary['steps']}, {summary['core_seconds']:.1f}" for summary in summaries)])
    return page.table(["shock", "error", *IN_SHOCKS], lines)


INTRODUCTION = """# Dissipation

Written by `scripts/validate dissipation`; nothing is edited by hand. Schemes of viscosity: as it always was, with limited reconstruction
(`numerics.reconstruction`), with a switch per particle (`numerics.viscosity_switch`), with both; in shocks also with density that returns to mass
over volume (`numerics.density_relaxation`), and with all three.

## A shear wave

`inputs/exact/shear_decay.toml`: rows of a fluid glide past each other, and nothing should brake them. Kinematic viscosity over alpha c h, from the
decay of the wave's own amplitude; disordered particles are shifted by up to a fifth of the spacing along each axis."""
VORTEX_TEXT = """## A vortex

`inputs/exact/vortex.toml` (Gresho & Chan 1990) after a turn: L1 error of the velocity around the centre, over the largest speed."""
LAYER_TEXT = """## A wave on a shear layer

`inputs/exact/shear_layer.toml`: error of the growth rate (Rayleigh 1880), of a layer that is 5 spacings thick, and 10."""
SHOCK_TEXT = """## Shocks

Scenes of `inputs/exact/` as they are there, coarse; Noh's also finer and with half of the viscosity, where density by continuity drifts.

Gas gains: with all three the errors of Noh's and Sedov's problems are those of plain viscosity or smaller, down to a quarter where density drifts. In solids
densities and speeds of fronts of flyers gain, while profiles lose a tenth to a third, as shorter fronts ring, and a weak plastic wave
loses throughout. Reconstruction alone lets density drift farther behind strong shocks, and wants density that returns beside it."""
