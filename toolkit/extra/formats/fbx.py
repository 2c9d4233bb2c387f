"""Binary FBX 7 files: the animation of a skeleton, sampled at the file's rate.

FBX has no public specification. The layout of the file is in Blender's notes on it
(code.blender.org, 2013). The order of a node's transforms is in Autodesk's FBX SDK guide
("Computing transformation matrices"). This reader was compared with ufbx.
"""

import os
from collections import defaultdict
from collections.abc import Container, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.formats.fbx_curves import LARGEST, Curve, read_curve
from toolkit.extra.formats.fbx_records import Record, Records
from toolkit.extra.formats.key_times import sampled
from toolkit.extra.formats.nodes import Node, chosen, record
from toolkit.io import files
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.text import printable

SECOND, NEW_SECOND = 46186158000, 141120000  # units of time in a second
RATES = {1: 120.0, 2: 100.0, 3: 60.0, 4: 50.0, 5: 48.0, 6: 30.0, 7: 30.0, 8: 30 / 1.001,
         9: 30 / 1.001, 10: 25.0, 11: 24.0, 12: 1000.0, 13: 24 / 1.001, 15: 96.0, 16: 72.0,
         17: 60 / 1.001, 18: 120 / 1.001}  # by TimeMode
OWN_RATE = 14  # the TimeMode whose rate is in CustomFrameRate
USUAL = 30.0  # frames per second of the other modes
ORDERS = ("ZYX", "YZX", "XZY", "ZXY", "YXZ", "XYZ")  # of the product, by RotationOrder
BONES = (b"LimbNode", b"Limb", b"Root")
FIGURE = b"Geometry", b"Deformer", b"Material", b"Texture", b"Video"  # objects of a skinned mesh
OBJECTS = (b"Model", b"AnimationStack", b"AnimationLayer", b"AnimationCurveNode",
           b"AnimationCurve", *FIGURE)  # that are read
TRACKS = {b"Lcl Translation": (0.0,) * 3, b"Lcl Rotation": (0.0,) * 3, b"Lcl Scaling": (1.0,) * 3}


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike, animation: str | int | None = None) -> Recording:
    """Read an animation stack ("take") of a binary FBX file, version 7 (2011 and later).

    If an animation has several layers, the first one is read.

    Parameters
    ----------
    path : the file
    animation : name or index of the stack; by default the first one

    Raises
    ------
    ValueError
        If the file is a text FBX, older than version 7, damaged, or holds no rigid skeleton.
    """
    with files.named(path):
        return Scene(files.read(path)).recording(animation)


@dataclass
class _Model:
    """A node of the scene."""

    name: str
    kind: bytes
    values: dict[bytes, tuple]  # its properties
    skinned: bool = False


