"""The authors' published parameters of LPN-FiLM, 100 styles, run by this package's own networks.

`toolkit.datasets.published_files` describes their files, which are for research and education. This
package does not contain them: the user provides the folder.
"""

import math
import os
from pathlib import Path

import torch

from toolkit import features
from toolkit.datasets import home, published_files as parameters
from toolkit.datasets.procedural import SKELETON
from toolkit.features import Layout, Normaliser
from toolkit.motion import Clip, trajectory
from toolkit.networks import Predictor, Sizes, build
from toolkit.networks.bank import StyleBank
from toolkit.training import run

DATASET = "lpn-film-100style"  # their name in `toolkit.datasets.fetch`

#: Sample offsets of the published run: 1/6 s apart in the past, 1/5 s apart in the future.
SAMPLES = (-60, -50, -40, -30, -20, -10, 0, 12, 24, 36, 48, 60)

#: Style names by index: the 95 trained ones, then the five that were kept for fine-tuning.
_NAMES = """
    Aeroplane Akimbo Angry ArmsAboveHead ArmsBehindBack ArmsBySide ArmsFolded Balance BeatChest
    BentForward BentKnees BigSteps BouncyLeft BouncyRight Cat Chicken CrossOver Crouched
    CrowdAvoidance Depressed Dinosaur DragLeftLeg DragRightLeg Drunk DuckFoot Elated FairySteps
    Flapping FlickLegs Followed GracefulArms HandsBetweenLegs Heavyset HighKnees InTheDark
    KarateChop Kick LawnMower LeanBack LeanLeft LeanRight LeftHop LegsApart LimpLeft LimpRight
    LookUp Lunge March Monk Morris Neutral Old OnHeels OnPhoneLeft OnPhoneRight
    OnToesBentForward OnToesCrouched PendulumHands Penguin PigeonToed Proud Punch Quail
    RaisedLeftArm RaisedRightArm RightHop Robot Rocket Rushed ShieldedLeft ShieldedRight
    SlideFeet SpinAntiClock SpinClock StartStop Stiff Strutting Superman Swat Sweep Swimming
    SwingArmsRound SwingShoulders Teapot Tiptoe TogetherStep TwoFootJump WalkingStickLeft
    WalkingStickRight Waving WhirlArms WideLegs WiggleHips WildLegs Zombie HandsInPockets
    Roadrunner Skip Star WildArms
"""
STYLES = tuple(_NAMES.split())
#: Styles in which `toolkit.evaluation.defects` finds something in half of the seconds of a natural
#: walk: shaking, gliding, one foot above the other.
BROKEN = "Drunk", "RightHop", "Skip"


def available() -> bool:
    """Whether `load` finds them without a folder, as after
    ``python -m toolkit data fetch lpn-film-100style``.
    """
    return home.folder(DATASET).is_dir()


LIFE = 0.25  # ours: with it, upper bodies move about as slowly and as far as in recorded takes
LIFT = 1.2  # ours: without it, the feet of the published network swing a third too low


def load(folder: str | os.PathLike | None = None, *, calibrated: bool = False) -> run.Run:
    """The published model and its 100 style vectors, ``model, bank = load(folder)``.

    The model has no FiLM generator: only the style vectors that it gave were published. Each part
    of the vector of Drunk is two to five times as long as the median of the others', and a
    character with it hardly walks. ``life`` and ``lift`` of the model are ours: 0 and 1 turn them
    off.

    The ``folder`` holds ``Xmean.bin``, ``cp0_a0.bin``, ``Style_000_scale1.bin`` …; None or
    ``"lpn-film-100style"`` for that of downloaded data (`toolkit.datasets.home`). ValueError if a
    file is missing, of another size, or holds a number that is not finite.

    A ``calibrated`` model computes the expected output under dropout, see `toolkit.networks.Model`.
    This halves the joint error of one-step predictions on real motion, but it is slower and differs
    from the published run.
    """
    if folder is None or os.fspath(folder) == DATASET:
        folder = home.find(DATASET, "Xmean.bin, cp0_a0.bin, …",
                           "https://github.com/ianxmason/local-phases")
    files = parameters.read(Path(folder))
    read = {name: torch.from_numpy(values) for name, values in files.items()}
    layout, sizes = Layout(SKELETON, samples=SAMPLES), Sizes()
    normalisers = {kind: Normaliser(read[f"{file}mean"], read[f"{file}std"])
                   for kind, file in (("inputs", "X"), ("phases", "GT_X"), ("outputs", "Y"))}
    model = build("lpn-film", layout, len(STYLES), sizes, normalisers, generator=False)
    model.calibrated = calibrated
    with torch.no_grad():
        for i, layer in enumerate(model.gating.layers):
            layer.weight.copy_(read[f"wc{i}_w"])
            layer.bias.copy_(read[f"wc{i}_b"])
        for i, layer in enumerate(model.experts.layers):
            for k in range(sizes.experts):
                layer.weight[k] = read[f"cp{i}_a{k}"].T
                layer.bias[k] = read[f"cp{i}_b{k}"]
    model.life, model.lift = LIFE, LIFT
    vectors = torch.stack([torch.cat([read[f"Style_{i:03d}_{part}"]
                                      for part in parameters.STYLE_PARTS])
                           for i in range(len(STYLES))])
    speeds = torch.full((len(STYLES),), math.nan)
    speeds[: parameters.TRAINED] = read["Walk_Velocities"] / 12
    broken = torch.tensor([name in BROKEN for name in STYLES])
    return run.Run(model, StyleBank(STYLES, vectors, speeds, broken))


