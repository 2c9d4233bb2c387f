"""A model: gated experts, their gating, a style modulation, and the normalisers of physical units.

Synthesis networks and modulations are independent parts; `MODELS` are the combinations of the
paper's Table 2.
"""

import contextlib
import dataclasses
import functools
import json
import os
from collections.abc import Iterator
from dataclasses import dataclass

import torch
from torch import Tensor, nn

from toolkit.features import CLIP_FRAMES, KINDS, Layout, Normaliser
from toolkit.io import model_files
from toolkit.motion.tensors import as_tensor, summary
from toolkit.networks import phase
from toolkit.networks.adapters import OneHot, ResidualAdapter, StyleTable
from toolkit.networks.experts import CONTROL_POINTS, CatmullRom, Experts, Gating, VelocityGating
from toolkit.networks.film import Film, FilmGenerator

#: Synthesis network and style modulation of each model.
MODELS = {
    "pfnn-onehot": "four sets of weights on a global phase (Holden et al. 2017), style by a "
    "one-hot label",
    "lpn-onehot": "gated experts on local phases, style by a one-hot label",
    "pfnn-resad": "four sets of weights on a global phase, style by decomposed residual adapters "
    "(Mason et al. 2018)",
    "lpn-resad": "gated experts on local phases, style by full residual adapters",
    "pfnn-film": "four sets of weights on a global phase, style by FiLM",
    "mann-film": "gated experts on velocities of hands and feet, style by FiLM",
    "lpn-film": "gated experts on local phases, style by FiLM after layer normalisation (the "
    "paper's model)",
}
#: Phase representation of each synthesis network.
PHASE = {"lpn": "local", "pfnn": "global", "mann": "none"}


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
    dropout: float = 0.3  # share of inputs that training drops, everywhere

    def __post_init__(self):
        for name, value in dataclasses.asdict(self).items():
            if name != "dropout" and (not isinstance(value, int) or value < 1):
                raise ValueError(f"sizes: {name} must be a whole number from 1, got {value!r}")
        if not 0 <= self.dropout < 1:
            raise ValueError(f"sizes: dropout must be in [0, 1), got {self.dropout!r}")

    @classmethod
    def small(cls) -> "Sizes":
        """About 3 million parameters, for half a minute of training on two cores; few styles."""
        return cls(hidden=256, film_channels=32, film_kernel=9, film_dense=256, dropout=0.1)


@contextlib.contextmanager
def evaluating(network: nn.Module) -> Iterator[None]:
    """Inside, a network is in evaluation mode, without dropout, and no gradients are recorded."""
    changed = []
    if network.training:
        changed = [module for module in network.modules() if module.training]
    for module in changed:
        module.training = False
    try:
        with torch.no_grad():
            yield
    finally:
        for module in changed:
            module.training = True


