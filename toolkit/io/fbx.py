"""Binary FBX 7 files: the animation of a skeleton, sampled at the file's rate.

FBX has no public specification. The layout of the file is in Blender's notes on it (code.blender.org, 2013); the order of a
node's transforms is in Autodesk's FBX SDK guide ("Computing transformation matrices"); the tangents of curves follow ufbx,
Samuli Raivio's reader in C, with which this one was compared.
"""

import os
from dataclasses import dataclass, field

import numpy as np
import torch
from torch import Tensor

from toolkit.io import files
from toolkit.io.fbx_records import Record, Records
from toolkit.io.nodes import Node, frame_rate, printable, record, sample_times
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.tensors import few

SECOND, NEW_SECOND = 46186158000, 141120000  # units of time in a second
RATES = {1: 120.0, 2: 100.0, 3: 60.0, 4: 50.0, 5: 48.0, 6: 30.0, 7: 30.0, 8: 30 / 1.001, 9: 30 / 1.001, 10: 25.0, 11: 24.0,
         12: 1000.0, 13: 24 / 1.001, 15: 96.0, 16: 72.0, 17: 60 / 1.001, 18: 120 / 1.001}  # by TimeMode
USUAL = 30.0  # frames per second of the other modes
ORDERS = ("ZYX", "YZX", "XZY", "ZXY", "YXZ", "XYZ", "ZYX")  # of the product, by RotationOrder; XYZ turns about x first
BONES, PLAIN = (b"LimbNode", b"Limb", b"Root"), (b"LimbNode", b"Limb", b"Root", b"Null")
CONSTANT, CUBIC, TCB, USER = 0x2, 0x8, 0x200, 0x400  # flags of a key
NEXT, CLAMP, TIME_INDEPENDENT, PROGRESSIVE, WEIGHTED = 0x100, 0x1000, 0x2000, 0x4000, 0x3000000
OBJECTS = 50_000  # limit for objects and connections of the kinds that are read
LARGEST = 1e30
_ONES, _ZEROS = (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike) -> Recording:
    """Read the first layer of the first animation stack ("take") of a binary FBX file, version 7 (2011 and later).

    Raises
    ------
    ValueError
        If the file is a text FBX, older than version 7, damaged, or holds no rigid skeleton.
    """
    with files.named(path):
        return _Scene(files.read(path)).recording()


@dataclass
class _Model:
    """A node of the scene."""

    name: str
    kind: bytes
    values: dict[bytes, tuple]  # its properties
    parent: int = 0  # id
    skinned: bool = False
    curves: dict[bytes, int] = field(default_factory=dict)  # ids of curve nodes, by property


