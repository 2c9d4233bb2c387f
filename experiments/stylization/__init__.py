"""Ablation and comparison of Park et al. 2021: ``python -m experiments stylization``."""
