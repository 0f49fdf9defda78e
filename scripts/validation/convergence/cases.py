"""What is compared with exact solutions: a scene over three or four spacings, and what is asked of its errors."""

import dataclasses

from common.runs import Run
from validation.plates import slab, wave


@dataclasses.dataclass
class Measure:
    """A key of summary.json's `errors`. `bound` holds at the finest spacing, for the reason given."""

    key: str
    label: str
    bound: float
    reason: str
    reference: float = None
    unit: str = ""


@dataclasses.dataclass
class Case:
    name: str
    label: str
    scene: str
    spacings: list
    settings: object
    """Function of the spacing."""
    measures: list
    fitted: str = None
    """The measure whose order is drawn; the first if not given."""

    def runs(self):
        return [Run(f"{self.name}/{d:g}", f"exact/{self.scene}.toml", self.settings(d)) for d in self.spacings]


SHOCK = "a shock is 2 to 3 h wide: order 1 at most in L1"
OFFSET = "a front starts about a spacing late and stays so: order 1"
HEATING = "wall heating at the contact, a few h wide: order 1"
SURFACE = "a free surface is soft over about a spacing: order 1"
LATTICE = "order 2 down to the 0.1 per cent by which sums over this lattice are off"


def ball(name, spacing, dimension):
    return [f"dimension={dimension}", f"{name}.spacing={spacing}"]


def sod(dimension):
    bodies = {"driver": (-0.6, 0.0, None), "driven": (0.0, 0.6, None)}
    return Case(
        f"sod_{dimension}d", f"Sod, {dimension}D", "sod", [0.01, 0.005, 0.0025] if dimension == 2 else [0.02, 0.01, 0.005],
        lambda d: slab(bodies, d, dimension, rows=14),
        [
            Measure("density_l1", "density, L1", 0.004 if dimension == 2 else 0.01, SHOCK),
            Measure("plateau_2_stress", "pressure, left of the contact", 0.01 if dimension == 2 else 0.03, "sums over a compressed lattice", 0.303130, "Pa"),
            Measure("plateau_2_velocity", "velocity there", 0.01, "as for pressure", 0.927453, "m/s"),
            Measure("front_2_speed", "speed of the shock", 0.015, OFFSET, 1.752156, "m/s"),
        ],
    )


def sedov(dimension):
    # In the plane a small ball's jets go further, and there is room for a larger one.
    start, viscosity = {2: (6, "{ alpha = 3, beta = 6 }"), 3: (4, "{ alpha = 2, beta = 4 }")}[dimension]
    radius = {2: 0.631955, 3: 0.711501}[dimension]
    bounds = {2: (0.04, 0.02), 3: (0.08, 0.02)}[dimension]
    return Case(
        f"sedov_{dimension}d", f"Sedov, {dimension}D", "sedov", [0.04, 0.02, 0.01] if dimension == 2 else [0.1, 0.07, 0.05],
        lambda d: ball("gas", d, dimension) + [f"gas.blast={{ energy = 1, radius = {start * d:g} }}", f"material.gas.viscosity={viscosity}"],
        [
            Measure("density_l1", "density, L1", bounds[0], SHOCK + "; density by continuity drifts where particles are in disorder"),
            Measure("front_1_speed", "radius of the shock", bounds[1], "the start in a ball of some spacings", radius, "m"),
        ],
    )


def noh(dimension):
    # Less viscosity where few spacings lie between shock and centre: it heats what converges before the shock.
    viscosity = {2: "{ alpha = 2, beta = 4 }", 3: "{ alpha = 1, beta = 1 }"}[dimension]
    bounds = {2: (0.04, 0.04), 3: (0.15, 0.2)}[dimension]
    return Case(
        f"noh_{dimension}d", f"Noh, {dimension}D", "noh", [0.04, 0.02, 0.01] if dimension == 2 else [0.1, 0.07, 0.05, 0.035],
        lambda d: ball("gas", d, dimension) + [f"material.gas.viscosity={viscosity}"],
        [
            Measure("density_l1", "density, L1", bounds[0], SHOCK + "; wall heating at the centre"),
            Measure("front_1_speed", "speed of the shock", bounds[1], "the shock has passed few spacings", 1 / 3, "m/s"),
        ],
    )


def standing_wave(kind, dimension, speed):
    return Case(
        f"wave_{kind}_{dimension}d", f"{kind} wave, {dimension}D", f"wave_{kind}",
        [0.1, 0.05, 0.025, 0.0125] if dimension == 2 else [0.1, 0.05, 0.025],
        lambda d: wave(d, dimension),
        [Measure("frequency", "wave speed", 0.003 if dimension == 2 else 0.007, LATTICE, speed, "m/s"), Measure("damping", "amplitude lost per radian", 1e-4, "time steps, nothing else damps")],
    )


