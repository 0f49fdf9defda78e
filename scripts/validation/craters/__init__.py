"""The page tests/validation/craters.md: impacts into porous ground beside Jutzi, Benz & Michel 2008, Sec. 5.3."""

import csv
import math
import pathlib
import shutil

import h5py
import matplotlib.pyplot as plt
import numpy

from common import page
from common.runs import Run
from validation.craters import cases

PAGE = "craters.md"
FROM_SOME = True
HEAD = """# Craters in porous ground

Written by `scripts/validate craters`: `inputs/deep_impact.toml` and `inputs/compaction_models.toml` over resolution, beside Jutzi, Benz &
Michel 2008 (Icarus 198, 242). Spacings are those near the impact; those of the paper are 20 cm apart (2.6 kg each). What the figures mean, and what
they depend on, stands in `scripts/validation/craters/judgement.md`."""

PAPER_VOLUMES = {"P-alpha": 62.3, "rho-alpha": 61.9, "epsilon-alpha": 82.9, "P-alpha, soft": 95.2}
PAPER_DISTENTION = {"P-alpha": "1", "rho-alpha": "about 1.8", "epsilon-alpha": "about 1.8", "P-alpha, soft": "-"}


def runs():
    return cases.all_runs()


def rows(run, name):
    with open(run.folder / name) as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def price(found):
    return [str(found["particles"]), f"{found['core_seconds']:.0f}", f"{found['energy_drift']:.0e}"]


def above(run, speed):
    """Mass of the ground that moves upwards faster than that, kg, from the cumulative table; linear in logarithms between its rows."""
    found = [row for row in rows(run, "ejecta.csv") if row["mass_kg"] > 0]
    speeds, masses = [math.log(row["speed_above_m_s"]) for row in found], [math.log(row["mass_kg"]) for row in found]
    return math.exp(float(numpy.interp(math.log(speed), speeds, masses)))


def crushed(run, speed):
    """The share of that whose pores have given way, from the last snapshot; None without pores."""
    last = sorted(run.folder.glob("snapshot_*.vtkhdf"))[-1]
    with h5py.File(last) as file:
        data = file["VTKHDF/PointData"]
        if "distention" not in data:
            return None
        up = (data["velocity"][:, 2] > speed) & (data["body"][:] != PROJECTILE)
        distention, mass = data["distention"][:][up], data["mass"][:][up]
    whole = distention > 0.999 * distention.max()
    return float(mass[~whole].sum() / mass.sum())


SPEEDS = [2, 5, 100]
PROJECTILE = 1
"""Its number among the bodies of the scene."""
DRAWN = ["P-alpha", "rho-alpha", "solid"]


def deep_impact():
    """Ejected mass of all variants."""
    lines = []
    for spacing in cases.DEEP_IMPACT:
        for variant in cases.DEEP_IMPACT_VARIANTS:
            solid = cases.deep_impact("solid, holds tension" if "holds" in variant else "solid", spacing)
            run = cases.deep_impact(variant, spacing)
            if not run.is_there():
                continue
            found = run.result()
            masses = [above(run, speed) for speed in SPEEDS]
            ratios = [f"{above(solid, speed) / mass:.1f}" if solid.is_there() else "" for speed, mass in zip(SPEEDS, masses)]
            share = crushed(run, 2)
            lines.append([
                f"{spacing} cm", variant, *(f"{mass:.3g}" for mass in masses), " / ".join(ratios),
                "–" if share is None else f"{100 * share:.0f} %", f"{found['outcome']['ejected_mass_above_face']:.3g}", *price(found),
            ])
    header = ["spacing", "ice", *(f"above {speed} m/s, kg" for speed in SPEEDS), "solid / this", "crushed, above 2 m/s", "above 2 m/s and the face, kg",
              "particles", "core-s", "drift of energy"]
    figure("craters_deep_impact.png", [(v, cases.deep_impact(v, s), "mass_kg", s) for v in DRAWN for s in cases.DEEP_IMPACT], "mass [kg]")
    keep_picture(cases.deep_impact, DRAWN, cases.DEEP_IMPACT, "craters_deep_impact")
    return page.table(header, lines) + "\n\nThe paper: solid / porous about 10, rho-alpha as P-alpha.\n\n![](craters_deep_impact.png)"


def compaction():
    lines = []
    for spacing in cases.COMPACTION:
        for variant in cases.COMPACTION_VARIANTS:
            run = cases.compaction(variant, spacing)
            if not run.is_there():
                continue
            found, law = run.result(), variant.removesuffix(", broken")
            outcome = found["outcome"]
            lines.append([
                f"{spacing} cm", variant, f"{outcome['compacted_volume']:.1f}", f"{PAPER_VOLUMES[law]}",
                f"{outcome['minimum_distention']:.3f}", PAPER_DISTENTION[law], f"{outcome['crushed_volume']:.2f}", *price(found),
            ])
    header = ["spacing", "law", "compacted, m^3", "paper", "least distention", "paper", "crushed, m^3", "particles", "core-s", "drift of energy"]
    runs = [(v, cases.compaction(v, s), "volume_before_m3", s) for v in cases.LAWS for s in cases.COMPACTION]
    figure("craters_compaction.png", runs, "volume before the impact [m$^3$]")
    profiles("craters_distention.png")
    keep_picture(cases.compaction, cases.LAWS, cases.COMPACTION, "craters_compaction")
    return page.table(header, lines) + "\n\n![](craters_compaction.png) ![](craters_distention.png)"


def figure(name, runs, label):
    """Ejecta over speed: a colour for each variant, thinner for coarser runs; compacted volumes as levels."""
    fig, axes = plt.subplots(figsize=(8, 6))
    variants = list(dict.fromkeys(variant for variant, *_ in runs))
    finest = {v: min((s for w, run, _, s in runs if w == v and run.is_there()), default=None) for v in variants}
    for variant, run, column, spacing in runs:
        if not run.is_there():
            continue
        found = rows(run, "ejecta.csv")
        best = spacing == finest[variant]
        colour = f"C{variants.index(variant)}"
        axes.loglog([row["speed_above_m_s"] for row in found], [row[column] for row in found], colour, lw=2 if best else 0.8,
                    label=f"{variant}, {spacing} cm" if best else None)
        volume = run.result()["outcome"].get("compacted_volume")
        if best and volume and "volume" in column:
            axes.axhline(volume, color=colour, ls="--", lw=1)
    axes.set(xlabel="upward speed [m/s]", ylabel=label)
    axes.set_xlim(left=0.1)
    axes.legend()
    page.save(fig, name)


def profiles(name):
    fig, axes = plt.subplots(figsize=(8, 5))
    for variant in cases.LAWS:
        runs = [cases.compaction(variant, spacing) for spacing in sorted(cases.COMPACTION)]
        run = next(filter(Run.is_there, runs), None)
        if run:
            found = rows(run, "distention.csv")
            axes.plot([row["depth_m"] for row in found], [row["distention"] for row in found], label=variant)
    axes.set(xlabel="depth below the point of impact [m]", ylabel="distention")
    axes.legend()
    page.save(fig, name)


def keep_picture(case, variants, spacings, name):
    """The cut of the finest run of each variant."""
    for variant in variants:
        run = next(filter(Run.is_there, (case(variant, spacing) for spacing in sorted(spacings))), None)
        if run:
            shutil.copy(run.folder / "outcome.png", page.FOLDER / f"{name}_{cases.slug(variant)}.png")


def write(found):
    judgement = pathlib.Path(__file__).with_name("judgement.md").read_text()
    return [HEAD, "## Deep Impact", deep_impact(), "## Laws of compaction", compaction(), judgement], []
