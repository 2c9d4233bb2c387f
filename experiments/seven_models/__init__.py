"""Comparison of the seven models of Mason et al. 2022: Table 2, Figure 10 and section 5.1."""

from experiments.seven_models import failures, hundred, interpolation, models
from toolkit import datasets, features
from toolkit.features import Features, store

__all__ = ["failures", "hundred", "interpolation", "load", "models"]


def load(data: str, root: str | None, styles: str | None, gaits: str | None, clip_seconds: float | None) -> Features:
    """Features of a dataset or a store."""
    chosen = [None if names is None else names.split(",") for names in (styles, gaits)]
    if store.is_store(data):
        if root or gaits:
            raise ValueError(f"{data}: a store allows no --root and --gaits, only --styles")
        return store.load(data, chosen[0])
    options = {"seconds": clip_seconds} if data == "procedural" else {}
    return features.build(datasets.load(data, root, *chosen, **options), short="skip", progress=True)
