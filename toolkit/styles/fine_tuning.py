"""New styles for a trained model (Mason et al. 2022, section 5.3.2): only the style is learnt."""

import copy
import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import features, runtime
from toolkit.features import KINDS, Features, splits
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.motion.tensors import shown, summary
from toolkit.networks import Film, FilmGenerator, Predictor
from toolkit.networks.bank import StyleBank
from toolkit.training import minibatches
from toolkit.training.loss import baselines, evaluate, loss_terms, make_bank, observed
from toolkit.training.minibatches import Minibatches

METHODS = {
    "generator": "fine-tune the FiLM generator (section 5.3.2)",
    "vector": "optimise the style vector itself",
    "forward": "one forward pass of the generator, without training",
}
STEPS = 400  # training steps per new style
RATES = {"generator": 2e-4, "vector": 1e-2}  # Adam's first, with cosine decay to zero
BATCH = 64  # frames of one style per step
MIX_UP = 0.5  # share of frames with a pose mix-up
WALK = 1.0, 3.0  # speed in m/s and seconds of the walks whose poses are mixed in
PRIOR = 0.15  # weight of the mean squared z-score of a vector among the bank's
SPREAD = 0.3  # standard deviation of style vectors without a bank
HELD_OUT = 0.2  # share of each new style's frames
EVERY = 40  # steps per new style between two measurements of the held-out error
MAX_GRADIENT = 1.0  # norm to which gradients are clipped
_POSES: dict[bytes, Tensor] = {}  # of the last walks, by model and bank


@dataclass(frozen=True, eq=False)
class NewStyles:
    """Result of `fine_tune`.

    ``model`` shares the memory of gating and experts with the given model; without a tuned
    generator it is the given model.
    """

    names: tuple[str, ...]  # the new styles
    bank: StyleBank  # the given bank with the new vectors
    model: Predictor  # the model with the tuned generator
    method: str  # one of `METHODS`
    seconds: float  # duration, with the computation of features
    losses: list[float]  # of every step
    held_out: dict[str, dict[str, float]]  # of each style: ``before``, ``after``, floors
    tried: Tensor  # [K, S, D] the vectors of the S new styles whenever the error was measured
    __repr__ = summary


