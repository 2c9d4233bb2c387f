"""Make the pictures of these pages again, in three minutes on one core.

``python docs/pictures.py [--published FOLDER --real FOLDER --run FILE --stylizers FOLDER]``.
Without the folder of the published parameters (Mason et al. 2022), the pictures in ``side_by_side``
and those of the other options stay as they are.
"""

import io
import sys
from contextlib import closing
from itertools import islice
from pathlib import Path
from typing import Annotated

import numpy as np
import screens
import torch
import typer
from PIL import Image
from tqdm import tqdm

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.view.render.bodies import Body, Camera, Lines, Pose, axes
from toolkit.view.render.mannequin import PALETTE, rgb
from toolkit.view.render.stage import open_stage

sys.path += [str(Path(__file__).parents[1] / folder) for folder in (".", "notebooks")]
from course.looping import loop

from experiments import crowds
from experiments.stylization import comparison, rotation, sets
from toolkit.motion.clearance import arms_out
from toolkit.stylization import data
from toolkit.stylization.restyling import lock_feet
from toolkit.stylization.training import Config

OUT = Path(__file__).parent
GAITS = ("FW", "BW", "SW", "FR", "BR", "SR")
# Styles in the table of moving pictures, and their camera angles in degrees.
SHOWN = {
    "Zombie": 60,
    "Old": 75,
    "Aeroplane": 30,
    "Crouch": 65,
    "HopLeft": 60,
    "HighKnees": 65,
    "MarchKick": 70,
    "DragRightLeg": 40,
    "Penguin": 15,
    "ArmsAboveHead": 40,
    "BentForward": 75,
    "Tiptoe": 70,
}
# Styles that are shown beside the published network, and their names in 100STYLE.
BESIDE = {
    "Zombie": "Zombie",
    "Old": "Old",
    "Aeroplane": "Aeroplane",
    "Crouch": "Crouched",
    "HighKnees": "HighKnees",
    "Strut": "Strutting",
}
PUBLISHED = typer.Option(help="Folder of the published parameters.")
REAL = typer.Option(help="Folder of 100STYLE, for the picture of feet.")
RUN = typer.Option(help="LPN-FiLM of a hundred styles, for the strips.")
STYLIZERS = typer.Option(help="Folder of `stylization-rotation`, for its picture.")
BLENDED = ("Neutral", "Zombie", "Aeroplane", "Strut")  # the styles of the picture in the README


def straight(style: str, seconds: float = 8.0) -> tk.Clip:
    """A procedural walk straight ahead at the style's usual speed."""
    ahead = torch.arange(round(seconds * 60)) / 60 * procedural.STYLES[style].speed
    return procedural.generate(style, path=torch.stack((0 * ahead, ahead, 0 * ahead), 1))


def rollout(model, bank, style: str, speed: float, seconds: float = 10.0) -> tk.Clip:
    """A walk of a model straight ahead, without its first two seconds."""
    commands = tk.runtime.straight(speed, seconds)
    return tk.runtime.rollout(model, commands, style=bank[style]).cut(120)


def looped(clip: tk.Clip) -> tk.Clip:
    """About two strides that repeat without a jump."""
    return clip.cut(*loop(clip))


def blended(model, bank, seconds: float = 2.0) -> tk.Clip:
    """A walk through `BLENDED` and back.

    Each style lasts for half of ``seconds`` and then blends into the next one.
    """
    frames = round(seconds * tk.runtime.FPS)
    vectors = torch.stack([bank[style] for style in (*BLENDED, BLENDED[0])])

    def style(frame: int) -> torch.Tensor:
        leg, share = divmod(max(0, frame - 120) / frames, 1.0)
        share = min(1.0, max(0.0, 2.0 * share - 1.0))
        return torch.lerp(vectors[int(leg)], vectors[min(int(leg) + 1, len(BLENDED))], share)

    commands = tk.runtime.straight(1.0, 2.0 + len(BLENDED) * seconds)
    return tk.runtime.rollout(model, commands, style=style).cut(120)


def feet(run, real: tk.Clip, seconds: float = 4.0) -> None:
    """Write a picture of the right toe's height and speed over time.

    It shows a real walk and a walk of a model at the same speed.
    """
    from matplotlib.figure import Figure

    figure = Figure((10, 4.2), layout="constrained")
    high, fast = figure.subplots(2, 1, sharex=True)
    walk = rollout(*run, "Neutral", tk.metrics.speed(real), seconds + 4.0)
    for clip, label, colour in (
        (real, "real take, Neutral FW", "0.45"),
        (walk, "published network", "C1"),
    ):
        shown = clip.cut(120, 120 + round(seconds * clip.fps))
        toe = shown.global_positions[:, clip.skeleton.role("right_toe")]
        time = torch.arange(len(toe)) / clip.fps
        speed = tk.contacts.velocities(toe, clip.fps)[:, [0, 2]].norm(dim=-1)
        height = toe[:, 1] - tk.contacts.standing_height(clip).mean()
        high.plot(time, 100 * height, colour, label=label)
        fast.plot(time, speed, colour)
    high.set_ylabel("height of the toe, cm")
    fast.set(ylabel="its speed, m/s", xlabel="seconds")
    figure.legend(ncols=2, loc="outside upper center")
    figure.savefig(OUT / "feet.png", dpi=110)


