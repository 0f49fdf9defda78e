"""The page tests/validation/fracture.md: flaws, strength against strain rate, a bar, and an impact in the laboratory."""

import pathlib

from validation.fracture import bar, elements, laboratory

PAGE = "fracture.md"

HEAD = """# Fracture

Written by `scripts/validate fracture`: `tests/fracture.rs` with large samples, and runs of `inputs/tensile_bar.toml` and
`inputs/nakamura_fujiwara.toml`. Text that judges the laboratory's figures stands in `scripts/validation/fracture/judgement.md`."""


def runs():
    return [elements.TABLES, *bar.runs(), *laboratory.runs()]


def write(found):
    return [
        HEAD,
        "## Flaws", elements.flaws(),
        "## Strength against strain rate", elements.rates(),
        "## A bar", bar.write(),
        "## The laboratory", laboratory.write(),
        pathlib.Path(__file__).with_name("judgement.md").read_text(),
    ], []
