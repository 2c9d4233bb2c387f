"""Evaluation of restyled motions (Park et al. 2021, section 7): realism, content preservation and style.

The classifiers must be trained on other clips than the stylizer.
"""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from torch import Tensor

from experiments.stylization import classifier
from experiments.stylization.classifier import Classifier
from toolkit.evaluation import metrics
from toolkit.features.splits import generator
from toolkit.motion import Clip, Skeleton, contacts
from toolkit.motion import rotations as R
from toolkit.stylization.data import FPS, Motions, to_clip
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.restyling import lock_feet

LOOSE = {"height": 0.03, "speed": 1.5}  # metres, m/s: limits of a contact before foot-skate removal
STEPPING = 1.0  # landings per second, least for walking or running
BATCH = 64  # motions per forward pass


@dataclass(frozen=True, eq=False)
class Judges:
    """A classifier of contents, one of styles, and the content classifier's features ``real [K, 256]`` of real motions."""

    content: Classifier
    style: Classifier
    real: Tensor

    def judge(self, x: Tensor, content: Tensor, domain: Tensor) -> dict[str, float]:
        """``fmd`` of motions x [M, 7, T, N]; shares with recognised ``content`` [M] and ``style`` (domain [M])."""
        return {
            "fmd": metrics.frechet_distance(classifier.features(self.content, x), self.real),
            "content": accuracy(self.content, x, content),
            "style": accuracy(self.style, x, domain),
        }


def accuracy(model: Classifier, x: Tensor, labels: Tensor) -> float:
    """Share of motions [M, 7, T, N] whose label [M] the classifier recognises."""
    return float((classifier.recognise(model, x) == labels).float().mean())


@torch.no_grad()
def evaluate(model: Stylizer, sources: Motions, references: Motions, judges: Judges, *, by: str = "noise",
             seed: int = 0) -> dict[str, float]:
    """Restyle every source to every other domain, twice, and measure the results.

    Parameters
    ----------
    model
        A stylizer, or another model with its methods `code_of` and `translate` (the baselines of Table 2).
    sources, references
        Motions that the model was not trained on.
    judges
        Classifiers trained on other motions than the model.
    by
        Source of the style codes: ``"noise"`` (Table 1) or ``"reference"`` (Table 2), a random motion of the domain.
    seed
        Seed of noise and references.

    Returns
    -------
    dict
        ``fmd``, ``content`` and ``style`` of all results (`Judges.judge`); the mean distance of a joint, metres, between the
        two results (``diversity``) and between source and result (``change``); and the agreement of the foot contacts of
        results and sources, for sources that walk or run: ``contact_f1`` after foot-skate removal, and ``contact_raw``
        before it, with looser limits.

    Raises
    ------
    ValueError
        If ``by`` is unknown.
    """
    if by not in ("noise", "reference"):
        raise ValueError(f"style codes come from by='noise' or by='reference', got {by!r}")
    rows, target = pairs(sources)
    x, draw = sources.x[rows], generator(seed, len(rows))
    members = [(references.domain == d).nonzero()[:, 0] for d in range(len(references.domains))]
    made = []
    for _ in range(2):
        if by == "noise":
            codes = model.code_from(torch.randn(len(rows), model.sizes.latent, generator=draw), target)
        else:
            chosen = torch.stack([members[d][torch.randint(len(members[d]), (), generator=draw)] for d in target])
            codes = _in_batches(model.code_of, references.x[chosen], target)
        made.append(_in_batches(model.translate, x, codes))
    return {
        **judges.judge(torch.cat(made), sources.content[rows].repeat(2), target.repeat(2)),
        "diversity": distance(*made),
        "change": distance(x, made[0]),
        **contact_agreement(sources.select(rows), made[0]),
    }


def _in_batches(function: Callable[[Tensor, Tensor], Tensor], *columns: Tensor) -> Tensor:
    return torch.cat([function(*part) for part in zip(*(column.split(BATCH) for column in columns), strict=True)])


def pairs(sources: Motions) -> tuple[Tensor, Tensor]:
    """Rows [P] and target domains [P]: every source with every domain but its own."""
    return tuple((torch.arange(len(sources.domains)) != sources.domain[:, None]).nonzero().T)


def distance(a: Tensor, b: Tensor) -> float:
    """Mean distance of a joint between two sets of motions [M, 7, T, N], metres."""
    return float((a[:, :3] - b[:, :3]).norm(dim=1).mean())


def contact_agreement(sources: Motions, made: Tensor) -> dict[str, float]:
    """``contact_f1`` and ``contact_raw`` (see `evaluate`) of the results [M, 7, T, N] of sources."""
    before, after = ([clip_of(*motion, sources.skeleton) for motion in zip(x, sources.root_velocity, strict=True)]
                     for x in (sources.x, made))
    locked = [lock_feet(*pair) for pair in zip(after, before, strict=True)]

    def standing(clips: list[Clip], **limits: float) -> Tensor:
        return torch.stack([contacts.detect(clip, **limits) for clip in clips])

    return {"contact_f1": contact_f1(standing(before), standing(locked)),
            "contact_raw": contact_f1(standing(before, **LOOSE), standing(after, **LOOSE))}


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
