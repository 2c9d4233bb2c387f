"""Training of the stylizer (Park et al. 2021, section 6 and appendix A.2): one plain loop over a config, and checkpoints.

What iteration n does is a pure function of the seed and n, so that a run that was stopped and resumed ends with the same
weights as one that was not, bit for bit. (With a budget of time the rates follow the clock; the batches are still the same.)
"""

import contextlib
import dataclasses
import json
import math
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import torch
from torch import Tensor, nn

from toolkit.features.splits import generator, seeded
from toolkit.io import model_files
from toolkit.io.progress import progress_bar
from toolkit.motion.tensors import summary
from toolkit.stylization import losses
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Discriminator, Sizes, Stylizer, build
from toolkit.training.checkpoint import Checkpoint, Saver

INIT, BATCH = range(2)  # what draws random numbers
NETWORKS = ("generator", "encoder", "mapping", "discriminator")


@dataclass(frozen=True)
class Config:
    """How to train; the defaults are the paper's (appendix A.2), at which a graphics card works for hours.

    Each field from ``squared`` to ``r1_every`` is a departure from the paper where it is not at its default; `quick` has
    them all, and ``python -m experiments stylization recipe`` measures what each is worth.
    """

    losses: tuple[str, ...] = losses.LOSSES  # Table 1 leaves out "ds", then "sty"
    iterations: int = 100_000  # style codes come from noise and from references by turns
    batch: int = 8
    sizes: Sizes = field(default_factory=Sizes)
    rates: dict[str, float] = field(default_factory=lambda: dict(zip(NETWORKS, (1e-4, 1e-6) * 2, strict=True)))  # Adam's
    betas: tuple[float, float] = (0.9, 0.99)  # of the published code; the paper: (0.99, 0.999), which is slow for a GAN
    final_rate: float = 1.0  # rates at the end as a share of the first, on a cosine between; 1: constant
    weights: dict[str, float] = field(default_factory=lambda: dict.fromkeys((*losses.LOSSES, "r1"), 1.0))  # λ
    seconds: float = math.inf  # training ends after this time or after the iterations, whichever comes first
    squared: bool = True  # content losses of squares, or of the norms of joints (`losses.content`)
    other_window: bool = False  # a source's own code is that of another window of its domain, so that it holds no content
    fading: bool = False  # "ds" only for codes from noise, with a constant second result, and its weight falls to 0
    warm_up: int = 0  # first iterations, which train G and E alone by "id", as an autoencoder
    encoder_learns: bool = False  # iterations with references train E, too (equation 12), not G alone (the published code)
    r1_every: int = 1  # iterations from one R1 term to the next, with as many times its weight
    log_every: int = 100  # iterations per row of the history
    save_every: float = 120.0  # seconds between checkpoints
    seed: int = 0
    device: str = "cpu"
    __repr__ = summary

    def __post_init__(self):
        if unknown := sorted(set(self.losses) - set(losses.LOSSES)):
            raise ValueError(f"unknown loss {', '.join(unknown)}; known: {', '.join(losses.LOSSES)}")
        if "adv" not in self.losses:
            raise ValueError(f"the losses need adv, which alone asks for a style; got {', '.join(self.losses) or 'none'}")
        for name, known in (("rates", NETWORKS), ("weights", (*losses.LOSSES, "r1"))):
            values = getattr(self, name)
            if set(values) != set(known) or any(not 0 <= v < math.inf for v in values.values()):
                raise ValueError(f"{name} must be numbers from 0 for {', '.join(known)}; got {values}")
        for name in ("iterations", "batch", "log_every", "r1_every"):
            if getattr(self, name) < 1:
                raise ValueError(f"{name} must be positive, got {getattr(self, name)}")
        if not self.seconds > 0:
            raise ValueError(f"training needs some seconds, got {self.seconds}")

    @classmethod
    def quick(cls, **changes) -> "Config":
        """Minutes on one core: small networks, high rates that decay, a stronger R1, and all departures.

        All λ are the paper's. With content losses of squares, G's gradient of the adversarial loss would be about twenty
        times that of each other one: it would learn to please D long before it learns to keep a motion.
        """
        settings = {"sizes": Sizes.small(), "iterations": 2000, "final_rate": 0.1, "squared": False, "other_window": True,
                    "fading": True, "warm_up": 300, "encoder_learns": True, "r1_every": 4,
                    "rates": dict(zip(NETWORKS, (2e-3, 1e-3, 1e-3, 1e-3), strict=True)),
                    "weights": dict.fromkeys(losses.LOSSES, 1.0) | {"r1": 5.0}}
        settings |= changes
        if "warm_up" not in changes:
            settings["warm_up"] = min(settings["warm_up"], settings["iterations"] // 5)
        return cls(**settings)

    def fixed(self) -> dict:
        """What must not change when a run is resumed, as JSON holds it."""
        free = ("save_every", "device")
        return json.loads(json.dumps({k: v for k, v in dataclasses.asdict(self).items() if k not in free}))


@dataclass(eq=False)
class Run:
    """What training made. ``history`` has a row per `Config.log_every` iterations: the means of all loss terms since."""

    stylizer: Stylizer
    discriminator: Discriminator
    config: Config
    history: list[dict[str, float]]
    __repr__ = summary

    def save(self, path: str | os.PathLike) -> None:
        """Write stylizer, config and history to one safetensors file, which `Stylizer.load` reads too."""
        tensors, description = self.stylizer.parts()
        tensors |= {f"discriminator.{k}": v for k, v in self.discriminator.state_dict().items()}
        numbers = {"config": dataclasses.asdict(self.config), "history": self.history}
        model_files.write(path, tensors, {"stylizer": description, "stylization": numbers})


def load(path: str | os.PathLike) -> Run:
    """Read a run that `Run.save` wrote; a file that is none is a one-line ValueError."""
    tensors, parts = model_files.read(path, "stylization")
    stylizer = Stylizer.from_parts(path, tensors, parts)
    with model_files.intact(path, "the record of the run"):
        numbers = parts["stylization"]
        stored = numbers["config"]
        config = Config(**stored | {"sizes": Sizes(**stored["sizes"]), "losses": tuple(stored["losses"]),
                                    "betas": tuple(stored["betas"])})
        discriminator = model_files.restore(
            lambda: Discriminator(stylizer.graph, stylizer.sizes, len(stylizer.domains)), tensors, "discriminator.")
        return Run(stylizer, discriminator, config, numbers["history"])


class Batches:
    """What iteration n sees, as a pure function of the seed and n.

    Domains are equally likely, of sources and of targets. The diversity loss needs two references and two noises each;
    ``kin`` are other motions of the sources' domains.
    """

    def __init__(self, motions: Motions, z: Tensor, config: Config):
        self.z, self.config = z, config
        self.rows = [(motions.domain == d).nonzero()[:, 0] for d in range(len(motions.domains))]
        if empty := [name for name, rows in zip(motions.domains, self.rows, strict=True) if not len(rows)]:
            raise ValueError(f"no motion of {', '.join(empty)} to train on")

    def __getitem__(self, n: int) -> dict[str, Tensor]:
        """Sources' ``x``, ``domain``, ``kin``; the ``target`` domains; ``references [2, B, …]``, ``noise [2, B, 16]``."""
        b, draw = self.config.batch, generator(self.config.seed, BATCH, n)
        source, target = torch.randint(len(self.rows), (2, b), generator=draw)
        places = torch.rand(4, b, generator=draw)
        noise = torch.randn(2, b, self.config.sizes.latent, generator=draw)
        x, *references, kin = (self._motions(d, u) for d, u in zip((source, target, target, source), places, strict=True))
        drawn = {"x": x, "domain": source, "target": target, "noise": noise, "references": torch.stack(references),
                 "kin": kin}
        return {name: value.to(self.config.device) for name, value in drawn.items()}

    def _motions(self, domains: Tensor, places: Tensor) -> Tensor:
        """The motion at a place (in [0, 1)) of each domain's."""
        rows = (self.rows[d] for d in domains.tolist())
        return self.z[[int(own[int(u * len(own))]) for own, u in zip(rows, places.tolist(), strict=True)]]


def fit(motions: Motions, config: Config | None = None, checkpoint: str | os.PathLike | None = None, *, resume: bool = True,
        progress: bool = False, on_step: Callable[[int, Stylizer], None] | None = None, networks: Callable = build,
        clock: Callable[[], float] = time.perf_counter) -> Run:
    """Train the four networks.

    Parameters
    ----------
    motions, config
        What to learn from, and how; by default the paper's way.
    checkpoint, resume
        File for the state of the run, written now and then and when it is interrupted; whether to go on from it.
    progress
        Show a bar.
    on_step
        Called after every iteration with its number and the stylizer; a KeyboardInterrupt it raises stops the run.
    networks
        Makes a stylizer and its discriminator, called like `toolkit.stylization.networks.build`.
    clock
        Seconds now, for `Config.seconds`: wall time, or `time.process_time`.

    Raises
    ------
    ValueError
        If a domain has no motion, a loss is not finite any more, or the checkpoint is of another config or other data.
    KeyboardInterrupt
        When interrupted, after the checkpoint was written.
    """
    config = config or Config()
    with seeded("cpu", config.seed, INIT):
        stylizer, discriminator = networks(motions.graph, motions.domains, config.sizes, motions.statistics())
    batches = Batches(motions, stylizer.statistics.apply(motions.x), config)
    both = {"stylizer": stylizer, "discriminator": discriminator}
    for network in both.values():
        network.to(config.device)
    trained = {name: discriminator if name == "discriminator" else getattr(stylizer, name) for name in NETWORKS}
    adams = {name: torch.optim.Adam(network.parameters(), config.rates[name], config.betas, fused=True)
             for name, network in trained.items()}
    file = Checkpoint("stylization_checkpoint", both, adams, config.fixed())
    state = {"step": 0, "elapsed": 0.0, "history": [], "sums": {}}
    if checkpoint and resume and Path(checkpoint).exists():
        state |= file.load(checkpoint)[0]
    began = clock() - state["elapsed"]
    saver = Saver(lambda: file.save(checkpoint, state) if checkpoint else None, config.save_every)
    bar = progress_bar(total=config.iterations, initial=state["step"], desc="training", unit="step", show=progress)
    with saver, bar:
        while (done := max(state["step"] / config.iterations, state["elapsed"] / config.seconds)) < 1:
            terms = _step(stylizer, discriminator, adams, batches[state["step"]], config, state["step"], done)
            state["step"] += 1
            state["elapsed"] = clock() - began
            for name, value in terms.items():
                total, count = state["sums"].get(name, (0.0, 0))
                state["sums"][name] = total + value, count + 1
            if state["step"] % config.log_every == 0:
                row = {name: total / count for name, (total, count) in state["sums"].items()}
                state["history"].append({"step": state["step"], "elapsed": state["elapsed"], **row})
                state["sums"] = {}
                bar.set_postfix({name: f"{value:.2f}" for name, value in row.items()}, refresh=False)
            bar.update()
            saver.stepped(on_step, state["step"], stylizer)
    return Run(stylizer.cpu().eval(), discriminator.cpu().eval(), config, state["history"])


def translations(stylizer: Stylizer, batch: dict[str, Tensor], config: Config, from_noise: bool) -> dict[str, Tensor]:
    """What G makes of the sources ``x [B, 7, T, N]`` of a batch, for all losses in one pass; z-scores.

    ``code`` of the target domains, from noise by F or from references by E, and ``fake`` made with it; ``second``, made with
    another code of the same domains (for "ds"); ``own`` codes of the sources and ``same`` made with them (for "id").
    """
    noise, references, target = batch["noise"], batch["references"], batch["target"]
    diverse = "ds" in config.losses and (from_noise or not config.fading)
    codes = [stylizer.mapping(noise[k], target) if from_noise else stylizer.encoder(references[k], target)
             for k in range(1 + diverse)]
    names, content = ["fake"], stylizer.generator.encode(batch["x"])
    made = {"code": codes[0]}
    if diverse and config.fading:
        with torch.no_grad():
            made["second"] = stylizer.generator.decode(content, codes.pop())
    elif diverse:
        names.append("second")
    if {"cyc", "id"} & set(config.losses):
        made["own"] = stylizer.encoder(batch["kin" if config.other_window else "x"], batch["domain"])
    if "id" in config.losses:
        names, codes = [*names, "same"], [*codes, made["own"]]
    motions = stylizer.generator.decode(tuple(part.repeat(len(codes), 1, 1, 1) for part in content), torch.cat(codes))
    return made | dict(zip(names, motions.chunk(len(codes)), strict=True))


def terms_of(stylizer: Stylizer, discriminator: Discriminator, batch: dict[str, Tensor], made: dict[str, Tensor],
             config: Config) -> dict[str, Tensor]:
    """The loss terms of G, E and F (equations 7 to 11) that the config asks for, unweighted."""
    target, fake = batch["target"], made["fake"]
    terms = {
        "adv": lambda: losses.adversarial(discriminator(fake, target)),
        "cyc": lambda: losses.content(batch["x"], stylizer.generator(fake, made["own"]), config.squared),
        "id": lambda: losses.content(batch["x"], made["same"], config.squared),
        "sty": lambda: losses.style(made["code"], stylizer.encoder(fake, target)),
        "ds": lambda: losses.diversity(fake, made["second"]),
    }
    return {name: terms[name]() for name in config.losses if name != "ds" or "second" in made}


def _step(stylizer: Stylizer, discriminator: Discriminator, adams: dict[str, torch.optim.Adam], batch: dict[str, Tensor],
          config: Config, n: int, done: float) -> dict[str, float]:
    """One step of D, then one of the others; all loss terms. ``done`` is the share of the training before it, 0 to 1."""
    share = 0.5 * (1 + math.cos(math.pi * done))
    for name, adam in adams.items():
        adam.param_groups[0]["lr"] = config.rates[name] * (config.final_rate + (1 - config.final_rate) * share)
    if n < config.warm_up:
        own = stylizer.encoder(batch["kin" if config.other_window else "x"], batch["domain"])
        rebuilt = losses.content(batch["x"], stylizer.generator(batch["x"], own), config.squared)
        _descend(config.weights["id"] * rebuilt, [adams["generator"], adams["encoder"]])
        return _finite({"id": rebuilt.item()}, n)
    from_noise = n % 2 == 0  # in odd iterations codes come from references
    learning = NETWORKS[:3] if from_noise else NETWORKS[: 1 + config.encoder_learns]
    with _frozen(*(getattr(stylizer, name) for name in NETWORKS[:3] if name not in learning)):
        made = translations(stylizer, batch, config, from_noise)

        slope = None
        x = batch["x"].requires_grad_(n % config.r1_every == 0)
        real = discriminator(x, batch["domain"])
        judged = losses.discriminator(real, discriminator(made["fake"].detach(), batch["target"]))
        if x.requires_grad:
            slope = losses.r1(real, x)
        _descend(judged if slope is None else judged + config.r1_every * config.weights["r1"] * slope,
                 [adams["discriminator"]])
        x.requires_grad_(False)

        with _frozen(discriminator):
            terms = terms_of(stylizer, discriminator, batch, made, config)
        weights = config.weights | ({"ds": config.weights["ds"] * (1 - done)} if config.fading else {})
        loss = sum((-1 if name == "ds" else 1) * weights[name] * term for name, term in terms.items())  # equation 12
        _descend(loss, [adams[name] for name in learning])
    values = {"d": judged, "r1": slope, **terms}
    return _finite({name: value.item() for name, value in values.items() if value is not None}, n)


@contextlib.contextmanager
def _frozen(*networks: nn.Module) -> Iterator[None]:
    """Inside, the parameters of networks get no gradients, which are then not computed."""
    for network in networks:
        network.requires_grad_(False)
    yield
    for network in networks:
        network.requires_grad_(True)


def _finite(values: dict[str, float], n: int) -> dict[str, float]:
    if not all(map(math.isfinite, values.values())):
        raise ValueError(f"training diverged at step {n}: {values}; lower the rates")
    return values


def _descend(loss: Tensor, adams: list[torch.optim.Adam]) -> None:
    for adam in adams:
        adam.zero_grad(set_to_none=True)
    loss.backward()
    for adam in adams:
        adam.step()
