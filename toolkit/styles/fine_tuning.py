"""New styles for a trained model (Mason et al. 2022, section 5.3.2): gating and experts stay, only the style is learnt."""

import copy
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor
from tqdm.auto import tqdm

from toolkit import features, runtime
from toolkit.features import KINDS, Features, splits
from toolkit.io.model_files import difference
from toolkit.motion import Clip
from toolkit.motion.tensors import summary
from toolkit.networks import Film, FilmGenerator, Model
from toolkit.networks.bank import StyleBank
from toolkit.training import minibatches
from toolkit.training.loss import evaluate, loss_terms, make_bank
from toolkit.training.minibatches import Minibatches

METHODS = {
    "generator": "fine-tune the FiLM generator (section 5.3.2)",
    "vector": "optimise the style vector itself",
    "forward": "one forward pass of the generator, nothing learnt",
}
STEPS = 400  # of gradient descent, for every new style
RATES = {"generator": 2e-4, "vector": 1e-2}  # Adam's, at the start; a cosine takes it to zero
BATCH = 64  # frames of one style per step
STRAY = 0.5  # share of frames whose input pose strays
WALK = 1.0, 3.0  # speed in m/s and seconds of the walks that poses stray to
PRIOR = 0.15  # weight of how unusual a vector is: its mean squared z-score among the bank's
SPREAD = 0.3  # standard deviation of style vectors where there is no bank to say it
MAX_GRADIENT = 1.0  # norm to which gradients are clipped


@dataclass(frozen=True, eq=False)
class NewStyles:
    """What `fine_tune` made.

    Parameters
    ----------
    names
        The new styles.
    bank
        The bank that was given, and their vectors.
    model
        The model with the generator that made the vectors. Its gating and experts *are* the given model's (the same
        memory); where no generator was tuned, it is the given model.
    method
        Which of `METHODS`.
    seconds
        How long it took, features included.
    losses
        The loss of every step.
    """

    names: tuple[str, ...]
    bank: StyleBank
    model: Model
    method: str
    seconds: float
    losses: list[float]
    __repr__ = summary


def fine_tune(model: Model, clips: Clip | Sequence[Clip] | Features, name: str | None = None, bank: StyleBank | None = None,
              *, method: str | None = None, steps: int = STEPS, mirror: bool = False, seed: int = 0,
              progress: bool = False) -> NewStyles:
    """Learn new styles from a few clips or one, and change nothing else.

    Departures from the paper, which fine-tunes with the settings of training: steps are few and the rate decays. As in
    `toolkit.training.Config.quick`, some frames' input poses stray, here to poses of the model's own walks, so that a
    character finds into the new style from any other. And a vector is pulled towards the bank's: one clip says little
    about what it does not show, and without the pull the error on its frames falls further, but a character glides.

    Parameters
    ----------
    model
        A trained model. It is not changed.
    clips
        Motion on the model's skeleton, at least four seconds in one go; or features of it.
    name
        What the style is called. Where not given, every clip has its own style, and all are learnt together.
    bank
        The model's style bank, which the new styles are added to. Its styles are what a character may come from, they say
        how far a vector may be out, and the best of them on the clips is where an optimised vector starts: leave it out
        only if there is none.
    method
        One of `METHODS`; where not given, ``"generator"`` if the model has one, else ``"vector"``: a model that was stored
        without its generator, such as the embedded one, can be given a style too.
    steps
        Of gradient descent, for every new style.
    mirror
        Learn from the clips' mirror images too; for symmetric styles.
    seed
        The same seed, the same vectors.
    progress
        Show a bar.

    Returns
    -------
    NewStyles
        Model and bank that have the new styles; the vectors of all others are the same bits as before.

    Raises
    ------
    ValueError
        If the clips are of another skeleton or too short, the bank has a style of that name, or the method is unknown or
        needs a generator that the model does not have.
    """
    began = time.perf_counter()
    data = clips if isinstance(clips, Features) else _features(model, clips, name, mirror)
    generator = getattr(model.modulation, "generator", None)
    generator = generator if isinstance(generator, FilmGenerator) else None
    method = method or ("vector" if generator is None else "generator")
    if method not in METHODS:
        raise ValueError(f"unknown method {method!r}; there is {', '.join(METHODS)}")
    if method != "vector" and generator is None:
        raise ValueError(f"method {method!r} needs a FiLM generator, and this model has none; 'vector' does without")
    if known := [style for style in data.styles if bank is not None and style in bank.names]:
        raise ValueError(f"the bank has {', '.join(known)} already; choose another name")
    losses: list[float] = []
    if method == "vector":
        vectors = torch.nn.Parameter(_start(model, bank, data))
        losses = _descend(model, bank, data, [vectors], lambda style, _: vectors[style, None], method, steps, seed, progress)
        made = StyleBank(tuple(data.styles), vectors.detach())
    else:
        if method == "generator":
            frozen = [*model.gating.parameters(), *model.experts.parameters(), *model.buffers()]
            model = copy.deepcopy(model, {id(tensor): tensor for tensor in frozen})
            learnt = list(model.modulation.parameters())
            losses = _descend(model, bank, data, learnt, lambda _, y: model.encode(y), method, steps, seed, progress)
        made = make_bank(model, data)
    bank = made if bank is None else bank.merge(made)
    return NewStyles(made.names, bank, model, method, time.perf_counter() - began, losses)


