"""Training on one process, or on several processes or GPUs by Lightning Fabric: each takes its share of every minibatch.

The result equals that of one process, up to rounding. The frames of a minibatch are dealt out in turn. Each process encodes
the style clips of its own frames. Dropout masks are those of the whole minibatch. Gradients are averaged, weighted by the
number of frames.
"""

import contextlib
import functools
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import torch
import torch.nn.functional as F
from torch import Tensor, nn
from torch.overrides import TorchFunctionMode

from toolkit.networks import Model
from toolkit.training.loss import loss_terms
from toolkit.training.run import Config

if TYPE_CHECKING:
    from lightning_fabric import Fabric


def first() -> bool:
    """True on rank 0."""
    return int(os.environ.get("RANK") or os.environ.get("LOCAL_RANK") or 0) == 0


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


def start(config: Config) -> "Fabric | Alone":
    """Set up device and processes of a config.

    ValueError if there is no such device; ImportError if several processes need Lightning Fabric and it is not installed.
    With several processes, the first call starts the others: they run the same command from its beginning. Under
    ``torchrun``, which starts them itself, on one machine or many, this joins them.
    """
    return _start(config.device, config.processes)


@functools.cache
def _start(device: str, processes: int) -> "Fabric | Alone":
    kind, nodes = torch.device(device), 1
    if "TORCHELASTIC_RUN_ID" in os.environ:
        processes, nodes = (int(os.environ[name]) for name in ("LOCAL_WORLD_SIZE", "GROUP_WORLD_SIZE"))
    try:
        if processes * nodes == 1:
            torch.empty(0, device=kind)
            return Alone(kind)
        from lightning_fabric import Fabric

        fabric = Fabric(accelerator=kind.type, devices=processes, num_nodes=nodes, strategy="ddp")
    except ImportError:
        raise ImportError('several processes need the extra "scale": pip install ".[scale]"') from None
    except (AssertionError, RuntimeError, ValueError) as error:
        raise ValueError(f"{processes} × {device!r}: {str(error).splitlines()[0]}") from error
    fabric.launch()
    return fabric


class Objective(nn.Module):
    """Loss of equation 5 over the share of a minibatch that process ``rank`` has; ``precision`` as in `Config`."""

    def __init__(self, model: Model, bone_weight: float, rank: int = 0, processes: int = 1, precision: str = "32"):
        super().__init__()
        self.model, self.bone_weight, self.rank, self.processes = model, bone_weight, rank, processes
        self.precision = precision

    def forward(self, x: Tensor, p: Tensor, z: Tensor, y: Tensor, style: int) -> Tensor:
        """Loss, mean squared error and bone-length error ``[3]``; their means over the processes are those of the minibatch.

        The arguments are a whole normalised minibatch of one style: ``x [B, Dx]``, ``p [B, n_phases]``, ``z [B, Dz]``,
        ``y [M, 240, 12 J]`` and the style's number. Frame i uses clip i modulo M.
        """
        rows = torch.arange(self.rank, len(x), self.processes, device=x.device)
        clips, which = (rows % len(y)).unique(return_inverse=True)
        with torch.autocast(x.device.type, torch.bfloat16, enabled=self.precision == "bf16"):
            with self._dropout(clips, len(y)):
                styles = self.model.encode(y[clips], style)
            with self._dropout(rows, len(x)):
                predicted = self.model(x[rows], p[rows], styles if len(styles) == 1 else styles[which])
            mse, bone = loss_terms(self.model, predicted, z[rows])
        return torch.stack((mse + self.bone_weight * bone, mse, bone)) * (len(rows) * self.processes / len(x))

    def _dropout(self, rows: Tensor, whole: int) -> contextlib.AbstractContextManager:
        return contextlib.nullcontext() if self.processes == 1 else _Share(rows, whole)


class _Share(TorchFunctionMode):
    """Inside, dropout of some rows uses these rows of the dropout mask of the ``whole`` minibatch."""

    def __init__(self, rows: Tensor, whole: int):
        super().__init__()
        self.rows, self.whole = rows, whole

    def __torch_function__(self, func, types, args=(), kwargs=None):
        if func is F.dropout:
            some, *how = args
            return some * F.dropout(some.new_ones(self.whole, *some.shape[1:]), *how, **(kwargs or {}))[self.rows]
        return func(*args, **(kwargs or {}))
