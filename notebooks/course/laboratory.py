"""What several notebooks measure in the same way.

Sources of phases against the truth, and walks of many characters.
"""

import dataclasses
from collections.abc import Mapping, Sequence
from pathlib import Path

import pandas as pd
import torch
from course.labels import measure
from course.pages import Page, show
from torch import Tensor

from toolkit import phases as ph, runtime
from toolkit.datasets import procedural
from toolkit.features import split_joints
from toolkit.motion.contacts import velocities
from toolkit.networks import Model
from toolkit.view.frontend import embed

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
        rows += [(f"{name} {gait}", source, float(error[:2].mean()), float(error[2:].mean()))
                 for source, error in found.items()]
    return pd.DataFrame(rows, columns=["clip", "source", "hands", "feet"])


def sliders(seconds: float = 8.0) -> Page:
    """A page in which sliders weigh four curves into a source, and errors follow at once.

    The page fits sinusoids of the true frequency to walks of `FOUR`, at 30 frames per second.
    """
    styles = []
    for name in FOUR:
        clip, truth = procedural.truth(name, "FW", seconds)
        curves = []
        for limb in ph.LIMBS:
            end = ph.local_positions(clip, limb)
            left, up, ahead = end.T
            speed = velocities(end, clip.fps).norm(dim=-1)
            four = torch.stack((ahead, up, left, speed))[:, ::2]
            four = (four - four.mean(1, keepdim=True)) / four.std(1, keepdim=True)
            curves.append([[round(x, 2) for x in curve] for curve in four.tolist()])
        turns = (truth.phase.diff(dim=0) + torch.pi) % (2 * torch.pi) - torch.pi
        styles.append({
            "name": name, "curves": curves,
            "phase": [[round(x, 3) for x in row] for row in truth.phase[::2].T.tolist()],
            "hertz": (turns.mean(0).abs() * clip.fps / (2 * torch.pi)).tolist()})
    names = ["ahead", "up", "to the left", "speed relative to the hips"]
    data = {"styles": styles, "fps": 30, "names": names}
    page = Path(__file__).with_suffix(".html").read_text(encoding="utf-8")
    return show(page.replace("DATA", embed(data)), 620)


def walk(
    model: Model, vectors: Tensor, speed: float = 0.9, seconds: float = 6.0, settled: int = 120
) -> Tensor:
    """Predicted positions ``[settled, S, J, 3]`` of S characters that walk straight ahead, each
    with its style vector.

    They are the last ``settled`` frames, in the root frame. ``speed`` is in metres per second.
    """
    fast = runtime.quick(model, round(runtime.FPS * seconds))  # compiled, if that pays
    states = list(runtime.states(fast, runtime.straight(speed, seconds), vectors))[-settled:]
    return torch.stack([split_joints(state.joints)["position"] for state in states])
