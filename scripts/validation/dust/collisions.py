"""Two aggregates collide: a map of what comes of it over speed and filling factor."""

import shutil

from common import page
from common.runs import Study

MAP = Study("dust/collisions", "studies/dust_collisions.toml", guess=4500)
PICTURE = "dust_collisions.png"


def runs():
    return [MAP]


def figures(study):
    """What the page needs of a study: of each point its values, its word, and its cost."""
    keys = ("values", "word", "core_seconds", "failed", "warnings")
    return {"points": [{key: point[key] for key in keys if key in point} for point in study["points"]]}


def write(known):
    parts = [TEXT]
    if (picture := MAP.folder / "map.png").exists():
        shutil.copy(picture, page.FOLDER / PICTURE)
    row = known.get(MAP.name)
    if row is None:
        return [*parts, "not run"], []
    seconds = sum(point["core_seconds"] for point in row["points"])
    parts += [f"![Map of outcomes]({PICTURE})", f"The map takes {seconds:.0f} core-s."]
    return parts, []


TEXT = """## A map of outcomes

`inputs/studies/dust_collisions.toml`: two aggregates of 1 mm, 8000 particles each, collide head on. What comes of it is told by four
populations: the largest piece, the second largest, a power law of smaller ones, and the rest (Geretshauser et al. 2011, A&A 531, A166)."""
