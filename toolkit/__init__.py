"""Stylised character animation: Mason et al. 2022 and Park et al. 2021 in plain Python."""

from toolkit import bvh

__version__ = "0.1.0"
__all__ = ["bvh"]