def fine_tune(model: Predictor, clips: Clip | Sequence[Clip] | Features, name: str | None = None,
              bank: StyleBank | None = None, *, method: str | None = None, steps: int = STEPS,
              mirror: bool = False, prior: float = PRIOR, seed: int = 0,
              progress: bool = False) -> NewStyles:
    """Learn new styles from one or a few clips; vectors of other styles are bitwise unchanged.

    The paper says only that the generator is fine-tuned while the LPN is frozen. Ours are few steps
    and a learning rate that decays. As in `toolkit.training.Config.quick`, some input poses are
    mixed with others (pose mix-up), here of the model's own walks, so that a character can change
    to the new style from any other. And a penalty keeps a vector near those of the bank, because
    one clip does not show all motions.

    A share of the frames is held out (`HELD_OUT`). The error on half of them is measured every
    `EVERY` steps, and the best step is kept, maybe the initial one. The result has the errors of
    the other half. ``before`` is the error with the best style of the bank (method
    ``"vector"``) or with the vector that the generator computes without fine-tuning; ``mean`` and
    ``repeat`` are those of `toolkit.training.loss.baselines`. Clips that are too short to hold
    frames out keep the last step.

    Parameters
    ----------
    model
        A trained model. It is not changed.
    clips
        Motion on the model's skeleton, at least 1.9 seconds without a break, better four or more;
        or features of it.
    name
        Name of the style. By default every clip keeps its own style, and all are learnt together.
    bank
        The model's style bank, to which the new styles are added. It gives the poses of the mix-up,
        the prior of the penalty, and the initial vector of ``"vector"``: the best style.
    method
        One of `METHODS`; by default ``"generator"`` if the model has one, else ``"vector"``.
    steps, seed
        Training steps per new style; the same seed gives the same vectors.
    mirror
        Learn from the mirror images of the clips, too; for symmetric styles.
    prior
        Weight λ of the penalty.

    Raises
    ------
    ValueError
        If the clips have another skeleton or are too short, the bank has a style of that name, or
        ``steps``, ``prior`` or ``method`` is invalid.
    """
    began = time.perf_counter()
    data = clips if isinstance(clips, Features) else _features(model, clips, name, mirror)
    has_generator = isinstance(model.generator, FilmGenerator)
    method = method or ("generator" if has_generator else "vector")
    if not isinstance(prior, int | float) or not 0 <= prior < math.inf:
        raise ValueError(f"prior must be a number from 0 on, got {shown(prior)}")
    if method not in METHODS:
        raise ValueError(f"unknown method {method!r}; known: {', '.join(METHODS)}")
    if method != "vector" and not has_generator:
        raise ValueError(f"method {method!r} needs a FiLM generator, and this model has none; "
                         "use method 'vector'")
    if method != "forward" and steps < 1:
        raise ValueError(f"steps must be positive, got {shown(steps)}")
    if known := [style for style in data.styles if bank is not None and style in bank.names]:
        raise ValueError(f"the bank has {', '.join(known)} already; choose another name")
    styles = tuple(data.styles)
    kept, aside = splits.split(data, HELD_OUT, seed, styles)
    half = splits.held_out(aside, 0.5, seed, styles)
    reported = splits.select(aside, half)
    choosing = splits.select(aside, {style: ~mask for style, mask in half.items()})

    # what is learnt, the bank that it makes, and the vector of a style in a step
    if method == "vector":
        learnt = [torch.nn.Parameter(_start(model, bank, kept))]
        speeds = torch.tensor([features.natural_speed(data.clips[style][:]) for style in styles])

        def made() -> StyleBank:
            return StyleBank(styles, learnt[0].detach().clone(), speeds)

        def vector(style: int, _: Tensor) -> Tensor:
            return learnt[0][style, None]
    else:
        if method == "generator":
            # all but the generator shares its memory
            frozen = [*model.gating.parameters(), *model.experts.parameters(), *model.buffers()]
            model = copy.deepcopy(model, {id(tensor): tensor for tensor in frozen})
        learnt = model.style_parameters()

        def made() -> StyleBank:
            return make_bank(model, kept)

        def vector(_: int, y: Tensor) -> Tensor:
            return model.encode(y)

    def errors(frames: Features) -> dict[str, float]:
        return {style: row["mse"] for style, row in evaluate(model, made(), frames).items()}

    before, losses, tried = errors(reported), [], [made().vectors]
    least, values = sum(errors(choosing).values()), [t.detach().clone() for t in learnt]
    if method != "forward":
        total, every = steps * len(styles), EVERY * len(styles)
        bar = progress_bar(total=total, desc=METHODS[method].split(" (")[0], unit="step",
                           show=progress)
        descent = _descend(model, bank, kept, learnt, vector, RATES[method], total, prior, seed)
        with bar:
            for step, loss in enumerate(descent, 1):
                losses.append(loss)
                bar.update()
                if step % every == 0 or step == total:
                    found = errors(choosing)
                    tried.append(made().vectors)
                    if not found or sum(found.values()) < least:
                        least = sum(found.values())
                        values = [tensor.detach().clone() for tensor in learnt]
        with torch.no_grad():
            for tensor, value in zip(learnt, values, strict=True):
                tensor.copy_(value)

    new, after, floors = made(), errors(reported), baselines(model, reported)
    unknown = dict.fromkeys(("mean", "repeat"), math.nan)
    held_out = {style: {"before": before.get(style, math.nan), "after": after.get(style, math.nan),
                        **floors.get(style, unknown)} for style in styles}
    bank = new if bank is None else bank.merge(new)
    return NewStyles(new.names, bank, model, method, time.perf_counter() - began, losses,
                     held_out, torch.stack(tried))


def _features(model: Predictor, clips: Clip | Sequence[Clip], name: str | None,
              mirror: bool) -> Features:
    """Features of clips on the model's skeleton, without End Sites if the model has none."""
    skeleton, samples = model.layout.skeleton, model.layout.samples
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    if not skeleton.ends:
        clips = [clip.without_ends() for clip in clips]
    for clip in clips:
        if why := features.Layout(clip.skeleton).difference(features.Layout(skeleton)):
            raise ValueError(f"{clip.name}: {why}, compared with the model's skeleton")
    named = clips if name is None else [clip.replace(style=name) for clip in clips]
    return features.build(named, mirror=mirror, short="skip", samples=samples)


