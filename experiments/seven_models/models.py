"""Train and measure all models with the same data, seeds and budget; runs and measures are stored
and can be resumed.
"""

import dataclasses
import json
import math
import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import torch
from course.comparison import block_errors, hands, over_columns, shared_baselines
from torch import Tensor
from tqdm import tqdm

from experiments.seven_models.posture import posture_error
from toolkit import datasets, features, networks, published, runtime, training
from toolkit.evaluation import metrics, recognition
from toolkit.evaluation.recognition import Recogniser
from toolkit.extra import store
from toolkit.features import Features, Normaliser, Split, natural_speed, splits
from toolkit.io import model_files
from toolkit.io.files import atomic_write
from toolkit.networks import Predictor, Sizes
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS, CharacterState, Command
from toolkit.training import Config, Run
from toolkit.training.run import STYLE_RATES

# seconds at the start of a walk that are not measured; m/s along the eight
WARM_UP, PACE = 2.0, 1.0
MOVING = 0.06  # metres, least range of moving hands
HANDS = ("hands", "hands_data", "swing", "swing_data", "together")
SETTINGS, TABLE, CEILING = "settings.json", "comparison.json", "ceiling.json"
HELD_OUT = 0.1  # share of every style's frames
SIZES = {
    "tiny": Sizes(hidden=32, experts=4, gating=16, film_channels=8, film_kernel=5, film_dense=32,
                  dropout=0.0),
    "small": Sizes(hidden=128, gating=16, film_channels=16, film_kernel=9, film_dense=128, rank=16,
                   dropout=0.1),
    "medium": Sizes.small(),
    "paper": Sizes(),
}  # values of ``--size``


