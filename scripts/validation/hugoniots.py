"""Plane impacts at several speeds: pressure and shock speed against the jump conditions and against measured rocks and metals."""

import tomllib

from common import page
from common.runs import ROOT, Run
from validation.plates import slab

TITLE = "Hugoniots"

SPEEDS = [1, 2, 4, 6, 8]
SPACING = {2: 0.0025, 3: 0.004}
"""Of a dimension, m."""
BOUND = {2: 0.015, 3: 0.02}
DATA = {
    # U_s = c + s u_p, km/s: measured, not of this equation of state.
    "aluminium": (5.386, 1.339, "Steinberg 1996, as carried in Spheral"),
    "basalt": (3.5, 1.3, "Nakazawa et al. 2002, Kinosaki basalt"),
}


UNITS = {"GPa": 1e9, "dyn/cm^2": 0.1, "kg/m^3": 1.0, "J/kg": 1.0, "erg/g": 1e-4}


def number(value):
    """A quantity of the library in SI units."""
    if isinstance(value, str):
        digits, unit = value.split()
        return float(digits) * UNITS[unit]
    return float(value)


def tillotson(material):
    """Pressure (Pa) of compressed matter at a density and an energy."""
    law = tomllib.loads((ROOT / "src/material/library.toml").read_text())[material]["eos"]["tillotson"]
    a, b, first, second = law["a"], law["b"], number(law["A"]), number(law["B"])
    rest, energy_0 = number(law["rho_0"]), number(law["E_0"])

    def pressure(density, energy):
        eta = density / rest
        return (a + b / (energy / (energy_0 * eta * eta) + 1)) * density * energy + first * (eta - 1) + second * (eta - 1) ** 2

    return rest, pressure


def shock(material, particle_speed):
    """Jump conditions by bisection in density: (pressure, Pa; shock speed, m/s)."""
    rest, pressure = tillotson(material)
    energy = 0.5 * particle_speed**2
    # The momentum that the jump asks for at this compression, against what the law gives.
    low, high = rest * (1 + 1e-9), 8 * rest
    for _ in range(200):
        density = 0.5 * (low + high)
        needed = rest * particle_speed**2 / (1 - rest / density)
        low, high = (low, density) if pressure(density, energy) > needed else (density, high)
    return pressure(density, energy), particle_speed / (1 - rest / density)


def run(material, speed, dimension):
    _, wave = shock(material, 500 * speed)
    until = 0.3 / wave
    settings = slab({"flyer": (-0.4, 0.0, 1000 * speed), "target": (0.0, 0.4, None)}, SPACING[dimension], dimension)
    return Run(f"hugoniot_{material}_{dimension}d/{speed}", f"exact/flyer_{material}.toml", settings + [f"run.until={until:.6g}", "output.picture=false"])


def runs():
    return [run(material, speed, dimension) for material in DATA for speed in SPEEDS for dimension in SPACING]


def write(found):
    lines, failures = [], []
    for material, (c, s, _) in DATA.items():
        for speed in SPEEDS:
            pressure, wave = shock(material, 500 * speed)
            measured = c + s * 0.5 * speed
            ours = {}
            for dimension, bound in BOUND.items():
                errors = found[run(material, speed, dimension).name]["errors"]
                ours[dimension] = bulk = errors["plateau_2_stress"], errors["front_2_speed"]
                if max(map(abs, bulk)) > bound:
                    failures.append(f"{material} at {speed} km/s, {dimension}D: pressure {bulk[0]:.4f}, shock {bulk[1]:.4f} (allowed: {bound})")
            of_pressure, of_speed = ([page.percent(bulk[k]) for bulk in ours.values()] for k in (0, 1))
            finest = wave * (1 + ours[2][1])
            lines.append(
                [material, speed, f"{pressure / 1e9:.3f}", f"{pressure / 1e9 * (1 + ours[2][0]):.3f}", *of_pressure, f"{wave:.0f}", f"{finest:.0f}", *of_speed,
                 f"{1000 * measured:.0f}", page.percent(finest / 1000 / measured - 1)]
            )
    head = ["material", "impact km/s", "P exact GPa", "ours, 2D", "error 2D", "error 3D", "U_s exact m/s", "ours, 2D", "error 2D", "error 3D", "U_s of the fit to data", "ours to data"]
    sources = "; ".join(f"{material}: U_s = {c} + {s} u_p km/s, {source}" for material, (c, s, source) in DATA.items())
    text = f"""A plate hits a plate of the same material, until the shock has passed 30 cm, spacing {1000 * SPACING[2]:g} mm in 2D and {1000 * SPACING[3]:g} mm in 3D. Exact are the
jump conditions with the scene's equation of state, solved here once more. Tolerance {page.percent(BOUND[2])} in 2D and {page.percent(BOUND[3])} at the wider
spacing in 3D: the shock starts about a spacing late, and sums over a compressed lattice are off by about one per cent.

{page.table(head, lines)}

The last column is Tillotson's law against measurements, not an error of the program. Data: {sources}."""
    return text, failures
