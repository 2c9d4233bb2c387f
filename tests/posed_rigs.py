"""Rigs of other rest poses, local axes, proportions and joints than 100STYLE's."""

from collections.abc import Callable

import torch

import toolkit as tk
from toolkit.datasets.procedural import SKELETON
from toolkit.motion import local_rotations, rotations as R

POSES = ("T-pose", "A-pose", "hanging", "along x", "along y")


def turn(side: float, degrees: float) -> torch.Tensor:
    """About z, so that the arm of a side is lowered."""
    return R.from_axis_angle(torch.tensor([0.0, 0.0, -side]), torch.deg2rad(torch.tensor(degrees)))


def frames_of(pose: str, offsets: torch.Tensor) -> torch.Tensor:
    """World rotations [J, 4] of the local frames of joints in a T-pose that faces +z."""
    own = R.identity(len(SKELETON))
    down = {"A-pose": 50.0, "hanging": 85.0}.get(pose)
    for j, name in enumerate(SKELETON.names):
        side = 1.0 if name.startswith("Left") else -1.0
        if down and any(part in name for part in ("Shoulder", "Elbow", "Wrist")):
            own[j] = R.inverse(turn(side, down))  # zero rotation is the lowered arm
        elif pose.startswith("along"):
            below = [k for k, p in enumerate(SKELETON.parents) if p == j] or [j]
            axis = torch.eye(3)["xy".index(pose[-1])]
            own[j] = R.between(axis, offsets[below].mean(0) if len(below) > 1
                               else offsets[below[0]])
    return own


def rig(pose: str, *, arms: float = 1.0, legs: float = 1.0, hips: float = 1.0,
        turned: torch.Tensor | None = None,
        joints: Callable[[dict, dict], tuple[dict, dict]] | None = None) -> tk.Clip:
    """One frame of a rig in T-pose, with its own names, proportions and local frames.

    ``joints`` changes the rows of its skeleton, name: (parent, offset, world rotation of the local
    frame), and its roles.
    """
    offsets = SKELETON.offsets.clone()
    for j, name in enumerate(SKELETON.names):
        offsets[j] *= arms if any(part in name for part in ("Elbow", "Wrist")) else 1.0
        offsets[j] *= legs if any(part in name for part in ("Knee", "Ankle")) else 1.0
        offsets[j] *= hips if name.endswith("Hip") else 1.0
    own = frames_of(pose, offsets)
    if turned is not None:  # zero rotations face another way or lie on their back
        own = R.multiply(own, R.inverse(turned))
    local = offsets.clone()
    local[1:] = R.rotate(R.inverse(own[list(SKELETON.parents[1:])]), offsets[1:])
    names = [f"rig:{name}" for name in SKELETON.names]
    above = [None] + [names[parent] for parent in SKELETON.parents[1:]]
    rows = dict(zip(names, zip(above, local, own, strict=True), strict=True))
    roles = {role: f"rig:{name}" for role, name in SKELETON.roles.items()}
    if joints is not None:
        rows, roles = joints(rows, roles)
    above, local, own = zip(*rows.values(), strict=True)
    parents = [list(rows).index(name) if name else -1 for name in above]
    skeleton = tk.Skeleton(tuple(rows), parents, torch.stack(local), roles)
    return tk.Clip(skeleton, local_rotations(skeleton, torch.stack(own)[None]),
                   torch.tensor([[0.0, 0.95, 0.0]]), 60.0, name=pose)


def with_twists(rows: dict, roles: dict) -> tuple[dict, dict]:
    """A joint in the middle of upper arms and thighs, fingers, a root above the hips."""
    made = {"root": (None, torch.zeros(3), R.identity())}
    for name, (above, offset, own) in rows.items():
        above = above or "root"
        if any(part in name for part in ("Elbow", "Knee")):
            offset = offset / 2
            made[f"{name}Twist"] = above, offset, rows[above][2]
            above = f"{name}Twist"
        made[name] = above, offset, own
        if name.endswith("Wrist"):
            made[f"{name}Thumb"] = name, torch.tensor([0.03, 0.02, 0.03]), own
    return made, roles


def without_toes(rows: dict, roles: dict) -> tuple[dict, dict]:
    """No toes, and shoulders fixed to the chest."""
    made = {}
    for name, (above, offset, own) in rows.items():
        if "Collar" in (above or ""):
            above, more, _ = rows[above]
            offset = offset + more
        if "Toe" not in name and "Collar" not in name:
            made[name] = above, offset, own
    return made, {role: name for role, name in roles.items() if name in made}


def with_soles(rows: dict, roles: dict) -> tuple[dict, dict]:
    """Feet that end straight below the ankle."""
    rows, roles = without_toes(rows, roles)
    for side in ("left", "right"):
        ankle = roles[f"{side}_foot"]
        roles[f"{side}_toe"] = f"{ankle}End"
        rows[f"{ankle}End"] = ankle, torch.tensor([0.0, -0.08, 0.0]), rows[ankle][2]
    return rows, roles
