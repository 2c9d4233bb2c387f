"""What notebook 07 and the experiments compare models by: shared errors, movement of hands."""

import json
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from types import SimpleNamespace

import pandas as pd
import torch
from torch import Tensor

from toolkit.features import (
    FRAME_KINDS,
    Features,
    Layout,
    Normaliser,
    mean_velocity,
    split_joints,
    splits,
)
from toolkit.motion.roles import SIDES
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.training import loss

SHARED = ("trajectory", "joints", "contacts")  # blocks of z that every model predicts
WINDOW = 240  # frames over which the hands' range is taken, as long as a style clip
LPN = "lpn-film", "lpn-onehot", "lpn-resad"
#: Columns of `summary`: key of a stored row, factor.
SHOWN = {"MSE": ("shared", 1), "recognised, %": ("recognised", 100),
         "hands' range, of the data's": ("hands", 1), "skate with IK, cm/s": ("skate_ik", 100),
         "shoulders off, cm": ("clavicle", 100), "hands off, cm": ("hand", 100),
         "bones off, mm": ("bone", 1000), "path off, cm": ("path", 100)}
ALIKE = 4  # style clips that a walk is compared with: those nearest to it in velocity


@torch.no_grad()
def block_errors(model: Model, bank: StyleBank, test: Features,
                 scale: Normaliser) -> dict[str, dict[str, float]]:
    """Mean squared error per style of every block of `SHARED`, in standard deviations of the data.

    ``scale`` are the statistics of the training data's ``outputs``.
    """
    errors = {}
    for style in (s for s in test.styles if len(test.inputs[s])):
        rows, totals = torch.arange(len(test.inputs[style])), dict.fromkeys(SHARED, 0.0)
        for part in rows.split(1024):
            x, p, z = (getattr(test, kind)[style][part] for kind in FRAME_KINDS)
            p, wanted = model.observe(p, z)
            off = model.predict(x, p, bank[style]) - wanted
            for block in SHARED:
                columns = off[:, model.layout.outputs[block]]
                columns = columns / scale.std[test.layout.outputs[block]]
                totals[block] += len(part) * float(columns.square().mean())
        errors[style] = {block: total / len(rows) for block, total in totals.items()}
    return errors


def shared_error(model: Model, bank: StyleBank, test: Features,
                 scale: Normaliser) -> dict[str, float]:
    """Mean squared error per style over all columns of `SHARED`, see `block_errors`.

    The full errors of two models are not comparable, because only some models predict local phases
    or a global phase.
    """
    return {style: over_columns(test.layout, found)
            for style, found in block_errors(model, bank, test, scale).items()}


def over_columns(layout: Layout, errors: dict[str, float]) -> float:
    """Mean over the columns of `SHARED`, from the mean of each block."""
    widths = {b: layout.outputs[b].stop - layout.outputs[b].start for b in SHARED}
    return sum(widths[block] * errors[block] for block in SHARED) / sum(widths.values())


def shared_baselines(data: Features, held_out: float, seed: int) -> dict[str, float]:
    """`shared_error`, mean over styles, of two guesses.

    They are the training data's ``mean``, and the current frame (``repeat``). ``mean, joints`` and
    ``repeat, joints`` are the errors of the joint features alone.
    """
    train, test = splits.split(data, held_out, seed, tuple(data.styles))
    normaliser = train.normalisers()["outputs"]
    errors: dict[str, list[float]] = defaultdict(list)
    for style in (s for s in test.styles if len(test.inputs[s])):
        x, p, z = (getattr(test, kind)[style][:] for kind in FRAME_KINDS)
        still = loss.repeat_frame(data.layout, x, p, normaliser.mean)
        for name, guess in (("mean", normaliser.mean), ("repeat", still)):
            off = ((z - guess) / normaliser.std).square()
            shared = torch.cat([off[:, data.layout.outputs[block]] for block in SHARED], 1)
            errors[name].append(float(shared.mean()))
            errors[f"{name}, joints"].append(float(off[:, data.layout.outputs["joints"]].mean()))
    return {name: sum(values) / len(values) for name, values in errors.items()}


def nearest(clips: Tensor, speed: float) -> Tensor:
    """The `ALIKE` of style clips whose mean velocity is nearest to ``speed`` m/s straight ahead."""
    away = (mean_velocity(clips) - torch.tensor([0.0, speed])).norm(dim=-1)
    return clips[away.argsort(stable=True)[:ALIKE]]


def hand_swing(layout: Layout, positions: Tensor) -> dict[str, Tensor]:
    """Range of motion of the hands and their correlation, from joint positions in the root frame.

    A mean pose has a low mean squared error, but its arms do not move (Mason et al. 2022, sections
    5.1 and 5.2.2).

    Of ``positions [F, ..., J, 3]`` over some seconds, metres: ``range [..., 2]``, the
    root-mean-square distance of the left and the right hand from their mean positions, metres; and
    ``together [...]``, the correlation of the fore and aft motion of both hands: 1 if they swing
    together, -1 if alternately, NaN if one does not move. ``layout`` names the J joints.
    """
    columns = [layout.names.index(layout.skeleton.roles[f"{side}_hand"]) for side in SIDES]
    hands = positions[..., columns, :]
    moved = hands - hands.mean(0)
    left, right = moved[..., 2].unbind(-1)
    together = (left * right).sum(0) / (left.square().sum(0) * right.square().sum(0)).sqrt()
    return {"range": moved.square().sum(-1).mean(0).sqrt(), "together": together}

