"""The page tests/validation/campaigns.md: Q*_D over radius beside published laws, and what strength, friction and pores do to it."""

import math
import pathlib
import shutil

from common import page
from common.runs import Study

PAGE = "campaigns.md"
BY_NAME = True
"""Some three core-hours."""
FROM_SOME = True

CAMPAIGNS = ["strength", "strength_viscosity", "strength_speed", "strength_resolution", "radius", "radius_contact"]
HEAD = """# Campaigns: Q*_D over radius and strength

Written by `scripts/validate campaigns`, which runs `inputs/campaigns/`: impacts at 45 degrees from the normal, 2e4 particles unless said
otherwise, uncertainties as each search states them (bracket, residual, shift between two times). What the figures mean stands in
`scripts/validation/campaigns/judgement.md`."""


def study(campaign):
    return Study(f"campaigns/{campaign}", f"campaigns/{campaign}.toml")


def runs():
    return [study(campaign) for campaign in CAMPAIGNS]


def quotient(a, b):
    """(value, uncertainty) of a / b."""
    if not a or not b or not a["q_star_d"] or not b["q_star_d"]:
        return None
    value = a["q_star_d"] / b["q_star_d"]
    relative = [row["uncertainty"] / row["q_star_d"] for row in (a, b)]
    return value, value * math.hypot(*relative)


def words(found):
    return "–" if found is None else f"{found[0]:.2f} ± {found[1]:.2f}"


def one(rows, family, **where):
    near = [row for row in rows if row["family"] == family and all(abs(row[key] / value - 1) < 0.2 for key, value in where.items())]
    return near[0] if near else None


def energy(row):
    return "–" if not row or not row["q_star_d"] else f"{row['q_star_d']:.3g} ± {row['uncertainty']:.1g}"


def thresholds(rows):
    head = ["target", "radius", "speed", "particles", "Q*_D, J/kg", "slope s", "energy drift", "core-s"]
    lines = [
        [
            row["family"], f"{row['radius'] / 1000:g} km", f"{row['speed'] / 1000:g} km/s", f"{row['particles']:.0f}", energy(row),
            f"{row['slope']:.2f}", f"{row['energy_drift']:.0e}", f"{row['core_seconds']:.0f}",
        ]
        for row in rows if row["q_star_d"]
    ]
    return page.table(head, lines)


STATEMENTS = [
    # What, over what, in the words of the paper.
    ("(a)", "intact, new strength", "intact, old strength", "no significant difference"),
    ("(b)", "broken, friction", "broken, no friction", "5 to 10"),
    ("(c)", "broken, friction, pores", "broken, friction", "2 to 3"),
    ("(d)", "broken, friction, cohesion", "broken, friction", "1 at large scales, more only at 1 km and below"),
]


def statements(rows):
    radii = sorted({row["radius"] for row in rows}, reverse=True)
    head = ["", "Q*_D of", "over that of", "paper", *(f"R = {radius / 1000:g} km" for radius in radii)]
    lines = []
    for name, this, that, paper in STATEMENTS:
        ratios = [words(quotient(one(rows, this, radius=radius), one(rows, that, radius=radius))) for radius in radii]
        lines.append([name, this, that, paper, *ratios])
    return page.table(head, lines)


FACTORS = [("friction / no friction", "friction", "no friction"), ("pores / friction", "friction, pores", "friction"),
           ("pores / friction, as light", "friction, pores", "friction, as light")]


def factors(rows, key, label):
    """Factors of friction and pores over something of the scene."""
    values = sorted({row[key] for row in rows})
    # Numbers of particles differ a little between targets of a level.
    levels = [value for k, value in enumerate(values) if k == 0 or value > 1.2 * values[k - 1]]
    head = [label, *(name for name, *_ in FACTORS)]
    lines = []
    for level in levels:
        pick = lambda family: one(rows, family, **{key: level})
        lines.append([f"{level:g}", *(words(quotient(pick(this), pick(that))) for _, this, that in FACTORS)])
    return page.table(head, lines)


def by_scene(rows):
    scenes = sorted({(row["radius"], row["speed"]) for row in rows})
    head = ["target, speed", *(name for name, *_ in FACTORS)]
    lines = []
    for radius, speed in scenes:
        pick = lambda family: one(rows, family, radius=radius, speed=speed)
        lines.append([f"{radius / 1000:g} km, {speed / 1000:g} km/s", *(words(quotient(pick(a), pick(b))) for _, a, b in FACTORS)])
    return page.table(head, lines)


