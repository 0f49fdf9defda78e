"""The page and its blocks, tables, and plots over spacing or cost."""

import math
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "tests" / "validation"
PAGE = FOLDER / "README.md"

HEAD = """# Validation

Written by `scripts/validate`: each block below by the file of its name in `scripts/validation/`. Every figure and number
follows from runs of scenes of `inputs/exact/`; nothing is edited by hand. `tests/exact.rs` runs a small version of each case.
"""


def replace(name, title, text, order):
    """Puts a section's block in its place on the page; other blocks stay."""
    blocks = {}
    if PAGE.exists():
        for part in PAGE.read_text().split("<!-- section: ")[1:]:
            key, body = part.split(" -->", 1)
            blocks[key] = body.strip()
    blocks[name] = f"## {title}\n\n{text.strip()}"
    known = [key for key in order if key in blocks] + [key for key in blocks if key not in order]
    PAGE.write_text(HEAD + "".join(f"\n<!-- section: {key} -->\n{blocks[key]}\n" for key in known))
    print(f"written to {PAGE.name}: {name}")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def percent(x):
    """With three digits, and small ones as powers."""
    return f"{100 * x:.3g} %" if abs(x) >= 1e-5 else f"{x:.1e}"


def order(spacings, errors):
    """Least squares slope of ln |error| over ln spacing."""
    points = [(math.log(d), math.log(abs(e))) for d, e in zip(spacings, errors) if e]
    if len(points) < 2:
        return math.nan
    mean = [sum(p[k] for p in points) / len(points) for k in (0, 1)]
    return sum((x - mean[0]) * (y - mean[1]) for x, y in points) / sum((x - mean[0]) ** 2 for x, _ in points)


def plot(name, panels, x_label, y_label="error", columns=3, joined=True):
    """One figure of several log-log panels: {title: {label: [(x, y), ...]}}."""
    rows = math.ceil(len(panels) / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(4.2 * columns, 3.4 * rows), squeeze=False)
    for axis, (title, series) in zip(axes.flat, panels.items()):
        for label, points in series.items():
            points = sorted((x, abs(y)) for x, y in points if y)
            axis.loglog(*zip(*points), "o-" if joined else "o", label=label, markersize=4)
        axis.set_title(title, fontsize=10)
        axis.set_xlabel(x_label)
        axis.set_ylabel(y_label)
        axis.grid(True, which="both", alpha=0.25)
        axis.legend(fontsize=7)
    for axis in list(axes.flat)[len(panels) :]:
        axis.remove()
    figure.tight_layout()
    figure.savefig(FOLDER / f"{name}.png", dpi=80)
    plt.close(figure)
