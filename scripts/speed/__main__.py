"""usage: scripts/bench [TOPIC] [--set KEY=VALUE...]

Without a topic: pairs, gravity, impact and effects, whose table is kept in tests/validation/bench.md. Wants an idle machine with
two cores; some minutes. A topic alone is printed only:

    pairs     the pair loops beside their ceiling, a stripped loop on the same processor (cargo bench --bench ceiling)
    gravity   an evaluation of self-gravity, error against cost (cargo bench --bench gravity)
    parts     parts of a step by themselves (cargo bench --bench parts)
    impact    whole runs: small and large, on ranks and on threads
    effects   what each effect costs: runs with it and without
    cluster   under Slurm, ranks x threads of one node, and how far off --check was; keeps tests/validation/cluster.md. As root

For a quick look, which is not kept: `scripts/bench impact --set target.particles=5000 --set run.steps=20` (--set goes to every
impact), and `STRONG=5000 WEAK=3000 STEPS=10 scripts/bench cluster`. SPH_MPI_BIN=PATH measures another program.
"""

import argparse

from common.page import FOLDER
from speed import benches, cluster, effects, impact

TOPICS = {
    "pairs": lambda settings: benches.run("ceiling"),
    "gravity": lambda settings: benches.run("gravity"),
    "parts": lambda settings: benches.run("parts"),
    "impact": lambda settings: impact.table(impact.measure(settings)),
    "effects": lambda settings: effects.table(effects.measure(settings)),
    "cluster": lambda settings: cluster.measure(),
}


def whole_page(settings):
    """Every topic of this machine, in one page."""
    pairs, gravity = benches.run("ceiling"), benches.run("gravity")
    runs = impact.measure(settings)
    run = runs["single"]
    phases = [f"{name} {100 * share:.1f}" for name, share in run["phases"].items() if share >= 0.0005]
    options = "".join(f" --set {setting}" for setting in settings)
    return f"""# Speed

{benches.processor()}. Impact with strength, damage and corrected gradient: {run["particles"]} particles, {run["steps"]} steps,
on one rank and one thread unless stated. By `scripts/bench{options}`.

{impact.table(runs, benches.ceiling(pairs), benches.gravity(gravity))}

Phases in per cent: {", ".join(phases)}.

## What each effect costs

{effects.table(effects.measure(settings))}

The impact has viscosity, corrected gradient and forces without torque (which go with it), records, fracture and strength; the last rows, from artificial stress on, add what it lacks.

Pores change the flow, not only the cost per particle: the goal is 1.3 on the whole step.

## Pair loops beside the ceiling

{pairs.strip()}
"""


def main():
    parser = argparse.ArgumentParser(usage=argparse.SUPPRESS, description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, add_help=False)
    parser.add_argument("-h", "--help", action="help", help=argparse.SUPPRESS)
    parser.add_argument("topic", nargs="?", choices=TOPICS, help=argparse.SUPPRESS)
    parser.add_argument("--set", action="append", default=[], dest="settings", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.topic:
        return print(TOPICS[given.topic](given.settings))
    text = whole_page(given.settings)
    if not given.settings:
        (FOLDER / "bench.md").write_text(text)
    print(text)


main()
