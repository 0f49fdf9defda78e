"""What accuracy costs: table 2 of the paper again."""

from common import page
from validation.dust.compaction import FIRST, HEAD, cells, plane

SPACING = 25
RATIOS = (2, 3, 4, 5, 5.6, 6, 7)
PAPER = {2: (16.2, 132401), 3: (14.8, 96912), 4: (19.8, 71175), 5: (19.0, 56347), 6: (21.6, 46782), 7: (24.3, 39980)}
"""h / l_c: hours on four cores, steps (K_0 = 300 kPa)."""

SOFT = {ratio: plane(f"ratio_{ratio}", SPACING, ratio=ratio, seconds=(ratio / 5.6)) for ratio in RATIOS}
HARD = {ratio: plane(f"hard_ratio_{ratio}", SPACING, FIRST, ratio=ratio, seconds=1.7 * (ratio / 5.6)) for ratio in RATIOS}
COURANT = {cfl: plane(f"cfl_{cfl}", settings=[f"numerics.cfl={cfl}"], seconds=0.5 / cfl) for cfl in (0.1, 0.25, 0.5, 0.6)}

ELASTIC = ["bead.rigid=false", "numerics.cfl=0.25"]
CASH_KARP = ["bead.rigid=false", "numerics.integrator=cash_karp", "numerics.cfl=1.25"]
BEADS = {
    "rigid": None,
    "elastic, two rates": ([*ELASTIC, 'two_rates.fast=["bead"]'], 55),
    "elastic, predictor-corrector": (ELASTIC, 230),
    "elastic, Cash-Karp (the paper's)": (CASH_KARP, 270),
}
"""Beads: what makes them, and core-seconds over those of a rigid one with K_0 = 4.5 kPa."""
DUSTS = {"4.5 kPa": [], "300 kPa": FIRST}


def bead(kind, dust, spacing, more=(), name="", **of_plane):
    """A run with such a bead."""
    if kind == "rigid":
        return {"4.5 kPa": plane("calibrated", spacing), "300 kPa": plane("table_1", spacing, FIRST, seconds=7)}[dust]
    settings, seconds = BEADS[kind]
    seconds *= 1 if dust == "4.5 kPa" else 0.54
    word = kind.split(" (")[0].replace(",", "").replace(" ", "_").replace("-", "_")
    own = "" if dust == "4.5 kPa" else "hard_"
    return plane(f"{own}bead_{word}{name}", spacing, [*DUSTS[dust], *settings, *more], seconds=seconds * of_plane.pop("share", 1), **of_plane)


FULL = [
    *((kind, dust, 100) for dust in DUSTS for kind in BEADS), *((kind, "4.5 kPa", 50) for kind in list(BEADS)[:2]),
    *((kind, "300 kPa", spacing) for spacing in (50, SPACING) for kind in BEADS),
]
FULL_RUNS = {key: bead(*key) for key in FULL}
SLICE = 0.04
"""ms of a fall that is cut short, to know what the whole costs."""
SLICES = {
    (ratio, kind): bead(kind, "300 kPa", SPACING, [f'run.until="{SLICE} ms"'], f"_slice_{ratio}", ratio=ratio, share=0.015 * ratio / 5.6)
    for ratio in RATIOS for kind in list(BEADS)[1:]
}
FEW = ["run.steps=400", "output.picture=false"]
EFFECTS = {
    "as it is": [],
    "no contact viscosity": ["numerics.contact_viscosity=false"],
    "no viscosity of the dust": ["numerics.contact_viscosity=false", "material.silica_dust.viscosity=false"],
    "plasticity after unloading": ['material.silica_dust.eos.sirono.plasticity="after_unloading"'],
    "an elastic bead": ELASTIC,
    "an elastic bead, two rates": BEADS["elastic, two rates"][0],
    "an elastic bead, Cash-Karp": CASH_KARP,
}
EFFECT_RUNS = {
    name: plane(f"effect_{number}", settings=[*FEW, *settings], seconds=0.2)
    for number, (name, settings) in enumerate(EFFECTS.items())
}