class _Scene(Records):
    """Models, curves and connections of the file."""

    def __init__(self, data: bytes):
        super().__init__(data)
        self.settings, self.defaults, self.second = {}, {}, SECOND
        self.models, self.curve_nodes, self.curves = {}, {}, {}
        self.stacks, self.layers, self.clusters, self.repeated, self.doubts = {}, {}, set(), set(), []
        links, objects = [], 0
        for top in self.records(27, len(data)):
            if top.name == b"FBXHeaderExtension":
                self._header(top)
            elif top.name == b"GlobalSettings":
                self.settings = self.properties(top)
            elif top.name == b"Definitions":
                self._defaults(top)
            elif top.name == b"Objects":
                for entry in self.children(top):
                    objects += self._object(entry)
                    if objects > OBJECTS:
                        raise ValueError(f"more than {OBJECTS} objects")
            elif top.name == b"Connections":
                for entry in self.children(top):
                    links.append(self.values(entry, 4))
                    if len(links) > 10 * OBJECTS:
                        raise ValueError(f"more than {10 * OBJECTS} connections")
        self._connect(links)

    def _header(self, top: Record) -> None:
        for flags in self.children(top):
            if flags.name == b"OtherFlags":
                for flag in self.children(flags):
                    if flag.name == b"TCDefinition" and self.values(flag)[:1] == [0]:
                        self.second = NEW_SECOND

    def _defaults(self, top: Record) -> None:
        for kind in self.children(top):
            if kind.name == b"ObjectType" and self.values(kind)[:1] == [b"Model"]:
                for template in self.children(kind):
                    self.defaults |= self.properties(template)

    def _object(self, record: Record) -> bool:
        """Note an object of a kind that is needed."""
        if record.name not in (b"Model", b"AnimationStack", b"AnimationLayer", b"AnimationCurveNode", b"AnimationCurve",
                               b"Deformer"):
            return False
        key, name, kind = [*self.values(record, 3), b"", b"", b""][:3]
        if not isinstance(key, int) or not isinstance(name, bytes) or not isinstance(kind, bytes):
            raise ValueError(f"an object {record.name.decode()} without its id and name")
        title = printable(name.split(b"\0")[0].removeprefix(b"Model::").decode(errors="replace"))
        match record.name:
            case b"Model":
                self.models[key] = _Model(title, kind, self.defaults | self.properties(record))
            case b"AnimationStack":
                self.stacks[key] = title
            case b"AnimationLayer":
                self.layers[key] = None
            case b"AnimationCurveNode":
                self.curve_nodes[key] = (self.properties(record), {}, set())
            case b"AnimationCurve":
                self.curves[key] = record
            case b"Deformer" if kind == b"Cluster":
                self.clusters.add(key)
        return True

    def _connect(self, links: list[list]) -> None:
        """Parents of models, stacks of layers, layers and models of curve nodes, curves by component."""
        targets = {}
        for link in links:
            if len(link) < 3 or not all(isinstance(x, int) for x in link[1:3]):
                continue
            _, key, to, *prop = link
            name = prop[0] if prop and isinstance(prop[0], bytes) else b""
            if key in self.models and to in self.models:
                self.models[key].parent = to
            elif key in self.layers and to in self.stacks:
                self.layers[key] = to
            elif key in self.curve_nodes and to in self.layers:
                self.curve_nodes[key][2].add(to)
            elif key in self.curve_nodes and to in self.models:
                targets.setdefault(to, []).append((name, key))
            elif key in self.curves and to in self.curve_nodes:
                self.curve_nodes[to][1][name] = key
            elif key in self.models and to in self.clusters:
                self.models[key].kind, self.models[key].skinned = BONES[0], True
        self.targets = targets

    def recording(self) -> Recording:
        """The chosen animation on the largest skeleton."""
        self._choose()
        ids = {key: i for i, key in enumerate(self.models)}
        tracks = {(key, name): self.curve_nodes[node] for key, model in self.models.items()
                  for name, node in model.curves.items()}
        curves = {key: self._curve(key) for _, parts, _ in tracks.values() for key in parts.values() if key in self.curves}
        if bad := [c for c in curves.values() if not (np.diff(c[0]) > 0).all()]:
            raise ValueError(f"the {len(bad[0][0])} key times of a curve do not increase")
        mode = self._setting(b"TimeMode", 6)
        usual = RATES.get(mode, float(self._setting(b"CustomFrameRate", USUAL)) if mode == 14 else USUAL)
        usual = usual if 1 <= usual <= 1000 else USUAL
        times = [c[0] for c in curves.values() if len(c[0]) > 1]
        rate = frame_rate(times, usual) if times else usual
        at = sample_times(times, rate, sum(m.kind in BONES or bool(m.curves) for m in self.models.values()), len(self.data))
        nodes = []
        for key, model in self.models.items():
            moved = {name: self._track(model, tracks[key, name], name, curves, at) for name in model.curves}
            node = Node(model.name, ids.get(model.parent, -1), *_transform(model.values, moved), skinned=model.skinned,
                        plain=model.kind in PLAIN)
            node.joint = model.kind in BONES or len(node.rotation) > 1 or len(node.translation) > 1
            nodes.append(node)
        scales = [node.scale[0] if len(node.scale) == 1 else np.median(node.scale, axis=0) for node in nodes]
        for node, model in zip(nodes, self.models.values(), strict=True):
            if model.values.get(b"InheritType", (0,))[:1] == (2,) and node.parent >= 0:  # not scaled by its parent
                node.scale = node.scale / np.where(scales[node.parent] == 0, 1.0, scales[node.parent])
        if any(node.joint for node in nodes) and len(at) == 1:
            self.doubts.append("no joint is animated; the pose of the nodes is given as it is")
        up, sign = self._setting(b"UpAxis", 1), self._setting(b"UpAxisSign", 1)
        scale = float(self._setting(b"UnitScaleFactor", 1.0))
        return record(nodes, len(at), rate, format_="FBX", unit=scale / 100 if 1e-6 < scale < 1e6 else None,
                      up="xyz"[up] if up in (0, 1, 2) and sign == 1 else None, doubts=self.doubts)

    def _choose(self) -> None:
        """Give models the curve nodes of the first animation's first layer."""
        if len(self.stacks) > 1:
            names = few(self.stacks.values())
            self.doubts.append(f"the file holds {len(self.stacks)} animations ({names}); the first was read")
        stack = next(iter(self.stacks), None)
        layers = [key for key, of in self.layers.items() if of == stack]
        used = {layer for _, _, of in self.curve_nodes.values() for layer in of if layer in layers}
        if len(used) > 1:
            self.doubts.append(f"the animation has {len(used)} layers; only the first was read")
        base = next((layer for layer in layers if layer in used), None)
        for key, listed in self.targets.items():
            for name, node in listed:
                if base in self.curve_nodes[node][2] and name in (b"Lcl Translation", b"Lcl Rotation", b"Lcl Scaling"):
                    self.models[key].curves[name] = node

    def _setting(self, name: bytes, default: float) -> float:
        value = self.settings.get(name, (default,))[:1]
        return value[0] if value and isinstance(value[0], int | float) else default

    def _curve(self, key: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Key times in seconds, values, flags and slopes ``[K]``, ``[K]``, ``[K]``, ``[K, 4]`` of a curve."""
        for part in self.children(self.curves[key]):
            if part.name in (b"Pre-Extrapolation", b"Post-Extrapolation"):
                kinds = [self.values(of, 1) for of in self.children(part) if of.name == b"Type"]
                self.repeated |= {key} if any(kind[:1] not in ([ord("C")], [b"C"]) for kind in kinds) else set()
        found = {part.name: self.values(part, 1) for part in self.children(self.curves[key]) if part.name.startswith(b"Key")}
        arrays = {name: values[0] for name, values in found.items() if values and isinstance(values[0], np.ndarray)}
        times, values = (arrays.get(name, np.zeros(0)).astype(np.float64) for name in (b"KeyTime", b"KeyValueFloat"))
        if len(times) != len(values) or not (np.abs(values) < LARGEST).all():
            raise ValueError("a curve has numbers that are not finite, or other numbers of times and values")
        flags, slopes = np.zeros(len(times), np.int64), np.zeros((len(times), 4), np.float32)
        counts = arrays.get(b"KeyAttrRefCount", np.zeros(0, np.int64)).astype(np.int64)
        given, data = arrays.get(b"KeyAttrFlags", flags[:0]), arrays.get(b"KeyAttrDataFloat", slopes[:0])
        if len(counts) and len(counts) == len(given) and len(data) == 4 * len(counts) and (counts >= 0).all() and (
                counts.sum() == len(times)):
            flags = np.repeat(given.astype(np.int64), counts)
            slopes = np.repeat(data.astype(np.float32).reshape(-1, 4), counts, axis=0)
        return times / self.second, values, flags, slopes

    def _track(self, model: _Model, curve_node: tuple, name: bytes, curves: dict, at: np.ndarray) -> np.ndarray:
        """Values ``[F, 3]`` of an animated property."""
        defaults, parts, _ = curve_node
        own = _triple(model.values, name, _ONES if name == b"Lcl Scaling" else _ZEROS)
        track = np.empty((len(at), 3))
        for i, axis in enumerate((b"d|X", b"d|Y", b"d|Z")):
            if (curve := curves.get(parts.get(axis))) is not None and len(curve[0]):
                track[:, i], rough = _evaluate(*curve, at)
                inside = curve[0][0] < at[0] + 1e-3 and curve[0][-1] > at[-1] - 1e-3
                for doubt in (_ROUGH,) * rough + (_REPEATED,) * (parts[axis] in self.repeated and not inside):
                    if doubt not in self.doubts:
                        self.doubts.append(doubt)
            else:
                track[:, i] = _number(defaults.get(axis, own[i : i + 1]))
        return track


_REPEATED = "some curves go on beyond their keys by a rule; their last values were held"
_ROUGH = "some curves have weighted or TCB tangents between key frames; plain tangents were used"


def _number(values: tuple) -> float:
    value = values[0] if len(values) else 0.0
    if not isinstance(value, int | float) or not abs(value) < LARGEST:
        raise ValueError("a property is not a finite number")
    return float(value)


def _triple(values: dict[bytes, tuple], name: bytes, default: tuple[float, ...] = _ZEROS) -> np.ndarray:
    given = values.get(name, default)
    return np.array([_number(given[i : i + 1]) for i in range(3)])


def _turn(degrees: np.ndarray, order: str = "ZYX") -> Tensor:
    """Rotations ``[F, 4]`` of angles about x, y and z ``[F, 3]``."""
    columns = ["XYZ".index(axis) for axis in order]
    return R.from_euler(torch.deg2rad(torch.from_numpy(degrees[:, columns])), order)


def _transform(values: dict[bytes, tuple], moved: dict[bytes, np.ndarray]) -> tuple[np.ndarray, Tensor, np.ndarray]:
    """Translation, rotation and scale of a node, one row or one for each frame.

    Its matrix is T · Roff · Rp · Rpre · R · Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S · Sp⁻¹, with the names of the FBX SDK.
    """
    move, angles, scale = (moved[name] if name in moved else _triple(values, name, default)[None] for name, default in (
        (b"Lcl Translation", _ZEROS), (b"Lcl Rotation", _ZEROS), (b"Lcl Scaling", _ONES)))
    move, angles, scale = (x[:1] if len(x) > 1 and np.ptp(x, axis=0).max() < 1e-9 else x for x in (move, angles, scale))
    active = _number(values.get(b"RotationActive", (1,))) and not _number(values.get(b"RotationSpaceForLimitOnly", (0,)))
    if active:
        order = int(_number(values.get(b"RotationOrder", (0,))))
        turned = _turn(angles, ORDERS[order if 0 <= order < len(ORDERS) else 0])
        before, after = (_triple(values, name)[None] for name in (b"PreRotation", b"PostRotation"))
        turned = R.multiply(_turn(before), turned) if before.any() else turned
        turned = R.multiply(turned, R.inverse(_turn(after))) if after.any() else turned
    else:
        turned = _turn(angles)
    pivot, offset, scale_pivot, scale_offset = (_triple(values, name) for name in (
        b"RotationPivot", b"RotationOffset", b"ScalingPivot", b"ScalingOffset"))
    if pivot.any() or scale_pivot.any() or scale_offset.any():
        inner = scale_offset - pivot + scale_pivot - scale * scale_pivot
        move = move + pivot + R.rotate(turned, torch.from_numpy(inner)).numpy()
    return move + offset, turned, scale


def _evaluate(times: np.ndarray, values: np.ndarray, flags: np.ndarray, data: np.ndarray, at: np.ndarray
              ) -> tuple[np.ndarray, bool]:
    """A curve at times ``at`` [F], and whether its tangents between keys are of a kind that was replaced."""
    if len(times) == 1:
        return np.full(len(at), values[0]), False
    at = np.clip(at, times[0], times[-1])
    i = np.clip(np.searchsorted(times, at + 1e-7, "right") - 1, 0, len(times) - 2)
    span = times[i + 1] - times[i]
    t = np.clip((at - times[i]) / span, 0.0, 1.0)
    between, kind = (t > 1e-4) & (t < 1 - 1e-4), flags[i]
    made = values[i] + t * (values[i + 1] - values[i])
    if (cubic := (kind & CUBIC) > 0).any():
        right, left = _slopes(times, values, flags, data.astype(np.float64))
        out, into = right[i] * span, left[i + 1] * span
        curved = ((2 * t**3 - 3 * t**2 + 1) * values[i] + (t**3 - 2 * t**2 + t) * out + (3 * t**2 - 2 * t**3) * values[i + 1]
                  + (t**3 - t**2) * into)
        made = np.where(cubic, curved, made)
    constant = (kind & CONSTANT) > 0
    held = np.where((kind & NEXT) > 0, values[i + (t > 1e-4)], values[i + (t > 1 - 1e-4)])
    rough = between & cubic & (((kind & WEIGHTED) > 0) | ((kind & TCB) > 0))
    return np.where(constant, held, made), bool(rough.any())


def _slopes(times: np.ndarray, values: np.ndarray, flags: np.ndarray, data: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Slopes to the right and to the left of each key, per second: the user's, or those that the key's flags ask for."""
    step, rise = np.diff(times), np.diff(values)
    slope = rise / step
    before, after = np.append(slope[0], slope), np.append(slope, slope[-1])
    share = np.concatenate(([0.0], step[:-1] / (step[:-1] + step[1:]), [0.0]))
    whole = np.concatenate((slope[:1], (rise[:-1] + rise[1:]) / (step[:-1] + step[1:]), slope[-1:]))
    auto = np.where(flags & TIME_INDEPENDENT, whole, 0.5 * whole + 0.5 * (before * (1 - share) + after * share))
    near = np.minimum(np.append(np.inf, np.abs(rise)), np.append(np.abs(rise), np.inf))
    auto = np.where((flags & CLAMP > 0) & (near <= 1e-3), 0.0, auto)
    limit = 3.0 * np.maximum(np.minimum(np.sign(auto) * before, np.sign(auto) * after), 0.0)
    ends = np.zeros(len(times), bool)
    ends[[0, -1]] = True
    auto = np.where(flags & PROGRESSIVE, np.where(ends, 0.0, np.sign(auto) * np.minimum(np.abs(auto), limit)), auto)
    own = (flags & CUBIC > 0) & ((flags & USER == 0) | (flags & TCB > 0))
    right = np.where(own, auto, data[:, 0])
    left = np.where(own, auto, np.append(0.0, data[:-1, 1]))
    return tuple(np.nan_to_num(x, nan=0.0, posinf=0.0, neginf=0.0) for x in (right, left))
