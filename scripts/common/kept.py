"""Figures of runs that stay in the repository, so that a page does not need all of its runs at once."""

import json


def known(file, runs, found, figures):
    """By run, what `file` and `found` know of what is asked now; what is found is written into the file, as `figures` takes it from a result."""
    kept = json.loads(file.read_text()) if file.exists() else {}
    asked = {run.name: run.stamp() for run in runs}
    kept |= {name: {"of": asked[name], **figures(result)} for name, result in found.items()}
    file.write_text(json.dumps(dict(sorted(kept.items())), indent=1) + "\n")
    return {name: row for name, row in kept.items() if asked.get(name) == row["of"]}
