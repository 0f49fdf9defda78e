"""A glass bead falls into dust (Sects. 4 and 5.1 of the paper)."""

import matplotlib.pyplot as plt

from common import page
from common.runs import Run

PLANE = "dust_compaction_2d.toml"
SPACE = "dust_compaction_3d.toml"
SIRONO = "material.silica_dust.eos.sirono"
TO_SPACE = 0.8488
"""A depth in three dimensions over that in the plane, 8 / (3 pi) (eq. 26)."""
HEXAGONAL = 0.9306
"""Root of a particle's area over l_c."""
SWEEP = 50
"""l_c of sweeps, um."""


def plane(name, spacing=SWEEP, settings=(), radius=0.55, ratio=5.6, seconds=1.0):
    """A run in the plane: l_c in um, the bead's radius in mm, h / l_c; `seconds`: core-seconds over those of the scene at this spacing."""
    own = [
        f'dust.spacing="{spacing} um"', f'bead.spacing="{spacing} um"', f'layer.0.outer="{ratio * spacing:g} um"',
        f'bead.position=[0,"{radius + 1e-3 * spacing:g} mm"]', f"numerics.eta={0.5 * ratio / HEXAGONAL:.3f}", "intrusion.ends_run=true",
    ]
    guess = 6 * (50 / spacing) ** 3 * seconds
    return Run(f"dust/plane_{name}_{spacing:g}um", PLANE, [*own, *settings], guess=guess)


def space(name, spacing, settings=(), seconds=1.0):
    own = [f'dust.spacing="{spacing} um"', f'bead.spacing="{spacing} um"', f'layer.0.outer="{3.75 * spacing:g} um"',
           f'bead.position=[0,0,"{0.55 + 1e-3 * spacing:g} mm"]']
    return Run(f"dust/space_{name}_{spacing:g}um", SPACE, [*own, *settings], guess=2000 * (50 / spacing) ** 4 * seconds)


FIRST = [f'{SIRONO}.K_0="300 kPa"', f'{SIRONO}.compression.powder.p_m="1.3 kPa"']
"""Table 1 of the paper: before calibration."""

CONVERGENCE = [plane("calibrated", spacing) for spacing in (100, 50, 25, 12.5)]
CONVERGENCE_FIRST = [plane("table_1", spacing, FIRST, seconds=7) for spacing in (100, 50, 25)]
IN_SPACE = [space("calibrated", spacing) for spacing in (100, 50, 25)]
IN_SPACE_FIRST = [space("table_1", spacing, FIRST, seconds=5) for spacing in (100, 50)]

DOMAINS = {f"bowl of {depth} mm": plane(f"bowl_{depth}", settings=[f'dust.radius="{depth} mm"'], seconds=(depth / 3.3) ** 2) for depth in (1.375, 2.2, 3.3, 5.5)} | {
    f"box of 8 mm, {depth} mm deep": plane(
        f"box_{depth}", settings=[f'dust.shape={{ box = {{ size = ["8 mm", "{depth} mm"] }} }}', f'dust.position=[0,"{-0.5 * depth} mm"]'], seconds=0.5 * depth)
    for depth in (1.375, 2.2, 3.3, 5.5)
}

