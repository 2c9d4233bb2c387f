"""Rules for foot skate of three papers, beside that of Kimodo in `toolkit.evaluation.MEASURES`.

They use heights above the standing height of the clip's toes
(`toolkit.motion.contacts.standing_height`), so that they do not depend on where a rig has its toe
joint or a file its floor. The sources use the height above y = 0 or above the lowest toe.
"""

import torch
from torch import Tensor

from toolkit.evaluation.metrics import hips_path, skate_kimodo
from toolkit.motion import Clip, contacts


def smoodi(clip: Clip) -> float:
    """Foot-skate ratio of SMooDi (Zhong et al. 2024): share of frames in [0, 1], lower is better.

    At 20 Hz, a toe skates between two frames if it is lower than 5 cm in both, and both its
    horizontal speed and the mean of that speed over five frames (0 beyond the ends) are more than
    0.5 m/s. A frame counts if either foot skates.

    Source: github.com/neu-vi/SMooDi, ``mld/models/metrics/tm2t.py``; after Karunratanakul et al.
    2023 (GMD).
    """
    toes, height = _toes(clip, 20.0)
    low = (height[:-1] < 0.05) & (height[1:] < 0.05)
    speed = toes.diff(dim=0)[..., [0, 2]].norm(dim=-1) * 20.0
    mean = torch.nn.functional.avg_pool1d(speed.T[:, None], 5, stride=1, padding=2)[:, 0].T
    return float((low & (speed > 0.5) & (mean > 0.5)).any(1).float().mean())


def camdm(clip: Clip) -> float:
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


def rsmt(clip: Clip) -> float:
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


def _toes(clip: Clip, fps: float | None = None) -> tuple[Tensor, Tensor]:
    """Positions ``[F, 2, 3]`` of the toes at a rate, and their heights ``[F, 2]``."""
    toes = contacts.toes_of(clip if fps is None else clip.resample(fps))
    return toes, toes[..., 1] - contacts.standing_height(clip)


#: The rules by the names of their papers.
RULES = {"SMooDi": smoodi, "Kimodo": skate_kimodo, "CAMDM": camdm, "RSMT": rsmt}
