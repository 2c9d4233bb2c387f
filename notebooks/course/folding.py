"""FiLM as a change of a layer's weights (Mason et al. 2022, section 5.3.1)."""

from torch import Tensor

from toolkit.networks.film import EPSILON


def fold(weight: Tensor, bias: Tensor, gamma: Tensor, beta: Tensor,
         deviation: Tensor | None = None) -> tuple[Tensor, Tensor]:
    """A style folded into a layer's own weights (section 5.3.1, equation 6).

    Without ``deviation`` it is the paper's equation, which omits layer normalisation: x W' + b' = γ
    ∘ (x W + b) + β for every x. With it x W' + b' = γ ∘ LN(x W + b) + β, but only for inputs whose
    F = x W + b has this deviation. To subtract the mean is linear, so it folds for all inputs; to
    divide by the deviation is not. So a style is equivalent to new weights, except for one factor
    per layer and frame.

    Parameters
    ----------
    weight : Tensor [..., n_in, n_out]
        Of a layer x W + b; for gated experts, the blended weights.
    bias : Tensor [..., n_out]
        b.
    gamma, beta : Tensor [n_out]
        Scale and shift of the layer.
    deviation : Tensor [...]
        Unbiased standard deviation of F.

    Returns
    -------
    tuple of Tensor [..., n_in, n_out] and [..., n_out]
        W' and b'.
    """
    if deviation is not None:
        weight, bias = weight - weight.mean(-1, keepdim=True), bias - bias.mean(-1, keepdim=True)
        gamma = gamma / (deviation[..., None] + EPSILON)
    return weight * gamma[..., None, :], bias * gamma + beta
