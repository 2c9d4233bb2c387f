"""Training on one process, or on several processes or GPUs by Lightning Fabric.

With several, each takes its share of every minibatch: the frames are dealt out in turn, and each
process encodes the style clips of its own frames. Gradients are averaged, weighted by the number of
frames. Without dropout the result is that of one process, up to rounding; with dropout each process
draws masks of its own, so the result is equal in distribution.
"""

import functools
import os
from dataclasses import dataclass
from typing import Any, ClassVar

import torch
from torch import Tensor, distributed, nn

from toolkit.networks import Predictor
from toolkit.training.loss import loss_terms


def first() -> bool:
    """True in the process that talks and writes files: the only one, or rank 0 of several."""
    running = distributed.is_available() and distributed.is_initialized()
    return not running or distributed.get_rank() == 0


@dataclass(frozen=True)
class Alone:
    """One process: the methods of a `Fabric` that training uses, without Lightning Fabric."""

    device: torch.device
    world_size: ClassVar[int] = 1
    global_rank: ClassVar[int] = 0

    def setup_module(self, module: nn.Module) -> nn.Module:
        """The module on the device."""
        return module.to(self.device)

    def backward(self, loss: Tensor) -> None:
        """Compute gradients."""
        loss.backward()


@functools.cache
def start(device: str, processes: int) -> Any:
    """Set up a device and processes: `Alone`, or a Lightning Fabric of several.

    With several processes, the first call starts the others: they run the same command from its
    beginning. Under ``torchrun``, which starts them itself, this joins them. ValueError if there is
    no such device, ImportError if several processes need Lightning Fabric and it is not installed.
    """
    nodes = 1
    if "TORCHELASTIC_RUN_ID" in os.environ:  # torchrun
        processes, nodes = int(os.environ["LOCAL_WORLD_SIZE"]), int(os.environ["GROUP_WORLD_SIZE"])
    try:
        kind = torch.device(device)
        if processes * nodes == 1:
            torch.empty(0, device=kind)
            return Alone(kind)
        from lightning_fabric import Fabric

        fabric = Fabric(accelerator=kind.type, devices=processes, num_nodes=nodes, strategy="ddp")
    except ImportError:
        raise ImportError(
            'several processes need the extra "scale": pip install ".[scale]"'
        ) from None
    except (AssertionError, RuntimeError, ValueError) as error:
        reason = str(error).splitlines()[0]
        raise ValueError(f"{processes} × {device!r}: {reason}") from error
    fabric.launch()
    return fabric


class Objective(nn.Module):
    """Loss of equation 5, or the model's own, over the share of a minibatch of process ``rank``."""

    def __init__(self, model: Predictor, rank: int = 0, processes: int = 1,
                 precision: str = "32"):
        super().__init__()
        self.model, self.rank, self.processes = model, rank, processes
        self.precision = precision

    def forward(self, x: Tensor, p: Tensor, z: Tensor, y: Tensor, style: int) -> Tensor:
        """Loss, mean squared error and bone-length error ``[3]``.

        Their means over the processes are those of the minibatch. The arguments are a whole
        normalised minibatch of one style: ``x [B, Dx]``, ``p [B, n_phases]``, ``z [B, Dz]``,
        ``y [M, 240, 12 J]`` and the style's number. Frame i uses clip i modulo M. A model's own
        loss stands in the place of the mean squared error, without a bone-length error.
        """
        rows = torch.arange(self.rank, len(x), self.processes, device=x.device)
        clips, which = (rows % len(y)).unique(return_inverse=True)
        with torch.autocast(x.device.type, torch.bfloat16, enabled=self.precision == "bf16"):
            styles = self.model.encode(y[clips], style)
            styles = styles if len(styles) == 1 else styles[which]
            if own := getattr(self.model, "loss", None):
                mse = own(x[rows], p[rows], z[rows], styles)
                bone = torch.zeros_like(mse)
            else:
                predicted = self.model(x[rows], p[rows], styles)
                mse, bone = loss_terms(self.model, predicted, z[rows])
        # shares differ in length by one frame; Fabric averages over processes
        weight = len(rows) * self.processes / len(x)
        return weight * torch.stack((mse + bone, mse, bone))
