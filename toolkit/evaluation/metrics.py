"""Measures of motion that a mean squared error does not show. Metres, seconds."""

import math

import torch
from torch import Tensor

from toolkit.features import Layout
from toolkit.motion import Clip, Skeleton
from toolkit.motion.clip import FEET, SIDES
from toolkit.motion.contacts import HEIGHT, detect, toes_of, velocities
from toolkit.motion.tensors import as_tensor


def foot_skate(clip: Clip, contact: Tensor | None = None) -> dict[str, float]:
    """Mean horizontal speed of each toe while it is in contact, m/s.

    ``contact [F, 2]`` is in [0, 1], right and left, for example of a network. By default a toe is in contact when it is low,
    at any speed: a speed limit would exclude the skating that is measured. The result has ``right`` and ``left``; NaN for a
    foot that is never in contact.

    Raises
    ------
    ValueError
        If the contacts do not have the clip's frames.
    """
    contact = detect(clip, height=HEIGHT, speed=math.inf) if contact is None else _checked(clip, contact)
    speeds = velocities(toes_of(clip), clip.fps)[..., [0, 2]].norm(dim=-1)
    return {side: float(speeds[contact[:, i] > 0.5, i].mean()) for i, side in enumerate(FEET)}


def _checked(clip: Clip, contacts: Tensor) -> Tensor:
    contacts = as_tensor(contacts, "contacts", clip.rotations)
    if contacts.shape != (len(clip), len(FEET)):
        raise ValueError(f"contacts of {len(clip)} frames have the shape [{len(clip)}, 2], got {list(contacts.shape)}")
    return contacts


def feet(clip: Clip, contacts: Tensor | None = None) -> dict[str, float]:
    """What feet do, in four numbers that tell sliding, swing and haste apart; compare them with those of real motion.

    Parameters
    ----------
    clip
        The motion.
    contacts : Tensor [F, 2], optional
        Contacts in [0, 1], right and left, for example those of a network; where not given those of
        `toolkit.motion.contacts.detect`: a toe that is low and slow, so that skate is under its limit of speed.

    Returns
    -------
    dict
        ``skate``, mean horizontal speed of toes in contact, m/s; ``clearance``, metres: how high a toe is lifted between two
        contacts over where it stands (mean over the swings of both feet); ``steps``, landings per second; ``acceleration``,
        99th percentile of the toes', m/s². NaN where there is no contact or no swing.

    Raises
    ------
    ValueError
        If contacts are not of the clip's frames, or the clip has fewer than three frames.
    """
    contact = detect(clip) if contacts is None else _checked(clip, contacts)
    if len(clip) < 3:
        raise ValueError(f"{clip.name}: acceleration needs three frames, got {len(clip)}")
    toes = toes_of(clip)
    velocity, contact = velocities(toes, clip.fps), contact > 0.5
    swings = []
    for side in range(len(FEET)):
        on, height = contact[:, side], toes[:, side, 1]
        stand = on.nonzero()[:, 0]
        swings += [float(height[a + 1 : b].max() - height[on].median())
                   for a, b in zip(stand[:-1].tolist(), stand[1:].tolist(), strict=True) if b > a + 1]
    return {
        "skate": float(velocity[..., [0, 2]].norm(dim=-1)[contact].mean()),
        "clearance": sum(swings) / len(swings) if swings else math.nan,
        "steps": step_rate(contact.float(), clip.fps),
        "acceleration": float((velocity[2:] - velocity[1:-1]).mul(clip.fps).norm(dim=-1).flatten().quantile(0.99)),
    }


def step_rate(contact: Tensor, fps: float) -> float:
    """Landings of both feet per second, from contacts ``[F, 2]`` in [0, 1]; 0 for a character that only slides."""
    on = contact > 0.5
    return int((on[1:] & ~on[:-1]).sum()) * fps / len(contact)


def speed(clip: Clip) -> float:
    """Mean horizontal speed of the hips, smoothed over half a second, m/s."""
    hips = clip.global_positions[:, clip.skeleton.role("hips")][:, [0, 2]]
    lag = max(1, min(len(clip) - 1, round(clip.fps / 2)))
    return float((hips[lag:] - hips[:-lag]).norm(dim=-1).mean() * clip.fps / lag)


def hips_height(clip: Clip) -> tuple[float, float]:
    """Lowest and highest height of the hips in the clip, metres."""
    height = clip.global_positions[:, clip.skeleton.role("hips"), 1]
    return float(height.min()), float(height.max())


def upright(clip: Clip) -> bool:
    """Whether the character is on its feet in every frame, see `on_feet`."""
    return bool(on_feet(clip.skeleton, clip.global_positions[..., 1]).all())


def on_feet(skeleton: Skeleton, height: Tensor) -> Tensor:
    """Whether the chest is above the hips and the hips above both ankles ``[...]``, from heights of joints ``[..., J]``."""
    hips, chest = height[..., skeleton.role("hips")], height[..., skeleton.trunk[0]]
    ankles = height[..., [skeleton.role(f"{side}_foot") for side in FEET]].amax(-1)
    return (chest > hips) & (hips > ankles)


