"""A learned phase source: the periodic autoencoder of Starke et al. 2022 (DeepPhase), limb by limb.

The network encodes two seconds of a limb's motion as one latent curve, replaces this curve by a
sinusoid and reconstructs the motion from it. The phase of the sinusoid is the limb's phase. The
training uses no contacts and no forward direction.

>>> source = Learned.train(clips, seed=0)
>>> ph = tk.phases.extract(clip, source=source)   # or source="learned", for the packaged one

Departures from DeepPhase, which encodes a whole body in several channels: one limb and one channel
at a time, because a local phase belongs to a limb; every window is scaled to unit power, because a
hand in a pocket has a phase, too; 41 samples at 20 Hz span the two seconds instead of 121 at 60 Hz.
The frequency of the result is the derivative of the phase, with an error of at most 2 % for the
hands of cyclic styles. The network's own, a mean over few spectral bins, is off by 13 % there.

The packaged source (`pretrained`) was trained without the styles of `HELD_OUT`, by

>>> source = Learned.train(training_clips(), seed=0, progress=True)
>>> source.save("toolkit/extra/sources/learned.safetensors")
"""

import itertools
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources

import numpy as np
import scipy
import torch
from torch import Tensor, nn

from toolkit.datasets import procedural
from toolkit.io import model_files
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, root_frames
from toolkit.motion.clip import LIMBS, SIDES
from toolkit.motion.tensors import summary, through_numpy
from toolkit.phases.sinusoids import MAX_FREQUENCY, MIN_FREQUENCY, Sinusoids
from toolkit.phases.steps import limb_length
from toolkit.phases.windows import SECOND, mean

RATE = 20.0  # Hz, of the windows' samples
HALF = 20  # samples on either side of a frame: one second
SAMPLES = 2 * HALF + 1
PARTS = ("hand", "foot")
CURVES = 6  # per limb: velocities of its middle and its end joint
HIDDEN = 12  # channels of the layer before the latent curve
BATCH = 256  # windows in a minibatch
LEARNING_RATE = 3e-3  # the highest of a one-cycle schedule
CHUNK = 1024  # windows at a time
SPEEDS = (0.75, 1.0, 1.33)  # playback speeds of the training clips

#: Procedural styles for tests, which training does not use.
HELD_OUT = ("BigSteps", "DragRightLeg", "Drunk", "Old", "PendulumHands", "Strut")


class Convolution(nn.Module):
    """One-dimensional convolution with zero padding; its kernels are as long as the window.

    It is one product with the kernels' Toeplitz matrix, many times faster on a CPU than
    `nn.Conv1d`.
    """

    def __init__(self, inputs: int, outputs: int):
        super().__init__()
        bound = 1 / math.sqrt(inputs * SAMPLES)
        self.weight = nn.Parameter(torch.empty(inputs, outputs, SAMPLES).uniform_(-bound, bound))
        self.bias = nn.Parameter(torch.empty(outputs, 1).uniform_(-bound, bound))

    def forward(self, x: Tensor) -> Tensor:
        """Curves ``[B, inputs, T]`` → ``[B, outputs, T]``."""
        inputs, outputs, samples = self.weight.shape
        half = samples // 2
        # bands[i, o, s, t]: weight of sample s of input i in sample t of output o
        padded = nn.functional.pad(self.weight.flip(-1), (half, half))
        bands = padded.unfold(-1, samples, 1).flip(-2)
        matrix = bands.transpose(1, 2).reshape(inputs * samples, outputs * samples)
        return (x.flatten(1) @ matrix).view(-1, outputs, samples) + self.bias


class PeriodicAutoencoder(nn.Module):
    """Windows ``[B, 6, T]`` → latent curve → sinusoid → the windows again (DeepPhase, section 4).

    T is `SAMPLES`, also the length of the kernels, so each convolution covers the whole window.
    """

    def __init__(self):
        super().__init__()
        self.encoder = _two_convolutions(CURVES, 1)
        self.shift = nn.Sequential(nn.Linear(SAMPLES, 2), nn.BatchNorm1d(2))
        self.decoder = _two_convolutions(1, CURVES)
        time = (torch.arange(SAMPLES) - HALF) / RATE
        self.register_buffer("time", time, persistent=False)

    def sinusoid(self, windows: Tensor) -> tuple[Tensor, ...]:
        """Latent curve ``[B, T]``; phase in the middle, frequency, amplitude, offset ``[B]``."""
        latent = self.encoder(windows)[:, 0]
        y, x = self.shift(latent).unbind(-1)
        return latent, torch.atan2(y, x), *spectrum(latent)

    def wave(self, phase: Tensor, frequency: Tensor, amplitude: Tensor, offset: Tensor) -> Tensor:
        """Samples ``[B, T]`` of sinusoids over the window."""
        angle = 2 * torch.pi * frequency[:, None] * self.time + phase[:, None]
        return amplitude[:, None] * torch.sin(angle) + offset[:, None]

    def forward(self, windows: Tensor) -> Tensor:
        """The windows, reconstructed from their sinusoids."""
        _, *parameters = self.sinusoid(windows)
        return self.decoder(self.wave(*parameters)[:, None])


