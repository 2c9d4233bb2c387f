"""A learned phase source: the periodic autoencoder of Starke, Mason and Komura 2022 (DeepPhase), one limb at a time.

The network reads two seconds of a limb's motion, squeezes them into one latent curve, replaces that curve by one sinusoid
and must rebuild the motion from it. The angle that serves this best is the limb's phase. Nothing tells the network what a
contact is or which way is forward.

>>> source = Learned.train(clips, seed=0)
>>> ph = tk.phases.extract(clip, source=source)        # or source="learned", for the one in the package

Departures from DeepPhase, which reads a whole body through several channels: one limb and one channel at a time, because a
local phase belongs to a limb; every window is scaled to unit power, because a hand in a pocket has a phase too; 41 samples
at 20 Hz span the two seconds instead of 121 at 60 Hz. The frequency handed out is the rate at which the phase grows, within
2 % for the hands of cyclic styles; the network's own, a mean over few and leaky spectral bins, is off by 13 % there.

The one in the package, which `pretrained` reads, has not seen the styles of `HELD_OUT`. It is made by

>>> Learned.train(training_clips(), seed=0, progress=True).save("toolkit/data/learned_phases.safetensors")
"""

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
from tqdm.auto import tqdm

from toolkit.datasets import procedural
from toolkit.io import model_files
from toolkit.motion import Clip, root_frames
from toolkit.phases.sinusoids import MAX_FREQUENCY, MIN_FREQUENCY, Sinusoids
from toolkit.phases.sources import LIMBS

RATE = 20.0  # Hz, of the windows' samples
HALF = 20  # samples on either side of a frame: one second
SAMPLES = 2 * HALF + 1
PARTS = ("hand", "foot")
CURVES = 6  # per limb: velocities of its middle and its end joint
CHUNK = 1024  # windows at a time
SPEEDS = (0.75, 1.0, 1.33)  # at which training also plays the clips

#: Procedural styles kept back from training, to test it on.
HELD_OUT = ("BigSteps", "DragRightLeg", "Drunk", "Old", "PendulumHands", "Strut")


class Convolution(nn.Module):
    """One-dimensional convolution of ``[B, inputs, T]`` by kernels as long as the window (T odd), zeros beyond its ends.

    As one product with the kernels' banded (Toeplitz) matrix, which on a processor is many times faster than `nn.Conv1d`.
    """

    def __init__(self, inputs: int, outputs: int, samples: int):
        super().__init__()
        bound = 1 / math.sqrt(inputs * samples)
        self.weight = nn.Parameter(torch.empty(inputs, outputs, samples).uniform_(-bound, bound))
        self.bias = nn.Parameter(torch.empty(outputs, 1).uniform_(-bound, bound))

    def forward(self, x: Tensor) -> Tensor:
        """``[B, outputs, T]``."""
        inputs, outputs, samples = self.weight.shape
        half = samples // 2
        # [i, o, s, t] = weight[i, o, half + s - t]: what sample s of input i adds to sample t of output o
        bands = nn.functional.pad(self.weight.flip(-1), (half, half)).unfold(-1, samples, 1).flip(-2)
        matrix = bands.transpose(1, 2).reshape(inputs * samples, outputs * samples)
        return (x.flatten(1) @ matrix).view(-1, outputs, samples) + self.bias


