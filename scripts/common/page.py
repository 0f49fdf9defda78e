"""Pages of tests/validation/ and their blocks, tables, and plots over spacing or cost."""

import math
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "tests" / "validation"
PAGE = FOLDER / "README.md"

HEAD = """# Validation

Written by `scripts/validate`: each block below by the topic of its name in `scripts/validation/`. Every figure and number
follows from runs of scenes of `inputs/`; nothing is edited by hand. `tests/exact.rs` and `tests/compaction.rs` run a small version of each
case.

Other pages: [what accuracy costs](price.md) (`scripts/validate price`), [integrators](integrators.md) (`scripts/validate integrators`), [fracture](fracture.md) (`scripts/validate fracture`), [craters](craters.md) (`scripts/validate craters`), [dust](dust.md) (`scripts/validate dust`), [dissipation](dissipation.md) (`scripts/validate dissipation`), [disruption thresholds](q_star.md) (`scripts/validate q_star`), [campaigns](campaigns.md) (`scripts/validate campaigns`),
[speed](bench.md) (`scripts/bench`), [scaling and predictions](cluster.md) (`scripts/bench cluster`).
"""


def replace_block(name, title, text, order):
    """Puts a topic's block in its place on the page; other blocks stay."""
    blocks = {}
    if PAGE.exists():
        for part in PAGE.read_text().split("<!-- section: ")[1:]:
            key, body = part.split(" -->", 1)
            blocks[key] = body.strip()
    blocks[name] = f"## {title}\n\n{text.strip()}"
    known = [key for key in order if key in blocks] + [key for key in blocks if key not in order]
    PAGE.write_text(HEAD + "".join(f"\n<!-- section: {key} -->\n{blocks[key]}\n" for key in known))
    print(f"written to tests/validation/{PAGE.name}: {name}")


def write(name, parts):
    """A page of its own: its parts under each other."""
    (FOLDER / name).write_text("\n\n".join(part.strip() for part in parts) + "\n")
    print(f"written to tests/validation/{name}")


def save(figure, name):
    figure.savefig(FOLDER / name, dpi=110, bbox_inches="tight")
    plt.close(figure)


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


def plot(name, panels, x_label, y_label="error", x_base=10):
    """One figure of several log-log panels: {title: {label: [(x, y), ...]}}. A case in 2D is dashed, in the colour of its twin."""
    figure, axes = plt.subplots(1, len(panels), figsize=(4.6 * len(panels), 5.8), squeeze=False)
    for axis, (title, series) in zip(axes.flat, panels.items()):
        cases = list(dict.fromkeys(label.removesuffix(", 2D").removesuffix(", 3D") for label in series))
        for label, points in series.items():
            number = cases.index(label.removesuffix(", 2D").removesuffix(", 3D"))
            points = sorted((x, abs(y)) for x, y in points if y)
            style = dict(color=f"C{number % 10}", marker="osv^D"[number // 10 + number % 3], linestyle="--" if label.endswith(", 2D") else "-")
            axis.loglog(*zip(*points), label=label, markersize=4, **style)
        axis.set_xscale("log", base=x_base)
        axis.set(title=title, xlabel=x_label, ylabel=y_label)
        for ruler in [axis.yaxis] + [axis.xaxis] * (x_base == 10):
            ruler.set_major_locator(LogLocator(subs=(1, 2, 5)))
            ruler.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            ruler.set_minor_formatter(NullFormatter())
        if x_base == 2:
            axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}" if value >= 1 else f"1/{1 / value:g}"))
        axis.grid(True, which="both", alpha=0.25)
        long = max(map(len, series)) > 40
        axis.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.19), ncols=1 if long else 2, handlelength=3)
    figure.tight_layout()
    figure.savefig(FOLDER / f"{name}.png", dpi=80)
    plt.close(figure)
