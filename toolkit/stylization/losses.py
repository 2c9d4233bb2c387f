"""The losses of Park et al. 2021 (section 6.2), each a mean over the batch and over a motion's or a code's numbers.

Where the paper writes a norm, these losses take a mean: of squares for the two content losses, of magnitudes for L1. So they
do not depend on the numbers of frames and joints, and are comparable with weights of 1.
"""

import torch
from torch import Tensor
from torch.nn import functional

LOSSES = ("adv", "cyc", "id", "sty", "ds")  # equations 7 to 11
DIVERSE = 0.5  # bound of the diversity loss, standard deviations of the data


def discriminator(real: Tensor, fake: Tensor) -> Tensor:
    """Adversarial loss of D (equation 7): binary cross-entropy of its logits ``[B]`` on real and on restyled motions."""
    return functional.softplus(-real).mean() + functional.softplus(fake).mean()


def adversarial(fake: Tensor) -> Tensor:
    """Adversarial loss of G: −log D of its motions, whose gradient does not vanish where D is right."""
    return functional.softplus(-fake).mean()


def r1(real: Tensor, x: Tensor) -> Tensor:
    """R1 regularisation of D: half the squared gradient of its logits ``real [B]`` by the real motions ``x``, per motion.

    The paper's equations do not have it; the published code does.
    """
    (slope,) = torch.autograd.grad(real.sum(), x, create_graph=True)
    return slope.square().flatten(1).sum(1).mean() / 2


def content(x: Tensor, rebuilt: Tensor) -> Tensor:
    """Cycle and identity loss (equations 8 and 9): mean squared difference of z-scores ``[B, 7, T, N]``."""
    return functional.mse_loss(rebuilt, x)


def style(code: Tensor, found: Tensor) -> Tensor:
    """Style reconstruction loss (equation 10): mean distance of the target codes and the codes found, ``[B, S]``."""
    return functional.l1_loss(found, code)


def diversity(first: Tensor, second: Tensor) -> Tensor:
    """Diversity-sensitive loss (equation 11), to be maximised: mean difference of a motion's results with two codes.

    Departure from equation 11: the term of a motion is at most `DIVERSE`, as in Yang et al. 2019, who introduced this loss.
    Without the bound it exceeds the adversarial loss in short runs, and the results diverge.
    """
    return (first - second).abs().mean((1, 2, 3)).clamp(max=DIVERSE).mean()
