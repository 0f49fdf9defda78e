"""A bar that is pulled apart, inputs/tensile_bar.toml at several strain rates, beside single elements."""

import h5py
import matplotlib.pyplot as plt
import numpy

from common.page import percent, table
from common.runs import Run
from validation.fracture import basalt
from validation.fracture.elements import save

POISSON = 0.1688
"""Of basalt."""
RATES = {100: (0.1, 1.8e-5), 300: (0.1, 5.7e-6), 1000: (0.05, 2e-6), 3000: (0.05, 1.2e-6), 10000: (0.02, 6e-7)}
"""Strain rate, 1/s: Courant number, which makes some hundred steps of it, and end, s."""


def settings(rate):
    cfl, until = RATES[rate]
    return [
        f"bar.flow={{ stretch = [{rate}, {-POISSON * rate:g}, {-POISSON * rate:g}] }}",
        f"layer.0.motion={{ velocity = [{-0.017 * rate:g}, 0, 0] }}",
        f"layer.1.motion={{ velocity = [{0.017 * rate:g}, 0, 0] }}",
        f"numerics.cfl={cfl}",
        f"run.until={until}",
    ]


def runs():
    calm = Run("fracture/bar_10000_calm", "tensile_bar.toml", settings(10000) + ["numerics.viscosity=false"])
    return [Run(f"fracture/bar_{rate}", "tensile_bar.toml", settings(rate)) for rate in RATES] + [calm]


def curve(run):
    """Times and mean tension along x within 12 mm of the middle, Pa."""
    points = []
    for path in sorted(run.folder.glob("snapshot_*.vtkhdf")):
        with h5py.File(path) as file:
            data, root = file["VTKHDF/PointData"], file["VTKHDF"]
            middle = abs(root["Points"][:, 0]) < 0.012
            intact, pressure = 1 - data["damage"][:], data["pressure"][:]
            tension = intact * data["deviatoric_stress"][:, 0] - numpy.where(pressure < 0, intact, 1) * pressure
            points.append((root["run"].attrs["time"] if "run" in root else file["run"].attrs["time"], tension[middle].mean()))
    return numpy.array(points).T


def write():
    found = {run.name.rsplit("bar_")[1]: run for run in runs()}
    particles = found["1000"].result()["particles"]
    edge = (40e-3 * 10e-3 * 10e-3 / particles) ** (1 / 3)
    figure, axis = plt.subplots(figsize=(5.2, 3.7))
    rows = []
    for rate in RATES:
        times, tension = curve(found[str(rate)])
        element, error = basalt.strength(rate, edge, particles)
        peak = tension.max()
        rows.append((rate, f"{peak / 1e6:.1f}", f"{element / 1e6:.1f} ± {error / 1e6:.1f}", percent(peak / element - 1), found[str(rate)].result()["steps"]))
        line = axis.plot(1e3 * rate * times, tension / 1e6, label=f"bar, {rate} 1/s")[0]
        axis.axhline(element / 1e6, color=line.get_color(), linestyle=":", linewidth=1)
    axis.set(xlabel="strain (1e-3)", ylabel="mean tension (MPa); dots: elements")
    save(figure, [axis], "fracture_bar")
    calm = curve(found["10000_calm"])[1].max()
    return "\n\n".join(
        [
            f"`inputs/tensile_bar.toml`: 40 x 10 x 10 mm, {particles} particles of 1 mm^3 with the whole program (Tillotson, strength, "
            "viscosity, corrected gradient), held at its ends by layers of 3 mm that move apart, sides free. The elements are as many and as large, "
            "solved without time steps.",
            table(["rate (1/s)", "bar, strength (MPa)", "elements (MPa)", "difference", "steps"], rows),
            f"Without artificial viscosity the bar at 1e4 1/s has {calm / 1e6:.1f} MPa. The slower the pull, the more waves carry load from "
            "particles that break to their neighbours (a wave passes six particles while one flaw breaks one), so that the bar falls below elements, "
            "each of which is stretched alike whatever the others do.",
            "![A bar that is pulled apart](fracture_bar.png)",
        ]
    )
