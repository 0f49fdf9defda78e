"""Opens nbody.bin with REBOUND and compares it with nbody.csv: nbody.py RUN. Then integrates it a little. Prints what it found."""

import csv
import json
import math
import sys
import warnings
from pathlib import Path

import rebound

warnings.simplefilter("error")  # a file of another version, say
run = Path(sys.argv[1])
with open(run / "nbody.csv") as file:
    rows = list(csv.DictReader(file))
archive = rebound.Simulationarchive(str(run / "nbody.bin"))
assert len(archive) == 1, len(archive)
sim = rebound.Simulation(str(run / "nbody.bin"))
summary = json.loads((run / "summary.json").read_text())
assert sim.N == len(rows) == summary["nbody"]["bodies"] > 0, (sim.N, len(rows))
assert sim.G == 6.67430e-11 and sim.t == summary["time"], (sim.G, sim.t)
names = {"m": "mass_kg", "r": "radius_m", "x": "x_m", "y": "y_m", "z": "z_m"}
names |= {f"v{axis}": f"velocity_{axis}_m_s" for axis in "xyz"}
for particle, row in zip(sim.particles, rows):
    for name, column in names.items():
        assert getattr(particle, name) == float(row[column]), (row["label"], name)
masses = [p.m for p in sim.particles]
assert masses == sorted(masses, reverse=True)

# Mass and momentum of the run, which is at rest in this frame.
mass = math.fsum(masses) + summary["nbody"]["left_out_mass"]
assert abs(mass / summary["outcome"]["total_mass"] - 1) < 1e-13, mass
scale = math.fsum(p.m * math.hypot(p.vx, p.vy, p.vz) for p in sim.particles)
for axis in "xyz":
    momentum = math.fsum(p.m * getattr(p, f"v{axis}") for p in sim.particles)
    momentum += summary["nbody"][f"left_out_momentum_{axis}"]
    assert abs(momentum) < 1e-12 * scale, (axis, momentum, scale)

before = sim.energy()
sim.steps(10)
drift = abs(sim.energy() / before - 1)
assert sim.t > summary["time"] and drift < 1e-9, (sim.t, drift)
print(f"{sim.N} bodies, the largest of {masses[0] / mass:.3f} of all mass; REBOUND {rebound.__version__}: "
      f"10 steps to t = {sim.t:.1f} s, energy within {drift:.1e}")
