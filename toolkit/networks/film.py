"""Style as feature-wise linear modulation (FiLM; Mason et al. 2022, section 4.2): a clip of motion to scales and shifts."""

import torch
import torch.nn.functional as F
from torch import Tensor, nn


def layer_norm(f: Tensor, epsilon: float = 1e-6) -> Tensor:
    """``f`` with mean 0 and (unbiased) standard deviation 1 over its last axis; nothing learnt (equation 3)."""
    centred = f - f.mean(-1, keepdim=True)
    return centred / (f.std(-1, keepdim=True) + epsilon)


class Film(nn.Module):
    """Modulation of hidden layers by a style vector (γ1, β1, γ2, β2), each as wide as a hidden layer.

    Parameters
    ----------
    hidden
        Units of a hidden layer.
    generator
        The network Ψ that makes style vectors of clips (equation 2); none where vectors are all that is left of it.
    """

    def __init__(self, hidden: int, generator: "FilmGenerator | None"):
        super().__init__()
        self.hidden, self.generator = hidden, generator

    @property
    def size(self) -> int:
        """Length of a style vector: the numbers a style costs at run time (Table 2, P.S.R.)."""
        return 4 * self.hidden

    def forward(self, layer: int, f: Tensor, style: Tensor) -> Tensor:
        """h = ELU(γ ∘ LN(F) + β) (equation 3) of hidden layer 0 or 1.

        ``f [B, hidden]``; ``style [B, 4 hidden]``, or ``[1, 4 hidden]`` or ``[4 hidden]`` for one style in the whole batch.
        """
        gamma, beta = style[..., 2 * layer * self.hidden : 2 * (layer + 1) * self.hidden].chunk(2, -1)
        return F.elu(gamma * layer_norm(f) + beta)


class FilmGenerator(nn.Module):
    """The FiLM generator Ψ (equation 2): two convolutions over time, each with max-pooling, and two dense layers.

    The paper prints 35,668,530 parameters for it; that is this network with its convolutions counted without their input
    channels. It has 39,214,592 at the paper's sizes.

    Departure from the paper, which uses γ raw and does not say how it starts: the last layer's bias starts at γ = 1, β = 0,
    so that training starts from plain layer normalisation and not from hidden layers that are almost zero.

    Parameters
    ----------
    n_in
        Columns of one frame of a style clip (12 J).
    frames
        Frames of a style clip.
    hidden
        Units of the hidden layers that the style vectors modulate.
    channels, kernel
        Filters of both convolutions, and their width in frames.
    dense
        Units of the first dense layer.
    dropout
        Share of the first dense layer's outputs that training drops.
    """

    def __init__(self, n_in: int, frames: int, hidden: int, channels: int, kernel: int, dense: int, dropout: float):
        super().__init__()
        self.first = nn.Conv1d(n_in, channels, kernel, padding="same")
        self.second = nn.Conv1d(channels, channels, kernel, padding="same")
        self.dense = nn.Linear(frames // 2 // 2 * channels, dense)
        self.out = nn.Linear(dense, 4 * hidden)
        self.dropout = nn.Dropout(dropout)
        with torch.no_grad():
            self.out.bias.copy_(torch.tensor([1.0, 0.0, 1.0, 0.0]).repeat_interleave(hidden))

    def forward(self, clips: Tensor) -> Tensor:
        """Normalised ``clips [M, frames, n_in]`` to style vectors ``[M, 4 hidden]``."""
        h = F.max_pool1d(F.relu(self.first(clips.transpose(1, 2))), 2)
        h = F.max_pool1d(F.relu(self.second(h)), 2)
        h = h.transpose(1, 2).flatten(1)  # time-major, as in the published network
        return self.out(self.dropout(F.relu(self.dense(h))))
