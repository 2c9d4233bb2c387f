"""Phase sources compared by what they are for: models that differ in nothing but their phases, on
recorded takes that none of them saw.

No measure looks at a column of phases. A source wins where its model predicts poses, one step and
a second ahead, or walks more like the recordings.
"""

from pathlib import Path
from typing import Annotated

import scipy
import torch
import typer
from torch import Tensor

from experiments.stylewalk import parts
from experiments.tables import Result, Store
from toolkit import features, phases, training
from toolkit.extra.benchmark import Judges, score, walk
from toolkit.features import split_joints
from toolkit.motion import Clip, trajectory
from toolkit.networks.phase import advance
from toolkit.runtime.frame import to_frame
from toolkit.training import Run

GAITS = "walk", "run"
STEPS, SEEDS = 2000, (0, 1)  # of each training
APART, HALF, WHOLE = 30, 30, 60  # frames between the starts; after which errors are measured
BAND = (0.8, 3.0)  # Hz of steps
COLUMNS = {"source": ["source"], "step": ["one step", 4], "half": ["0.5 s, cm", 2, 100],
           "whole": ["1 s, cm", 2, 100], "style-recurrence": ["style", 3],
           "fmd-recurrence": ["fmd", 2], "defects": ["defects", 3], "skate": ["skate", 3]}


def constant(clip: Clip, limb: str) -> Tensor:
    """No phase: the floor."""
    return torch.zeros(len(clip))


class HipsHilbert:
    """An outsider's source: the angle of the analytic signal of the height of the hips.

    All limbs have the same phase, of a step and not of a stride.
    """

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """The height ``[F]`` in the band of steps."""
        height = clip.global_positions[:, clip.skeleton.role("hips"), 1].double().numpy()
        steps = scipy.signal.butter(2, BAND, "bandpass", fs=clip.fps, output="sos")
        return torch.from_numpy(scipy.signal.sosfiltfilt(steps, height).copy())

    def signal(self, curve: Tensor) -> Tensor:
        """The analytic signal ``[F]``, turned so that the sine of its angle is the curve."""
        return torch.from_numpy(scipy.signal.hilbert(curve.numpy())) * 1j


SOURCES = {"none": constant, "hybrid": "hybrid", "contact": "contact",
           "contact-free": "contact-free", "velocity": "velocity", "hips, Hilbert": HipsHilbert()}


def run(
    data: Annotated[Path, typer.Option(help="Folder that holds bandai/.")],
    out: Annotated[Path, typer.Option(help="Folder of the trained models.")] = Path("out/sources"),
    store: Store = False,
) -> None:
    """Train a model with each phase source, and compare what they predict and how they walk."""
    torch.set_num_threads(1)
    *seen, held_out = parts(data)
    seen = [clip for part in seen for clip in part if clip.gait in GAITS]
    held_out = [clip.resample(60) for clip in held_out if clip.gait in GAITS]
    out.mkdir(parents=True, exist_ok=True)
    judges, rows, still = Judges.load(), [], {}
    for name, source in SOURCES.items():
        found: dict[str, list[float]] = {}
        made = features.build(seen, source=source, short="skip")
        for seed in SEEDS:
            file = out / f"{name.replace(', ', '-')}-{seed}.safetensors"
            if not file.is_file():
                training.fit(made, training.Config.quick(steps=STEPS, seed=seed)).save(file)
            trained = training.load(file)
            errors, still = predicted(trained, held_out, source)
            walks = score(walk(*trained), judges, name).rows
            errors |= {key: walks[key.replace("-", " ")][0] for key in COLUMNS
                       if key.replace("-", " ") in walks}
            for key, value in errors.items():
                found.setdefault(key, []).append(value)
            print(name, seed, {key: f"{value:.4g}" for key, value in errors.items()}, flush=True)
        rows.append({"source": name} | found)
    rows.append({"source": "the pose stays"} | still)
    result = Result("sources", f"LPN-FiLM, {STEPS} steps with each phase source, "
                    f"{len(SEEDS)} seeds; walks and runs of Bandai-Namco 2, errors on "
                    f"{len(held_out)} takes that were held out.",
                    "python -m experiments sources --data DATA --store", COLUMNS, rows,
                    {"steps": STEPS, "takes": len(seen), "held out": len(held_out)})
    result.show(store)


def predicted(trained: Run, clips: list[Clip], source) -> tuple[dict[str, float], dict[str, float]]:
    """Errors of the joint columns: of a model, and of a pose that stays as it is.

    ``step`` is the mean squared error of the normalised columns one step ahead; ``half`` and
    ``whole`` are mean errors of joint positions, metres, half a second and a second ahead. For
    these the model gets its own poses and phases back, and the recorded trajectory.
    """
    model, bank = trained
    layout, errors = model.layout, {"step": [], "half": [], "whole": []}
    kept = {key: [] for key in errors}
    deviation = model.outputs_std[layout.outputs["joints"]]
    groups: dict[tuple[str, str], list[Clip]] = {}
    for clip in clips:
        groups.setdefault((clip.style, clip.gait), []).append(clip)
    for (style, _), group in groups.items():
        for clip, ph in zip(group, phases.extract_group(group, source=source), strict=True):
            if len(clip) < trajectory.WHOLE + WHOLE:
                continue
            rows = features.frames(clip, ph)
            x, p, z = rows.inputs, rows.phases, rows.outputs
            wanted = z[:, layout.outputs["joints"]]
            joints = model.predict(x, p, bank[style])[:, layout.outputs["joints"]]
            for some, guess in ((errors, joints), (kept, x[:, layout.inputs["joints"]])):
                some["step"].append(((guess - wanted) / deviation).square().mean(1))
            at = torch.arange(0, len(x) - WHOLE, APART)
            own, phase = x[at][:, layout.inputs["joints"]], p[at]
            first = split_joints(own)["position"]
            for frame in range(1, WHOLE + 1):
                path = x[at + frame - 1][:, layout.inputs["trajectory"]]
                given = layout.pack_input(trajectory=path, joints=own)
                blocks = layout.unpack_output(model.predict(given, phase, bank[style]))
                phase = advance(layout, phase, blocks)
                root = layout.unpack_output(z[at + frame - 1])["trajectory"][:, :4]
                here = root.new_tensor([0.0, 0.0, 0.0, 1.0]).expand_as(root)
                own = to_frame(blocks["joints"], here, root)
                if frame in (HALF, WHOLE):
                    key = "half" if frame == HALF else "whole"
                    truth = split_joints(x[at + frame][:, layout.inputs["joints"]])["position"]
                    for some, guess in ((errors, split_joints(own)["position"]), (kept, first)):
                        some[key].append((guess - truth).norm(dim=-1).mean(1))
    means = [{key: float(torch.cat(v).mean()) for key, v in some.items()}
             for some in (errors, kept)]
    return means[0], means[1]
