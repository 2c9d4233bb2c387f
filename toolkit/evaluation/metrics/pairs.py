"""Measures of two motions that belong together: a clip and the real clip with the same frames."""

import math

import torch
from torch import Tensor

from toolkit.evaluation.metrics.bodies import hips_path
from toolkit.motion import Clip, contacts, rotations as R

STILL = 0.1  # m/s; slower hips have no direction of movement


def check_pair(clip: Clip, real: Clip) -> None:
    """Raise a ValueError unless two clips have the same joints, frames and rate."""
    if clip.skeleton.names != real.skeleton.names:
        raise ValueError(f"{clip.name} and {real.name}: the joints differ; "
                         "retarget one to the skeleton of the other")
    if (len(clip), clip.fps) != (len(real), real.fps):
        raise ValueError(f"{clip.name} and {real.name}: expected the same frames, "
                         f"got {len(clip)} at {clip.fps:g} Hz and {len(real)} at {real.fps:g} Hz; "
                         "cut or resample one")


def npss(clip: Clip, real: Clip) -> float:
    """Normalised power spectrum similarity (Gopalakrishnan et al. 2019): no unit, lower is better.

    For each number of the pose: the power of its Fourier coefficients over time, normalised to the
    sum 1; the sum over all frequencies of the absolute difference of the cumulated powers of clip
    and real clip (earth mover's distance); mean over the numbers, weighted by the real clip's
    power. 0 for equal motions. The numbers are world quaternions of all joints, as in Harvey et al.
    2020 and RSMT; the source has Euler angles. Signs of quaternions are made continuous.
    Harvey et al. square only the real part of the coefficients, so their values differ.

    Source: github.com/cr7anand/neural_temporal_models, ``metrics.py``.
    """
    check_pair(clip, real)
    truth = real.global_rotations.double()
    both = [R.unroll(q).flatten(1) for q in (clip.global_rotations.to(truth), truth)]
    power = torch.fft.fft(torch.stack(both), dim=1).abs().square()
    total = power.sum(1, keepdim=True)
    shares = (power / torch.where(total > 0, total, 1.0)).cumsum(1)
    distance, weight = (shares[0] - shares[1]).abs().sum(0), total[1, 0]
    return float((distance * weight).sum() / weight.sum())


def geodesic(clip: Clip, real: Clip) -> float:
    """Geodesic error: mean angle between joint rotations, radians in [0, π], lower is better.

    The rotations are those relative to the parents, the root's that in the world. The angle is that
    of the rotation ``R Rrealᵀ``, the distance on the group of rotations (Huynh 2009, *Metrics for
    3D rotations*, Φ6), mean over frames and joints. End Sites, which never turn, are left out.
    """
    check_pair(clip, real)
    turn = [j for j in range(len(clip.skeleton)) if not clip.skeleton.is_end(j)]
    a, b = (x.rotations[:, turn].to(clip.rotations).double() for x in (clip, real))
    between = R.multiply(R.inverse(a), b)
    # the arc tangent is exact near 0, unlike the arc cosine
    return float(2 * torch.atan2(between[..., 1:].norm(dim=-1), between[..., 0].abs()).mean())


def global_position(clip: Clip, real: Clip) -> float:
    """Global position error: mean distance of the joints in the world, metres, lower is better.

    The mean per-joint position error (Ionescu et al. 2014, Human3.6M) without alignment. It is L2P
    of Harvey et al. 2020 (*Robust motion in-betweening*) in metres, per joint: theirs is the norm
    over all joints of z-scores.
    """
    check_pair(clip, real)
    apart = clip.global_positions - real.global_positions.to(clip.global_positions)
    return float(apart.norm(dim=-1).mean())


def trajectory_error(clip: Clip, real: Clip) -> float:
    """Trajectory error (CAMDM, Chen et al. 2024): angle between movements, radians in [0, π].

    Lower is better. The directions are those of the hips' horizontal displacement to the next
    frame. Frames in which either moves slower than `STILL` are left out; NaN if all are.
    Departures: the source has degrees, and the absolute value of the mean of differences that are
    not wrapped; here it is the mean of absolute circular differences.

    Source: github.com/AIGAnimation/CAMDM, ``Evaluation/eval_traj_alignment.py``.
    """
    check_pair(clip, real)
    steps = torch.stack([hips_path(each).diff(dim=0).to(clip.global_positions) * each.fps
                         for each in (clip, real)])
    moving = (steps.norm(dim=-1) >= STILL).all(0)
    if not moving.any():
        return math.nan
    x, z = steps[:, moving].unbind(-1)
    return float(torch.atan2((x[0] * z[1] - z[0] * x[1]).abs(), x.prod(0) + z.prod(0)).mean())


def stop(clip: Clip, real: Clip) -> float:
    """Speed of the hips where the real ones stand, m/s, lower is better.

    The real hips stand where they are slower than `STILL` for a second before. NaN if they never
    do.
    """
    check_pair(clip, real)
    own, theirs = (contacts.velocities(hips_path(each), each.fps).norm(dim=-1)
                   for each in (clip, real))
    second = round(clip.fps)
    if len(clip) <= second:
        return math.nan
    stands = (theirs < STILL).unfold(0, second, 1).all(-1)
    return float(own[second - 1:][stands].mean())


def phase_error(phase: Tensor, truth: Tensor) -> tuple[Tensor, Tensor]:
    """Mean circular distance of phases ``[F, ...]`` without their constant lag, and the lag.

    The start of a cycle is a convention: the cycle of a foot may start at the middle of its contact
    or at toe-off. Both results ``[...]`` are in radians: the mean distance over the frames in
    [0, π], near π/2 for unrelated phases, and the lead of ``phase`` in [−π, π].
    """
    gap = (phase - truth).double()
    lag = torch.atan2(gap.sin().mean(0), gap.cos().mean(0))
    rest = gap - lag
    return torch.atan2(rest.sin(), rest.cos()).abs().mean(0).to(phase), lag.to(phase)

