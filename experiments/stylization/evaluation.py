"""Measures of restyled motions (Park et al. 2021, section 7): realism, content, style, variety."""

from collections.abc import Callable

import torch
from torch import Tensor

from experiments.stylization.judges import Judges
from toolkit.features.splits import generator
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.restyling import calm

BATCH = 64  # motions per forward pass
WAYS = ("noise", "reference")
SLIDE = range(-16, 17, 2)  # frames by which one motion is moved over another to compare them
PAIRS = 400  # of real motions, for their own diversity


@torch.no_grad()
def results(model: Stylizer, sources: Motions, references: Motions, by: str, seed: int,
            smooth: bool = False) -> list[Tensor]:
    """Every source in every other domain, twice: two tensors ``[P, 7, T, N]``, as `pairs`.

    Parameters
    ----------
    model
        A stylizer, or another model with its methods `code_of` and `translate` (the baselines of
        Table 2).
    sources, references
        Motions that the model was not trained on.
    by
        Source of the style codes: ``"noise"`` (Table 1), or ``"reference"`` (Table 2), a random
        motion of the domain.
    seed
        Of noise and references.
    smooth
        Whether their change is smoothed as in `stylize`.
    """
    if by not in WAYS:
        raise ValueError(f"style codes come from by= one of {', '.join(WAYS)}, got {by!r}")
    rows, target = pairs(sources)
    x = sources.x[rows]
    if by == "noise":
        draw = generator(seed, len(rows))
        noise = torch.randn(2, len(rows), model.sizes.latent, generator=draw)
        codes = [model.code_from(z, target) for z in noise]
    else:
        codes = [_in_batches(model.code_of, references.x[chosen], target)
                 for chosen in drawn(sources, references, seed)]
    made = [_in_batches(model.translate, x, code) for code in codes]
    return [calm(motion, x) for motion in made] if smooth else made


def blend(made: Tensor, shift: Tensor) -> Tensor:
    """Half of each, motions ``[B, 7, T, N]``, as in `stylize`."""
    positions, q = ((made + shift) / 2).split((3, 4), 1)
    return torch.cat((positions, torch.nn.functional.normalize(q, dim=1)), 1)


def drawn(sources: Motions, references: Motions, seed: int) -> list[Tensor]:
    """Rows [P] of the references of `results`, for the first and for the second result."""
    _, target = pairs(sources)
    fits = references.domain == target[:, None]  # [P, R]
    draw = generator(seed, len(target))
    return [torch.multinomial(fits.float(), 1, generator=draw)[:, 0] for _ in range(2)]


def measures(sources: Motions, target: Tensor, made: list[Tensor],
             judges: Judges) -> dict[str, float]:
    """Measures of results ``[P, 7, T, N]``, one or two for each source and target domain [P].

    Those of `Judges.judge`, and ``diversity``, the mean angle (degrees) between the joints of the
    two results.
    """
    several = len(made)
    content, domain = sources.content.repeat(several), target.repeat(several)
    return {
        **judges.judge(torch.cat(made), content, domain),
        "diversity": float(angles(*made).mean()) if several > 1 else 0.0,
    }


def _in_batches(function: Callable[..., Tensor], *columns: Tensor) -> Tensor:
    parts = zip(*(column.split(BATCH) for column in columns), strict=True)
    return torch.cat([function(*part) for part in parts])


def pairs(sources: Motions) -> tuple[Tensor, Tensor]:
    """Rows [P] and target domains [P]: every source with every domain but its own."""
    others = torch.arange(len(sources.domains)) != sources.domain[:, None]
    return tuple(others.nonzero().T)


def angles(a: Tensor, b: Tensor) -> Tensor:
    """Mean angle [P] in degrees (geodesic) between the joints of motions ``[P, 7, T, N]``.

    The middle half of a is compared with the frames of b at the same times, or a little earlier or
    later (`SLIDE`), where the two agree most: so that two walks out of step are not called
    different.
    """
    frames = a.shape[2]
    start, half = frames // 4, frames // 2
    q, turned = a[:, 3:, start : start + half], []
    for move in SLIDE:
        if 0 <= start + move <= frames - half:
            other = b[:, 3:, start + move : start + move + half]
            turned.append(2 * (q * other).sum(1).abs().clamp(max=1).acos().mean((1, 2)))
    return torch.stack(turned).amin(0).rad2deg()


def own_diversity(motions: Motions) -> float:
    """`angles` between real motions of one domain and content from different takes, the mean."""
    alike = (motions.domain == motions.domain[:, None]) & (
        motions.content == motions.content[:, None])
    first, second = (alike & (motions.take != motions.take[:, None])).nonzero().T
    if not len(first):
        return float("nan")
    chosen = torch.randperm(len(first), generator=generator(0))[:PAIRS]
    return float(angles(motions.x[first[chosen]], motions.x[second[chosen]]).mean())
