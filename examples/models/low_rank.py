"""Low-rank adapters on a style encoder, as a style modulation of the paper's network."""

import torch
import torch.nn.functional as F
from torch import nn

import toolkit as tk


class LowRank(nn.Module):
    """h = ELU(LN(F + U (c ∘ V x)) + β): each style has its own c and β; all share U and V.

    `generator` makes style vectors (c and β of both layers) of style clips.
    """

    def __init__(self, layout, hidden, rank=32):
        super().__init__()
        self.widths, self.size = (rank, hidden), 2 * (rank + hidden)
        self.down = nn.ModuleList(nn.Linear(n, rank, bias=False) for n in (layout.n_inputs, hidden))
        self.up = nn.ModuleList(nn.Linear(rank, hidden, bias=False) for _ in range(2))
        self.generator = Statistics(nn.Linear(2 * layout.n_clip, 128), nn.ELU(),
                                    nn.Linear(128, self.size))

    def forward(self, layer, f, style, x, gates):
        """Activation ``[B, hidden]`` of a layer, from its value ``f`` and its inputs ``x``."""
        strength, shift = style.chunk(2, -1)[layer].split(self.widths, -1)
        adapted = self.up[layer](strength * self.down[layer](x))
        return F.elu(tk.networks.layer_norm(f + adapted) + shift)


class Statistics(nn.Sequential):
    """Style vectors ``[M, D]`` from the means and deviations of clips ``[M, 240, 12 J]``."""

    def forward(self, clips):
        """Dense layers on the mean and the deviation over time."""
        return super().forward(torch.cat((clips.mean(1), clips.std(1)), -1))


@tk.networks.register("low-rank")
def low_rank(layout, n_styles, sizes):
    """LPN-FiLM with another modulation in the place of FiLM."""
    model = tk.networks.build("lpn-film", layout, n_styles, sizes, generator=False)
    model.modulation = LowRank(layout, sizes.hidden)
    return model
