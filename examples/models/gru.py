"""A recurrent model without phases: a GRU reads the last ten frames and this one."""

import torch
from torch import nn

import toolkit as tk


@tk.networks.register("gru")
class Recurrent(tk.networks.Predictor):
    """ẑ of the GRU's last state; a learned vector for each style stands beside each frame."""

    phase, memory = "none", 10

    def __init__(self, layout, n_styles, sizes):
        super().__init__(layout, n_styles, sizes)
        self.style_size = 32
        self.styles = nn.Embedding(n_styles, self.style_size)
        self.read = nn.Linear(self.layout.n_inputs + self.style_size, sizes.hidden)
        self.cell = nn.GRUCell(sizes.hidden, sizes.hidden)
        self.out = nn.Linear(sizes.hidden, self.layout.n_outputs)

    def encode(self, clips, style=None):
        """The learned vector ``[1, D]`` of a style's number."""
        return self.styles.weight[style][None]

    def forward(self, x, phases, style):
        """``x [B, 11, Dx]``; this model has no phases."""
        style, state = style.expand(x.shape[0], -1), None
        for frame in x.unbind(1):
            state = self.cell(torch.relu(self.read(torch.cat((frame, style), -1))), state)
        return self.out(state)