class Model(nn.Module):
    """One of the seven models: ẑ = Φ(x; Ω(p), Ψ(y)) (equation 4), made by `build`.

    `predict`, `observe` and `style_vector` use physical units; `forward` and `encode`, for
    training, use normalised ones. `predict` and `style_vector` always run in evaluation mode,
    without dropout. The attribute `layout` has the columns of the model's own phase. A model with
    FiLM whose attribute `calibrated` is set predicts the mean over the dropout of its training.
    """

    calibrated = False
    life = 0.0  # how much the style wanders in `toolkit.runtime.rollout`, see `runtime.life.alive`
    lift = 1.0  # factor on the height of a toe in the air, in the pose that is fed back

    def __init__(self, name: str, layout: Layout, n_styles: int, sizes: Sizes,
                 normalisers: dict[str, Normaliser], generator: bool = True):
        super().__init__()
        synthesis, style = name.split("-")
        layout = dataclasses.replace(layout, phase=PHASE[synthesis])
        self.name, self.layout, self.n_styles, self.sizes = name, layout, n_styles, sizes
        n_in, n_out, s = layout.n_inputs, layout.n_outputs, sizes
        widths = dict(zip(KINDS, (n_in, layout.n_phases, n_out, layout.n_clip), strict=True))
        if not set(normalisers) <= set(KINDS):
            raise ValueError(f"normalisers are for {', '.join(KINDS)}; got "
                             f"{', '.join(normalisers)}")
        for kind, width in widths.items():
            given = normalisers.get(kind, Normaliser(torch.zeros(width), torch.ones(width)))
            if given.mean.shape != (width,) or given.std.shape != (width,):
                raise ValueError(
                    f"the normaliser of {kind} needs {width} columns, got {list(given.mean.shape)}"
                )
            like = torch.empty(0)  # device and dtype of the weights
            self.register_buffer(f"{kind}_mean", given.mean.to(like, copy=True))
            self.register_buffer(f"{kind}_std", given.std.to(like, copy=True))
        experts, rank = (CONTROL_POINTS, s.rank) if synthesis == "pfnn" else (s.experts, None)
        match synthesis:
            case "lpn":
                self.gating = Gating(layout.n_phases, s.gating, experts, s.dropout)
            case "mann":
                self.gating = VelocityGating(layout.limb_velocities, s.gating, experts, s.dropout)
            case "pfnn":
                self.gating = CatmullRom(experts)
        self.experts = Experts(experts, n_in, s.hidden, n_out, s.dropout)
        rows = n_styles if generator else 0
        match style:
            case "film":
                film = FilmGenerator(layout.n_clip, CLIP_FRAMES, s.hidden, s.film_channels,
                                     s.film_kernel, s.film_dense, s.dropout) if generator else None
                self.modulation = Film(s.hidden, film)
            case "onehot":
                self.modulation = OneHot(experts, s.hidden, rows)
            case "resad":
                self.modulation = ResidualAdapter(s.hidden, experts, rank, rows)

    def __repr__(self) -> str:
        return summary(self, {
            "name": self.name, "parameters": sum(p.numel() for p in self.parameters()),
            "hidden": self.sizes.hidden, "inputs": self.layout.n_inputs,
            "phases": self.layout.n_phases, "outputs": self.layout.n_outputs,
            "style_size": self.style_size, "generator": self.modulation.generator is not None,
        })  # fmt: skip

    def forward(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """Output frames ``[B, Dz]``; all normalised.

        ``x [B, Dx]``, ``phases [B, n_phases]``, ``style [B or 1, D]``.
        """
        gates = self.gating(phases, x)

        def modulate(layer: int, f: Tensor, inputs: Tensor) -> Tensor:
            if self.training or not self.calibrated:
                return self.modulation(layer, f, style, inputs, gates)
            scatter = self.experts.layers[layer].scatter(inputs, gates)
            return self.modulation.expected(layer, f, style, self.dropped * scatter)

        return self.experts(x, gates, modulate)

    @property
    def dropped(self) -> float:
        """Relative variance q / (1 − q) of an input of which training drops a share q."""
        return self.sizes.dropout / (1 - self.sizes.dropout)

    def encode(self, clips: Tensor | None, style: int | Tensor | None = None) -> Tensor:
        """Style vectors.

        Parameters
        ----------
        clips : Tensor [M, 240, 12 J]
            Normalised style clips, from which FiLM's generator computes vectors (equation 2).
        style
            The style's number, or numbers ``[M]``, which models with a table of styles look up.

        Returns
        -------
        Tensor [M, D]
            One per clip, or per number.

        Raises
        ------
        ValueError
            If the model has neither generator nor table, or the table does not have the style.
        """
        generator = self.modulation.generator
        if generator is None:
            source = "FiLM generator" if isinstance(self.modulation, Film) else "table of styles"
            raise ValueError(f"this model was stored without its {source}: it takes style "
                             "vectors, and cannot make any")
        return generator(style) if isinstance(generator, StyleTable) else generator(clips)

    def observe(self, phases: Tensor, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """Phases ``[B, 8]`` and output frames ``[B, Dz]`` of data in this model's columns.

        Local phases are unchanged. A model with a global phase gets an angle and its update (see
        `toolkit.networks.phase.global_phase`). Without phases these columns are left out.
        """
        return phase.observe(self.layout, phases, outputs)

    def predict(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """The next frame, in physical units, on the model's device and in its dtype.

        The model predicts in evaluation mode and without gradients. Arrays and lists are accepted.

        Parameters
        ----------
        x : Tensor [B, Dx]
            Input frames.
        phases : Tensor [B, n_phases]
            Phases in the model's form: 8 columns of local phases, one angle, or no column.
        style : Tensor [B, D] or [D]
            Style vectors, or one for all.

        Returns
        -------
        Tensor [B, Dz]
            Output frames.

        Raises
        ------
        ValueError
            If a number of columns is wrong.
        """
        x = self._columns(x, "x", self.layout.n_inputs)
        phases = self._columns(phases, "phases", self.layout.n_phases)
        style = self._columns(style, "style", self.style_size)
        with evaluating(self):
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
        if isinstance(self.modulation.generator, StyleTable):
            return self.encode(None, style)[0].detach()
        size = CLIP_FRAMES, self.layout.n_clip
        if clips.dim() != 3 or not len(clips) or clips.shape[1:] != size:
            raise ValueError(f"style clips are [M, {size[0]}, {size[1]}], got {list(clips.shape)}")
        vectors, normaliser = [], self.normaliser("clips")
        with evaluating(self):
            for part in clips.split(32):
                vectors.append(self.encode(normaliser.apply(part.to(self.clips_mean))))
        return torch.cat(vectors).mean(0)

    def normaliser(self, kind: str) -> Normaliser:
        """The normaliser of ``inputs``, ``phases``, ``outputs`` or ``clips``."""
        return Normaliser(getattr(self, f"{kind}_mean"), getattr(self, f"{kind}_std"))

    @property
    def style_size(self) -> int:
        """D, the length of a style vector."""
        return self.modulation.size

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:
        """Its tensors and description, as `toolkit.io.model_files` stores them."""
        generator = generator and self.modulation.generator is not None
        tensors = {}
        for name, value in self.state_dict().items():
            if generator or not name.startswith("modulation.generator."):
                tensors[f"model.{name}"] = value
        layout, sizes = json.loads(self.layout.to_json()), dataclasses.asdict(self.sizes)
        return tensors, {"name": self.name, "layout": layout, "n_styles": self.n_styles,
                         "sizes": sizes, "generator": generator, "calibrated": self.calibrated}

    def save(self, path: str | os.PathLike, *, generator: bool = True) -> None:
        """Write a safetensors file; with ``generator=False`` without Ψ or the table of styles."""
        tensors, description = self.parts(generator=generator)
        model_files.write(path, tensors, {"model": description})

    @classmethod
    def load(cls, path: str | os.PathLike, layout: Layout | None = None) -> "Model":
        """Read a model, of `save` or of a training run, ready to predict.

        Parameters
        ----------
        path
            The file.
        layout
            The expected layout of its training data.

        Raises
        ------
        ValueError
            If the file does not hold a model, or the model has another layout.
        """
        return cls.from_parts(path, *model_files.read(path, "model"), layout)

    @classmethod
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict,
                   layout: Layout | None) -> "Model":
        """The model among what `toolkit.io.model_files.read` returned for ``path``."""
        with model_files.intact(path, "the model's description"):
            d = parts["model"]
            name, sizes = d["name"], Sizes(**d["sizes"])
            stored = Layout.from_json(json.dumps(d["layout"]))
            calibrated = bool(d.get("calibrated", False))
            if name not in MODELS:
                raise ValueError(f"unknown model {name!r}")
            if calibrated and not name.endswith("film"):
                raise ValueError(f"only models with FiLM can be calibrated, got {name}")
            if not isinstance(d["n_styles"], int):
                raise ValueError(f"n_styles must be a whole number, got {d['n_styles']!r}")
        if layout is not None and stored != dataclasses.replace(layout, phase=stored.phase):
            described = ({"joints": own.names, "parents": own.parents,
                          "points": own.skeleton.names, "samples": own.samples}
                         for own in (layout, stored))
            raise ValueError(f"{path}: the layout differs in {model_files.difference(*described)}")
        with model_files.intact(path, "the model"):
            build = functools.partial(cls, name, stored, d["n_styles"], sizes, {}, d["generator"])
            model = model_files.restore(build, tensors, "model.")
        model.calibrated = calibrated
        return model
