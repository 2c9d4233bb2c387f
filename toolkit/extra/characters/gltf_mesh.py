"""The skinned mesh of a glTF or FBX file: vertices, triangles, weights, colours."""

import io
import os
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from toolkit.extra.characters.fbx_figure import SLOTS, glb
from toolkit.extra.formats.gltf import pose
from toolkit.extra.formats.gltf_file import (
    PACKED,
    Document,
    index_of,
    indices_of,
    member,
    members,
    numbers_of,
)
from toolkit.extra.formats.nodes import descending, unique
from toolkit.io.files import named
from toolkit.motion import rotations as R
from toolkit.motion.text import printable

COMPRESSED = ("KHR_draco_mesh_compression", *PACKED)
SHARED = 500_000  # vertices beyond those that the bytes hold: primitives may share them
PICTURES = "PNG", "JPEG", "WEBP"  # formats of a texture
DECODED = 100_000_000  # bytes of a texture beyond ten times its own
TEXTURES = 100  # that are read; the others have no colour
GREY = 0.8  # linear base colour where the file gives none


@dataclass(frozen=True, eq=False)
class SkinnedMesh:
    """A mesh over the nodes of a file, in metres with y up."""

    names: tuple[str, ...]  # of J joints and the nodes between them, unique
    parents: tuple[int, ...]  # the root comes first with -1
    nodes: tuple[int, ...]  # J, number of each joint's node in the file
    above: np.ndarray  # [4, 4] world transform of the node above the root
    rest: np.ndarray  # [J, 4, 4] world transforms of the joints in the pose of the nodes
    bind: np.ndarray  # [J, 4, 4] the same in the pose in which the mesh was bound to them
    points: np.ndarray  # [V, 3] in the world, in the bind pose
    triangles: np.ndarray  # [T, 3]
    joints: np.ndarray  # [V, 4]
    weights: np.ndarray  # [V, 4] with sum 1
    colors: np.ndarray  # [V, 3] uint8 (sRGB); a texture is read at each vertex
    digest: bytes  # SHA-256 of the file


def read(path: str | os.PathLike) -> SkinnedMesh:
    """Read the skinned meshes of a glTF or FBX file as one, with meshes that hang on a joint.

    Morph targets are left out, and of textures only the base colour is used.

    Raises
    ------
    ValueError
        If the file is not glTF or damaged, holds no skinned mesh, or its mesh is compressed.
    """
    with named(path), np.errstate(all="ignore"):  # numbers that are not finite are refused
        return _Reader(opened(Path(path))).mesh()


def opened(path: Path) -> Document:
    """The document of a glTF file, or of an FBX file, which becomes one."""
    return Document(path, glb(path) if path.suffix.lower() == ".fbx" else None)


