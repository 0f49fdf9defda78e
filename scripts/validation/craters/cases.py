"""What is run: variants of two scenes over resolution."""

from common.runs import Run

# Between particles near the impact, cm; shells around them are two and four times coarser.
DEEP_IMPACT = [56, 40, 28]
COMPACTION = [50, 35, 25]

RHO_ALPHA = ["material.{}.porosity.p_alpha=false", "material.{}.porosity.rho_alpha.quadratic=true"]
SOLID_ICE = ["material.ice.porosity=false", 'material.ice.eos.tillotson.rho_0="305.67 kg/m^3"', "material.ice.viscosity.speed=sound"]


# Ground that holds tension as the crystal does, and ground that holds none.
WHOLE = [f"{body}.damage=0" for body in ("near", "middle", "far")]
BROKEN = [f"{body}.damage=1" for body in ("near", "far")]


def of(material, settings):
    return [setting.format(material) for setting in settings]


DEEP_IMPACT_VARIANTS = {
    "P-alpha": [],
    "rho-alpha": of("ice", RHO_ALPHA),
    "solid": SOLID_ICE,
    "P-alpha, holds tension": WHOLE,
    "solid, holds tension": [*SOLID_ICE, *WHOLE],
    "P-alpha, P_e = 0.5 MPa": ['material.ice.porosity.p_alpha.quadratic.P_e="0.5 MPa"'],
}
# Of what is not run at all spacings, those at which it is, cm.
ONLY = {
    "rho-alpha": DEEP_IMPACT[:2],
    "P-alpha, P_e = 0.5 MPa": [40],
}
COMPACTION_VARIANTS = {
    "P-alpha": [],
    "rho-alpha": of("basalt", RHO_ALPHA),
    "epsilon-alpha": of("basalt", ["material.{}.porosity.p_alpha=false", "material.{}.porosity.epsilon_alpha=true"]),
    "P-alpha, soft": of("basalt", ['material.{}.porosity.p_alpha.quadratic.P_s="10 MPa"']),
}
LAWS = list(COMPACTION_VARIANTS)
for law in LAWS:
    COMPACTION_VARIANTS[f"{law}, broken"] = COMPACTION_VARIANTS[law] + BROKEN


def deep_impact(variant, spacing):
    shells = [("near", 1), ("middle", 2), ("far", 4)]
    settings = [f'{body}.spacing="{factor * spacing} cm"' for body, factor in shells]
    return Run(f"craters/deep_impact_{slug(variant)}_{spacing}cm", "deep_impact.toml", DEEP_IMPACT_VARIANTS[variant] + settings, guess=price("deep_impact", spacing))


def compaction(variant, spacing):
    settings = [f'{body}.spacing="{factor * spacing} cm"' for body, factor in [("near", 1), ("far", 2)]]
    return Run(f"craters/compaction_{slug(variant)}_{spacing}cm", "compaction_models.toml", COMPACTION_VARIANTS[variant] + settings, guess=price("compaction", spacing))


def slug(variant):
    return variant.replace(", ", "_").replace("-", "_").replace(" = ", "_").replace(" ", "_")


# Core-seconds of the coarsest run of a scene, as measured; halving the spacing takes ten times as long, with twice the steps.
COARSEST = {"deep_impact": 60, "compaction": 40}


def price(scene, spacing):
    """Predicted core-seconds."""
    coarsest = {"deep_impact": DEEP_IMPACT, "compaction": COMPACTION}[scene][0]
    return COARSEST[scene] * (coarsest / spacing) ** 3.3


def spacings(scene, variant):
    """At which a variant is run, cm."""
    if scene == "deep_impact":
        return ONLY.get(variant, DEEP_IMPACT)
    return COMPACTION[:1] if variant.endswith("broken") else COMPACTION


def all_runs():
    """The cheapest first."""
    found = [deep_impact(v, s) for v in DEEP_IMPACT_VARIANTS for s in spacings("deep_impact", v)]
    found += [compaction(v, s) for v in COMPACTION_VARIANTS for s in spacings("compaction", v)]
    return sorted(found, key=lambda run: run.guess)