class Scene(Records):
    """Models, curves and connections of the file."""

    def __init__(self, data: bytes):
        super().__init__(data)
        self.second = SECOND
        self.settings: dict[bytes, tuple] = {}
        self.defaults: dict[bytes, tuple] = {}  # properties of models that do not say their own

        # Objects by id
        self.models: dict[int, _Model] = {}
        self.stacks: dict[int, str] = {}
        self.layers: set[int] = set()
        # values of a property's axes that have no curve
        self.curve_nodes: dict[int, dict[bytes, tuple]] = {}
        self.curves: dict[int, Record] = {}
        self.parts: dict[int, Record] = {}  # objects of `FIGURE`
        # what is connected to each object, and to which property of it
        self.below: dict[int, list[tuple[int, bytes]]] = defaultdict(list)
        for top in self.records(27, len(data)):
            for entry in self.children(top):
                if top.name == b"FBXHeaderExtension":
                    self._time_unit(entry)
                elif top.name == b"Definitions" and self.values(entry)[:1] == [b"Model"]:
                    for template in self.children(entry):
                        self.defaults |= self.properties(template)
                elif top.name == b"Objects":
                    self._object(entry)
                elif top.name == b"Connections":
                    self._connect(self.values(entry))
            if top.name == b"GlobalSettings":
                self.settings = self.properties(top)

        # A cluster of a skin follows one bone
        for cluster, part in self.parts.items():
            if part.name == b"Deformer":
                for key, _ in self.connected(cluster, self.models):
                    self.models[key].kind, self.models[key].skinned = BONES[0], True

    def _time_unit(self, entry: Record) -> None:
        """Since 2020 a flag may say that time has another unit."""
        for flag in self.children(entry) if entry.name == b"OtherFlags" else ():
            if flag.name == b"TCDefinition" and self.values(flag)[:1] == [0]:
                self.second = NEW_SECOND

    def _object(self, record: Record) -> None:
        """Note an object of a kind that is needed."""
        if record.name not in OBJECTS:
            return
        key, name, kind = [*self.values(record), b"", b"", b""][:3]
        if not isinstance(key, int) or not isinstance(name, bytes) or not isinstance(kind, bytes):
            raise ValueError(f"an object {record.name.decode()} without its id and name")
        title = printable(name.split(b"\0")[0].removeprefix(b"Model::").decode(errors="replace"))
        match record.name:
            case b"Model":
                self.models[key] = _Model(title, kind, self.defaults | self.properties(record))
            case b"AnimationStack":
                self.stacks[key] = title
            case b"AnimationLayer":
                self.layers.add(key)
            case b"AnimationCurveNode":
                self.curve_nodes[key] = self.properties(record)
            case b"AnimationCurve":
                self.curves[key] = record
            case _:
                self.parts[key] = record

    def _connect(self, link: list) -> None:
        """Note that an object is connected to another one, or to a property of it."""
        if len(link) < 3 or not all(isinstance(x, int) for x in link[1:3]):
            return
        _, key, to, *prop = link
        self.below[to].append((key, prop[0] if prop and isinstance(prop[0], bytes) else b""))

    def connected(self, to: int | None, among: Container[int]) -> list[tuple[int, bytes]]:
        """Those of some objects that are connected to an object, and to which property."""
        return [(key, name) for key, name in self.below.get(to, ()) if key in among]

    def recording(self, animation: str | int | None) -> Recording:
        """An animation on the largest skeleton."""
        doubts: list[str] = []
        tracks = self._layer(animation, doubts)
        keys = {key for of in tracks.values() for node in of.values()
                for key, _ in self.connected(node, self.curves)}
        curves = {key: read_curve(self, self.curves[key], self.second) for key in keys}

        # One rate for all curves
        mode = self._setting(b"TimeMode", 6)
        own = float(self._setting(b"CustomFrameRate", USUAL))
        usual = RATES.get(mode, own if mode == OWN_RATE and 1 <= own <= 1000 else USUAL)
        times = [curve.times for curve in curves.values() if len(curve.times) > 1]
        joints = sum(m.kind in BONES or bool(tracks[key]) for key, m in self.models.items())
        at, rate = sampled(times, usual, joints, len(self.data))

        moved = {model: {name: self._track(model, name, node, curves, at, doubts)
                         for name, node in of.items()} for model, of in tracks.items()}
        return record(self.nodes(moved), len(at), rate, format_="FBX", unit=self.unit, up=self.up,
                      doubts=doubts)

    def nodes(self, moved: dict[int, dict[bytes, np.ndarray]]) -> list[Node]:
        """The models as nodes; ``moved`` holds the animated properties of some."""
        places, nodes = {key: i for i, key in enumerate(self.models)}, []
        parents = {child: places[key] for key in self.models
                   for child, what in self.connected(key, self.models) if not what}
        for key, model in self.models.items():
            node = Node(model.name, parents.get(key, -1),
                        *_transform(model.values, moved.get(key, {})),
                        skinned=model.skinned, plain=model.kind in (*BONES, b"Null"))
            node.joint = model.kind in BONES or len(node.rotation) > 1 or len(node.translation) > 1
            nodes.append(node)

        # Models may say that they do not take part in their parent's scale
        scales = [np.median(node.scale, axis=0) for node in nodes]
        for node, model in zip(nodes, self.models.values(), strict=True):
            if model.values.get(b"InheritType", (0,))[:1] == (2,) and node.parent >= 0:
                above = scales[node.parent]
                node.scale = node.scale / np.where(above == 0, 1.0, above)
        return nodes

    @property
    def unit(self) -> float | None:
        """Metres of the file's unit of length; None if it says none that can be."""
        scale = float(self._setting(b"UnitScaleFactor", 1.0))
        return scale / 100 if 1e-6 < scale < 1e6 else None

    @property
    def up(self) -> str | None:
        """The axis that points up; None if it is none of x, y and z."""
        up, sign = self._setting(b"UpAxis", 1), self._setting(b"UpAxisSign", 1)
        return "xyz"[int(up)] if up in (0, 1, 2) and sign == 1 else None

    def _layer(self, animation: str | int | None,
               doubts: list[str]) -> dict[int, dict[bytes, int]]:
        """For each model the curve nodes by property, of the first layer that has any."""
        index = chosen(list(self.stacks.values()), animation, doubts)
        stack = [*self.stacks, None][index]
        layers = [{node for node, _ in self.connected(layer, self.curve_nodes)}
                  for layer, _ in self.connected(stack, self.layers)]
        used = [nodes for nodes in layers if nodes]
        if len(used) > 1:
            doubts.append(f"the animation has {len(used)} layers; only the first was read")
        return {model: {name: node for node, name in self.connected(model, self.curve_nodes)
                        if used and node in used[0] and name in TRACKS} for model in self.models}

    def _track(self, model: int, name: bytes, node: int, curves: dict[int, Curve],
               at: np.ndarray, doubts: list[str]) -> np.ndarray:
        """Values ``[F, 3]`` of an animated property.

        An axis without a curve has the value of the curve node, or else of the model.
        """
        still, track = triple(self.models[model].values, name), np.empty((len(at), 3))
        own = {axis: curves[key] for key, axis in self.connected(node, self.curves)}
        for i, axis in enumerate((b"d|X", b"d|Y", b"d|Z")):
            if axis in own and len(own[axis].times):
                track[:, i], said = own[axis](at)
                doubts += [doubt for doubt in said if doubt not in doubts]
            else:
                track[:, i] = number(self.curve_nodes[node].get(axis, still[i : i + 1]))
        return track

    def _setting(self, name: bytes, default: float) -> float:
        value = self.settings.get(name, (default,))[:1]
        return value[0] if value and isinstance(value[0], int | float) else default


