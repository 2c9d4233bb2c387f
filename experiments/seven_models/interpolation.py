"""Interpolation of two styles (Mason et al. 2022, section 5.1.2): measures of walks as functions of the blend."""

import torch

from experiments.seven_models.models import FPS, WARM_UP, states
from toolkit.evaluation.models import Curves, blend_curves, nearest
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import Features, natural_speed, splits
from toolkit.runtime import Command
from toolkit.training import Run

PAIRS, BLENDS = 50, 11  # pairs of styles, blends from one to the other
FIGURE_8 = ("BentForward", "LeanBack")  # the paper's pair, the first one if the data have it
SECONDS = 4.0  # measured seconds of a walk


def style_pairs(styles: list[str]) -> list[tuple[str, str]]:
    """`PAIRS` pairs of different styles, the paper's pair first if the data have it."""
    draw, pairs = splits.generator(0), [FIGURE_8] if set(FIGURE_8) <= set(styles) else []
    while len(pairs) < min(PAIRS, len(styles) * (len(styles) - 1) // 2):
        a, b = (styles[i] for i in torch.randperm(len(styles), generator=draw)[:2].tolist())
        if (a, b) not in pairs and (b, a) not in pairs:
            pairs.append((a, b))
    return pairs


def blend_walks(run: Run, data: Features, recogniser: Recogniser, pairs: list[tuple[str, str]]) -> Curves:
    """Walks with all blends of all pairs in one crowd, each at the blend of both styles' usual speeds."""
    blends = [(a, b, t) for a, b in pairs for t in shares()]
    vectors = torch.stack([run.bank.blend({a: 1 - t, b: t}) for a, b, t in blends])
    velocity = torch.tensor([[0.0, run.bank.speed({a: 1 - t, b: t})] for a, b, t in blends])
    commands = [Command(velocity)] * round((WARM_UP + SECONDS) * FPS)
    walk = states(run.model, commands, vectors)[round(WARM_UP * FPS) :]
    joints = torch.stack([s.joints for s in walk], 1).nan_to_num()
    return blend_curves(joints.unflatten(0, (len(pairs), BLENDS)), recogniser, pairs)


def blend_data(data: Features, recogniser: Recogniser, pairs: list[tuple[str, str]]) -> Curves:
    """The same for two style clips that are blended linearly frame by frame, which shows the recogniser's own boundary."""
    ends = [[nearest(y, natural_speed(y))[0] for y in (data.clips[style][:] for style in pair)] for pair in pairs]
    blended = torch.stack([torch.stack([torch.lerp(a, b, t) for t in shares()]) for a, b in ends])
    return blend_curves(blended, recogniser, pairs)


def shares() -> list[float]:
    """The weight of the second style in each blend."""
    return [i / (BLENDS - 1) for i in range(BLENDS)]


def mean(curves: list[Curves]) -> Curves:
    """Mean over runs."""
    return Curves(*(torch.stack([getattr(c, name) for c in curves]).mean(0) for name in ("odds", "gait")))