class _Reader:
    """A file's nodes, and how much of its meshes was read."""

    def __init__(self, file: Document):
        self.file = file
        self.nodes, self.parents = self.file.listed("nodes"), self.file.parents
        self.vertices = 0
        self.images: dict[int, np.ndarray | None] = {}

        # World transforms [4, 4], parents first
        self.tree, self.order = descending(self.parents)
        self.world = np.empty((len(self.nodes), 4, 4))
        for j in self.order:
            self.world[j] = self._above(j) @ _transform(self.nodes[j])

    def _above(self, j: int) -> np.ndarray:
        """World transform ``[4, 4]`` of the node above a node."""
        return self.world[self.parents[j]] if self.parents[j] >= 0 else np.eye(4)

    def mesh(self) -> SkinnedMesh:
        """All meshes that follow joints, as one."""
        skins = self.file.listed("skins")
        listed = [indices_of(skin, "joints", len(self.nodes)) for skin in skins]
        meshes = [j for j, node in enumerate(self.nodes) if "mesh" in node]
        skinned = {j: index_of(self.nodes[j], "skin", len(skins)) for j in meshes
                   if "skin" in self.nodes[j]}
        if not skinned:
            raise ValueError("it holds no skinned mesh, so there is no character to draw")
        required = str(self.file.document.get("extensionsRequired"))
        if packed := [name for name in COMPRESSED if name in required]:
            name = printable(self.nodes[min(skinned)].get("name", min(skinned)))
            raise ValueError(f"its mesh {name} is compressed by {packed[0]}; {self.file.unpacking}")
        joints = self._tree({j for of in listed for j in of})
        place = {j: i for i, j in enumerate(joints)}
        bind, spaces = self._bind(skins, listed, joints)

        # The joint on which a node hangs, or -1
        hosts = [-1] * len(self.nodes)
        for j in self.order:
            hosts[j] = place.get(j, hosts[self.parents[j]] if self.parents[j] >= 0 else -1)

        rows = []
        for j, k in skinned.items():
            rows += self._primitives(j, spaces[k], np.array([place[i] for i in listed[k]], int))
        for j in meshes:
            if j not in skinned and (host := hosts[j]) >= 0:  # moves with one joint
                still = np.linalg.inv(self.world[joints[host]]) @ self.world[j]
                rows += self._primitives(j, bind[host] @ still, None, host)
        if not rows:
            raise ValueError("its meshes have no triangles")
        points, triangles, follow, weights, colors = zip(*rows, strict=True)
        counts = np.cumsum([0, *map(len, points[:-1])])
        triangles = [part + count for part, count in zip(triangles, counts, strict=True)]

        names = [printable(self.nodes[j].get("name", "")).strip() or f"node{j}" for j in joints]
        return SkinnedMesh(
            tuple(unique(names)), tuple(place.get(self.parents[j], -1) for j in joints),
            tuple(joints), self._above(joints[0]), self.world[joints], bind,
            *map(np.concatenate, (points, triangles, follow, weights, colors)), self.file.digest)

    def _tree(self, joints: set[int]) -> list[int]:
        """Joints and the nodes between them, parents first, below one root."""
        kept: set[int] = set()
        for j in joints:
            while j >= 0 and j not in kept:
                kept.add(j)
                j = self.parents[j]
        stack = [j for j in kept if self.parents[j] < 0]
        if len(stack) != 1:
            raise ValueError("the joints of its skins have no common ancestor")
        below = {j: [child for child in self.tree.children[j] if child in kept] for j in kept}
        while stack[0] not in joints and len(below[stack[0]]) == 1:
            stack = below[stack[0]]
        found = []
        while stack:
            found.append(stack.pop())
            stack += reversed(below[found[-1]])
        return found

    def _bind(self, skins: list[dict], listed: list[list[int]],
              joints: list[int]) -> tuple[np.ndarray, list[np.ndarray]]:
        """World transforms of the joints in the bind pose, and of the space of each skin's mesh.

        A skin's inverse bind matrices lead from this space to the joints. It is placed by a joint
        that an earlier skin has bound, or else by its first joint, in the pose of the nodes.
        """
        bind: dict[int, np.ndarray] = {}
        spaces = []
        for skin, of in zip(skins, listed, strict=True):
            matrices = np.eye(4)[None].repeat(len(of), 0)
            if "inverseBindMatrices" in skin:
                matrices = self.file.array(skin["inverseBindMatrices"], 16)
                matrices = matrices.reshape(-1, 4, 4).swapaxes(1, 2)  # the file goes by columns
            if len(matrices) < len(of):
                raise ValueError("a skin has fewer inverse bind matrices than joints")
            inverse = dict(zip(of, matrices, strict=False))
            shared = bind.keys() & inverse.keys()
            first = next((j for j in joints if j in (shared or inverse)), None)
            if first is not None:
                spaces.append(bind.get(first, self.world[first]) @ inverse[first])
            else:
                spaces.append(np.eye(4))
            for j, matrix in inverse.items():
                bind.setdefault(j, spaces[-1] @ np.linalg.inv(matrix))

        for j in joints:
            above = self.parents[j]
            if j not in bind and above in bind:  # keeps its place below the joint above
                bind[j] = bind[above] @ np.linalg.inv(self.world[above]) @ self.world[j]
            bind.setdefault(j, self.world[j])
        return np.stack([bind[j] for j in joints]), spaces

    def _primitives(self, node: int, place: np.ndarray, skin: np.ndarray | None,
                    host: int = -1) -> list[tuple[np.ndarray, ...]]:
        """Points, triangles, joints, weights and colours of each primitive of a node's mesh.

        The vertices follow the joints of ``skin``, or all of them ``host``.
        """
        meshes, found = self.file.listed("meshes"), []
        mesh = meshes[index_of(self.nodes[node], "mesh", len(meshes))]
        for primitive in members(mesh, "primitives"):
            attributes = member(primitive, "attributes")
            if primitive.get("mode", 4) != 4 or "POSITION" not in attributes:
                self._count(1)
                continue  # points and lines
            points = self.file.array(attributes["POSITION"], 3)
            corners = np.arange(len(points))
            if "indices" in primitive:
                corners = self.file.array(primitive["indices"], 1)[:, 0]
            self._count(1 + len(points) + len(corners) / 10)
            if not ((corners >= 0) & (corners < len(points))).all():
                raise ValueError("a triangle has a vertex that does not exist")
            triangles = corners[: len(corners) // 3 * 3].astype(np.int64).reshape(-1, 3)
            if skin is None:
                joints = np.full((len(points), SLOTS), host)
                weights = np.eye(1, SLOTS).repeat(len(points), 0)
            else:
                joints, weights = self._weights(attributes, skin, len(points))
            colors = self._colors(primitive, attributes, len(points))
            points = points @ place[:3, :3].T + place[:3, 3]
            found.append((points, triangles, joints, weights, colors))
        return found

    def _weights(self, attributes: dict, skin: np.ndarray,
                 count: int) -> tuple[np.ndarray, np.ndarray]:
        """Joints ``[V, 4]`` that vertices follow, and their weights ``[V, 4]`` with sum 1."""
        if not {"JOINTS_0", "WEIGHTS_0"} <= attributes.keys():
            raise ValueError("a skinned mesh has no weights")
        own, weights = (self.file.array(attributes[k], SLOTS) for k in ("JOINTS_0", "WEIGHTS_0"))
        fit = len(own) == len(weights) == count
        if not fit or not ((own >= 0) & (own < len(skin))).all():
            raise ValueError("the weights of a mesh do not fit its vertices and joints")
        weights = np.maximum(weights, 0)
        weights = np.where(weights.sum(1, keepdims=True) > 1e-6, weights, np.eye(1, SLOTS))
        return skin[own.astype(int)], weights / weights.sum(1, keepdims=True)

    def _count(self, vertices: float) -> None:
        """Count vertices that primitives may share; ValueError for many more than the file has."""
        self.vertices += vertices
        if self.vertices > SHARED + self.file.size / 20:  # one takes 20 bytes with its weights
            raise ValueError(f"its meshes have {self.vertices:.0f} vertices in "
                             f"{self.file.size} bytes")

    def _colors(self, primitive: dict, attributes: dict, count: int) -> np.ndarray:
        """Base colour ``[V, 3]`` uint8: those of material, vertex and texture, multiplied."""
        materials = self.file.listed("materials")
        material = {}
        if "material" in primitive:
            material = materials[index_of(primitive, "material", len(materials))]
        surface = member(material, "pbrMetallicRoughness")
        usual = (1.0 if surface else GREY,) * 4
        linear = numbers_of(surface, "baseColorFactor", 4, usual)[None, :3].repeat(count, 0)
        if "COLOR_0" in attributes:
            given = self.file.array(attributes["COLOR_0"], 3, 4)[:, :3]
            if len(given) != count:
                raise ValueError("the colours of a mesh do not fit its vertices")
            linear = linear * given
        tone = np.clip(linear, 0, 1) ** (1 / 2.2)

        texture = member(surface, "baseColorTexture")
        image = self._image(texture) if texture else None
        place = f"TEXCOORD_{texture.get('texCoord', 0)}"
        if image is not None and place in attributes:
            # [V, 2], shares of width and height
            across = self.file.array(attributes[place], 2) % 1.0
            if len(across) != count:
                raise ValueError("the texture coordinates of a mesh do not fit its vertices")
            height, width, _ = image.shape
            columns, rows = np.minimum((across * (width, height)).astype(int),
                                       (width - 1, height - 1)).T
            tone = tone * image[rows, columns] / 255
        return (255 * tone + 0.5).astype(np.uint8)

    def _image(self, texture: dict) -> np.ndarray | None:
        """Pixels ``[H, W, 3]`` of a texture that lies in the file; None if it cannot be read."""
        textures, images = self.file.listed("textures"), self.file.listed("images")
        source = textures[index_of(texture, "index", len(textures))].get("source")
        known = type(source) is int and 0 <= source < len(images)
        if not known or "bufferView" not in images[source]:
            return None
        if source not in self.images and len(self.images) < TEXTURES:
            self.images[source] = _pixels(bytes(self.file.view(images[source])[1]))
        return self.images.get(source)


def _pixels(data: bytes) -> np.ndarray | None:
    """Pixels ``[H, W, 3]`` of a picture, at most 1024 x 1024; None if it cannot be read."""
    try:
        from PIL import Image  # of the extra "view"
    except ImportError:
        return None
    try:
        with warnings.catch_warnings(action="ignore"):  # Pillow's limit ignores the file's size
            picture = Image.open(io.BytesIO(data), formats=PICTURES)
            if 4 * picture.size[0] * picture.size[1] > DECODED + 10 * len(data):
                return None
            picture.thumbnail((1024, 1024))
            return np.asarray(picture.convert("RGB"))
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return None


def _transform(node: dict) -> np.ndarray:
    """Transform ``[4, 4]`` of a node relative to its parent."""
    made = np.eye(4)
    made[:3, 3], turn, scale = pose(node)
    made[:3, :3] = R.to_matrix(turn).numpy() * scale
    return made
