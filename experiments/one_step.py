"""Prediction errors one step ahead from real input: of the clip's own style, and the rank of this
style among all.
"""

from pathlib import Path
from typing import Annotated

import typer
from torch import Tensor

from experiments.tables import Result, Store
from toolkit import features, published
from toolkit.cli import verbs
from toolkit.extra.characters.retargeting import retarget
from toolkit.io import bvh
from toolkit.motion import Clip
from toolkit.networks import Predictor
from toolkit.networks.bank import StyleBank

STORED, EVERY = "one-step", 8  # the result; frames apart of which styles are ranked
#: Columns of the stored result.
COLUMNS = {"take": ["take"], "frames": ["frames", 0], "style": ["style"],
           "error": ["joint error", 4],
           "right": ["contact correlation: right", 3], "left": ["left", 3],
           "phase": ["phase error", 3],
           "rank": ["rank of the style", 0], "of": ["of", 0], "other": ["nearest other style"],
           "next": ["its error", 4],
           "repeat": ["repeating the frame", 3], "mean": ["the mean pose", 3]}
#: Asked of the published network, calibrated, on Neutral_FW.
AIM = {"take": "aim, calibrated: Neutral_FW.bvh", "error": 0.022, "right": 0.91, "left": 0.91,
       "phase": 0.20}

Take = Annotated[Path, typer.Option(
    "--clip", help="A BVH file; `one-step` retargets another skeleton than the model's.")]
Style = Annotated[str, typer.Option(help="Style of the clip.")]
Start = Annotated[int, typer.Option(help="First frame (100STYLE: START of Frame_Cuts.csv).")]


def run(
    clip: Take,
    style: Style,
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    start: Start = 0,
    calibrated: Annotated[bool, typer.Option("--calibrated",
                                             help="Use calibrated inference.")] = False,
    store: Store = False,
) -> None:
    """Errors of the predicted next frames of a real clip with its own style, compared with all
    other styles and with floors.

    The inputs are the features and phases of the clip. Its own style should have the smallest error
    of all.
    """
    net, bank = published.either(model, parameters)
    net.calibrated = calibrated
    motion = bvh.load(clip)
    if features.Layout(motion.skeleton).names != net.layout.names:
        motion = retarget(motion, net.layout.skeleton).replace(name=f"{clip.name}, retargeted")
    row = published.one_step(net, bank, motion, style, (start, None))
    right, left = row["contact_correlation"]
    errors, floors = ranked(net, bank, motion, (start, None))
    other = next(name for name in errors if name != style)
    kind = "published" if parameters else "embedded" if model is None else "trained"
    row = {"take": f"{kind}{', calibrated' * calibrated}: {motion.name}",
           "frames": row["frames"], "style": style, "error": row["joint_mse"], "right": right,
           "left": left, "phase": row["phase_error"], "rank": list(errors).index(style) + 1,
           "of": len(errors), "other": other, "next": errors[other], **floors}
    made = Result(STORED,
                  "Predictions one step ahead from real input, in the model's normalised units, "
                  "and the rank of the take's style among all by the joint error",
                  "python -m experiments one-step --published "
                  "DATA/lpn_film_100style --clip DATA/100style/Neutral_FW.bvh --style Neutral "
                  "--start 327 [--calibrated] --store", COLUMNS, [AIM, row])
    made.show(store=False)
    print("first: " + ", ".join(f"{name} {errors[name]:.4f}" for name in list(errors)[:5]))
    if store:
        made.add()


def ranked(net: Predictor, bank: StyleBank, clip: Clip,
           frames: tuple[int, int | None]) -> tuple[dict[str, float], dict[str, float]]:
    """Joint errors as of `toolkit.published.one_step` by style, the smallest first; of repeating
    the frame and of the mean.

    Of every `EVERY`-th frame: calibrated inference in a hundred styles takes minutes.
    """
    rows = published.frames_of(net.layout, clip, frames)
    inputs, (phase, target) = rows.inputs[::EVERY], net.observe(rows.phases[::EVERY],
                                                                rows.outputs[::EVERY])
    now, joints = net.normaliser("outputs"), net.layout.outputs["joints"]

    def error(z: Tensor) -> float:
        return float(((z - target) / now.std)[:, joints].square().mean())

    errors = {name: error(net.predict(inputs, phase, bank[name])) for name in bank.names}
    same = target.clone()
    same[:, joints] = inputs[:, net.layout.inputs["joints"]]
    return dict(sorted(errors.items(), key=lambda item: item[1])), {"repeat": error(same),
                                                                    "mean": error(now.mean)}
