"""A dust aggregate breaks on a plate (Sect. 5.3, Fig. 19, table 5)."""

import matplotlib.pyplot as plt

from common import page
from common.runs import Run
from validation.dust.compaction import SIRONO

SCENE = "dust_fragmentation.toml"
PAPER = {3: (0.361, 0.200), 3.5: (0.429, 0.172), 4: (0.518, 0.230), 4.25: (0.523, 0.194), 4.5: (0.673, 0.234), 4.75: (0.834, 0.196),
         5: (0.832, 0.198), 5.5: (0.836, 0.220), 6: (2.027, 0.171), 6.5: (0.910, 0.390)}
"""K_0, kPa: slope and largest fragment."""


def impact(modulus, spacing=8, more=(), name=""):
    own = [f'{SIRONO}.K_0="{modulus} kPa"']
    if spacing != 8:
        own += [f'aggregate.spacing="{spacing} um"', f'plate.spacing="{spacing} um"', f'aggregate.position=[0,0,"{-0.285 - 1e-3 * spacing:g} mm"]']
    return Run(f"dust/fragments{name}_{modulus}_{spacing:g}um", SCENE, [*own, *more], guess=4500 * (8 / spacing) ** 4 * (modulus / 4.5) ** 0.5)


COARSE = 20
"""l_c of sweeps and of what is only compared with each other, um."""
TURNED_AT = 16
SWEEP = {modulus: impact(modulus, COARSE) for modulus in PAPER}
SPACINGS = {spacing: impact(4.5, spacing) for spacing in (COARSE, 16, 12, 8)}
TURNED = {seed: impact(4.5, TURNED_AT, [f"aggregate.orientation={{ seed = {seed} }}"], f"_turned_{seed}") for seed in (1, 2, 3)}
GAMMA = {gamma: impact(4.5, COARSE, [] if gamma == 4 else [f"{SIRONO}.gamma={gamma}"], "" if gamma == 4 else f"_gamma_{gamma}") for gamma in (2, 3, 4, 5, 6)}

CHOICES = {
    "as it is": [], "no viscosity of the dust": ["material.silica_dust.viscosity.alpha=0"],
    "alpha = 10 at the plate": ["material.glass.viscosity.alpha=10"], "alpha = 51 at the plate": ["material.glass.viscosity.alpha=51"],
    "shear as printed (eqs. 10, 18)": [f"{SIRONO}.shear_as_printed=true"], "plasticity after unloading (variant 2)": [f'{SIRONO}.plasticity="after_unloading"'],
    "a plate to which dust sticks": ["plate.rigid.adhesion=true"],
}
CHOICE_RUNS = {name: impact(4.5, COARSE, more, f"_choice_{number}" if more else "") for number, (name, more) in enumerate(CHOICES.items())}


def runs():
    return list({run.name: run for sweep in (SPACINGS, SWEEP, TURNED, GAMMA, CHOICE_RUNS) for run in sweep.values()}.values())


HEAD = ["slope", "scatter", "mu", "largest", "second", "pieces of 10 and more", "particles", "steps", "core-s"]


def cells(row):
    if row is None:
        return ["not run", *[""] * (len(HEAD) - 1)]
    found = row["fragments"]
    number = lambda key: "–" if found.get(key) is None else f"{found[key]:.3f}"
    return [f"{number('slope')} ± {number('slope_error')}", number("slope_scatter"), number("mu"), number("largest"), number("second_largest"), found["resolved_pieces"],
            row["particles"], row["steps"], f"{row['core_seconds']:.0f}"]


def write(known):
    lines = [[k, *cells(known.get(run.name)), *(f"{x:.3f}" for x in PAPER[k])] for k, run in SWEEP.items()]
    spacings = [[key, *cells(known.get(run.name)), *(f"{x:.3f}" for x in PAPER[4.5])] for key, run in SPACINGS.items()]
    head = ["K_0, kPa", *HEAD, "paper: slope", "mu"]
    parts = [
        TEXT, page.table(["l_c, um", *head[1:]], spacings), f"Over the bulk modulus, at l_c = {COARSE} um:", page.table(head, lines),
        f"Other orientations of the lattice, at {TURNED_AT} um, K_0 = 4.5 kPa:", page.table(["seed", *HEAD], [[key, *cells(known.get(run.name))] for key, run in TURNED.items()]),
        GAMMA_TEXT, page.table(["gamma", *HEAD], [[key, *cells(known.get(run.name))] for key, run in GAMMA.items()]),
    ]
    parts += [CHOICE_TEXT, page.table(["choice", *HEAD], [[key, *cells(known.get(run.name))] for key, run in CHOICE_RUNS.items()])]
    draw(known)
    return [*parts, "![Slope over the bulk modulus](dust_fragmentation.png)"], []


def draw(known):
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.4))
    for axis, key, paper in zip(axes, ("slope", "largest"), (0, 1)):
        points = [(k, known[run.name]["fragments"].get(key)) for k, run in SWEEP.items() if run.name in known]
        points = [point for point in points if point[1] is not None]
        if points:
            axis.plot(*zip(*points), "o-", label=f"ours, {COARSE} um")
        axis.plot(list(PAPER), [value[paper] for value in PAPER.values()], "kx", label="paper")
        axis.axhline((0.67, 0.22)[paper], color="0.5", linestyle="--", label="experiment")
        axis.set(xlabel="K_0, kPa", ylabel=("slope of the cumulative mass", "share of the largest")[paper])
        axis.grid(True, alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.tight_layout()
    page.save(figure, "dust_fragmentation.png")


TEXT = """## Fragmentation

`inputs/dust_fragmentation.toml`: an aggregate of 0.57 mm, filling factor 0.35, at 8.4 m/s on a rigid plate, after 0.8 ms; the mass in pieces
up to m is fitted by F = (m / mu)^slope, masses over that of all; pieces are apart where particles are farther than 2 h from each other. Experiments: a slope of 0.67, 0.22 of the mass in the largest. The paper's l_c is 8 um:"""
GAMMA_TEXT = f"""The exponent gamma of K = K_0 (rho / rho_i)^gamma, at {COARSE} um. Dust that is hit at 8.4 m/s is pressed to a filling factor of 0.63 within 0.03 ms with
gamma = 4, beyond phi_2 = 0.58, at 120 kPa: K is about 1 MPa there, so that its reference, which is what stays of compaction, ends at 0.55. It
spreads along the plate at 3 m/s, and the rim of this splash tears into small pieces. With gamma = 6 it is pressed to 0.57, keeps all of that,
and is slowed to less than 2 m/s within 0.16 ms. The paper's aggregate is compacted to 0.58 and fractures there (its Fig. 20):"""
CHOICE_TEXT = f"""What else they depend on, at {COARSE} um. In the paper the plate has the sound of glass, 1400 m/s, in the viscosity of its pairs with dust, and brakes
what slides along it; here it has none, and alpha = 51 at the plate stands for it (half of 1400 m/s over the 14 m/s of this dust):"""
