"""The losses of Park et al. 2021 (section 6.2), each a mean over the batch and over a motion's or a code's numbers.

Where the paper writes a norm, ours is the mean: of squares for the two content losses, of magnitudes for L1. So the numbers
do not depend on batch, frames or joints, and weights of 1 make them comparable.
"""

import torch
from torch import Tensor
from torch.nn import functional

LOSSES = ("adv", "cyc", "id", "sty", "ds")  # equations 7 to 11
DIVERSE = 0.5  # deviations of the data


def discriminator(real: Tensor, fake: Tensor) -> Tensor:
    """Adversarial loss of D (equation 7): binary cross-entropy of its logits ``[B]`` on real and on restyled motions."""
    return functional.softplus(-real).mean() + functional.softplus(fake).mean()


def adversarial(fake: Tensor) -> Tensor:
    """Adversarial loss of G: how sure D is that its motions are not real; −log D, which does not fade where D is right."""
    return functional.softplus(-fake).mean()


def r1(real: Tensor, x: Tensor) -> Tensor:
    """R1 of D: half the squared gradient of its logits ``real [B]`` by the real motions ``x``, summed over each motion.

    Not in the paper's equations; the published code has it.
    """
    (slope,) = torch.autograd.grad(real.sum(), x, create_graph=True)
    return slope.square().flatten(1).sum(1).mean() / 2


def content(x: Tensor, rebuilt: Tensor) -> Tensor:
    """Cycle and identity loss (equations 8 and 9): mean squared difference of z-scores ``[B, 7, T, N]``."""
    return functional.mse_loss(rebuilt, x)


def style(code: Tensor, found: Tensor) -> Tensor:
    """Style reconstruction loss (equation 10): mean distance of the code asked for and the code found, ``[B, S]``."""
    return functional.l1_loss(found, code)


def diversity(first: Tensor, second: Tensor) -> Tensor:
    """Diversity-sensitive loss (equation 11), to be maximised: mean difference of what two codes make of a motion.

    Departure from equation 11: a motion counts at most `DIVERSE`, the bound that the loss had where it comes from (Yang et
    al. 2019). Without, over short runs, it wins over the adversarial loss and drives motions apart without end.
    """
    return (first - second).abs().mean((1, 2, 3)).clamp(max=DIVERSE).mean()
