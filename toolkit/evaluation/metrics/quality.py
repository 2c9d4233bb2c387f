"""What a viewer sees of one motion, from the positions of its joints alone.

Real motion does not have the value 0: compare with real clips. `toolkit.evaluation.defects` names
the single moments.
"""

import torch
from torch import Tensor

from toolkit.evaluation import findings
from toolkit.evaluation.metrics.steps import foot_skate
from toolkit.motion import Clip
from toolkit.motion.roles import SIDES

SLOW = 1.5  # seconds: the mean pose over so long is slow motion
JOINTS = "hips", *(f"{side}_{part}" for side in SIDES for part in ("hand", "elbow", "knee", "toe"))
UPPER = "shoulder", "elbow", "hand"


def jerk(clip: Clip) -> float:
    """Mean jerk of hips, hands, elbows, knees and toes, m/s³; nearest to real is best.

    Of positions 1/30 s apart, so that it does not depend on the rate. NaN below 0.13 s.
    """
    joints = clip.global_positions[:, [clip.skeleton.role(role) for role in JOINTS]].double()
    return float(findings.jerks(joints, clip.fps).mean())


def shake(clip: Clip) -> float:
    """How far joints go to and fro from frame to frame, metres, as real.

    The mean fourth difference over 16: the amplitude of a motion of two frames.
    """
    return _mean(clip, "shake")


def skate(clip: Clip) -> float:
    """Mean speed of low toes in three dimensions, m/s: `foot_skate`, mean of the feet.

    A foot that is never low, as in a hop, does not count; NaN if none is.
    """
    return float(torch.tensor(list(foot_skate(clip).values())).nanmean())


def floor(clip: Clip) -> float:
    """How much deeper one toe stands than the other, metres: it sinks, or the other one hovers."""
    return _mean(clip, "floor")


def through(clip: Clip) -> float:
    """How deep limbs are within the body, metres: the sum over parts of their means over frames.

    The limits are those of `toolkit.evaluation.findings.LIMITS`.
    """
    return float(sum((limit - values).clamp_min(0.0).mean()
                     for kind, _, values, limit in findings.measured(clip) if kind == "body"))


def stretch(clip: Clip) -> float:
    """Mean absolute deviation of bone lengths from their means, metres; 0 for a `Clip`."""
    p = clip.global_positions.double()
    lengths = (p[:, 1:] - p[:, list(clip.skeleton.parents[1:])]).norm(dim=-1)
    return float((lengths - lengths.mean(0)).abs().mean())


def motion(clip: Clip) -> float:
    """Deviation of arms and chest from their mean places in the hips' frame, metres, as real."""
    return _deviation(upper_body(clip))


def slow_motion(clip: Clip) -> float:
    """`motion` of the mean pose over 1.5 seconds: glances, sways; NaN for clips below 3 s.

    A loop that repeats one cycle has nearly none.
    """
    window = round(SLOW * clip.fps)
    if len(clip) < 2 * window:
        return torch.nan
    return _deviation(upper_body(clip).unfold(0, window, 1).mean(-1))


def upper_body(clip: Clip) -> Tensor:
    """Positions ``[F, 7, 3]`` of arms and chest in the frame of the hips."""
    skeleton = clip.skeleton
    joints = [*(skeleton.role(f"{side}_{part}") for side in SIDES for part in UPPER),
              skeleton.trunk[0]]
    p = clip.global_positions.double()
    return facing(clip, p[:, joints] - p[:, [skeleton.role("hips")]])


def facing(clip: Clip, vectors: Tensor) -> Tensor:
    """Vectors ``[F, N, 3]`` in the directions of the hips: to the left, up, ahead."""
    p, skeleton = clip.global_positions.double(), clip.skeleton
    left = p[:, skeleton.role("left_hip")] - p[:, skeleton.role("right_hip")]
    cos, sin = torch.nn.functional.normalize(left[:, [0, 2]], dim=-1)[:, :, None].unbind(1)
    x, y, z = vectors.unbind(-1)
    return torch.stack((cos * x + sin * z, y, cos * z - sin * x), -1)


def _deviation(points: Tensor) -> float:
    return float((points - points.mean(0)).square().sum(-1).mean(0).sqrt().mean())


def _mean(clip: Clip, kind: str) -> float:
    """Mean of a kind of `findings.measured`, NaN where it has no value."""
    found = [values for kinds, _, values, _ in findings.measured(clip) if kinds == kind]
    return float(torch.cat(found).nanmean()) if found else torch.nan
