"""What each effect costs: an impact with one effect less, or one more, beside the impact itself."""

from speed.impact import interactions, step_seconds, timed

FEW = ["run.steps=60"]
PORES = "quadratic=true"
ELASTIC = f'{PORES},elastic={{c_e="2 km/s",c_0="3145 m/s"}}'

WITHOUT = {
    "viscosity": [*FEW, "numerics.viscosity=false"],
    "corrected_gradient": [*FEW, "numerics.corrected_gradient=false"],
    "angular_momentum": [*FEW, "numerics.angular_momentum=false"],
    "record": [*FEW, "record=false"],
    "fracture": [*FEW, "material.basalt.fracture=false"],
    # Fracture needs strength: beside the run without fracture.
    "strength": [*FEW, "material.basalt.fracture=false", "material.basalt.strength=false"],
}
WITH = {
    "artificial_stress": [*FEW, "numerics.artificial_stress=true"],
    "friction": [*FEW, "material.basalt.strength.collins=true"],
    # The target's pores crush under a projectile without any: another flow, so that it is compared by particle and step.
    "porosity": [*FEW, f"material.basalt.porosity={{p_alpha={{{PORES}}}}}", "projectile.distention=1"],
    "elastic_pores": [*FEW, f"material.basalt.porosity={{p_alpha={{{ELASTIC}}}}}", "projectile.distention=1"],
    "smoothing_length": [*FEW, 'numerics.smoothing_length={follows="density"}'],
    # Its first intervals grow from one step, so that more steps tell what it costs later.
    "gravity": ["run.steps=300", "gravity.self=true"],
    "gravity_every_step": [*FEW, "gravity.self={interval=0}"],
}


def measure(settings):
    """Summaries by effect; `none` is the impact as it is."""
    return {name: timed(f"effect_{name}", own + settings) for name, own in ({"none": FEW} | WITHOUT | WITH).items()}


def table(runs):
    base = runs["none"]
    pairs = next(name for name in base["phases"] if name.startswith("pairs"))
    lines = ["| effect | pair phase with it / without | whole step with it / without | interactions per update with it / without |", "|---|---:|---:|---:|"]
    for name in (*WITHOUT, *WITH):
        other, reference = runs[name], runs["fracture"] if name == "strength" else base
        ratios = [step_seconds(other, part) / step_seconds(reference, part) for part in ((pairs,), None)]
        # An effect that changes the flow changes the number of neighbours, too.
        ratios.append(interactions(other) / interactions(reference))
        ratios = ratios if name in WITH else [1 / ratio for ratio in ratios]
        lines.append(f"| {name} | {' | '.join(f'{ratio:.2f}' for ratio in ratios)} |")
    return "\n".join(lines)