def runs():
    return [*COURANT.values(), *SOFT.values(), *HARD.values(), *EFFECT_RUNS.values(), *SLICES.values(), *FULL_RUNS.values()]


def rows(sweep, known):
    for ratio, run in sweep.items():
        row = known.get(run.name)
        hours, steps = PAPER.get(ratio, (None, None))
        gain = f"{4 * 3600 * hours / row['core_seconds']:.0f}" if row and hours else ""
        yield [ratio, *cells(row), steps or "", f"{4 * hours:.0f}" if hours else "", gain]


def write(known):
    head = ["h / l_c", *HEAD, "paper: steps", "core-hours", "core-time, paper's over ours"]
    courant = page.table(["CFL", *HEAD], [[cfl, *cells(known.get(run.name))] for cfl, run in COURANT.items()])
    return [
        TEXT, page.table(head, rows(HARD, known)), SOFT_TEXT, page.table(head, rows(SOFT, known)), COURANT_TEXT, courant,
        BEADS_TEXT, page.table(["l_c", "K_0", "bead", *HEAD, "core-time over the rigid bead's"], beads(known)),
        EFFECTS_TEXT, page.table(["scene", "us of a particle's step", "over the first"], effects(known)),
        SLICES_TEXT, page.table(["h / l_c", "bead", "steps per ms", "core-h for 5 ms", "paper: steps per ms", "core-h for 5 ms"], slices(known)),
    ], []


def effects(known):
    """Rows of prices per step."""
    step = lambda row: 1e6 * row["core_seconds"] / (row["steps"] * row["particles"])
    first = known.get(EFFECT_RUNS["as it is"].name)
    for name, run in EFFECT_RUNS.items():
        row = known.get(run.name)
        yield [name, *([f"{step(row):.2f}", f"{step(row) / step(first):.2f}"] if row and first else ["not run", ""])]


def beads(known):
    """Rows of falls with each bead."""
    for (kind, dust, spacing), run in FULL_RUNS.items():
        row, rigid = known.get(run.name), known.get(FULL_RUNS["rigid", dust, spacing].name)
        times = f"{row['core_seconds'] / rigid['core_seconds']:.1f}" if row and rigid else ""
        yield [f"{spacing} um", dust, kind, *cells(row), times]


def slices(known):
    """Rows of falls cut short."""
    for (ratio, kind), run in SLICES.items():
        row, (hours, steps) = known.get(run.name), PAPER.get(ratio, (None, None))
        ours = ["not run", ""]
        if row:
            ms = 1e3 * row["time"]
            ours = [f"{row['steps'] / ms:.0f}", f"{5 * row['core_seconds'] / ms / 3600:.2f}"]
        yield [ratio, kind, *ours, f"{steps / 5:.0f}" if steps else "", f"{4 * hours:.0f}" if hours else ""]


TEXT = """## What accuracy costs

The paper's table 2: l_c = 25 um in the plane, K_0 = 300 kPa, p_m = 1.3 kPa, neighbours by h / l_c. Its core-hours are those of 5 ms on four cores of 2.66
GHz in 2009, with an elastic bead, whose sound sets the step; ours end when the rigid bead is deepest."""
SOFT_TEXT = "The same with the calibrated K_0 = 4.5 kPa and p_m = 0.26 kPa (the paper's times are those with 300 kPa, as its bead set the step anyway):"
COURANT_TEXT = "The Courant number, at l_c = 50 um:"

BEADS_TEXT = """### The bead

A rigid bead has no sound that limits steps. An elastic one (Murnaghan's law, 5 GPa) sets the step of all, unless it takes small steps of its own
(`[two_rates]`). What differs in depth and time between them is the error that a rigid bead brings."""
EFFECTS_TEXT = """What a step costs, over the first 400 steps at l_c = 50 um, with 113 neighbours; steps of two rates are large ones, of 200 small
ones each:"""
SLICES_TEXT = f"""The first {SLICE} ms at l_c = {SPACING} um with K_0 = 300 kPa; steps of two rates are large ones."""
