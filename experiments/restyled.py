"""Defects of restyled clips: results of `toolkit.stylization.stylize`, feet and arms as well."""

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import torch
from course.halves import split

from experiments.tables import Result, Store
from toolkit import datasets
from toolkit.datasets import procedural
from toolkit.evaluation import defects
from toolkit.motion import Clip
from toolkit.stylization import Stylizer, build, pretrained, stylize

RECORDED = Path(__file__).parents[1] / "examples/models/recorded_stylizer.safetensors"
SECONDS, CLIPS = 5.0, 24  # of a clip, from its middle; of dataset 2
ARMS = "body", "fold"  # kinds; also those of elbows and hands
COLUMNS: dict[str, list] = {"method": ["defects a minute"], "procedural": ["procedural", 1],
                            "arms": ["of arms", 1], "recorded": ["recorded", 1],
                            "arms2": ["of arms", 1]}


def run(store: Store = False) -> None:
    """Defects a minute of restyled clips, of their sources and without the last two steps."""
    torch.set_num_threads(1)
    computed = [clip for seed in (300, 310) for clip in procedural.load(
        styles=["Neutral", "Strut", "Old"], gaits=["FW", "BW", "FR"], seconds=SECONDS, seed=seed)]
    takes = datasets.load("bandai", dataset=2)
    _, own = split(build(takes), 0.5, 0)  # the judges', which the stylizer was not trained on
    unseen = own.take.unique()[:: max(1, len(own.take.unique()) // CLIPS)]
    found = (measured(pretrained(), [clip.resample(30.0) for clip in computed]),
             measured(Stylizer.load(RECORDED), [middle(takes[k]) for k in unseen]))
    rows = [{"method": method, "procedural": whole, "arms": arms, "recorded": whole2,
             "arms2": arms2}
            for (method, whole, arms), (_, whole2, arms2) in zip(*found, strict=True)]
    Result("restyled", "Restyled clips of 30 Hz, each in all other styles of the stylizer",
           "python -m experiments restyled --store", COLUMNS, rows).show(store)


def middle(clip: Clip) -> Clip:
    """At most so many `SECONDS`."""
    first = max(0, len(clip) - round(SECONDS * clip.fps)) // 2
    return clip.cut(first, len(clip) - first)


def measured(stylizer: Stylizer, clips: Sequence[Clip]) -> Iterator[tuple[str, float, float]]:
    """Of the sources and of their results: defects a minute, all and those of arms."""
    made = {"source": clips}
    for blend in (True, False):
        for feet in (False, True):
            method = f"{'blend' if blend else 'network'}{'' if feet else ', as predicted'}"
            made[method] = [
                stylize(stylizer, clip, domain, 0, blend=clip.style if blend else None, feet=feet)
                for clip in clips for domain in stylizer.domains if domain != clip.style]
    for method, motions in made.items():
        found = Counter(finding.kind in ARMS or finding.joint.endswith(("hand", "elbow"))
                        for motion in motions for finding in defects(motion))
        minutes = sum(motion.seconds for motion in motions) / 60
        yield method, found.total() / minutes, found[True] / minutes
