"""New styles before and after fine-tuning."""

import hashlib
from pathlib import Path
from typing import Annotated

import torch
import typer
from course.style_space import clip_vectors, separation

from experiments.tables import Result
from toolkit import datasets, features, runtime, styles, training
from toolkit.evaluation import metrics, recognition
from toolkit.features import Features, splits
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.training import loss

WALKS = ("FW", "walk")  # gaits whose clips give a style its speed
SETTLE, WALK = 150, 390  # frames: start of a walk that is not measured; whole walk
SECONDS = 30.0  # of a procedural clip
HELD_OUT = {"procedural": ("Zombie", "Crouch", "LimpLeft", "HighKnees", "Akimbo"),
            "bandai": ("old", "proud", "exhausted")}
GAITS = {"procedural": ["FW", "BW", "SW", "TR1"],
         "bandai": ["walk", "run", "walk-back", "walk-left", "walk-right", "walk-turn-left",
                    "walk-turn-right"]}
COLUMNS = {"method": ["method"], "data": ["data"], "error": ["error on test frames", 3],
           "silhouette": ["silhouette", 2], "least": ["least", 2],
           "recognised": ["recognised in closed loop", 0], "of": ["of", 0],
           "sure": ["mean probability", 2], "seconds": ["s for a style", 0]}


def run(
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(HELD_OUT)}.")] = "procedural",
    root: Annotated[Path | None, typer.Option(help="Folder that holds it.")] = None,
    steps: Annotated[int, typer.Option(
        min=1, help="Training steps; 10,000 take some minutes.")] = 10_000,
) -> None:
    """New styles, compared with the styles of training.

    A model is trained without some styles, which every method then adds.
    """
    if data not in HELD_OUT:
        raise ValueError(f"unknown data {data!r}; known: {', '.join(HELD_OUT)}")
    new, options = HELD_OUT[data], {"seconds": SECONDS} if data == "procedural" else {}
    clips = datasets.load(data, root, gaits=GAITS[data], **options)
    found = features.build(clips, short="skip", progress=True)
    known = tuple(style for style in found.styles if style not in new)
    walks = {s: max((c for c in clips if c.style == s and c.gait in WALKS),
                    key=lambda c: c.seconds) for s in found.styles}
    speeds = {style: metrics.speed(clip) for style, clip in walks.items()}
    judge = recognition.train(found)
    print(f"{found.n_frames:,} frames of {len(found.styles)} styles; {judge.accuracy(found):.0%} "
          f"of clips are recognised")
    config = training.Config.quick(styles=known, steps=steps, refit=0)
    model, bank = training.fit(found, config, progress=True)
    learnt, test = splits.split(found, 0.2, 0, new)
    given = {f"one clip, {sum(walks[s].seconds for s in new) / len(new):.0f} s":
             features.build([walks[s] for s in new]),
             f"all, {learnt.n_frames / len(new) / runtime.FPS:.0f} s": learnt}
    before, names = clip_vectors(model, splits.split(found, 0.0, 0, bank.names)[0])
    rows = [{"method": "known styles", **_silhouettes(separation(before, names), known),
             **_recognised(model, bank, judge, speeds)}]
    frozen, vectors = _fingerprint(model), bank.vectors.clone()
    for method in styles.METHODS:
        for name, frames in given.items():
            made = styles.fine_tune(model, frames, None, bank, method=method)
            kept = torch.equal(made.bank.select(bank.names).vectors, vectors)
            if _fingerprint(made.model) != frozen or not kept:
                raise RuntimeError("gating, experts or the vectors of other styles changed")
            own = made.bank.select(new)
            errors = [e["mse"] for e in loss.evaluate(model, own, test).values()]
            row = {"method": method, "data": name, "error": sum(errors) / len(errors),
                   **_recognised(model, own, judge, speeds), "seconds": made.seconds / len(new)}
            if method != "vector":  # no other clip gets another vector
                row |= _silhouettes(_separated(made.model, learnt, before, names), new)
            rows.append(row)
    print(Result("styles", "", "", COLUMNS, rows).markdown())
    print(f"new styles: {', '.join(new)}; silhouettes of clips, the mean and the least of a "
          "style.\nGating, experts and the vectors of the known styles keep their bits.")


def _separated(model: Model, data: Features, known: torch.Tensor,
               names: list[str]) -> dict[str, float]:
    """Silhouettes of the new styles' clips among those of the known ones."""
    vectors, labels = clip_vectors(model, data)
    return separation(torch.cat((known, vectors)), names + labels)


def _silhouettes(told: dict[str, float], of: tuple[str, ...]) -> dict[str, float]:
    mine = [told[style] for style in of]
    return {"silhouette": sum(mine) / len(mine), "least": min(mine)}


def _recognised(model: Model, bank: StyleBank, judge: recognition.Recogniser,
                speeds: dict[str, float]) -> dict[str, float]:
    """How many styles of the bank are taken for themselves when they walk straight ahead, and the
    mean probability of being so.
    """
    ahead = torch.tensor([[0.0, speeds[s]] for s in bank])
    states = list(runtime.states(model, [runtime.Command(ahead)] * WALK, bank.vectors))[SETTLE:]
    sure = judge.probabilities(torch.stack([s.joints for s in states], 1))
    own = torch.tensor([judge.styles.index(s) for s in bank])
    return {"recognised": int((sure.argmax(1) == own).sum()), "of": len(own),
            "sure": float(sure[range(len(own)), own].mean())}


def _fingerprint(model: Model) -> str:
    """Hash of gating and experts."""
    parts = [*model.gating.state_dict().values(), *model.experts.state_dict().values()]
    return hashlib.sha256(b"".join(t.numpy().tobytes() for t in parts)).hexdigest()
