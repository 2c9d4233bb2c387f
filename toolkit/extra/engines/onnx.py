"""The step's network as ONNX: normalisers, gating, experts and style modulation in one graph.

`torch.onnx` traces `Predictor.predict`, so there is one description of the seven networks.
"""

import contextlib
import copy
import json
import logging
import os
import warnings
from collections.abc import Iterator
from pathlib import Path

import torch
from torch import Tensor, nn

from toolkit.io.files import write_whole
from toolkit.io.model_files import sound
from toolkit.motion.trajectory import FPS
from toolkit.networks import Predictor
from toolkit.networks.bank import StyleBank
from toolkit.networks.phase import initial_pose

OPSET = 18
BANK = ".styles.safetensors"  # ending of the file of style vectors beside the graph


def save(model: Predictor, path: str | os.PathLike, bank: StyleBank | None = None) -> list[Path]:
    """Write the network as ONNX, and its style vectors beside it as ``<name>.styles.safetensors``.

    Inputs are ``x [batch, Dx]`` (``[batch, K + 1, Dx]`` for a model that remembers K frames),
    ``phases [batch, n_phases]`` (absent where the model knows no phase) and ``style [batch, D]``
    (or ``[1, D]``, one for all), output is ``z [batch, Dz]``: float32, physical units, any batch,
    as of `Predictor.predict`. Metadata, each a JSON text: ``model`` (its name), ``layout``
    (skeleton), ``joints`` (the J of the features), ``columns`` (of x and z by name), ``samples``
    (offsets of the trajectory, frames), ``fps``, ``start`` (a phase and a pose to begin with) and
    ``styles``.

    Returns the files that were written, each whole or not at all. ``bank`` holds the styles of the
    model.

    Raises
    ------
    ValueError
        If the bank's vectors are not this model's, or a weight is not finite.
    ImportError
        If the package onnxscript is not there.
    """
    path = Path(path)
    if bank is not None and bank.vectors.shape[1] != model.style_size:
        raise ValueError(f"the model takes style vectors [{model.style_size}], "
                         f"the bank has [{bank.vectors.shape[1]}]")
    write_whole(path, graph(model, bank).SerializeToString())
    if bank is None:
        return [path]
    bank.save(path.with_suffix(BANK))
    return [path, path.with_suffix(BANK)]


def graph(model: Predictor, bank: StyleBank | None = None):
    """The network as ``onnx.ModelProto``."""
    try:
        import onnxscript  # noqa: F401  # torch.onnx works with it, and asks for it late
    except ImportError:
        raise ImportError('ONNX needs the extra "export": pip install ".[export]"') from None
    sound(model.state_dict())
    widths = {"x": model.layout.n_inputs, "phases": model.layout.n_phases,
              "style": model.style_size}
    rows = {"x": 2, "phases": 2, "style": 3}
    example = {name: torch.zeros(rows[name], width) for name, width in widths.items() if width}
    if model.memory:
        example["x"] = torch.zeros(2, model.memory + 1, widths["x"])
    # the second axis takes the name of the first
    axes = {"x": "batch", "phases": torch.export.Dim.DYNAMIC, "style": "styles"}
    step = _Step(copy.deepcopy(model)).cpu().eval()
    if model.generator is not None:
        step.model.modulation.generator = None
    with _quiet():
        made = torch.onnx.export(
            step, kwargs=example, input_names=list(example), output_names=["z"],
            dynamic_shapes={name: {0: axes[name]} for name in example}, opset_version=OPSET,
            dynamo=True, verbose=False)
    for node in made.model.graph:
        node.metadata_props.clear()  # lines and paths of source files
    metadata = _metadata(model, bank)
    made.model.metadata_props.update({key: json.dumps(of) for key, of in metadata.items()})
    return made.model_proto


class _Step(nn.Module):
    """`Predictor.predict` with one row of styles for all characters, or a row each."""

    def __init__(self, model: Predictor):
        super().__init__()
        self.model = model

    def forward(self, x: Tensor, phases: Tensor | None = None,
                style: Tensor | None = None) -> Tensor:
        """``x [B, Dx]``, ``phases [B, n_phases]`` or none, ``style [B or 1, D]`` to ``[B, Dz]``."""
        # torch.export cannot trace a broadcast of two free sizes; ONNX's own Add does it when the
        # network runs
        row = x if x.dim() == 2 else x[:, -1]
        styles = torch.onnx.ops.symbolic("Add", (style, torch.zeros_like(row[:, :1])),
                                         dtype=style.dtype,
                                         shape=(x.shape[0], style.shape[1]), version=OPSET)
        return self.model.predict(x, row[:, :0] if phases is None else phases, styles)


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Inside, torch's exporter does not warn of its own calls and of other packages."""
    logger = logging.getLogger("torch.onnx")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        with warnings.catch_warnings(action="ignore", category=FutureWarning):
            yield
    finally:
        logger.setLevel(level)


def _metadata(model: Predictor, bank: StyleBank | None) -> dict:
    layout, (phase, pose) = model.layout, initial_pose(model)
    columns = {"x": layout.inputs, "z": layout.outputs}
    for name, blocks in columns.items():
        columns[name] = {block: [where.start, where.stop] for block, where in blocks.items()}
    return {
        "model": model.name, "layout": layout.to_json(), "joints": layout.names,
        "samples": list(layout.samples), "fps": FPS, "columns": columns,
        "start": {"phases": phase.tolist(), "joints": pose.tolist()},
        "styles": [] if bank is None else bank.names,
    }
