"""Ablation and comparison of Park et al. 2021, with the baselines: ``python -m experiments stylization``."""
