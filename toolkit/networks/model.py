"""A model: gated experts, their gating, a style modulation, and the normalisers between physical units and its own."""

import dataclasses
import json
import os
from dataclasses import dataclass

import torch
from torch import Tensor, nn

from toolkit.features import CLIP_FRAMES, Layout, Normaliser
from toolkit.networks import weights
from toolkit.networks.experts import Experts, Gating
from toolkit.networks.film import Film, FilmGenerator

KINDS = ("inputs", "phases", "outputs", "clips")  # what is normalised


@dataclass(frozen=True)
class Sizes:
    """How large the networks are; the defaults are the paper's (section 4.3)."""

    hidden: int = 512  # units of both hidden layers of the synthesis network
    experts: int = 8  # K
    gating: int = 32  # units of both hidden layers of the gating network
    film_channels: int = 256  # filters of both convolutions of the FiLM generator
    film_kernel: int = 25  # their width, frames
    film_dense: int = 2048  # units of its first dense layer
    dropout: float = 0.3  # share of inputs that training drops, everywhere

    def __post_init__(self):
        for name, value in dataclasses.asdict(self).items():
            if name != "dropout" and (not isinstance(value, int) or value < 1):
                raise ValueError(f"sizes: {name} must be a whole number from 1, got {value!r}")
        if not 0 <= self.dropout < 1:
            raise ValueError(f"sizes: dropout must be in [0, 1), got {self.dropout!r}")

    @classmethod
    def small(cls) -> "Sizes":
        """About 3 million parameters: half a minute of training on two cores, and not for as many styles as the paper's."""
        return cls(hidden=256, film_channels=32, film_kernel=9, film_dense=256, dropout=0.1)


