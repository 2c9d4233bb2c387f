"""A style learnt from clips, and chosen by how it walks beside them. (ours)"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import torch
from torch import Tensor

from toolkit.features import splits
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.networks import FilmGenerator, Predictor
from toolkit.networks.bank import StyleBank
from toolkit.styles import comparison
from toolkit.styles.comparison import Comparison
from toolkit.styles.fine_tuning import STEPS, NewStyles, fine_tune, prior_of

#: The search of `choose`: rounds; vectors of a round, of which the best ones make the next middle;
#: their deviation, as a share of the bank's, and what is left of it in each further round; the
#: excess that is enough.
ROUNDS, VECTORS, BEST, NOISE, COOLING, ENOUGH = 8, 24, 6, 0.3, 0.85, 0.7


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

    The ways are the default of `fine_tune`, the same with the mirror images of the clips, and, for
    a model that has its FiLM generator, the style vector alone. Of the best one, `choose` looks for
    the vector that walks most like the clip.

    Parameters and errors are those of `fine_tune` and `choose`.
    """
    longest = max(clips, key=lambda clip: clip.seconds)
    ways: list[dict] = [{}, {"mirror": True}]
    if isinstance(model.generator, FilmGenerator):
        ways.append({"method": "vector"})
    tried: list[Learnt] = []
    for way in ways:
        made = fine_tune(model, clips, name, bank, steps=steps, seed=seed, progress=progress, **way)
        tried.append(Learnt(made, *choose(made, longest, rounds=0), mirror="mirror" in way))
        if tried[-1].compared.verdict == "good":
            break
    best = min(tried, key=lambda one: one.compared.rank())
    bank, compared = _searched(best.made, longest, best.bank, best.compared, ROUNDS, seed, progress)
    return replace(best, bank=bank, compared=compared)


def choose(made: NewStyles, clip: Clip, *, rounds: int = ROUNDS, seed: int = 0,
           progress: bool = False) -> tuple[StyleBank, Comparison]:
    """The bank with the vector that walks most like a clip, and its comparison.

    At first this is a vector of the training. The error one step ahead, by which the training went,
    does not say how it walks. So up to ``rounds`` times, vectors that are drawn around a middle one
    walk side by side, and the next middle is a weighted mean of the best: an evolution strategy
    (Beyer and Schwefel 2002). It ends with an excess of `ENOUGH`.

    The clip should be a walk (`not_a_walk`). ValueError if several styles were learnt at once.
    """
    if len(made.names) != 1:
        raise ValueError(f"one style is chosen at a time, got {', '.join(made.names)}")
    (name,) = made.names
    vectors = torch.cat([made.bank[name][None], made.tried[:, 0]])
    floors = comparison.floors_of(made.bank, vectors[0], name)
    found = comparison.compared(clip, made.model, vectors, made.bank, floors)
    best = min(range(len(found)), key=lambda i: found[i].rank())
    bank = _with(made, vectors[best])
    return _searched(made, clip, bank, found[best], rounds, seed, progress)


def _searched(made: NewStyles, clip: Clip, bank: StyleBank, compared: Comparison, rounds: int,
              seed: int, progress: bool) -> tuple[StyleBank, Comparison]:
    """The evolution strategy of `choose`, from the vector of a bank and its comparison on."""
    (name,) = made.names
    floors, draw = comparison.floors_of(made.bank, made.bank[name], name), splits.generator(seed)
    deviation = NOISE * prior_of(made.model, made.bank)[1]
    weights = torch.arange(BEST, 0, -1.0)[:, None] / sum(range(BEST + 1))
    middle = bank[name]
    for turn in progress_bar(range(rounds), desc="search", unit="round", show=progress):
        if compared.excess <= ENOUGH:
            break
        noise = torch.randn(VECTORS, len(middle), generator=draw) * deviation * COOLING**turn
        vectors = torch.cat([middle[None], middle + noise])
        found = comparison.compared(clip, made.model, vectors, made.bank, floors)
        ranked = sorted(range(len(found)), key=lambda i: found[i].rank())
        middle = (weights * vectors[ranked[:BEST]]).sum(0)
        if (best := found[ranked[0]]).rank() < compared.rank():
            bank, compared = _with(made, vectors[ranked[0]]), best
    return bank, compared


def _with(made: NewStyles, vector: Tensor) -> StyleBank:
    """The bank of a training with another vector of its one style."""
    vectors = made.bank.vectors.clone()
    vectors[made.bank.names.index(made.names[0])] = vector
    return replace(made.bank, vectors=vectors)
