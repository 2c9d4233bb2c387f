"""Skeleton: joints in a tree, their roles and counterparts; forward kinematics."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.roles import SIDES, Tree, find, mirror_pairs
from toolkit.motion.tensors import as_tensor, summary
from toolkit.motion.text import checked

FEET = SIDES[::-1]  # the published network's order of contacts; ours of all pairs of legs or arms
LONGEST = 1e6  # metres, of a bone
#: The order of local phases.
LIMBS = tuple(f"{side}_{part}" for part in ("hand", "foot") for side in SIDES)


class Levels(NamedTuple):
    """Joints in the order of their depth: the root, its children, their children …."""

    order: Tensor  # [J] joints
    back: Tensor  # [J] place of each joint in this order
    sizes: list[int]  # joints of each depth
    above: list[Tensor]  # of each depth but the root's: places of the parents in the depth above


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A tree of J joints and End Sites.

    ValueError if lengths differ, a name repeats, a parent does not come before its child or an End
    Site is no leaf.
    """

    names: tuple[str, ...]  # J unique ones
    parents: tuple[int, ...]  # the root comes first with -1, every parent before its children
    offsets: Tensor  # [J, 3] from the parent, in its frame, metres; the root's is not used
    roles: dict[str, str] | None = None  # joint by role of `ROLES`; by default found from the names
    ends: tuple[str, ...] | None = None  # End Sites (no rotation); by default leaves named ...End

    def __post_init__(self):
        set_ = object.__setattr__
        set_(self, "names", checked(self.names, "a joint"))
        set_(self, "parents", tuple(int(p) for p in self.parents))
        set_(self, "offsets", as_tensor(self.offsets, "offsets", torch.float32).cpu())
        n = len(self.names)
        if len(self.parents) != n or self.offsets.shape != (n, 3):
            raise ValueError(f"{n} joint names need {n} parents and offsets [{n}, 3]; got "
                             f"{len(self.parents)} parents and offsets {list(self.offsets.shape)}")
        if not bool((self.offsets[1:].abs() <= LONGEST).all()):
            raise ValueError(f"offsets must be finite, and at most {LONGEST:g} m")
        below = enumerate(self.parents[1:], 1)
        if self.parents[:1] != (-1,) or any(not 0 <= p < j for j, p in below):
            raise ValueError("the root must come first with parent -1, and every parent before its "
                             "children")
        inner = {0, *self.parents}
        leaves = {name: None for j, name in enumerate(self.names) if j not in inner}  # keeps order
        ends = self.ends
        if ends is None:
            ends = (name for name in leaves if name.endswith("End"))
        set_(self, "ends", tuple(ends))
        if wrong := [str(name) for name in self.ends if name not in leaves]:
            raise ValueError("End Sites must be leaves of the tree; these are not: "
                             f"{', '.join(wrong)}")
        roles = self.roles
        if roles is None:
            lengths = self.offsets.norm(dim=-1).tolist()
            found = find(self.names, self.parents, lengths, self.ends)
            roles = {role: joint for role, (joint, _) in found.items()}
        set_(self, "roles", dict(roles))
        if odd := sorted({*self.roles.values()} - {*self.names}):
            raise ValueError(f"roles name joints that are not there: {', '.join(odd)}")

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return summary(self, {"joints": len(self), "end_sites": len(self.ends),
                              "names": self.names, "roles": self.roles})

    def to_dict(self) -> dict:
        """The fields as JSON values; ``Skeleton(**fields)`` makes the skeleton again."""
        return {"names": list(self.names), "parents": list(self.parents),
                "offsets": self.offsets.tolist(), "roles": self.roles, "ends": list(self.ends)}

    def index(self, name: str) -> int:
        """Index of a joint by its name or, where no joint has this name, by its role."""
        joint = name if name in self.names else self.roles.get(name)
        if joint is None:
            raise ValueError(f"unknown joint {name!r}; the skeleton has {', '.join(self.names)}")
        return self.names.index(joint)

    def role(self, role: str) -> int:
        """Index of the joint with a role: SMPL's joint left_wrist has the role left_hand."""
        if role not in self.roles:
            raise ValueError(f"no joint has the role {role!r}; "
                             f"the skeleton has {', '.join(self.names)}")
        return self.names.index(self.roles[role])

    def both(self, part: str) -> list[int]:
        """Indices of the joints of a part on both sides, right and left."""
        return [self.role(f"{side}_{part}") for side in FEET]

    def has(self, *parts: str) -> bool:
        """Whether joints are known for these parts on both sides: ``has("hip", "shoulder")``."""
        return all(f"{side}_{part}" in self.roles for side in SIDES for part in parts)

    def is_end(self, joint: int) -> bool:
        """Whether a point is an End Site."""
        return self.names[joint] in self.ends

    def end_site(self, role: str) -> int:
        """Index of the End Site below the joint with a role; the joint itself if it has none.

        An End Site within 0.1 mm of the joint counts as none.
        """
        joint = self.role(role)
        ends = filter(self.is_end, self.tree.children[joint])
        return next((j for j in ends if float(self.offsets[j].norm()) > 1e-4), joint)

    @cached_property
    def feature_joints(self) -> tuple[int, ...]:
        """Joints that the features describe (section 3.2).

        All but End Sites, and the End Sites of hands or with a role.
        """
        kept = {self.end_site(f"{side}_hand") for side in SIDES}
        kept |= {self.names.index(name) for name in self.roles.values()}
        return tuple(j for j in range(len(self)) if not self.is_end(j) or j in kept)

    @cached_property
    def feature_of(self) -> list[int]:
        """For each point the index of the feature joint whose rotation it has: its own, or else
        that of its parent.
        """
        place = {j: i for i, j in enumerate(self.feature_joints)}
        return [place[j if j in place else self.parents[j]] for j in range(len(self))]

    def levels(self, device: torch.device) -> Levels:
        """The joints by their depth below the root; made once for each device."""
        kept = self.__dict__.setdefault("_levels", {})
        if device not in kept:
            groups, above = [[0]], []
            while joints := [j for j, p in enumerate(self.parents) if p in groups[-1]]:
                above.append([groups[-1].index(self.parents[j]) for j in joints])
                groups.append(joints)
            with torch.inference_mode(False):  # the next call may need gradients
                order = torch.tensor([j for joints in groups for j in joints], device=device)
                kept[device] = Levels(order, order.argsort(), [len(joints) for joints in groups],
                                      [torch.tensor(places, device=device) for places in above])
        return kept[device]

    @cached_property
    @torch.inference_mode(False)
    def rest_positions(self) -> Tensor:
        """Positions ``[J, 3]`` with every rotation zero, the root at the origin."""
        still = R.identity(len(self), dtype=torch.float32)
        return forward_kinematics(self, still, torch.zeros(3))[1]

    @cached_property
    @torch.inference_mode(False)
    def facing_axis(self) -> Tensor:
        """The axis ``[3]`` of the hips' frame nearest to (right → left hip) × (hips → chest)."""
        rest = self.rest_positions
        left = rest[self.role("left_hip")] - rest[self.role("right_hip")]
        forward = torch.linalg.cross(left, rest[self.trunk[0]] - rest[self.role("hips")])
        largest = forward.abs().argmax()
        return torch.eye(3)[largest] * forward[largest].sign()

    @cached_property
    def tree(self) -> Tree:
        """Children, ancestors and subtrees by index; without lengths."""
        return Tree(self.parents)

    @cached_property
    def trunk(self) -> list[int]:
        """Joints above both shoulders, from the chest to the hips, or to the root without these."""
        left, right = (self.tree.up(self.role(f"{side}_shoulder"))[1:] for side in SIDES)
        trunk, hips = [j for j in left if j in right], self.role("hips")
        return trunk[: trunk.index(hips) + 1] if hips in trunk else trunk

    @cached_property
    def neck(self) -> list[int]:
        """Joints from the chest to the head; the chest alone where no head is known."""
        chest = self.trunk[0]
        below = sorted(self.tree.below(chest)[1:])
        head = next((j for j in below if self.names[j].lower().endswith("head")), chest)
        above = self.tree.up(head)
        return above[: above.index(chest) + 1][::-1]

    @cached_property
    def mirror_pairs(self) -> tuple[int, ...]:
        """For each joint the index of its left/right counterpart, itself where it has none."""
        return mirror_pairs(self.names, self.parents, self.roles)


