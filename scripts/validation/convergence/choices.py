"""What the settings of the scenes are worth: kernel, gradient, viscosity and forces without torque as they are and otherwise."""

from common import page
from common.runs import Run
from validation.convergence.cases import CASES

PLAIN = ["numerics.kernel=cubic_spline", "numerics.eta=1.2"]


def otherwise():
    """(what, key, run of the page, run with other numerics): what the choices of the scenes are worth."""
    by_name = {case.name: case for case in CASES}
    weak = ["material.gas.viscosity={ alpha = 1, beta = 2 }"]
    rows = [
        ("wave speed", "frequency", "wave_longitudinal_2d", 0.0125, PLAIN, "spline, eta 1.2"),
        ("wave speed, space", "frequency", "wave_longitudinal_3d", 0.025, PLAIN, "spline, eta 1.2"),
        ("Sod, pressure left of the contact", "plateau_2_stress", "sod_2d", 0.0025, PLAIN, "spline, eta 1.2"),
        ("Sod, the same", "plateau_2_stress", "sod_2d", 0.0025, [*PLAIN, "numerics.corrected_gradient=false"], "spline, eta 1.2, no corrected gradient"),
        ("flyer of basalt, pressure", "plateau_2_stress", "flyer_basalt_2d", 0.005, PLAIN, "spline, eta 1.2"),
        ("piston, elastic limit", "plateau_2_stress", "piston_2d", 0.0025, ["material.aluminium.viscosity={ alpha = 1.5, beta = 3 }"], "alpha 1.5, beta 3"),
        ("Noh in the plane, density, L1", "density_l1", "noh_2d", 0.02, weak, "alpha 1, beta 2"),
        ("Noh in the plane, density, L1", "density_l1", "noh_2d", 0.01, weak, "alpha 1, beta 2"),
        ("spin in the plane, angular momentum per turn", "angular_momentum_per_turn", "spin_2d", 0.1, ["numerics.corrected_gradient=false", "numerics.angular_momentum=false"], "no corrected gradient"),
        ("spin in space, angular momentum per turn", "angular_momentum_per_turn", "spin_3d", 0.2, ["numerics.corrected_gradient=false", "numerics.angular_momentum=false"], "no corrected gradient"),
        ("spin in space, angular momentum per turn", "angular_momentum_per_turn", "spin_3d", 0.2, ["numerics.angular_momentum=false"], "forces with a torque"),
        ("spin in the plane, angular momentum per turn", "angular_momentum_per_turn", "spin_2d", 0.05, ["numerics.artificial_stress=false"], "no artificial stress"),
    ]
    for number, (what, key, name, spacing, settings, how) in enumerate(rows):
        case = by_name[name]
        base = case.runs()[case.spacings.index(spacing)]
        yield what, key, spacing, how, base, Run(f"otherwise/{number}_{name}", base.scene, base.settings + settings)


def runs():
    return [run for *_, run in otherwise()]


def table(found):
    return page.table(["what", "spacing (m)", "error as in the scene", "error otherwise", "otherwise"], [
        [what, f"{d:g}", page.percent(found[base.name]["errors"][key]), page.percent(found[run.name]["errors"][key]), how]
        for what, key, d, how, base, run in otherwise()
    ])
