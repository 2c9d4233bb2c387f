"""What several notebooks measure in the same way.

Sources of phases against the truth, and walks of many characters.
"""

import dataclasses
from collections.abc import Mapping, Sequence

import pandas as pd
import torch
from torch import Tensor

from toolkit import phases as ph, runtime
from toolkit.datasets import procedural
from toolkit.evaluation.phases import measure
from toolkit.features import split_joints
from toolkit.networks import Model

# Cyclic, asymmetric, no global phase, stochastic.
FOUR = ("Neutral", "DragRightLeg", "PendulumHands", "Drunk")


def trial(
    sources: Mapping[str, str | ph.Source], cases: Sequence[tuple[str, str]], seconds: float = 12.0,
    seed: int = 0, stagger: float | None = None
) -> pd.DataFrame:
    """Errors of sources in degrees: columns ``clip``, ``source``, ``hands``, ``feet``.

    Parameters
    ----------
    sources
        Name -> a name of `toolkit.phases.SOURCES`, or a source.
    cases
        Style and gait of each clip.
    seconds, seed
        Of the procedural walks.
    stagger
        How unsteady the styles are, in place of their own value.
    """
    named = {
        name: ph.named(source) if isinstance(source, str) else source
        for name, source in sources.items()
    }
    rows = []
    for name, gait in cases:
        style = (
            name
            if stagger is None
            else dataclasses.replace(procedural.STYLES[name], stagger=stagger)
        )
        found = measure(name, *procedural.truth(style, gait, seconds, seed), named).phase
        rows += [(f"{name} {gait}", source, float(error[:2].nanmean()), float(error[2:].nanmean()))
                 for source, error in found.items()]
    return pd.DataFrame(rows, columns=["clip", "source", "hands", "feet"])


def walk(
    model: Model, vectors: Tensor, speed: float = 0.9, seconds: float = 6.0, settled: int = 120
) -> Tensor:
    """Predicted positions ``[settled, S, J, 3]`` of S characters that walk straight ahead, each
    with its style vector.

    They are the last ``settled`` frames, in the root frame. ``speed`` is in metres per second.
    """
    states = list(runtime.states(model, runtime.straight(speed, seconds), vectors))[-settled:]
    return torch.stack([split_joints(state.joints)["position"] for state in states])
