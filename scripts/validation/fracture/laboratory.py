"""Nakamura & Fujiwara 1991, inputs/nakamura_fujiwara.toml, over resolution, seeds of flaws, and what is uncertain in it."""

import csv

import h5py
import matplotlib.pyplot as plt
import numpy

from common.page import table
from common.runs import Run
from validation.fracture.elements import save

RADIUS = 0.03
OUTWARDS = numpy.array([-numpy.cos(numpy.pi / 6), -numpy.sin(numpy.pi / 6), 0])
"""From the centre to the antipode of the point that is hit."""
CAP = 15
"""Material around the antipode: within so many degrees of it and 0.1 radii of the surface."""
COARSE, MIDDLE = 10000, 30000


def seeded(n, seed):
    return Run(f"fracture/nf_{n}_{seed}", "nakamura_fujiwara.toml", [f"target.particles={n}", f"material.basalt.fracture.seed={seed}"])


def varied(name, *settings, n=MIDDLE):
    return Run(f"fracture/nf_{name}", "nakamura_fujiwara.toml", [f"target.particles={n}", *settings])


SEEDS = {COARSE: (1, 2, 3), MIDDLE: (1, 2, 3), 100000: (1, 2)}
VARIED = {
    "k = 4e35 m^-3, m = 9 (Benz & Asphaug 1999)": varied("ba99", "material.basalt.fracture.weibull_k=4e35", "material.basalt.fracture.weibull_m=9"),
    "k = 5e34 m^-3, m = 8 (Schaefer et al. 2016)": varied("m8", "material.basalt.fracture.weibull_m=8"),
    "nylon without strength": varied("fluid", "material.nylon.strength=false"),
    "lattice turned": varied("turned", "target.orientation={ seed = 1 }"),
    "45 degrees": varied("oblique", 'impact.angle="45 deg"', n=COARSE),
    "viscosity of basalt: alpha 0.5, beta 1": varied("thin", "material.basalt.viscosity={ alpha = 0.5, beta = 1 }", n=COARSE),
    "viscosity of basalt: alpha 3, beta 6": varied("thick", "material.basalt.viscosity={ alpha = 3, beta = 6 }", n=COARSE),
    "yield strength of basalt: 0.35 GPa": varied("soft", "material.basalt.strength.yield_strength=0.35 GPa", n=COARSE),
    "yield strength of basalt: 35 GPa": varied("hard", "material.basalt.strength.yield_strength=35 GPa", n=COARSE),
}


def frictional(n, seed):
    """With the pressure-dependent strength of Jutzi 2015."""
    return Run(f"fracture/nf_friction_{n}_{seed}", "nakamura_fujiwara.toml",
               [f"target.particles={n}", f"material.basalt.fracture.seed={seed}", "material.basalt.strength.collins=true"])


BOTH = [(MIDDLE, 1), (MIDDLE, 2), (MIDDLE, 3)]
"""Resolutions and seeds of flaws for which both strengths are run."""


def runs():
    return [*VARIED.values(), *(seeded(n, seed) for n, seeds in SEEDS.items() for seed in seeds), *(frictional(*both) for both in BOTH)]


def antipode(run):
    """Times and mean velocity of the material around the antipode, away from the centre, m/s."""
    times, speeds, there = [], [], None
    for path in sorted(run.folder.glob("snapshot_*.vtkhdf")):
        with h5py.File(path) as file:
            root, data = file["VTKHDF"], file["VTKHDF/PointData"]
            ids = data["id"][:]
            if there is None:
                position = root["Points"][:]
                distance = numpy.linalg.norm(position, axis=1)
                near = (position @ OUTWARDS > distance * numpy.cos(numpy.radians(CAP))) & (distance > 0.9 * RADIUS) & (ids >> 48 == 0)
                there = ids[near]
            mine = numpy.isin(ids, there)
            mass, velocity = data["mass"][:], data["velocity"][:]
            drift = mass @ velocity / mass.sum()
            times.append(root["run"].attrs["time"] if "run" in root else file["run"].attrs["time"])
            speeds.append(((velocity[mine] - drift) @ OUTWARDS).mean())
    return numpy.array(times), numpy.array(speeds)


