"""Train and measure every model on the same data, seeds and budget; runs are stored whole, so that a stopped one goes on."""

import dataclasses
import json
import math
import os
import platform
import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import torch
from torch import Tensor
from tqdm import tqdm

from experiments.closed_loop import eight
from toolkit import networks, runtime, training
from toolkit.evaluation import metrics, recognition
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import Features, Layout, Normaliser, split_joints, splits
from toolkit.io import model_files
from toolkit.io.files import atomic_write
from toolkit.networks import Model, Sizes
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS, CharacterState, Command
from toolkit.training import Config, Run, loss

SHARED = ("trajectory", "joints", "contacts")  # blocks of z that every model predicts
WARM_UP, PACE = 2.0, 1.0  # seconds of a walk straight ahead that are not measured; m/s round the eight
WINDOW = 240  # frames over which the hands' range is taken, as long as a style clip
MOVING = 0.06  # metres of range from which hands count as moving
HANDS = ("hands", "hands_data", "swing", "swing_data", "together")
ALIKE = 4  # style clips that a walk is held beside: those nearest to it in velocity
SETTINGS, TABLE = "settings.json", "comparison.json"
SIZES = {
    "tiny": Sizes(hidden=32, experts=4, gating=16, film_channels=8, film_kernel=5, film_dense=32, dropout=0.0),
    "small": Sizes(hidden=128, gating=16, film_channels=16, film_kernel=9, film_dense=128, rank=16, dropout=0.1),
    "medium": Sizes.small(),
    "paper": Sizes(),
}  # what ``--size`` means


#: Rates of the style modulation as shares of the rest's. FiLM's convolutions die of high ones. Tables of styles need high
#: ones, a one-hot's most of all, or short training hardly finds them: a row learns only in its own style's minibatches.
STYLE_RATES = {"film": 0.1, "onehot": 10.0, "resad": 1.0}