def by_viscosity(rows):
    """Families of strength_viscosity are `alpha 0.1, friction`."""
    alphas = list(dict.fromkeys(row["family"].split(", ")[0] for row in rows))
    head = ["viscosity", *(name for name, *_ in FACTORS)]
    lines = [[alpha, *(words(quotient(one(rows, f"{alpha}, {a}"), one(rows, f"{alpha}, {b}"))) for _, a, b in FACTORS)] for alpha in alphas]
    return page.table(head, lines)


def without_scene(rows):
    """Families of strength_speed have the scene's label at their end."""
    known = ["friction, pores", "friction, as light", "no friction", "friction"]
    return [row | {"family": next(name for name in known if row["family"].startswith(name))} for row in rows]


def slope(rows):
    points = [(math.log(row["radius"]), math.log(row["q_star_d"])) for row in rows]
    return (points[-1][1] - points[0][1]) / (points[-1][0] - points[0][0]) if len(points) > 1 else math.nan


SLOPES = {"basalt, 5 km/s": (-0.36, 1.36), "basalt, 3 km/s": (-0.38, 1.36), "ice, 3 km/s": (-0.39, 1.26)}
"""Of Benz & Asphaug 1999: strength, gravity."""
ALONE = 40.0, 5000.0
"""Up to this radius strength alone decides, from that on gravity, m."""


def regimes(rows):
    head = ["target", "weakest radius", "least over Benz & Asphaug", "most", "slope of strength", "theirs", "slope of gravity", "theirs"]
    lines = []
    for family, (strength, gravity) in SLOPES.items():
        mine = sorted((row for row in rows if row["family"] == family and row["q_star_d"]), key=lambda row: row["radius"])
        if not mine:
            continue
        ratios = [row["ratio_to_reference"] for row in mine]
        weakest = min(mine, key=lambda row: row["q_star_d"])["radius"]
        small, large = [row for row in mine if row["radius"] <= ALONE[0]], [row for row in mine if row["radius"] >= ALONE[1]]
        lines.append([family, f"{weakest:g} m", f"{min(ratios):.2f}", f"{max(ratios):.2f}", f"{slope(small):.2f}", f"{strength}", f"{slope(large):.2f}", f"{gravity}"])
    return page.table(head, lines)


def by_geometry(centre, contact):
    """Q*_D over Benz & Asphaug 1999 for the two places where 45 degrees are measured."""
    head = ["target", "radius", "projectile / target radius at Q*_D", "over Benz & Asphaug, at the centre's path", "at contact"]
    lines = []
    for row in sorted(contact, key=lambda row: (row["family"], row["radius"])):
        other = one(centre, row["family"], radius=row["radius"])
        ratio = lambda found: f"{found['ratio_to_reference']:.2f}" if found and found["q_star_d"] else "none"
        size = f"{(2 * other['q_star_d'] / other['speed'] ** 2) ** (1 / 3):.2f}" if other and other["q_star_d"] else "–"
        lines.append([row["family"], f"{row['radius'] / 1000:g} km", size, ratio(other), ratio(row)])
    return page.table(head, lines)


def keep(campaign):
    figure = study(campaign).folder / "q_star.png"
    if figure.exists():
        shutil.copy(figure, page.FOLDER / f"campaign_{campaign}.png")
    return f"![Q*_D over the radius](campaign_{campaign}.png)"


def write(found):
    rows = {campaign: found.get(study(campaign).name, {}).get("thresholds", []) for campaign in CAMPAIGNS}
    parts = [HEAD]
    if strength := rows["strength"]:
        parts += ["## What strength, friction, pores and cohesion do (Jutzi 2015)", statements(strength), thresholds(strength)]
    if viscosity := rows["strength_viscosity"]:
        parts += ["## Friction and pores: artificial viscosity (1.5 above), 10 km, 5 km/s", by_viscosity(viscosity), thresholds(viscosity)]
    if speed := rows["strength_speed"]:
        parts += ["## Friction and pores: speed and size", by_scene(without_scene(speed)), thresholds(speed)]
    if resolution := rows["strength_resolution"]:
        parts += ["## Friction and pores: resolution, 10 km, 5 km/s", factors(resolution, "particles", "particles"), thresholds(resolution)]
    if radius := rows["radius"]:
        parts += ["## Q*_D over the radius", regimes(radius), keep("radius"), thresholds(radius)]
        if contact := rows["radius_contact"]:
            parts += ["### Where 45 degrees are measured", by_geometry(radius, contact), thresholds(contact)]
    parts.append(pathlib.Path(__file__).with_name("judgement.md").read_text())
    return parts, []
