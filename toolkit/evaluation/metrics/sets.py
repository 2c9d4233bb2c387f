"""Measures of many clips by the features of a recogniser (`toolkit.evaluation.recognition`)."""

import math
from collections import defaultdict
from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.evaluation.recognition import Recogniser
from toolkit.motion import Clip


def frechet_distance(a: Tensor, b: Tensor) -> float:
    """Squared Fréchet distance of the Gaussians fitted to two sets of feature vectors.

    ``|μa − μb|² + tr(Σa + Σb − 2 (Σa Σb)^½)``. With the features of a motion classifier it is the
    Fréchet Motion Distance (Park et al. 2021, section 7). It is biased upwards for small sets:
    compare only values of sets of the same size.

    The features are ``a [M, D]`` and ``b [K, D]``; M and K may differ and be smaller than D.
    ValueError if a set has fewer than two rows or the widths differ.
    """
    if a.dim() != 2 or b.dim() != 2 or a.shape[1] != b.shape[1] or min(len(a), len(b)) < 2:
        raise ValueError("expected features [M, D] and [K, D], M and K at least 2; "
                         f"got {list(a.shape)} and {list(b.shape)}")
    means = [x.double().mean(0) for x in (a, b)]
    # Σ = RᵀR, so the trace of the root of a product of two covariances, which may be singular, is
    # the sum of the singular values of Ra Rbᵀ
    roots = [torch.linalg.qr(x.double() - mean).R / math.sqrt(len(x) - 1)
             for x, mean in zip((a, b), means, strict=True)]
    spread = sum(root.square().sum() for root in roots)
    spread = spread - 2 * torch.linalg.svdvals(roots[0] @ roots[1].T).sum()
    return max(0.0, float((means[0] - means[1]).square().sum() + spread))


def fmd(recogniser: Recogniser, clips: Sequence[Clip], real: Sequence[Clip],
        windows: int | None = None) -> float:
    """Fréchet motion distance (Park et al. 2021, section 7): no unit, lower is better.

    The FID of Heusel et al. 2017, on motions: `frechet_distance` of the recogniser's features of
    windows of one second: of all, or of so many of the clips, evenly spread. Compare only values of
    the same recogniser and number of windows. Departure: it is a recogniser of styles; Park et al.
    take one of contents.
    """
    made = _windows(recogniser, clips)
    if windows is not None:
        made = made[torch.linspace(0, len(made) - 1, windows).round().long()]
    return frechet_distance(made, _windows(recogniser, real))


def nearest(recogniser: Recogniser, clips: Sequence[Clip], real: Sequence[Clip]) -> float:
    """Mean distance of a window's features to the nearest of the real ones: no unit, as real.

    Much less than that of other real clips: the clips are copies.
    """
    made, truth = _windows(recogniser, clips), _windows(recogniser, real)
    return float(torch.cdist(made, truth).amin(1).mean())


def _windows(recogniser: Recogniser, clips: Sequence[Clip]) -> Tensor:
    return torch.cat([recogniser.embed(clip) for clip in clips])


def recognition(recogniser: Recogniser, clips: Sequence[Clip]) -> float:
    """Recognition accuracy, top 1 (Zhong et al. 2024, SMooDi): share in [0, 1], higher is better.

    The share of clips whose style is the recogniser's most probable one; NaN if it knows no clip's
    style.

    Source: github.com/neu-vi/SMooDi, ``mld/models/metrics/tm2t.py``, ``topk_accuracy`` (in
    percent).
    """
    known = [clip for clip in clips if clip.style in recogniser.styles]
    right = [recogniser.styles[int(recogniser.of_clip(clip).argmax())] == clip.style
             for clip in known]
    return sum(right) / len(right) if right else math.nan


def diversity(recogniser: Recogniser, clips: Sequence[Clip]) -> float:
    """Diversity (Guo et al. 2020, *Action2Motion*): mean distance of two clips' features.

    No unit; nearest to real is best. The source draws 200 random pairs. This is the mean over all
    pairs of different clips, its expected value. A clip's features are the mean over its windows.
    NaN for a single clip.
    """
    features = [recogniser.embed(clip).double().mean(0) for clip in clips]
    if len(features) < 2:
        return math.nan
    return float(torch.nn.functional.pdist(torch.stack(features)).mean())


def multimodality(recogniser: Recogniser, clips: Sequence[Clip]) -> float:
    """Multimodality (Guo et al. 2020): `diversity` within a style, mean over the styles.

    No unit; nearest to real is best. NaN if no style has two clips.
    """
    groups: dict[str, list[Clip]] = defaultdict(list)
    for clip in clips:
        groups[clip.style].append(clip)
    found = [diversity(recogniser, some) for some in groups.values() if len(some) > 1]
    return sum(found) / len(found) if found else math.nan
