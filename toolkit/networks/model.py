"""A model: gated experts, their gating, a style modulation, and the normalisers of physical units.

Synthesis networks and modulations are independent parts; `MODELS` are the combinations of the paper's Table 2.
"""

import contextlib
import dataclasses
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
    "pfnn-onehot": "four sets of weights on a global phase, style by a one-hot label (Holden et al. 2017)",
    "lpn-onehot": "gated experts on local phases, style by a one-hot label",
    "pfnn-resad": "four sets of weights on a global phase, style by decomposed residual adapters (Mason et al. 2018)",
    "lpn-resad": "gated experts on local phases, style by full residual adapters",
    "pfnn-film": "four sets of weights on a global phase, style by FiLM",
    "mann-film": "gated experts on velocities of hands and feet, style by FiLM",
    "lpn-film": "gated experts on local phases, style by FiLM after layer normalisation (the paper's model)",
}
PHASE = {"lpn": "local", "pfnn": "global", "mann": "none"}  # phase representation of each synthesis network


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
        """About 3 million parameters: half a minute of training on two cores, for fewer styles than the paper's sizes."""
        return cls(hidden=256, film_channels=32, film_kernel=9, film_dense=256, dropout=0.1)


@contextlib.contextmanager
def evaluating(network: nn.Module) -> Iterator[None]:
    """Puts a network in evaluation mode, without dropout, and records no gradients; restores the mode on exit."""
    changed = [module for module in network.modules() if module.training] if network.training else []
    for module in changed:
        module.training = False
    try:
        with torch.no_grad():
            yield
    finally:
        for module in changed:
            module.training = True


