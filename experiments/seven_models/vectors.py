"""Style vectors of a finished model: of one clip, the mean of some or of all, and fitted to frames;
on held-out frames.
"""

from collections.abc import Sequence

import torch

from experiments.seven_models.models import HELD_OUT, WARM_UP, average, states
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import Features, splits
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS, Command
from toolkit.training import Run
from toolkit.training.loss import evaluate, make_bank, refit

SECONDS, FRAMES = 6.0, 400  # measured seconds of a walk; held-out frames of a style
ONE_CLIP = 3  # different clips


def compared(runs: Sequence[Run], data: Features, recogniser: Recogniser,
             progress: bool = False) -> list[dict]:
    """Rows, one for each way to make a bank: error on held-out frames and share of recognised
    walks, a value for each run.

    ``better`` is the share of styles whose error is lower than with the mean of all clips.
    """
    train, test = splits.split(data, HELD_OUT, 0, tuple(data.styles))
    rows: dict[str, dict] = {}
    for run in runs:
        reference = None
        for name, banks in _banks(run, train, progress).items():
            errors = [evaluate(run.model, bank, test, FRAMES) for bank in banks]
            by_style = {s: average([found[s]["mse"] for found in errors]) for s in errors[0]}
            reference = reference or by_style
            row = rows.setdefault(name, {"vector": name, "mse": [], "better": [], "recognised": []})
            row["mse"].append(average(list(by_style.values())))
            row["better"].append(average([float(by_style[s] < reference[s]) for s in by_style]))
            row["recognised"].append(average([recognised(run, bank, recogniser) for bank in banks]))
    return list(rows.values())


def _banks(run: Run, train: Features, progress: bool) -> dict[str, list[StyleBank]]:
    whole = make_bank(run.model, train)
    single = []
    for place in range(ONE_CLIP):
        clips = {s: y[(len(y) * (2 * place + 1) // (2 * ONE_CLIP))][None]
                 for s, y in train.clips.items()}
        vectors = torch.stack([run.model.style_vector(clips[s]) for s in whole.names])
        single.append(StyleBank(whole.names, vectors, whole.speeds))
    names = whole.names
    shifted = StyleBank(names, whole.vectors.roll(1, 0), whole.speeds)
    return {"mean of all clips": [whole], "mean of 50 clips": [make_bank(run.model, train, 50)],
            "one clip": single,
            "fitted to frames": [refit(run.model, whole, train, progress=progress)],
            "another style's": [shifted]}


def recognised(run: Run, bank: StyleBank, recogniser: Recogniser) -> float:
    """Share of the styles that a recogniser names rightly in a straight walk at the style's natural
    speed.
    """
    velocity = torch.tensor([[0.0, bank.speed(style)] for style in bank.names])
    commands, warm = [Command(velocity)] * round((WARM_UP + SECONDS) * FPS), round(WARM_UP * FPS)
    joints = torch.stack([s.joints for s in states(run.model, commands, bank.vectors)[warm:]],
                         1).nan_to_num()
    right = torch.tensor([recogniser.styles.index(style) for style in bank.names])
    return float((recogniser.probabilities(joints).argmax(-1) == right).float().mean())
