"""Make the moving pictures at the head of notebooks 06 to 12 again.

``python docs/course/pictures.py`` takes two minutes.
"""

import io
from pathlib import Path

import torch
from course import losses_page, plane
from course.looping import loop
from PIL import Image

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.stylization.losses import LOSSES

OUT = Path(__file__).parent
SHOW = {"fps": 15.0, "height": 150}


def new_style() -> None:
    """A clip of a new style, the learnt style, and the best known one."""
    arms = procedural.Arm(out=20, forward=45, elbow=95, swing=4, elbow_swing=4)
    legs = procedural.Leg(lift=0.14, tiptoe=20)
    sneak = procedural.Style(height=0.82, lean=28, step=0.5, cadence=0.75, arms=arms, legs=legs)
    clip = procedural.generate(sneak, "FW", seconds=8.0).replace(style="Sneak")
    model, bank = tk.pretrained()
    bank = tk.styles.fine_tune(model, clip, "Sneak", bank, steps=200).bank
    walk = tk.runtime.straight(tk.metrics.speed(clip), 7.0)
    rows = [
        clip.cut(120),
        *(tk.runtime.rollout(model, walk, bank[name]).cut(180) for name in ("Sneak", "Drunk")),
    ]
    write("new_style", rows, ["the clip", "learnt", "best known"])


def feet() -> None:
    """A walk of the embedded network without and with the foot lock."""
    model, bank = tk.pretrained()
    states = list(tk.runtime.states(model, tk.runtime.straight(1.0, 6.0), bank["Neutral"]))
    contact = torch.stack([state.contacts[0] for state in states])[120:]
    walks = [tk.runtime.record(model, states, feet=locked).cut(120) for locked in (False, True)]
    a, b = loop(walks[1])
    tk.view.animate(
        [clip.cut(a, b) for clip in walks],
        OUT / "feet.webp",
        labels=["as predicted", "with foot lock"],
        contacts=[contact[a:b]] * 2,
        view=90.0,
        **SHOW,
    )


def shot() -> None:
    """The shot of notebook 10 without its first half second, from the front of its path."""
    made = tk.shots.Shot(
        [(0, 0), (1.0, 2.5, 3.0), (-0.6, 4.5), (0, 6, 10.0)],
        [(0, "Neutral"), (3, "Neutral"), (6, "Zombie")],
        holds=[{"seconds": 1.0, "distance": 4.0}],
    )
    clip = made.render(*tk.pretrained()).cut(30)
    tk.view.animate(
        clip,
        OUT / "shot.webp",
        labels=["Neutral until 3 s, Zombie from 6 s on"],
        view=35.0,
        fps=10.0,
        height=150,
    )


def five_losses() -> None:
    """The toy of the five losses while it learns."""
    sets = [LOSSES, *(tuple(name for name in LOSSES if name != off) for off in ("cyc", "ds"))]
    toy, frames = plane.Toy(sets, seed=0), []
    for _ in range(24):
        figure = losses_page.losses_figure(toy, ["all five losses", "without cyc", "without ds"])
        frames.append(Image.open(io.BytesIO(figure._repr_png_())).convert("RGB"))
        toy.train(34)
    frames[0].save(
        OUT / "five_losses.webp",
        save_all=True,
        append_images=frames[1:] + frames[-1:] * 6,
        duration=150,
        loop=0,
    )


def write(name: str, clips: list[tk.Clip], labels: list[str]) -> None:
    """One loop of each clip, side by side."""
    tk.view.animate(
        [clip.cut(*loop(clip)) for clip in clips],
        OUT / f"{name}.webp",
        labels=labels,
        **SHOW,
    )


if __name__ == "__main__":
    torch.set_num_threads(1)
    for picture in (new_style, feet, shot, five_losses):
        picture()
