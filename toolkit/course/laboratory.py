"""The laboratory of phase sources: one source, measured on clips whose true phases are known."""

import dataclasses
from collections.abc import Mapping, Sequence

import pandas as pd

from toolkit import phases as ph
from toolkit.datasets import procedural
from toolkit.evaluation.phases import measure

FOUR = ("Neutral", "DragRightLeg", "PendulumHands", "Drunk")  # cyclic, asymmetric, no global phase, stochastic


def trial(sources: Mapping[str, str | ph.Source], cases: Sequence[tuple[str, str]], seconds: float = 12.0, seed: int = 0,
          stagger: float | None = None) -> pd.DataFrame:
    """Errors of sources in degrees: columns ``clip``, ``source``, ``hands``, ``feet``.

    Parameters
    ----------
    sources
        Name -> a name of `toolkit.phases.SOURCES`, "learned", or a source.
    cases
        Style and gait of each clip.
    seconds, seed
        Of the procedural walks.
    stagger
        How unsteady the styles are, in place of their own value.
    """
    named = {name: ph.named(source) if isinstance(source, str) else source for name, source in sources.items()}
    rows = []
    for name, gait in cases:
        style = name if stagger is None else dataclasses.replace(procedural.STYLES[name], stagger=stagger)
        found = measure(name, *procedural.truth(style, gait, seconds, seed), "", named).phase
        rows += [(f"{name} {gait}", source, float(error[:2].nanmean()), float(error[2:].nanmean()))
                 for source, error in found.items()]
    return pd.DataFrame(rows, columns=["clip", "source", "hands", "feet"])
