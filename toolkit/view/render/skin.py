"""Linear blend skinning: every vertex follows up to four joints, by weight.

Pictures are skinned here, pages in the browser (``scene/body.js``).
"""

import base64
import os
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from torch import Tensor

from toolkit.motion import Clip, Skeleton, rotations as R

SLOTS = 4  # joints that a vertex may follow


class Figure(Protocol):
    """What is drawn in place of the mannequin, such as `toolkit.extra.characters.Character`."""

    skin: "Skin"
    rest: Clip  # one frame of its rig

    def fitted(self, clip: Clip) -> Clip:
        """A clip on the rig."""

    def following(self, clip: Clip) -> dict:
        """How the rig follows the joints of a clip's skeleton, as ``scene/figure.js`` describes."""

    def packed(self, follow: dict | None = None) -> dict:
        """The mesh as the browser's scene takes it."""


#: A glTF or VRM file with a skinned mesh, what was read from it, or None for the mannequin.
Character = str | os.PathLike | Figure | None


@dataclass(frozen=True, eq=False)
class Skin:
    """A surface of V vertices over the J joints of a skeleton, in its bind pose, metres."""

    points: np.ndarray  # [V, 3] float32
    normals: np.ndarray  # [V, 3] float32, unit
    triangles: np.ndarray  # [T, 3]
    joints: np.ndarray  # [V, SLOTS]
    weights: np.ndarray  # [V, SLOTS] with sum 1
    inverse: np.ndarray  # [J, 3, 4] inverse world transforms of the joints in the bind pose

    def pose(self, rotations: Tensor, positions: Tensor) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and unit normals ``[V, 3]`` for joints in the world, [J, 4] and [J, 3]."""
        moved = R.to_matrix(rotations).double().numpy() @ self.inverse
        moved[..., 3] += positions.double().numpy()
        each = moved.astype(np.float32)[self.joints]  # [V, SLOTS, 3, 4]
        blended = np.einsum("vs,vsij->vij", self.weights, each)
        points = np.einsum("vij,vj->vi", blended[..., :3], self.points) + blended[..., 3]
        normals = np.einsum("vij,vj->vi", blended[..., :3], self.normals)
        normals /= np.sqrt(np.einsum("vi,vi->v", normals, normals)).clip(1e-9)[:, None]
        return points, normals

    def packed(self, skeleton: Skeleton, colors: np.ndarray,
               marks: np.ndarray | None = None) -> dict:
        """The surface as the browser's scene takes it (``scene/body.js`` describes the format).

        ``colors`` [V, 3] are 0 to 255. ``marks`` [V, 4] are shares (0 to 1) of the left foot, the
        right foot and the trunk, and the ambient light.
        """
        shares = np.floor(255 * self.weights + 1e-6).astype(np.uint8)
        rest = (255 - shares.sum(1)).astype(np.uint8)
        shares[np.arange(len(shares)), self.weights.argmax(1)] += rest
        low, size = self.points.min(0), np.ptp(self.points, axis=0).clip(1e-9)
        arrays = {
            "inverse": (self.inverse, "<f4"), "points": ((self.points - low) / size * 65535, "<u2"),
            "normals": (self.normals * 127, "i1"), "triangles": (self.triangles, "<u2"),
            "joints": (self.joints, "<u2"), "weights": (shares, "u1"), "colors": (colors, "u1"),
            "marks": (np.zeros((0, 4)) if marks is None else 255 * marks, "u1")}
        if len(self.points) > 65535:
            arrays["triangles"] = (self.triangles, "<u4")
        if len(self.inverse) < 256:
            arrays["joints"] = (self.joints, "u1")
        return tree(skeleton) | {"low": low.tolist(), "size": size.tolist()} | {
            name: encoded(*array) for name, array in arrays.items()}


def tree(skeleton: Skeleton) -> dict:
    """Parents and offsets of a skeleton, for the browser."""
    offsets = [[round(x, 6) for x in offset] for offset in skeleton.offsets.tolist()]
    return {"parents": list(skeleton.parents), "offsets": offsets}


def encoded(values, kind: str) -> str:
    """An array as a page holds it: base64; what becomes whole numbers is rounded."""
    kind, values = np.dtype(kind), np.asarray(values)
    values = values.round() if kind.kind in "iu" else values
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode("ascii")