VISCOSITY = {alpha: plane(f"alpha_{alpha}", settings=[f"material.silica_dust.viscosity.alpha={alpha}"]) for alpha in (0, 0.05, 0.1, 0.2, 0.5, 1, 2)}
LATER = ['run.until="9 ms"']
HARD_VISCOSITY = {alpha: plane(f"hard_alpha_{alpha}", settings=[*FIRST, f"material.silica_dust.viscosity.alpha={alpha}"], seconds=7) for alpha in (0, 0.1, 2)}
PRESSURE = {p: plane(f"p_m_{p}", settings=[f'{SIRONO}.compression.powder.p_m="{p} kPa"', *(LATER if p < 0.2 else [])], seconds=0.6) for p in (0.13, 0.26, 0.65, 1.3, 2.6, 6.5, 13)}
WIDTH = {delta: plane(f"Delta_{delta}", settings=[f"{SIRONO}.compression.powder.Delta={delta}", *(LATER if delta > 0.77 else [])]) for delta in (0.55, 0.58, 0.65, 0.7, 0.75, 0.8)}
MODULUS = {k: plane(f"K_0_{k}", settings=[f'{SIRONO}.K_0="{k} kPa"'], seconds=(k / 4.5) ** 0.5) for k in (2, 4.5, 50, 300)}
INVISCID = ["numerics.contact_viscosity=false", "material.silica_dust.viscosity.alpha=0"]
MODULUS_INVISCID = {k: plane(f"K_0_{k}_inviscid", settings=[f'{SIRONO}.K_0="{k} kPa"', *INVISCID, *LATER], seconds=(k / 4.5) ** 0.5) for k in (2, 300)}
RADIUS = {r: plane(f"radius_{r}", settings=[f'bead.radius="{r} mm"', f'dust.radius="{6 * r:g} mm"', 'run.until="20 ms"'], radius=r, seconds=(r / 0.55) ** 3) for r in (0.5, 0.75, 1, 1.5)}
CHOICES = {
    "as it is": plane("calibrated", SWEEP),
    "plasticity after unloading (variant 2)": plane("variant_2", settings=[f'{SIRONO}.plasticity="after_unloading"']),
    "shear as printed (eqs. 10, 18)": plane("as_printed", settings=[f"{SIRONO}.shear_as_printed=true", *LATER]),
    "gamma = 2": plane("gamma_2", settings=[f"{SIRONO}.gamma=2"]),
    "gamma = 6": plane("gamma_6", settings=[f"{SIRONO}.gamma=6"]),
    "no contact viscosity": plane("no_contact", settings=["numerics.contact_viscosity=false"]),
    "alpha 1.9 by the bead": plane("contact_1.9", settings=["material.glass.viscosity.alpha=1.9"]),
    "no gravity": plane("no_gravity", settings=["gravity.uniform=[0,0]"]),
    "no gravity, an absorbing layer": plane("absorbing", settings=["gravity.uniform=[0,0]", 'layer.0.motion={ damping = "0.1 ms" }', *LATER]),
}
FINE = 25
"""l_c where 50 um are too coarse: slow beads, which come to rest within a few spacings, and both variants of plasticity, um."""
SPEED = {v: plane(f"speed_{v}", FINE, settings=[f'bead.velocity=[0,"-{v} m/s"]', *LATER]) for v in (0.1, 0.25, 0.4, 0.65, 1)}
FINE_VARIANT = plane("variant_2", FINE, [f'{SIRONO}.plasticity="after_unloading"'])
SWEEPS = (DOMAINS, VISCOSITY, HARD_VISCOSITY, PRESSURE, WIDTH, MODULUS, MODULUS_INVISCID, SPEED, RADIUS, CHOICES)


def runs():
    several = [run for sweep in SWEEPS for run in sweep.values()]
    all_of_them = [*CONVERGENCE, FINE_VARIANT, *IN_SPACE, *several, *CONVERGENCE_FIRST, *IN_SPACE_FIRST]
    return list({run.name: run for run in all_of_them}.values())


HEAD = ["depth", "peak at", "phi there", "gap at", "stops after", "compacted / bead", "sine off by", "steps", "core-s"]


def stopped(row):
    """The fall of a run in which the bead came to rest."""
    fall = (row or {}).get("intrusion") or {}
    return fall if fall.get("stopping_time") is not None else None


def cells(row):
    """What is told of a run."""
    if row is None:
        return ["not run"] + [""] * (len(HEAD) - 1)
    fall = stopped(row)
    if not fall:
        return ["did not come to rest"] + [""] * (len(HEAD) - 3) + [row["steps"], f"{row['core_seconds']:.0f}"]
    mm = lambda key: "–" if fall[key] is None else f"{1e3 * fall[key]:.3f} mm"
    return [mm("depth"), mm("peak_depth"), f"{fall['peak_filling_factor']:.3f}", mm("gap_depth"), f"{1e3 * fall['stopping_time']:.2f} ms",
            f"{fall['compacted_over_body']:.2f}", f"{fall['sine_deviation']:.3f}", row["steps"], f"{row['core_seconds']:.0f}"]


