"""What restyled motions are worth (Park et al. 2021, section 7): do they look real, keep the content and change the style?

Judged by classifiers that never saw a clip of the generator's.
"""

from dataclasses import dataclass
from typing import Protocol

import torch
from torch import Tensor

from toolkit.evaluation import classifier, metrics
from toolkit.evaluation.classifier import Classifier
from toolkit.features.splits import generator
from toolkit.motion import Clip, Skeleton, contacts
from toolkit.motion import rotations as R
from toolkit.stylization.data import FPS, Motions, to_clip
from toolkit.stylization.restyling import hold_feet

LOOSE = {"height": 0.03, "speed": 1.5}  # metres, m/s: when a toe counts as standing that no foot-skate removal has held yet
STEPPING = 1.0  # landings per second from which a motion counts as walking or running
BATCH = 64  # motions restyled at a time


class Model(Protocol):
    """Anything that restyles: ours, and the baselines of Table 2."""

    def code_of(self, x: Tensor, domain: Tensor) -> Tensor:
        """Style codes [B, …] of references [B, 7, T, N] of domains [B]."""

    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """Motions [B, 7, T, N] in the style of codes [B, …]."""


@dataclass(frozen=True, eq=False)
class Judges:
    """A classifier of contents and one of styles; ``real [K, 256]``, the first's features of motions to look like."""

    content: Classifier
    style: Classifier
    real: Tensor

    def judge(self, x: Tensor, content: Tensor, domain: Tensor) -> dict[str, float]:
        """``fmd``, and the shares of motions x [M, 7, T, N] whose ``content`` [M] and ``style``, domain [M], are named."""
        return {
            "fmd": metrics.frechet_distance(classifier.features(self.content, x), self.real),
            "content": accuracy(self.content, x, content),
            "style": accuracy(self.style, x, domain),
        }


def accuracy(model: Classifier, x: Tensor, labels: Tensor) -> float:
    """Share of motions [M, 7, T, N] for which the classifier names the label [M]."""
    return float((classifier.recognise(model, x) == labels).float().mean())


@torch.no_grad()
def evaluate(model: Model, sources: Motions, references: Motions, judges: Judges, *, by: str = "noise",
             seed: int = 0) -> dict[str, float]:
    """Restyle every source to every domain that it is not of, twice, and judge what comes out.

    Parameters
    ----------
    model
        What restyles; has ``code_from`` and ``sizes`` as well where codes come from noise.
    sources, references
        Motions that it was not trained on.
    judges
        Trained on motions that the model never saw.
    by
        Where codes come from: ``"noise"`` (Table 1) or ``"reference"`` (Table 2), drawn at random from the domain's.
    seed
        Draws noise and references.

    Returns
    -------
    dict
        ``fmd``, ``content`` and ``style`` of all results (`Judges.judge`); ``diversity``, the mean distance of a joint
        between the two results, and ``change``, between source and result, metres; and whether results stand on the floor
        when their sources do, of sources that walk or run: ``contact_f1`` after foot-skate removal, which helps it, and
        ``contact_raw`` before, by looser limits.

    Raises
    ------
    ValueError
        If ``by`` is neither.
    """
    if by not in ("noise", "reference"):
        raise ValueError(f"style codes come by noise or by reference, not by {by!r}")
    rows, target = pairs(sources)
    x, draw = sources.x[rows], generator(seed, len(rows))
    made = []
    for _ in range(2):
        if by == "noise":
            codes = model.code_from(torch.randn(len(rows), model.sizes.latent, generator=draw), target)
        else:
            chosen = [(references.domain == d).nonzero()[:, 0] for d in range(len(references.domains))]
            chosen = torch.stack([chosen[d][torch.randint(len(chosen[d]), (), generator=draw)] for d in target])
            codes = torch.cat([model.code_of(*part) for part in zip(references.x[chosen].split(BATCH), target.split(BATCH),
                                                                    strict=True)])
        parts = zip(x.split(BATCH), codes.split(BATCH), strict=True)
        made.append(torch.cat([model.translate(*part) for part in parts]))
    return {
        **judges.judge(torch.cat(made), sources.content[rows].repeat(2), target.repeat(2)),
        "diversity": distance(*made),
        "change": distance(x, made[0]),
        **contact_agreement(sources.select(rows), made[0]),
    }


def pairs(sources: Motions) -> tuple[Tensor, Tensor]:
    """Rows [P] and target domains [P]: every source with every domain but its own."""
    return tuple((torch.arange(len(sources.domains)) != sources.domain[:, None]).nonzero().T)


def distance(a: Tensor, b: Tensor) -> float:
    """Mean distance of a joint between motions [M, 7, T, N] that are frame by frame alike, metres."""
    return float((a[:, :3] - b[:, :3]).norm(dim=1).mean())


def contact_agreement(sources: Motions, made: Tensor) -> dict[str, float]:
    """``contact_f1`` and ``contact_raw``, see `evaluate`, of sources and what was made of each, [M, 7, T, N]."""
    before, after = ([clip_of(*motion, sources.skeleton) for motion in zip(x, sources.root_velocity, strict=True)]
                     for x in (sources.x, made))
    held = [hold_feet(*pair) for pair in zip(after, before, strict=True)]

    def standing(clips: list[Clip], **limits: float) -> Tensor:
        return torch.stack([contacts.detect(clip, **limits) for clip in clips])

    return {"contact_f1": contact_f1(standing(before), standing(held)),
            "contact_raw": contact_f1(standing(before, **LOOSE), standing(after, **LOOSE))}


def clip_of(x: Tensor, root_velocity: Tensor, skeleton: Skeleton) -> Clip:
    """The clip of a motion [7, T, N], from the origin."""
    return to_clip(x, root_velocity, Clip(skeleton, R.identity(1, len(skeleton)), torch.zeros(1, 3), FPS))


def contact_f1(source: Tensor, result: Tensor) -> float:
    """F1 of the results' foot contacts [M, T, 2] as a guess of the sources', over those that step; NaN where none does.

    The feet of two walkers that have nothing to do with each other agree by chance to about 0.6.
    """
    steps = torch.tensor([metrics.step_rate(contact, FPS) >= STEPPING for contact in source])
    a, b = source[steps], result[steps]
    return float(2 * (a * b).sum() / (a.sum() + b.sum())) if len(a) else float("nan")
