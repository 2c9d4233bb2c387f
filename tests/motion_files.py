"""Small files of other tools' formats, written for tests: glTF, FBX, NumPy."""

import io
import json
import struct
import zlib

import numpy as np
import torch
from scipy.spatial.transform import Rotation

import toolkit as tk
from toolkit.extra.characters import retargeting
from toolkit.extra.formats import npz
from toolkit.motion import rotations as R

TYPES = {"f4": 5126, "i2": 5122, "u2": 5123, "u1": 5121, "i1": 5120, "u4": 5125}
SECOND = 46186158000


class Document:
    """A glTF document and its buffer; arrays are added to it."""

    def __init__(self, nodes, **more):
        self.json = {"asset": {"version": "2.0"}, "nodes": nodes, "bufferViews": [],
                     "accessors": [], **more}
        self.data = b""

    def add(self, values, **more):
        values = np.ascontiguousarray(values)
        kind = {0: "SCALAR", 1: "SCALAR", 2: "VEC2", 3: "VEC3",
                4: "VEC4", 16: "MAT4"}[1 if values.ndim == 1 else values.shape[1]]
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data),
                                         "byteLength": values.nbytes})
        self.json["accessors"].append({"bufferView": len(self.json["bufferViews"]) - 1,
                                       "count": len(values), "type": kind,
                                       "componentType": TYPES[values.dtype.str[1:]], **more})
        self.data += values.tobytes() + b"\0" * (-values.nbytes % 4)
        return len(self.json["accessors"]) - 1

    def animate(self, *tracks, name="walk"):
        """Add tracks: node, path, times, values, interpolation (more fields of the accessor)."""
        made = {"name": name, "channels": [], "samplers": []}
        for node, what, times, values, kind, *more in tracks:
            made["channels"].append({"sampler": len(made["samplers"]),
                                     "target": {"node": node, "path": what}})
            made["samplers"].append({"input": self.add(np.float32(times)),
                                     "output": self.add(values, **(more or [{}])[0]),
                                     "interpolation": kind})
        self.json.setdefault("animations", []).append(made)
        return self

    def skinned(self, points):
        """Attributes of vertices that all follow a skin's first joint."""
        rows = np.float32([[1, 0, 0, 0]] * len(points))
        return {"POSITION": self.add(np.float32(points)), "WEIGHTS_0": self.add(rows),
                "JOINTS_0": self.add(np.zeros(rows.shape, "u1"))}

    def glb(self):
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        return glb(self.json, self.data)


def glb(document, data):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = b"".join(struct.pack("<I4s", len(x), kind) + x for x, kind in ((text, b"JSON"),
                                                                            (data, b"BIN\0")))
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def glb_parts(path):
    """The JSON and the binary data of a .glb file."""
    data = path.read_bytes()
    magic, version, length, size, kind = struct.unpack_from("<4sII I4s", data)
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def textured(document, primitive, places, picture):
    """Give a primitive a texture, the bytes of a picture, at ``places [V, 2]``."""
    doc = document.json
    primitive["attributes"]["TEXCOORD_0"] = document.add(places)
    primitive["material"] = 0
    view = doc["accessors"][document.add(np.frombuffer(picture, "u1"))]["bufferView"]
    doc |= {"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                                                    "baseColorFactor": [1, 0.5, 0, 1]}}],
            "textures": [{"source": 0}], "images": [{"bufferView": view}]}


