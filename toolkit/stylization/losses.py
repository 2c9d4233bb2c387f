"""The losses of Park et al. 2021 (section 6.2).

Where the paper writes a norm over a motion, these losses take a mean: for the two content losses of
the norms of single joints, for L1 of magnitudes. So they do not depend on the numbers of frames and
joints.
"""

import torch
from torch import Tensor
from torch.nn import functional

LOSSES = ("adv", "cyc", "id", "sty", "ds")  # equations 7 to 11
DIVERSE = 0.5  # bound of the diversity loss, standard deviations of the data


def discriminator(real: Tensor, fake: Tensor) -> Tensor:
    """Adversarial loss of D (equation 7): cross-entropy of real and of restyled logits."""
    return functional.softplus(-real).mean() + functional.softplus(fake).mean()


def adversarial(fake: Tensor) -> Tensor:
    """Adversarial loss of G: −log D, whose gradient does not vanish where D is right."""
    return functional.softplus(-fake).mean()


def r1(real: Tensor, x: Tensor) -> Tensor:
    """R1 regularisation of D: half the squared gradient of its logits ``real`` by motions ``x``.

    The paper's equations do not have it; the published code does.
    """
    (slope,) = torch.autograd.grad(real.sum(), x, create_graph=True)
    return slope.square().flatten(1).sum(1).mean() / 2


def content(x: Tensor, rebuilt: Tensor) -> Tensor:
    """Cycle and identity loss (equations 8 and 9) of z-scores, as in the published code.

    The mean norm of a joint's seven differences in a frame. The gradient of a norm, unlike that of
    its square, does not vanish as the difference becomes small.
    """
    return (rebuilt - x).square().sum(1).add(1e-8).sqrt().mean()


def style(code: Tensor, found: Tensor) -> Tensor:
    """Style reconstruction loss (equation 10): mean distance of target codes and codes found."""
    return functional.l1_loss(found, code)


def diversity(first: Tensor, second: Tensor) -> Tensor:
    """Diversity-sensitive loss (equation 11), to be maximised: difference of two results.

    Departure: the term of a motion is at most `DIVERSE`, as in Yang et al. 2019,
    who introduced this loss. Without the bound it exceeds the adversarial loss in short runs, and
    the results diverge.
    """
    return (first - second).abs().mean((1, 2, 3)).clamp(max=DIVERSE).mean()
