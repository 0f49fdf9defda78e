"""A dust aggregate bounces off a plate (Sect. 5.2, Fig. 18)."""

import matplotlib.pyplot as plt

from common import page
from common.runs import Run
from validation.dust.compaction import SIRONO

SCENE = "dust_bouncing.toml"
MODULI = {0.26: (1, 2, 5, 10, 20, 100, 500), 1.3: (1, 5, 20, 100, 300)}
"""kPa, by p_m in kPa."""


def bounce(p_m, modulus, spacing=25, more=(), name=""):
    own = [f'{SIRONO}.compression.powder.p_m="{p_m} kPa"', f'{SIRONO}.K_0="{modulus} kPa"']
    if spacing != 25:
        own += [f'aggregate.spacing="{spacing} um"', f'plate.spacing="{spacing} um"', f'aggregate.position=[0,0,"{0.5 + 1e-3 * spacing:g} mm"]']
    guess = 100 * (modulus / 5) ** 0.5 * (25 / spacing) ** 4
    return Run(f"dust/bounce{name}_{p_m}_{modulus}_{spacing:g}um", SCENE, [*own, *more], guess=guess)


SWEEP = {(p_m, modulus): bounce(p_m, modulus) for p_m, moduli in MODULI.items() for modulus in moduli}
SPACINGS = {spacing: bounce(0.26, 5, spacing) for spacing in (50, 25, 12.5)}
FROM_AFAR = {spacing: bounce(0.26, 5, spacing, ['aggregate.position=[0,0,"0.7 mm"]'], "_from_afar") for spacing in (50, 25)}
GAMMA = {gamma: bounce(0.26, 5, 50, [] if gamma == 4 else [f"{SIRONO}.gamma={gamma}"], "" if gamma == 4 else f"_gamma_{gamma}") for gamma in (2, 3, 4, 5, 6)}
CHOICES = {
    "as it is": [], "CFL 0.25": ["numerics.cfl=0.25"], "h / l_c = 2.8 (eta 1.4)": ["numerics.eta=1.4"], "h / l_c = 5.6 (eta 2.8)": ["numerics.eta=2.8"],
    "no viscosity": ["numerics.contact_viscosity=false", "material.silica_dust.viscosity.alpha=0"], "alpha = 0.5": ["material.silica_dust.viscosity.alpha=0.5"],
    "no contact viscosity": ["numerics.contact_viscosity=false"], "alpha = 5 at the plate": ["material.glass.viscosity.alpha=5"], "alpha = 25 at the plate": ["material.glass.viscosity.alpha=25"], "shear as printed (eqs. 10, 18)": [f"{SIRONO}.shear_as_printed=true"],
    "plasticity after unloading (variant 2)": [f'{SIRONO}.plasticity="after_unloading"'], "close-packed": ['aggregate.lattice="hcp"'],
    "tensile strength, a tenth": [f'{SIRONO}.tension.T_0="63 Pa"'], "tensile strength, ten times": [f'{SIRONO}.tension.T_0="6.3 kPa"'],
    "a plate to which dust sticks": ["plate.rigid={ adhesion = true }"],
}
CHOICE_RUNS = {name: bounce(0.26, 5, 50, more, f"_choice_{number}" if more else "") for number, (name, more) in enumerate(CHOICES.items())}
VARIANTS = {"at once": bounce(0.26, 5), "after unloading": bounce(0.26, 5, 25, [f'{SIRONO}.plasticity="after_unloading"'], "_variant_2")}
PAPER = {(0.26, 5): "0.19", (0.26, 500): "0.09", (1.3, 1): "0.7", (1.3, 20): "0.2", (1.3, 300): "0.13"}


def runs():
    return list({run.name: run for sweep in (SPACINGS, FROM_AFAR, CHOICE_RUNS, VARIANTS, GAMMA, SWEEP) for run in sweep.values()}.values())


HEAD = ["restitution", "energy lost", "contact", "particles", "steps", "core-s"]


