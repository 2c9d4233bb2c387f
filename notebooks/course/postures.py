"""How a body holds itself, in five numbers."""

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
