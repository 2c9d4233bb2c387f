"""A style learnt from clips, and chosen by how it walks beside them. (ours)"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import torch
from torch import Tensor

from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.networks import FilmGenerator, Predictor
from toolkit.networks.bank import StyleBank
from toolkit.styles import comparison
from toolkit.styles.closed_loop import RATES, ClosedLoop
from toolkit.styles.comparison import Comparison
from toolkit.styles.fine_tuning import STEPS, NewStyles, fine_tune, prior_of

#: Rounds of `choose` in closed loop, and the excess that is enough.
ROUNDS, ENOUGH = 12, 0.7


@dataclass(frozen=True, eq=False)
class Learnt:
    """Result of `learn`."""

    made: NewStyles  # the training
    bank: StyleBank  # with the chosen vector
    compared: Comparison  # its walk beside the longest clip
    mirror: bool  # whether the mirror images of the clips were learnt, too


def learn(model: Predictor, bank: StyleBank, clips: Sequence[Clip], name: str, *,
          steps: int = STEPS, seed: int = 0, progress: bool = False) -> Learnt:
    """Learn one style from clips in several ways, until one walks as the longest clip does.

    Long standing ends of the clips are cut (`comparison.walking`). The ways are the default of
    `fine_tune`, the same with the mirror images of the clips, and, for a model that has its FiLM
    generator, the style vector alone. The best vector is then trained in closed loop, see `choose`;
    the other ways' vectors, too, as long as none is good.

    Parameters and errors are those of `fine_tune` and `choose`.
    """
    longest = max(clips, key=lambda clip: clip.seconds)
    ways: list[dict] = [{}, {"mirror": True}]
    if isinstance(model.generator, FilmGenerator):
        ways.append({"method": "vector"})
    tried: list[Learnt] = []
    clips = [comparison.walking(clip) for clip in clips]
    for way in ways:
        made = fine_tune(model, clips, name, bank, steps=steps, seed=seed, progress=progress, **way)
        tried.append(Learnt(made, *choose(made, longest, rounds=0), mirror="mirror" in way))
        if tried[-1].compared.verdict == "good":
            break
    ended: list[Learnt] = []
    for one in sorted(tried, key=lambda one: one.compared.rank()):
        best, compared = _in_closed_loop(one.made, longest, one.bank, one.compared, ROUNDS, seed,
                                         progress)
        ended.append(replace(one, bank=best, compared=compared))
        if compared.verdict == "good":
            break
    return min(ended, key=lambda one: one.compared.rank())


def choose(made: NewStyles, clip: Clip, *, rounds: int = ROUNDS, seed: int = 0,
           progress: bool = False) -> tuple[StyleBank, Comparison]:
    """The bank with the vector that walks most like a clip, and its comparison.

    At first this is a vector of the training, whose error one step ahead does not say how it walks.
    So it is trained on by its walk, in up to ``rounds`` rounds of `toolkit.styles.closed_loop`,
    until its excess is at most `ENOUGH`. The best round counts. If none is better than before, so
    many rounds follow at a lower rate.

    The clip should be a walk (`not_a_walk`). ValueError if several styles were learnt at once.
    """
    if len(made.names) != 1:
        raise ValueError(f"one style is chosen at a time, got {', '.join(made.names)}")
    (name,) = made.names
    vectors = torch.cat([made.bank[name][None], made.tried[:, 0]])
    floors = comparison.floors_of(made.bank, vectors[0], name)
    walked = comparison.walks(clip, made.model, vectors, made.bank, floors)
    found = comparison.compared(clip, made.model, walked, floors)
    best = min(range(len(found)), key=lambda i: found[i].rank())
    bank = _with(made, vectors[best])
    return _in_closed_loop(made, clip, bank, found[best], rounds, seed, progress)


def _in_closed_loop(made: NewStyles, clip: Clip, bank: StyleBank, compared: Comparison, rounds: int,
                    seed: int, progress: bool) -> tuple[StyleBank, Comparison]:
    """The training of `choose`, from the vector of a bank and its comparison on."""
    (name,), model = made.names, made.model
    floors = comparison.floors_of(made.bank, made.bank[name], name)
    prior, middle = prior_of(model, made.bank), comparison.middle(clip)

    def walks(vector: Tensor) -> list[comparison.Walk]:
        return comparison.walks(clip, model, vector[None], made.bank, floors, rounds)

    start = compared
    for rate in RATES:
        if not rounds or compared.excess <= ENOUGH or compared is not start:
            break
        vector = bank[name]
        loop = ClosedLoop(model, middle, vector, prior, rate, rounds, seed)
        walked = walks(vector)
        for _ in progress_bar(range(rounds), desc="closed loop", unit="round", show=progress):
            vector = loop.round(walked)
            walked = walks(vector)
            if not all(walk.states[-1].joints.isfinite().all() for walk in walked):
                break  # the vector diverged
            (found,) = comparison.compared(clip, model, walked, floors)
            if found.rank() < compared.rank():
                bank, compared = _with(made, vector), found
            if compared.excess <= ENOUGH:
                break
    return bank, compared


def _with(made: NewStyles, vector: Tensor) -> StyleBank:
    """The bank of a training with another vector of its one style."""
    vectors = made.bank.vectors.clone()
    vectors[made.bank.names.index(made.names[0])] = vector
    return replace(made.bank, vectors=vectors)
