"""Networks of Mason et al. 2022: gated experts that synthesise motion, and style modulation."""

import dataclasses

from toolkit.features import Features, Layout, Normaliser
from toolkit.networks import bank, phase
from toolkit.networks.adapters import OneHot, ResidualAdapter, StyleTable
from toolkit.networks.experts import BlendedLinear, CatmullRom, Experts, Gating, VelocityGating
from toolkit.networks.film import Film, FilmGenerator, fold, layer_norm
from toolkit.networks.model import MODELS, PHASE, Model, Sizes
from toolkit.networks.parameter_counts import Row, counts, table2

__all__ = ["MODELS", "BlendedLinear", "CatmullRom", "Experts", "Film", "FilmGenerator", "Gating",
           "Model", "OneHot", "ResidualAdapter", "Row", "Sizes", "StyleTable", "VelocityGating",
           "bank", "build", "counts", "fold", "layer_norm", "normalisers", "table2"]


def build(name: str, layout: Layout, n_styles: int, sizes: Sizes | None = None,
          normalisers: dict[str, Normaliser] | None = None, *, generator: bool = True) -> Model:
    """A new model with random weights (from torch's global generator), in evaluation mode.

    Parameters
    ----------
    name
        One of `MODELS`.
    layout
        Columns of x, p, z and y in the data. `Model.layout` differs from it in the columns of the
        phase.
    n_styles
        Styles to learn.
    sizes
        By default those of the paper.
    normalisers
        Of ``inputs``, ``phases``, ``outputs``, ``clips``, as the function `normalisers` makes them.
        A missing normaliser is the identity.
    generator
        Whether the model has a FiLM generator or a style table. Without it the model cannot make
        style vectors.

    Raises
    ------
    ValueError
        If there is no model of that name.
    """
    _check(name)
    return Model(name, layout, n_styles, sizes or Sizes(), normalisers or {}, generator).eval()


def normalisers(name: str, data: Features) -> dict[str, Normaliser]:
    """Statistics of ``inputs``, ``phases``, ``outputs`` and ``clips`` in the columns of a model."""
    _check(name)
    layout = dataclasses.replace(data.layout, phase=PHASE[name.split("-")[0]])
    return phase.normalisers(layout, data)


def _check(name: str) -> None:
    if name not in MODELS:
        raise ValueError(f"unknown model {name!r}; known: {', '.join(MODELS)}")
