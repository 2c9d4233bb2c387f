"""The step's network as ONNX, for engines and ONNX Runtime: normalisers, gating, experts and style modulation in one graph.

Written node by node, in the form that `toolkit.networks.experts` computes (inputs scaled by gates, one product per layer).
"""

import json
import math
import os
from pathlib import Path

import numpy as np
from torch import Tensor

from toolkit.io.files import atomic_write
from toolkit.motion.trajectory import FPS, SAMPLES
from toolkit.networks import Model
from toolkit.networks.adapters import OneHot
from toolkit.networks.bank import StyleBank
from toolkit.networks.film import EPSILON, Film
from toolkit.networks.gating import CatmullRom, VelocityGating
from toolkit.networks.phase import amid_a_stride

OPSET, IR_VERSION = 18, 10
BANK = ".styles.safetensors"  # ending of the file of style vectors beside the graph


def save(model: Model, path: str | os.PathLike, bank: StyleBank | None = None) -> list[Path]:
    """Write the network as ONNX, and its style vectors beside it as ``<name>.styles.safetensors``.

    Inputs are ``x [batch, Dx]``, ``phases [batch, n_phases]`` (absent where the model knows no phase) and
    ``style [batch, D]`` (or ``[1, D]``, one for all), output is ``z [batch, Dz]``: float32, physical units, any batch, as of
    `Model.predict`. Metadata, each a JSON text: ``model`` (its name), ``layout`` (skeleton), ``joints`` (the J of the
    features), ``columns`` (of x and z by name), ``samples`` (offsets of the trajectory, frames), ``fps``, ``start`` (a phase
    and a pose to begin with) and ``styles``.

    Parameters
    ----------
    model
        Any of the seven.
    path
        The file to write.
    bank
        Its styles.

    Returns
    -------
    list of Path
        The files that were written, each whole or not at all.

    Raises
    ------
    ValueError
        If the bank's vectors are not this model's.
    ImportError
        If the package onnx is not there.
    """
    path = Path(path)
    if bank is not None and bank.vectors.shape[1] != model.style_size:
        raise ValueError(f"the model takes style vectors [{model.style_size}], the bank has [{bank.vectors.shape[1]}]")
    packed, files = graph(model, bank).SerializeToString(), [path]
    with atomic_write(path) as file:
        file.write(packed)
    if bank is not None:
        files.append(path.with_suffix(BANK))
        bank.save(files[1])
    return files


def graph(model: Model, bank: StyleBank | None = None):
    """The ``onnx.ModelProto`` that `save` writes."""
    try:
        from onnx import TensorProto, checker, helper
    except ImportError:
        raise ImportError('ONNX needs the extra "export": pip install ".[export]"') from None
    layout, g = model.layout, _Graph()
    widths = {"x": layout.n_inputs, "phases": layout.n_phases, "style": model.style_size}
    x = g.normalised("x", model, "inputs")
    gates = _gates(g, model, x)
    wide, h = g.node("Unsqueeze", gates, g.constant([2])), x
    for i, layer in enumerate(model.experts.layers):
        experts, rows, _ = layer.weight.shape
        scaled = g.node("Mul", wide, g.node("Unsqueeze", h, g.constant([1])))
        scaled = g.node("Reshape", scaled, g.constant([-1, experts * rows]))
        product = g.node("MatMul", scaled, g.constant(layer.weight.flatten(0, 1)))
        f = g.node("Add", product, g.node("MatMul", gates, g.constant(layer.bias)))
        h = f if layer is model.experts.layers[-1] else _modulated(g, model.modulation, i, f, h, wide)
    outputs = model.normaliser("outputs")
    g.node("Add", g.node("Mul", h, g.constant(outputs.std)), g.constant(outputs.mean), name="z")

    def value(name: str, width: int):
        return helper.make_tensor_value_info(name, TensorProto.FLOAT, ["styles" if name == "style" else "batch", width])

    inputs = [value(name, width) for name, width in widths.items() if width]
    made = helper.make_graph(g.nodes, "step", inputs, [value("z", layout.n_outputs)], g.constants)
    made = helper.make_model(made, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=IR_VERSION,
                             producer_name="toolkit")
    helper.set_model_props(made, {key: json.dumps(entry) for key, entry in _metadata(model, bank).items()})
    checker.check_model(made, full_check=True)
    return made


def _metadata(model: Model, bank: StyleBank | None) -> dict:
    layout, (phase, pose) = model.layout, amid_a_stride(model)
    columns = {"x": layout.inputs, "z": layout.outputs}
    return {
        "model": model.name, "layout": json.loads(layout.to_json()), "joints": layout.names,
        "samples": list(SAMPLES), "fps": FPS,
        "columns": {name: {block: [s.start, s.stop] for block, s in slices.items()} for name, slices in columns.items()},
        "start": {"phases": phase.tolist(), "joints": pose.tolist()}, "styles": [] if bank is None else bank.names,
    }


