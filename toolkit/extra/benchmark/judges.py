"""Two judges of style of different architecture, trained on disjoint recorded takes.

``python -m experiments stylewalk`` trains them.
"""

import os
from collections.abc import Sequence
from pathlib import Path

import torch
from torch import Tensor, nn

from toolkit.evaluation.findings import ROLES
from toolkit.evaluation.metrics.quality import facing
from toolkit.io import model_files
from toolkit.motion import Clip
from toolkit.motion.text import checked

FPS, WINDOW, HOP = 30.0, 30, 10  # of what a judge sees: frames a second, of a window, between two
CHANNELS = 3 * len(ROLES) + 2
WIDTH = 24  # of the layers, and of the features whose Fréchet distance is measured
#: The embedded judges lie in a checkout, since their licence (CC BY-NC 4.0) is not the package's.
FILE = Path(__file__).parents[3] / "examples" / "models" / "stylewalk.safetensors"


class Convolution(nn.Module):
    """Two convolutions over time, and the mean of their output."""

    def __init__(self, styles: int):
        super().__init__()
        self.first = nn.Conv1d(CHANNELS, WIDTH, 5, stride=2)
        self.second = nn.Conv1d(WIDTH, WIDTH, 5, stride=2)
        self.out = nn.Linear(WIDTH, styles)

    def features(self, windows: Tensor) -> Tensor:
        """Features ``[B, WIDTH]`` of ``[B, WINDOW, CHANNELS]``."""
        h = torch.relu(self.first(windows.transpose(1, 2)))
        return torch.relu(self.second(h)).mean(-1)


class Recurrence(nn.Module):
    """A gated recurrent unit, and its last state."""

    def __init__(self, styles: int):
        super().__init__()
        self.unit = nn.GRU(CHANNELS, WIDTH, batch_first=True)
        self.out = nn.Linear(WIDTH, styles)

    def features(self, windows: Tensor) -> Tensor:
        """Features ``[B, WIDTH]`` of ``[B, WINDOW, CHANNELS]``."""
        return self.unit(windows)[1][0]


KINDS = {"convolution": Convolution, "recurrence": Recurrence}


class Judges(nn.Module):
    """Both judges, with the features of recorded windows that neither was trained on."""

    def __init__(self, styles: Sequence[str], reference: int):
        super().__init__()
        self.styles = checked(styles, "a style")
        self.register_buffer("mean", torch.zeros(CHANNELS))
        self.register_buffer("std", torch.ones(CHANNELS))
        self.judges = nn.ModuleDict({name: kind(len(styles)) for name, kind in KINDS.items()})
        for name in KINDS:
            self.register_buffer(f"reference_{name}", torch.zeros(reference, WIDTH))

    @torch.no_grad()
    def features(self, name: str, clip: Clip) -> Tensor:
        """Features ``[W, WIDTH]`` of a clip's windows by a judge."""
        return self.judges[name].features((windows(clip) - self.mean) / self.std)

    @torch.no_grad()
    def style(self, name: str, clip: Clip) -> str:
        """The most probable style of a clip."""
        chances = self.judges[name].out(self.features(name, clip)).softmax(-1).mean(0)
        return self.styles[int(chances.argmax())]

    def reference(self, name: str) -> Tensor:
        """Features ``[R, WIDTH]`` of recorded windows."""
        return getattr(self, f"reference_{name}")

    def save(self, path: str | os.PathLike) -> None:
        """Write a safetensors file."""
        tensors = {f"judges.{name}": value for name, value in self.state_dict().items()}
        about = {"styles": self.styles, "reference": len(self.reference("recurrence"))}
        model_files.write(path, tensors, {"judges": about})

    @classmethod
    def load(cls, path: str | os.PathLike | None = None) -> "Judges":
        """Read a file, by default that of the checkout; ValueError if it is missing or other."""
        path = FILE if path is None else Path(path)
        if not path.exists():
            raise ValueError(f"{path}: no such file; the judges are in the repository, not in the "
                             "installed package (CC BY-NC 4.0): give --judges FILE")
        tensors, parts = model_files.read(path, "judges")
        with model_files.intact(path, "the judges"):
            about = parts["judges"]
            return model_files.restore(lambda: cls(about["styles"], about["reference"]), tensors,
                                       "judges.")


def windows(clip: Clip) -> Tensor:
    """What a judge sees, ``[W, WINDOW, CHANNELS]``: at `FPS`, in the directions of the hips.

    Places of the joints from the hips, the height of the hips and their velocity, in lengths of the
    leg, so that skeletons of any size and layout are judged. ValueError below a second.
    """
    clip = clip.resample(FPS)
    if len(clip) <= WINDOW:
        raise ValueError(f"{clip.name}: a judge needs more than a second, "
                         f"the clip lasts {clip.seconds:.2f} s")
    p, skeleton = clip.global_positions.double(), clip.skeleton
    at = [skeleton.role(role) for role in ROLES]
    hips, knee, foot = (p[:, skeleton.role(role)] for role in ("left_hip", "left_knee",
                                                               "left_foot"))
    leg = ((hips - knee).norm(dim=-1) + (knee - foot).norm(dim=-1)).mean()
    floor = p[:, at, 1].amin(1).quantile(0.05)
    places = p[:, at] - p[:, at[:1]]
    places[:, 0, 1] = p[:, at[0], 1] - floor
    velocity = p[:, at[:1]].diff(dim=0, prepend=p[:1, at[:1]]) * FPS
    seen = (facing(clip, places).flatten(1), facing(clip, velocity)[:, 0, [0, 2]])
    return (torch.cat(seen, 1)[1:] / leg).float().unfold(0, WINDOW, HOP).transpose(1, 2)