def number(values: Sequence) -> float:
    """The first of some values; 0 if there is none."""
    value = values[0] if len(values) else 0.0
    if not isinstance(value, int | float) or not abs(value) < LARGEST:
        raise ValueError("a property is not a finite number")
    return float(value)


def triple(values: dict[bytes, tuple], name: bytes) -> np.ndarray:
    """A property of three numbers, by default zeros, of a scale ones."""
    given = values.get(name, TRACKS.get(name, (0.0,) * 3))
    return np.array([number(given[i : i + 1]) for i in range(3)])


def turn(degrees: np.ndarray, order: str = "ZYX") -> Tensor:
    """Rotations ``[F, 4]`` of angles about x, y and z ``[F, 3]``."""
    columns = ["XYZ".index(axis) for axis in order]
    return R.from_euler(torch.deg2rad(torch.from_numpy(degrees[:, columns])), order)


def _transform(values: dict[bytes, tuple],
               moved: dict[bytes, np.ndarray]) -> tuple[np.ndarray, Tensor, np.ndarray]:
    """Translation, rotation and scale of a node, one row or one for each frame.

    Its matrix is T · Roff · Rp · Rpre · R · Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S · Sp⁻¹, with the names
    of the FBX SDK.
    """
    tracks = []
    for name in TRACKS:
        track = moved[name] if name in moved else triple(values, name)[None]
        still = len(track) > 1 and np.ptp(track, axis=0).max() < 1e-9
        tracks.append(track[:1] if still else track)
    move, angles, scale = tracks

    # Rpre · R · Rpost⁻¹; both are unused where rotation limits do not count
    limits = number(values.get(b"RotationSpaceForLimitOnly", (0,)))
    if number(values.get(b"RotationActive", (1,))) and not limits:
        order = int(number(values.get(b"RotationOrder", (0,))))
        turned = turn(angles, ORDERS[order] if 0 <= order < len(ORDERS) else ORDERS[0])
        before, after = (triple(values, name)[None] for name in (b"PreRotation", b"PostRotation"))
        turned = R.multiply(turn(before), turned) if before.any() else turned
        turned = R.multiply(turned, R.inverse(turn(after))) if after.any() else turned
    else:
        turned = turn(angles)

    # All that stands right of the rotation moves a point before it turns
    pivot, offset, scale_pivot, scale_offset = (triple(values, name) for name in (
        b"RotationPivot", b"RotationOffset", b"ScalingPivot", b"ScalingOffset"))
    if pivot.any() or scale_pivot.any() or scale_offset.any():
        inner = scale_offset - pivot + scale_pivot - scale * scale_pivot
        move = move + pivot + R.rotate(turned, torch.from_numpy(inner)).numpy()
    return move + offset, turned, scale
