"""What the codes of a trained stylizer hold, and which loss widens or narrows their spread within a domain."""

import torch
from torch import Tensor

from experiments.stylization.evaluation import angles
from toolkit.features.splits import generator
from toolkit.stylization import losses, training
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Stylizer

BATCHES, SOURCES = 8, 12  # for the pulls; sources that are restyled to every domain
AS_WIDE = 5.0  # factor that makes the codes of references spread about as widely as those of noise


@torch.no_grad()
def spreads(model: Stylizer, sources: Motions, references: Motions, seed: int = 0) -> dict[str, float]:
    """How much the codes of references and of noise differ, and what G makes of it.

    ``between`` and ``within`` domains: root mean square of the codes of references about their means; ``noise``: that
    within domains of the codes of noise. ``degrees``: angle between two results with two references of one domain, and
    ``degrees_wide`` with their codes moved away from the domain's mean by `AS_WIDE`; ``degrees_noise`` with two noises.
    ``follows``: cosine between the difference of the mean poses of the two results and that of their references.
    """
    codes, domains = model.code_of(references.x, references.domain), range(len(model.domains))
    mean = torch.stack([codes[references.domain == d].mean(0) for d in domains])
    draw = generator(seed)
    noise = torch.stack([model.code_from(torch.randn(100, model.sizes.latent, generator=draw), d) for d in domains])
    some = sources.select(torch.randperm(len(sources), generator=draw)[:SOURCES])
    found: dict[str, list[Tensor]] = {"degrees": [], "degrees_wide": [], "degrees_noise": [], "follows": []}
    for d in domains:
        x, own = some.x[some.domain != d], (references.domain == d).nonzero()[:, 0]
        first, second = own[torch.randint(len(own), (2, len(x)), generator=draw)]
        pairs = {"degrees": codes[torch.stack((first, second))],
                 "degrees_noise": noise[d, : 2 * len(x)].unflatten(0, (2, -1))}
        pairs["degrees_wide"] = mean[d] + AS_WIDE * (pairs["degrees"] - mean[d])
        for name, (a, b) in pairs.items():
            one, other = model.translate(x, a), model.translate(x, b)
            found[name].append(angles(one, other))
            if name == "degrees":
                moved, asked = (pair[:, :3].mean(2).flatten(1) for pair in
                                (one - other, references.x[first] - references.x[second]))
                found["follows"].append(torch.cosine_similarity(moved, asked))
    return {"between": _rms(mean - mean.mean(0)), "within": _rms(codes - mean[references.domain]),
            "noise": _rms(noise - noise.mean(1, keepdim=True)),
            **{name: float(torch.cat(values).mean()) for name, values in found.items()}}


def pulls(run: training.Run, motions: Motions) -> dict[str, list[float]]:
    """Derivative of each loss by the logarithm of the spread of the codes of training motions within their domains.

    A list has a number per batch. A positive one means: the loss falls if the codes of a domain become more alike. "sty"
    is that of an iteration with references, in which both codes change; "ds" has the sign that it has in the sum of losses,
    for codes of references.
    """
    model, judge = run.stylizer.requires_grad_(False), run.discriminator.requires_grad_(False)
    z = model.statistics.apply(motions.x)
    batches = training.Batches(motions, z, run.config)
    codes = torch.cat([model.encoder(*part) for part in zip(z.split(64), motions.domain.split(64), strict=True)])
    mean = torch.stack([codes[motions.domain == d].mean(0) for d in range(len(model.domains))])
    found: dict[str, list[float]] = {}
    for n in range(BATCHES):
        batch = batches[n]
        x, source, target = batch["x"], batch["domain"], batch["target"]
        spread = torch.zeros((), requires_grad=True)  # its logarithm

        def code(of: Tensor, domain: Tensor, spread: Tensor = spread) -> Tensor:
            return mean[domain] + spread.exp() * (model.encoder(of, domain) - mean[domain])

        content = model.generator.encode(x)
        first, second = (code(reference, target) for reference in batch["references"])
        fake = model.generator.decode(content, first)
        again = model.generator.encode(fake.detach())
        terms = {"adv": losses.adversarial(judge(fake, target)), "sty": losses.style(first, code(fake, target)),
                 "ds": -losses.diversity(fake, model.generator.decode(content, second))}
        for name, of in (("own window", x), ("another window", batch["kin"])):
            own = code(of, source)
            terms[f"id, code of {name}"] = losses.content(x, model.generator.decode(content, own), run.config.squared)
            terms[f"cyc, code of {name}"] = losses.content(x, model.generator.decode(again, own), run.config.squared)
        for name, term in terms.items():
            found.setdefault(name, []).append(float(torch.autograd.grad(term, spread, retain_graph=True)[0]))
    return found


def _rms(x: Tensor) -> float:
    return float(x.square().mean().sqrt())