def fbx(records, version=7400, *, pack_arrays=True):
    """A binary FBX file of records ``(name, properties, children)``."""
    head, size = ("<QQQB", 25) if version >= 7500 else ("<IIIB", 13)

    def value(x):
        match x:
            case bool():
                return b"C" + struct.pack("<B", x)
            case int():
                return b"L" + struct.pack("<q", x)
            case float():
                return b"D" + struct.pack("<d", x)
            case bytes():
                return b"R" + struct.pack("<I", len(x)) + x
            case str():
                return b"S" + struct.pack("<I", len(x.encode())) + x.encode()
            case np.ndarray():
                data = zlib.compress(x.tobytes()) if pack_arrays else x.tobytes()
                letter = {"f4": b"f", "f8": b"d", "i8": b"l", "i4": b"i"}[x.dtype.str[1:]]
                return letter + struct.pack("<III", len(x), pack_arrays, len(data)) + data

    def pack(of, at):
        name, properties, children = of
        body = b"".join(map(value, properties))
        start = at + size + len(name) + len(body)
        inside = bytearray()
        for child in children:
            inside += pack(child, start + len(inside))
        inside += b"\0" * size if children else b""
        return struct.pack(head, start + len(inside), len(properties), len(body),
                           len(name)) + name.encode() + body + inside

    made = bytearray(b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", version))
    for of in records:
        made += pack(of, len(made))
    return bytes(made) + b"\0" * size


def table(**values):
    """A record of properties."""
    return ("Properties70", [], [("P", [name.replace("_", " "), "", "", "A", *value], [])
                                 for name, value in values.items()])


def fbx_scene(models, curves, *, settings=None, other=None, version=7400,
              pack_arrays=True, templates=()):
    """A scene of models ``{name: (parent, properties)}`` and of curves.

    ``templates`` are pairs of a kind of objects and its usual properties.

    ``curves`` are ``{(model, property, axis): (times, values, flags, data)}``.
    """
    ids = {name: 10 + i for i, name in enumerate(models)}
    objects = [("Model", [ids[name], f"{name}\0\x01Model", "LimbNode"], [table(**values)])
               for name, (_, values) in models.items()]
    links = [("C", ["OO", ids[name], ids.get(parent, 0)],
              []) for name, (parent, _) in models.items()]
    objects.append(("AnimationStack", [1, "Take\0\x01AnimStack", ""], []))
    objects.append(("AnimationLayer", [2, "Base\0\x01AnimLayer", ""], []))
    links.append(("C", ["OO", 2, 1], []))
    nodes = {}
    for i, ((model, what, axis), (times, values, flags, data)) in enumerate(curves.items()):
        if (model, what) not in nodes:
            nodes[model, what] = 1000 + len(nodes)
            objects.append(("AnimationCurveNode", [nodes[model, what], "T\0\x01AnimCurveNode", ""],
                            []))
            links += [("C", ["OO", nodes[model, what], 2], []),
                      ("C", ["OP", nodes[model, what], ids[model], what], [])]
        parts = [("KeyTime", [np.round(np.array(times) * SECOND).astype("<i8")]),
                 ("KeyValueFloat", [np.float32(values)]),
                 ("KeyAttrFlags", [np.array(flags, "<i4")]),
                 ("KeyAttrDataFloat", [np.float32(data).ravel()]),
                 ("KeyAttrRefCount", [np.ones(len(times), "<i4")])]
        objects.append(("AnimationCurve", [5000 + i, "\0\x01AnimCurve", ""],
                        [(n, p, []) for n, p in parts]))
        links.append(("C", ["OP", 5000 + i, nodes[model, what], f"d|{axis}"], []))
    wide = {"UpAxis": [1], "UpAxisSign": [1], "UnitScaleFactor": [1.0],
            "TimeMode": [6]} | (settings or {})
    wide = {name: value for name, value in wide.items() if value is not None}
    said = [(name, [value], []) for name, value in (other or {}).items()]
    usual = [("ObjectType", [kind], [("PropertyTemplate", ["X"], [table(**values)])])
             for kind, values in templates]
    return fbx([("FBXHeaderExtension", [], [("OtherFlags", [], said)]),
                ("GlobalSettings", [], [table(**wide)]),
                *([("Definitions", [], usual)] if usual else []), ("Objects", [], objects),
                ("Connections", [], links)], version, pack_arrays=pack_arrays)


def fbx_figure(character, picture):
    """A character as FBX: in metres below a node in centimetres, Z up, with a material of a colour.

    Half of the triangles show a picture from its lowest row at the feet to its highest at the head.
    The mesh lies half a metre aside, and its node moves it back.
    """
    objects, links = [], []

    def add(kind, name, what, *parts, to=0, prop=None):
        objects.append((kind, [len(objects) + 1, f"{name}\0\x01{kind}", what], list(parts)))
        links.append(["OP" if prop else "OO", len(objects), to, *([prop] if prop else [])])
        return len(objects)

    def array(name, values):
        return (name, [np.ascontiguousarray(values).ravel()], [])

    def layer(name, how, *arrays):
        return (f"LayerElement{name}", [0], [("MappingInformationType", [how], []), *arrays])

    rest, mesh, points = character.rest, character.mesh, character.points.astype(float)
    turned, places = R.to_matrix(rest.global_rotations[0]), rest.global_positions[0]
    angles = torch.rad2deg(R.to_euler(rest.rotations[0].double(), "ZYX")).flip(-1)
    top = add("Model", "Armature", "Null", table(Lcl_Rotation=[90.0, 0.0, 0.0],
                                                 Lcl_Scaling=[100.0] * 3))
    bones = []
    for j, parent in enumerate(mesh.parents):
        move = rest.skeleton.offsets[j] if j else places[0]
        bones.append(add("Model", mesh.names[j], "LimbNode", table(
            Lcl_Translation=move.tolist(), Lcl_Rotation=angles[j].tolist()),
            to=top if parent < 0 else bones[parent]))
    body = add("Model", "Body", "Mesh", table(GeometricTranslation=[-0.5, 0.0, 0.0]), to=top)

    across = np.stack((np.full(len(points), 0.5), np.interp(
        points[:, 1], [points[:, 1].min(), points[:, 1].max()], [0.1, 0.9])), 1)
    corners = mesh.triangles.copy()
    corners[:, 2] = ~corners[:, 2]
    kinds = np.arange(len(corners), dtype="<i4") % 2
    geometry = add(
        "Geometry", "Body", "Mesh", array("Vertices", points + np.array([0.5, 0.0, 0.0])),
        array("PolygonVertexIndex", corners.astype("<i4")),
        layer("UV", "ByPolygonVertex", array("UV", across),
              array("UVIndex", mesh.triangles.astype("<i4"))),
        layer("Material", "ByPolygon", array("Materials", kinds)),
        to=body)
    painted = add("Material", "Skin", "", to=body)
    texture = add("Texture", "Skin", "", to=painted, prop="DiffuseColor")
    add("Video", "Skin", "Clip", ("Content", [picture], []), to=texture)
    add("Material", "Cloth", "", table(DiffuseColor=[0.0, 1.0, 0.0]), to=body)
    skin = add("Deformer", "", "Skin", to=geometry)
    for j, bone in enumerate(bones):
        bound = np.eye(4)
        bound[:3, :3], bound[:3, 3] = turned[j], places[j]
        vertices, slots = np.nonzero((mesh.joints == j) & (mesh.weights > 0))
        cluster = add("Deformer", "", "Cluster", array("Indexes", vertices.astype("<i4")),
                      array("Weights", mesh.weights[vertices, slots]),
                      array("Transform", np.linalg.inv(bound).T), to=skin)
        links.append(["OO", bone, cluster])
    return fbx([("GlobalSettings", [], [table(UpAxis=[2], UpAxisSign=[1], UnitScaleFactor=[1.0])]),
                ("Objects", [], objects), ("Connections", [], [("C", link, []) for link in links])])


def smpl_walk(seconds=1.0):
    """A procedural walk on SMPL's joints."""
    clip = tk.datasets.procedural.generate("Neutral", seconds=seconds)
    offsets = npz.rest_pose(22).float()
    offsets[1:] += 0.02 * torch.randn(21, 3, generator=torch.Generator().manual_seed(0))
    return retargeting.retarget(clip, tk.Skeleton(npz.BODY, npz.PARENTS[:22], offsets,
                                                  roles=npz.ROLES, ends=()))


def axis_angles(q):
    """Rotation vectors of quaternions."""
    vectors = Rotation.from_quat(q.reshape(-1, 4), scalar_first=True).as_rotvec()
    return torch.from_numpy(vectors).reshape(*q.shape[:-1], 3)


def packed(**arrays):
    file = io.BytesIO()
    np.savez_compressed(file, **{name: np.asarray(value) for name, value in arrays.items()})
    return file.getvalue()
