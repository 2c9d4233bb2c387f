"""A model: gated experts, their gating, a style modulation, and the normalisers of physical units.

Synthesis networks and modulations are independent parts; `MODELS` are the combinations of the
paper's Table 2.
"""

import functools

from torch import Tensor, nn

from toolkit import registry
from toolkit.features import CLIP_FRAMES, Layout
from toolkit.motion.tensors import summary
from toolkit.networks.adapters import OneHot, ResidualAdapter, StyleTable
from toolkit.networks.experts import CONTROL_POINTS, CatmullRom, Experts, Gating, VelocityGating
from toolkit.networks.film import Film, FilmGenerator
from toolkit.networks.predictor import Predictor, Sizes

#: Synthesis network and style modulation of each model: "pfnn", four sets of weights on a global
#: phase (Holden et al. 2017), "lpn" and "mann", gated experts on local phases, or on velocities of
#: hands and feet; "onehot", a one-hot label, "resad", residual adapters (Mason et al. 2018), in the
#: PFNN decomposed, "film", FiLM after layer normalisation. The last one is the paper's model.
MODELS = ("pfnn-onehot", "lpn-onehot", "pfnn-resad", "lpn-resad", "pfnn-film", "mann-film",
          "lpn-film")
#: Phase representation of each synthesis network.
PHASE = {"lpn": "local", "pfnn": "global", "mann": "none"}


class Model(Predictor):
    """One of the seven models: ẑ = Φ(x; Ω(p), Ψ(y)) (equation 4), made by `build`.

    A model with FiLM whose attribute `calibrated` is set predicts the mean over the dropout of its
    training. Without ``generator`` it has no FiLM generator or table of styles: it takes style
    vectors, and cannot make any.
    """

    calibrated = False

    def __init__(self, name: str, layout: Layout, n_styles: int, sizes: Sizes,
                 generator: bool = True):
        synthesis, style = name.split("-")
        self.phase = PHASE[synthesis]
        super().__init__(layout, n_styles, sizes)
        self.name, layout, s = name, self.layout, sizes
        experts, rank = (CONTROL_POINTS, s.rank) if synthesis == "pfnn" else (s.experts, None)
        match synthesis:
            case "lpn":
                self.gating = Gating(layout.n_phases, s.gating, experts, s.dropout)
            case "mann":
                self.gating = VelocityGating(layout.limb_velocities, s.gating, experts, s.dropout)
            case "pfnn":
                self.gating = CatmullRom()
        self.experts = Experts(experts, layout.n_inputs, s.hidden, layout.n_outputs, s.dropout)
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
            "style_size": self.style_size, "generator": self.generator is not None})

    def forward(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:  # noqa: D102
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
        """Style vectors ``[M, D]``: of clips by FiLM's generator (equation 2), or of numbers.

        ValueError if the model has neither, or the table does not have the style.
        """
        if self.generator is None:
            source = "FiLM generator" if isinstance(self.modulation, Film) else "table of styles"
            raise ValueError(f"this model was stored without its {source}: it takes style "
                             "vectors, and cannot make any")
        return self.generator(style if isinstance(self.generator, StyleTable) else clips)

    def style_vector(self, clips: Tensor, style: int | None = None) -> Tensor:  # noqa: D102
        if isinstance(self.generator, StyleTable):
            return self.encode(None, style)[0].detach()
        return super().style_vector(clips, style)

    @property
    def generator(self) -> nn.Module | None:
        """FiLM's generator or the table of styles; None if it was left out."""
        return self.modulation.generator

    @property
    def style_size(self) -> int:  # type: ignore[override]  # it follows `modulation`
        """D, the length of a style vector."""
        return self.modulation.size

    def style_parameters(self) -> list[nn.Parameter]:
        """Those of the style modulation."""
        return list(self.modulation.parameters())

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:  # noqa: D102
        tensors, description = super().parts()
        whole = self.generator is not None and (generator or self.name not in MODELS)
        if not whole:
            tensors = {name: value for name, value in tensors.items()
                       if not name.startswith("model.modulation.generator.")}
        return tensors, description | {"generator": whole, "calibrated": self.calibrated}


for _name in MODELS:
    registry.register(f"model.{_name}", functools.partial(Model, _name))
