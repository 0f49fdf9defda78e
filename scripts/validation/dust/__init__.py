"""Dust: compaction by a bead that falls, bouncing, fragmentation, as in Geretshauser et al. 2010, beside the paper and experiments."""

from common import kept, page
from validation.dust import bouncing, collisions, compaction, fragmentation, price, verdicts

PAGE = "dust.md"
BY_NAME = True
FROM_SOME = True

KEPT = page.FOLDER / "dust.json"
"""Figures of every run that was ever made, so that the page does not need all of them at once."""

SECTIONS = (verdicts, compaction, price, bouncing, fragmentation, collisions)


def runs():
    return [run for section in SECTIONS for run in section.runs()]


def figures(summary):
    """What the page needs of a summary, or of a study."""
    if "points" in summary:
        return collisions.figures(summary)
    own = {key: summary[key] for key in ("particles", "steps", "core_seconds", "pair_interactions", "time", "momentum_drift")}
    return own | {key: summary[key] for key in ("intrusion", "restitution", "fragments") if key in summary}


def write(found):
    known = kept.known(KEPT, runs(), found, figures)
    text, failures = [INTRODUCTION.format(there=len(known), all=len(runs()))], []
    for section in SECTIONS:
        parts, wrong = section.write(known)
        text += parts
        failures += wrong
    return text, failures


INTRODUCTION = """# Dust

Written by `scripts/validate dust`; nothing is edited by hand ({there} of {all} runs are there; `scripts/validate dust --list` tells what the others
cost). Figures of the paper are those of Geretshauser et al. 2010, A&A 513, A58; experiments those of Guettler et al. 2009, Weidling et al.
2009, Heisselmann et al. 2007. The paper's smoothing length is the whole support of the kernel, 2 h here: where h / l_c is
written, it is the paper's. Depths below the first surface of the dust. Core-seconds are those of the machine that made a run: one without
AVX-512 takes two to three times as long as one with it."""