def forward_kinematics(skeleton: Skeleton, rotations: Tensor,
                       root_positions: Tensor) -> tuple[Tensor, Tensor]:
    """Global rotations and positions of local rotations and the root's position.

    Parameters
    ----------
    rotations : Tensor [..., J, 4]
    root_positions : Tensor [..., 3]

    Returns
    -------
    rotations, positions : Tensor [..., J, 4] and [..., J, 3]
    """
    # All joints of one depth are turned at once. Frames come last, [J, 4, F]: those of a number are
    # then contiguous, which is fastest.
    shape, n, levels = rotations.shape[:-2], len(skeleton), skeleton.levels(rotations.device)
    local = rotations.reshape(-1, 4 * n).T.contiguous().view(n, 4, -1)
    root, *below = local.index_select(0, levels.order).split(levels.sizes)
    turned, parents = [root], [root[:0]]
    for own, places in zip(below, levels.above, strict=True):
        parents.append(turned[-1].index_select(0, places))
        turned.append(torch.stack(R.multiply_parts(parents[-1].unbind(1), own.unbind(1)), 1))

    # All bones are turned by their parents, then added up from the root down.
    offsets = skeleton.offsets.to(rotations)[levels.order[1:], :, None]
    bones = torch.stack(R.rotate_parts(torch.cat(parents).unbind(1), offsets.unbind(1)), 1)
    positions = [root_positions.expand(*shape, 3).reshape(-1, 3).T[None]]
    for bone, places in zip(bones.split(levels.sizes[1:]), levels.above, strict=bool(below)):
        positions.append(positions[-1].index_select(0, places) + bone)

    def in_order(parts: list[Tensor], width: int) -> Tensor:
        """Numbers by depth ``[J, width, F]`` as ``[..., J, width]`` in the skeleton's order."""
        whole = torch.cat(parts).index_select(0, levels.back).view(n * width, -1)
        return whole.T.contiguous().view(*shape, n, width)

    return in_order(turned, 4), in_order(positions, 3)


def local_rotations(skeleton: Skeleton, global_rotations: Tensor) -> Tensor:
    """Rotations ``[..., J, 4]`` relative to the parents: the inverse of `forward_kinematics`."""
    above = R.inverse(global_rotations[..., list(skeleton.parents[1:]), :])
    local = R.multiply(above, global_rotations[..., 1:, :])
    return torch.cat((global_rotations[..., :1, :], local), -2)