def either(file: str | os.PathLike | None, folder: str | os.PathLike | None) -> run.Run:
    """A model and its styles, of a run's ``file`` or the published ``folder``, or the embedded.

    The ``file`` may be a name (`toolkit.training.run.model_file`); for the ``folder`` see `load`.
    ValueError if both are given.
    """
    if file is not None and folder is not None:
        raise ValueError("give either --model FILE or --published FOLDER, not both")
    if folder is not None:
        return load(folder)
    return run.load(run.model_file(file or "procedural"))


def one_step(model: Predictor, bank: StyleBank, clip: Clip, style: str,
             frames: tuple[int, int | None] = (0, None)) -> dict:
    """How well a model predicts the next frame of a real clip.

    Features and phases are this package's own. With the published parameters, this is the strongest
    check that they agree with the paper's.

    Parameters
    ----------
    model, bank, style
        A model, its style vectors, and the name of one.
    clip
        Motion of the model's skeleton at any rate, resampled to 60 Hz.
    frames
        First and last (not included) frame to predict from, at the clip's rate. Their trajectory
        and phases use up to a second before and after; frames without a whole window are left out.

    Returns
    -------
    dict
        ``style``; the number of ``frames`` evaluated; ``joint_mse``, mean squared error of the 12 J
        joint features in the model's normalised units; ``contact_correlation`` [2], right and left;
        ``phase_error``, Σ(predicted − own)² / Σ own², NaN if the model predicts no phases.

    Raises
    ------
    ValueError
        If the clip's joints are not the model's, or no frame has a whole window.
    """
    joints, own = model.layout.names, Layout(clip.skeleton).names
    if joints != own:
        odd = next((n for n in (*own, *joints) if n not in joints or n not in own), "their order")
        raise ValueError(f"{clip.name}: the model moves {len(joints)} joints, the clip has "
                         f"{len(own)}; they differ in {odd}")
    rows = frames_of(model.layout, clip, frames)
    p, target = model.observe(rows.phases, rows.outputs)
    z = model.predict(rows.inputs, p, bank[style])
    error = (z - target) / model.normaliser("outputs").std
    own, predicted = (model.layout.unpack_output(v) for v in (target, z))
    pairs = torch.stack((predicted["contacts"], own["contacts"])).unbind(-1)
    phase_error = math.nan
    if "phases" in own:
        gap = predicted["phases"] - own["phases"]
        phase_error = float(gap.square().sum() / own["phases"].square().sum())
    return {
        "style": style,
        "frames": len(z),
        "joint_mse": float(error[:, model.layout.outputs["joints"]].square().mean()),
        "contact_correlation": [float(torch.corrcoef(pair)[0, 1]) for pair in pairs],
        "phase_error": phase_error,
    }


def frames_of(layout: Layout, clip: Clip, frames: tuple[int, int | None]) -> features.Frames:
    """Features of some frames of a real clip, see `one_step`, with up to a second around them."""
    (start, stop), scale, samples = frames, trajectory.FPS / clip.fps, layout.samples
    stop = None if stop is None else round(stop * scale) + samples[-1] + 1
    window = clip.resample(trajectory.FPS).cut(max(0, round(start * scale) + samples[0]), stop)
    return features.frames(window, samples=samples)
