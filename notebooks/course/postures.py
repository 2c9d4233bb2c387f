"""How a body holds itself: five numbers, and the part of it that is unusual."""

import torch
from torch import Tensor

from toolkit.features import Layout


def posture(layout: Layout, positions: Tensor) -> dict[str, Tensor]:
    """Mean posture and step length, from joint positions in the root frame, as a network has them.

    Of ``positions [F, ..., J, 3]`` over some seconds, metres, each ``[...]``: the means of
    ``hips_height``, ``hand_height`` (of both) and ``arm_spread`` (left to right hand, sideways);
    ``step_length``, the fore and aft distance of the ankles (95th percentile); and
    ``bone_stretch``, the mean absolute error of the bone lengths. ``layout`` names the J joints.
    """
    roles = layout.skeleton.roles
    role = {r: positions[..., layout.names.index(roles[r]), :] for r in
            ("hips", "left_hand", "right_hand", "left_foot", "right_foot")}
    rest = layout.skeleton.rest_positions[list(layout.skeleton.feature_joints)].to(positions)
    stretch = (layout.bone_lengths(positions) - layout.bone_lengths(rest)).abs()
    stride = (role["left_foot"] - role["right_foot"])[..., 2].abs()
    return {
        "hips_height": role["hips"][..., 1].mean(0),
        "hand_height": (role["left_hand"] + role["right_hand"])[..., 1].mean(0) / 2,
        "arm_spread": (role["left_hand"] - role["right_hand"])[..., 0].mean(0),
        "step_length": stride.quantile(0.95, 0),
        "bone_stretch": stretch.mean((0, -1)),
    }


PARTS = {"arms": ("Collar", "Shoulder", "Elbow", "Wrist"),
         "legs": ("RightHip", "LeftHip", "Knee", "Ankle", "Toe"), "trunk": ("",)}


def part(layout: Layout, poses: Tensor) -> list[str]:
    """The part of the body (``arms``, ``legs``, ``trunk``) in which each mean pose is unusual.

    For each part, it is the distance of ``poses [S, 3 J]`` from their mean, over the mean of this
    distance in all poses. So arms, which differ by much in every style, do not always win.
    """
    of = [next(name for name, words in PARTS.items() if any(word in joint for word in words))
          for joint in layout.names]
    away = (poses - poses.mean(0)).unflatten(1, (-1, 3)).norm(dim=2)
    each = torch.stack([away[:, [name == x for x in of]].mean(1) for name in PARTS], 1)
    return [list(PARTS)[k] for k in (each / each.mean(0)).argmax(1).tolist()]
