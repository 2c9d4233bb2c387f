"""A codebook: the next frame is decoded from eight learned codes (van den Oord et al. 2017)."""

import torch
from torch import nn

import toolkit as tk

GROUPS, CODES, WIDTH = 8, 64, 16  # codes of a frame, codes to choose from, numbers of a code
COMMITMENT = 0.25  # weight of the distance of the encoder from its codes, as in the paper


def layers(n_in, hidden, n_out):
    """Two dense layers; the normalisation between them keeps walks in closed loop bounded."""
    return nn.Sequential(nn.Linear(n_in, hidden), nn.LayerNorm(hidden), nn.ELU(),
                         nn.Linear(hidden, n_out))


@tk.networks.register("vq-codebook")
class Codebook(tk.networks.Predictor):
    """The encoder sees frame, phases and style, the decoder only the codes and the frame."""

    def __init__(self, layout, n_styles, sizes):
        super().__init__(layout, n_styles, sizes)
        self.style_size, inputs = 32, self.layout.n_inputs
        self.styles = nn.Embedding(n_styles, self.style_size)
        given = inputs + self.layout.n_phases + self.style_size
        self.encoder = layers(given, sizes.hidden, GROUPS * WIDTH)
        self.codes = nn.Parameter(torch.randn(GROUPS, CODES, WIDTH))
        self.decoder = layers(inputs + GROUPS * WIDTH, sizes.hidden, self.layout.n_outputs)

    def encode(self, clips, style=None):
        """The learned vector ``[1, D]`` of a style's number."""
        return self.styles.weight[style][None]

    def decoded(self, x, phases, style):
        """Output frames ``[B, Dz]``; the encoder's values and the nearest codes, ``[B, G, W]``."""
        given = torch.cat((x, phases, style.expand(x.shape[0], -1)), -1)
        values = self.encoder(given).unflatten(1, (GROUPS, WIDTH))
        distances = (values[:, :, None] - self.codes).square().sum(-1)
        chosen = self.codes[torch.arange(GROUPS), distances.argmin(-1)]
        passed = values + (chosen - values).detach()  # the gradient of the codes goes to the values
        return self.decoder(torch.cat((x, passed.flatten(1)), -1)), values, chosen

    def forward(self, x, phases, style):
        """Normalised output frames."""
        return self.decoded(x, phases, style)[0]

    def loss(self, x, phases, z, style):
        """Squared error, and the distance of codes and values, each drawn to the other."""
        made, values, chosen = self.decoded(x, phases, style)
        apart = (chosen - values.detach()).square().mean()
        return ((made - z).square().mean() + apart
                + COMMITMENT * (chosen.detach() - values).square().mean())