@dataclass(frozen=True)
class Plan:
    """Settings of training and measurement for all runs in a folder."""

    size: str = "small"  # a key of `SIZES`
    steps: int = 4000  # training steps of every run
    device: str = "cpu"
    walk: float = 8.0  # measured seconds of the straight walk, at least 4
    radius: float = 1.5  # metres, of both loops of the eight
    # training steps of the recogniser; by default 20 per style, at least 200
    recogniser_steps: int | None = None

    def config(self, model: str, seed: int) -> Config:
        """Training settings of one run: equal for all runs except
        `toolkit.training.run.STYLE_RATES`.

        FiLM's style vectors are means over clips, as in the paper;
        `experiments.seven_models.vectors` compares fitted ones.
        """
        return Config.quick(model=model, sizes=SIZES[self.size], steps=self.steps, seed=seed,
                            device=self.device,
                            evaluate_every=max(1, self.steps // 2), held_out=HELD_OUT, refit=0)


def load(data: str, root: str | None, styles: str | None, gaits: str | None,
         clip_seconds: float | None,
         listed: bool = False) -> Features:
    """Features of a dataset or a store, with the same held-out frames for every seed.

    They are those of a store, or of the dataset's list (`toolkit.datasets.split`) if ``listed``, or
    random ones.
    """
    chosen = [None if names is None else names.split(",") for names in (styles, gaits)]
    if store.is_store(data):
        if root or gaits or listed:
            raise ValueError(f"{data}: a store allows no --root, --gaits and --listed, only "
                             f"--styles")
        found = store.load(data, chosen[0])
    else:
        options = {"seconds": clip_seconds} if data == "procedural" else {}
        clips = datasets.load(data, root, *chosen, **options)
        if listed:
            return splits.listed(clips, datasets.split(data, root), progress=True)
        found = features.build(clips, short="skip", progress=True)
    held_out = found.split or Split(None, None,
                                    splits.held_out(found, HELD_OUT, 0, tuple(found.styles)))
    return dataclasses.replace(found, split=dataclasses.replace(held_out, share=None, seed=None))


def settle(folder: Path, own: dict, data: dict | None = None) -> None:
    """Store the settings of a folder, with a description of the ``data``, or compare them with the
    stored ones.

    Raises
    ------
    ValueError
        If the folder holds a comparison with other settings.
    """
    path = folder / SETTINGS
    if not path.exists():
        write_json(path, own | (data or {}))
    held = read_json(path)
    if why := model_files.difference({key: held.get(key) for key in own}, own):
        raise ValueError(f"{folder}: holds a comparison with other settings ({why}); choose "
                         f"another --out")


def trained(data: Features, config: Config, folder: Path, progress: bool = False) -> Run:
    """The run of a config in a folder: read from its file, or trained, from its checkpoint if there
    is one.

    Raises
    ------
    ValueError
        If the stored run or checkpoint was trained with other settings.
    """
    path = folder / "runs" / f"{config.model}-{config.seed}.safetensors"
    times = path.with_suffix(".json")
    if path.exists():
        run = dataclasses.replace(training.load(path), history=read_json(times))
        if why := model_files.difference(config.fixed(), run.config.fixed()):
            raise ValueError(f"{path}: was trained with other settings ({why}); choose another "
                             f"--out")
        return run
    path.parent.mkdir(parents=True, exist_ok=True)
    checkpoint = path.with_suffix(".checkpoint")
    run = training.fit(data, config, checkpoint, progress=progress)
    write_json(times, run.history)  # with its times, which the model's file lacks
    run.save(path)
    checkpoint.unlink(missing_ok=True)
    return run


def judge(data: Features, folder: Path, steps: int | None = None) -> Recogniser:
    """The recogniser of a folder: read from its file, or trained on the style clips of the training
    frames.
    """
    path = folder / "recogniser.safetensors"
    if not path.exists():
        train = splits.split(data, HELD_OUT, 0, tuple(data.styles))[0]
        recognition.train(train,
                          steps=steps or max(recognition.STEPS, 20 * len(data.styles))).save(path)
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
        styles = both(run.model, run.bank, data, recogniser, plan)
        last = run.history[-1]
        write_json(path,
                   {"seed": run.config.seed, "seconds": last["elapsed"],
                    "processor": last["processor"],
                          "steps": last["step"], "history": run.history,
                          "counts": networks.counts(run.model),
                          "styles": {s: row | run.held_out[s] for s, row in styles.items()}})
    return read_json(path)


def both(model: Predictor, bank: StyleBank, data: Features, recogniser: Recogniser,
         plan: Plan) -> dict[str, dict[str, float]]:
    """Measures of every style: those of `one_step` on held-out frames, and those of
    `closed_loop`.
    """
    train, test = splits.split(data, HELD_OUT, 0, tuple(data.styles))
    errors = one_step(model, bank, test, train.normalisers()["outputs"])
    loop = closed_loop(model, bank, data, recogniser, plan)
    return {s: {**errors[s], **loop[s]} for s in errors}


def one_step(model: Predictor, bank: StyleBank, test: Features,
             scale: Normaliser) -> dict[str, dict[str, float]]:
    """``joints``: the error of the joint features; ``shared``: that of all columns that all models
    predict (`shared_error`).
    """
    return {style: {"shared": over_columns(test.layout, found), "joints": found["joints"]}
            for style, found in block_errors(model, bank, test, scale).items()}


def ceiling(parameters: str | os.PathLike, data: Features, recogniser: Recogniser, plan: Plan,
            folder: Path) -> dict:
    """The measures in closed loop of the network that made the data: read from their file, or
    computed.

    ``parameters`` is the folder of the published ones.
    """
    path = folder / CEILING
    if not path.exists():
        model, bank = published.load(parameters)
        speeds = [natural_speed(data.clips[style][:]) for style in data.styles]
        bank = StyleBank(tuple(data.styles), torch.stack([bank[style] for style in data.styles]),
                         torch.tensor(speeds))
        write_json(path, {"styles": closed_loop(model, bank, data, recogniser, plan)})
    return read_json(path)


def over_styles(styles: dict[str, dict[str, float]]) -> dict[str, float]:
    """Means of measures over the styles; measures of hands only over styles whose hands move in the
    data.
    """
    moving = [row for row in styles.values() if row["hands_data"] > MOVING]
    every = list(styles.values())
    return {key: average([row[key] for row in (moving if key in HANDS else every)])
            for key in every[0]}


def eight(radius: float) -> Tensor:
    """Points (x, z) ``[97, 2]`` of two touching circles, first the left one; the start is straight
    ahead.
    """
    t = torch.linspace(0.0, 2 * math.pi, 49)
    left = torch.stack((radius * (1 - t.cos()), radius * t.sin()), -1)
    return torch.cat((left, left[1:] * torch.tensor([-1.0, 1.0])))


def closed_loop(model: Predictor, bank: StyleBank, data: Features, recogniser: Recogniser,
                plan: Plan) -> dict[str, dict[str, float]]:
    """Measures of every style in closed loop: straight ahead at the style's usual speed in the
    data, then along an eight.

    Returns
    -------
    dict
        Per style: ``upright`` (1, or 0 if it fell or a value is not finite); ``speed`` / commanded
        speed; ``skate`` and ``skate_ik``, m/s of the toes in contact without and with foot IK, for
        the worse foot; ``path``, metres from the eight; ``hands``, the range of the hands divided
        by that in the style clips with the nearest velocity, ``hands_data`` metres; ``swing`` and
        ``swing_data``, the correlation of both hands, and ``together``, their absolute difference;
        ``clavicle`` and ``hand``, metres from the data's mean pose, see `posture_error`; ``steps``
        per second; ``probability`` of the right style by the recogniser, and whether it is
        ``recognised``, in the straight walk.
    """
    speeds = {style: bank.speed(style) for style in data.styles}
    vectors = torch.stack([bank[style] for style in data.styles])
    velocity = torch.tensor([[0.0, speeds[style]] for style in data.styles])
    warm = round(WARM_UP * FPS)
    course = eight(plan.radius)
    walk = states(model, [Command(velocity)] * (warm + round(plan.walk * FPS)), vectors)[warm:]
    laps = states(model, runtime.follow(course.tolist(), PACE), vectors)
    joints = torch.stack([s.joints for s in walk], 1)  # [B, F, 12 J]
    seen = recogniser.probabilities(joints.nan_to_num())
    rows = {}
    for i, style in enumerate(data.styles):
        row = _gait(model, walk, laps, course, i)
        clips = data.clips[style][:]
        row |= hands(data.layout, joints[i], clips, row["speed"])
        row |= posture_error(data.layout, joints[i], clips, row["speed"])
        right = recogniser.styles.index(style)
        row |= {"probability": float(seen[i, right]),
                "recognised": float(seen[i].argmax() == right)}
        rows[style] = row | {"speed": row["speed"] / speeds[style]}
    return rows


def states(model: Predictor, commands: Sequence, vectors: Tensor,
           first: CharacterState | None = None) -> list[CharacterState]:
    """All states of a crowd, one character per style vector, without the vectors, which may be
    large.
    """
    return [dataclasses.replace(s, style=s.style[:, :0])
            for s in runtime.states(model, commands, vectors, first)]


def _gait(model: Predictor, walk: list[CharacterState], laps: list[CharacterState], course: Tensor,
          i: int) -> dict[str, float]:
    contact = torch.stack([s.contacts[i] for s in walk])
    try:
        plain, clip = (runtime.record(model, walk, feet=ik, arms=ik, character=i)
                       for ik in (False, True))
        lap = runtime.record(model, laps, feet=False, arms=False, character=i)
    except ValueError:  # a Clip refuses numbers that are not finite
        return {"upright": 0.0} | dict.fromkeys(("speed", "skate", "skate_ik", "path", "steps"),
                                                math.nan)
    skate, skate_ik = (max((v for v in metrics.foot_skate(c, contact).values()
                            if not math.isnan(v)), default=math.nan)
                       for c in (plain, clip))
    return {"upright": float(metrics.upright(clip) and metrics.upright(lap)),
            "speed": metrics.speed(clip),
            "skate": skate, "skate_ik": skate_ik, "path": metrics.path_error(lap, course),
            "steps": metrics.feet(clip, contact)["steps"]}


def compare(data: Features, source: dict, plan: Plan, models: Sequence[str], seeds: int,
            folder: Path, progress: bool = False) -> dict:
    """Train and measure models with seeds 0, 1 …; finished runs in the folder are not repeated.

    Returns
    -------
    dict
        The content of `TABLE`, see `collect`.
    """
    recogniser = judge(data, folder, plan.recogniser_steps)
    own = {"size": plan.size, "steps": plan.steps,
           "frames": {style: len(x) for style, x in data.inputs.items()}}
    settle(folder, own, {"source": source})
    jobs = [(name, seed) for seed in range(seeds) for name in models]
    for name, seed in tqdm(jobs, desc="compare", unit="run", disable=None if progress else True):
        run = trained(data, plan.config(name, seed), folder, progress)
        measured(run, data, plan, recogniser, folder)
    return collect(data, plan, recogniser, folder)


def collect(data: Features, plan: Plan, recogniser: Recogniser, folder: Path) -> dict:
    """The measures of all finished runs in a folder, of any model and seed; written to `TABLE`.

    Returns
    -------
    dict
        ``settings``, ``machine``, ``baselines``, ``recogniser`` (share of held-out windows that it
        names rightly) and ``models``. A model has its parameter ``counts`` and its ``runs`` in the
        order of the seeds; ``ceiling`` is a run, too.
    """
    found = {name: sorted((_run(read_json(path))
                           for path in (folder / "measures").glob(f"{name}-*.json")),
                          key=lambda run: run["seed"]) for name in networks.MODELS}
    config = plan.config("lpn-film", 0)
    table = {
        "settings": read_json(folder / SETTINGS)
        | {"batch": config.batch, "rate": config.rate, "style_rates": STYLE_RATES},
        "machine": machine(plan.device), "recogniser": accuracy(recogniser, data),
        "baselines": shared_baselines(data, HELD_OUT, 0),
        "models": {name: {"counts": runs[0]["counts"], "runs": runs}
                   for name, runs in found.items() if runs},
    }
    if (folder / CEILING).exists():
        table["ceiling"] = _run(read_json(folder / CEILING))
    write_json(folder / TABLE, table)
    return table


def accuracy(recogniser: Recogniser, data: Features) -> float:
    """Share of the seconds of held-out motion that are recognised, mean over the styles; a second
    is 60 frames in a row.
    """
    test = splits.split(data, HELD_OUT, 0, tuple(data.styles))[1]
    joints, right = data.layout.inputs["joints"], []
    for number, style in enumerate(recogniser.styles):
        size = recognition.WINDOW
        rows = torch.arange(len(test.inputs[style]) // size * size).view(-1, size)
        frames = test.frames[style][rows]
        together = frames[:, -1] - frames[:, 0] == size - 1
        if together.any():
            windows = test.inputs[style][rows[together].flatten()][:, joints].unflatten(
                0, (-1, size))
            named = recogniser.probabilities(windows).argmax(-1)
            right.append(float((named == number).float().mean()))
    return average(right)


def _run(held: dict) -> dict:
    """A run's measures with their means over the styles; ``trained`` is its number of training
    steps.
    """
    return {"trained": held.get("steps", 0)} | held | over_styles(held["styles"])


def average(values: Sequence[float]) -> float:
    """Mean of the values that are not NaN."""
    return float(torch.tensor(values, dtype=torch.float64).nanmean())


def machine(device: str) -> dict[str, str | int]:
    """Description of the machine."""
    where = torch.cuda.get_device_name(device) if device.startswith("cuda") else platform.machine()
    return {"device": where, "cores": os.cpu_count() or 1, "threads": torch.get_num_threads(),
            "torch": torch.__version__}


def read_json(path: Path) -> dict | list:
    """Read a file of `write_json`; ValueError if it is damaged or missing."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        how = f"`seven-models --data … --out {path.parent}` makes it"
        raise ValueError(f"{path}: missing; {how}") from None
    except (OSError, json.JSONDecodeError) as error:
        raise ValueError(f"{path}: cannot be read ({error})") from error


def write_json(path: Path, value: dict | list) -> None:
    """Write a file, whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(path) as file:
        file.write((json.dumps(value, indent=1) + "\n").encode())
