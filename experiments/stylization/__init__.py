"""The ablation and the comparison of Park et al. 2021, with their baselines: ``python -m experiments stylization``."""
