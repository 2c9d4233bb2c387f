"""What feet do in a walk: steps, swings, skate and haste."""

import math
from itertools import pairwise

from torch import Tensor

from toolkit.motion import Clip, contacts
from toolkit.motion.skeleton import FEET


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
    contact = contacts.detect(clip) if contact is None else contact
    if contact.shape != (len(clip), len(FEET)):
        raise ValueError(f"contacts of {len(clip)} frames have the shape [{len(clip)}, 2], "
                         f"got {list(contact.shape)}")
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
