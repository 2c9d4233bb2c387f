"""Networks of Mason et al. 2022: gated experts that synthesise motion, and style modulation."""

import torch

from toolkit.features import Features, Normaliser
from toolkit.networks import bank, phase
from toolkit.networks.adapters import OneHot, ResidualAdapter, StyleTable
from toolkit.networks.experts import BlendedLinear, CatmullRom, Experts, Gating, VelocityGating
from toolkit.networks.film import Film, FilmGenerator, layer_norm
from toolkit.networks.model import MODELS, Model
from toolkit.networks.parameter_counts import Row, counts, table2
from toolkit.networks.predictor import Predictor, Sizes, build, imported, register

__all__ = ["MODELS", "BlendedLinear", "CatmullRom", "Experts", "Film", "FilmGenerator", "Gating",
           "Model", "OneHot", "Predictor", "ResidualAdapter", "Row", "Sizes", "StyleTable",
           "VelocityGating", "bank", "build", "counts", "imported", "layer_norm",
           "normalisers", "register", "table2"]


def normalisers(name: str, data: Features) -> dict[str, Normaliser]:
    """Statistics of ``inputs``, ``phases``, ``outputs`` and ``clips`` in the columns of a model."""
    with torch.device("meta"):
        layout = build(name, data.layout, len(data.styles)).layout
    return phase.normalisers(layout, data)
