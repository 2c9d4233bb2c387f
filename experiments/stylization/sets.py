"""What is compared: clips for training, validation (of a recipe) and the test (scored once).

Dataset 2 has many takes of each style and content. Half of them train the judges, the other half is
the generators'.

Dataset 1 has one take of each style and content. So the takes are five parts, in each of which
every style and every content is: one for the test, one for validation, three for the generators.
The judges train on all takes but those of the part that they judge, and on more contents and styles
than are judged: with the generators' takes, too, but never with a judged one.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import torch
from course.halves import split
from torch import Tensor

from toolkit import datasets
from toolkit.features.splits import generator
from toolkit.stylization.data import Motions, build

PARTS = ("test", "validation")
FIFTHS = (*PARTS, "third", "fourth", "fifth")  # of the takes of dataset 1
#: Styles of dataset 1 on which recipes were chosen: a judge can tell them apart.
STYLES = ("feminine", "masculinity", "not-confident", "old", "tired")
#: What contents are judged as; the others are of references only.
CONTENTS = {"bow": "bow", "bye": "wave", "byebye": "wave", "run": "run", "dash": "run",
            "walk": "walk"}
OTHERS = {"guide": "guide", "walk-back": "walk", "walk-left": "walk", "walk-right": "walk"}


@dataclass(frozen=True)
class Task:
    """Motions of a comparison.

    ``train`` is for the generators. By part ("test", "validation") there are the ``sources``, the
    ``references``, and for judges of "content" and "style" the motions they learn from,
    ``judged[part][label]``.
    """

    train: Motions
    sources: Mapping[str, Motions]
    references: Mapping[str, Motions]
    judged: Mapping[str, Mapping[str, Motions]]


def walks_and_runs() -> Task:
    """The task of dataset 2."""
    return many_takes(build(datasets.load("bandai", dataset=2), mirror=True))


def dissimilar() -> Motions:
    """All windows of dataset 1 with contents that all styles have, and their mirror images."""
    clips = datasets.load("bandai", dataset=1)
    common = {clip.gait for clip in clips if clip.style == STYLES[0]}
    return build([clip for clip in clips if clip.gait in common], mirror=True)


def many_takes(motions: Motions) -> Task:
    """Half of the takes for the judges; of the others a fifth each for test and validation."""
    others, own = split(motions, 0.5, 0)
    rest, test = split(others, 0.2, 1)
    train, validation = split(rest, 0.2, 2)
    judged = {"content": own, "style": own}
    parts = {"test": test, "validation": validation}
    return Task(train, parts, parts, dict.fromkeys(PARTS, judged))


def few_takes(motions: Motions, styles: tuple[str, ...], contents: Mapping[str, str]) -> Task:
    """Fifths of the takes.

    Generators learn from all contents of some styles, judges of contents from all styles.
    """
    part = fifths(motions)
    chosen = torch.tensor([name in styles for name in motions.domains])[motions.domain]
    judged = torch.tensor([name in contents for name in motions.contents])[motions.content]
    common = _domains(motions.select(chosen), styles)
    named = _contents(motions.select(judged), contents)
    few = _contents(_domains(motions.select(chosen & judged), styles), contents)
    sources = {name: few.select(part[chosen & judged] == k) for k, name in enumerate(FIFTHS)}
    judges = {name: {"content": named.select(part[judged] != k),
                     "style": common.select(part[chosen] != k)} for k, name in enumerate(FIFTHS)}
    names = {**OTHERS, **contents}
    alike = _contents(common, {name: names.get(name, name) for name in motions.contents})
    references = {name: alike.select(part[chosen] == k) for k, name in enumerate(PARTS)}
    return Task(common.select(part[chosen] >= len(PARTS)), sources, references, judges)


def some(motions: Motions, count: int) -> Motions:
    """At most so many windows, chosen at random and always the same."""
    order = torch.randperm(len(motions), generator=generator(0))
    return motions.select(order[:count].sort().values)


def fifths(motions: Motions) -> Tensor:
    """The part ``[M]``, 0 to 4, of each window.

    Takes of one style, of one content, and of one style and content are in different parts.
    """
    labels = torch.stack((motions.take, motions.domain, motions.content), 1).flip(0).tolist()
    originals = {take: (d, c) for take, d, c in labels}  # not the mirror image's
    seen: dict[tuple[int, int], int] = {}
    part = torch.zeros(max(originals) + 1, dtype=torch.long)
    for take, (d, c) in sorted(originals.items()):
        part[take] = (d + c + seen.setdefault((d, c), 0)) % 5
        seen[d, c] += 1
    return part[motions.take]


def _domains(motions: Motions, names: tuple[str, ...]) -> Motions:
    """The same windows with these domains alone."""
    domain = [names.index(motions.domains[d]) for d in motions.domain.tolist()]
    return replace(motions, domain=torch.tensor(domain), domains=tuple(names))


def _contents(motions: Motions, to: Mapping[str, str]) -> Motions:
    """The same windows with contents of other names, several of which may become one."""
    names = tuple(sorted(set(to.values())))
    content = [names.index(to[motions.contents[c]]) for c in motions.content.tolist()]
    return replace(motions, content=torch.tensor(content), contents=names)