class _Graph:
    """Nodes and constants, named as they come."""

    def __init__(self):
        self.nodes, self.constants = [], []

    def node(self, kind: str, *inputs: str, name: str | None = None, **attributes) -> str:
        """The name of the output of a new node."""
        from onnx import helper

        self.nodes.append(helper.make_node(kind, list(inputs), [name or f"{kind}{len(self.nodes)}"], **attributes))
        return self.nodes[-1].output[0]

    def constant(self, values) -> str:
        """The name of a tensor: of floats from torch, of integers (int64) or of one number (float32)."""
        from onnx import numpy_helper

        kind = np.int64 if isinstance(values, list) else np.float32
        array = values.detach().cpu().contiguous().numpy() if isinstance(values, Tensor) else np.array(values, kind)
        self.constants.append(numpy_helper.from_array(array, f"c{len(self.constants)}"))
        return self.constants[-1].name

    def normalised(self, name: str, model: Model, kind: str) -> str:
        n = model.normaliser(kind)
        return self.node("Div", self.node("Sub", name, self.constant(n.mean)), self.constant(n.std))

    def part(self, name: str, start: int, width: int) -> str:
        """Columns of a matrix."""
        return self.node("Slice", name, self.constant([start]), self.constant([start + width]), self.constant([1]))


def _gates(g: _Graph, model: Model, x: str) -> str:
    """Blending coefficients ``[batch, K]``, see `toolkit.networks.gating`."""
    gating = model.gating
    if isinstance(gating, CatmullRom):
        return _catmull_rom(g, g.normalised("phases", model, "phases"), gating.points)
    if isinstance(gating, VelocityGating):
        h = g.node("Gather", x, g.constant(gating.columns), axis=1)
    else:
        h = g.normalised("phases", model, "phases")
    for layer in gating.layers:
        h = g.node("Gemm", h, g.constant(layer.weight), g.constant(layer.bias), transB=1)
        h = g.node("Softmax", h, axis=-1) if layer is gating.layers[-1] else g.node("Elu", h)
    return h


def _catmull_rom(g: _Graph, phase: str, points: int) -> str:
    """Coefficients by distance from each control point, see `toolkit.networks.gating.CatmullRom`."""
    count = g.constant(float(points))
    places = g.constant(points / 2 - Tensor(range(points)))
    along = g.node("Add", g.node("Mul", phase, g.constant(points / math.tau)), places)
    turns = g.node("Mul", g.node("Floor", g.node("Div", along, count)), count)
    d = g.node("Abs", g.node("Sub", g.node("Sub", along, turns), g.constant(points / 2)))

    def polynomial(*coefficients: float) -> str:
        """Of d, the highest power first."""
        total = g.constant(coefficients[0])
        for c in coefficients[1:]:
            total = g.node("Add", g.node("Mul", total, d), g.constant(c))
        return total

    near, far = polynomial(1.5, -2.5, 0.0, 1.0), polynomial(-0.5, 2.5, -4.0, 2.0)
    beyond = g.node("Where", g.node("Less", d, g.constant(2.0)), far, g.constant(0.0))
    return g.node("Where", g.node("Less", d, g.constant(1.0)), near, beyond)


def _modulated(g: _Graph, modulation, layer: int, f: str, x: str, gates: str) -> str:
    """Activation of a hidden layer: what it made, ``f``, of the inputs ``x``; ``gates [batch, K, 1]``."""

    def matrix(start: int, rows: int, columns: int) -> str:
        """Numbers of the style vector as a matrix ``[batch, rows, columns]``."""
        return g.node("Reshape", g.part("style", start, rows * columns), g.constant([-1, rows, columns]))

    if isinstance(modulation, Film):
        hidden = modulation.hidden
        gamma, beta = (g.part("style", (2 * layer + i) * hidden, hidden) for i in range(2))
        f = g.node("Add", g.node("Mul", gamma, _layer_norm(g, f, hidden)), beta)
    elif isinstance(modulation, OneHot):
        if layer == 0:
            shifts = g.node("Mul", gates, matrix(0, modulation.experts, modulation.hidden))
            f = g.node("Add", f, g.node("ReduceSum", shifts, g.constant([1]), keepdims=0))
    elif layer == 1:
        starts = np.cumsum([0, *modulation.widths]).tolist()
        *factors, b = (matrix(start, *shape) for start, shape in zip(starts, modulation.shapes, strict=False))
        h = g.node("MatMul", g.node("Unsqueeze", x, g.constant([1])), factors[0])
        if len(factors) > 1:
            _, c, u = factors
            h = g.node("Mul", h, g.node("MatMul", g.node("Transpose", gates, perm=[0, 2, 1]), c))
            h = g.node("MatMul", h, u)
        f = g.node("Add", f, g.node("Squeeze", g.node("Add", h, b), g.constant([1])))
    return g.node("Elu", f)


def _layer_norm(g: _Graph, f: str, width: int) -> str:
    """See `toolkit.networks.film.layer_norm`: ONNX's own has the biased deviation."""
    centred = g.node("Sub", f, g.node("ReduceMean", f, g.constant([1]), keepdims=1))
    square = g.node("ReduceSum", g.node("Mul", centred, centred), g.constant([1]), keepdims=1)
    deviation = g.node("Sqrt", g.node("Div", square, g.constant(width - 1)))
    return g.node("Div", centred, g.node("Add", deviation, g.constant(EPSILON)))
