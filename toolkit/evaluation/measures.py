"""The field's measures of motion, each as its source defines it. Metres, seconds, radians.

Heights are above the standing height of the clip's toes (`toolkit.motion.contacts.standing_height`), so that a measure does
not depend on where a rig has its toe joint or a file its floor. The sources use the height above y = 0 or above the lowest
toe. Where we depart otherwise, the docstring of the measure says so. `CLIP`, `PAIR` and `SET` sort the measures by what they
need: a clip; a clip and the real clip with the same frames; a recogniser of styles and many clips.
"""

import math
from collections import defaultdict
from collections.abc import Callable, Sequence

import torch
from torch import Tensor

from toolkit.evaluation.metrics import frechet_distance
from toolkit.evaluation.recognition import Recogniser
from toolkit.motion import Clip, contacts, root_frames, trajectory
from toolkit.motion import rotations as R

STILL = 0.1  # m/s; slower hips have no direction of movement


def _toes(clip: Clip, fps: float | None = None) -> tuple[Tensor, Tensor]:
    """Positions ``[F, 2, 3]`` of the toes at a rate, and their heights ``[F, 2]`` above the clip's standing height."""
    if len(clip) < 2:
        raise ValueError(f"{clip.name}: foot skate needs two frames, the clip has {len(clip)}")
    sampled = clip if fps is None else clip.resample(fps)
    if len(sampled) < 2:
        raise ValueError(f"{clip.name}: foot skate needs two frames at {fps:g} Hz, the clip lasts {clip.seconds:.2f} s")
    toes = contacts.toes_of(sampled)
    return toes, toes[..., 1] - contacts.standing_height(clip)


def skate_smoodi(clip: Clip) -> float:
    """Foot-skate ratio of SMooDi (Zhong et al. 2024): share of frames in [0, 1], lower is better.

    At 20 Hz, a toe skates between two frames if it is lower than 5 cm in both, and both its horizontal speed and the mean of
    that speed over five frames (0 beyond the ends) are more than 0.5 m/s. A frame counts if either foot skates.

    Source: github.com/neu-vi/SMooDi, ``mld/models/metrics/tm2t.py``; after Karunratanakul et al. 2023 (GMD).
    """
    toes, height = _toes(clip, 20.0)
    speed = toes.diff(dim=0)[..., [0, 2]].norm(dim=-1) * 20.0
    mean = torch.nn.functional.avg_pool1d(speed.T[:, None], 5, stride=1, padding=2)[:, 0].T
    low = (height[:-1] < 0.05) & (height[1:] < 0.05)
    return float((low & (speed > 0.5) & (mean > 0.5)).any(1).float().mean())


def skate_kimodo(clip: Clip) -> float:
    """Foot-skate ratio of Kimodo (NVIDIA 2026): share in [0, 1] of the time on the floor, lower is better.

    A toe is on the floor between two frames if it is lower than 5 cm in both. It skates if its speed, also upwards, is more
    than 0.2 m/s. The ratio is over both toes; it is 0 if no toe is ever on the floor.

    Source: github.com/nv-tlabs/kimodo, ``kimodo/metrics/foot_skate.py``, ``FootSkateRatio``.
    """
    toes, height = _toes(clip)
    low = (height[:-1] < 0.05) & (height[1:] < 0.05)
    skates = low & (toes.diff(dim=0).norm(dim=-1) * clip.fps > 0.2)
    return int(skates.sum()) / max(1, int(low.sum()))


def skate_camdm(clip: Clip) -> float:
    """Foot sliding of CAMDM (Chen et al. 2024): a ratio of distances without unit, lower is better.

    Mean horizontal displacement to the next frame of toes lower than 1 cm, over the mean horizontal displacement of the
    root. The last frame has displacement 0. The ratio is 0 if no toe is low; a root that does not move at all counts as
    1 cm a frame. Departure: the root is the joint with the role ``hips``, because the first joint of some rigs stays at the
    origin.

    Source: github.com/AIGAnimation/CAMDM, ``Evaluation/utils/motion_modules.py``, ``cal_metric_foot_sliding``.
    """
    toes, height = _toes(clip)
    step = toes.diff(dim=0, append=toes[-1:])[..., [0, 2]].norm(dim=-1)
    hips = clip.global_positions[:, clip.skeleton.role("hips")][:, [0, 2]]
    way, low = float(hips.diff(dim=0).norm(dim=-1).mean()), height < 0.01
    return float(step[low].mean()) / (way or 0.01) if low.any() else 0.0


def skate_rsmt(clip: Clip) -> float:
    """Foot skate of RSMT (Tang et al. 2023), after Zhang et al. 2018 (MANN): m/s, lower is better.

    The speed of a toe, also upwards, times a weight ``clamp(2 − 2^(h / 2.5), 0, 1)`` of its height h in cm at the end of the
    step, mean over the toes and frames whose weight is not 0; 0 if there is none. Departures: the source's unit is cm per
    frame at 30 Hz (ours times 100 / 30); it also sums over the ankles, which are seldom lower than 2.5 cm, and takes the
    absolute height.

    Source: github.com/yuyujunjun/RSMT-Realtime-Stylized-Motion-Transition, ``benchmark.py``, ``skating_loss``.
    """
    toes, height = _toes(clip)
    weight = (2 - 2 ** (100 * height[1:] / 2.5)).clamp(0, 1)
    speed = toes.diff(dim=0).norm(dim=-1) * clip.fps
    return float((speed * weight).sum()) / max(1, int((weight > 0).sum()))


