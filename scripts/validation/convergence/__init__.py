"""Every exact solution over three or four spacings, in 2D and 3D where the problem has both."""

import math
import shutil

from common import page
from validation.convergence import choices, drift
from validation.convergence.cases import CASES

TITLE = "Convergence"

FIGURES = {
    "sod": ("sod_2d", "density"),
    "sedov": ("sedov_3d", "density"),
    "noh": ("noh_2d", "density"),
    "piston": ("piston_2d", "stress"),
    "flyer": ("flyer_basalt_2d", "stress"),
    "release": ("release_basalt_2d", "velocity"),
    "wave": ("wave_shear_3d", "signal"),
    "sphere": ("sphere_torsional_3d", "signal"),
    "cantilever": ("cantilever", "signal"),
}
"""Figures of the finest runs that the page shows."""


def runs():
    return [run for case in CASES for run in case.runs()] + choices.runs() + drift.runs()


def rows(case, found):
    """Rows of the table, and what is outside its tolerance."""
    summaries = [found[run.name] for run in case.runs()]
    lines, failures = [], []
    for measure in case.measures:
        errors = [summary["errors"].get(measure.key) for summary in summaries]
        known = [(d, e) for d, e in zip(case.spacings, errors) if e is not None]
        finest = errors[-1]
        within = finest is not None and abs(finest) <= measure.bound
        if not within:
            failures.append(f"{case.label}, {measure.label}: {finest} (allowed: {measure.bound})")
        ours = "" if not measure.reference or finest is None else f"{measure.reference * (1 + finest):.5g} {measure.unit}"
        reference = f"{measure.reference:.5g} {measure.unit}" if measure.reference else "exact curve" if "l1" in measure.key else ""
        slope = page.order(*zip(*known)) if len(known) > 1 else math.nan
        lines.append(
            [
                case.label if measure is case.measures[0] else "",
                measure.label,
                reference,
                ours,
                ", ".join("–" if e is None else page.percent(e) for e in errors),
                "–" if math.isnan(slope) else f"{slope:.1f}",
                f"{page.percent(measure.bound)}{'' if within else ' **missed**'}",
                measure.reason,
                ", ".join(f"{s['core_seconds']:.2g}" for s in summaries) if measure is case.measures[0] else "",
            ]
        )
    return lines, failures


GROUPS = {
    "shocks in gas": ("sod", "sedov", "noh"),
    "shocks in solids": ("piston", "flyer", "release"),
    "waves and vibrations": ("wave", "sphere", "cantilever"),
}


def write(found):
    lines, failures = [], []
    for case in CASES:
        some, failed = rows(case, found)
        lines += some
        failures += failed
    panels = {
        title: {
            case.label: [(d / case.spacings[0], found[run.name]["errors"].get(case.measures[0].key)) for d, run in zip(case.spacings, case.runs())]
            for case in CASES
            if case.name.startswith(names)
        }
        for title, names in GROUPS.items()
    }
    page.plot("convergence", panels, "spacing, relative to the coarsest", "error (first row of each case)", x_base=2)
    for figure, (name, field) in FIGURES.items():
        case = next(case for case in CASES if case.name == name)
        shutil.copy(case.runs()[-1].folder / f"compare_{field}.png", page.FOLDER / f"exact_{figure}.png")
    head = ["case", "what", "reference", "ours, finest", "errors, coarse to fine", "order", "tolerance", "reason", "core-s"]
    seconds = sum(found[run.name]["core_seconds"] for run in runs())
    spacings = page.table(["case", "spacings (m)", "particles"], [
        [case.label, ", ".join(f"{d:g}" for d in case.spacings), ", ".join(str(found[run.name]["particles"]) for run in case.runs())]
        for case in CASES
    ])
    text = f"""{page.table(head, lines)}

L1 errors are means over volume of |q - exact|, over the largest exact value. The order is fitted over all spacings shown. All
of this took {seconds / 60:.0f} core-minutes.

{NOTES}
What the settings of the scenes are worth:

{choices.table(found)}

Noh in space: matter between {100 * drift.SHELL[0]:g} and {100 * drift.SHELL[1]:g} cm from the centre at the end, where the exact density is {drift.EXACT:g} kg/m^3.

{drift.table()}

![Errors over spacing](convergence.png)

{" ".join(f"![{figure}](exact_{figure}.png)" for figure in FIGURES)}

{spacings}"""
    return text, failures


NOTES = """- **Sums over the lattice.** The momentum sum is not normalised (this is what makes it conserve), so that stress acts with a
  factor that depends on lattice and neighbours: with the cubic spline and eta = 1.2 it is 1.026 in the close-packed plane and
  1.023 in space, at any spacing. Sound is then faster by half of that, and pressures behind shocks are off by about as much.
  With Wendland's kernel and eta = 1.4 the factor is 0.998 and 0.999: the scenes of solids and the shock tube use it. Behind
  a shock the lattice is compressed along one axis, which makes the same error larger.
- **Density by continuity.** Behind a strong shock particles lose their order, and the density that they have integrated then
  exceeds mass over volume; viscosity that keeps the order smears the shock and heats what converges before it. The next table
  has both densities for Noh's problem in space. Their own density is too high by a quarter and more, and the more so the
  further the shock has gone in spacings; as it gives the volumes m / rho with which pairs act, pressure acts too weakly, and mass
  over volume passes the exact density, too. At 0.05 m this hides the losses by wall heating and the smeared shock, at 0.035 m
  it no longer does: so the error of density rises again, while those of velocity and of a density summed over neighbours
  go on falling. The correction of gradients makes a part of it; wider kernels make it worse. It is the price of a density
  by continuity with little viscosity, is not corrected here, and a finer lattice would not correct it. Errors of Sedov's
  problem that do not fall with the spacing have the same reason. In rock, whose density changes little, plateaus show no such
  drift: pressures behind shocks of flyers are right to some tenths of a per cent.
- **Wall heating** at the centre of Noh's implosion and at the contact of flyers is the known error of artificial viscosity: it is
  a few smoothing lengths wide, so that its share falls with the spacing; its height does not.
- **Free surfaces** make bodies soft over about a spacing: frequencies are too low, with order one.
- **Spins.** A spinning body is in tension, and forces along a stress turn it: by 1e-4 of its angular momentum in a turn, and by a per cent
  where a disc of fine spacing clumps without artificial stress. Forces without torque (`angular_momentum`) keep it to 1e-8, and to 1e-7 where it clumps.
  Without viscosity modes of the free surface grow within some turns. Little viscosity (alpha = 0.1) stops these, and does not affect
  a rigid rotation.
"""
