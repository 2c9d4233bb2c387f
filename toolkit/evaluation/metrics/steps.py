"""What feet do: contacts, steps and skate, by our own measures and by those of four papers.

The papers' measures use heights above the standing height of the clip's toes
(`toolkit.motion.contacts.standing_height`), so that they do not depend on where a rig has its toe
joint or a file its floor. The sources use the height above y = 0 or above the lowest toe.
"""

import math
from itertools import pairwise

import torch
from torch import Tensor

from toolkit.evaluation.metrics.bodies import hips_path
from toolkit.motion import Clip, contacts
from toolkit.motion.skeleton import FEET
from toolkit.motion.tensors import as_tensor


def foot_skate(clip: Clip, contact: Tensor | None = None) -> dict[str, float]:
    """Mean speed of each toe while it is in contact, in three dimensions, m/s.

    ``contact [F, 2]`` is in [0, 1], right and left, for example of a network. By default a toe is
    in contact when it is low, at any speed: a speed limit would exclude the skating that is
    measured. The result has ``right`` and ``left``; NaN for a foot that is never in contact.
    ValueError if the contacts do not have the clip's frames.
    """
    contact = (contacts.detect(clip, height=contacts.HEIGHT, speed=math.inf) if contact is None
               else _checked(clip, contact))
    speeds = contacts.velocities(contacts.toes_of(clip), clip.fps).norm(dim=-1)
    return {side: float(speeds[contact[:, i] > 0.5, i].mean()) for i, side in enumerate(FEET)}


def feet(clip: Clip, contact: Tensor | None = None) -> dict[str, float]:
    """What feet do, in four numbers that tell sliding, swing and haste apart.

    Compare them with those of real motion: ``skate``, mean horizontal speed of toes in contact,
    m/s; ``clearance``, metres: how high a toe is lifted between two contacts over where it stands
    (mean over the swings of both feet); ``steps``, landings per second; ``acceleration``, 99th
    percentile of the toes', m/s². NaN where there is no contact or no swing.

    ``contact`` is that of `foot_skate`, but by default that of `toolkit.motion.contacts.detect`: a
    toe that is low and slow, so that skate is under its limit of speed. ValueError also if the clip
    has fewer than three frames.
    """
    contact = contacts.detect(clip) if contact is None else _checked(clip, contact)
    if len(clip) < 3:
        raise ValueError(f"{clip.name}: acceleration needs three frames, got {len(clip)}")
    toes = contacts.toes_of(clip)
    velocity = contacts.velocities(toes, clip.fps)
    contact = contact > 0.5
    swings = []
    for side in range(len(FEET)):
        on, height = contact[:, side], toes[:, side, 1]
        floor = height[on].median()
        for a, b in pairwise(on.nonzero()[:, 0].tolist()):
            if b > a + 1:  # frames in the air between two contacts
                swings.append(float(height[a + 1 : b].max() - floor))
    acceleration = (velocity[2:] - velocity[1:-1]).mul(clip.fps).norm(dim=-1)
    return {
        "skate": float(velocity[..., [0, 2]].norm(dim=-1)[contact].mean()),
        "clearance": sum(swings) / len(swings) if swings else math.nan,
        "steps": step_rate(contact.float(), clip.fps),
        "acceleration": float(acceleration.flatten().quantile(0.99)),
    }


def step_rate(contact: Tensor, fps: float) -> float:
    """Landings of both feet per second, from contacts ``[F, 2]`` in [0, 1].

    It is 0 for a character that only slides.
    """
    on = contact > 0.5
    return int((on[1:] & ~on[:-1]).sum()) * fps / len(contact)


def skate_smoodi(clip: Clip) -> float:
    """Foot-skate ratio of SMooDi (Zhong et al. 2024): share of frames in [0, 1], lower is better.

    At 20 Hz, a toe skates between two frames if it is lower than 5 cm in both, and both its
    horizontal speed and the mean of that speed over five frames (0 beyond the ends) are more than
    0.5 m/s. A frame counts if either foot skates.

    Source: github.com/neu-vi/SMooDi, ``mld/models/metrics/tm2t.py``; after Karunratanakul et al.
    2023 (GMD).
    """
    toes, height = _toes(clip, 20.0)
    speed = toes.diff(dim=0)[..., [0, 2]].norm(dim=-1) * 20.0
    mean = torch.nn.functional.avg_pool1d(speed.T[:, None], 5, stride=1, padding=2)[:, 0].T
    return float((_low(height) & (speed > 0.5) & (mean > 0.5)).any(1).float().mean())