def sweep_table(name, sweep, known):
    return page.table([name, *HEAD], [[key, *cells(known.get(run.name))] for key, run in sweep.items()])


def spacings(runs, known):
    return page.table(["l_c", *HEAD], [[run.name.rsplit("_", 1)[1].replace("um", " um"), *cells(known.get(run.name))] for run in runs])


def predicted(known):
    """What runs in space would take that are finer than any that is there."""
    def hours(runs):
        there = [(float(run.name.rsplit("_", 1)[1].removesuffix("um")), row) for run in runs if stopped(row := known.get(run.name))]
        return min(there)[1]["core_seconds"] / 3600 * (min(there)[0] / 25) ** 4 if there else None

    soft, hard = hours(IN_SPACE), hours(IN_SPACE_FIRST)
    return [SPACE_PRICE.format(soft=soft, hard=hard)] if soft and hard else []


def write(known):
    parts = [COMPACTION, spacings(CONVERGENCE, known), FIRST_TEXT, spacings(CONVERGENCE_FIRST, known), SPACE_TEXT,
             spacings(IN_SPACE, known), SPACE_FIRST_TEXT, spacings(IN_SPACE_FIRST, known), *predicted(known), experiment(known)]
    titles = {"domain": DOMAINS, "alpha": VISCOSITY, "alpha of the first dust": HARD_VISCOSITY, "p_m, kPa": PRESSURE, "Delta": WIDTH, "K_0, kPa": MODULUS, "K_0, kPa, no viscosity": MODULUS_INVISCID, "v, m/s": SPEED, "radius, mm": RADIUS, "choice": CHOICES}
    for name, sweep in titles.items():
        parts += [TEXTS[name], sweep_table(name, sweep, known)]
    both = {"at once": plane("calibrated", FINE), "after unloading": FINE_VARIANT}
    parts += [f"Both variants of plasticity at l_c = {FINE} um:", sweep_table("plasticity", both, known)]
    draw(known)
    return [*parts, "![Sweeps of the compaction](dust_compaction.png)"], failures(known)


def experiment(known):
    """Ours, the paper's and the experiment's figures side by side."""
    final = [known.get(run.name) for run in IN_SPACE]
    ours = next(filter(None, map(stopped, reversed(final))), None)
    flat = [known.get(run.name) for run in CONVERGENCE]
    flat = next(filter(None, map(stopped, reversed(flat))), None)

    def figures(key, unit, scale):
        value = f"{scale * ours[key]:.3f} {unit}".strip() if ours else "not run"
        plane = f"{scale * flat[key]:.3f} {unit}".strip() if flat else "not run"
        return value, plane

    rows = [
        ["depth (peak of the filling factor)", *figures("peak_depth", "mm", 1e3), "1.02 mm", "1.07 mm"],
        ["depth of the bead's lowest point", *figures("depth", "mm", 1e3), "–", "1.0 mm (eq. 23)"],
        ["stopping time", *figures("stopping_time", "ms", 1e3), "2.42 ± 0.05 ms", "3.0 ± 0.1 ms"],
        ["peak of the filling factor", *figures("peak_filling_factor", "", 1), "0.29", "0.3"],
        ["that one bead's volume of dust exceeds", *figures("filling_factor_of_body_volume", "", 1), "0.24", "0.23"],
        ["intrusion curve off the sine (rms)", *figures("sine_deviation", "", 1), "slightly below it", "0"],
    ]
    return EXPERIMENT + "\n\n" + page.table(["", "ours, 3D", "ours, 2D", "paper, 3D", "experiment"], rows)