def cells(row):
    if row is None:
        return ["not run", *[""] * (len(HEAD) - 1)]
    found = row.get("restitution") or {}
    if found.get("coefficient") is None:
        return ["none: they stick", "", "", row["particles"], row["steps"], f"{row['core_seconds']:.0f}"]
    time = 1e3 * (found["contact_end"] - found["contact_begin"]) if found.get("contact_end") else float("nan")
    return [f"{found['coefficient']:.3f}", f"{100 * found['energy_loss']:.1f} %", f"{time:.2f} ms", row["particles"], row["steps"], f"{row['core_seconds']:.0f}"]


def write(known):
    sweep = [[p_m, k, *cells(known.get(run.name)), PAPER.get((p_m, k), "")] for (p_m, k), run in SWEEP.items()]
    parts = [
        TEXT, page.table(["p_m, kPa", "K_0, kPa", *HEAD, "paper"], sweep),
        "Over the spacing, p_m = 0.26 kPa, K_0 = 5 kPa:", page.table(["l_c, um", *HEAD], [[key, *cells(known.get(run.name))] for key, run in SPACINGS.items()]),
        AFAR_TEXT, page.table(["l_c, um", *HEAD], [[key, *cells(known.get(run.name))] for key, run in FROM_AFAR.items()]),
        GAMMA_TEXT, page.table(["gamma", *HEAD], [[key, *cells(known.get(run.name))] for key, run in GAMMA.items()]),
        CHOICE_TEXT, page.table(["choice", *HEAD], [[key, *cells(known.get(run.name))] for key, run in CHOICE_RUNS.items()]),
        VARIANTS_TEXT, page.table(["plasticity", *HEAD], [[key, *cells(known.get(run.name))] for key, run in VARIANTS.items()]),
    ]
    draw(known)
    return [*parts, "![Restitution over the bulk modulus](dust_bouncing.png)"], []


def draw(known):
    figure, axis = plt.subplots(figsize=(5, 3.6))
    for number, wanted in enumerate(MODULI):
        points = [(k, (known.get(run.name) or {}).get("restitution")) for (p_m, k), run in SWEEP.items() if p_m == wanted]
        points = [(k, found["coefficient"]) for k, found in points if found and found.get("coefficient") is not None]
        if points:
            axis.semilogx(*zip(*points), "o-", color=f"C{number}", label=f"p_m = {wanted} kPa")
    paper = [(k, float(value), p_m) for (p_m, k), value in PAPER.items()]
    axis.semilogx([k for k, _, _ in paper], [value for _, value, _ in paper], "kx", label="paper")
    axis.axhline(0.2, color="0.5", linestyle="--", label="experiment")
    axis.set(xlabel="K_0, kPa", ylabel="coefficient of restitution")
    axis.legend(fontsize=8)
    axis.grid(True, alpha=0.3)
    page.save(figure, "dust_bouncing.png")


TEXT = """## Bouncing

`inputs/dust_bouncing.toml`: an aggregate of 1 mm at 0.2 m/s on a rigid plate, l_c = 25 um. Experiments: 0.2, 95 % of the energy lost."""
AFAR_TEXT = """The aggregate starts a spacing above the plate, within its smoothing length: it is touched there, and its contact begins where both are now. From
0.2 mm above the contact begins a support away, as a cushion that gives back what it takes:"""
GAMMA_TEXT = """The exponent gamma of K = K_0 (rho / rho_i)^gamma, which the paper does not print (Sirono 2004 has 4), at 50 um:"""
VARIANTS_TEXT = """Both variants of plasticity at 25 um. Pressure is the same by both on any path (a test); after unloading the moduli lag behind, and with them shear and
the sound in viscosity. A bead's lowest point differs by half a per cent, its peak by 5 (above), the little that a bounce keeps by a third, at
either spacing to the other side:"""
CHOICE_TEXT = """What else the coefficient depends on, at 50 um. In the paper the plate has the sound of glass, 1400 m/s, in the viscosity of its pairs with
dust; here it has none, and a larger alpha of the plate stands for it."""
