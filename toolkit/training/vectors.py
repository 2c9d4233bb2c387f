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

STEPS, BATCH, RATE = 30, 64, 0.06  # steps per style, frames of a step, first rate in deviations of the bank's vectors


def refit(model: Model, bank: StyleBank, data: Features, steps: int = STEPS, seed: int = 0, pose_mixup: float = 0.3,
          progress: bool = False) -> StyleBank:
    """A bank whose vectors have less error on the frames of their styles; the model stays as it is.

    Ours. The paper takes the mean of the vectors of a style's clips (section 4.4), which were never trained as such. From
    there on, Adam minimises the mean squared error of the normalised outputs over the frames of ``data``, whose styles the
    bank has. ``steps`` is the number of steps for each style; ``pose_mixup`` is that of `Minibatches`.
    """
    batches, device = Minibatches(data, BATCH, 1, seed, pose_mixup), model.outputs_mean.device
    scale = float(bank.vectors.std(0).mean()) if len(bank) > 1 else 1.0
    vectors = bank.vectors.clone()
    for which, style in enumerate(progress_bar(batches.styles, desc="vectors", unit="style", show=progress)):
        vector = bank[style].clone().to(device).requires_grad_()
        adam = torch.optim.Adam([vector], fused=True)
        for turn in range(steps):
            x, p, z, y = (rows.to(device) for rows in batches[turn * len(batches.styles) + which])
            x, p, z, _ = (model.normaliser(kind).apply(rows) for kind, rows in
                          zip(KINDS, (x, *model.observe(p, z), y), strict=True))
            adam.param_groups[0]["lr"] = scale * RATE * (1 + math.cos(math.pi * turn / steps)) / 2
            with evaluating(model), torch.enable_grad():
                (vector.grad,) = torch.autograd.grad((model(x, p, vector[None]) - z).square().mean(), vector)
            adam.step()
        vectors[bank.names.index(style)] = vector.detach().cpu()
    return dataclasses.replace(bank, vectors=vectors)