def _two_convolutions(inputs: int, outputs: int) -> nn.Sequential:
    return nn.Sequential(Convolution(inputs, HIDDEN), nn.LayerNorm(SAMPLES), nn.Tanh(),
                         Convolution(HIDDEN, outputs))


def spectrum(latent: Tensor) -> tuple[Tensor, Tensor, Tensor]:
    """Frequency, amplitude and offset of curves ``[..., T]``.

    The frequency is the mean, weighted by power; the amplitude is that of equal power.
    """
    bins = torch.fft.rfft(latent)
    power = bins[..., 1:].abs().square()
    frequencies = torch.fft.rfftfreq(SAMPLES, 1 / RATE, device=latent.device)[1:]
    total = power.sum(-1) + 1e-12
    frequency = (power * frequencies).sum(-1) / total
    return frequency, 2 * total.sqrt() / SAMPLES, bins[..., 0].real / SAMPLES


def limb_curves(clip: Clip, limb: str) -> Tensor:
    """Velocities ``[F, 6]`` of a limb's middle and end joint, in limb lengths per second.

    They are relative to the hips. Axes are those of the root frame: outwards (so that left and
    right limbs are alike), up, forward.
    """
    side, part = limb.split("_")
    skeleton, positions = clip.skeleton, clip.global_positions
    roles = ("elbow", "hand") if part == "hand" else ("knee", "toe")
    middle, end = (skeleton.role(f"{side}_{role}") for role in roles)
    reach = positions[:, [middle, end]] - positions[:, [skeleton.role("hips")]]
    local = root_frames(clip).turn_to_local(reach) / limb_length(skeleton, limb)
    if side == "right":
        local = torch.cat((-local[..., :1], local[..., 1:]), -1)
    return torch.gradient(local, spacing=1 / clip.fps, dim=0)[0].flatten(1)


def cut(curves: Tensor, fps: float, every: int = 1) -> Tensor:
    """Windows ``[N, C, T]`` around every n-th frame of curves ``[F, C]``: centred, of unit power.

    The curves are mirrored beyond their ends.
    """
    around = np.arange(-HALF, HALF + 1) / RATE
    times = np.arange(0, len(curves), every)[:, None] / fps + around
    last = (len(curves) - 1) / fps
    times = last - np.abs(last - np.abs(times))

    def sampled(values: np.ndarray) -> np.ndarray:
        return scipy.interpolate.CubicSpline(np.arange(len(values)) / fps, values)(times)

    found = through_numpy(sampled, curves).transpose(1, 2)
    found = found - found.mean(-1, keepdim=True)
    return found / found.square().mean((1, 2), keepdim=True).sqrt().clamp_min(1e-4)


