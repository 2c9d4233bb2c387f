"""What feet do: contacts, steps and skate, by our own measures and by Kimodo's."""

import math
from itertools import pairwise

from torch import Tensor

from toolkit.motion import Clip, contacts
from toolkit.motion.skeleton import FEET
from toolkit.motion.tensors import as_tensor


def foot_skate(clip: Clip, contact: Tensor | None = None) -> dict[str, float]:
    """Mean speed of each toe while it is in contact, in three dimensions, m/s.

    ``contact [F, 2]`` is in [0, 1], right and left, for example of a network. By default a toe is
    in contact when it is low, at any speed: a speed limit would exclude the skating that is
    measured. The result has ``right`` and ``left``; NaN for a foot that is never in contact.

    Raises
    ------
    ValueError
        If the contacts do not have the clip's frames.
    """
    low = contacts.detect(clip, height=contacts.HEIGHT, speed=math.inf)
    contact = low if contact is None else _checked(clip, contact)
    speeds = contacts.velocities(contacts.toes_of(clip), clip.fps).norm(dim=-1)
    return {side: float(speeds[contact[:, i] > 0.5, i].mean()) for i, side in enumerate(FEET)}


def feet(clip: Clip, contact: Tensor | None = None) -> dict[str, float]:
    """What feet do, in four numbers that tell sliding, swing and haste apart.

    Compare them with those of real motion.

    Parameters
    ----------
    clip
        The motion.
    contact : Tensor [F, 2], optional
        Contacts in [0, 1], right and left, for example those of a network. By default those of
        `toolkit.motion.contacts.detect`: a toe that is low and slow, so that skate is under its
        limit of speed.

    Returns
    -------
    dict
        ``skate``, mean horizontal speed of toes in contact, m/s; ``clearance``, metres: how high a
        toe is lifted between two contacts over where it stands (mean over the swings of both
        feet); ``steps``, landings per second; ``acceleration``, 99th percentile of the toes',
        m/s². NaN where there is no contact or no swing.

    Raises
    ------
    ValueError
        If contacts are not of the clip's frames, or the clip has fewer than three frames.
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


def skate_kimodo(clip: Clip) -> float:
    """Foot-skate ratio of Kimodo (NVIDIA 2026): share in [0, 1] of the time on the floor.

    A toe is on the floor between two frames if it is lower than 5 cm in both. It skates if its
    speed, also upwards, is more than 0.2 m/s. The ratio is over both toes, 0 if no toe is ever on
    the floor; lower is better. Heights are above the standing height of the clip's toes
    (`toolkit.motion.contacts.standing_height`), so that they do not depend on where a rig has its
    toe joint or a file its floor; the source has those above y = 0.

    Source: github.com/nv-tlabs/kimodo, ``kimodo/metrics/foot_skate.py``, ``FootSkateRatio``.
    """
    if len(clip) < 2:
        raise ValueError(f"{clip.name}: foot skate needs two frames, the clip has {len(clip)}")
    toes = contacts.toes_of(clip)
    height = toes[..., 1] - contacts.standing_height(clip)
    low = (height[:-1] < 0.05) & (height[1:] < 0.05)
    skates = low & (toes.diff(dim=0).norm(dim=-1) * clip.fps > 0.2)
    return int(skates.sum()) / max(1, int(low.sum()))


def _checked(clip: Clip, contact: Tensor) -> Tensor:
    contact = as_tensor(contact, "contacts", clip.rotations)
    if contact.shape != (len(clip), len(FEET)):
        raise ValueError(f"contacts of {len(clip)} frames have the shape [{len(clip)}, 2], "
                         f"got {list(contact.shape)}")
    return contact
