"""Make the moving pictures at the head of notebooks 06 to 12 again: ``python docs/course/pictures.py``, two minutes."""

from pathlib import Path

import torch

import toolkit as tk
from toolkit.datasets import procedural

OUT = Path(__file__).parent
SHOW = {"fps": 15.0, "height": 150}


def new_style() -> None:
    """A clip of a new style, the learnt style, and the best known one."""
    arms = procedural.Arm(out=20, forward=45, elbow=95, swing=4, elbow_swing=4)
    sneak = procedural.Style(height=0.82, lean=28, step=0.5, cadence=0.75, arms=arms, legs=procedural.Leg(lift=0.14, tiptoe=20))
    clip = procedural.generate(sneak, "FW", seconds=8.0).replace(style="Sneak")
    model, bank = tk.pretrained()
    bank = tk.styles.fine_tune(model, clip, "Sneak", bank, steps=200).bank
    walk = tk.runtime.straight(tk.metrics.speed(clip), 7.0)
    rows = [clip.cut(120), *(tk.runtime.rollout(model, walk, bank[name]).cut(180) for name in ("Sneak", "Drunk"))]
    write("new_style", rows, ["the clip", "learnt", "best known"])


def write(name: str, clips: list[tk.Clip], labels: list[str]) -> None:
    """One loop of each clip, side by side."""
    tk.view.animate([clip.cut(*tk.view.loop(clip)) for clip in clips], OUT / f"{name}.webp", labels=labels, **SHOW)


if __name__ == "__main__":
    torch.set_num_threads(1)
    for picture in (new_style,):
        picture()
