"""Vectors of single clips, and the separation of styles (Mason et al. 2022, Figure 11)."""

from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.features import Features
from toolkit.networks import Predictor

CLIPS = 50  # of a style, at most, of which `clip_vectors` makes vectors


@torch.no_grad()
def clip_vectors(model: Predictor, data: Features) -> tuple[Tensor, list[str]]:
    """Style vectors ``[N, D]`` of single style clips (Figure 11), and the style of each.

    The model needs a FiLM generator. Clips of a style that has many are evenly spaced.
    """
    vectors, styles = [], []
    for style, y in data.clips.items():
        chosen = y[torch.linspace(0, len(y) - 1, min(CLIPS, len(y))).long()]
        vectors += [model.style_vector(clip[None]) for clip in chosen]
        styles += [style] * len(chosen)
    return torch.stack(vectors), styles


def separation(vectors: Tensor, styles: Sequence[str]) -> dict[str, float]:
    """How well the vectors of clips separate their styles: the mean silhouette of each style.

    The silhouette of a clip is (b − a) / max(a, b), where a is the mean distance to the other clips
    of its style and b to those of the nearest other style. 1: far from all others; 0: between two;
    negative: nearer to another style.

    Parameters
    ----------
    vectors : Tensor [N, D]
        Vectors of single clips, see `clip_vectors`.
    styles
        The style of each vector; at least two styles with two clips each.

    Raises
    ------
    ValueError
        If the numbers of vectors and styles differ, or there are fewer styles or clips.
    """
    names = list(dict.fromkeys(styles))
    counts = {name: styles.count(name) for name in names}
    if len(styles) != len(vectors) or len(names) < 2 or min(counts.values()) < 2:
        raise ValueError("separation needs two styles or more, of two clips or more each; "
                         f"got {len(vectors)} vectors and clips {counts}")
    try:
        from sklearn.metrics import silhouette_samples
    except ImportError as error:
        raise ValueError("this needs the package scikit-learn: "
                         "pip install scikit-learn") from error
    each = silhouette_samples(vectors.detach().double().cpu().numpy(), styles)
    return {name: float(each[[s == name for s in styles]].mean()) for name in names}
