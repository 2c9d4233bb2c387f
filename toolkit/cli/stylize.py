"""The verb `stylize`: give a clip another style (Park et al. 2021)."""

from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit.cli import motion_files
from toolkit.cli.verbs import Roles, Seed, Unit, Up, say
from toolkit.evaluation import metrics
from toolkit.evaluation.findings import told
from toolkit.io import save as saving
from toolkit.motion import contacts
from toolkit.stylization.networks import Stylizer, pretrained
from toolkit.stylization.restyling import stylize


def stylize_clip(
    clip: Annotated[Path, Option(
        help="Motion file to restyle, on the skeleton of the training data.")],
    out: Annotated[Path, Option(
        help=f"File to write: {', '.join(saving.suffixes())} (pictures: beside the source).")],
    model: Annotated[Path | None, Option(
        help="File of train-stylizer; by default the embedded one.")] = None,
    domain: Annotated[str | None, Option(
        help="Target style; with --reference, the style of that clip.")] = None,
    seed: Seed = 0,
    reference: Annotated[Path | None, Option(
        help="Motion file whose style is used instead of noise.")] = None,
    blend: Annotated[str | None, Option(
        help="Style of the clip: makes a blend, half network, half shift and scale.")] = None,
    feet: Annotated[bool, Option(help="Remove foot skate, and turn arms out of the body.")] = True,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
) -> None:
    """Give a clip another style, from noise or a reference clip; print its foot skate.

    Another --seed gives another variant of the style.
    """
    saving.check(out, saving.suffixes(), clip, reference)
    stylizer = pretrained() if model is None else Stylizer.load(model)
    if domain is None:
        raise ValueError(f"say which style by --domain: {', '.join(stylizer.domains)}")
    source = motion_files.read(clip, unit, up, roles)
    other = None if reference is None else motion_files.read(reference, unit, up, roles)
    made = stylize(stylizer, source, domain, seed, reference=other, blend=blend, feet=feet)
    saving.save(made, out, title=domain, source=source, progress=True)
    standing = contacts.detect(source)
    before, after = (100 * metrics.feet(motion, standing)["skate"] for motion in (source, made))
    say(f"{len(made)} frames; feet that should stand slide by {after:.1f} cm/s, in the source "
        f"{before:.1f}; wrote {out}")
    say(told(made))