def check_pair(clip: Clip, real: Clip) -> None:
    """Raise a ValueError unless two clips have the same joints, frames and rate."""
    if clip.skeleton.names != real.skeleton.names:
        raise ValueError(f"{clip.name} and {real.name}: the joints differ; retarget one to the skeleton of the other")
    if (len(clip), clip.fps) != (len(real), real.fps):
        raise ValueError(f"{clip.name} and {real.name}: expected the same frames, got {len(clip)} at {clip.fps:g} Hz and "
                         f"{len(real)} at {real.fps:g} Hz; cut or resample one")


def npss(clip: Clip, real: Clip) -> float:
    """Normalised power spectrum similarity (Gopalakrishnan et al. 2019): no unit, lower is better, 0 for equal motions.

    For each number of the pose: the power of its Fourier coefficients over time, normalised to the sum 1; the sum over all
    frequencies of the absolute difference of the cumulated powers of clip and real clip (earth mover's distance); mean over
    the numbers, weighted by the real clip's power. The numbers are world quaternions of all joints, as in Harvey et al. 2020
    and RSMT; the source has Euler angles. Signs of quaternions are made continuous, and equal to the real clip's. Harvey et
    al. square only the real part of the coefficients, so their values differ.

    Source: github.com/cr7anand/neural_temporal_models, ``metrics.py``.
    """
    check_pair(clip, real)
    truth = R.unroll(real.global_rotations.double())
    made = R.unroll(clip.global_rotations.to(truth))
    made = made * torch.where((made * truth).sum((0, -1)) < 0, -1.0, 1.0)[:, None].to(made)
    power = [torch.fft.fft(x.flatten(1), dim=0).abs().square() for x in (made, truth)]
    total = [p.sum(0) for p in power]
    share = [(p / torch.where(t > 0, t, 1.0)).cumsum(0) for p, t in zip(power, total, strict=True)]
    return float(((share[0] - share[1]).abs().sum(0) * total[1]).sum() / total[1].sum())


def geodesic(clip: Clip, real: Clip) -> float:
    """Geodesic error: mean angle between the joints' rotations, radians in [0, π], lower is better.

    The rotations are those relative to the parents, the root's that in the world. The angle is that of the rotation
    ``R Rrealᵀ``, the distance on the group of rotations (Huynh 2009, *Metrics for 3D rotations*, Φ6), mean over frames and
    joints.
    """
    check_pair(clip, real)
    return float(_angle(clip.rotations.double(), real.rotations.to(clip.rotations).double()).mean())


def _angle(a: Tensor, b: Tensor) -> Tensor:
    """Angle between rotations ``[..., 4]``, radians; exact near 0, unlike the arc cosine."""
    between = R.multiply(R.inverse(a), b)
    return 2 * torch.atan2(between[..., 1:].norm(dim=-1), between[..., 0].abs())


def global_position(clip: Clip, real: Clip) -> float:
    """Global position error: mean distance of the joints in the world from those of the real clip, metres, lower is better.

    The mean per-joint position error (Ionescu et al. 2014, Human3.6M) without alignment. It is L2P of Harvey et al. 2020
    (*Robust motion in-betweening*) in metres, per joint: theirs is the norm over all joints of z-scores, whose
    statistics differ from one training set to the next.
    """
    check_pair(clip, real)
    return float((clip.global_positions - real.global_positions.to(clip.rotations)).norm(dim=-1).mean())


def global_quaternion(clip: Clip, real: Clip) -> float:
    """Global quaternion error L2Q (Harvey et al. 2020): no unit, lower is better.

    The norm of the difference of all joints' world quaternions, mean over the frames. It grows with the number of joints. Of
    the two signs of a quaternion the one nearer to the real clip's counts.
    """
    check_pair(clip, real)
    a, b = clip.global_rotations, real.global_rotations.to(clip.rotations)
    return float(torch.minimum((a - b).square().sum(-1), (a + b).square().sum(-1)).sum(-1).sqrt().mean())


def trajectory_error(clip: Clip, real: Clip) -> float:
    """Trajectory error (Chen et al. 2024, CAMDM): angle between movements, radians in [0, π], lower is better.

    The directions are those of the hips' horizontal displacement to the next frame. Frames in which either moves slower than
    `STILL` are left out; NaN if all are. Departures: the source has degrees, and the absolute value of the mean of
    differences that are not wrapped; here it is the mean of absolute circular differences.

    Source: github.com/AIGAnimation/CAMDM, ``Evaluation/eval_traj_alignment.py``.
    """
    check_pair(clip, real)
    steps = [c.global_positions[:, c.skeleton.role("hips")][:, [0, 2]].diff(dim=0).to(clip.rotations) * c.fps
             for c in (clip, real)]
    moving = torch.stack([s.norm(dim=-1) >= STILL for s in steps]).all(0)
    return float(_turn(*steps)[moving].mean()) if moving.any() else math.nan


