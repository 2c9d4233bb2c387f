"""Training of the stylizer (Park et al. 2021, section 6 and appendix A.2).

A resumed run ends with the same weights as one that was not stopped, see `toolkit.training.loop`.
(With a budget of time the rates follow the clock; the batches are still the same.)
"""

import json
import math
import os
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path

import torch
from torch import Tensor

from toolkit.features.splits import generator, seeded
from toolkit.io.progress import progress_bar
from toolkit.motion.tensors import summary
from toolkit.stylization import losses
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Discriminator, Sizes, Stylizer, build
from toolkit.training.checkpoint import Checkpoint, Saver

INIT, BATCH = range(2)  # what draws random numbers
#: Adam's first rates of the networks, the paper's.
RATES = {"generator": 1e-4, "encoder": 1e-6, "mapping": 1e-4, "discriminator": 1e-6}
NETWORKS = tuple(RATES)
#: Adam's, of the published code. The paper prints (0.99, 0.999), which is slow for a GAN.
BETAS = (0.9, 0.99)


@dataclass(frozen=True)
class Config:
    """How to train; the defaults are the paper's (appendix A.2), for hours on a graphics card.

    Departures without a field: `BETAS` and the R1 term are those of the published code, and the
    diversity loss has a bound (`losses.diversity`). Each field from ``other_window`` to
    ``r1_every`` is a departure where it is not at its default; `quick` has them all.
    """

    losses: tuple[str, ...] = losses.LOSSES  # Table 1 leaves out "ds", then "sty"
    iterations: int = 100_000  # style codes come from noise and from references by turns
    batch: int = 8
    sizes: Sizes = field(default_factory=Sizes)
    rates: dict[str, float] = field(default_factory=RATES.copy)  # Adam's
    final_rate: float = 1.0  # rates at the end as a share of the first, on a cosine between
    weights: dict[str, float] = field(  # λ
        default_factory=lambda: dict.fromkeys((*losses.LOSSES, "r1"), 1.0))
    seconds: float = math.inf  # training ends after this time or after the iterations
    other_window: bool = False  # a source's own code is that of a window drawn from its domain
    fading: bool = False  # "ds" only for codes from noise, second result constant, weight falls
    warm_up: int = 0  # first iterations, which train G and E alone by "id", as an autoencoder
    r1_every: int = 1  # iterations from one R1 term to the next, with as many times its weight
    log_every: int = 100  # iterations per row of the history
    seed: int = 0
    device: str = "cpu"
    __repr__ = summary

    def __post_init__(self):
        if unknown := sorted(set(self.losses) - set(losses.LOSSES)):
            raise ValueError(f"unknown loss {', '.join(unknown)}; "
                             f"known: {', '.join(losses.LOSSES)}")
        if "adv" not in self.losses:
            raise ValueError("the losses need adv, which alone asks for a style; "
                             f"got {', '.join(self.losses) or 'none'}")
        for name, known in (("rates", NETWORKS), ("weights", (*losses.LOSSES, "r1"))):
            values = getattr(self, name)
            if set(values) != set(known) or any(not 0 <= v < math.inf for v in values.values()):
                raise ValueError(f"{name} must be numbers from 0 for {', '.join(known)}; "
                                 f"got {values}")
        for name in ("iterations", "batch", "log_every", "r1_every"):
            if getattr(self, name) < 1:
                raise ValueError(f"{name} must be positive, got {getattr(self, name)}")
        if not self.seconds > 0:
            raise ValueError(f"training needs some seconds, got {self.seconds}")

    @classmethod
    def quick(cls, **changes) -> "Config":
        """Minutes on one core: small networks, decaying high rates, stronger R1, all departures.

        The λ of the five losses are the paper's.
        """
        iterations = changes.get("iterations", 2000)
        return cls(**{
            "sizes": Sizes.small(), "iterations": iterations, "final_rate": 0.1,
            "other_window": True, "fading": True, "warm_up": min(300, iterations // 5),
            "r1_every": 4,
            "rates": dict.fromkeys(NETWORKS, 1e-3) | {"generator": 2e-3},
            "weights": dict.fromkeys(losses.LOSSES, 1.0) | {"r1": 5.0},
        } | changes)

    def fixed(self) -> dict:
        """What must not change when a run is resumed, as JSON holds it."""
        values = asdict(self)
        del values["device"]
        return json.loads(json.dumps(values))


@dataclass(eq=False)
class Run:
    """What training made; ``history``: per `Config.log_every` iterations the means of the terms.
    """

    stylizer: Stylizer
    discriminator: Discriminator
    config: Config
    history: list[dict[str, float]]
    __repr__ = summary


class Batches:
    """What iteration n sees, as a pure function of the seed and n.

    Domains are equally likely, of sources and of targets. The diversity loss needs two references
    and two noises each.
    """

    def __init__(self, motions: Motions, z: Tensor, config: Config):
        self.z, self.config = z, config
        domains = torch.arange(len(motions.domains))
        self.own = (motions.domain == domains[:, None]).float()  # [D, M], of each domain's motions
        if empty := [motions.domains[d] for d in domains[~self.own.any(1)]]:
            raise ValueError(f"no motion of {', '.join(empty)} to train on")

    def __getitem__(self, n: int) -> dict[str, Tensor]:
        """Tensors by name.

        ``x`` and ``domain`` of the sources and ``kin``, motions drawn from their domains; the
        ``target`` domains, ``references [2, B, …]`` and ``noise [2, B, 16]``.
        """
        b, draw = self.config.batch, generator(self.config.seed, BATCH, n)
        source, target = torch.randint(len(self.own), (2, b), generator=draw)
        rows, kin = torch.multinomial(self.own[source], 2, generator=draw, replacement=True).T
        alike = torch.multinomial(self.own[target], 2, generator=draw, replacement=True).T
        noise = torch.randn(2, b, self.config.sizes.latent, generator=draw)
        drawn = {"x": self.z[rows], "domain": source, "kin": self.z[kin], "target": target,
                 "references": self.z[alike], "noise": noise}
        return {name: value.to(self.config.device) for name, value in drawn.items()}


def fit(motions: Motions, config: Config | None = None,
        checkpoint: str | os.PathLike | None = None, *, resume: bool = True,
        progress: bool = False, networks: Callable = build,
        clock: Callable[[], float] = time.perf_counter) -> Run:
    """Train the four networks; for the other parameters and errors see `toolkit.training.fit`.

    ``networks`` makes a stylizer and its discriminator, called like `networks.build`. ``clock``
    gives the seconds now, for `Config.seconds`: wall time, or `time.process_time`. ValueError also
    if a domain has no motion or a loss is not finite any more.
    """
    config = config or Config()
    with seeded("cpu", config.seed, INIT):
        stylizer, discriminator = networks(motions.graph, motions.domains, config.sizes,
                                           motions.statistics())
    batches = Batches(motions, stylizer.statistics.apply(motions.x), config)
    both = {"stylizer": stylizer.to(config.device),
            "discriminator": discriminator.to(config.device)}
    adams = {}
    for name in NETWORKS:
        network = discriminator if name == "discriminator" else getattr(stylizer, name)
        adams[name] = torch.optim.Adam(network.parameters(), config.rates[name], BETAS, fused=True)
    # an example of each value, as `model_files.alike` compares them
    kinds = {"step": 0, "elapsed": 0.0, "history": [{"": 0.0}], "sums": {"": (0.0, 0.0)}}
    file = Checkpoint("stylization_checkpoint", both, adams, config.fixed(), kinds)
    state = {"step": 0, "elapsed": 0.0, "history": [], "sums": {}}
    if checkpoint and resume and Path(checkpoint).exists():
        state = file.load(checkpoint)[0]
    began = clock() - state["elapsed"]

    def spent() -> float:
        return max(state["step"] / config.iterations, state["elapsed"] / config.seconds)

    saver = Saver(lambda: file.save(checkpoint, state) if checkpoint else None)
    bar = progress_bar(total=config.iterations, initial=state["step"], desc="training",
                       unit="step", show=progress)
    with saver, bar:
        while (done := spent()) < 1:
            step = state["step"]
            terms = _step(stylizer, discriminator, adams, batches[step], config, step, done)
            state |= {"step": step + 1, "elapsed": clock() - began}
            for name, value in terms.items():
                total, count = state["sums"].get(name, (0.0, 0))
                state["sums"][name] = total + value, count + 1
            if state["step"] % config.log_every == 0:
                row = {name: total / count for name, (total, count) in state["sums"].items()}
                state["history"].append({"step": state["step"], "elapsed": state["elapsed"], **row})
                state["sums"] = {}
                bar.set_postfix({name: f"{value:.2f}" for name, value in row.items()},
                                refresh=False)
            bar.update()
            saver.stepped()
    return Run(stylizer.cpu().eval(), discriminator.cpu().eval(), config, state["history"])


def translations(stylizer: Stylizer, batch: dict[str, Tensor], config: Config,
                 from_noise: bool) -> dict[str, Tensor]:
    """What G makes of the sources ``x [B, 7, T, N]`` of a batch; z-scores.

    ``code`` of the target domains, from noise by F or from references by E, and ``fake`` made with
    it; ``second``, made with another code of the same domains (for "ds"); ``own`` codes of the
    sources and ``same`` made with them (for "cyc" and "id").
    """
    def code(k: int) -> Tensor:
        if from_noise:
            return stylizer.mapping(batch["noise"][k], batch["target"])
        return stylizer.encoder(batch["references"][k], batch["target"])

    content, decode = stylizer.generator.encode(batch["x"]), stylizer.generator.decode
    made = {"code": code(0)}
    made["fake"] = decode(content, made["code"])
    if "ds" in config.losses and (from_noise or not config.fading):
        with torch.set_grad_enabled(not config.fading):
            made["second"] = decode(content, code(1))
    if {"cyc", "id"} & set(config.losses):
        made["own"] = _own_code(stylizer, batch, config)
        made["same"] = decode(content, made["own"])
    return made


def terms_of(stylizer: Stylizer, discriminator: Discriminator, batch: dict[str, Tensor],
             made: dict[str, Tensor], config: Config) -> dict[str, Tensor]:
    """The loss terms of G, E and F (equations 7 to 11) that the config asks for, unweighted."""
    x, fake = batch["x"], made["fake"]
    terms = {"adv": losses.adversarial(discriminator(fake, batch["target"]))}
    if "cyc" in config.losses:
        back = stylizer.generator(fake, made["own"])
        terms["cyc"] = losses.content(x, back)
    if "id" in config.losses:
        terms["id"] = losses.content(x, made["same"])
    if "sty" in config.losses:
        terms["sty"] = losses.style(made["code"], stylizer.encoder(fake, batch["target"]))
    if "second" in made:
        terms["ds"] = losses.diversity(fake, made["second"])
    return terms


def _own_code(stylizer: Stylizer, batch: dict[str, Tensor], config: Config) -> Tensor:
    window = batch["kin"] if config.other_window else batch["x"]
    return stylizer.encoder(window, batch["domain"])


def _step(stylizer: Stylizer, discriminator: Discriminator, adams: dict[str, torch.optim.Adam],
          batch: dict[str, Tensor], config: Config, n: int, done: float) -> dict[str, float]:
    """One step of D, then one of the others; all loss terms.

    ``done`` is the share of the training before it, 0 to 1.
    """
    share = 0.5 * (1 + math.cos(math.pi * done))
    for name, adam in adams.items():
        rate = config.final_rate + (1 - config.final_rate) * share
        adam.param_groups[0]["lr"] = config.rates[name] * rate
    x = batch["x"]
    if n < config.warm_up:
        term = losses.content(x, stylizer.generator(x, _own_code(stylizer, batch, config)))
        _descend(config.weights["id"] * term, [adams["generator"], adams["encoder"]])
        return _finite({"id": term}, n)
    from_noise = n % 2 == 0  # in odd iterations codes come from references
    learning = NETWORKS[:3] if from_noise else NETWORKS[:2]  # F only where it makes the codes
    made = translations(stylizer, batch, config, from_noise)

    # D: real motions of their own domains against results
    x.requires_grad_(n % config.r1_every == 0)
    real = discriminator(x, batch["domain"])
    refused = discriminator(made["fake"].detach(), batch["target"])
    values = {"d": losses.discriminator(real, refused)}
    judged = values["d"]
    if x.requires_grad:
        values["r1"] = losses.r1(real, x)
        judged = judged + config.r1_every * config.weights["r1"] * values["r1"]
    _descend(judged, [adams["discriminator"]])
    x.requires_grad_(False)

    # G, E and F (equation 12), in which "ds" is made large
    terms = terms_of(stylizer, discriminator, batch, made, config)
    weights = config.weights | {"ds": -config.weights["ds"] * ((1 - done) if config.fading else 1)}
    loss = sum(weights[name] * term for name, term in terms.items())
    _descend(loss, [adams[name] for name in learning])
    return _finite(values | terms, n)


def _finite(terms: dict[str, Tensor], n: int) -> dict[str, float]:
    values = {name: term.item() for name, term in terms.items()}
    if not all(map(math.isfinite, values.values())):
        raise ValueError(f"training diverged at step {n}: {values}; lower the rates")
    return values


def _descend(loss: Tensor, adams: list[torch.optim.Adam]) -> None:
    """One step of some networks; the gradients of the others are dropped before their own step."""
    for adam in adams:
        adam.zero_grad(set_to_none=True)
    loss.backward()
    for adam in adams:
        adam.step()
