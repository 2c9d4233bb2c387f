"""The skinned figure of an FBX file as binary glTF, which is then read as any other.

A cluster's matrix is glTF's inverse bind matrix: it leads from the mesh to the bone. FBX has
texture coordinates for each corner of each polygon, glTF has a vertex for each different corner.
"""

from pathlib import Path

import numpy as np

from toolkit.extra.formats.fbx import Scene, number, triple, turn
from toolkit.extra.formats.fbx_records import Record
from toolkit.extra.formats.gltf_file import Buffer, container
from toolkit.extra.formats.interpretation import interpret, upright
from toolkit.extra.formats.nodes import record
from toolkit.io import files
from toolkit.motion import rotations as R

HEIGHTS = 0.2, 20.0  # metres: a figure of another height has another unit than the file says
SLOTS = 4  # joints that a vertex may follow
CORNERS = 4_000_000  # of all meshes, beyond the bytes of the file
PICTURES = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg"}  # by their first bytes
DEFAULTS = {b"DiffuseColor": (0.8,) * 3, b"DiffuseFactor": (1.0,), b"GeometricScaling": (1.0,) * 3}


def glb(path: Path) -> bytes:
    """The bytes of a .glb file from an FBX file.

    It has the nodes in the pose of the file, in metres with y up, and the meshes as triangles with
    weights, texture coordinates, and for each material its colour, or its picture if the file holds
    that. Where the file's unit makes a figure that is much smaller or taller than people, the unit
    is guessed as for a motion.
    """
    return _Figure(files.read(path)).glb(path)


