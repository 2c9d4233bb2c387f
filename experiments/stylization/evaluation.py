"""Evaluation of restyled motions (Park et al. 2021, section 7): realism, content preservation, style and diversity."""

from collections.abc import Callable

import torch
from torch import Tensor

from experiments.stylization.judges import Judges
from toolkit.evaluation import metrics
from toolkit.features.splits import generator
from toolkit.motion import Clip, Skeleton, contacts
from toolkit.motion import rotations as R
from toolkit.stylization.data import FPS, Motions, to_clip
from toolkit.stylization.networks import Stylizer

LOOSE = {"height": 0.03, "speed": 1.5}  # metres, m/s: limits of a contact before feet are held
STEPPING = 1.0  # landings per second, least for walking or running
BATCH = 64  # motions per forward pass
STEPS = 100  # sources of the foot contacts, at most
WAYS = ("noise", "reference", "dissimilar")
SLIDE = range(-16, 17, 2)  # frames by which one motion is moved over another to compare them
PAIRS = 400  # of real motions, for their own diversity


def evaluate(model: Stylizer, sources: Motions, references: Motions, judges: Judges, *, by: str = "noise",
             seed: int = 0) -> dict[str, float]:
    """Restyle every source to every other domain, twice, and measure the results (`measures`).

    Parameters
    ----------
    model
        A stylizer, or another model with its methods `code_of` and `translate` (the baselines of Table 2).
    sources, references
        Motions that the model was not trained on.
    judges
        Classifiers that were not trained on these motions.
    by
        Source of the style codes: ``"noise"`` (Table 1), ``"reference"`` (Table 2), a random motion of the domain, or
        ``"dissimilar"``, one of another content than the source's.
    seed
        Seed of noise and references.

    Raises
    ------
    ValueError
        If ``by`` is unknown.
    """
    rows, target = pairs(sources)
    return measures(sources.select(rows), target, results(model, sources, references, by, seed), judges)


@torch.no_grad()
def results(model: Stylizer, sources: Motions, references: Motions, by: str, seed: int) -> list[Tensor]:
    """Every source in every other domain, twice: two tensors ``[P, 7, T, N]`` in the order of `pairs`."""
    if by not in WAYS:
        raise ValueError(f"style codes come from by= one of {', '.join(WAYS)}, got {by!r}")
    rows, target = pairs(sources)
    if by == "noise":
        draw = generator(seed, len(rows))
        codes = [model.code_from(torch.randn(len(rows), model.sizes.latent, generator=draw), target) for _ in range(2)]
    else:
        codes = [_in_batches(model.code_of, references.x[k], target) for k in drawn(sources, references, by, seed)]
    return [_in_batches(model.translate, sources.x[rows], code) for code in codes]


def drawn(sources: Motions, references: Motions, by: str, seed: int) -> list[Tensor]:
    """Rows [P] of the references of `results`, for the first and for the second result."""
    rows, target = pairs(sources)
    fits = references.domain == target[:, None]  # [P, R]
    if by == "dissimilar":
        other = torch.tensor([[name != own for name in references.contents] for own in sources.contents])
        fits &= other[sources.content[rows]][:, references.content]
    draw = generator(seed, len(rows))
    return [torch.multinomial(fits.float(), 1, generator=draw)[:, 0] for _ in range(2)]


def measures(sources: Motions, target: Tensor, made: list[Tensor], judges: Judges) -> dict[str, float]:
    """Measures of results ``[P, 7, T, N]`` (a list, to compare two for the same source) of sources and target domains [P].

    Those of `Judges.judge`; ``diversity``, the mean angle (degrees) between the joints of the first two results;
    ``bone``, the mean error of a bone's length (metres) in the positions;
    ``contact_f1``, the agreement of foot contacts of sources that walk or run with their results', before feet are held;
    ``acceleration``, the mean acceleration of the results' joints as a share of the sources'.
    """
    several = len(made)
    return {
        **judges.judge(torch.cat(made), sources.content.repeat(several), target.repeat(several)),
        "diversity": float(angles(*made[:2]).mean()) if several > 1 else 0.0,
        "bone": bone_error(made[0], sources.skeleton),
        "contact_f1": contact_agreement(sources, made[0]),
        "acceleration": float(acceleration(made[0]).mean() / acceleration(sources.x).mean()),
    }