def hands(layout: Layout, joints: Tensor, clips: Tensor, speed: float) -> dict[str, float]:
    """Movement of the hands in a walk, compared with the style clips nearest to it in velocity.

    The walk has features ``joints [F, 12 J]``, at least `WINDOW` frames, and a ``speed`` in m/s;
    the style clips of the data are ``clips [M, 240, 12 J]``. The result has ``hands``, the range
    (`hand_swing`) as a share of ``hands_data``, the data's range in metres; ``swing`` and
    ``swing_data``, the correlation of the two hands; ``together``, the absolute difference of these
    two.
    """
    windows = joints.unfold(0, WINDOW, WINDOW).transpose(1, 2)
    made, real = (hand_swing(layout, split_joints(y)["position"].transpose(0, 1))
                  for y in (windows, nearest(clips, speed)))
    swing, swing_data = (float(found["together"].nanmean()) for found in (made, real))
    moved = float(made["range"].mean() / real["range"].mean())
    return {"hands": moved, "hands_data": float(real["range"].mean()), "swing": swing,
            "swing_data": swing_data, "together": abs(swing - swing_data)}


def stored(folder: Path) -> dict[str, dict]:
    """Results of ``experiments seven-models`` on a hundred styles, by name; {} if there are none.
    """
    found = {file.stem.removeprefix("hundred-"): json.loads(file.read_text("utf-8"))
             for file in sorted(folder.glob("hundred-*.json"))}
    vectors = folder / "style-vectors-long.json"
    return found | {"vectors": json.loads(vectors.read_text("utf-8"))} if found else {}


def spread(values: Sequence[float] | float, scale: float = 1.0) -> str:
    """Mean, and half of the range of the seeds."""
    found = scale * torch.atleast_1d(torch.as_tensor(values))
    half = float(found.max() - found.min()) / 2
    return f"{found.mean():.3g}" + (f" ± {half:.1g}" if half > 1e-4 else "")


def summary(stored: dict[str, dict]) -> tuple[pd.DataFrame, dict, dict[str, float]]:
    """A table of the models after both trainings; their rows by training and model; passes through
    the data.
    """
    table, values, passes = {}, {}, {}
    for run in ("styles", "long") if stored else ():
        about = stored[run]["settings"]
        passes[run] = about["steps"] * about["batch"] / about["frames"]
        for row in stored[run]["rows"]:
            values[run, row["model"]] = row
            seen = f"{passes[run]:.2g} passes" if "seeds" in row else ""
            table[row["model"], seen] = {
                name: spread(row[key], scale) for name, (key, scale) in SHOWN.items()
                if row.get(key) is not None}
    return pd.DataFrame(table).T.fillna(""), values, passes


def after_long_training(stored: dict[str, dict], values: dict) -> SimpleNamespace:
    """The three modulations of the LPN: errors, shares of recognised walks (FiLM's, the others',
    of vectors fitted to frames), shoulders (cm; between clips of the data), and whether FiLM had
    the largest or the smallest error with every seed of the shorter training.
    """
    late = pd.DataFrame({kind: {key: values["long", kind][key][0] for key in (
        "shared", "recognised", "clavicle")} for kind in LPN}).T
    early = {kind: values["styles", kind]["shared"] for kind in LPN}
    fitted = {row["vector"]: row["recognised"][0] for row in stored["vectors"]["rows"]}
    return SimpleNamespace(
        error=late["shared"], film=late["recognised"]["lpn-film"],
        rest=late["recognised"].drop("lpn-film").min(), fitted=fitted["fitted to frames"],
        wide=100 * late["clavicle"],
        between=stored["long"]["numbers"]["clavicle: between clips of the data, cm"],
        worst_early=all(min(early["lpn-film"]) > max(early[kind]) for kind in LPN[1:]),
        best_early=all(max(early["lpn-film"]) < min(early[kind]) for kind in LPN[1:]))


def stuck(stored: dict[str, dict]) -> SimpleNamespace:
    """Numbers of styles, one for each seed, whose hands move less than half as far as in the data:
    of MANN and LPN (``moving`` styles in all), and of PFNN and LPN, ``again``.
    """
    runs = [stored[name]["rows"] for name in ("no-phase-features", "no-global-phase")]
    counts = [{row["model"]: row["styles below 0.5"] for row in rows} for rows in runs]
    return SimpleNamespace(
        mann=counts[0]["mann-film"], lpn=counts[0]["lpn-film"], pfnn=counts[1]["pfnn-film"],
        again=counts[1]["lpn-film"], moving=[rows[0]["of styles"] for rows in runs],
        best=max(max(found["published"]) for found in counts))


def shoulders(stored: dict[str, dict]) -> dict[str, list[float]]:
    """How far shoulders are off, cm, by model, one number for each seed."""
    return {row["model"]: row["clavicle, cm"] for row in stored["artifacts"]["rows"]}


def blends(stored: dict[str, dict]) -> dict[str, SimpleNamespace]:
    """By model: the widest of ten steps of a blend, as a share of the change of the gait and of a
    classifier's odds (``leap``), and where the second style begins to win (``cross``).
    """
    return {row["model"]: SimpleNamespace(gait=row["gait's widest"], leap=row["widest step"],
                                          cross=row["crosses at"])
            for row in stored["interpolation"]["rows"]}
