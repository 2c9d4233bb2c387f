"""The space of style vectors: maps of it, and the separation of styles in it (Mason et al. 2022, Figure 11)."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module

import torch
from torch import Tensor

from toolkit.features import Features
from toolkit.motion.tensors import summary
from toolkit.networks import Model

EMBEDDINGS = {"tsne": ("sklearn.manifold", "TSNE", "scikit-learn"), "pca": ("sklearn.decomposition", "PCA", "scikit-learn"),
              "umap": ("umap", "UMAP", "umap-learn")}  # name: module, class, package
PERPLEXITY = 30.0  # of t-SNE, about the number of neighbours; at most a third of the points


@torch.no_grad()
def clip_vectors(model: Model, data: Features, clips: int = 50) -> tuple[Tensor, list[str]]:
    """Style vectors ``[N, D]`` of single style clips (Figure 11), and the style of each.

    The model needs a FiLM generator. A style has at most ``clips`` clips, evenly spaced.
    """
    vectors, styles = [], []
    for style, y in data.clips.items():
        chosen = y[torch.linspace(0, len(y) - 1, min(clips, len(y))).long()]
        vectors += [model.style_vector(clip[None]) for clip in chosen]
        styles += [style] * len(chosen)
    return torch.stack(vectors), styles


def embed(vectors: Tensor, method: str = "tsne", seed: int = 0) -> Tensor:
    """A map of style vectors: points ``[N, 2]`` of ``vectors [N, D]``.

    Parameters
    ----------
    vectors
        Three or more.
    method
        ``"tsne"`` (Figure 11) keeps neighbours together; ``"pca"`` is linear, so blends lie on straight lines; ``"umap"``
        needs the package umap-learn.
    seed
        The same seed gives the same map.

    Raises
    ------
    ValueError
        If the method is unknown or its package missing, or there are fewer than three vectors.
    """
    if method not in EMBEDDINGS:
        raise ValueError(f"unknown embedding {method!r}; known: {', '.join(EMBEDDINGS)}")
    if vectors.dim() != 2 or len(vectors) < 3:
        raise ValueError(f"a map needs three or more vectors [N, D], got {list(vectors.shape)}")
    module, name, package = EMBEDDINGS[method]
    try:
        embedding = getattr(import_module(module), name)
    except ImportError as error:
        raise ValueError(f"the embedding {method!r} needs the package {package}: pip install {package}") from error
    others = len(vectors) - 1
    options = {"tsne": {"perplexity": min(PERPLEXITY, others / 3), "init": "pca"},
               "umap": {"n_neighbors": min(15, others), "n_jobs": 1}, "pca": {"n_components": 2}}[method]
    points = embedding(**options, random_state=seed).fit_transform(vectors.detach().double().cpu().numpy())
    return torch.from_numpy(points).float()


@dataclass(frozen=True)
class Separation:
    """How well the vectors of clips separate their styles: three measures by style.

    The silhouette of a clip is (b − a) / max(a, b), where a is the mean distance to the other clips of its style and b to
    those of the nearest other style. 1: far from all others; 0: between two; negative: nearer to another style.
    """

    silhouette: dict[str, float]  # mean over the clips
    ratio: dict[str, float]  # distance to the nearest other mean / root-mean-square distance of the clips from their mean
    found: dict[str, float]  # share of clips whose nearest mean is that of their own style (without the clip itself)
    __repr__ = summary


def separation(vectors: Tensor, styles: Sequence[str]) -> Separation:
    """Silhouette, separation and nearest-mean accuracy of every style.

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
    label = torch.tensor([names.index(s) for s in styles])
    counts = torch.bincount(label, minlength=len(names))
    if len(label) != len(vectors) or len(names) < 2 or int(counts.min()) < 2:
        raise ValueError(f"separation needs two styles or more, of two clips or more each; got {len(vectors)} vectors and "
                         f"clips {dict(zip(names, counts.tolist(), strict=True))}")
    rows, member = vectors.detach().double(), torch.nn.functional.one_hot(label).double()
    own = label[:, None]
    mean = torch.cdist(rows, rows) @ member  # summed distance of each clip to the clips of each style, [N, S]
    within = mean.gather(1, own)[:, 0] / (counts[label] - 1)
    others = (mean / counts).scatter(1, own, torch.inf).amin(1)
    silhouette = (others - within) / torch.maximum(within, others).clamp_min(1e-12)
    centres = member.T @ rows / counts[:, None]
    without = (centres[label] * counts[label, None] - rows) / (counts[label, None] - 1)  # mean without this clip
    reach = torch.cdist(rows, centres).scatter(1, own, (rows - without).norm(dim=-1, keepdim=True))
    spread = (member.T @ (rows - centres[label]).square().sum(-1, keepdim=True))[:, 0].div(counts).sqrt()
    apart = torch.cdist(centres, centres).fill_diagonal_(torch.inf).amin(1)

    def by_style(values: Tensor) -> dict[str, float]:
        return dict(zip(names, (member.T @ values.double() / counts).tolist(), strict=True))

    ratio = dict(zip(names, (apart / spread.clamp_min(1e-12)).tolist(), strict=True))
    return Separation(by_style(silhouette), ratio, by_style(reach.argmin(1) == label))
