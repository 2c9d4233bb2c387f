"""Networks of Mason et al. 2022: gated experts that synthesise motion, and style modulation."""

import torch

from toolkit.features import Features, Layout, Normaliser
from toolkit.networks import bank, phase
from toolkit.networks.adapters import OneHot, ResidualAdapter, StyleTable
from toolkit.networks.experts import BlendedLinear, CatmullRom, Experts, Gating, VelocityGating
from toolkit.networks.film import Film, FilmGenerator, fold, layer_norm
from toolkit.networks.model import MODELS, Model
from toolkit.networks.parameter_counts import Row, counts, table2
from toolkit.networks.predictor import Predictor, Sizes, made, register

__all__ = ["MODELS", "BlendedLinear", "CatmullRom", "Experts", "Film", "FilmGenerator", "Gating",
           "Model", "OneHot", "Predictor", "ResidualAdapter", "Row", "Sizes", "StyleTable",
           "VelocityGating", "bank", "build", "counts", "fold", "layer_norm", "normalisers",
           "register", "table2"]


def build(name: str, layout: Layout, n_styles: int, sizes: Sizes | None = None,
          normalisers: dict[str, Normaliser] | None = None, *, generator: bool = True) -> Predictor:
    """A new model with random weights (from torch's global generator), in evaluation mode.

    Parameters
    ----------
    name
        One of `MODELS`, or the name of a model of your own, see `register`.
    layout
        Columns of x, p, z and y in the data. `Predictor.layout` differs from it in the columns of
        the phase.
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
    model = made(name, layout, n_styles, sizes or Sizes(), generator)
    model.normalise(normalisers or {})
    return model.eval()


def normalisers(name: str, data: Features) -> dict[str, Normaliser]:
    """Statistics of ``inputs``, ``phases``, ``outputs`` and ``clips`` in the columns of a model."""
    with torch.device("meta"):
        layout = made(name, data.layout, len(data.styles), Sizes()).layout
    return phase.normalisers(layout, data)