@dataclass(frozen=True, eq=False)
class Learned:
    """A phase source: a network for both hands, one for both feet, factors of their latent curves.

    A factor gives the curves of the training clips unit power, like a normalised source. Its sign
    makes whole windows increase while the limb moves forward. The sign of single samples, which
    form the curve, follows for feet; for hands it is nearly arbitrary.
    """

    networks: dict[str, PeriodicAutoencoder]
    factors: dict[str, float]
    __repr__ = summary

    @classmethod
    def train(cls, clips: Sequence[Clip], *, steps: int = 3000, seed: int = 0,
              progress: bool = False) -> "Learned":
        """Train on clips of any skeletons, rates and styles; the same seed, the same networks.

        The loss is the mean squared error of reconstructed windows, five per second of each clip
        at each of `SPEEDS`. ``steps`` is the number of minibatches.

        Raises
        ------
        ValueError
            If there is no clip, or a skeleton lacks a limb.
        """
        if not clips:
            raise ValueError("a learned source needs at least one clip to train on, got none")
        networks, factors = {}, {}
        for part in PARTS:
            windows = []
            for clip, side, speed in itertools.product(clips, SIDES, SPEEDS):
                every = max(1, round(clip.fps / 5))
                windows.append(cut(limb_curves(clip, f"{side}_{part}"), clip.fps * speed, every))
            windows = torch.cat(windows).float().cpu()
            with torch.random.fork_rng(devices=[]):
                torch.manual_seed(seed)
                networks[part] = network = PeriodicAutoencoder()
                _descend(network, windows, steps, f"{part}s" if progress else None)
            # of unit power, and growing where the end joint leads forward
            latent = _sinusoids(network, windows)[0]
            forward = windows[:, CURVES - 1].cumsum(-1)
            together = (latent * (forward - forward.mean(-1, keepdim=True))).sum()
            factors[part] = float(together.sign() / latent.square().mean().sqrt())
        return cls(networks, factors)

    def sinusoids(self, clip: Clip) -> tuple[Tensor, Sinusoids]:
        """Latent curve ``[F, 4]`` of every limb, and the network's sinusoid around every frame.

        The residual is their difference. The frequency is the mean derivative of the phase over
        one second.
        """
        columns = []
        for limb in LIMBS:
            part = limb.split("_")[1]
            network, factor = self.networks[part], self.factors[part]
            windows = cut(limb_curves(clip, limb), clip.fps)
            latent, phase, frequency, amplitude, offset = _sinusoids(network, windows)
            wave = network.wave(phase, frequency, amplitude, offset)
            residual = (latent - wave).square().mean(1).sqrt()
            turned = (phase + (torch.pi if factor < 0 else 0.0)) % (2 * torch.pi)
            columns.append((latent[:, HALF] * factor, turned, _growth(phase, clip.fps),
                            amplitude * abs(factor), offset * factor, residual * abs(factor)))
        device = clip.rotations.device
        curve, *found = (torch.stack(column, 1).to(device, torch.float64)
                         for column in zip(*columns, strict=True))
        return curve, Sinusoids(*found)

    def save(self, path: str | os.PathLike) -> None:
        """Write networks and factors to one safetensors file."""
        state = nn.ModuleDict(self.networks).state_dict()
        tensors = {f"learned.{name}": value for name, value in state.items()}
        model_files.write(path, tensors, {"learned": {"factors": self.factors}})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Learned":
        """Read a source that `save` wrote; ValueError for any other file. It runs no code."""
        tensors, parts = model_files.read(path, "learned")
        with model_files.intact(path, "the learned source in it"):
            factors = {part: float(parts["learned"]["factors"][part]) for part in PARTS}
            networks = model_files.restore(
                lambda: nn.ModuleDict({part: PeriodicAutoencoder() for part in PARTS}), tensors,
                "learned.")
            return cls(dict(networks.items()), factors)


@cache
def pretrained() -> Learned:
    """The source in the package, trained on procedural clips."""
    folder = resources.files("toolkit.extra.sources")
    with resources.as_file(folder / "learned.safetensors") as path:
        return Learned.load(path)


def training_clips() -> list[Clip]:
    """The training clips of the source in the package."""
    styles = [style for style in procedural.STYLES if style not in HELD_OUT]
    return procedural.load(styles, ("FW", "BW", "FR", "SW", "TR1"), seconds=12.0, seed=0)


def _descend(network: PeriodicAutoencoder, windows: Tensor, steps: int, name: str | None) -> None:
    """Train with Adam on the reconstruction error, then set the network to evaluation mode."""
    adam = torch.optim.Adam(network.parameters(), lr=LEARNING_RATE)
    schedule = torch.optim.lr_scheduler.OneCycleLR(adam, LEARNING_RATE, total_steps=steps)
    with progress_bar(range(steps), desc=name, show=name is not None) as bar:
        for _ in bar:
            some = windows[torch.randint(len(windows), (BATCH,))]
            loss = nn.functional.mse_loss(network(some), some)
            adam.zero_grad()
            loss.backward()
            adam.step()
            schedule.step()
            bar.set_postfix(loss=f"{loss.item():.3f}", refresh=False)
    network.eval()


@torch.no_grad()
def _sinusoids(network: PeriodicAutoencoder, windows: Tensor) -> tuple[Tensor, ...]:
    """`PeriodicAutoencoder.sinusoid` of any number of windows, in the network's dtype."""
    parts = map(network.sinusoid, windows.to(network.time).split(CHUNK))
    return tuple(torch.cat(column) for column in zip(*parts, strict=True))


def _growth(phase: Tensor, fps: float) -> Tensor:
    """Frequency ``[F]``, Hz: the mean derivative of phases over one second around every frame."""
    turns = through_numpy(np.unwrap, phase.double()) / (2 * torch.pi)
    rate = torch.gradient(turns, spacing=1 / fps)[0]
    return mean(rate, SECOND, fps).clamp(MIN_FREQUENCY, MAX_FREQUENCY)
