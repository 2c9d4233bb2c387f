"""Networks of Mason et al. 2022: gated experts that synthesise motion, and style modulation."""

from toolkit.networks import bank
from toolkit.networks.adapters import OneHot, ResidualAdapter, StyleTable
from toolkit.networks.experts import BlendedLinear, CatmullRom, Experts, Gating, VelocityGating
from toolkit.networks.film import Film, FilmGenerator, layer_norm
from toolkit.networks.model import MODELS, Model
from toolkit.networks.parameter_counts import Row, counts, table2
from toolkit.networks.phase import normalisers
from toolkit.networks.predictor import Predictor, Sizes, build, imported, register

__all__ = ["MODELS", "BlendedLinear", "CatmullRom", "Experts", "Film", "FilmGenerator", "Gating",
           "Model", "OneHot", "Predictor", "ResidualAdapter", "Row", "Sizes", "StyleTable",
           "VelocityGating", "bank", "build", "counts", "imported", "layer_norm",
           "normalisers", "register", "table2"]