def _features(model: Model, clips: Clip | Sequence[Clip], name: str | None, mirror: bool) -> Features:
    """Features of clips on the model's skeleton; their End Sites are left out where the model has none."""
    skeleton, clips = model.layout.skeleton, [clips] if isinstance(clips, Clip) else list(clips)
    if not any(map(skeleton.is_end, range(len(skeleton)))):
        clips = [clip.without_ends() for clip in clips]
    for clip in clips:
        expected, got = ({"joints": s.names, "parents": s.parents} for s in (skeleton, clip.skeleton))
        if why := difference(expected, got):
            raise ValueError(f"{clip.name}: not the model's skeleton; it differs in {why}")
    named = clips if name is None else [clip.replace(style=name) for clip in clips]
    return features.build(named, mirror=mirror, short="skip")


def _usual(model: Model, bank: StyleBank | None) -> tuple[Tensor, Tensor]:
    """Mean and standard deviation ``[D]`` of the bank's vectors; without one, of FiLM's as they start (γ = 1, β = 0)."""
    if bank is not None and len(bank) > 1:
        deviation = bank.vectors.std(0)
        return bank.vectors.mean(0), deviation + 0.1 * deviation.mean()
    plain = torch.tensor([1.0, 0.0, 1.0, 0.0] if isinstance(model.modulation, Film) else [0.0] * 4)
    return plain.repeat_interleave(model.style_size // 4), torch.full((model.style_size,), SPREAD)


def _start(model: Model, bank: StyleBank | None, data: Features) -> Tensor:
    """Vectors ``[S, D]`` to start from: of the bank's styles the best on the clips; without a bank the usual one."""
    if bank is None:
        return _usual(model, bank)[0].repeat(len(data.styles), 1)
    best = []
    for style in data.styles:
        rows = ({known: getattr(data, kind)[style] for known in bank} for kind in (*KINDS, "takes"))
        errors = evaluate(model, bank, Features(data.layout, *rows), frames=200)
        best.append(min(errors, key=lambda known: errors[known]["mse"]))
    return torch.stack([bank[known] for known in best])


def _walks(model: Model, bank: StyleBank) -> Tensor:
    """Poses ``[N, 12 J]`` of the model's walks in all styles, from the mean pose on, six a second."""
    speed, seconds = WALK
    states = list(runtime.states(model, runtime.straight(speed, seconds), bank.vectors))
    return torch.cat([state.joints for state in states[::10]])


def _descend(model: Model, bank: StyleBank | None, data: Features, learnt: list[Tensor],
             vector: Callable[[int, Tensor], Tensor], method: str, steps: int, seed: int,
             progress: bool) -> list[float]:
    """Lower the loss by changing ``learnt`` only, from which ``vector(style's number, clips)`` makes ``[1, D]``; losses."""
    batches = Minibatches(data, min(BATCH, *map(len, data.inputs.values())), 1, seed)
    joints, draw, total = model.layout.inputs["joints"], splits.generator(seed, minibatches.STRAY), steps * len(data.styles)
    poses = _walks(model, bank) if bank is not None else model.inputs_mean[None, joints]
    middle, spread = _usual(model, bank)
    adam, losses = torch.optim.Adam(learnt, lr=RATES[method], fused=True), []
    for step in tqdm(range(total), desc=METHODS[method].split(" (")[0], unit="step", disable=not progress):
        adam.param_groups[0]["lr"] = RATES[method] * (1 + math.cos(math.pi * step / total)) / 2
        x, p, z, y = batches[step]
        there = poses[torch.randint(len(poses), (len(x),), generator=draw)]
        astray, far = torch.rand(2, len(x), 1, generator=draw)
        x = x.to(poses, copy=True)
        x[:, joints] = torch.lerp(x[:, joints], there, (astray < STRAY) * far)
        x, p, z, y = (model.normaliser(kind).apply(v) for kind, v in zip(KINDS, (x, *model.observe(p, z), y), strict=True))
        style = vector(step % len(data.styles), y)
        odd = ((style - middle) / spread).square().mean()
        loss = sum(loss_terms(model, model(x, p, style), z)) + PRIOR * odd
        for tensor, gradient in zip(learnt, torch.autograd.grad(loss, learnt), strict=True):
            tensor.grad = gradient
        torch.nn.utils.clip_grad_norm_(learnt, MAX_GRADIENT)
        adam.step()
        losses.append(loss.item())
    return losses