def piston(dimension):
    velocity = '["100 m/s", 0]' if dimension == 2 else '["100 m/s", 0, 0]'
    return Case(
        f"piston_{dimension}d", f"piston, {dimension}D", "piston_aluminium",
        [0.01, 0.005, 0.0025] if dimension == 2 else [0.02, 0.01, 0.005],
        lambda d: slab({"rod": (-6 * max(d, 0.01), 1.0, None)}, d, dimension) + [f"layer.0.motion={{ velocity = {velocity} }}"],
        [
            Measure("stress_l1", "stress, L1", 0.03 if dimension == 2 else 0.04, SHOCK),
            Measure("plateau_1_stress", "stress at the piston", 0.004, LATTICE, 1.57315e9, "Pa"),
            Measure("plateau_2_stress", "elastic limit", 0.02, "the plastic front is weak, hence wide, and reaches into the precursor", 6.3279e8, "Pa"),
            Measure("front_1_speed", "speed of the plastic front", 0.03, OFFSET, 5479.1, "m/s"),
            Measure("front_2_speed", "speed of the precursor", 0.01, OFFSET, 6443.7, "m/s"),
        ],
    )


def flyer(material, dimension, stress, speed):
    return Case(
        f"flyer_{material}_{dimension}d", f"flyer of {material} at 4 km/s, {dimension}D", f"flyer_{material}",
        [0.02, 0.01, 0.005, 0.0025] if dimension == 2 else [0.02, 0.01, 0.005],
        lambda d: slab({"flyer": (-0.4, 0.0, 4000), "target": (0.0, 0.4, None)}, d, dimension),
        [
            Measure("stress_l1", "pressure, L1", 0.04, SHOCK),
            Measure("plateau_2_stress", "pressure", 0.005, "sums over a compressed lattice", stress, "Pa"),
            Measure("plateau_2_internal_energy", "internal energy", 0.08, HEATING, 2e6, "J/kg"),
            Measure("front_2_speed", "speed of the shock", 0.02, OFFSET, speed, "m/s"),
        ],
    )


def release(material, dimension, velocity, energy):
    return Case(
        f"release_{material}_{dimension}d", f"release of {material}, {dimension}D", f"release_{material}", [0.02, 0.01, 0.005],
        lambda d: slab({"flyer": (-0.4, 0.0, 2000), "target": (0.0, 0.3, None)}, d, dimension),
        [
            Measure("velocity_l1", "velocity, L1", 0.01, SURFACE),
            Measure("plateau_1_velocity", "velocity of the free surface", 0.01, "required: 1 per cent", velocity, "m/s"),
            Measure("plateau_1_internal_energy", "residual energy", 0.25, "a small difference of heating and release, to which the smeared shock adds: order 1", energy, "J/kg"),
        ],
    )


def sphere(kind, dimension, period):
    bounds = {("radial", 2): 0.01, ("torsional", 2): 0.01, ("radial", 3): 0.015, ("torsional", 3): 0.03}[kind, dimension]
    return Case(
        f"sphere_{kind}_{dimension}d", f"{kind} mode of a {'disc' if dimension == 2 else 'sphere'}", f"sphere_{kind}",
        [0.1, 0.05, 0.025] if dimension == 2 else [0.2, 0.1, 0.05],
        lambda d: ball("sphere", d, dimension),
        [Measure("frequency", "frequency", bounds, SURFACE, 1 / period, "Hz"), Measure("damping", "amplitude lost per radian", 1e-3, "time steps, nothing else damps")],
    )


def spin(dimension):
    rate = "182.2" if dimension == 2 else '["0 rad/s", "0 rad/s", "182.2 rad/s"]'
    return Case(
        f"spin_{dimension}d", f"spin, {dimension}D", "spin", [0.2, 0.1, 0.05] if dimension == 2 else [0.3, 0.2, 0.14],
        lambda d: ball("sphere", d, dimension) + [f"sphere.spin={rate}"],
        [Measure("angular_momentum_per_turn", "angular momentum lost per turn, over ten", 1e-6, "second moments of neighbourhoods are followed to the second order of the step")],
    )


CANTILEVER = Case(
    "cantilever", "cantilever, 2D", "cantilever", [0.004, 0.002, 0.001, 0.0007],
    lambda d: [f"plate.spacing={d}", 'run.until="0.13 s"'],
    [Measure("frequency", "frequency", 0.08, "two free surfaces, each soft over about a spacing, and stiffness goes with the cube of thickness; a thick plate is slower by 2 to 3 per cent", 1 / 0.2541, "Hz")],
)

CASES = [
    *map(sod, (2, 3)),
    *map(sedov, (2, 3)),
    *map(noh, (2, 3)),
    *(standing_wave("longitudinal", n, 4593.3) for n in (2, 3)),
    *(standing_wave("shear", n, 2899.6) for n in (2, 3)),
    *map(piston, (2, 3)),
    *(flyer("aluminium", n, 4.41857e10, 8182.5) for n in (2, 3)),
    *(flyer("basalt", n, 3.40090e10, 6298.0) for n in (2, 3)),
    *(release("aluminium", n, 2007.10, 5.9692e4) for n in (2, 3)),
    *(release("basalt", n, 2018.5, 8.254e4) for n in (2, 3)),
    *(sphere("radial", n, p) for n, p in ((2, 1 / 1452.16), (3, 5.704e-4))),
    *(sphere("torsional", n, p) for n, p in ((2, 1 / 2370.02), (3, 8.664e-4))),
    CANTILEVER,
    *map(spin, (2, 3)),
]
