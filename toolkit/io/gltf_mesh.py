"""The skinned mesh of a glTF file (.glb, .gltf, .vrm): vertices, triangles, weights and colours over its skeleton."""

import io
import os
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from toolkit.io.files import named
from toolkit.io.gltf import pose
from toolkit.io.gltf_file import Document, index_of, indices_of, member, members, numbers_of, whole_of
from toolkit.io.nodes import printable, unique
from toolkit.motion import rotations as R

SLOTS = 4  # joints that a vertex may follow
SKINS = 1000  # of a file
SHARED = 20_000_000, 500_000  # values and vertices beyond those that the bytes hold: primitives may share an accessor
PICTURES = "PNG", "JPEG", "WEBP"  # formats of a texture
DECODED, PIXELS, KEPT = 100_000_000, 500_000_000, 30  # bytes of a texture beyond ten times its own, pixels of all, kept ones
GREY = 0.8  # linear base colour where the file gives none


@dataclass(frozen=True, eq=False)
class SkinnedMesh:
    """A mesh over the nodes of a file, in metres with y up. The tree of J joints holds all joints of the skin."""

    names: tuple[str, ...]  # J, unique
    parents: tuple[int, ...]  # the root comes first with -1
    nodes: tuple[int, ...]  # J, number of each joint's node in the file
    above: np.ndarray  # [4, 4] world transform of the node above the root
    rest: np.ndarray  # [J, 4, 4] world transforms of the joints in the pose of the nodes
    bind: np.ndarray  # [J, 4, 4] the same in the pose in which the mesh was bound to them
    points: np.ndarray  # [V, 3] in the world, in the bind pose
    triangles: np.ndarray  # [T, 3]
    joints: np.ndarray  # [V, 4]
    weights: np.ndarray  # [V, 4] with sum 1
    colors: np.ndarray  # [V, 3] uint8, base colour (sRGB) with that of the vertex; a texture is read at each vertex
    digest: bytes  # SHA-256 of the file


def read(path: str | os.PathLike) -> SkinnedMesh:
    """Read the skinned meshes of a glTF file as one mesh; meshes that hang on a joint without a skin are included.

    Morph targets are left out, and of textures only the base colour is used.

    Raises
    ------
    ValueError
        If the file is not glTF or damaged, holds no skinned mesh, or its mesh is compressed.
    """
    with named(path), np.errstate(all="ignore"):  # numbers that are not finite are refused
        try:
            return _Reader(Path(path)).mesh()
        except (IndexError, np.linalg.LinAlgError) as error:
            raise ValueError(str(error)) from error


