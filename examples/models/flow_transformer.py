"""Flow matching (Lipman et al. 2023): a transformer that sees a history of ten frames."""

import torch
from torch import nn

import toolkit as tk

STEPS = 4  # of the path from noise to the next frame


@tk.networks.register("flow-transformer")
class FlowTransformer(tk.networks.Predictor):
    """The network learns the velocity of straight paths from noise to the next frame."""

    memory = 10

    def __init__(self, layout, n_styles, sizes):
        super().__init__(layout, n_styles, sizes)
        width, outputs = sizes.hidden, self.layout.n_outputs
        self.style_size = 64
        self.encoder = nn.Sequential(nn.Linear(2 * self.layout.n_clip, 128), nn.ELU(),
                                     nn.Linear(128, self.style_size))
        self.frames = nn.Linear(self.layout.n_inputs, width)
        given = outputs + self.layout.n_phases + self.style_size + 1
        self.query = nn.Sequential(nn.Linear(given, width), nn.ELU(), nn.Linear(width, width))
        self.places = nn.Parameter(0.02 * torch.randn(self.memory + 2, width))
        layer = nn.TransformerEncoderLayer(width, 4, 2 * width, sizes.dropout, batch_first=True,
                                           norm_first=True)
        self.body = nn.TransformerEncoder(layer, 2, enable_nested_tensor=False)
        self.out = nn.Linear(width, outputs)

    def encode(self, clips, style=None):
        """Style vectors ``[M, D]`` of the mean and the deviation of each column of a clip."""
        return self.encoder(torch.cat((clips.mean(1), clips.std(1)), -1))

    def velocity(self, z, time, x, phases, style):
        """Velocity ``[B, Dz]`` of the path at ``z [B, Dz]`` and ``time [B, 1]`` in [0, 1]."""
        query = self.query(torch.cat((z, phases, style.expand(x.shape[0], -1), time), -1))
        tokens = torch.cat((self.frames(x), query[:, None]), 1) + self.places
        return self.out(self.body(tokens)[:, -1])

    def forward(self, x, phases, style):
        """The path that begins in the mean of the noise: one answer to one input."""
        z = torch.zeros_like(x[:, 0, :1]).expand(-1, self.layout.n_outputs)
        for step in range(STEPS):
            time = torch.full_like(x[:, 0, :1], step / STEPS)
            z = z + self.velocity(z, time, x, phases, style) / STEPS
        return z

    def loss(self, x, phases, z, style):
        """Squared error of the velocity at a random time of a path from random noise."""
        noise, time = torch.randn_like(z), torch.rand_like(z[:, :1])
        velocity = self.velocity(torch.lerp(noise, z, time), time, x, phases, style)
        return (velocity - (z - noise)).square().mean()