class PeriodicAutoencoder(nn.Module):
    """Windows ``[B, C, T]`` of C curves → latent curve → sinusoid → the windows again (DeepPhase, section 4).

    Parameters
    ----------
    curves
        C, of the input.
    hidden
        Width of the layer between input and latent curve.
    samples
        T, odd, the kernel's length too: each convolution sees the whole window.
    rate
        Samples per second.
    """

    def __init__(self, curves: int = CURVES, hidden: int = 12, samples: int = SAMPLES, rate: float = RATE):
        super().__init__()
        self.rate, self.hidden = rate, hidden
        self.encoder = _two_convolutions(curves, hidden, 1, samples)
        self.shift = nn.Sequential(nn.Linear(samples, 2), nn.BatchNorm1d(2))
        self.decoder = _two_convolutions(1, hidden, curves, samples)
        self.register_buffer("time", (torch.arange(samples) - samples // 2) / rate, persistent=False)

    def sinusoid(self, windows: Tensor) -> tuple[Tensor, ...]:
        """Latent curve ``[B, T]`` of windows; phase in the middle (radians), frequency (Hz), amplitude, offset ``[B]``."""
        latent = self.encoder(windows)[:, 0]
        y, x = self.shift(latent).unbind(-1)
        return latent, torch.atan2(y, x), *spectrum(latent, self.rate)

    def wave(self, phase: Tensor, frequency: Tensor, amplitude: Tensor, offset: Tensor) -> Tensor:
        """Those sinusoids ``[B]``, sampled over the window ``[B, T]``."""
        phase, frequency, amplitude, offset = (v[:, None] for v in (phase, frequency, amplitude, offset))
        return amplitude * torch.sin(2 * torch.pi * frequency * self.time + phase) + offset

    def forward(self, windows: Tensor) -> Tensor:
        """The windows rebuilt from their sinusoids."""
        _, *parameters = self.sinusoid(windows)
        return self.decoder(self.wave(*parameters)[:, None])


def _two_convolutions(inputs: int, hidden: int, outputs: int, samples: int) -> nn.Sequential:
    return nn.Sequential(Convolution(inputs, hidden, samples), nn.LayerNorm(samples), nn.Tanh(),
                         Convolution(hidden, outputs, samples))


def spectrum(latent: Tensor, rate: float) -> tuple[Tensor, Tensor, Tensor]:
    """Frequency (the mean, weighted by power), amplitude (of equal power) and offset (the mean) of curves ``[..., T]``."""
    samples = latent.shape[-1]
    bins = torch.fft.rfft(latent)
    power = bins[..., 1:].abs().square()
    frequencies = torch.fft.rfftfreq(samples, 1 / rate, device=latent.device)[1:]
    total = power.sum(-1) + 1e-12
    return (power * frequencies).sum(-1) / total, 2 * total.sqrt() / samples, bins[..., 0].real / samples


def limb_curves(clip: Clip, limb: str) -> Tensor:
    """Velocities ``[F, 6]`` of a limb's middle and end joint relative to the hips, in limb lengths per second.

    Axes are those of the root frame: outwards (so that left and right limbs look the same), up, forward.
    """
    side, part = limb.split("_")
    skeleton, positions = clip.skeleton, clip.global_positions
    roles = ("shoulder", "elbow", "hand") if part == "hand" else ("hip", "knee", "toe")
    start, middle, end = (skeleton.role(f"{side}_{role}") for role in roles)
    above, chain = end, [end]
    while above != start:
        above = skeleton.parents[above]
        chain.append(above)
    length = skeleton.offsets[chain[:-1]].norm(dim=-1).sum()
    reach = positions[:, [middle, end]] - positions[:, [skeleton.role("hips")]]
    local = root_frames(clip).turn_to_local(reach) / length
    if side == "right":
        local = local * torch.tensor([-1.0, 1.0, 1.0])
    return torch.gradient(local, spacing=1 / clip.fps, dim=0)[0].flatten(1)


def cut(curves: Tensor, fps: float, every: int = 1) -> Tensor:
    """Windows ``[N, C, T]`` around every n-th frame of curves ``[F, C]``: centred, unit power, mirrored beyond the ends."""
    times = torch.arange(0, len(curves), every, dtype=torch.float64)[:, None] / fps + torch.arange(-HALF, HALF + 1) / RATE
    last = (len(curves) - 1) / fps
    times = last - (last - times.abs()).abs()
    spline = scipy.interpolate.CubicSpline(torch.arange(len(curves)).double().numpy() / fps, curves.double().numpy())
    found = torch.from_numpy(spline(times.numpy())).float().transpose(1, 2)
    found = found - found.mean(-1, keepdim=True)
    return found / found.square().mean((1, 2), keepdim=True).sqrt().clamp_min(1e-4)


@dataclass(frozen=True, eq=False)
class Learned:
    """A phase source: one network for both hands, one for both feet, and the factors that their latent curves come out with.

    A factor gives the training clips' curves unit power, as a normalised source has, and the sign by which whole windows
    rise where the limb goes forward. The samples that become the curve follow that for feet; for hands it is nearly
    arbitrary.
    """

    networks: dict[str, PeriodicAutoencoder]
    factors: dict[str, float]

    @classmethod
    def train(cls, clips: Sequence[Clip], *, steps: int = 3000, batch: int = 256, rate: float = 3e-3, hidden: int = 12,
              seed: int = 0, progress: bool = False) -> "Learned":
        """Train on clips of any skeletons, rates and styles, by the mean squared error of the rebuilt windows.

        Parameters
        ----------
        clips
            What to learn from; five windows a second are cut from each, and also from it played at `SPEEDS`.
        steps, batch
            Minibatches, and windows in each.
        rate
            Adam's highest learning rate, on one rise and fall.
        hidden
            Width of the networks.
        seed
            The same seed gives the same networks.
        progress
            Show a bar.

        Raises
        ------
        ValueError
            If there is no clip, or a skeleton lacks a limb.
        """
        if not clips:
            raise ValueError("a learned source needs at least one clip to train on, got none")
        networks, factors = {}, {}
        for part in PARTS:
            curves = [(limb_curves(clip, f"{side}_{part}"), clip.fps) for clip in clips for side in ("left", "right")]
            windows = torch.cat([cut(c, fps * v, max(1, round(fps / 5))) for c, fps in curves for v in SPEEDS])
            with torch.random.fork_rng(devices=[]):
                torch.manual_seed(seed)
                networks[part] = network = PeriodicAutoencoder(hidden=hidden)
                _descend(network, windows, steps, batch, rate, f"{part}s" if progress else None)
            latent = _sinusoids(network, windows)[0]
            forward = windows[:, CURVES - 1].cumsum(-1)
            together = (latent * (forward - forward.mean(-1, keepdim=True))).sum()
            factors[part] = float(together.sign() / latent.square().mean().sqrt())
        return cls(networks, factors)

    def sinusoids(self, clip: Clip) -> tuple[Tensor, Sinusoids]:
        """Latent curve ``[F, 4]`` of every limb, and the sinusoid that the network put in its place around every frame.

        The residual is between the two; the frequency is not the network's but the growth of the phase over one second.
        """
        columns = []
        for limb in LIMBS:
            part = limb.split("_")[1]
            network, factor = self.networks[part], self.factors[part]
            latent, *parameters = _sinusoids(network, cut(limb_curves(clip, limb), clip.fps))
            phase, _, amplitude, offset = parameters
            residual = (latent - network.wave(*parameters)).square().mean(1).sqrt()
            turned = (phase + (torch.pi if factor < 0 else 0.0)) % (2 * torch.pi)
            columns.append((latent[:, HALF] * factor, turned, _growth(phase, clip.fps), amplitude * abs(factor),
                            offset * factor, residual * abs(factor)))
        curve, *rest = (torch.stack(column, 1).double() for column in zip(*columns, strict=True))
        return curve, Sinusoids(*rest)

    def save(self, path: str | os.PathLike) -> None:
        """Write networks and factors to one safetensors file."""
        tensors = {f"learned.{part}.{k}": v for part in PARTS for k, v in self.networks[part].state_dict().items()}
        hidden = {part: self.networks[part].hidden for part in PARTS}
        model_files.write(path, tensors, {"learned": {"hidden": hidden, "factors": self.factors}})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Learned":
        """Read a source that `save` wrote; a file that is none is a one-line ValueError. No code in it is run."""
        tensors, parts = model_files.read(path, "learned")
        networks = {}
        with model_files.intact(path, "the learned source in it"):
            for part in PARTS:
                networks[part] = PeriodicAutoencoder(hidden=parts["learned"]["hidden"][part]).eval()
                own = f"learned.{part}."
                networks[part].load_state_dict({k.removeprefix(own): v for k, v in tensors.items() if k.startswith(own)})
            return cls(networks, {part: float(parts["learned"]["factors"][part]) for part in PARTS})


@cache
def pretrained() -> Learned:
    """The source in the package, trained on procedural clips. No network access."""
    with resources.as_file(resources.files("toolkit") / "data" / "learned_phases.safetensors") as path:
        return Learned.load(path)


def training_clips() -> list[Clip]:
    """What the source in the package was trained on."""
    styles = [style for style in procedural.STYLES if style not in HELD_OUT]
    return procedural.load(styles, ("FW", "BW", "FR", "SW", "TR1"), seconds=12.0, seed=0)


def _descend(network: PeriodicAutoencoder, windows: Tensor, steps: int, batch: int, rate: float, name: str | None) -> None:
    """Adam on the error of rebuilt windows; leaves the network ready to predict."""
    adam = torch.optim.Adam(network.parameters(), lr=rate)
    schedule = torch.optim.lr_scheduler.OneCycleLR(adam, rate, total_steps=steps)
    with tqdm(range(steps), desc=name, disable=name is None) as bar:
        for _ in bar:
            some = windows[torch.randint(len(windows), (batch,))]
            loss = nn.functional.mse_loss(network(some), some)
            adam.zero_grad()
            loss.backward()
            adam.step()
            schedule.step()
            bar.set_postfix(loss=f"{loss.item():.3f}", refresh=False)
    network.eval()


@torch.no_grad()
def _sinusoids(network: PeriodicAutoencoder, windows: Tensor) -> tuple[Tensor, ...]:
    """`PeriodicAutoencoder.sinusoid` of any number of windows."""
    return tuple(torch.cat(column) for column in zip(*map(network.sinusoid, windows.split(CHUNK)), strict=True))


def _growth(phase: Tensor, fps: float) -> Tensor:
    """Frequency ``[F]``, Hz: the mean growth of phases ``[F]`` over one second around every frame."""
    half = round(fps / 2)
    step = torch.gradient(torch.from_numpy(np.unwrap(phase.double().numpy())), spacing=1 / fps)[0] / (2 * torch.pi)
    step = nn.functional.pad(step[None, None], (half, half), mode="replicate")
    return nn.functional.avg_pool1d(step, 2 * half + 1, stride=1)[0, 0].clamp(MIN_FREQUENCY, MAX_FREQUENCY)