def orientation_error(clip: Clip, real: Clip) -> float:
    """Orientation error (Chen et al. 2024, CAMDM): angle between the facing directions, radians in [0, π], lower is better.

    Facing is that of the root frame. The mean of absolute circular differences over the frames, as in `trajectory_error`.

    Source: github.com/AIGAnimation/CAMDM, ``Evaluation/eval_traj_alignment.py``.
    """
    check_pair(clip, real)
    facing = [torch.stack(trajectory.heading(root_frames(c).rotations), -1).to(clip.rotations) for c in (clip, real)]
    return float(_turn(*facing).mean())


def _turn(a: Tensor, b: Tensor) -> Tensor:
    """Angle between directions ``[..., 2]``, radians in [0, π]."""
    return torch.atan2((a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]).abs(), (a * b).sum(-1))


def fmd(recogniser: Recogniser, clips: Sequence[Clip], real: Sequence[Clip]) -> float:
    """Fréchet motion distance (Park et al. 2021, section 7): no unit, lower is better.

    The FID of Heusel et al. 2017, on motions: `toolkit.evaluation.metrics.frechet_distance` of the recogniser's features
    of all windows of one second. Compare only values of the same recogniser and the same number of windows.
    """
    return frechet_distance(*(torch.cat([recogniser.embed(clip) for clip in some]) for some in (clips, real)))


def _recognition(top: int) -> Callable[[Recogniser, Sequence[Clip]], float]:
    def accuracy(recogniser: Recogniser, clips: Sequence[Clip]) -> float:
        known = [clip for clip in clips if clip.style in recogniser.styles]
        most = min(top, len(recogniser.styles))
        right = [recogniser.styles.index(clip.style) in recogniser.of_clip(clip).topk(most).indices for clip in known]
        return sum(right) / len(right) if right else math.nan

    accuracy.__name__ = accuracy.__qualname__ = f"recognition_top{top}"
    accuracy.__doc__ = f"""Recognition accuracy, top {top} (Zhong et al. 2024, SMooDi): share in [0, 1], higher is better.

    The share of clips whose style is among the {top} most probable ones of the recogniser; NaN if it knows no clip's style.

    Source: github.com/neu-vi/SMooDi, ``mld/models/metrics/tm2t.py``, ``topk_accuracy`` (in percent).
    """
    return accuracy


def diversity(recogniser: Recogniser, clips: Sequence[Clip]) -> float:
    """Diversity (Guo et al. 2020, *Action2Motion*): mean distance of two clips' features, no unit; nearest to real is best.

    The source draws 200 random pairs. This is the mean over all pairs of different clips, its expected value. A clip's
    features are the mean over its windows. NaN for a single clip.
    """
    return _apart(_features(recogniser, clips))


def multimodality(recogniser: Recogniser, clips: Sequence[Clip]) -> float:
    """Multimodality (Guo et al. 2020): as `diversity`, of two clips of one style, mean over styles; nearest to real is best.

    NaN if no style has two clips.
    """
    groups: dict[str, list[Clip]] = defaultdict(list)
    for clip in clips:
        groups[clip.style].append(clip)
    found = [_apart(_features(recogniser, some)) for some in groups.values() if len(some) > 1]
    return sum(found) / len(found) if found else math.nan


def _features(recogniser: Recogniser, clips: Sequence[Clip]) -> Tensor:
    return torch.stack([recogniser.embed(clip).double().mean(0) for clip in clips])


def _apart(x: Tensor) -> float:
    return float(torch.nn.functional.pdist(x).mean()) if len(x) > 1 else math.nan


CLIP: dict[str, Callable[[Clip], float]] = {
    "skate-smoodi": skate_smoodi, "skate-kimodo": skate_kimodo, "skate-camdm": skate_camdm, "skate-rsmt": skate_rsmt,
}
PAIR: dict[str, Callable[[Clip, Clip], float]] = {
    "npss": npss, "geodesic": geodesic, "global-position": global_position, "global-quaternion": global_quaternion,
    "trajectory-error": trajectory_error, "orientation-error": orientation_error,
}
SET: dict[str, Callable[..., float]] = {
    "fmd": fmd, "diversity": diversity, "multimodality": multimodality,
    **{f"recognition-top{top}": _recognition(top) for top in (1, 3, 5)},
}
MEASURES: dict[str, Callable[..., float]] = CLIP | PAIR | SET
UNITS = {"skate-rsmt": "m/s", "global-position": "m"}
UNITS |= dict.fromkeys(("geodesic", "trajectory-error", "orientation-error"), "rad")
BEST = dict.fromkeys(MEASURES, "lower") | dict.fromkeys([name for name in SET if name.startswith("recognition")], "higher")
BEST |= {"diversity": "as real", "multimodality": "as real"}