class Model(nn.Module):
    """LPN-FiLM (equation 4): ẑ = Φ(x; Ω(p), Ψ(y)). Make one with `toolkit.networks.build`.

    `predict` and `style_vector` speak physical units; `forward` and `encode`, for training, normalised ones.

    Parameters
    ----------
    name
        Which model of `toolkit.networks.MODELS`.
    layout
        Columns of x, p, z and y.
    n_styles
        Styles it is meant for. FiLM needs no number of its own for them; models with per-style weights do.
    sizes
        Its sizes.
    normalisers
        For each of ``inputs``, ``phases``, ``outputs``, ``clips``; those not given change nothing.
    generator
        Whether it can make style vectors of clips. Without, 9 in 10 of the paper's parameters are saved.
    """

    def __init__(self, name: str, layout: Layout, n_styles: int, sizes: Sizes, normalisers: dict[str, Normaliser],
                 generator: bool = True):  # fmt: skip
        super().__init__()
        self.name, self.layout, self.n_styles, self.sizes = name, layout, n_styles, sizes
        n_in, n_out, s = layout.n_inputs, layout.n_outputs, sizes
        widths = dict(zip(KINDS, (n_in, layout.n_phases, n_out, layout.n_clip), strict=True))
        if not set(normalisers) <= set(KINDS):
            raise ValueError(f"normalisers are for {', '.join(KINDS)}; got {', '.join(normalisers)}")
        for kind, width in widths.items():
            given = normalisers.get(kind, Normaliser(torch.zeros(width), torch.ones(width)))
            if given.mean.shape != (width,) or given.std.shape != (width,):
                raise ValueError(f"the normaliser of {kind} needs {width} columns, got {list(given.mean.shape)}")
            self.register_buffer(f"{kind}_mean", given.mean.clone())
            self.register_buffer(f"{kind}_std", given.std.clone())
        self.gating = Gating(layout.n_phases, s.gating, s.experts, s.dropout)
        self.experts = Experts(s.experts, n_in, s.hidden, n_out, s.dropout)
        psi = FilmGenerator(layout.n_clip, CLIP_FRAMES, s.hidden, s.film_channels, s.film_kernel, s.film_dense, s.dropout)
        self.modulation = Film(s.hidden, psi if generator else None)

    def forward(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """Normalised output frames ``[B, Dz]`` of normalised ``x [B, Dx]``, ``phases [B, 8]``; ``style`` ``[B or 1, D]``."""
        return self.experts(x, self.gating(phases), lambda layer, f: self.modulation(layer, f, style))

    def encode(self, clips: Tensor) -> Tensor:
        """Style vectors ``[M, D]`` of normalised ``clips [M, 240, 12 J]`` (equation 2)."""
        if self.modulation.generator is None:
            raise ValueError("this model was stored without its FiLM generator: it takes style vectors, and cannot make any")
        return self.modulation.generator(clips)

    @torch.no_grad()
    def predict(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """The next frame, in physical units.

        Parameters
        ----------
        x : Tensor [B, Dx]
            Input frames.
        phases : Tensor [B, 8]
            Local phases.
        style : Tensor [B, D] or [D]
            Style vectors, or one for all.

        Returns
        -------
        Tensor [B, Dz]
            Output frames.

        Raises
        ------
        ValueError
            If a width is another.
        """
        for what, value, width in (("x", x, self.layout.n_inputs), ("phases", phases, self.layout.n_phases),
                                   ("style", style, self.style_size)):  # fmt: skip
            if value.shape[-1] != width:
                raise ValueError(f"{what} needs {width} columns, got shape {list(value.shape)}")
        z = self(self.normaliser("inputs").apply(x), self.normaliser("phases").apply(phases), style)
        return self.normaliser("outputs").invert(z)

    @torch.no_grad()
    def style_vector(self, clips: Tensor) -> Tensor:
        """One style vector ``[D]``: the mean over clips ``[M, 240, 12 J]`` in physical units (section 4.4)."""
        if clips.dim() != 3 or not len(clips) or clips.shape[1:] != (CLIP_FRAMES, self.layout.n_clip):
            raise ValueError(f"style clips are [M, {CLIP_FRAMES}, {self.layout.n_clip}], got {list(clips.shape)}")
        normaliser, device = self.normaliser("clips"), self.clips_mean.device
        return torch.cat([self.encode(normaliser.apply(part.to(device))) for part in clips.split(32)]).mean(0)

    def normaliser(self, kind: str) -> Normaliser:
        """The normaliser of ``inputs``, ``phases``, ``outputs`` or ``clips``."""
        return Normaliser(getattr(self, f"{kind}_mean"), getattr(self, f"{kind}_std"))

    @property
    def style_size(self) -> int:
        """D, the length of a style vector."""
        return self.modulation.size

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:
        """Its tensors and its description, as `toolkit.networks.weights` stores them; the generator only if asked for."""
        generator = generator and self.modulation.generator is not None
        tensors = {k: v for k, v in self.state_dict().items() if generator or not k.startswith("modulation.generator.")}
        description = {
            "name": self.name, "layout": json.loads(self.layout.to_json()), "n_styles": self.n_styles,
            "sizes": dataclasses.asdict(self.sizes), "generator": generator,
        }  # fmt: skip
        return {f"model.{k}": v for k, v in tensors.items()}, description

    def save(self, path: str | os.PathLike, *, generator: bool = True) -> None:
        """Write weights, layout, sizes and normalisers to one safetensors file; ``generator=False`` leaves Ψ out."""
        tensors, description = self.parts(generator=generator)
        weights.write(path, tensors, {"model": description})

    @classmethod
    def load(cls, path: str | os.PathLike, layout: Layout | None = None) -> "Model":
        """Read a model, of `save` or of a training run, ready to predict.

        Parameters
        ----------
        path
            The file.
        layout
            The layout it must have.

        Raises
        ------
        ValueError
            If the file is no model's or the model's layout is another.
        """
        return cls.from_parts(path, *weights.read(path, "model"), layout)

    @classmethod
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict, layout: Layout | None) -> "Model":
        """The model among what `toolkit.networks.weights.read` returned for ``path``."""
        from toolkit.networks import MODELS

        try:
            d = parts["model"]
            name, stored, sizes = d["name"], Layout.from_json(json.dumps(d["layout"])), Sizes(**d["sizes"])
            if name not in MODELS:
                raise ValueError(f"unknown model {name!r}")
            if layout is not None and stored != layout:
                described = (
                    {"joints": own.names, "parents": own.parents, "points": own.skeleton.names} for own in (layout, stored)
                )
                raise ValueError(f"the layout differs in {weights.difference(*described)}")
            with torch.device("meta"):  # no memory, no random numbers: the file has them all
                model = cls(name, stored, d["n_styles"], sizes, {}, d["generator"])
        except (KeyError, TypeError, ValueError) as error:
            raise ValueError(f"{path}: {error}") from error
        own = {k.removeprefix("model."): v.float() for k, v in tensors.items() if k.startswith("model.")}
        shapes = {k: list(v.shape) for k, v in model.state_dict().items()}
        if why := weights.difference(shapes, {k: list(v.shape) for k, v in own.items()}):
            raise ValueError(f"{path}: the model differs in tensor {why}")
        model.load_state_dict(own, assign=True)
        return model.eval()
