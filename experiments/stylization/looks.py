"""Pictures, films and numbers of a restyled clip: what changes, as one sees it. ``experiments stylization strip``."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from PIL import Image

from experiments.seven_models.models import machine
from experiments.tables import Result
from toolkit import datasets, view
from toolkit.evaluation import metrics
from toolkit.motion import Clip, contacts, root_frames
from toolkit.stylization.data import prepare
from toolkit.stylization.medley import medley
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.restyling import stylize

NOISES = (1, 2, 3)
SCALE, COLOURS = 0.6, 96  # of the picture of all strips
LONG = 1000  # least frames of the clip of several actions
COLUMNS: dict[str, list] = {
    "clip": ["clip"], "stoop": ["stoop, °", 0], "hands": ["range of the hands, cm", 0, 100],
    "speed": ["speed of the hands, m/s", 2], "lift": ["lift of the toes, cm", 0, 100],
    "steps": ["landings per second", 1], "upright": ["upright"],
}


def restyled(model: Stylizer, source: Clip, references: Mapping[str, Sequence[Clip]],
             seeds: Sequence[int] = NOISES) -> dict[str, Clip]:
    """A clip and its restyled versions by label: for each domain with some noises and with its references."""
    rows = {f"{source.style} {source.gait}: source": source}
    for domain, clips in references.items():
        rows |= {f"{domain}, noise {seed}": stylize(model, source, domain, seed) for seed in seeds}
        rows |= {f"{domain}, reference {clip.gait}": stylize(model, source, domain, reference=clip) for clip in clips}
    return rows


def measured(clip: Clip) -> dict[str, float | str]:
    """Posture, hands, steps of a clip, `COLUMNS` without the label.

    ``stoop``: mean angle of the line from the hips to the chest to the vertical, degrees; ``hands``: diagonal of the box in
    the root frame in which a hand moves, metres; ``speed`` of the hands there; ``lift``: greatest height of a toe above its
    least, metres. Hands and toes are means over the two sides.
    """
    clip = prepare(clip)
    local = root_frames(clip).to_local(clip.global_positions)
    hands, toes = ([clip.skeleton.role(f"{side}_{part}") for side in contacts.FEET] for part in ("hand", "toe"))
    trunk = local[:, clip.skeleton.trunk[0]] - local[:, clip.skeleton.role("hips")]
    reach, height = local[:, hands], clip.global_positions[:, toes, 1]
    return {"stoop": float(torch.atan2(trunk[:, [0, 2]].norm(dim=-1), trunk[:, 1]).rad2deg().mean()),
            "hands": float((reach.amax(0) - reach.amin(0)).norm(dim=-1).mean()),
            "speed": float(reach.diff(dim=0).norm(dim=-1).mean() * clip.fps),
            "lift": float((height.amax(0) - height.amin(0)).mean()),
            "steps": metrics.step_rate(contacts.detect(clip), clip.fps), "upright": "yes" if metrics.upright(clip) else "no"}


def beside(pictures: Sequence[Path], out: Path) -> None:
    """Write pictures side by side, of one height, smaller and with few colours."""
    images = [Image.open(path).convert("RGB") for path in pictures]
    height = round(SCALE * min(image.height for image in images))
    images = [image.resize((image.width * height // image.height, height), Image.Resampling.LANCZOS) for image in images]
    whole = Image.new("RGB", (sum(image.width for image in images), height))
    for k, image in enumerate(images):
        whole.paste(image, (sum(before.width for before in images[:k]), 0))
    whole.quantize(COLOURS).save(out, optimize=True)


def strip(
    model: Annotated[Path, typer.Option(help="File of train-stylizer.")],
    domains: Annotated[str, typer.Option(help="Comma-separated target styles.")],
    source: Annotated[str, typer.Option(help="Style of the sources.")],
    contents: Annotated[str, typer.Option(help="Comma-separated contents of the sources.")],
    out: Annotated[Path, typer.Option(help="Folder for the pictures and films.")],
    references: Annotated[str | None, typer.Option(help="Contents of the references; default: the contents.")] = None,
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}.")] = "bandai",
    root: Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")] = None,
    seconds: Annotated[float, typer.Option(min=0.1, help="Seconds to show.")] = 3.0,
    film: Annotated[bool, typer.Option(help="Write films, too.")] = True,
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """Draw a source and, for each style, its results with three noises and with references (Figures 1 and 8).

    Writes a picture and a film of each content, and ``strips.png``, all pictures side by side.

    The first clip of each style and content is taken. The table also has the actor's own clip of the style and a clip of at
    least 1,000 frames, in which the contents and references follow each other.
    """
    names, shown = domains.split(","), contents.split(",")
    asked = (references or contents).split(",")
    needed = list(dict.fromkeys((*shown, *asked)))
    clips = {(clip.style, clip.gait): clip for clip in reversed(datasets.load(data, root, [source, *names], needed))}
    network, lines = Stylizer.load(model), []
    out.mkdir(parents=True, exist_ok=True)
    for content in shown:
        rows = restyled(network, clips[source, content], {name: [clips[name, other] for other in asked] for name in names})
        stop = min(seconds, *(clip.seconds for clip in rows.values()))
        view.strip(list(rows.values()), out / f"{content}.png", labels=list(rows), frames=6, stop=stop, width=9,
                   dpi=110)
        if film:
            short = [clip.cut(0, round(stop * clip.fps)) for clip in rows.values()]
            view.animate(short, out / f"{content}.webp", labels=list(rows), columns=1 + len(rows) // 2, fps=8, height=150)
        rows |= {f"{name} {content}: the actor's own": clips[name, content] for name in names}
        lines += [{"clip": label, **measured(clip)} for label, clip in rows.items()]
    beside([out / f"{content}.png" for content in shown], out / "strips.png")
    several = [clips[source, content] for content in needed]
    long = medley(several * -(-2 * LONG // sum(map(len, several)))).cut(0, LONG)
    lines.append({"clip": f"{source}, {len(long):,} frames: source", **measured(long)})
    lines += [{"clip": f"{name}, {len(long):,} frames, noise 1", **measured(stylize(network, long, name, 1))}
              for name in names]
    result = Result("stylisation-strips", f"One clip of each action of {source} in other styles by one trained model",
                    "python -m experiments stylization strip --model FILE --domains … --source … --contents … --out FOLDER "
                    "--store", COLUMNS, lines, {"frames": len(long), **machine("cpu")})
    print(result.markdown() + (f"wrote {result.save()}\n" if store else "") + f"wrote {out}")
