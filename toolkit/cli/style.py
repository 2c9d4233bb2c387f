"""The verb `style`: add a style to a trained model from clips, and list the styles of a model."""

from pathlib import Path
from shlex import quote
from typing import Annotated

import typer
from typer import Option

from toolkit import registry, runtime
from toolkit.cli import motion_files
from toolkit.cli.verbs import Animation, Published, Roles, Seed, TrainedRun, Unit, Up, say
from toolkit.evaluation.findings import told
from toolkit.io import model_files, save as saving
from toolkit.io.files import below
from toolkit.io.load import readers
from toolkit.motion import Clip
from toolkit.networks import Predictor
from toolkit.networks.bank import StyleBank
from toolkit.styles.comparison import not_a_walk
from toolkit.styles.fine_tuning import METHODS, STEPS
from toolkit.styles.learning import learn
from toolkit.training import published
from toolkit.training.run import included, model_file

AXES = 3.0  # seconds of a model's walk, from which its skeleton's axes are measured

app = typer.Typer(no_args_is_help=True, add_completion=False)


@app.command("add")
def add(
    clips: Annotated[Path, Option(
        help="A motion file of the style, or a folder of them; whole files are used.")],
    name: Annotated[str, Option(help="Name of the new style.")],
    out: Annotated[Path, Option(help="File to write: the model, with one more style.")],
    model: TrainedRun = None,
    parameters: Published = None,
    steps: Annotated[int, Option(min=1, help="Steps of gradient descent.")] = STEPS,
    seed: Seed = 0,
    anyway: Annotated[bool, Option(
        "--anyway", help="Learn from what is no walk, and write a style that failed.")] = False,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
    animation: Animation = None,
) -> None:
    """Learn a style from one clip or more of at least 2 s, better 4 s; nothing else changes.

    The new style then walks at the longest clip's speed and on its path, and is compared with it:
    good, weak or failed. A failed style is not written.

    Motion of another rig is retargeted to the model's skeleton. The clips are learnt as they are,
    and with their mirror images if the walk is not good. A model that has its FiLM generator
    fine-tunes a copy of it; if the walk is not good, or a model has none, as the embedded one, only
    the style vector is optimised. Then vectors are trained on while they walk, until one walks
    well, for some minutes on each model.

    Without --model and --published, the style is learnt on each model that is there: procedural,
    recorded, and published, if its files were fetched. The one where it walks best is written.
    """
    if not clips.exists():
        raise ValueError(f"{clips}: no such file or folder")
    files = [clips]
    if clips.is_dir():
        files = [path for path in below(clips) if path.suffix.lower() in readers()]
    if not files:
        raise ValueError(f"{clips}: no motion file ({', '.join(readers())}) in this folder")
    if not name.strip() or any(c in name for c in "=,"):
        raise ValueError(f"a style's name must not be empty nor hold '=' or ',', got {name!r}")
    saving.check(out, ())
    motions = [motion_files.read(file, unit, up, roles, animation) for file in files]
    learnt = []
    for base in _bases(model, parameters):
        tensors, parts, network, bank = _read(base, parameters)
        if not isinstance(parts.setdefault("added", []), list):
            raise ValueError(f"{base}: its list of added styles is damaged")
        say(f"{base or 'published'}:")
        shown = [fitted(motion, network, bank) for motion in motions]
        for clip in shown:
            if (why := not_a_walk(clip)) and not anyway:
                raise ValueError(f"{clip.name}: {why}; no style was learnt (--anyway learns it)")
        best = learn(network, bank, shown, name, steps=steps, seed=seed, progress=True)
        held_out = best.made.held_out[name]
        say("{}: held-out frames: mean squared error {before:.3f} before, {after:.3f} after; "
            "{repeat:.3f} by repeating the frame, {mean:.3f} by the mean".format(
                METHODS[best.made.method], **held_out))
        say(str(best.compared))
        say(told(best.compared.clips["style"]))
        learnt.append((best, base, tensors, parts))
    best, base, tensors, parts = min(learnt, key=lambda one: one[0].compared.rank())
    if len(learnt) > 1:
        say(f"The style walks best on the model {base or 'published'}.")
    if str(base) == "recorded":
        say("This model, and a style added to it, is under CC BY-NC 4.0: not for commercial use.")
    if best.compared.verdict == "failed" and not anyway:
        raise ValueError(f"{name!r} does not walk as the clip does, so {out} was not written "
                         "(--anyway writes it); use more or longer clips")
    record = {"style": name, "clips": [file.name for file in files], "method": best.made.method,
              "mirror": best.mirror, "base": str(base or "published"), "steps": steps,
              "seed": seed, "verdict": best.compared.verdict}
    new = {"bank": list(best.bank.names), "added": [*parts["added"], record]}
    model_files.write(out, tensors | best.bank.tensors, parts | new)
    _print_near(best.bank, name)
    say(f"wrote {out}; next: python -m toolkit rollout --model {quote(str(out))} --style "
        f"{quote(name)} --out walk.html")


@app.command("list")
def list_(model: TrainedRun = None, parameters: Published = None) -> None:
    """List the styles of a model, each with its nearest ones."""
    bank = published.either(model, parameters).bank
    for name in bank:
        _print_near(bank, name)


def fitted(clip: Clip, network: Predictor, bank: StyleBank) -> Clip:
    """The clip on the model's skeleton."""
    skeleton = network.layout.skeleton
    if not skeleton.ends:
        clip = clip.without_ends()
    if (clip.skeleton.names, clip.skeleton.parents) == (skeleton.names, skeleton.parents):
        return clip
    retargeting = registry.find("toolkit.motion.retargeting")
    # a walk of the model, because the zero rotations of some skeletons are no standing figure
    walk = runtime.rollout(network, runtime.straight(1.0, AXES), bank.vectors.mean(0))
    made = retargeting.retarget(clip, walk)
    say(f"{clip.name}: retargeted; {retargeting.report(clip, made)}")
    return made


def _print_near(bank: StyleBank, name: str) -> None:
    near = ", ".join(f"{other} ({apart:.1f})" for other, apart in bank.nearest(name, 3))
    say(f"{name:<20} near it: {near}")


def _bases(model: Path | None, folder: Path | None) -> list[str | Path | None]:
    """Models to which a style is added: names or files, None for the published one."""
    if model is not None or folder is not None:
        return [model]
    return [*included(), *([None] if published.available() else [])]


def _read(base: str | Path | None,
          folder: Path | None) -> tuple[dict, dict, Predictor, StyleBank]:
    """Tensors and description of a model's file or the published one, the model, its bank."""
    if base is None or folder is not None:
        run = published.either(base, folder or published.DATASET)
        return *run.parts(), *run
    path = model_file(base)
    tensors, parts = model_files.read(path, "model")
    model = Predictor.from_parts(path, tensors, parts)
    return tensors, parts, model, StyleBank.from_parts(path, tensors, parts)
