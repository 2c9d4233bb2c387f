"""What every model of the next frame has: units, style vectors, files; base of models of your own.

`docs/adding_a_model.md` shows how a model of your own is written, registered and trained.
"""

import contextlib
import hashlib
import json
import os
import sys
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn

from toolkit import registry
from toolkit.features import CLIP_FRAMES, KINDS, Layout, Normaliser
from toolkit.io import model_files
from toolkit.motion.tensors import as_tensor
from toolkit.networks import phase

STYLES = 100_000  # most styles of a model
FACTORS = "life", "lift", "ground"  # settings of the runtime that a file keeps


@dataclass(frozen=True)
class Sizes:
    """How large the networks are; the defaults are the paper's (section 4.3)."""

    hidden: int = 512  # units of both hidden layers of the synthesis network
    experts: int = 8  # K; the PFNN has four control points instead
    gating: int = 32  # units of both hidden layers of the gating network
    film_channels: int = 256  # filters of both convolutions of the FiLM generator
    film_kernel: int = 25  # their width, frames
    film_dense: int = 2048  # units of its first dense layer
    rank: int = 30  # of the PFNN's residual adapters
    # share of a layer's inputs that training drops; of the FiLM generator, only in its last layer
    dropout: float = 0.3

    def __post_init__(self):
        for name, value in asdict(self).items():
            if name != "dropout" and (type(value) is not int or value < 1):
                raise ValueError(f"sizes: {name} must be a whole number from 1, got {value!r}")
        if not 0 <= self.dropout < 1:
            raise ValueError(f"sizes: dropout must be in [0, 1), got {self.dropout!r}")

    @classmethod
    def small(cls) -> "Sizes":
        """About 3 million parameters, for half a minute of training on two cores; few styles."""
        return cls(hidden=256, film_channels=32, film_kernel=9, film_dense=256, dropout=0.1)


@contextlib.contextmanager
def evaluating(network: nn.Module, gradients: bool = False) -> Iterator[None]:
    """Inside, a network is in evaluation mode, without dropout; gradients only if asked for."""
    changed = [m for m in network.modules() if m.training] if network.training else []
    for module in changed:
        module.training = False
    try:
        with torch.set_grad_enabled(gradients):
            yield
    finally:
        for module in changed:
            module.training = True