class _Figure(Scene):
    """The scene of an FBX file with its meshes."""

    def glb(self, path: Path) -> bytes:
        """The scene as a .glb file."""
        self.buffer, self.corners = Buffer(), CORNERS + len(self.data)
        self.lists: dict[str, list] = {name: [] for name in (
            "meshes", "skins", "materials", "textures", "images")}
        nodes, self.places = self.nodes({}), {key: i for i, key in enumerate(self.models)}
        still = record(nodes, 1, 30.0, format_="FBX", unit=self.unit, up=self.up, doubts=[])
        found, unit = interpret(still, path)[1], self.unit
        if not unit or not HEIGHTS[0] < found.height / found.unit * unit < HEIGHTS[1]:
            unit = found.unit

        made = [{"name": node.name, "translation": node.translation[0].tolist(),
                 "rotation": node.rotation[0].roll(-1).tolist(), "scale": node.scale[0].tolist(),
                 "children": []} for node in nodes]
        made.append({"name": "FBX", "rotation": upright(found.up).roll(-1).tolist(),
                     "scale": [unit] * 3, "children": []})
        for i, node in enumerate(nodes):
            made[node.parent]["children"].append(i)  # the last is above those without a parent
        for model, i in self.places.items():
            for geometry in self.linked(model, b"Geometry"):
                made[i] |= self._mesh(model, geometry)
        made = [{key: value for key, value in node.items() if value != []} for node in made]
        used = {name: of for name, of in self.lists.items() if of}
        return container({"asset": {"version": "2.0"}, "scene": 0, "nodes": made,
                          "scenes": [{"nodes": [len(nodes)]}], **used}, self.buffer)

    def _mesh(self, model: int, geometry: int) -> dict:
        """Mesh and skin of a node: a primitive for each of its materials."""
        parts = self._inside(self.parts[geometry])
        points = self._numbers(parts, b"Vertices")
        points = points[: len(points) // 3 * 3].reshape(-1, 3)
        corners = self._numbers(parts, b"PolygonVertexIndex").astype(np.int64)
        self.corners -= len(corners)
        if self.corners < 0:
            raise ValueError("its meshes have more corners than a file of this size should hold")
        ends = corners < 0  # the last corner of a polygon is stored as its complement
        corners = np.where(ends, ~corners, corners)
        if not (corners < len(points)).all():
            raise ValueError("a polygon has a corner that does not exist")

        # A polygon is a fan of triangles from its first corner
        polygon = np.cumsum(ends) - ends
        first = np.flatnonzero(np.append(True, ends[:-1]))[polygon]
        within = np.flatnonzero(~ends[:-1] & (np.arange(len(corners))[:-1] > first[:-1]))
        fans = np.stack((first[within], within, within + 1), 1)

        # The transform that a node has for its mesh alone
        values = DEFAULTS | self.models[model].values
        move, angles, scale = (triple(values, b"Geometric" + what)
                               for what in (b"Translation", b"Rotation", b"Scaling"))
        points = (scale * points) @ R.to_matrix(turn(angles[None]))[0].numpy().T + move

        across = self._at_corners(parts, b"UV", b"UV", 2, polygon, corners)
        material = self._at_corners(parts, b"Material", b"Materials", 1, polygon, corners)
        material = np.zeros(len(corners)) if material is None else material[:, 0]
        materials, primitives = self.linked(model, b"Material"), []
        skin, joints, weights = self._skin(geometry, len(points))
        normals = smooth(points, corners[fans])
        for kind in np.unique(material[fans[:, 0]]).astype(int).tolist():
            own = fans[material[fans[:, 0]] == kind].reshape(-1)
            rows = corners[own, None] if across is None else np.column_stack(
                (corners[own], across[own]))
            rows, indices = np.unique(rows, axis=0, return_inverse=True)
            at = rows[:, 0].astype(np.int64)
            attributes = {"POSITION": self._add(points[at], bounds=True),
                          "NORMAL": self._add(normals[at])}
            if across is not None:  # v goes up in FBX
                attributes["TEXCOORD_0"] = self._add(rows[:, 1:] * (1, -1) + (0, 1))
            if skin:
                attributes["JOINTS_0"] = self.buffer.add(joints[at].astype("<u2"))
                attributes["WEIGHTS_0"] = self._add(weights[at])
            primitives.append({"attributes": attributes, "indices": self.buffer.add(
                indices.reshape(-1).astype("<u4"))})
            if 0 <= kind < len(materials):
                primitives[-1]["material"] = self._material(materials[kind])
        return {"mesh": self._listed("meshes", {"primitives": primitives}), **skin} if primitives \
            else {}

    def _skin(self, geometry: int, count: int) -> tuple[dict, np.ndarray, np.ndarray]:
        """The skin of a mesh; joints and weights ``[V, 4]`` of its vertices, the largest ones."""
        bones, inverse, rows = [], [], [np.zeros((0, 3))]
        skins = self.linked(geometry, b"Deformer")
        for cluster in [part for skin in skins for part in self.linked(skin, b"Deformer")]:
            parts = self._inside(self.parts[cluster])
            matrix, vertices, weights = (self._numbers(parts, name) for name in (
                b"Transform", b"Indexes", b"Weights"))
            bone = self.connected(cluster, self.models)
            if not bone or len(matrix) != 16:
                continue
            if len(vertices) != len(weights) or not ((vertices >= 0) & (vertices < count)).all():
                raise ValueError("the weights of a mesh do not fit its vertices")
            rows.append(np.column_stack((vertices, np.full(len(vertices), len(bones)), weights)))
            bones.append(self.places[bone[0][0]])
            inverse.append(matrix.reshape(4, 4))
        vertex, bone, weight = np.concatenate(rows).T
        order = np.lexsort((-weight, vertex))
        vertex, bone, weight = vertex[order].astype(int), bone[order], weight[order]
        rank = np.arange(len(vertex)) - np.searchsorted(vertex, vertex)
        most = rank < SLOTS
        joints, weights = np.zeros((2, count, SLOTS))
        joints[vertex[most], rank[most]] = bone[most]
        weights[vertex[most], rank[most]] = weight[most]
        weights /= np.maximum(weights.sum(1, keepdims=True), 1e-6)
        skin = {"skin": self._listed("skins", {
            "joints": bones, "inverseBindMatrices": self._add(np.stack(inverse))})} if bones else {}
        return skin, joints, weights

    def _at_corners(self, parts: dict[bytes, Record], kind: bytes, name: bytes, width: int,
                    polygon: np.ndarray, corners: np.ndarray) -> np.ndarray | None:
        """Values ``[corners, width]`` of a layer at each corner; None where they do not fit."""
        if b"LayerElement" + kind not in parts:
            return None
        own = self._inside(parts[b"LayerElement" + kind])
        values = self._numbers(own, name)
        values = values[: len(values) // width * width].reshape(-1, width)
        rows = {b"ByPolygonVertex": np.arange(len(corners)), b"ByPolygon": polygon,
                b"ByVertice": corners, b"AllSame": 0 * corners}.get(
            self._first(own, b"MappingInformationType"))
        if rows is not None and len(among := self._numbers(own, kind + b"Index")):
            rows = among.astype(np.int64)[rows.clip(0, len(among) - 1)]
        if rows is None or not ((rows >= 0) & (rows < len(values))).all():
            return None
        return values[rows]

    def _material(self, key: int) -> int:
        """Index of a material: its colour in linear light, or its picture."""
        values = DEFAULTS | self.properties(self.parts[key])
        color = triple(values, b"DiffuseColor") * number(values[b"DiffuseFactor"])
        surface: dict = {"metallicFactor": 0.0}
        for video in [video for texture in self.linked(key, b"Texture", b"DiffuseColor")
                      for video in self.linked(texture, b"Video")]:
            data = self._first(self._inside(self.parts[video]), b"Content")
            for start, kind in PICTURES.items():
                if data and data.startswith(start):  # it takes the place of the colour
                    image = {"bufferView": self.buffer.view(data), "mimeType": kind}
                    texture = self._listed("textures", {"source": self._listed("images", image)})
                    surface["baseColorTexture"], color = {"index": texture}, np.ones(3)
        surface["baseColorFactor"] = [*color.clip(0.0, 1.0).tolist(), 1.0]
        return self._listed("materials", {"pbrMetallicRoughness": surface, "doubleSided": True})

    def _listed(self, name: str, entry: dict) -> int:
        """Index of an entry that joins a list of the document."""
        self.lists[name].append(entry)
        return len(self.lists[name]) - 1

    def _add(self, values: np.ndarray, *, bounds: bool = False) -> int:
        """Index of the accessor of finite numbers."""
        if not (np.abs(values) < 1e30).all():
            raise ValueError("a mesh has numbers that are not finite")
        return self.buffer.add(values.astype("<f4"), bounds=bounds)

    def _inside(self, record: Record) -> dict[bytes, Record]:
        return {part.name: part for part in self.children(record)}

    def _numbers(self, parts: dict[bytes, Record], name: bytes) -> np.ndarray:
        """The array in a record; empty if there is none."""
        value = self._first(parts, name, np.ndarray)
        return np.zeros(0) if value is None else value

    def _first(self, parts: dict[bytes, Record], name: bytes, kind: type = bytes):
        """The first value of a record, if it is of a kind."""
        values = self.values(parts[name]) if name in parts else []
        return values[0] if values and isinstance(values[0], kind) else None

    def linked(self, key: int, kind: bytes, name: bytes = b"") -> list[int]:
        """Objects of a kind that are connected to an object, or to a property of it."""
        return [other for other, prop in self.connected(key, self.parts)
                if prop == name and self.parts[other].name == kind]


def smooth(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Unit normals ``[V, 3]``: the mean of those of the triangles around, by their area."""
    first, second, third = points[triangles].swapaxes(0, 1)
    faces, normals = np.cross(second - first, third - first), np.zeros_like(points)
    for corner in triangles.T:
        np.add.at(normals, corner, faces)
    return normals / np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-12)