def few_colours(path: Path) -> None:
    """Store a picture with 128 colours, so that its file is small."""
    Image.open(path).convert("RGB").quantize(128).save(path, optimize=True)


def hundred(authors, run) -> None:
    """Write walks of the published network and of one trained on its walks, in four styles."""
    rows = {f"{style}, {name}": rollout(*walker, style, authors.bank.speed(style), 9.0)
            for style in ("Zombie", "Aeroplane", "March", "Swimming")
            for name, walker in (("published", authors), ("trained here", run))}
    tk.view.strip(
        [clip.cut(240, 330) for clip in rows.values()],
        OUT / "hundred_strips.png",
        labels=list(rows),
        width=9,
        dpi=100,
    )
    few_colours(OUT / "hundred_strips.png")


def restyle(seconds: float = 4.0) -> None:
    """Write a film of a plain walk that the stylizer in the package restyles.

    There are two styles, and two noises for each of them.
    """
    stylizer, walk = tk.stylization.pretrained(), straight("Neutral", seconds)
    shown = {"plain walk": walk} | {
        f"{style}, noise {seed}": tk.stylization.stylize(stylizer, walk, style, seed)
        for style in ("Zombie", "Old")
        for seed in (1, 2)
    }
    start, end = loop(walk)
    tk.view.animate(
        [clip.cut(start, end) for clip in shown.values()],
        OUT / "restyle.webp",
        labels=list(shown),
        fps=15.0,
        height=170,
        view=75,
        progress=True,
    )


def recorded(seconds: float = 5.0) -> None:
    """Write a film of five styles of the model of recorded people, each at its usual speed."""
    model, bank = tk.pretrained("recorded")
    names = "normal", "feminine", "exhausted", "proud", "old"
    walks = [rollout(model, bank, name, bank.speed(name), seconds) for name in names]
    tk.view.animate(walks, OUT / "recorded.webp", labels=names, fps=10.0, height=160, view=60,
                    progress=True)


