"""New styles before and after fine-tuning."""

import hashlib
from pathlib import Path
from typing import Annotated

import torch
import typer
from course.style_space import clip_vectors, separation

from toolkit import datasets, features, runtime, styles, training
from toolkit.evaluation import metrics, recognition
from toolkit.features import Features, splits
from toolkit.motion import Clip
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.training import loss

WALKS = ("FW", "walk")  # gaits whose clips give a style its speed
SETTLE, WALK = 150, 390  # frames: start of a walk that is not measured; whole walk
HELD_OUT = {"procedural": "Zombie,Crouch,LimpLeft,HighKnees,Akimbo",
            "bandai": "old,proud,exhausted"}
GAITS = {"procedural": "FW,BW,SW,TR1",
         "bandai": "walk,run,walk-back,walk-left,walk-right,walk-turn-left,walk-turn-right"}


def run(
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(HELD_OUT)}.")] = "procedural",
    root: Annotated[Path | None, typer.Option(help="Folder that holds it.")] = None,
    held_out: Annotated[str
                        | None, typer.Option(help="Comma-separated new styles, which training "
                                                  "does not use.")] = None,
    steps: Annotated[int, typer.Option(
        min=1, help="Training steps of each model; 10,000 take some minutes.")] = 10_000,
    seconds: Annotated[float, typer.Option(help="Length of each procedural clip.")] = 30.0,
    keep: Annotated[Path
                    | None, typer.Option(help="Folder for trained models; models in it are not "
                                              "trained again.")] = None,
    seed: Annotated[int, typer.Option(help="Seed of training.")] = 0,
) -> None:
    """New styles, compared with the styles of training.

    A model is trained without some styles, which every method then adds.
    """
    if data not in HELD_OUT:
        raise ValueError(f"unknown data {data!r}; known: {', '.join(HELD_OUT)}")
    new = (held_out or HELD_OUT[data]).split(",")
    options = {"seconds": seconds} if data == "procedural" else {}
    clips = datasets.load(data, root, gaits=GAITS[data].split(","), **options)
    found = features.build(clips, short="skip", progress=True)
    known = tuple(style for style in found.styles if style not in new)
    walks = {s: max((c for c in clips if c.style == s and c.gait in WALKS),
                    key=lambda c: c.seconds) for s in found.styles}
    speeds = {style: metrics.speed(clip) for style, clip in walks.items()}
    judge = recognition.train(found, seed)
    print(f"{found.n_frames:,} frames of {len(found.styles)} styles; {judge.accuracy(found):.0%} "
          f"of clips are recognised")
    net = _trained("lpn-film", found, known, steps, keep, seed)
    _adding(net, found, [walks[s] for s in new], judge, speeds)


def _trained(name: str, data: Features, known: tuple[str, ...], steps: int, keep: Path | None,
             seed: int) -> training.Run:
    file = None if keep is None else keep / f"{name}-{len(known)}-{steps}.safetensors"
    if file is not None and file.exists():
        return training.load(file)
    config = training.Config.quick(model=name, styles=known, steps=steps, seed=seed, refit=0)
    made = training.fit(data, config, progress=True)
    if file is not None:
        keep.mkdir(parents=True, exist_ok=True)
        made.save(file)
    print(f"{name}: {len(known)} styles, {made.history[-1]['step']:,} steps, held-out error "
          f"{made.table()[-1]['error']:.3f}")
    return made


def _adding(net: training.Run, data: Features, walks: list[Clip], judge: recognition.Recogniser,
            speeds: dict[str, float]) -> None:
    """Add the styles of ``walks`` by every method, from this one clip of each style and from all
    but the test frames.
    """
    model, bank, new = net.model, net.bank, tuple(clip.style for clip in walks)
    learnt, test = splits.split(data, 0.2, 0, new)
    sources = {f"one clip, {sum(c.seconds for c in walks) / len(new):.0f} s": features.build(walks),
               f"all, {learnt.n_frames / len(new) / runtime.FPS:.0f} s": learnt}
    seen = splits.split(data, 0.0, 0, bank.names)[0]
    before, names = clip_vectors(model, seen)
    told = separation(before, names).values()
    right, sure = _recognised(model, bank, judge, speeds)
    print(f"\nnew styles: {', '.join(new)}")
    print("error on test frames; mean silhouette of the new styles' clips among the known "
          "styles' (least of any style);")
    print("number of styles recognised in closed loop (mean probability); seconds per style")
    print(f"{'method':<11}{'data':<17}{'error':>7}{'silhouette':>15}{'recognised':>17}{'s':>6}")
    apart = f"{sum(told) / len(told):.2f} ({min(told):.2f})"
    print(f"{'known styles':<35}{apart:>15}{f'{right}/{len(bank)} ({sure:.2f})':>17}")
    frozen, vectors = _fingerprint(model), bank.vectors.clone()
    for method in styles.METHODS:
        for source, rows in sources.items():
            made = styles.fine_tune(model, rows, None, bank, method=method)
            kept = torch.equal(made.bank.select(bank.names).vectors, vectors)
            if _fingerprint(made.model) != frozen or not kept:
                raise RuntimeError("gating, experts or the vectors of other styles changed")
            own = made.bank.select(new)
            error = sum(e["mse"] for e in loss.evaluate(model, own, test).values()) / len(new)
            right, sure = _recognised(model, own, judge, speeds)
            print(f"{method:<11}{source:<17}{error:>7.3f}"
                  f"{_silhouette(made, method, learnt, before, names):>15}"
                  f"{f'{right}/{len(new)} ({sure:.2f})':>17}{made.seconds / len(new):>6.0f}",
                  flush=True)
    print("gating, experts and the vectors of the known styles are bitwise equal after every run")


def _silhouette(made: styles.NewStyles, method: str, data: Features, known: torch.Tensor,
                names: list[str]) -> str:
    """Mean and least silhouette of the new styles' clips among the known ones; not defined for the
    method vector.
    """
    if method == "vector":
        return "–"
    vectors, labels = clip_vectors(made.model, data)
    told = separation(torch.cat((known, vectors)), names + labels)
    mine = [told[style] for style in made.names]
    return f"{sum(mine) / len(mine):.2f} ({min(mine):.2f})"


def _recognised(model: Model, bank: StyleBank, judge: recognition.Recogniser,
                speeds: dict[str, float]) -> tuple[int, float]:
    """How many styles of the bank are taken for themselves when they walk, and the mean probability
    of being so.
    """
    sure = walk(model, bank.vectors, [speeds[s] for s in bank], judge)[0]
    own = [judge.styles.index(s) for s in bank]
    return (
        int((sure.argmax(1) == torch.tensor(own)).sum()), float(sure[range(len(own)), own].mean())
    )


def walk(model: Model, vectors: torch.Tensor, speeds: list[float], judge: recognition.Recogniser,
          ) -> tuple[torch.Tensor, list[runtime.CharacterState]]:
    """Probabilities ``[S, styles]`` of characters that walk straight ahead, and their states."""
    ahead = torch.stack((torch.zeros(len(speeds)), torch.tensor(speeds)), 1)
    states = list(runtime.states(model, [runtime.Command(ahead)] * WALK, vectors))[SETTLE:]
    return judge.probabilities(torch.stack([s.joints for s in states], 1)), states


def _fingerprint(model: Model) -> str:
    """Hash of gating and experts."""
    parts = [*model.gating.state_dict().values(), *model.experts.state_dict().values()]
    return hashlib.sha256(b"".join(t.numpy().tobytes() for t in parts)).hexdigest()
