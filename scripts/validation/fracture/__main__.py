"""The page tests/validation/fracture.md. Blocks whose runs are there are written, as those of the laboratory take longest."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))

import bar
import elements
import laboratory
from page import FOLDER
from runs import perform, show

HEAD = """# Fracture

Written by `scripts/validate_fracture`: `tests/fracture.rs` with large samples, and runs of `inputs/tensile_bar.toml` and
`inputs/nakamura_fujiwara.toml`. Text that judges the laboratory's figures stands in `scripts/validation/fracture/judgement.md`."""


def main():
    if "--list" in sys.argv:
        return show(bar.runs() + laboratory.runs())
    elements.make()
    perform(bar.runs())
    perform(laboratory.runs())
    blocks = {
        "Flaws": elements.flaws(),
        "Strength against strain rate": elements.rates(),
        "A bar": bar.write(),
        "The laboratory": laboratory.write(),
    }
    judgement = pathlib.Path(__file__).with_name("judgement.md").read_text().strip()
    text = [HEAD, *(f"## {title}\n\n{block}" for title, block in blocks.items()), judgement]
    (FOLDER / "fracture.md").write_text("\n\n".join(text) + "\n")
    print("written to tests/validation/fracture.md")


main()