class Model(nn.Module):
    """One of the seven models: ẑ = Φ(x; Ω(p), Ψ(y)) (equation 4). Make one with `toolkit.networks.build`.

    `predict`, `observe` and `style_vector` use physical units; `forward` and `encode`, for training, use normalised ones.
    `predict` and `style_vector` always run in evaluation mode, without dropout. The attribute `layout` has the columns of
    the model's own phase; `calibrated` can be switched at any time.
    """

    def __init__(self, name: str, layout: Layout, n_styles: int, sizes: Sizes, normalisers: dict[str, Normaliser],
                 generator: bool = True, calibrated: bool = False):
        super().__init__()
        if calibrated and not name.endswith("film"):
            raise ValueError(f"only models with FiLM can be calibrated, got {name}")
        synthesis, style = name.split("-")
        layout = dataclasses.replace(layout, phase=PHASE[synthesis])
        self.name, self.layout, self.n_styles, self.sizes, self.calibrated = name, layout, n_styles, sizes, calibrated
        n_in, n_out, s = layout.n_inputs, layout.n_outputs, sizes
        widths = dict(zip(KINDS, (n_in, layout.n_phases, n_out, layout.n_clip), strict=True))
        if not set(normalisers) <= set(KINDS):
            raise ValueError(f"normalisers are for {', '.join(KINDS)}; got {', '.join(normalisers)}")
        for kind, width in widths.items():
            given = normalisers.get(kind, Normaliser(torch.zeros(width), torch.ones(width)))
            if given.mean.shape != (width,) or given.std.shape != (width,):
                raise ValueError(f"the normaliser of {kind} needs {width} columns, got {list(given.mean.shape)}")
            self.register_buffer(f"{kind}_mean", given.mean.to(torch.empty(0), copy=True))  # as the weights are
            self.register_buffer(f"{kind}_std", given.std.to(torch.empty(0), copy=True))
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
                film = (layout.n_clip, CLIP_FRAMES, s.hidden, s.film_channels, s.film_kernel, s.film_dense, s.dropout)
                self.modulation = Film(s.hidden, FilmGenerator(*film) if generator else None)
            case "onehot":
                self.modulation = OneHot(experts, s.hidden, rows)
            case "resad":
                self.modulation = ResidualAdapter(s.hidden, experts, rank, rows)

    def __repr__(self) -> str:
        return summary(self, {
            "name": self.name, "parameters": sum(p.numel() for p in self.parameters()), "hidden": self.sizes.hidden,
            "inputs": self.layout.n_inputs, "phases": self.layout.n_phases, "outputs": self.layout.n_outputs,
            "style_size": self.style_size, "generator": self.modulation.generator is not None,
        })  # fmt: skip

    def forward(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """Output frames ``[B, Dz]`` of ``x [B, Dx]``, ``phases [B, n_phases]`` and ``style [B or 1, D]``; all normalised."""
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
            raise ValueError(f"this model was stored without its {source}: it takes style vectors, and cannot make any")
        return generator(style) if isinstance(generator, StyleTable) else generator(clips)

    def observe(self, phases: Tensor, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """Convert phases ``[B, 8]`` and output frames ``[B, Dz]`` of data to this model's columns, in physical units.

        Local phases are unchanged. A model with a global phase gets an angle and its update (see
        `toolkit.networks.phase.global_phase`). For a model without phases these columns are left out.
        """
        return phase.observe(self.layout, phases, outputs)

    def predict(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """The next frame, in physical units, on the model's device and in its dtype; arrays and lists are accepted.

        The model always predicts in evaluation mode and without gradients.

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
        given, like = [], self.outputs_mean
        for what, value, width in (("x", x, self.layout.n_inputs), ("phases", phases, self.layout.n_phases),
                                   ("style", style, self.style_size)):
            given.append(as_tensor(value, what, like))
            if given[-1].shape[-1] != width:
                raise ValueError(f"{what} needs {width} columns, got shape {list(given[-1].shape)}")
        with evaluating(self):
            z = self(self.normaliser("inputs").apply(given[0]), self.normaliser("phases").apply(given[1]), given[2])
        return self.normaliser("outputs").invert(z)

    def style_vector(self, clips: Tensor, style: int | None = None) -> Tensor:
        """One style vector ``[D]``: the mean over clips ``[M, 240, 12 J]`` in physical units (section 4.4).

        Models with a table of styles use ``style``, the style's number, and not the clips.
        """
        if isinstance(self.modulation.generator, StyleTable):
            return self.encode(None, style)[0].detach()
        if clips.dim() != 3 or not len(clips) or clips.shape[1:] != (CLIP_FRAMES, self.layout.n_clip):
            raise ValueError(f"style clips are [M, {CLIP_FRAMES}, {self.layout.n_clip}], got {list(clips.shape)}")
        normaliser = self.normaliser("clips")
        with evaluating(self):
            return torch.cat([self.encode(normaliser.apply(part.to(self.clips_mean))) for part in clips.split(32)]).mean(0)

    def normaliser(self, kind: str) -> Normaliser:
        """The normaliser of ``inputs``, ``phases``, ``outputs`` or ``clips``."""
        return Normaliser(getattr(self, f"{kind}_mean"), getattr(self, f"{kind}_std"))

    @property
    def style_size(self) -> int:
        """D, the length of a style vector."""
        return self.modulation.size

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:
        """Its tensors and description, as `toolkit.io.model_files` stores them; generator or table only if asked for."""
        generator = generator and self.modulation.generator is not None
        tensors = {k: v for k, v in self.state_dict().items() if generator or not k.startswith("modulation.generator.")}
        description = {
            "name": self.name, "layout": json.loads(self.layout.to_json()), "n_styles": self.n_styles,
            "sizes": dataclasses.asdict(self.sizes), "generator": generator, "calibrated": self.calibrated,
        }
        return {f"model.{k}": v for k, v in tensors.items()}, description

    def save(self, path: str | os.PathLike, *, generator: bool = True) -> None:
        """Write weights, layout, sizes and normalisers to a safetensors file; ``generator=False``: without Ψ or table."""
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
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict, layout: Layout | None) -> "Model":
        """The model among what `toolkit.io.model_files.read` returned for ``path``."""
        with model_files.intact(path, "the model's description"):
            d = parts["model"]
            name, stored, sizes = d["name"], Layout.from_json(json.dumps(d["layout"])), Sizes(**d["sizes"])
            if name not in MODELS:
                raise ValueError(f"unknown model {name!r}")
            if not isinstance(d["n_styles"], int):
                raise ValueError(f"n_styles must be a whole number, got {d['n_styles']!r}")
        if layout is not None and stored != dataclasses.replace(layout, phase=stored.phase):
            described = (
                {"joints": own.names, "parents": own.parents, "points": own.skeleton.names, "samples": own.samples}
                for own in (layout, stored)
            )
            raise ValueError(f"{path}: the layout differs in {model_files.difference(*described)}")
        with model_files.intact(path, "the model"):
            generator, calibrated = d["generator"], d.get("calibrated", False)
            return model_files.restore(lambda: cls(name, stored, d["n_styles"], sizes, {}, generator, calibrated), tensors,
                                       "model.")