def fragments(run):
    """Masses over the target's, largest first, and where the largest one is, over the radius."""
    target = run.result()["outcome"]["target_mass"]
    with open(run.folder / "fragments.csv") as file:
        rows = list(csv.DictReader(file))
    return [float(row["mass_kg"]) / target for row in rows], float(rows[0]["distance_m"]) / RADIUS


def row(label, run):
    found, (masses, offset), (_, speeds) = run.result(), fragments(run), antipode(run)
    outcome = found["outcome"]
    return (
        label, found["particles"], f"{outcome['largest_fragment_fraction']:.3f}", f"{outcome['largest_fragment_fraction_strict']:.3f}",
        f"{offset:.2f}", f"{masses[1]:.3f}", f"{outcome['fragments']:.0f}", f"{outcome['damaged_fraction']:.3f}",
        f"{speeds.max():.1f}", f"{speeds[-1]:.1f}", f"{found['core_seconds']:.0f}",
    )


HEAD = [
    "", "particles", "largest fragment", "the same, D < 0.5", "its distance from the centre / R", "second", "fragments", "mean damage",
    "antipode, largest (m/s)", "at 100 us", "core-s",
]


def write():
    figure, axes = plt.subplots(1, 3, figsize=(13, 3.7))
    colours = dict(zip(SEEDS, ("tab:green", "tab:orange", "tab:blue")))
    for n, seeds in SEEDS.items():
        for seed in seeds:
            run, style = seeded(n, seed), dict(color=colours[n], label=f"{n}" if seed == 1 else None, linewidth=1.5 if seed == 1 else 0.7)
            masses, _ = fragments(run)
            axes[0].loglog(masses, numpy.arange(1, len(masses) + 1), **style)
            times, speeds = antipode(run)
            axes[1].plot(1e6 * times, speeds, **style)
            axes[2].semilogx([n], [run.result()["outcome"]["largest_fragment_fraction"]], "o", color=colours[n])
    axes[0].set(xlabel="mass over that of the target", ylabel="fragments of this mass and more")
    axes[1].set(xlabel="time (us)", ylabel="speed of the antipode (m/s)")
    axes[2].axhline(0.3, color="k", linestyle=":", label="experiment, about")
    axes[2].set(xlabel="particles", ylabel="largest fragment over target", ylim=(0, 0.4))
    save(figure, axes, "fracture_laboratory")
    seeds = [row(f"flaw seed {seed}", seeded(n, seed)) for n, seeds in SEEDS.items() for seed in seeds]
    mean = {n: numpy.mean([seeded(n, seed).result()["outcome"]["largest_fragment_fraction"] for seed in s]) for n, s in SEEDS.items()}
    means = ", ".join(f"{share:.3f} at {n}" for n, share in mean.items())
    return "\n\n".join(
        [
            "`inputs/nakamura_fujiwara.toml`: a ball of basalt of 3 cm, k = 5e34 m^-3, m = 8.5 as Benz & Asphaug 1994, and 0.2 g of nylon at "
            "3.2 km/s, 30 degrees from the normal, for 100 us. Experiment: the largest fragment keeps about 0.3 and is a core; fragments "
            f"of the far side leave with some 10 m/s. The antipode here is what starts within {CAP} degrees of it and 0.1 R of the surface.",
            table(HEAD, seeds),
            f"Largest fragment, mean over seeds: {means}; the experiment, about 0.3.",
            "Old strength (von Mises, 3.5 GPa, damage takes shear away) and new (Jutzi 2015: cohesion 90 MPa, internal friction 2, limit 3.5 GPa, "
            "friction 0.8 of broken rock) side by side:",
            table(HEAD, [row(f"{name}, flaw seed {seed}", run(n, seed)) for n, seed in BOTH for name, run in (("old", seeded), ("new", frictional))]),
            "What is uncertain, to be compared with the same number of particles above:",
            table(HEAD, [row(label, run) for label, run in VARIED.items()]),
            "![Fragments, antipode, largest fragment](fracture_laboratory.png)",
            "Fragments of a single particle do not count, so that the spectra end at two particles.",
        ]
    )