def draw(known):
    """Depth of the peak and stopping time over what is swept."""
    panels = {"p_m, kPa": PRESSURE, "Delta": WIDTH, "alpha of the dust": VISCOSITY, "speed, m/s": SPEED}
    figure, axes = plt.subplots(1, len(panels), figsize=(4 * len(panels), 3.6))
    for axis, (name, sweep) in zip(axes, panels.items()):
        rows = {key: stopped(known.get(run.name)) for key, run in sweep.items() if stopped(known.get(run.name))}
        if not rows:
            continue
        axis.plot(list(rows), [1e3 * row["peak_depth"] for row in rows.values()], "o-", label="peak at, mm")
        axis.plot(list(rows), [1e3 * row["depth"] for row in rows.values()], "s-", label="depth, mm")
        axis.plot(list(rows), [1e3 * row["stopping_time"] for row in rows.values()], "^--", label="stopping time, ms")
        axis.set(xlabel=name)
        if name.startswith("p_m"):
            axis.set_xscale("log")
        axis.grid(True, alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.tight_layout()
    page.save(figure, "dust_compaction.png")


def failures(known):
    """What should hold: convergence."""
    wrong = []
    depth = lambda run: (stopped(known.get(run.name)) or {}).get("peak_depth")
    fine = [depth(run) for run in CONVERGENCE if depth(run)]
    if len(fine) > 2 and abs(fine[-1] / fine[-2] - 1) > 0.05:
        wrong.append(f"dust: the last two spacings differ by {100 * (fine[-1] / fine[-2] - 1):.1f} % in depth")
    return wrong


COMPACTION = """## A bead falls into dust: in the plane

`inputs/dust_compaction_2d.toml`, a rigid bead, K_0 = 4.5 kPa, p_m = 0.26 kPa, h / l_c = 5.6, over the spacing. `depth` is that of the bead's lowest
point, `peak at` where the filling factor below it is largest, `gap at` where it is smallest between bead and dust, all when the bead is deepest.
The paper's two measures are peak and gap (its Fig. 6).

Runs in the plane were made before the contact's pressure was that of its exact filling (`src/step/contact.rs`). At 50 um that changes the
depth by +0.3 %, the peak by -0.7 %, its filling factor by +2.4 % and the time by +0.2 %; in a bowl of 1.375 mm the depth by +1.2 %."""
FIRST_TEXT = """With the paper's table 1 (K_0 = 300 kPa, p_m = 1.3 kPa); it found the peak at 0.9 mm for small l_c:"""
SPACE_TEXT = """## In three dimensions

`inputs/dust_compaction_3d.toml`: K_0 = 2 kPa, p_m = 0.26 kPa, h / l_c = 3.75, as in the paper's final run (peak at 1.02 mm, stopped after 2.42 ms)."""
SPACE_FIRST_TEXT = """With the paper's table 1; it found the peak at 0.65 mm, converged:"""
SPACE_PRICE = """Cost grows as 1 / l_c^4 (particles, and steps): at 25 um some {soft:.0f} core-hours with K_0 = 2 kPa, and {hard:.0f} with table 1, which is not
run."""
EXPERIMENT = """## Beside the experiment

A bead of 1.1 mm at 0.65 m/s. Depths in the plane are 1 / 0.849 of those in space (eq. 26): 1.07 mm are 1.26 mm."""
TEXTS = {
    "domain": f"""## Shape and size of the bed

At l_c = {SWEEP} um. The paper sees spurious peaks below 3.3 mm.""",
    "alpha": "## Viscosity of the dust",
    "alpha of the first dust": """With the paper's table 1 (K_0 = 300 kPa, p_m = 1.3 kPa), where sound is eight times faster; its peak rises from 0.92 to 0.62 mm as alpha goes
from 0 to 2:""",
    "p_m, kPa": """## Compressive strength

The paper takes 0.26 kPa, of which it expects 1.18 to 1.42 mm in the plane (as 1 mm in space).""",
    "Delta": "Width of the curve of strength:",
    "K_0, kPa": "Bulk modulus, which the paper says hardly matters here:",
    "K_0, kPa, no viscosity": "The same without any viscosity:",
    "v, m/s": """## Speed and size of the bead

Eq. 23 makes depth proportional to m v / A, 8.3e-4 m^2 s/kg times that, and the stopping time independent of speed. At l_c = 25 um:""",
    "radius, mm": "At l_c = 50 um. Experiments: 3.0 ms for beads of 1 mm, 6.2 ms for 3 mm. The bed is six radii deep.",
    "choice": """## Choices

What the paper leaves open, prints otherwise, or found without influence.""",
}