def stylised(runs: Path) -> None:
    """Write strips of an active bow, wave, run and walk as tired, by three ways and their blend.

    ``runs`` is the folder ``--out`` of ``experiments stylization-rotation``.
    """
    group, (old, new) = rotation.GROUPS[0], ("active", "tired")
    train = sets.few_takes(sets.dissimilar(), group, sets.CONTENTS).train
    ours, plain = (comparison.trained(method, train, Config.quick(seed=0, iterations=2000),
                                      runs / f"1-{comparison.slug(method)}-0")[0]
                   for method in ("ours", "1-D convolutions"))
    takes = {old: {}, new: {}}
    for clip in tk.datasets.load("bandai", dataset=1, styles=[*takes]):
        takes[clip.style][clip.gait] = clip
    pictures = []
    for gait in ("bow", "bye", "run", "walk"):
        clip, stylize = takes[old][gait], tk.stylization.stylize
        source = data.prepare(clip, ours.skeleton)
        x, velocity = data.describe(source)
        moved = data.to_clip(ours.shift(x[None], old, new)[0], velocity, source)
        rows = {f"{old} {gait}: source": clip,
                "shift and scale": arms_out(lock_feet(moved, source)),
                f"ours, {new}": stylize(ours, clip, new),
                f"blend, {new}": stylize(ours, clip, new, blend=old),
                "1-D convolutions": stylize(plain, clip, new),
                f"a real {new} {gait}": takes[new][gait]}
        for name, row in rows.items():
            print(name, len(tk.evaluation.defects(row)), "defects")
        file = io.BytesIO()
        first = [row.cut(0, min(len(row), round(5 * row.fps))) for row in rows.values()]
        tk.view.strip(first, labels=list(rows), frames=6, width=5, dpi=100).savefig(file)
        pictures.append(Image.open(file).convert("RGB"))
    width = max(picture.width for picture in pictures)
    heights = [max(picture.height for picture in pictures[k : k + 2]) for k in (0, 2)]
    whole = Image.new("RGB", (2 * width, sum(heights)), pictures[0].getpixel((0, 0)))
    for k, picture in enumerate(pictures):
        whole.paste(picture, (k % 2 * width, k // 2 * heights[0]))
    whole.quantize(64).save(OUT / "stylisation.png", optimize=True)


class Tinted(Body):
    """A mannequin with a colour of its own."""

    def __init__(self, clip: tk.Clip, number: int):
        super().__init__(clip)
        self.tint = rgb(PALETTE[number % len(PALETTE)])

    def colors(self, frame: int) -> np.ndarray:
        """Colours [V, 3] of the vertices."""
        return 0.45 * super().colors(frame) + 0.55 * self.tint


def crowd(model, bank) -> None:
    """Write the animation of two streams that cross, three seconds of it."""
    fast = tk.runtime.compile(model)
    scene = crowds.streams(100, 0, 1.0).spaced(fast, bank, bodies=0.1)
    states = list(islice(scene.states(fast, bank), 600))[420:]
    bodies = [Tinted(tk.runtime.record(fast, states, character=i), i) for i in range(100)]
    frames = np.arange(0, 180, 60 // 8)
    # a camera that sees every body in every frame
    azimuth, tilt = np.radians((-30.0, 32.0))
    bounds = [body.seen(frames, np.zeros((len(frames), 3)), azimuth, tilt) for body in bodies]
    low, high = np.min([b[0] for b in bounds], 0), np.max([b[1] for b in bounds], 0)
    right, up, back = axes(azimuth, tilt)
    floor = (low[0] + high[0]) / 2 * right + (low[1] + high[1]) / 2 * up
    camera = Camera(floor - back * floor[1] / back[1], azimuth, tilt, high[1] - low[1] + 0.6)
    size = 400, round(400 * camera.height / (high[0] - low[0] + 0.6))
    light = np.array([-0.35, 1.0, 0.25]) @ axes(azimuth, 0.0)
    lines = Lines(reach=float(np.ptp([low, high], axis=0).max()))
    with closing(open_stage(bodies, size, light, lines)) as stage:
        pictures = [
            Image.fromarray(stage.draw([Pose(body, frame) for body in bodies], camera))
            for frame in tqdm(frames, desc="crowd")
        ]
    pictures[0].save(
        OUT / "crowd.webp", save_all=True, append_images=pictures[1:], duration=125, loop=0,
        quality=60
    )


def main(
    published: Annotated[Path | None, PUBLISHED] = None,
    real: Annotated[Path | None, REAL] = None,
    run: Annotated[Path | None, RUN] = None,
    stylizers: Annotated[Path | None, STYLIZERS] = None,
) -> None:
    """Make every picture in this folder again."""
    torch.set_num_threads(1)
    for folder in ("styles", "side_by_side"):
        (OUT / folder).mkdir(exist_ok=True)
    walks = {style: straight(style) for style in procedural.STYLES}
    tk.view.strip(
        list(map(looped, walks.values())),
        OUT / "contact_sheet.png",
        labels=list(walks),
        width=12,
        dpi=66,
    )
    few_colours(OUT / "contact_sheet.png")
    gaits = [looped(procedural.generate("Neutral", gait)) for gait in GAITS]
    tk.view.animate(
        gaits,
        OUT / "gaits.gif",
        labels=GAITS,
        fps=14.0,
        height=100,
        progress=True,
    )
    for style, view in tqdm(SHOWN.items(), desc="styles"):
        tk.view.animate(
            looped(walks[style]),
            OUT / "styles" / f"{style}.gif",
            labels=[""],
            view=view,
            height=140,
        )

    restyle()
    recorded()
    if stylizers is not None:
        stylised(stylizers)
    embedded = tk.pretrained()
    tk.view.animate(
        blended(*embedded),
        OUT / "blend.webp",
        labels=[", ".join(BLENDED)],
        fps=12.0,
        height=240,
        view=60,
        progress=True,
    )
    shown = [
        style
        for style in ("Neutral", "Zombie", "Strut", "Crouch", "Aeroplane")
        if style in embedded.bank
    ]
    crowd(*embedded)
    screens.controller(*embedded)
    screens.director(*embedded)
    rows = [rollout(*embedded, style, procedural.STYLES[style].speed) for style in shown]
    rows = [row.cut(0, 120) for row in rows]
    tk.view.strip(rows, OUT / "styles.png", labels=shown, width=9, dpi=120)
    few_colours(OUT / "styles.png")
    if published is None:
        return
    authors = tk.published.load(published)
    if real is not None:
        feet(authors, tk.datasets.load("100style", real, styles=["Neutral"], gaits=["FW"])[0])
    if run is not None:
        hundred(authors, tk.training.load(run))
    for style, name in tqdm(BESIDE.items(), desc="side by side"):
        speed = procedural.STYLES[style].speed
        clips = {
            "procedural data": walks[style],
            "embedded model": rollout(*embedded, style, speed),
            "Mason et al. 2022": rollout(*authors, name, speed),
        }
        tk.view.animate(
            [looped(clip) for clip in clips.values()],
            OUT / "side_by_side" / f"{style}.gif",
            labels=list(clips),
            height=120,
        )


if __name__ == "__main__":
    typer.run(main)
