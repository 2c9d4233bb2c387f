"""Your own character: a skinned mesh of glTF, VRM or FBX, drawn in place of the mannequin."""

import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import torch

from toolkit.extra.characters import gltf_mesh
from toolkit.extra.characters.anatomy import measure, with_toes
from toolkit.extra.characters.fbx_figure import smooth
from toolkit.extra.characters.gltf_mesh import SkinnedMesh
from toolkit.extra.characters.retargeting import leaders, retarget
from toolkit.extra.formats.nodes import END
from toolkit.motion import Clip, Skeleton, rotations as R
from toolkit.motion.clearance import THIGH, TRUNK, arms_out, limbs, trunk
from toolkit.motion.contacts import standing_height
from toolkit.motion.roles import SIDES
from toolkit.motion.skeleton import local_rotations
from toolkit.view.render.skin import Skin

SOFT = 0.02  # metres by which an arm may press into the body
HIGH = 0.15  # metres: a toe that is higher above the lowest vertex tells nothing about the sole


@dataclass(frozen=True, eq=False)
class Character:
    """A skinned mesh over a humanoid rig, in metres; linear blend skinning of rigid joints."""

    path: Path
    mesh: SkinnedMesh
    rest: Clip  # one frame of the rig
    moved: np.ndarray  # [J, 4, 4] of the joints, from the pose in which the mesh was bound

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Character":
        """Read a character from a .glb, .gltf, .vrm or .fbx file.

        It stands in the pose of the file's nodes, or in the bind pose if that one shows no standing
        figure. Roles are found from the joints' names.

        Raises
        ------
        ValueError
            If the file cannot be read or holds no skinned mesh, or its joints are not a humanoid's.
        """
        path = Path(path)
        mesh, errors = gltf_mesh.read(path), []
        for pose in (mesh.rest, mesh.bind):
            rest = _clip(mesh, pose, path.name)
            try:
                measure(rest)
            except ValueError as error:
                errors.append(error)
                continue
            return cls(path, mesh, rest, pose @ np.linalg.inv(mesh.bind))
        raise errors[0]

    @property
    def skeleton(self) -> Skeleton:
        """The rig's skeleton."""
        return self.rest.skeleton

    def fitted(self, clip: Clip) -> Clip:
        """A clip on the character's rig: soles of its mesh on the floor, arms out of its body."""
        made = retarget(clip, self.rest)
        if made is clip:
            return clip
        return arms_out(made.moved(shift=(0.0, self.sole(made), 0.0)), *self.gaps)

    def following(self, clip: Clip) -> dict:
        """How the rig follows the joints of a clip's skeleton frame by frame, without foot IK.

        The clip shows its heights. ``scene/figure.js`` describes the format.
        """
        source, goal = measure(clip), measure(self.rest)
        hips = [[rig.skeleton.role(f"{side}_hip") for side in SIDES] for rig in (source, goal)]
        scale = goal.leg / source.leg
        height, fitted = (c.global_positions[:, joints, 1].mean() for c, joints in zip(
            (clip, self.fitted(clip)), hips, strict=True))
        rules = []
        for joint, (a, b, share) in leaders(source, goal).items():
            axes = source.axes[a], source.axes[b], R.inverse(goal.axes[joint])
            rules.append([joint, a, b, round(share, 6), *torch.cat(axes).tolist()])
        return {"rules": rules, "rest": goal.rest.tolist(), "scale": scale, "hips": hips,
                "lift": float(fitted - scale * height)}

    def packed(self, follow: dict | None = None) -> dict:
        """The mesh as the browser's scene takes it (``scene/figure.js`` describes the format)."""
        return self.skin.packed(self.skeleton, self.mesh.colors) | {"own": True, "follow": follow}

    def sole(self, clip: Clip) -> float:
        """Metres by which a clip on the rig is lifted: then the mesh stands on the floor."""
        toes = with_toes(self.skeleton).both("toe")
        rise = float(self.rest.global_positions[0, toes, 1].amin()) - float(self.points[:, 1].min())
        if rise >= HIGH:
            return 0.0
        return rise - float(standing_height(clip.replace(skeleton=with_toes(clip.skeleton))))

    @cached_property
    def gaps(self) -> tuple[float, float]:
        """Metres that forearms keep from the axes of trunk and thighs: the radii of arm and body.

        A radius is the median distance from the axis, of the vertices that the part's joints move
        most. Flesh gives way by `SOFT`. A thin character keeps what people keep
        (`toolkit.motion.clearance`).
        """
        skeleton, points = self.skeleton, limbs(self.rest)
        mine = self.mesh.joints[np.arange(len(self.points)), self.mesh.weights.argmax(1)]
        around = {"trunk": (skeleton.trunk, trunk(self.rest))}
        for part, end in (("hip", "knee"), ("elbow", "hand")):
            axes = [points[f"{side}_{end}"] for side in SIDES]
            around[part] = skeleton.both(part), torch.cat(axes, 1)
        radii = {}
        for part, (joints, axis) in around.items():
            flesh = torch.from_numpy(self.points[np.isin(mine, joints)]).to(axis)
            apart = torch.cdist(flesh, axis[0]).amin(1)
            radii[part] = float(apart.median()) if len(flesh) else 0.0
        arm = radii["elbow"] - SOFT
        return max(TRUNK, radii["trunk"] + arm), max(THIGH, radii["hip"] + arm)

    @cached_property
    def skin(self) -> Skin:
        """The mesh over the rig's joints, in the pose in which the file binds it."""
        mesh, pose = self.mesh, np.tile(np.eye(4), (len(self.skeleton), 1, 1))
        pose[:, :3, :3] = R.to_matrix(self.rest.global_rotations[0]).numpy()
        pose[:, :3, 3] = self.rest.global_positions[0].numpy()
        inverse = (np.linalg.inv(pose) @ self.moved)[:, :3]
        return Skin(mesh.points.astype(np.float32), self.normals, mesh.triangles, mesh.joints,
                    mesh.weights, inverse)

    @cached_property
    def points(self) -> np.ndarray:
        """Vertices ``[V, 3]`` in the pose of ``rest``."""
        return self.skin.pose(self.rest.global_rotations[0], self.rest.global_positions[0])[0]

    @cached_property
    def normals(self) -> np.ndarray:
        """Unit normals ``[V, 3]`` where the mesh is bound, the same for vertices at one place."""
        places, same = np.unique(self.mesh.points.round(5), axis=0, return_inverse=True)
        same = same.ravel()
        return smooth(places, same[self.mesh.triangles])[same].astype(np.float32)


def _clip(mesh: SkinnedMesh, pose: np.ndarray, name: str) -> Clip:
    """One frame of the rig from world transforms ``[J, 4, 4]``, without their scales."""
    axes = pose[:, :3, :3] / np.linalg.norm(pose[:, :3, :3], axis=1, keepdims=True).clip(1e-12)
    turned, places = R.from_matrix(torch.from_numpy(axes)), torch.from_numpy(pose[:, :3, 3])
    offsets = torch.zeros(len(pose), 3, dtype=torch.float64)
    above = list(mesh.parents[1:])
    offsets[1:] = R.rotate(R.inverse(turned[above]), places[1:] - places[above])
    inner = {0, *mesh.parents}
    ends = [name for j, name in enumerate(mesh.names) if j not in inner and END.search(name)]
    skeleton = Skeleton(mesh.names, mesh.parents, offsets.float(), ends=ends)
    return Clip(skeleton, R.normalize(local_rotations(skeleton, turned[None]).float()),
                places[:1].float(), 60.0, name=name)
