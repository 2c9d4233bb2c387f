"""Exercises of the notebooks on the first walk and of features."""

import torch
from course.checks import Exercise, equals, same_as

from toolkit import features
from toolkit.datasets import procedural


def _clips() -> list[tuple]:
    walk = procedural.generate("HighKnees", seconds=2.0)
    return [(walk, "left_toe"), (walk, "right_hand"), (walk.moved(shift=(0.0, 0.3, 0.0)), "hips")]


def _to_root(point, root, angle):
    angle = torch.as_tensor(angle)
    ahead, left = torch.stack((angle.sin(), angle.cos())), torch.stack((angle.cos(), -angle.sin()))
    return torch.stack(((point - root) @ left, (point - root) @ ahead))


def _turned_only(point, root, angle):
    return _to_root(point, torch.zeros(2), angle)


def _other_way(point, root, angle):
    return _to_root(point, root, -angle)


def _points() -> list[tuple]:
    make = torch.Generator().manual_seed(1)
    return [
        (*torch.randn(2, 2, generator=make), float(torch.randn((), generator=make)))
        for _ in range(4)
    ]


def _poses() -> list[tuple]:
    clip = procedural.generate("LimpLeft", seconds=4.0)
    layout = features.Layout(clip.skeleton)
    joints = features.split_joints(features.frames(clip).inputs[:, layout.inputs["joints"]])[
        "position"
    ]
    pairs = [
        layout.names.index(n.replace("Left", "?").replace("Right", "Left").replace("?", "Right"))
        for n in layout.names
    ]
    return [(joints, pairs), (joints[:3], pairs)]


EXERCISES = {
    "00.1": Exercise(
        equals(
            {"Old": 0.25, "Zombie": 0.75},
            {
                "these are the weights of the other walk: a quarter should be Old.": {
                    "Old": 0.75, "Zombie": 0.25
                },
                "the weights should be shares of one, not percent.": {"Old": 25, "Zombie": 75},
            },
        ),
        "the names are the keys, and the weights are shares of one.",
    ),
    "00.2": Exercise(
        same_as(
            lambda speed, fps: speed / fps,
            lambda: [(1.2, 60), (3.0, 30), (0.0, 120)],
            {
                "this is the number of frames per metre.": lambda speed, fps: (
                    fps / max(speed, 1e-9)
                ),
                "this is far too long: in one second the character moves `speed` "
                "metres.": lambda speed, fps: (
                    speed * fps
                ),
            },
        ),
        "in one second there are fps frames, and the character moves speed metres.",
    ),
    "00.3": Exercise(
        same_as(
            lambda clip, joint: clip.global_positions[:, clip.skeleton.index(joint), 1].max(),
            _clips,
            {
                "this is the mean height, not the highest point.": lambda clip, joint: (
                    clip.global_positions[:, clip.skeleton.index(joint), 1].mean()
                ),
                "this is not the height: it is number 1 of the three coordinates, and no "
                "other.": lambda clip, joint: (
                    clip.global_positions[:, clip.skeleton.index(joint)].max()
                ),
            },
        ),
        "take all frames, one joint and coordinate 1, then the maximum.",
    ),
    "01.1": Exercise(
        same_as(
            _to_root,
            _points,
            {
                "the point must be taken relative to the root first.": _turned_only,
                "the frame is turned the other way: at π/2 its forward axis is (1, 0).": _other_way
            },
        ),
        "take the difference from the root, then its dot product with the frame's left axis and "
        "with its forward axis.",
    ),
    "01.2": Exercise(
        same_as(
            lambda joints: torch.tensor([48 + 12 * joints, 42 + 12 * joints]),
            lambda: [(25,), (17,), (31,)],
            {
                "z holds only the future half of the window.": lambda joints: (
                    torch.tensor([48, 66]) + 12 * joints
                ),
                "z also holds phases, their updates and contacts.": lambda joints: (
                    torch.tensor([48, 24]) + 12 * joints
                ),
                "z also holds the updates of the phases.": lambda joints: (
                    torch.tensor([48, 34]) + 12 * joints
                ),
                "z also holds two foot contacts.": lambda joints: (
                    torch.tensor([48, 40]) + 12 * joints
                ),
            },
        ),
        "each joint has 12 numbers, and each sample of the window has 4.",
    ),
    "01.3": Exercise(
        same_as(
            lambda positions, pairs: positions[:, pairs] * torch.tensor([-1.0, 1.0, 1.0]),
            _poses,
            {
                "the joints are exchanged, but the coordinate to the left has its old "
                "sign.": lambda positions, pairs: (
                    positions[:, pairs]
                ),
                "the sign is right, but left and right joints are not "
                "exchanged.": lambda positions, pairs: (
                    positions * torch.tensor([-1.0, 1.0, 1.0])
                ),
                "you have negated the wrong coordinate.": lambda positions, pairs: (
                    positions[:, pairs] * torch.tensor([1.0, 1.0, -1.0])
                ),
            },
        ),
        "index the joints with pairs, and multiply by (-1, 1, 1).",
    ),
}
