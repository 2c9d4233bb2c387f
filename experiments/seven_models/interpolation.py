"""Interpolation of two styles (Mason et al. 2022, section 5.1.2): measures of walks as functions of the blend."""

from dataclasses import dataclass

import torch
from torch import Tensor

from experiments.seven_models.models import FPS, WARM_UP, average, nearest, states, usual_speed
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import Features, split_joints, splits
from toolkit.runtime import Command
from toolkit.training import Run

PAIRS, BLENDS = 6, 11  # pairs of styles, blends from one to the other
FIGURE_8 = ("BentForward", "LeanBack")  # the paper's pair, the first one if the data have it
SECONDS = 4.0  # measured seconds of a walk


@dataclass(frozen=True, eq=False)
class Curves:
    """Measures of T blends from the first to the second style of P pairs.

    ``odds [P, T]``: the recogniser's probability of the second style, divided by the sum for both. ``gait [P, T]``: position
    of the walk on the line between the walks of both styles, 0 to 1, in the space of means and deviations over time of all
    joint positions. It does not depend on a classifier, which has its own decision boundary.
    """

    odds: Tensor
    gait: Tensor

    @property
    def recognised(self) -> Tensor:
        """Pairs ``[P]`` of which both styles are recognised; only these are used."""
        return (self.odds[:, 0] < 0.5) & (self.odds[:, -1] > 0.5)

    def numbers(self) -> dict[str, float]:
        """Means over these pairs; NaN if there is none."""
        odds, gait = self.odds[self.recognised], self.gait[self.recognised]
        return {
            "widest step": widest_step(odds), "crosses at": _crossing(odds), "gait's widest": widest_step(gait),
            "rank corr.": _rank_correlation(gait), f"of {len(self.odds)} pairs": float(len(odds)),
        }


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
    speeds = {style: usual_speed(data.clips[style][:]) for pair in pairs for style in pair}
    blends = [(a, b, t) for a, b in pairs for t in shares()]
    vectors = torch.stack([run.bank.blend({a: 1 - t, b: t}) for a, b, t in blends])
    velocity = torch.tensor([[0.0, (1 - t) * speeds[a] + t * speeds[b]] for a, b, t in blends])
    commands = [Command(velocity)] * round((WARM_UP + SECONDS) * FPS)
    walk = states(run.model, commands, vectors)[round(WARM_UP * FPS) :]
    joints = torch.stack([s.joints for s in walk], 1).nan_to_num()
    return _curves(joints.unflatten(0, (len(pairs), BLENDS)), recogniser, pairs)


def blend_data(data: Features, recogniser: Recogniser, pairs: list[tuple[str, str]]) -> Curves:
    """The same for two style clips that are blended linearly frame by frame, which shows the recogniser's own boundary."""
    ends = [[nearest(y, usual_speed(y))[0] for y in (data.clips[style][:] for style in pair)] for pair in pairs]
    return _curves(torch.stack([torch.stack([torch.lerp(a, b, t) for t in shares()]) for a, b in ends]), recogniser, pairs)


def shares() -> list[float]:
    """The weight of the second style in each blend."""
    return [i / (BLENDS - 1) for i in range(BLENDS)]


def mean(curves: list[Curves]) -> Curves:
    """Mean over runs."""
    return Curves(*(torch.stack([getattr(c, name) for c in curves]).mean(0) for name in ("odds", "gait")))


def _curves(joints: Tensor, recogniser: Recogniser, pairs: list[tuple[str, str]]) -> Curves:
    """Curves of ``joints [P, T, F, 12 J]``."""
    names = torch.tensor([[recogniser.styles.index(style) for style in pair] for pair in pairs])
    p = recogniser.probabilities(joints).gather(-1, names[:, None].expand(-1, joints.shape[1], -1)) + 1e-9
    position = split_joints(joints)["position"].flatten(3)  # [P, T, F, 3 J]
    gait = torch.cat((position.mean(2), position.std(2)), -1)
    way = gait[:, -1:] - gait[:, :1]
    return Curves(p[..., 1] / p.sum(-1), ((gait - gait[:, :1]) * way).sum(-1) / way.square().sum(-1).clamp_min(1e-12))


def widest_step(curves: Tensor) -> float:
    """Largest difference between neighbouring blends, mean over ``curves [P, T]``; a linear curve has 1 / (T - 1)."""
    return average(curves.diff(dim=1).abs().amax(1).tolist())


def _crossing(odds: Tensor) -> float:
    """Weight of the first blend in which the second style is more probable, mean."""
    return average(((odds > 0.5).float().argmax(1) / (odds.shape[1] - 1)).tolist())


def _rank_correlation(curves: Tensor) -> float:
    """Spearman correlation with the weight, mean; 1 for increasing curves."""
    ranks, blend = curves.argsort(1).argsort(1).double(), torch.arange(curves.shape[1], dtype=torch.float64)
    return average([float(torch.corrcoef(torch.stack((rank, blend)))[0, 1]) for rank in ranks])
