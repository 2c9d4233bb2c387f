"""Style vectors fitted to frames: gradient descent on the vectors alone, with a finished model."""

import dataclasses
import math

import torch

from toolkit.features import KINDS, Features
from toolkit.io.progress import progress_bar
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.networks.model import evaluating
from toolkit.training.minibatches import Minibatches

STEPS, BATCH, RATE = 100, 128, 0.02  # steps per style, frames of a step, first rate in deviations of the bank's vectors


def refit(model: Model, bank: StyleBank, data: Features, steps: int = STEPS, seed: int = 0, pose_mixup: float = 0.3,
          progress: bool = False) -> StyleBank:
    """A bank whose vectors have less error on the frames of their styles; the model stays as it is.

    Ours. The paper takes the mean of the vectors of a style's clips (section 4.4), which were never trained as such. From
    there on, Adam minimises the mean squared error of the normalised outputs over the frames of ``data``, whose styles the
    bank has. ``steps`` is the number of steps for each style; ``pose_mixup`` is that of `Minibatches`.
    """
    batches = Minibatches(data, BATCH, 1, seed, pose_mixup)
    scale = bank.vectors.std(0).mean() if len(bank) > 1 else torch.tensor(1.0)
    learnt = {style: bank[style].clone().requires_grad_() for style in batches.styles}
    adams = {style: torch.optim.Adam([vector], fused=True) for style, vector in learnt.items()}
    frozen = [parameter for parameter in model.parameters() if parameter.requires_grad]
    with evaluating(model), torch.enable_grad():
        for parameter in frozen:
            parameter.requires_grad_(False)
        try:
            for step in progress_bar(range(steps * len(learnt)), desc="vectors", unit="step", show=progress):
                turn, which = divmod(step, len(learnt))
                style = batches.styles[which]
                x, p, z, y = batches[step]
                x, p, z, _ = (model.normaliser(kind).apply(rows) for kind, rows in
                              zip(KINDS, (x, *model.observe(p, z), y), strict=True))
                adams[style].param_groups[0]["lr"] = float(scale) * RATE * (1 + math.cos(math.pi * turn / steps)) / 2
                loss = (model(x, p, learnt[style][None]) - z).square().mean()
                (learnt[style].grad,) = torch.autograd.grad(loss, learnt[style])
                adams[style].step()
        finally:
            for parameter in frozen:
                parameter.requires_grad_(True)
    vectors = torch.stack([learnt[name].detach() if name in learnt else bank[name] for name in bank.names])
    return dataclasses.replace(bank, vectors=vectors)