class _Reader:
    """A file's nodes with their world transforms."""

    def __init__(self, path: Path):
        self.file = Document(path)
        self.nodes = self.file.listed("nodes")
        self.parents = self.file.parents
        self.values = self.vertices = self.pixels = 0  # that were read
        self.world: dict[int, np.ndarray] = {}
        self.hosts: dict[int, int | None] = {}
        self.primitives: dict[int, list[dict]] = {}
        self.images: dict[int, np.ndarray | None] = {}

    def array(self, index: object, width: int) -> np.ndarray:
        """The values of an accessor; a ValueError if all together are many more than the file has bytes."""
        values = self.file.array(index, width)
        self.values += values.size
        if self.values > SHARED[0] + self.file.size:
            raise ValueError(f"its meshes read {self.values} values from {self.file.size} bytes")
        return values

    def place(self, j: int) -> np.ndarray:
        """World transform ``[4, 4]`` of a node."""
        chain = [j]
        while self.parents[chain[-1]] >= 0 and chain[-1] not in self.world:
            chain.append(self.parents[chain[-1]])
            if len(chain) > len(self.nodes):
                raise ValueError("some nodes are their own ancestors")
        for k in reversed(chain):
            if k not in self.world:
                above = self.world[self.parents[k]] if self.parents[k] >= 0 else np.eye(4)
                self.world[k] = above @ _transform(self.nodes[k])
        return self.world[j]

    def mesh(self) -> SkinnedMesh:
        """All meshes that follow joints, as one."""
        skins = self.file.listed("skins")
        if len(skins) > SKINS:
            raise ValueError(f"more than {SKINS} skins")
        listed = [indices_of(skin, "joints", len(self.nodes)) for skin in skins]
        skinned = [(j, index_of(node, "skin", len(skins))) for j, node in enumerate(self.nodes)
                   if "mesh" in node and "skin" in node]
        if not skinned:
            raise ValueError("it holds no skinned mesh, so there is no character to draw")
        inverse: dict[int, np.ndarray] = {}
        for skin, joints in zip(skins, listed, strict=True):
            if "inverseBindMatrices" in skin:
                matrices = self.array(skin["inverseBindMatrices"], 16).reshape(-1, 4, 4).swapaxes(1, 2)
            else:
                matrices = np.eye(4)[None].repeat(len(joints), 0)
            if len(matrices) < len(joints):
                raise ValueError("a skin has fewer inverse bind matrices than joints")
            for j, matrix in zip(joints, matrices, strict=False):
                inverse.setdefault(j, matrix)
        order = self._tree({j for joints in listed for j in joints})
        at = {j: i for i, j in enumerate(order)}
        first = next(j for j in order if j in inverse)
        shift = self.place(first) @ inverse[first]  # from the space of the mesh to the world
        bind = np.empty((len(order), 4, 4))
        for i, j in enumerate(order):
            if j in inverse:
                bind[i] = shift @ np.linalg.inv(inverse[j])
            else:
                bind[i] = self.place(j)
                if (above := self.parents[j]) in at:
                    bind[i] = bind[at[above]] @ np.linalg.inv(self.place(above)) @ bind[i]
        places = [np.array([at[j] for j in joints], int) for joints in listed]
        parts = [self._primitives(j, places[skin], at, shift) for j, skin in skinned]
        parts += [self._primitives(j, None, at, bind[at[a]] @ np.linalg.inv(self.place(a)) @ self.place(j), a)
                  for j, node in enumerate(self.nodes) if "mesh" in node and "skin" not in node
                  and (a := self._above(j, at)) is not None]
        rows = [row for part in parts for row in part]
        if not rows:
            raise ValueError("its meshes have no triangles")
        counts = np.cumsum([0, *(len(row[0]) for row in rows)])
        points, joints, weights, colors = (np.concatenate([row[i] for row in rows]) for i in (0, 2, 3, 4))
        triangles = np.concatenate([row[1] + count for row, count in zip(rows, counts, strict=False)])
        names = unique([printable(self.nodes[j].get("name", "")) or f"node{j}" for j in order])
        top = self.parents[order[0]]
        return SkinnedMesh(tuple(names), tuple(at.get(self.parents[j], -1) for j in order), tuple(order),
                           self.place(top) if top >= 0 else np.eye(4), np.stack([self.place(j) for j in order]), bind,
                           points, triangles, joints, weights, colors, self.file.digest)

    def _tree(self, joints: set[int]) -> list[int]:
        """Joints and the nodes between them, parents first, below one root."""
        kept: set[int] = set()
        for j in joints:
            self.place(j)  # refuses circles
            while j >= 0 and j not in kept:
                kept.add(j)
                j = self.parents[j]
        below = {j: [c for c in indices_of(self.nodes[j], "children", len(self.nodes)) if c in kept] for j in kept}
        stack = [j for j in kept if self.parents[j] < 0]
        if len(stack) != 1:
            raise ValueError("the joints of its skins have no common ancestor")
        while stack[0] not in joints and len(below[stack[0]]) == 1:
            stack = below[stack[0]]
        found = []
        while stack:
            found.append(stack.pop())
            stack += reversed(below[found[-1]])
        return found

    def _above(self, j: int, at: dict[int, int]) -> int | None:
        """The joint that a node hangs on."""
        path = []
        while j >= 0 and j not in at and j not in self.hosts:
            path.append(j)
            j = self.parents[j]
        found = self.hosts.get(j, j if j >= 0 else None)
        self.hosts |= dict.fromkeys(path, found)
        return found

    def _primitives(self, node: int, skin: np.ndarray | None, at: dict[int, int], place: np.ndarray,
                    host: int = -1) -> list[tuple[np.ndarray, ...]]:
        """Points, triangles, joints, weights and colours of each primitive of a node's mesh."""
        meshes, found = self.file.listed("meshes"), []
        mesh = index_of(self.nodes[node], "mesh", len(meshes))
        if mesh not in self.primitives:
            self.primitives[mesh] = members(meshes[mesh], "primitives")
        for primitive in self.primitives[mesh]:
            self._count(1)
            if "KHR_draco_mesh_compression" in member(primitive, "extensions"):
                raise ValueError("its mesh is compressed by KHR_draco_mesh_compression; unpack it with gltf-transform")
            attributes = member(primitive, "attributes")
            if primitive.get("mode", 4) != 4 or "POSITION" not in attributes:
                continue  # points and lines
            points = self.array(attributes["POSITION"], 3)
            self._count(len(points))
            corners = self.array(primitive["indices"], 1)[:, 0] if "indices" in primitive else np.arange(len(points))
            if not ((corners >= 0) & (corners < len(points))).all():
                raise ValueError("a triangle has a vertex that does not exist")
            triangles = corners[: len(corners) // 3 * 3].astype(np.int64).reshape(-1, 3)
            if skin is None:
                joints, weights = np.zeros((len(points), SLOTS), int), np.eye(1, SLOTS).repeat(len(points), 0)
                joints += at[host]
            else:
                if not {"JOINTS_0", "WEIGHTS_0"} <= attributes.keys():
                    raise ValueError("a skinned mesh has no weights")
                own, weights = (self.array(attributes[k], SLOTS) for k in ("JOINTS_0", "WEIGHTS_0"))
                if not len(own) == len(weights) == len(points) or not ((own >= 0) & (own < len(skin))).all():
                    raise ValueError("the weights of a mesh do not fit its vertices and joints")
                weights = np.maximum(weights, 0)
                weights = np.where(weights.sum(1, keepdims=True) > 1e-6, weights, np.eye(1, SLOTS))
                joints = skin[own.astype(int)]
            found.append((points @ place[:3, :3].T + place[:3, 3], triangles, joints,
                          weights / weights.sum(1, keepdims=True), self._colors(primitive, attributes, len(points))))
        return found

    def _count(self, vertices: int) -> None:
        """Count vertices, or a primitive; a ValueError if all meshes together have many more than the file can hold."""
        self.vertices += vertices
        if self.vertices > SHARED[1] + self.file.size / 20:  # a vertex with its weights takes 20 bytes
            raise ValueError(f"its meshes have {self.vertices} vertices in {self.file.size} bytes")

    def _colors(self, primitive: dict, attributes: dict, count: int) -> np.ndarray:
        """Base colour ``[V, 3]`` uint8 of each vertex: the material's colour, its own and the texture there, multiplied."""
        materials = self.file.listed("materials")
        material = materials[index_of(primitive, "material", len(materials))] if "material" in primitive else {}
        surface = member(material, "pbrMetallicRoughness")
        linear = numbers_of(surface, "baseColorFactor", 4, (1.0,) * 4)[:3] if surface else np.full(3, GREY)
        linear = np.asarray(linear)[None].repeat(count, 0)
        if "COLOR_0" in attributes:
            index = attributes["COLOR_0"]
            accessors = self.file.listed("accessors")
            wide = accessors[index_of(attributes, "COLOR_0", len(accessors))].get("type") == "VEC4"
            given = self.array(index, 4 if wide else 3)[:, :3]
            if len(given) != count:
                raise ValueError("the colours of a mesh do not fit its vertices")
            linear = linear * given
        tone = np.clip(linear, 0, 1) ** (1 / 2.2)
        texture = member(surface, "baseColorTexture")
        image = self._image(texture) if texture else None
        place = f"TEXCOORD_{texture.get('texCoord', 0)}"
        if image is not None and place in attributes:
            u, v = (self.array(attributes[place], 2) % 1.0).T
            if len(u) != count:
                raise ValueError("the texture coordinates of a mesh do not fit its vertices")
            rows, columns = (v * len(image)).astype(int), (u * image.shape[1]).astype(int)
            tone = tone * image[np.minimum(rows, len(image) - 1), np.minimum(columns, image.shape[1] - 1)] / 255
        return (255 * tone + 0.5).astype(np.uint8)

    def _image(self, texture: dict) -> np.ndarray | None:
        """Pixels ``[H, W, 3]`` of a texture that lies in the file; None if it cannot be read."""
        textures, images = (self.file.listed(key) for key in ("textures", "images"))
        source = textures[index_of(texture, "index", len(textures))].get("source")
        if type(source) is not int or not 0 <= source < len(images) or "bufferView" not in images[source]:
            return None
        if source not in self.images:
            views = self.file.listed("bufferViews")
            view = views[index_of(images[source], "bufferView", len(views))]
            start, size = (whole_of(view, key, 0) for key in ("byteOffset", "byteLength"))
            data = self.file.buffer(index_of(view, "buffer", len(self.file.listed("buffers"))))
            if len(self.images) == KEPT:
                del self.images[next(iter(self.images))]
            self.images[source] = self._pixels(bytes(data[start : start + size]))
        return self.images[source]

    def _pixels(self, data: bytes) -> np.ndarray | None:
        """Pixels ``[H, W, 3]`` of a picture, at most 1024; None if it cannot be read, a ValueError if it is very large."""
        try:
            from PIL import Image  # of the extra "view"
        except ImportError:
            return None
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # Pillow's limit does not depend on the size of the file
                picture = Image.open(io.BytesIO(data), formats=PICTURES)
            width, height = picture.size
            self.pixels += width * height
            small = 4 * width * height <= DECODED + 10 * len(data) and self.pixels <= PIXELS
            if small:
                picture.thumbnail((1024, 1024))
                return np.asarray(picture.convert("RGB"))
        except Image.DecompressionBombError:
            small = False
        except (OSError, ValueError, SyntaxError):
            return None
        raise ValueError(f"a texture of {len(data)} bytes has too many pixels")


def _transform(node: dict) -> np.ndarray:
    """Transform ``[4, 4]`` of a node relative to its parent."""
    if "matrix" in node:
        return numbers_of(node, "matrix", 16).reshape(4, 4).T
    made = np.eye(4)
    made[:3, 3], turn, scale = (part[0] for part in pose(node))
    made[:3, :3] = R.to_matrix(turn).numpy() * scale
    return made
