"""The verb `export onnx`: networks for game engines."""

from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit.cli.export import wrote
from toolkit.cli.verbs import Published, TrainedRun
from toolkit.extra.engines import onnx as onnx_files
from toolkit.io import save as saving
from toolkit.training import published


def onnx(
    out: Annotated[Path, Option(help="File to write: .onnx; the style vectors go beside it.")],
    model: TrainedRun = None,
    parameters: Published = None,
) -> None:
    """Write the network (gating, experts) as ONNX and its style vectors as safetensors."""
    saving.check(out, (".onnx",))
    net, bank = published.either(model, parameters)
    wrote(*onnx_files.save(net, out, bank))
