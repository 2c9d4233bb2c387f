"""Train and measure all models with the same data, seeds and budget; runs and measures are stored and can be resumed."""

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
from toolkit.evaluation.models import hands, shared_baselines, shared_error
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import Features, splits
from toolkit.io import model_files
from toolkit.io.files import atomic_write
from toolkit.networks import Model, Sizes
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS, CharacterState, Command
from toolkit.training import Config, Run

WARM_UP, PACE = 2.0, 1.0  # seconds at the start of a walk that are not measured; m/s along the eight
MOVING = 0.06  # metres, least range of moving hands
HANDS = ("hands", "hands_data", "swing", "swing_data", "together")
SETTINGS, TABLE = "settings.json", "comparison.json"
SIZES = {
    "tiny": Sizes(hidden=32, experts=4, gating=16, film_channels=8, film_kernel=5, film_dense=32, dropout=0.0),
    "small": Sizes(hidden=128, gating=16, film_channels=16, film_kernel=9, film_dense=128, rank=16, dropout=0.1),
    "medium": Sizes.small(),
    "paper": Sizes(),
}  # values of ``--size``

#: Learning rates of the style modulation, relative to the other rates. High rates destroy FiLM's convolutions. Tables of
#: styles need high rates, one-hot the highest, because a row is trained only by the minibatches of its own style.
STYLE_RATES = {"film": 0.1, "onehot": 10.0, "resad": 1.0}


@dataclass(frozen=True)
class Plan:
    """Settings of training and measurement for all runs in a folder."""

    size: str = "small"  # a key of `SIZES`
    steps: int = 4000  # training steps of every run
    device: str = "cpu"
    walk: float = 8.0  # measured seconds of the straight walk, at least 4
    radius: float = 1.5  # metres, of both loops of the eight
    recogniser_steps: int = recognition.STEPS  # training steps of the recogniser

    def config(self, model: str, seed: int) -> Config:
        """Training settings of one run: equal for all runs except `STYLE_RATES`."""
        return Config.quick(model=model, sizes=SIZES[self.size], steps=self.steps, seed=seed, device=self.device,
                            style_rate=STYLE_RATES[model.split("-")[1]], evaluate_every=max(1, self.steps // 4))


def settle(folder: Path, plan: Plan, data: Features, source: dict) -> dict:
    """Store the settings of a folder, or compare them with the stored ones, and return them; ``source`` describes the data.

    Raises
    ------
    ValueError
        If the folder holds a comparison of other data, size or budget.
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
    """The run of a config in a folder: read from its file, or trained, from its checkpoint if there is one.

    Raises
    ------
    ValueError
        If the stored run or checkpoint was trained with other settings.
    """
    path = folder / "runs" / f"{config.model}-{config.seed}.safetensors"
    if path.exists():
        run = training.load(path)
        if why := model_files.difference(config.fixed(), run.config.fixed()):
            raise ValueError(f"{path}: was trained with other settings ({why}); choose another --out")
        return run
    path.parent.mkdir(parents=True, exist_ok=True)
    checkpoint = path.with_suffix(".checkpoint")
    run = training.fit(data, config, checkpoint, progress=progress)
    run.save(path)
    checkpoint.unlink(missing_ok=True)
    return run


def judge(data: Features, folder: Path, steps: int = recognition.STEPS) -> Recogniser:
    """The recogniser of the data's styles in a folder: read from its file, or trained."""
    path = folder / "recogniser.safetensors"
    if not path.exists():
        recognition.train(data, steps=steps).save(path)
    return Recogniser.load(path)


def measured(run: Run, data: Features, plan: Plan, recogniser: Recogniser, folder: Path) -> dict:
    """The measures of a run in a folder: read from their file, or computed.

    Returns
    -------
    dict
        ``styles``: style to its measures; the other values are means, see `over_styles`.
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
    """Means of measures over the styles; measures of hands only over styles whose hands move in the data."""
    moving = [row for row in styles.values() if row["hands_data"] > MOVING]
    every = list(styles.values())
    return {key: average([row[key] for row in (moving if key in HANDS else every)]) for key in every[0]}


def closed_loop(model: Model, bank: StyleBank, data: Features, recogniser: Recogniser,
                plan: Plan) -> dict[str, dict[str, float]]:
    """Measures of every style in closed loop: straight ahead at the style's usual speed in the data, then along an eight.

    Returns
    -------
    dict
        Per style: ``upright`` (1, or 0 if it fell or a value is not finite); ``speed`` / commanded speed; ``skate`` and
        ``skate_ik``, m/s of the toes in contact without and with foot IK, for the worse foot; ``path``, metres from the
        eight; ``hands``, the range of the hands divided by that in the style clips with the nearest velocity,
        ``hands_data`` metres; ``swing`` and ``swing_data``, the correlation of both hands, and ``together``, their absolute
        difference; ``probability`` of the right style by the recogniser, and whether it is ``recognised``.
    """
    speeds = {style: bank.speed(style) for style in data.styles}
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
        row |= hands(data.layout, joints[i], data.clips[style][:], row["speed"])
        right = recogniser.styles.index(style)
        row |= {"probability": float(seen[i, right]), "recognised": float(seen[i].argmax() == right)}
        rows[style] = row | {"speed": row["speed"] / speeds[style]}
    return rows


def states(model: Model, commands: Sequence, vectors: Tensor, first: CharacterState | None = None) -> list[CharacterState]:
    """All states of a crowd, one character per style vector, without the vectors, which may be large."""
    return [dataclasses.replace(s, style=s.style[:, :0]) for s in runtime.states(model, commands, vectors, first)]


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


def frame_time(model: Model, style: Tensor, runs: int = 5, frames: int = 60) -> tuple[float, float]:
    """Mean and deviation over some runs of the time for a frame of one character, milliseconds."""
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
    """Train and measure models with seeds 0, 1 …; finished runs in the folder are not repeated.

    Several processes may work on different models in one folder.

    Returns
    -------
    dict
        The content of `TABLE`: ``settings``, ``machine``, ``baselines`` and ``models``. A model has its parameter
        ``counts``, the milliseconds of a ``frame``, its ``runs`` in the order of the seeds, and the ``mean`` and ``spread``
        (deviation) of every measure over the seeds.
    """
    settings, recogniser = settle(folder, plan, data, source), judge(data, folder, plan.recogniser_steps)
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
    """Mean of the values that are not NaN."""
    return float(torch.tensor(values, dtype=torch.float64).nanmean())


def machine(device: str) -> dict[str, str | int]:
    """Description of the machine."""
    where = torch.cuda.get_device_name(device) if device.startswith("cuda") else platform.machine()
    return {"device": where, "cores": os.cpu_count() or 1, "threads": torch.get_num_threads(), "torch": torch.__version__}


def read_json(path: Path) -> dict:
    """Read a file of `write_json`; ValueError if it is damaged or missing."""
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