def prior_of(model: Predictor, bank: StyleBank | None) -> tuple[Tensor, Tensor]:
    """Mean and deviation ``[D]`` of the bank's vectors; without a bank γ = 1, β = 0 of FiLM."""
    if bank is not None and len(bank) > 1:
        deviation = bank.vectors.std(0)
        return bank.vectors.mean(0), deviation + 0.1 * deviation.mean()
    mean = torch.zeros(model.style_size)
    if isinstance(getattr(model, "modulation", None), Film):
        mean.view(4, -1)[::2] = 1.0
    return mean, torch.full_like(mean, SPREAD)


def _start(model: Predictor, bank: StyleBank | None, data: Features) -> Tensor:
    """Initial vectors ``[S, D]``: the bank's best style on the clips, or the prior's mean."""
    if bank is None:
        return prior_of(model, bank)[0].repeat(len(data.styles), 1)
    best = []
    for style in data.styles:
        # the style's rows under the name of each style of the bank
        rows = ({known: getattr(data, kind)[style] for known in bank}
                for kind in (*KINDS, "takes", "frames"))
        errors = evaluate(model, bank, Features(data.layout, *rows), frames=200)
        best.append(min(errors, key=lambda known: errors[known]["mse"]))
    return torch.stack([bank[known] for known in best])


def _walked(model: Predictor, bank: StyleBank) -> Tensor:
    """Poses of the model's walks in all styles, six per second. The last ones are kept, because
    one bank is used for many trainings.
    """
    if (key := model.fingerprint(bank.vectors)) not in _POSES:
        states = list(runtime.states(model, runtime.straight(*WALK), bank.vectors))
        _POSES.clear()
        _POSES[key] = torch.cat([state.joints for state in states[::10]])
    return _POSES[key]


def _descend(model: Predictor, bank: StyleBank | None, data: Features, learnt: list[Tensor],
             vector: Callable[[int, Tensor], Tensor], rate: float, steps: int, weight: float,
             seed: int) -> Iterator[float]:
    """Train what is learnt; the loss of every step.

    ``vector(index of the style, clips)`` computes a vector ``[1, D]`` from it.
    """
    frames = min(BATCH, *map(len, data.inputs.values()))
    batches = Minibatches(data, frames, 1, seed, memory=model.memory)
    joints = model.layout.inputs["joints"]
    draw = splits.generator(seed, minibatches.MIXUP)
    # poses that are mixed in
    poses = model.inputs_mean[None, joints] if bank is None else _walked(model, bank)
    mean, deviation = prior_of(model, bank)
    adam = torch.optim.Adam(learnt, lr=rate, fused=True)
    for step in range(steps):
        adam.param_groups[0]["lr"] = rate * (1 + math.cos(math.pi * step / steps)) / 2
        x, p, z, y = batches[step]
        # pose mix-up: some input poses are moved towards poses of the model's walks
        other = poses[torch.randint(len(poses), (len(x),), generator=draw)]
        mixed, share = torch.rand(2, len(x), 1, generator=draw)
        x = x.to(poses, copy=True)
        window = x.view(len(x), -1, x.shape[-1])  # past frames, if any, and the present one
        share = ((mixed < MIX_UP) * share)[:, None]
        window[..., joints] = torch.lerp(window[..., joints], other[:, None], share)
        x, p, z, y = observed(model, x, p, z, y)
        style = vector(step % len(data.styles), y)
        prior = ((style - mean) / deviation).square().mean()
        loss = sum(loss_terms(model, model(x, p, style), z)) + weight * prior
        for tensor, gradient in zip(learnt, torch.autograd.grad(loss, learnt), strict=True):
            tensor.grad = gradient
        torch.nn.utils.clip_grad_norm_(learnt, MAX_GRADIENT)
        adam.step()
        yield loss.item()
