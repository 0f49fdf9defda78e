"""A column of pumice is pressed together: does it give its crush curve back (Jutzi, Benz & Michel 2008, section 5.2)?"""

import csv
import math

import matplotlib.pyplot as plt

from common import page
from common.runs import Run

TITLE = "The crush curve of pumice"

LAWS = {
    "P-alpha": [],
    "rho-alpha": ["material.pumice.porosity.p_alpha=false", "material.pumice.porosity.rho_alpha.two_slope=true"],
}
MATRIX = 2327.0
"""Density of the matrix without load, kg/m^3: an experiment states distention as this over the density."""
RANGE = (1.2e6, 2e8)
"""Where the curve is compared: above P_e and below P_s, Pa."""
CURVE, EVEN, DRIFT = 0.01, 0.02, 1e-3


def curve(p):
    """Distention at a pressure, Pa: Jutzi et al. 2008, eq. 21 and table 2."""
    p_e, p_t, p_s, alpha_t, alpha_0 = 1e6, 6.8e7, 2.13e8, 1.9, 4.64
    p = max(p, p_e)
    slow = 1.0 + (alpha_t - 1.0) * (max(p_s - p, 0.0) / (p_s - p_e)) ** 3
    return slow + (alpha_0 - alpha_t) * (max(p_t - p, 0.0) / (p_t - p_e)) ** 12


def run(law):
    return Run(f"crush/{law.replace('-', '_')}", "crush_curve.toml", LAWS[law])


def runs():
    return [run(law) for law in LAWS]


def history(law):
    """Rows of (pressure, matrix density over density, distention, its scatter) of the sample."""
    with open(run(law).folder / "history.csv") as file:
        rows = csv.DictReader(file)
        keys = ["sample_pressure [Pa]", "sample_density [kg/m^3]", "sample_distention", "sample_distention_scatter"]
        found = [tuple(float(row[key]) for key in keys) for row in rows]
    return [(p, MATRIX / rho, alpha, scatter) for p, rho, alpha, scatter in found if RANGE[0] < p < RANGE[1]]


def pressure_at(rows, alpha):
    """Pressure at which the distention comes down to a value, Pa."""
    for (p, _, a, _), (q, _, b, _) in zip(rows, rows[1:]):
        if a >= alpha > b:
            return p + (q - p) * (a - alpha) / (a - b)
    return math.nan


def write(found):
    failures, lines = [], []
    for law in LAWS:
        rows, summary = history(law), found[run(law).name]
        seen = max(abs(seen / curve(p) - 1) for p, seen, _, _ in rows)
        own = max(abs(alpha / curve(p) - 1) for p, _, alpha, _ in rows)
        scatter = max(scatter / alpha for _, _, alpha, scatter in rows)
        heat = [pressure_at(rows, alpha) for alpha in (3.0, 1.5)]
        exact = [pressure_at([(p, 0, curve(p), 0) for p in [1e6 * 1.002**k for k in range(2700)]], a) for a in (3.0, 1.5)]
        drift = summary["energy_drift"]
        lines.append([law, len(rows), page.percent(seen), page.percent(own), page.percent(scatter)]
                     + [page.percent(p / e - 1) for p, e in zip(heat, exact)]
                     + [f"{drift:.1e}", summary["steps"], f"{summary['core_seconds']:.3g}"])
        judged = [("scatter", scatter, EVEN), ("energy drift", drift, DRIFT)] + ([("curve", own, CURVE)] if law == "P-alpha" else [])
        failures += [f"crush curve, {law}: {what} {value:.4f} (allowed: {most})" for what, value, most in judged if value > most]
    draw()
    head = ["law", "rows", "by density", "by distention", "scatter", "P at alpha = 3", "P at alpha = 1.5", "energy drift", "steps", "core-s"]
    text = f"""`inputs/crush_curve.toml`: a column that becomes 4.6 times shorter. Largest error against the curve that was put in, between {RANGE[0] / 1e6:g} and
{RANGE[1] / 1e6:g} MPa: of the distention that an experiment would give from the density, and of the particles' own; how unevenly it is crushed; and
by how much the pressure at a distention is above the curve's. Required of P-alpha: {page.percent(CURVE)} and a scatter of {page.percent(EVEN)}. With rho-alpha
the curve is entered with the pressure of cold matter, so that pressure lies above it by its thermal part, from the work of crushing; this is no error.
The error by density is larger than that by distention where the matrix itself is compressed.

{page.table(head, lines)}

![Crush curve](crush_curve.png)"""
    return text, failures


def draw():
    figure, (whole, tail) = plt.subplots(1, 2, figsize=(11, 4.6))
    pressures = [1e6 * 1.01**k for k in range(560)]
    for axes in (whole, tail):
        axes.plot([p / 1e6 for p in pressures], [curve(p) for p in pressures], "k-", lw=1.2, label="put in")
        for law, colour in zip(LAWS, ("C0", "C3")):
            rows = history(law)[::6]
            axes.plot([p / 1e6 for p, *_ in rows], [alpha for _, _, alpha, _ in rows], ".", ms=4, color=colour, label=law)
        axes.set(xlabel="pressure [MPa]", ylabel="distention")
    whole.set_xscale("log")
    tail.set(xlim=(0, 220), ylim=(1, 2))
    whole.legend()
    page.save(figure, "crush_curve.png")
