"""A small classifier of styles: has a model's motion the style that was asked for?

Its input is one second of joint features (`toolkit.features`, root frame, physical units). They
show pose, tempo and the coordination of the limbs, but not the path.
"""

import os

import torch
import torch.nn.functional as F
from torch import Tensor, nn

from toolkit import features
from toolkit.features import CHANNELS, Features, Normaliser, splits
from toolkit.io import model_files
from toolkit.motion import Clip, root_frames, trajectory
from toolkit.motion.tensors import summary
from toolkit.motion.text import checked

WINDOW = 60  # frames of an input, one second
HOP = 15  # frames between the windows of a longer motion
HIDDEN = 64  # filters of each convolution
STEPS, BATCH, RATE = 200, 128, 2e-3
OFFSET, JITTER = 0.3, 0.1  # augmentation: standard deviations of noise per window, per frame
DROPPED = 0.2  # augmentation: share of columns set to their mean
LEAST = 0.2  # least deviation of a column as a share of the mean deviation of its channel


class Recogniser(nn.Module):
    """Probabilities of S styles from 12 J joint features; `train` makes one.

    Two strided convolutions over time, their mean and maximum over time, and one dense layer.
    """

    def __init__(self, styles: tuple[str, ...], normaliser: Normaliser):
        super().__init__()
        self.styles = checked(styles, "a style")
        self.register_buffer("mean", normaliser.mean.float())
        self.register_buffer("std", normaliser.std.float())
        self.first = nn.Conv1d(len(normaliser.mean), HIDDEN, 8, stride=4)
        self.second = nn.Conv1d(HIDDEN, HIDDEN, 5, stride=2)
        self.out = nn.Linear(2 * HIDDEN, len(self.styles))

    def __repr__(self) -> str:
        return summary(self, {"styles": self.styles})

    def forward(self, windows: Tensor) -> Tensor:
        """Logits ``[B, S]`` of normalised ``windows [B, WINDOW, 12 J]``."""
        return self.out(self.hidden_features(windows))

    def hidden_features(self, windows: Tensor) -> Tensor:
        """Input ``[B, 2 HIDDEN]`` of the last layer."""
        h = F.elu(self.second(F.elu(self.first(windows.transpose(1, 2)))))
        return torch.cat((h.mean(-1), h.amax(-1)), -1)

    @torch.no_grad()
    def probabilities(self, joints: Tensor) -> Tensor:
        """Probability ``[..., S]`` of each style: the mean over windows, `HOP` frames apart.

        ``joints [..., F, 12 J]`` are joint features in the root frame, physical units, at 60 Hz.
        ValueError if F is less than `WINDOW`, or the number of columns is not that of training.
        """
        windows = self._windows(joints)
        logits = self(windows.flatten(0, -3))
        return torch.softmax(logits, -1).unflatten(0, windows.shape[:-2]).mean(-2)

    def _windows(self, joints: Tensor) -> Tensor:
        """Normalised windows ``[..., W, WINDOW, 12 J]`` of joint features ``[..., F, 12 J]``."""
        columns = len(self.mean)
        if joints.dim() < 2 or joints.shape[-2] < WINDOW or joints.shape[-1] != columns:
            raise ValueError(f"a style is recognised from [..., F, {columns}] with at least "
                             f"{WINDOW} frames F, got {list(joints.shape)}")
        windows = joints.unfold(-2, WINDOW, HOP).transpose(-1, -2).to(self.mean)
        return (windows - self.mean) / self.std

    def of_clip(self, clip: Clip) -> Tensor:
        """Probability ``[S]`` of each style for a clip of at least one second."""
        return self.probabilities(_joints(clip))

    @torch.no_grad()
    def embed(self, clip: Clip) -> Tensor:
        """`hidden_features` ``[W, 2 HIDDEN]`` of the W windows of a clip of at least one second."""
        return self.hidden_features(self._windows(_joints(clip)))

    def accuracy(self, data: Features) -> float:
        """Share of the style clips in ``data`` that are recognised, mean over the styles."""
        right = [(self.probabilities(data.clips[style][:]).argmax(-1) == i).float().mean()
                 for i, style in enumerate(self.styles)]
        return float(torch.stack(right).mean())

    def save(self, path: str | os.PathLike) -> None:
        """Write to a safetensors file."""
        tensors = {f"recogniser.{name}": value for name, value in self.state_dict().items()}
        model_files.write(path, tensors, {"recogniser": {"styles": self.styles}})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Recogniser":
        """Read a file of `save`; ValueError for any other file."""
        tensors, parts = model_files.read(path, "recogniser")
        with model_files.intact(path, "the recogniser"):
            normaliser = Normaliser(tensors["recogniser.mean"], tensors["recogniser.std"])
            return model_files.restore(
                lambda: cls(parts["recogniser"]["styles"], normaliser), tensors, "recogniser.")


def train(data: Features, seed: int = 0, steps: int = STEPS) -> Recogniser:
    """Train a recogniser of the styles in ``data`` on its style clips, in some seconds on one core.

    It is used on the poses of models, which are smoother than the data's and have a small offset.
    Therefore a nearly constant column is not scaled to unit deviation, and training adds offsets
    and noise to the windows and drops columns. The same seed gives the same recogniser; ``steps``
    is the number of minibatches. ValueError if there are fewer than two styles.
    """
    if len(data.styles) < 2:
        raise ValueError(f"a recogniser needs at least two styles, got {', '.join(data.styles)}")
    draw, normaliser = splits.generator(seed), data.normalisers()["clips"]
    std = normaliser.std.unflatten(0, (-1, len(CHANNELS), 3))
    std = std.maximum(LEAST * std.mean((0, 2), keepdim=True)).flatten()
    with splits.seeded("cpu", seed):
        model = Recogniser(tuple(data.styles), Normaliser(normaliser.mean, std))
    adam = torch.optim.Adam(model.parameters(), lr=RATE, weight_decay=1e-4, fused=True)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(adam, steps)
    for _ in range(steps):
        labels = torch.randint(len(data.styles), (BATCH,), generator=draw)
        drawn = []
        for label in labels:
            clips = data.clips[data.styles[label]]
            which = int(torch.randint(len(clips), (), generator=draw))
            where = int(torch.randint(features.CLIP_FRAMES - WINDOW + 1, (), generator=draw))
            drawn.append(clips[which][where : where + WINDOW])
        windows = (torch.stack(drawn).to(model.mean) - model.mean) / model.std
        columns = (BATCH, 1, windows.shape[-1])
        # what models do to poses: an offset, noise; and no column may decide alone
        windows = windows + OFFSET * torch.randn(columns, generator=draw)
        windows = windows + JITTER * torch.randn(windows.shape, generator=draw)
        windows = windows * (torch.rand(columns, generator=draw) > DROPPED)
        loss = F.cross_entropy(model(windows), labels)
        adam.zero_grad(set_to_none=True)
        loss.backward()
        adam.step()
        schedule.step()
    return model.eval()


def _joints(clip: Clip) -> Tensor:
    clip = clip.resample(trajectory.FPS)
    return features.joint_features(clip, root_frames(clip))
