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
        joints: Callable[[list, list, list], None] | None = None) -> tk.Clip:
    """One frame of a rig in T-pose, with its own names, proportions and local frames."""
    offsets = SKELETON.offsets.clone()
    for j, name in enumerate(SKELETON.names):
        offsets[j] *= arms if any(part in name for part in ("Elbow", "Wrist")) else 1.0
        offsets[j] *= legs if any(part in name for part in ("Knee", "Ankle")) else 1.0
        offsets[j] *= hips if name.endswith("Hip") else 1.0
    own = frames_of(pose, offsets)
    if turned is not None:  # zero rotations face another way or lie on their back
        own = R.multiply(own, R.inverse(turned))
    local = offsets.clone()
    parents = list(SKELETON.parents)
    local[1:] = R.rotate(R.inverse(own[parents[1:]]), offsets[1:])
    rows = [f"rig:{name}" for name in SKELETON.names], parents, [*local]
    roles = {role: f"rig:{name}" for role, name in SKELETON.roles.items()}
    if joints is not None:
        rows, roles, own = joints(*rows, roles, own)
    skeleton = tk.Skeleton(rows[0], rows[1], torch.stack(rows[2]), roles)
    return tk.Clip(skeleton, local_rotations(skeleton, own[None]), torch.tensor([[0.0, 0.95, 0.0]]),
                   60.0, name=pose)


def with_twists(names: list, parents: list, offsets: list, roles: dict, own: torch.Tensor) -> tuple:
    """A joint in the middle of upper arms and thighs, fingers, a root above the hips."""
    order, rows = ["root"], {"root": (None, torch.zeros(3), R.identity(4)[0])}
    for j, name in enumerate(names):
        above = "root" if parents[j] < 0 else names[parents[j]]
        offset = offsets[j]
        if any(part in name for part in ("Elbow", "Knee")):
            rows[f"{name}Twist"] = above, offset / 2, own[parents[j]]
            order.append(f"{name}Twist")
            above, offset = f"{name}Twist", offset / 2
        rows[name] = above, offset, own[j]
        order.append(name)
        if name.endswith("Wrist"):
            rows[f"{name}Thumb"] = name, torch.tensor([0.03, 0.02, 0.03]), own[j]
            order.append(f"{name}Thumb")
    made = [order, [-1 if rows[n][0] is None else order.index(rows[n][0]) for n in order],
            [rows[n][1] for n in order]]
    return made, roles, torch.stack([rows[n][2] for n in order])


def without_toes(names: list, parents: list, offsets: list, roles: dict,
                 own: torch.Tensor) -> tuple:
    """No toes, and shoulders fixed to the chest."""
    kept = [j for j, name in enumerate(names) if "Toe" not in name and "Collar" not in name]
    offsets = [o if "Collar" not in names[parents[j]]
               else o + offsets[parents[j]] for j, o in enumerate(offsets)]
    above = [parents[p] if p >= 0 and p not in kept else p for p in parents]
    made = [[names[j] for j in kept], [kept.index(above[j]) if j else -1 for j in kept],
            [offsets[j] for j in kept]]
    return made, {role: name for role, name in roles.items() if "toe" not in role}, own[kept]


def with_soles(names: list, parents: list, offsets: list, roles: dict, own: torch.Tensor) -> tuple:
    """Feet that end straight below the ankle."""
    (names, parents, offsets), _, own = without_toes(names, parents, offsets, roles, own)
    for side in ("left", "right"):
        ankle = names.index(roles[f"{side}_foot"])
        names, parents = [*names, f"{names[ankle]}End"], [*parents, ankle]
        offsets = [*offsets, torch.tensor([0.0, -0.08, 0.0])]
        own = torch.cat((own, own[ankle : ankle + 1]))
        roles = roles | {f"{side}_toe": names[-1]}
    return [names, parents, offsets], roles, own