@dataclass(frozen=True)
class Plan:
    """How all runs of a folder are trained, and how long they are watched."""

    size: str = "small"  # a key of `SIZES`
    steps: int = 4000  # budget of every run, minibatches
    device: str = "cpu"
    walk: float = 8.0  # seconds of the walk straight ahead that are measured, at least 4
    radius: float = 1.5  # metres, of the eight's two loops
    lessons: int = recognition.STEPS  # minibatches of the recogniser

    def config(self, model: str, seed: int) -> Config:
        """How one run is trained: all alike but for `STYLE_RATES`."""
        return Config.quick(model=model, sizes=SIZES[self.size], steps=self.steps, seed=seed, device=self.device,
                            style_rate=STYLE_RATES[model.split("-")[1]], evaluate_every=max(1, self.steps // 4))


def settle(folder: Path, plan: Plan, data: Features, source: dict) -> dict:
    """Write down what a folder compares, and give it back; ``source`` says where the data come from.

    Raises
    ------
    ValueError
        If it holds a comparison of other data, size or budget.
    """
    own = {"size": plan.size, "steps": plan.steps, "frames": {s: len(x) for s, x in data.inputs.items()}}
    path = folder / SETTINGS
    if not path.exists():
        write_json(path, own | {"source": source})
    held = read_json(path)
    if why := model_files.difference({key: held[key] for key in own}, own):
        raise ValueError(f"{folder}: holds a comparison with other settings ({why}); choose another --out")
    return held


def trained(data: Features, config: Config, folder: Path, progress: bool = False) -> Run:
    """The run of a config in a folder: read, or trained first, from its checkpoint on where there is one.

    Raises
    ------
    ValueError
        If the stored run or checkpoint was trained in another way.
    """
    path = folder / "runs" / f"{config.model}-{config.seed}.safetensors"
    if path.exists():
        run = training.load(path)
        if why := model_files.difference(config.fixed(), run.config.fixed()):
            raise ValueError(f"{path}: was trained in another way ({why}); choose another --out")
        return run
    path.parent.mkdir(parents=True, exist_ok=True)
    checkpoint = path.with_suffix(".checkpoint")
    run = training.fit(data, config, checkpoint, progress=progress)
    run.save(path)
    checkpoint.unlink(missing_ok=True)
    return run


def judge(data: Features, folder: Path, lessons: int = recognition.STEPS) -> Recogniser:
    """The folder's recogniser of the data's styles, trained first where there is none."""
    path = folder / "recogniser.safetensors"
    if not path.exists():
        recognition.train(data, steps=lessons).save(path)
    return Recogniser.load(path)


def measured(run: Run, data: Features, plan: Plan, recogniser: Recogniser, folder: Path) -> dict:
    """The measures of a run in a folder: read, or taken first.

    Returns
    -------
    dict
        ``styles``: style to its measures; all the others are means, see `over_styles`.
    """
    path = folder / "measures" / f"{run.config.model}-{run.config.seed}.json"
    if not path.exists():
        train, test = splits.split(data, run.config.held_out, run.config.seed, tuple(data.styles))
        shared = shared_error(run.model, run.bank, test, train.normalisers()["outputs"])
        loop = closed_loop(run.model, run.bank, data, recogniser, plan)
        styles = {s: {"shared": shared[s], **run.held_out[s], **loop[s]} for s in shared}
        write_json(path, {"seconds": run.history[-1]["elapsed"], "steps": run.history[-1]["step"], "styles": styles})
    found = read_json(path)
    return found | over_styles(found["styles"])


def over_styles(styles: dict[str, dict[str, float]]) -> dict[str, float]:
    """Means of measures over the styles; of hands over those whose hands move in the data."""
    moving = [row for row in styles.values() if row["hands_data"] > MOVING]
    every = list(styles.values())
    return {key: average([row[key] for row in (moving if key in HANDS else every)]) for key in every[0]}


def shared_error(model: Model, bank: StyleBank, test: Features, scale: Normaliser) -> dict[str, float]:
    """Mean squared error, per style, over the blocks of z that every model predicts, each column in deviations of the data.

    A model's own full error also counts what only some predict (local phases, a global phase, none): it does not compare.
    ``scale`` are the statistics of the data's ``outputs``.
    """
    errors = {}
    for style in (s for s in test.styles if len(test.inputs[s])):
        rows, total = torch.arange(len(test.inputs[style])), 0.0
        for part in rows.split(1024):
            x, p, z = (getattr(test, kind)[style][part] for kind in ("inputs", "phases", "outputs"))
            p, wanted = model.observe(p, z)
            off = _shared(model.layout, model.predict(x, p, bank[style]) - wanted) / _shared(test.layout, scale.std)
            total += len(part) * float(off.square().mean())
        errors[style] = total / len(rows)
    return errors


def shared_baselines(data: Features, held_out: float, seed: int) -> dict[str, float]:
    """The same error of predicting the training data's ``mean``, and of the current frame once more (``repeat``)."""
    train, test = splits.split(data, held_out, seed, tuple(data.styles))
    normaliser = train.normalisers()["outputs"]
    errors: dict[str, list[float]] = {"mean": [], "repeat": []}
    for style in (s for s in test.styles if len(test.inputs[s])):
        x, p, z = (getattr(test, kind)[style][:] for kind in ("inputs", "phases", "outputs"))
        still = loss.repeat_frame(data.layout, x, p, normaliser.mean)
        for name, guess in (("mean", normaliser.mean), ("repeat", still)):
            errors[name].append(float(_shared(data.layout, (z - guess) / normaliser.std).square().mean()))
    return {name: average(values) for name, values in errors.items()}


def _shared(layout: Layout, z: Tensor) -> Tensor:
    return torch.cat([z[..., layout.outputs[name]] for name in SHARED], -1)


def closed_loop(model: Model, bank: StyleBank, data: Features, recogniser: Recogniser,
                plan: Plan) -> dict[str, dict[str, float]]:
    """What every style does on its own: straight ahead at the data's usual speed of that style, then round an eight.

    Returns
    -------
    dict
        Per style: ``upright`` (1, or 0 where it fell or a number is not finite); ``speed``, share of the command; ``skate``
        and ``skate_ik``, m/s of the toes in contact, without and with foot IK, the worse foot; ``path``, metres from the
        eight; ``hands``, the hands' range as a share of that in the style clips which are nearest in velocity, which is
        ``hands_data`` metres; ``swing`` and ``swing_data``, the correlation of both hands, and ``together``, how far apart
        these are; ``probability`` that the recogniser gives to the right style, and whether that is the ``recognised`` one.
    """
    speeds = {style: usual_speed(data.clips[style][:]) for style in data.styles}
    vectors = torch.stack([bank[style] for style in data.styles])
    velocity = torch.tensor([[0.0, speeds[style]] for style in data.styles])
    warm = round(WARM_UP * FPS)
    course = eight(plan.radius)
    walk = states(model, [Command(velocity)] * (warm + round(plan.walk * FPS)), vectors)[warm:]
    laps = states(model, runtime.follow(course.tolist(), PACE), vectors)
    joints = torch.stack([s.joints for s in walk], 1)  # [B, F, 12 J]
    seen = recogniser.probabilities(torch.cat((joints, torch.stack([s.joints for s in laps], 1)), 1).nan_to_num())
    rows = {}
    for i, style in enumerate(data.styles):
        row = _gait(model, walk, laps, course, i)
        row |= _hands(data.layout, joints[i], data.clips[style][:], row["speed"])
        right = recogniser.styles.index(style)
        row |= {"probability": float(seen[i, right]), "recognised": float(seen[i].argmax() == right)}
        rows[style] = row | {"speed": row["speed"] / speeds[style]}
    return rows


def states(model: Model, commands: Sequence, vectors: Tensor, first: CharacterState | None = None) -> list[CharacterState]:
    """All states of a crowd, one character per style vector; the vectors themselves, which may be large, are left out."""
    return [dataclasses.replace(s, style=s.style[:, :0]) for s in runtime.states(model, commands, vectors, first)]


def usual_speed(clips: Tensor) -> float:
    """Median speed, m/s, of those style clips ``[M, 240, 12 J]`` that walk ahead; 1 where none does."""
    ahead = _velocity(clips)
    forward = ahead[(ahead[:, 1] > 0.2) & (ahead[:, 1] > 2 * ahead[:, 0].abs()), 1]
    return float(forward.median()) if len(forward) else 1.0


def nearest(clips: Tensor, speed: float) -> Tensor:
    """The `ALIKE` of style clips whose mean velocity, in the root frame, is nearest to ``speed`` m/s straight ahead."""
    return clips[(_velocity(clips) - torch.tensor([0.0, speed])).norm(dim=-1).argsort(stable=True)[:ALIKE]]


def _velocity(clips: Tensor) -> Tensor:
    return split_joints(clips)["velocity"][:, :, 0, [0, 2]].mean(1)


def _gait(model: Model, walk: list[CharacterState], laps: list[CharacterState], course: Tensor, i: int) -> dict[str, float]:
    contact = torch.stack([s.contacts[i] for s in walk])
    try:
        plain, clip = (runtime.record(model, walk, feet=ik, arms=ik, character=i) for ik in (False, True))
        lap = runtime.record(model, laps, feet=False, arms=False, character=i)
    except ValueError:  # a Clip refuses numbers that are not finite
        return {"upright": 0.0} | dict.fromkeys(("speed", "skate", "skate_ik", "path"), math.nan)
    skate, skate_ik = (max((v for v in metrics.foot_skate(c, contact).values() if not math.isnan(v)), default=math.nan)
                       for c in (plain, clip))
    return {"upright": float(metrics.upright(clip) and metrics.upright(lap)), "speed": metrics.speed(clip),
            "skate": skate, "skate_ik": skate_ik, "path": metrics.path_error(lap, course)}


def _hands(layout: Layout, joints: Tensor, clips: Tensor, speed: float) -> dict[str, float]:
    windows = joints.unfold(0, WINDOW, WINDOW).transpose(1, 2)
    made, real = (metrics.hand_swing(layout, split_joints(y)["position"].transpose(0, 1))
                  for y in (windows, nearest(clips, speed)))
    swing, swing_data = (float(found["together"].nanmean()) for found in (made, real))
    return {"hands": float(made["range"].mean() / real["range"].mean()), "hands_data": float(real["range"].mean()),
            "swing": swing, "swing_data": swing_data, "together": abs(swing - swing_data)}


def frame_time(model: Model, style: Tensor, runs: int = 5, frames: int = 60) -> tuple[float, float]:
    """Mean and deviation, over some runs, of the milliseconds that one character's next frame takes."""
    command, times = Command((0.0, 1.0)), []
    with torch.no_grad():
        state = runtime.start(model, style)
        for _ in range(runs + 1):
            began = time.perf_counter()
            for _ in range(frames):
                state = runtime.step(model, state, command)
            times.append(1000 * (time.perf_counter() - began) / frames)
    return statistics.mean(times[1:]), statistics.stdev(times[1:])  # the first run warms up


def compare(data: Features, source: dict, plan: Plan, models: Sequence[str], seeds: int, folder: Path,
            progress: bool = False) -> dict:
    """Train and measure models with seeds 0, 1 …; what the folder holds already is not done again.

    Two processes may work on different models in one folder.

    Returns
    -------
    dict
        What is also stored as `TABLE`: ``settings``, ``machine``, ``baselines`` and ``models``. A model has its parameter
        ``counts``, the milliseconds of a ``frame``, its ``runs`` in the order of the seeds, and of every measure the
        ``mean`` and the ``spread`` (deviation) over the seeds.
    """
    settings, recogniser = settle(folder, plan, data, source), judge(data, folder, plan.lessons)
    found, frame, counts = {name: [] for name in models}, {}, {}
    jobs = [(name, seed) for seed in range(seeds) for name in models]
    for name, seed in tqdm(jobs, desc="compare", unit="run", disable=None if progress else True):
        run = trained(data, plan.config(name, seed), folder, progress)
        found[name].append(measured(run, data, plan, recogniser, folder))
        if seed == 0:
            frame[name], counts[name] = frame_time(run.model, run.bank.vectors[0]), networks.counts(run.model)
    config = plan.config(models[0], 0)
    baselines = [shared_baselines(data, config.held_out, seed) for seed in range(seeds)]
    table = {
        "settings": settings | {"seeds": seeds, "batch": config.batch, "rate": config.rate, "style_rates": STYLE_RATES},
        "machine": machine(plan.device), "recogniser": recogniser.accuracy(data),
        "baselines": {name: _spread([b[name] for b in baselines]) for name in baselines[0]},
        "models": {name: {"counts": counts[name], "frame": frame[name], **_summary(runs)} for name, runs in found.items()},
    }
    write_json(folder / TABLE, table)
    return table


def _summary(runs: list[dict]) -> dict:
    spreads = {key: _spread([run[key] for run in runs]) for key in runs[0] if key != "styles"}
    return {"runs": runs, "mean": {k: v[0] for k, v in spreads.items()}, "spread": {k: v[1] for k, v in spreads.items()}}


def _spread(values: list[float]) -> tuple[float, float]:
    return average(values), statistics.stdev(values) if len(values) > 1 else 0.0


def average(values: Sequence[float]) -> float:
    """Mean of those values that are numbers."""
    return float(torch.tensor(values, dtype=torch.float64).nanmean())


def machine(device: str) -> dict[str, str | int]:
    """What the times were taken on."""
    where = torch.cuda.get_device_name(device) if device.startswith("cuda") else platform.machine()
    return {"device": where, "cores": os.cpu_count() or 1, "threads": torch.get_num_threads(), "torch": torch.__version__}


def read_json(path: Path) -> dict:
    """What `write_json` wrote; a file that is damaged or not there is a one-line ValueError."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ValueError(f"{path}: missing; `seven-models --data … --out {path.parent}` makes it") from None
    except (OSError, json.JSONDecodeError) as error:
        raise ValueError(f"{path}: cannot be read ({error})") from error


def write_json(path: Path, value: dict) -> None:
    """Write a file, whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(path) as file:
        file.write((json.dumps(value, indent=1) + "\n").encode())
