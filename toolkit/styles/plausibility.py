"""Plausibility of style vectors: stretched bones, and limbs that penetrate the body.

Mason et al. 2022 name implausible poses of blends as a limitation (section 6, "Physics
Understanding").
"""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import runtime
from toolkit.features import Layout, split_joints
from toolkit.motion.clip import SIDES
from toolkit.motion.tensors import summary
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank

LEG = 0.87  # metres, distance of hip and ankle in the body of `RADII`
RADII = {"forearm": 0.032, "trunk": 0.10, "head": 0.09, "thigh": 0.062, "shank": 0.042,
         "foot": 0.034}  # metres
#: A blend is warned of if it exceeds its styles by more: share of a bone length, metres.
STRETCH, DEPTH = 0.03, 0.02
SPEED = 1.0  # m/s, of the walks
SETTLE = 2.0  # seconds at the start of a walk that are not measured


@dataclass(frozen=True, eq=False)
class Strain:
    """Bone stretch and self-penetration in S walks, means over the frames.

    Bone lengths are those of the network's output; the clips of `toolkit.runtime.record` have
    constant ones. Some styles have a penetration of their own (hands in pockets).
    """

    bone_stretch: Tensor  # [S] largest relative error of a bone length
    penetration: Tensor  # [S] depth of the deepest pair of limb, trunk and head, metres
    __repr__ = summary


def strain(model: Model, vectors: Tensor, seconds: float = 5.0) -> Strain:
    """Bone stretch and self-penetration of walks straight ahead with style vectors ``[S, D]``.

    The first `SETTLE` of the ``seconds`` are not measured; ValueError if there are no others.
    """
    if seconds <= SETTLE:
        raise ValueError(f"strain is measured after {SETTLE:g} s of walking, "
                         f"got seconds = {seconds:g}")
    states = list(runtime.states(model, runtime.straight(SPEED, seconds), vectors))
    poses = [split_joints(state.joints)["position"] for state in states]
    positions = torch.stack(poses[round(SETTLE * runtime.FPS) :])  # [F, S, J, 3]
    return Strain(bone_stretch(model.layout, positions), penetration(model.layout, positions))


def bone_stretch(layout: Layout, positions: Tensor) -> Tensor:
    """Largest relative error of a bone length ``[...]``, mean over F, of ``[F, ..., J, 3]``."""
    rest = layout.skeleton.rest_positions[list(layout.skeleton.feature_joints)].to(positions)
    length, got = layout.bone_lengths(rest), layout.bone_lengths(positions)
    return ((got - length).abs() / length)[..., length > 1e-3].mean(0).amax(-1)


def penetration(layout: Layout, positions: Tensor) -> Tensor:
    """Depth of the deepest pair ``[...]``, metres, mean over F, of positions ``[F, ..., J, 3]``.

    Limbs, trunk and head are capsules. Pairs are both forearms, a forearm with trunk, head or a
    thigh, and the lower legs and feet of both sides. Neighbouring limbs always touch and are not
    tested.
    """
    capsules, pairs = _body(layout)
    tail, head, radius = (torch.tensor(values) for values in zip(*capsules.values(), strict=True))
    order = list(capsules)
    a, b = (torch.tensor([order.index(pair[side]) for pair in pairs]) for side in (0, 1))
    ends = (positions[..., end[which], :] for which in (a, b) for end in (tail, head))
    apart = segment_distance(*ends)
    return (radius[a] + radius[b] - apart).clamp_min(0.0).amax(-1).mean(0)


def segment_distance(a: Tensor, b: Tensor, c: Tensor, d: Tensor) -> Tensor:
    """Smallest distance ``[...]`` of the segments from a to b and from c to d, all ``[..., 3]``."""
    u, v, w = b - a, d - c, a - c
    uu, uv, vv, uw, vw = ((p * q).sum(-1) for p, q in ((u, u), (u, v), (v, v), (u, w), (v, w)))
    # the nearest points lie at shares s and t: those of the lines, then each put on its segment
    s = ((uv * vw - vv * uw) / (uu * vv - uv * uv).clamp_min(1e-9)).clamp(0.0, 1.0)
    t = ((uv * s + vw) / vv.clamp_min(1e-9)).clamp(0.0, 1.0)
    s = ((uv * t - uw) / uu.clamp_min(1e-9)).clamp(0.0, 1.0)
    return (w + s[..., None] * u - t[..., None] * v).norm(dim=-1)


def check(model: Model, bank: StyleBank, blend: Mapping[str, float], seconds: float = 5.0) -> dict:
    """`Strain` of a blend, and the largest of its styles.

    The result has ``bone_stretch``, ``penetration``, ``usual_bone_stretch`` and
    ``usual_penetration``. It warns if the blend exceeds all of its styles by `STRETCH` or `DEPTH`.
    """
    vectors = torch.stack([bank.blend(blend), *(bank[name] for name in blend)])
    found = strain(model, vectors, seconds)
    result, worse = {}, []
    limits = {"bone_stretch": (STRETCH, "bones are stretched by {:.0%} (its styles: {:.0%})"),
              "penetration": (DEPTH, "limbs are {:.3f} m inside the body (its styles: {:.3f} m)")}
    for what, (limit, text) in limits.items():
        here, usual = float(getattr(found, what)[0]), float(getattr(found, what)[1:].max())
        result |= {what: here, f"usual_{what}": usual}
        if here > usual + limit:
            worse.append(text.format(here, usual))
    if worse:
        warnings.warn("the blend is unlike the motion that the model was trained on: "
                      f"{'; '.join(worse)}", stacklevel=2)
    return result


def _body(layout: Layout) -> tuple[dict[str, tuple[int, int, float]], list[tuple[str, str]]]:
    """Capsules (first joint, last joint, radius) by name, and the pairs that must not touch."""
    skeleton, names = layout.skeleton, layout.names
    rest = skeleton.rest_positions[list(skeleton.feature_joints)]
    at = {role: names.index(name) for role, name in skeleton.roles.items() if name in names}
    scale = float((rest[at["left_hip"]] - rest[at["left_foot"]]).norm()) / LEG
    limbs = {"forearm": ("elbow", "hand"), "thigh": ("hip", "knee"), "shank": ("knee", "foot"),
             "foot": ("foot", "toe")}
    capsules = {}
    for side in SIDES:
        for part, (a, b) in limbs.items():
            ends = at[f"{side}_{a}"], at[f"{side}_{b}"]
            capsules[f"{side} {part}"] = (*ends, RADII[part] * scale)
    chest, top = names.index(skeleton.names[skeleton.trunk[0]]), int(rest[:, 1].argmax())
    capsules["trunk"] = at["hips"], chest, RADII["trunk"] * scale
    capsules["head"] = top, top, RADII["head"] * scale
    arms, legs = ("left forearm", "right forearm"), ("shank", "foot")
    body = ("trunk", "head", "left thigh", "right thigh")
    pairs = [arms, *((arm, other) for arm in arms for other in body)]
    return capsules, pairs + [(f"left {a}", f"right {b}") for a in legs for b in legs]
