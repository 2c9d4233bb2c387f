"""Styles of recordings that a trained model has never seen, added from one take and from six: do
they walk as asked?
"""

from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.one_step import Store, ranked
from experiments.styles import walk
from experiments.tables import Result
from toolkit import features, published, styles
from toolkit.cli import verbs
from toolkit.evaluation import metrics, recognition
from toolkit.extra.characters.retargeting import retarget
from toolkit.io.load import load
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, Skeleton
from toolkit.runtime import FPS, rollout, straight
from toolkit.training import Run
from toolkit.view import strip

# of Bandai-Namco's dataset 2, many takes each
STYLES = ("active", "exhausted", "feminine", "masculine", "normal")
TAKES = 6  # walks from which a style is learnt; the judge learns from the others
DRAWN = ("feminine", "exhausted")
SOURCES = {"1 take": 1, f"{TAKES} takes": TAKES}
COLUMNS = {"learnt": ["model, and what a style is learnt from"], "seconds": ["seconds a style", 0],
           "before": ["before", 3], "after": ["after", 3], "repeat": ["repeating the frame", 3],
           "mean": ["the mean", 3],
           "nearest": ["recognised of 5: nearest style", 1], "recognised": ["added style", 1],
           "sure": ["mean probability", 2], "speed": ["speed / recorded", 2],
           "lowest": ["hips, m: lowest", 2]}


def run(
    root: Annotated[Path, typer.Option(help="Folder of Bandai-Namco's datasets, which holds "
                                            "dataset-2.")],
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    steps: Annotated[int, typer.Option(min=1, help="Steps of gradient descent for a style.")] = 200,
    seeds: Annotated[str, typer.Option(help="Comma-separated seeds, of judges and of added "
                                            "styles.")] = "0,1,2",
    picture: Annotated[Path
                       | None, typer.Option(help="PNG of styles added from one take, beside "
                                                 "recorded ones.")] = None,
    store: Store = False,
) -> None:
    """Error one step ahead, and recognised walks, of five styles of dataset 2 that are added from
    one take and from six.

    The judge learns from the walks that no style is learnt from. The floor is a walk with the
    model's own nearest style, by the error one step ahead. Frames that are kept aside are of the
    same takes.
    """
    net = published.either(model, parameters)
    skeleton, takes = net.model.layout.skeleton, {style: walks(root / "dataset-2", style)
                                                  for style in STYLES}
    fitted = {s: [on_skeleton(take, s, skeleton)
                  for take in progress_bar(takes[s], desc=s, unit="take")] for s in STYLES}
    told, rows = [], {source: [] for source in SOURCES}
    for seed in map(int, seeds.split(",")):
        judge = recognition.train(features.build([c for s in STYLES for c in fitted[s][TAKES:]],
                                                 short="skip"), seed)
        told += [int(judge.of_clip(c).argmax()) == i for i, s in enumerate(STYLES)
                 for c in fitted[s][:TAKES]]
        print(f"seed {seed}: {sum(told)} of {len(told)} real walks recognised that no judge has "
              f"learnt from")
        for source, count in SOURCES.items():
            rows[source].append(added(net, {s: fitted[s][:count] for s in STYLES}, judge, steps,
                                      seed))
            print(source, {key: round(value, 3) for key, value in rows[source][-1].items()},
                  flush=True)
    if picture:
        draw(net, {s: fitted[s] for s in DRAWN}, steps, seed, picture)
    if store:
        kind = "published" if parameters else "embedded" if model is None else "trained"
        Result("added-recordings",
               "Five styles of Bandai-Namco's dataset 2, walks, added to a trained model.",
               "python -m experiments added-styles --root DATA/bandai [--published "
               "DATA/lpn_film_100style] --store", COLUMNS,
               [{"learnt": f"{kind}, {source}",
                 **{key: [row[key] for row in made] for key in made[0]}}
                for source, made in rows.items()],
               {"steps": steps}, {"share of real walks recognised": sum(told) / len(told)}).add()


def walks(folder: Path, style: str) -> list[Path]:
    """Files of the walks of a style, in their order."""
    return sorted(folder.glob(f"dataset-2_walk_{style}_*.bvh"))


def added(net: Run, takes: dict[str, list[Clip]], judge: recognition.Recogniser, steps: int,
          seed: int) -> dict:
    """A row of the table: means over the styles of ``takes``."""
    made = [styles.fine_tune(net.model, clips, style, net.bank, steps=steps, seed=seed,
                             progress=True)
            for style, clips in takes.items()]
    near = [nearest(net, clips[0]) for clips in takes.values()]
    speeds = [sum(map(metrics.speed, clips)) / len(clips) for clips in takes.values()]
    own = torch.arange(len(takes))
    floor = walk(net.model, torch.stack([net.bank[style] for style in near]), speeds,
                 judge)[0].argmax(1)
    vectors = torch.stack([one.bank[style] for one, style in zip(made, takes, strict=True)])
    sure, states = walk(net.model, vectors, speeds, judge)
    path = torch.stack([s.root[:, :2] for s in states])
    went = (path[1:] - path[:-1]).norm(dim=-1).mean(0) * FPS
    hips = features.split_joints(torch.stack([s.joints for s in states]))["position"][
        :, :, net.model.layout.names.index("Hips"), 1]
    errors = [one.held_out[style] for one, style in zip(made, takes, strict=True)]
    return {"seconds": sum(c.seconds for clips in takes.values() for c in clips) / len(takes),
            **{key: sum(e[key] for e in errors) / len(errors)
               for key in ("before", "after", "repeat", "mean")},
            "nearest": int((floor == own).sum()), "recognised": int((sure.argmax(1) == own).sum()),
            "sure": float(sure[own, own].mean()),
            "speed": float((went / torch.tensor(speeds)).mean()),
            "lowest": float(hips.min())}


def draw(net: Run, takes: dict[str, list[Clip]], steps: int, seed: int, path: Path) -> None:
    """Write strips of each style's last take, of the style added from its first, and of the model's
    nearest style.
    """
    rows = {}
    for style, (first, *_, last) in takes.items():
        bank = styles.fine_tune(net.model, first, style, net.bank, steps=steps, seed=seed,
                                progress=True).bank
        near, ahead = nearest(net, first), straight(metrics.speed(first), 5.0)
        walked = {name: rollout(net.model, ahead, style=bank[name]).cut(120)
                  for name in (style, near)}
        rows |= {f"{style}, recorded": last, f"{style}, added": walked[style],
                 f"nearest style: {near}": walked[near]}
    strip(list(rows.values()), path, labels=list(rows), start=0.5, stop=2.0, width=9, dpi=100)


def nearest(net: Run, clip: Clip) -> str:
    """The model's own style with the least error on the clip, one step ahead."""
    return next(iter(ranked(net.model, net.bank, clip, (0, None))[0]))


def on_skeleton(file: Path, style: str, skeleton: Skeleton) -> Clip:
    """A take on the model's skeleton, labelled."""
    return retarget(load(file), skeleton).replace(style=style, gait="FW")
