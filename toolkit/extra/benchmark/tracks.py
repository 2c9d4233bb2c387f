"""The plan of the benchmark, as data, and a model's walks after it."""

import hashlib
import json
import math
from importlib import resources
from typing import Any

import torch

from toolkit import runtime
from toolkit.motion import Clip
from toolkit.motion.trajectory import FPS
from toolkit.networks.bank import StyleBank

_TEXT = (resources.files(__package__) / "stylewalk.json").read_bytes()
#: Version, styles, seeds and tracks. A track is a list of parts: ``seconds``; ``speed`` as a share
#: of the style's own; ``turn``, degrees a second, or at once where a part has no seconds.
PLAN: dict[str, Any] = json.loads(_TEXT)
HASH = hashlib.sha256(_TEXT).hexdigest()
VARIED = 0.1  # largest change of the speed by a seed


def commands(track: str, pace: float, seed: int = 0) -> list[runtime.Command]:
    """One command a frame of a track, for a style that walks at ``pace`` m/s, after a warm-up.

    The seed varies the speed by up to 10 %, and turns to the other side where it is odd.
    """
    draw = torch.Generator().manual_seed(seed)
    pace *= 1 + VARIED * (2 * float(torch.rand((), generator=draw)) - 1)
    side = -1 if seed % 2 else 1
    first = {"seconds": PLAN["warm_up"], "speed": 1.0, "turn": 0.0}
    made, angle = [], 0.0
    for part in (first, *PLAN["tracks"][track]):
        frames = round(part["seconds"] * FPS)
        turn = side * math.radians(part["turn"])
        if not frames:
            angle += turn
        for _ in range(frames):
            angle += turn / FPS
            way = math.sin(angle), math.cos(angle)
            speed = pace * part["speed"]
            made.append(runtime.Command((speed * way[0], speed * way[1]), way))
    return made


def walk(model: Any, bank: StyleBank, progress: bool = False) -> dict[str, Clip]:
    """A model's walks: a clip for each track, style and seed, named ``track_style_seed``.

    Styles that the bank does not have are left out; ``Neutral`` counts as ``normal``. ValueError if
    it has none.
    """
    names = {style: style for style in PLAN["styles"] if style in bank.names}
    if "Neutral" in bank.names:
        names.setdefault("normal", "Neutral")
    if not names:
        raise ValueError(f"the bank has none of the styles {', '.join(PLAN['styles'])}")
    clips, skipped = {}, round(PLAN["warm_up"] * FPS)
    people = [(style, own, seed) for style, own in names.items() for seed in PLAN["seeds"]]
    vectors = torch.stack([bank[own] for _, own, _ in people])
    for track in PLAN["tracks"]:
        orders = [commands(track, bank.speed(own), seed) for _, own, seed in people]
        together = [runtime.Command(*(torch.tensor([getattr(order, part) for order in frame])
                                      for part in ("velocity", "facing")))
                    for frame in zip(*orders, strict=True)]
        walked = list(runtime.states(model, together, vectors, life=model.life, progress=progress))
        for number, (style, _, seed) in enumerate(people):
            clip = runtime.record(model, walked[skipped:], character=number)
            name = f"{track}_{style}_{seed}"
            clips[name] = clip.replace(style=style, gait=track, name=name)
    return clips
