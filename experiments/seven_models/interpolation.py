"""Interpolation of two styles (Mason et al. 2022, section 5.1.2): measures of walks as functions of
the blend.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import torch
from course.comparison import nearest
from torch import Tensor

from experiments.seven_models.models import FPS, WARM_UP, states
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import Features, natural_speed, split_joints, splits
from toolkit.runtime import Command
from toolkit.training import Run

PAIRS, BLENDS = 50, 11  # pairs of styles, blends from one to the other
FIGURE_8 = ("BentForward", "LeanBack")  # the paper's pair, the first one if the data have it
SECONDS = 4.0  # measured seconds of a walk


@dataclass(frozen=True, eq=False)
class Curves:
    """Of P pairs of styles, T blends from the first style to the second.

    ``odds [P, T]``: what the recogniser gives to the second style, as a share of what it gives to
    both. ``gait [P, T]``: how far the walk is along the straight line between the walks at both
    ends, 0 to 1, in the mean and the standard deviation over time of every joint's position. The
    gait needs no classifier, whose odds may jump where the walk does not.
    """

    odds: Tensor
    gait: Tensor

    @property
    def recognised(self) -> Tensor:
        """Pairs ``[P]`` of which the recogniser names both ends rightly; `numbers` uses only
        these.
        """
        return (self.odds[:, 0] < 0.5) & (self.odds[:, -1] > 0.5)

    def numbers(self) -> dict[str, float]:
        """Means over those pairs; NaN where there is none.

        ``widest step`` of the odds and ``gait's widest``: the largest difference between
        neighbouring blends, 1 / (T - 1) for an even curve; ``crosses at``: the first blend in which
        the second style is the likelier one; ``rank corr.``: Spearman's, of the gait with the
        blend; and the number of pairs.
        """
        odds, gait = self.odds[self.recognised], self.gait[self.recognised]
        blend = torch.arange(odds.shape[1], dtype=torch.float64)
        ranks = [torch.corrcoef(torch.stack((g.argsort().argsort().double(), blend)))[0, 1]
                 for g in gait]
        columns = {
            "widest step": odds.diff(dim=1).abs().amax(1),
            "crosses at": (odds > 0.5).double().argmax(1) / (len(blend) - 1),
            "gait's widest": gait.diff(dim=1).abs().amax(1), "rank corr.": torch.tensor(ranks),
        }
        means = {name: float(column.double().mean()) for name, column in columns.items()}
        return means | {f"of {len(self.odds)} pairs": float(len(odds))}


def blend_curves(joints: Tensor, recogniser: Recogniser,
                 pairs: Sequence[tuple[str, str]]) -> Curves:
    """Curves of walks ``joints [P, T, F, 12 J]`` along blends from the first to the second style of
    P ``pairs``.
    """
    names = torch.tensor([[recogniser.styles.index(style) for style in pair] for pair in pairs])
    p = recogniser.probabilities(joints).gather(
        -1, names[:, None].expand(-1, joints.shape[1], -1)) + 1e-9
    position = split_joints(joints)["position"].flatten(3)  # [P, T, F, 3 J]
    gait = torch.cat((position.mean(2), position.std(2)), -1)
    way = gait[:, -1:] - gait[:, :1]
    return Curves(p[..., 1] / p.sum(-1),
                  ((gait - gait[:, :1]) * way).sum(-1) / way.square().sum(-1).clamp_min(1e-12))


def style_pairs(styles: list[str]) -> list[tuple[str, str]]:
    """`PAIRS` pairs of different styles, the paper's pair first if the data have it."""
    draw, pairs = splits.generator(0), [FIGURE_8] if set(FIGURE_8) <= set(styles) else []
    while len(pairs) < min(PAIRS, len(styles) * (len(styles) - 1) // 2):
        a, b = (styles[i] for i in torch.randperm(len(styles), generator=draw)[:2].tolist())
        if (a, b) not in pairs and (b, a) not in pairs:
            pairs.append((a, b))
    return pairs


def blend_walks(run: Run, data: Features, recogniser: Recogniser,
                pairs: list[tuple[str, str]]) -> Curves:
    """Walks with all blends of all pairs in one crowd, each at the blend of both styles' usual
    speeds.
    """
    blends = [(a, b, t) for a, b in pairs for t in shares()]
    vectors = torch.stack([run.bank.blend({a: 1 - t, b: t}) for a, b, t in blends])
    velocity = torch.tensor([[0.0, run.bank.speed({a: 1 - t, b: t})] for a, b, t in blends])
    commands = [Command(velocity)] * round((WARM_UP + SECONDS) * FPS)
    walk = states(run.model, commands, vectors)[round(WARM_UP * FPS) :]
    joints = torch.stack([s.joints for s in walk], 1).nan_to_num()
    return blend_curves(joints.unflatten(0, (len(pairs), BLENDS)), recogniser, pairs)


def blend_data(data: Features, recogniser: Recogniser, pairs: list[tuple[str, str]]) -> Curves:
    """The same for two style clips that are blended linearly frame by frame, which shows the
    recogniser's own boundary.
    """
    ends = [[nearest(y, natural_speed(y))[0] for y in (data.clips[style][:] for style in pair)]
            for pair in pairs]
    blended = torch.stack([torch.stack([torch.lerp(a, b, t) for t in shares()]) for a, b in ends])
    return blend_curves(blended, recogniser, pairs)


def shares() -> list[float]:
    """The weight of the second style in each blend."""
    return [i / (BLENDS - 1) for i in range(BLENDS)]

