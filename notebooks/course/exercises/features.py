"""Exercises of the notebooks on the first walk and of features."""

from functools import cache

import torch
from course.checks import Exercise, same_as, shows

import toolkit as tk
from toolkit.datasets import procedural

FLIP = torch.diag(torch.tensor([-1.0, 1.0, 1.0]))


@cache
def _straight(aeroplane: float) -> tk.Clip:
    """A walk of three seconds at 1 m/s that is so much Aeroplane, else Neutral."""
    model, bank = tk.pretrained()
    style = (1 - aeroplane) * bank["Neutral"] + aeroplane * bank["Aeroplane"]
    commands = tk.runtime.straight(1.0, 3.0)
    return tk.runtime.rollout(tk.runtime.quick(model, len(commands)), commands, style=style)


def _apart(aeroplane: float) -> float:
    """Mean distance of the hands in such a walk, metres."""
    walk = _straight(aeroplane)
    left, right = (walk.skeleton.index(f"{side}_hand") for side in ("left", "right"))
    places = walk.global_positions[60:]
    return float((places[:, left] - places[:, right]).norm(dim=-1).mean())


def _ahead() -> float:
    """How far Neutral goes in such a walk, metres."""
    places = _straight(0.0).root_positions
    return float((places[-1] - places[0])[2])


def _half_way(weights: dict) -> bool:
    share = weights["Aeroplane"] / sum(weights.values())
    went = (_apart(round(float(share), 3)) - _apart(0.0)) / (_apart(1.0) - _apart(0.0))
    return abs(went - 0.5) < 0.03


def _axes(angle):
    """The left and the forward axis of a root frame."""
    angle = torch.as_tensor(angle)
    return torch.stack((angle.cos(), -angle.sin())), torch.stack((angle.sin(), angle.cos()))


def _from_root(own, root, angle):
    left, ahead = _axes(angle)
    return root + own[0] * left + own[1] * ahead


def _points() -> list[tuple]:
    draw = torch.Generator().manual_seed(1)
    return [
        (*torch.randn(2, 2, generator=draw), torch.randn((), generator=draw)) for _ in range(4)
    ]


def _shifted_only(clip: tk.Clip) -> torch.Tensor:
    """Positions relative to the root, not turned into its frame: the fault of exercise 01.2."""
    return clip.global_positions - tk.motion.root_frames(clip).positions[:, None]


@cache
def _walk() -> tk.Clip:
    return procedural.generate("LimpLeft", seconds=4.0)


def _in_the_world(clip: tk.Clip) -> torch.Tensor:
    return clip.global_positions


def _changes(places, turn, shift) -> torch.Tensor:
    """How far each joint moves in each frame, metres."""
    moved = _walk().moved(turn=float(turn), shift=tuple(shift))
    return (places(moved) - places(_walk())).norm(dim=-1)


def _turns() -> list[tuple]:
    clip = _walk()
    names = clip.skeleton.names
    swapped = [n.replace("Left", "?").replace("Right", "Left").replace("?", "Right") for n in names]
    pairs = [names.index(name) for name in swapped]
    matrices = tk.motion.rotations.to_matrix(clip.global_rotations)
    return [(matrices, pairs), (matrices[:3], pairs)]


EXERCISES = {
    "00.1": Exercise(
        shows(
            ("give a dictionary with weights of Old and of Zombie",
             lambda x: isinstance(x, dict) and set(x) == {"Old", "Zombie"}),
            ("the weights should sum to one", lambda x: abs(sum(x.values()) - 1) < 1e-3),
            ("this vector is not nearer to Zombie's", lambda x: abs(x["Zombie"]) > abs(x["Old"])),
            ("it is not three times as far",
             lambda x: abs(abs(x["Zombie"]) - 3 * abs(x["Old"])) < 0.01),
        ),
        "draw the line from Old to Zombie. Which weight has the blend half way, and at an end?",
        "it has gone three of four equal parts of the way from Old to Zombie.",
    ),
    "00.2": Exercise(
        shows(
            ("this is how far it goes", lambda x: abs(float(x) - _ahead()) > 0.02),
            ("this is not the difference", lambda x: abs(179 / 60 - float(x) - _ahead()) < 0.03),
        ),
        "where is the character in frame 0 and three seconds later, and which number is ahead?",
        "1 m/s × 179 / 60 s, less the difference of z between the frames 179 and 0.",
    ),
    "00.3": Exercise(
        shows(
            ("give a dictionary with weights of Neutral and of Aeroplane",
             lambda x: isinstance(x, dict) and set(x) == {"Neutral", "Aeroplane"}),
            ("the weights should sum to one", lambda x: abs(sum(x.values()) - 1) < 1e-3),
            ("the hands are not half way", _half_way),
        ),
        "section 2 measured equal weights. Were the hands too near or too far apart?",
        "compute the distance of section 2 for shares of 0.1, 0.2 … and take the nearest.",
    ),
    "01.1": Exercise(
        same_as(_from_root, _points, {
            "the place of the root is missing.":
                lambda own, root, angle: _from_root(own, 0 * root, angle),
            "the frame is turned the other way: at π/2 its forward axis is (1, 0).":
                lambda own, root, angle: _from_root(own, root, -angle),
            "this is the way into the root frame.": lambda own, root, angle: torch.stack(
                [(own - root) @ axis for axis in _axes(angle)]),
        }),
        "from the root, how far do you go along its left axis, and how far along its forward axis?",
        "root + own[0] · left + own[1] · forward.",
    ),
    "01.2": Exercise(
        shows(
            ("give a turn and a shift of three numbers", lambda turn, shift: len(shift) == 3),
            ("a joint moves by two metres or less",
             lambda turn, shift: float(_changes(_in_the_world, turn, shift).min()) > 2),
            ("this test finds the fault: the faulty numbers change by a centimetre or more",
             lambda turn, shift: float(_changes(_shifted_only, turn, shift).max()) < 0.01),
            parts=2,
        ),
        "which of the two does the faulty code take out: where a character is, or its direction?",
        "do not turn, and shift along the floor.",
    ),
    "01.3": Exercise(
        same_as(lambda turns, pairs: FLIP @ turns[:, pairs] @ FLIP, _turns, {
            "left and right joints are not exchanged.": lambda turns, pairs: FLIP @ turns @ FLIP,
            "with one factor the determinant is −1: this is no rotation.":
                lambda turns, pairs: FLIP @ turns[:, pairs],
            "the joints are exchanged, but not mirrored.": lambda turns, pairs: turns[:, pairs],
        }),
        "what must happen to a vector before the mirrored rotation turns it, and what after?",
        "flip @ turns[:, pairs] @ flip: mirror, turn, mirror back.",
    ),
}
