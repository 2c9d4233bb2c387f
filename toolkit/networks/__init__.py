"""Networks of Mason et al. 2022: gated experts that synthesise motion, and what modulates them with style."""

from toolkit.features import Layout, Normaliser
from toolkit.networks.experts import BlendedLinear, Experts, Gating
from toolkit.networks.film import Film, FilmGenerator, layer_norm
from toolkit.networks.model import Model, Sizes

__all__ = ["MODELS", "BlendedLinear", "Experts", "Film", "FilmGenerator", "Gating", "Model", "Sizes", "build", "counts",
           "layer_norm"]  # fmt: skip

MODELS = {"lpn-film": "gated experts on local phases, style by FiLM after layer normalisation (the paper's model)"}


def build(name: str, layout: Layout, n_styles: int, sizes: Sizes | None = None,
          normalisers: dict[str, Normaliser] | None = None, *, generator: bool = True) -> Model:  # fmt: skip
    """A new model with random weights (from torch's global generator), set to predict.

    Parameters
    ----------
    name
        One of `MODELS`.
    layout
        Columns of x, p, z and y.
    n_styles
        Styles to learn.
    sizes
        The paper's where not given.
    normalisers
        Of ``inputs``, ``phases``, ``outputs``, ``clips``, as `toolkit.features.Features.normalisers` makes them; those not
        given change nothing.
    generator
        Whether it can make style vectors of clips; without, it needs them given.

    Raises
    ------
    ValueError
        If there is no model of that name.
    """
    if name not in MODELS:
        raise ValueError(f"unknown model {name!r}; there is {', '.join(MODELS)}")
    return Model(name, layout, n_styles, sizes or Sizes(), normalisers or {}, generator).eval()


def counts(model: Model) -> dict[str, int]:
    """Parameters as Table 2 counts them: ``synthesis`` (experts and gating), ``style`` and ``per_style`` at run time."""

    def total(*modules) -> int:
        return sum(p.numel() for m in modules for p in m.parameters())

    return {"synthesis": total(model.experts, model.gating), "style": total(model.modulation), "per_style": model.style_size}
