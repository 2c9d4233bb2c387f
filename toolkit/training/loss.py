"""The loss of Mason et al. 2022 (equation 5), style vectors, held-out errors and baselines."""

import dataclasses
import math

import torch
from torch import Tensor

from toolkit.features import FRAME_KINDS, KINDS, Features, Layout, natural_speed
from toolkit.io.progress import progress_bar
from toolkit.networks import Predictor
from toolkit.networks.bank import StyleBank
from toolkit.networks.predictor import evaluating
from toolkit.training.minibatches import Minibatches, remembered

STEPS, BATCH = 30, 64  # of `refit`: steps per style, frames of a step
RATE = 0.06  # its first rate, in deviations of the bank's vectors


def loss_terms(model: Predictor, predicted: Tensor, target: Tensor) -> tuple[Tensor, Tensor]:
    """Mean squared error and bone-length loss (equation 5) of normalised outputs ``[B, Dz]``.

    The bone-length loss is the mean absolute error of bone lengths, in metres, over samples and
    bones.
    """
    layout, normaliser = model.layout, model.normaliser("outputs")
    positions = [layout.joint_positions(normaliser.invert(z)) for z in (predicted, target)]
    made, right = map(layout.bone_lengths, positions)
    return (predicted - target).square().mean(), (made - right).abs().mean()


def observed(model: Predictor, x: Tensor, p: Tensor, z: Tensor, *y: Tensor) -> tuple[Tensor, ...]:
    """Rows of x, p, z and perhaps y as a model learns from them: with its own phase, normalised."""
    kinds = zip(KINDS, (x, *model.observe(p, z), *y), strict=False)
    return tuple(model.normaliser(kind).apply(rows) for kind, rows in kinds)


def make_bank(model: Predictor, data: Features, clips: int | None = None) -> StyleBank:
    """Mean style vector of every style over its clips, or ``clips`` of them; and natural speeds.

    A model with a table of styles gives its rows; ``data`` must have the styles of its training, in
    the same order.
    """

    vectors, speeds = [], []
    for number, every in enumerate(data.clips.values()):
        y = every[_spread(len(every), clips)]
        vectors.append(model.style_vector(y, number))
        speeds.append(natural_speed(y))
    return StyleBank(tuple(data.clips), torch.stack(vectors).cpu(), torch.tensor(speeds))


def _spread(count: int, most: int | None) -> Tensor:
    """Numbers of at most so many of ``count`` rows, evenly spread."""
    if most is None or count <= most:
        return torch.arange(count)
    return torch.linspace(0, count - 1, most).long()


def evaluate(model: Predictor, bank: StyleBank, data: Features,
             frames: int | None = None) -> dict[str, dict[str, float]]:
    """Error of every style: ``mse`` of normalised outputs, ``bone`` length error in metres.

    It uses ``frames`` frames of each style, evenly spread, or all. The model runs in evaluation
    mode.
    """
    errors, device = {}, model.outputs_mean.device
    for style in data.styles:
        n = len(data.inputs[style])
        if not n:
            continue
        rows = _spread(n, frames)
        sums = torch.zeros(2, dtype=torch.float64)
        for part in rows.split(1024):
            x = remembered(data, style, part, model.memory).to(device)
            p, z = (getattr(data, kind)[style][part].to(device) for kind in FRAME_KINDS[1:])
            x, p, z = observed(model, x, p, z)
            with evaluating(model):
                terms = loss_terms(model, model(x, p, bank[style][None].to(device)), z)
                sums += len(part) * torch.stack(terms).double().cpu()
        errors[style] = dict(zip(("mse", "bone"), (sums / len(rows)).tolist(), strict=True))
    return errors


@torch.no_grad()
def baselines(model: Predictor, data: Features) -> dict[str, dict[str, float]]:
    """Mean squared error of two predictions that need no learning, per style.

    ``mean`` predicts the mean of the training data. ``repeat`` predicts the current frame again,
    with the mean contacts because x does not hold contacts.
    """
    normaliser = model.normaliser("outputs")
    errors = {}
    for style in data.styles:
        if len(data.inputs[style]):
            x, p, z = (getattr(data, kind)[style][:] for kind in FRAME_KINDS)
            still = repeat_frame(model.layout, x, p, normaliser.mean)
            z, still = (normaliser.apply(rows) for rows in (model.observe(p, z)[1], still))
            errors[style] = {"mean": float(z.square().mean()),
                             "repeat": float((z - still).square().mean())}
    return errors


def repeat_frame(layout: Layout, x: Tensor, phases: Tensor, mean: Tensor) -> Tensor:
    """Output frames ``[N, Dz]`` without any change of pose, trajectory and phases.

    A global phase continues at its mean rate: it never rests. Without a change, its one column
    would dominate the error.
    """
    blocks = layout.unpack_output(mean.expand(len(x), -1))  # contacts stay at their mean
    future = blocks["trajectory"].shape[1]
    blocks["trajectory"] = x[:, layout.inputs["trajectory"]][:, -future:]
    blocks["joints"] = x[:, layout.inputs["joints"]]
    if layout.phase == "local":
        blocks |= {"phases": phases, "phase_updates": torch.zeros_like(phases)}
    return layout.pack_output(**blocks)


def refit(model: Predictor, bank: StyleBank, data: Features, steps: int = STEPS, seed: int = 0,
          pose_mixup: float = 0.3, progress: bool = False) -> StyleBank:
    """A bank whose vectors have less error on the frames of their styles; the model stays as it is.

    Ours. The paper takes the mean of the vectors of a style's clips, or one (section 4.4). A mean
    was never trained as such. From it on, Adam minimises the mean squared error of the normalised
    outputs over the frames of ``data``, whose styles the bank has. ``steps`` is the number of steps
    for each style; ``pose_mixup`` is that of `Minibatches`.
    """
    batches = Minibatches(data, BATCH, 1, seed, pose_mixup, model.memory)
    device = model.outputs_mean.device
    scale = float(bank.vectors.std(0).mean()) if len(bank) > 1 else 1.0
    vectors = bank.vectors.clone()
    bar = progress_bar(batches.styles, desc="vectors", unit="style", show=progress)
    for which, style in enumerate(bar):
        vector = bank[style].clone().to(device).requires_grad_()
        adam = torch.optim.Adam([vector], fused=True)
        for turn in range(steps):
            rows = batches[turn * len(batches.styles) + which]
            x, p, z = observed(model, *(part.to(device) for part in rows[:3]))
            adam.param_groups[0]["lr"] = scale * RATE * (1 + math.cos(math.pi * turn / steps)) / 2
            with evaluating(model, gradients=True):
                error = (model(x, p, vector[None]) - z).square().mean()
                (vector.grad,) = torch.autograd.grad(error, vector)
            adam.step()
        vectors[bank.names.index(style)] = vector.detach().cpu()
    return dataclasses.replace(bank, vectors=vectors)
