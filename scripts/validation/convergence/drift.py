"""Noh's implosion in space: the density that particles have integrated beside mass over volume, which it should be."""

import h5py
import numpy
from scipy.spatial import cKDTree

from common import page
from common.runs import Run

SHELL = (0.10, 0.16)
"""Behind the shock and outside of what wall heating has thinned, m."""
END, WITHIN, EXACT = 0.6, 0.35, 64.0
"""Of the scene: its end, s, the ball that is compared, m, and the density behind the shock, kg/m^3."""
CASES = {
    "as in the table": (["material.gas.viscosity={ alpha = 1, beta = 1 }"], [0.05, 0.035]),
    "no corrected gradient": (["material.gas.viscosity={ alpha = 1, beta = 1 }", "numerics.corrected_gradient=false"], [0.05, 0.035]),
    "h not below 0.4 of the first": (
        ["material.gas.viscosity={ alpha = 1, beta = 1 }", 'numerics.smoothing_length={ follows = "density", smallest = 0.4, largest = 1.0 }'],
        [0.05],
    ),
    "alpha 2, beta 4": (["material.gas.viscosity={ alpha = 2, beta = 4 }"], [0.05]),
}


def batch():
    """(what, spacing) -> run."""
    return {
        (label, d): Run(f"drift/{number}_{d:g}", "exact/noh.toml", ["dimension=3", f"gas.spacing={d}", *settings, "output.snapshots=1", "output.picture=false"])
        for number, (label, (settings, spacings)) in enumerate(CASES.items())
        for d in spacings
    }


def runs():
    return list(batch().values())


def kernel(r, h):
    """The cubic spline."""
    q = r / h
    return numpy.where(q < 1, 1 - 1.5 * q**2 + 0.75 * q**3, numpy.where(q < 2, 0.25 * (2 - q) ** 3, 0)) / (numpy.pi * h**3)


def measure(run):
    """Mass over volume of the shell, mean density there, and the L1 error with either density of each particle."""
    with h5py.File(sorted(run.folder.glob("snapshot_*.vtkhdf"))[-1]) as file:
        position, data = file["VTKHDF/Points"][:], file["VTKHDF/PointData"]
        density, mass = data["density"][:], data["mass"][:]
    r = numpy.linalg.norm(position, axis=1)
    shell, ball = (SHELL[0] < r) & (r < SHELL[1]), r < WITHIN
    volume = 4 / 3 * numpy.pi * (SHELL[1] ** 3 - SHELL[0] ** 3)
    # A sum over neighbours, with a smoothing length that follows it.
    distances, _ = cKDTree(position).query(position[ball], k=160)
    summed = density[ball]
    for _ in range(3):
        h = 1.2 * numpy.cbrt(mass[ball] / summed)
        summed = (mass[ball][:, None] * kernel(distances, h[:, None])).sum(axis=1)
    exact = numpy.where(r[ball] < END / 3, EXACT, (1 + END / r[ball]) ** 2)

    def l1(found):
        share = mass[ball] / found
        return (share * abs(found - exact)).sum() / share.sum() / EXACT

    return mass[shell].sum() / volume, density[shell].mean(), l1(density[ball]), l1(summed)


def table():
    head = ["", "spacing (m)", "mass over volume (kg/m^3)", "density by continuity", "too large by", "L1", "L1 of a summed density"]
    rows = []
    for (label, d), run in batch().items():
        true, carried, error, summed = measure(run)
        rows.append((label, f"{d:g}", f"{true:.1f}", f"{carried:.1f}", f"{100 * (carried / true - 1):.0f} %", page.percent(error), page.percent(summed)))
    return page.table(head, rows)