def _in_batches(function: Callable[[Tensor, Tensor], Tensor], *columns: Tensor) -> Tensor:
    return torch.cat([function(*part) for part in zip(*(column.split(BATCH) for column in columns), strict=True)])


def pairs(sources: Motions) -> tuple[Tensor, Tensor]:
    """Rows [P] and target domains [P]: every source with every domain but its own."""
    return tuple((torch.arange(len(sources.domains)) != sources.domain[:, None]).nonzero().T)


def angles(a: Tensor, b: Tensor) -> Tensor:
    """Mean angle [P] in degrees (geodesic distance of rotations) between the joints of motions ``[P, 7, T, N]``.

    The middle half of a is compared with the frames of b at the same times, or a little earlier or later (`SLIDE`), where
    the two agree most: so that two walks out of step are not called different.
    """
    frames = a.shape[2]
    start, half = frames // 4, frames // 2
    moves = [start + k for k in SLIDE if 0 <= start + k <= frames - half]
    q = a[:, 3:, start : start + half]
    turned = [2 * (q * b[:, 3:, s : s + half]).sum(1).abs().clamp(max=1).acos().mean((1, 2)) for s in moves]
    return torch.stack(turned).amin(0).rad2deg()


def own_diversity(motions: Motions, seed: int = 0) -> float:
    """`angles` between two real motions of one domain and one content from different takes, the mean over random pairs."""
    alike = (motions.domain == motions.domain[:, None]) & (motions.content == motions.content[:, None])
    first, second = (alike & (motions.take != motions.take[:, None])).nonzero().T
    if not len(first):
        return float("nan")
    chosen = torch.randperm(len(first), generator=generator(seed))[:PAIRS]
    return float(angles(motions.x[first[chosen]], motions.x[second[chosen]]).mean())


def bone_error(x: Tensor, skeleton: Skeleton) -> float:
    """Mean difference of the bones' lengths in the positions of motions ``[P, 7, T, N]`` to the skeleton's, metres."""
    bones = (x[:, :3, :, 1:] - x[:, :3, :, list(skeleton.parents[1:])]).norm(dim=1)
    return float((bones - skeleton.offsets[1:].norm(dim=-1)).abs().mean())


def acceleration(x: Tensor) -> Tensor:
    """Mean magnitude [P] of the joints' accelerations in the root frame, m/s²."""
    return x[:, :3].diff(n=2, dim=2).norm(dim=1).mean((1, 2)) * FPS**2


def contact_agreement(sources: Motions, made: Tensor) -> float:
    """`contact_f1` of the results [M, 7, T, N] of sources, by loose limits and for at most `STEPS` of them."""
    chosen = torch.randperm(len(made), generator=generator(0, len(made)))[:STEPS]
    sources, made = sources.select(chosen), made[chosen]
    before, after = (torch.stack([contacts.detect(clip_of(*motion, sources.skeleton), **LOOSE)
                                  for motion in zip(x, sources.root_velocity, strict=True)]) for x in (sources.x, made))
    return contact_f1(before, after)


def clip_of(x: Tensor, root_velocity: Tensor, skeleton: Skeleton) -> Clip:
    """The clip of a motion [7, T, N], which starts at the origin."""
    return to_clip(x, root_velocity, Clip(skeleton, R.identity(1, len(skeleton)), torch.zeros(1, 3), FPS))


def contact_f1(source: Tensor, result: Tensor) -> float:
    """F1 of the results' foot contacts [M, T, 2] as predictions of the sources', for sources that step; else NaN.

    Two unrelated walks have an F1 of about 0.6.
    """
    steps = torch.tensor([metrics.step_rate(contact, FPS) >= STEPPING for contact in source])
    a, b = source[steps], result[steps]
    return float(2 * (a * b).sum() / (a.sum() + b.sum())) if len(a) else float("nan")