class Predictor(nn.Module):
    """A model of the next frame: ẑ = f(x, p, style).

    `Model` has the seven models of the paper. A subclass of your own has ``__init__(layout,
    n_styles, sizes)``, see `build`, which sets `style_size`, and the methods `forward` and
    `encode`. These two, and ``loss``, use normalised values; `predict`, `observe` and
    `style_vector` use physical units. The attribute `layout` has the model's own phase.

    A subclass may have a method ``loss(x, phases, z, style)``, which returns what training
    minimises (a scalar). Without it that is the error of `forward`, with the bone-length loss of
    equation 5.
    """

    #: ``"local"``, ``"global"`` or ``"none"``, see `Layout`; None: that of the given layout
    phase: str | None = None
    #: K past input frames that the model sees beside the present one; x is then ``[B, K + 1, Dx]``
    memory = 0
    style_size: int  # D, the length of a style vector
    name = ""  # under which it is registered
    life = 0.0  # how much the style wanders in `toolkit.runtime.rollout`, see `runtime.life.alive`
    lift = 1.0  # factor on the height of a toe in the air, in the pose that is fed back
    ground = 0.02  # height of a standing toe, metres

    def __init__(self, layout: Layout, n_styles: int, sizes: Sizes):
        super().__init__()
        if type(n_styles) is not int or not 1 <= n_styles <= STYLES:
            raise ValueError(f"a model has 1 to {STYLES} styles, got {n_styles!r:.60}")
        own = layout.phase if self.phase is None else self.phase
        self.layout = layout = replace(layout, phase=own)
        self.n_styles, self.sizes = n_styles, sizes
        widths = layout.n_inputs, layout.n_phases, layout.n_outputs, layout.n_clip
        for kind, width in zip(KINDS, widths, strict=True):
            self.register_buffer(f"{kind}_mean", torch.zeros(width))
            self.register_buffer(f"{kind}_std", torch.ones(width))

    def forward(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """Output frames ``[B, Dz]``; all normalised.

        ``x [B, Dx]``, or ``[B, K + 1, Dx]`` with a `memory` of K frames, the present one last;
        ``phases [B, n_phases]``, ``style [B or 1, D]``.
        """
        raise NotImplementedError

    def encode(self, clips: Tensor | None, style: int | Tensor | None = None) -> Tensor:
        """Style vectors ``[M, D]`` of clips ``[M, 240, 12 J]``, or ``[1, D]`` of a style's number.

        The clips are normalised. A model uses the one or the other.
        """
        raise NotImplementedError

    @property
    def generator(self) -> nn.Module | None:
        """The part that makes style vectors, if `fine_tune` and slim files are to know it."""
        return None

    def style_parameters(self) -> list[nn.Parameter]:
        """The parameters that have a learning rate of their own, `Config.style_rate`."""
        return []

    def observe(self, phases: Tensor, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """Phases ``[B, 8]`` and output frames ``[B, Dz]`` of data in this model's columns.

        Local phases are unchanged. A model with a global phase gets an angle and its update (see
        `toolkit.networks.phase.global_phase`). Without phases these columns are left out.
        """
        return phase.observe(self.layout, phases, outputs)

    def predict(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """The next frames ``[B, Dz]``, in physical units, on the model's device and in its dtype.

        The model predicts in evaluation mode. Gradients are recorded if an argument requires them.
        Arrays and lists are accepted. ValueError if a number of columns is wrong.

        Parameters
        ----------
        x : Tensor [B, Dx]
            Input frames; or ``[B, K + 1, Dx]`` for a model with a `memory`. If it gets ``[B, Dx]``,
            it remembers this frame only.
        phases : Tensor [B, n_phases]
            Phases in the model's form: 8 columns of local phases, one angle, or no column.
        style : Tensor [B, D] or [D]
            Style vectors, or one for all.
        """
        x = self._columns(x, "x", self.layout.n_inputs)
        phases = self._columns(phases, "phases", self.layout.n_phases)
        style = torch.atleast_2d(self._columns(style, "style", self.style_size))
        if self.memory and x.dim() == 2:
            x = x[:, None].expand(-1, self.memory + 1, -1)
        asked = torch.is_grad_enabled() and any(v.requires_grad for v in (x, phases, style))
        with evaluating(self, asked):
            x = self.normaliser("inputs").apply(x)
            z = self(x, self.normaliser("phases").apply(phases), style)
        return self.normaliser("outputs").invert(z)

    def _columns(self, value, what: str, width: int) -> Tensor:
        """A value as a tensor like the model's, with so many columns."""
        value = as_tensor(value, what, self.outputs_mean)
        if value.shape[-1] != width:
            raise ValueError(f"{what} needs {width} columns, got shape {list(value.shape)}")
        return value

    def style_vector(self, clips: Tensor, style: int | None = None) -> Tensor:
        """One style vector ``[D]``: the mean over clips ``[M, 240, 12 J]`` (section 4.4).

        Models with a table of styles use ``style``, the style's number, and not the clips.
        """
        size = CLIP_FRAMES, self.layout.n_clip
        if clips.dim() != 3 or not len(clips) or clips.shape[1:] != size:
            raise ValueError(f"style clips are [M, {size[0]}, {size[1]}], got {list(clips.shape)}")
        vectors, normaliser = [], self.normaliser("clips")
        with evaluating(self):
            for part in clips.split(32):
                vectors.append(self.encode(normaliser.apply(part), style))
        return torch.cat(vectors).mean(0).detach()

    def normaliser(self, kind: str) -> Normaliser:
        """The normaliser of ``inputs``, ``phases``, ``outputs`` or ``clips``."""
        return Normaliser(getattr(self, f"{kind}_mean"), getattr(self, f"{kind}_std"))

    def normalise(self, normalisers: dict[str, Normaliser]) -> None:
        """Set normalisers; a ValueError if one is unknown, or has not as many columns."""
        if not set(normalisers) <= set(KINDS):
            raise ValueError(f"normalisers are for {', '.join(KINDS)}; got "
                             f"{', '.join(normalisers)}")
        for kind, given in normalisers.items():
            own = self.normaliser(kind)
            for mine, other in ((own.mean, given.mean), (own.std, given.std)):
                if other.shape != mine.shape:
                    raise ValueError(f"the normaliser of {kind} needs {len(mine)} columns, got "
                                     f"{list(other.shape)}")
                mine.copy_(other)

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:
        """Its tensors and description, as `toolkit.io.model_files` stores them.

        ``generator=False`` leaves out what makes style vectors, if it is one of the seven models.
        """
        tensors = {f"model.{name}": value for name, value in self.state_dict().items()}
        layout, sizes = self.layout.to_json(), asdict(self.sizes)
        part = registry.find(f"model.{self.name}")
        factors = {name: getattr(self, name) for name in FACTORS
                   if getattr(self, name) != getattr(type(self), name)}
        return tensors, {"name": self.name, "layout": layout, "n_styles": self.n_styles,
                         "sizes": sizes, "module": getattr(part, "func", part).__module__,
                         **factors}

    def fingerprint(self, *vectors: Tensor) -> bytes:
        """A hash of all numbers on which walks in style vectors ``[..., D]`` depend."""
        numbers = *self.state_dict().values(), *vectors
        factors = [getattr(self, name) for name in FACTORS]
        known = hashlib.sha256(json.dumps([repr(self), self.layout.to_json(), factors]).encode())
        for values in numbers:
            known.update(f"{values.device}".encode() + values.cpu().numpy().tobytes())
        return known.digest()

    @classmethod
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor],
                   parts: dict) -> "Predictor":
        """The model among what `toolkit.io.model_files.read` returned for ``path``.

        It is ready to predict. No code of the file is run: a model of your own must have been
        registered before, and the file has the name of the module that does it. ValueError if the
        file does not hold a model, or no model of its name is registered.
        """
        with model_files.intact(path, "the model's description"):
            d = parts["model"]
            name, sizes = str(d["name"]), Sizes(**d["sizes"])
            stored = Layout.from_json(d["layout"])
            calibrated, whole = bool(d.get("calibrated", False)), bool(d.get("generator", True))
            factors = {factor: float(d[factor]) for factor in FACTORS if factor in d}
            if not all(-2 * (factor == "ground") <= value <= 2
                       for factor, value in factors.items()):
                raise ValueError(f"{', '.join(FACTORS)} must be from 0 to 2, ground from -2")
        if name not in registry.names("model"):
            module = str(d.get("module", "unknown"))
            raise ValueError(f"{path}: it holds a model {name!r}, which is not registered; import "
                             f"the module that registers it, {module!r}, before you load the file; "
                             f"in a command, name it before the file: {module}:{path}")
        with model_files.intact(path, "the model"):
            model = model_files.restore(
                lambda: build(name, stored, d["n_styles"], sizes, generator=whole), tensors,
                "model.")
        if calibrated and name.endswith("film"):
            model.calibrated = True
        for factor, value in factors.items():
            setattr(model, factor, value)
        return model


def register(name: str) -> Callable[[Any], Any]:
    """A decorator that gives a model of your own a name, for `build`, `Config.model` and files.

    It decorates a subclass of `Predictor`, or a function of ``(layout, n_styles, sizes)`` that
    returns a model.
    """
    def registered(part: Any) -> Any:
        registry.register(f"model.{name}", part)
        return part

    return registered


def imported(given: str) -> str:
    """What stands after the last colon of ``MODULE:NAME``, once that module was imported.

    The module may be a Python file. Modules are looked up in the current folder, too. Without a
    colon, or for a file with one in its name, nothing is imported. ValueError if there is no such
    file, or a module of its name was imported from elsewhere.
    """
    place, _, name = given.rpartition(":")
    if len(place) < 2 or Path(given).exists():  # C:\\ is a drive; a file may have a colon
        return given
    folder, module = os.path.split(os.path.abspath(place))
    file = Path(folder, module).resolve() if module.endswith(".py") else None
    if file and not file.is_file():
        raise ValueError(f"{given}: there is no file {place}")
    if folder not in sys.path:
        sys.path.insert(0, folder)
    found = import_module(module.removesuffix(".py"))
    if file and Path(found.__file__ or "").resolve() != file:
        raise ValueError(f"{given}: a module {found.__name__} is there already, "
                         f"{found.__file__}; give your file another name")
    return name


def build(name: str, layout: Layout, n_styles: int, sizes: Sizes | None = None,
          normalisers: dict[str, Normaliser] | None = None, *, generator: bool = True) -> Predictor:
    """A new model with random weights (from torch's global generator), in evaluation mode.

    Parameters
    ----------
    name
        One of `toolkit.networks.MODELS`, or the name of a model of your own, see `register`;
        ValueError for another.
    layout, n_styles
        Columns of x, p, z and y in the data, and the number of styles to learn.
    sizes
        By default those of the paper.
    normalisers
        As `toolkit.networks.normalisers` makes them. A missing one is the identity.
    generator
        Whether one of the seven models has its FiLM generator or style table. Without it the model
        cannot make style vectors.
    """
    options = {} if generator else {"generator": False}
    model = registry.find(f"model.{name}")(layout, n_styles, sizes or Sizes(), **options)
    model.name = name
    model.normalise(normalisers or {})
    return model.eval()
