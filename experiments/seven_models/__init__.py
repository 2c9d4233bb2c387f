"""Comparison of the seven models of Mason et al. 2022: Table 2, Figure 10 and section 5.1."""

from experiments.seven_models import failures, hundred, interpolation, models
from experiments.seven_models.models import load

__all__ = ["failures", "hundred", "interpolation", "load", "models"]