def skate_kimodo(clip: Clip) -> float:
    """Foot-skate ratio of Kimodo (NVIDIA 2026): share in [0, 1] of the time on the floor.

    A toe is on the floor between two frames if it is lower than 5 cm in both. It skates if its
    speed, also upwards, is more than 0.2 m/s. The ratio is over both toes, 0 if no toe is ever on
    the floor; lower is better.

    Source: github.com/nv-tlabs/kimodo, ``kimodo/metrics/foot_skate.py``, ``FootSkateRatio``.
    """
    toes, height = _toes(clip)
    low = _low(height)
    skates = low & (toes.diff(dim=0).norm(dim=-1) * clip.fps > 0.2)
    return int(skates.sum()) / max(1, int(low.sum()))


def skate_camdm(clip: Clip) -> float:
    """Foot sliding of CAMDM (Chen et al. 2024): a ratio of distances, no unit, lower is better.

    Mean horizontal displacement to the next frame of toes lower than 1 cm, over the mean horizontal
    displacement of the root. The last frame has displacement 0. The ratio is 0 if no toe is low; a
    root that does not move at all counts as 1 cm a frame. Departure: the root is the joint with the
    role ``hips``, because the first joint of some rigs stays at the origin.

    Source: github.com/AIGAnimation/CAMDM, ``Evaluation/utils/motion_modules.py``,
    ``cal_metric_foot_sliding``.
    """
    toes, height = _toes(clip)
    step = toes.diff(dim=0, append=toes[-1:])[..., [0, 2]].norm(dim=-1)
    way, low = float(hips_path(clip).diff(dim=0).norm(dim=-1).mean()), height < 0.01
    return float(step[low].mean()) / (way or 0.01) if low.any() else 0.0


def skate_rsmt(clip: Clip) -> float:
    """Foot skate of RSMT (Tang et al. 2023), after Zhang et al. 2018 (MANN): m/s, lower is better.

    The speed of a toe, also upwards, times a weight ``clamp(2 − 2^(h / 2.5), 0, 1)`` of its height
    h in cm at the end of the step, mean over the toes and frames whose weight is not 0; 0 if there
    is none. Departures: the source's unit is cm per frame at 30 Hz (ours times 100 / 30); it also
    sums over the ankles, which are seldom lower than 2.5 cm, and takes the absolute height.

    Source: github.com/yuyujunjun/RSMT-Realtime-Stylized-Motion-Transition, ``benchmark.py``,
    ``skating_loss``.
    """
    toes, height = _toes(clip)
    weight = (2 - 2 ** (100 * height[1:] / 2.5)).clamp(0, 1)
    speed = toes.diff(dim=0).norm(dim=-1) * clip.fps
    return float((speed * weight).sum()) / max(1, int((weight > 0).sum()))


def _checked(clip: Clip, contact: Tensor) -> Tensor:
    contact = as_tensor(contact, "contacts", clip.rotations)
    if contact.shape != (len(clip), len(FEET)):
        raise ValueError(f"contacts of {len(clip)} frames have the shape [{len(clip)}, 2], "
                         f"got {list(contact.shape)}")
    return contact


def _toes(clip: Clip, fps: float | None = None) -> tuple[Tensor, Tensor]:
    """Positions ``[F, 2, 3]`` of the toes at a rate, and their heights ``[F, 2]``."""
    sampled = clip if fps is None or len(clip) < 2 else clip.resample(fps)
    if len(sampled) < 2:
        raise ValueError(f"{clip.name}: foot skate needs two frames at {sampled.fps:g} Hz, "
                         f"the clip lasts {clip.seconds:.2f} s")
    toes = contacts.toes_of(sampled)
    return toes, toes[..., 1] - contacts.standing_height(clip)


def _low(height: Tensor) -> Tensor:
    """Whether a toe is lower than 5 cm in a frame and in the next one, ``[F - 1, 2]``."""
    return (height[:-1] < 0.05) & (height[1:] < 0.05)
