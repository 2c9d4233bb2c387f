"""Mean poses of shoulders and hands in closed loop, compared with the data's."""

from course.comparison import nearest
from torch import Tensor

from toolkit.features import Layout, split_joints
from toolkit.motion.roles import SIDES


def posture_error(layout: Layout, joints: Tensor, clips: Tensor, speed: float) -> dict[str, float]:
    """Distance of the mean pose of the shoulders and hands in a walk from that in the style clips
    nearest to it in velocity.

    The arguments are those of `course.comparison.hands`. The result has ``clavicle`` and
    ``hand``, metres, the mean of both sides: shoulders are seen from the chest and hands from their
    shoulder, so they show clavicles and arms alone. ``clavicle_data`` and ``hand_data`` are the
    same between one style clip of the data and the others: what even the data would have.
    """
    skeleton, place = layout.skeleton, layout.names.index

    def mean_pose(y: Tensor) -> dict[str, Tensor]:
        at = split_joints(y)["position"].mean(-3)  # [..., J, 3]
        shoulder, hand = (at[..., [place(skeleton.names[skeleton.role(f"{side}_{part}")])
                                   for side in SIDES], :]
                          for part in ("shoulder", "hand"))
        return {"clavicle": shoulder - at[..., place(skeleton.names[skeleton.trunk[0]]), None, :],
                "hand": hand - shoulder}

    near = nearest(clips, speed)
    made, real = mean_pose(joints), mean_pose(near)
    found = {name: float((made[name] - real[name].mean(0)).norm(dim=-1).mean()) for name in made}
    for name, poses in real.items():
        apart = (poses[:1] - poses[1:]).norm(dim=-1)
        found[f"{name}_data"] = float(apart.mean()) if len(poses) > 1 else 0.0
    return found