def posture(layout: Layout, positions: Tensor) -> dict[str, Tensor]:
    """Mean posture and step length, from joint positions in the root frame as a network predicts them.

    Of ``positions [F, ..., J, 3]`` over some seconds, metres, each ``[...]``: the means of ``hips_height``, ``hand_height``
    (of both) and ``arm_spread`` (left to right hand, sideways); ``step_length``, the fore and aft distance of the ankles
    (95th percentile); and ``bone_stretch``, the mean absolute error of the bone lengths. ``layout`` names the J joints.
    """
    role = {r: positions[..., layout.names.index(n), :] for r, n in layout.skeleton.roles.items() if n in layout.names}
    rest = layout.skeleton.rest_positions[list(layout.skeleton.feature_joints)].to(positions)
    return {
        "hips_height": role["hips"][..., 1].mean(0),
        "hand_height": (role["left_hand"] + role["right_hand"])[..., 1].mean(0) / 2,
        "arm_spread": (role["left_hand"] - role["right_hand"])[..., 0].mean(0),
        "step_length": (role["left_foot"] - role["right_foot"])[..., 2].abs().quantile(0.95, 0),
        "bone_stretch": (layout.bone_lengths(positions) - layout.bone_lengths(rest)).abs().mean((0, -1)),
    }


def hand_swing(layout: Layout, positions: Tensor) -> dict[str, Tensor]:
    """Range of motion of the hands and their correlation, from joint positions in the root frame.

    A mean pose has a low mean squared error, but its arms do not move (Mason et al. 2022, sections 5.1 and 5.2.2).

    Of ``positions [F, ..., J, 3]`` over some seconds, metres: ``range [..., 2]``, the root-mean-square distance of the left
    and the right hand from their mean positions, metres; and ``together [...]``, the correlation of the fore and aft motion
    of both hands: 1 if they swing together, -1 if alternately, NaN if one does not move. ``layout`` names the J joints.
    """
    hands = positions[..., [layout.names.index(layout.skeleton.roles[f"{side}_hand"]) for side in SIDES], :]
    moved = hands - hands.mean(0)
    left, right = moved[..., 2].unbind(-1)
    together = (left * right).sum(0) / (left.square().sum(0) * right.square().sum(0)).sqrt()
    return {"range": moved.square().sum(-1).mean(0).sqrt(), "together": together}


def path_error(clip: Clip, points: Tensor) -> float:
    """Mean distance of the hips on the floor from a polyline of (x, z) ``points [P, 2]``, metres."""
    hips = clip.global_positions[:, clip.skeleton.role("hips")][:, None, [0, 2]]
    points = as_tensor(points, "points", hips)
    a, b = points[None, :-1], points[None, 1:]
    along = (((hips - a) * (b - a)).sum(-1) / (b - a).square().sum(-1).clamp_min(1e-12)).clamp(0.0, 1.0)
    return float((hips - a - along[..., None] * (b - a)).norm(dim=-1).amin(1).mean())


def phase_error(phase: Tensor, truth: Tensor) -> tuple[Tensor, Tensor]:
    """Mean circular distance of two phases after subtraction of their constant lag.

    The start of a cycle is a convention: the cycle of a foot may start at the middle of its contact or at toe-off.

    Parameters
    ----------
    phase, truth : Tensor [F, ...]
        Radians.

    Returns
    -------
    error, lag : Tensor [...]
        Radians: the mean over the frames in [0, π], near π/2 for unrelated phases, and the lead of ``phase`` in [−π, π].
    """
    gap = (phase - truth).double()
    lag = torch.atan2(gap.sin().mean(0), gap.cos().mean(0))
    rest = gap - lag
    return torch.atan2(rest.sin(), rest.cos()).abs().mean(0).to(phase), lag.to(phase)


def frechet_distance(a: Tensor, b: Tensor) -> float:
    """Squared Fréchet distance of the Gaussians fitted to two sets of feature vectors.

    ``|μa − μb|² + tr(Σa + Σb − 2 (Σa Σb)^½)``. With the features of a motion classifier it is the Fréchet Motion Distance
    (Park et al. 2021, section 7). It is biased upwards for small sets: compare only values of sets of the same size.

    The features are ``a [M, D]`` and ``b [K, D]``; M and K may differ and be smaller than D.

    Raises
    ------
    ValueError
        If a set has fewer than two rows or the widths differ.
    """
    if a.dim() != 2 or b.dim() != 2 or a.shape[1] != b.shape[1] or min(len(a), len(b)) < 2:
        raise ValueError(f"expected features [M, D] and [K, D], M and K at least 2; got {list(a.shape)} and {list(b.shape)}")
    means = [x.double().mean(0) for x in (a, b)]
    roots = [torch.linalg.qr(x.double() - mean).R / math.sqrt(len(x) - 1) for x, mean in zip((a, b), means, strict=True)]
    spread = sum(root.square().sum() for root in roots) - 2 * torch.linalg.svdvals(roots[0] @ roots[1].T).sum()
    return max(0.0, float((means[0] - means[1]).square().sum() + spread))  # Σ = RᵀR: no root of a singular matrix
