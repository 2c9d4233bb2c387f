"""Exercises of the notebook on features."""

import torch

from toolkit import features
from toolkit.course.checks import Exercise, same_as
from toolkit.datasets import procedural


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
    return [(*torch.randn(2, 2, generator=make), float(torch.randn((), generator=make))) for _ in range(4)]


def _poses() -> list[tuple]:
    clip = procedural.generate("LimpLeft", seconds=4.0)
    layout = features.Layout(clip.skeleton)
    joints = features.split_joints(features.frames(clip).inputs[:, layout.inputs["joints"]])["position"]
    pairs = [layout.names.index(n.replace("Left", "?").replace("Right", "Left").replace("?", "Right")) for n in layout.names]
    return [(joints, pairs), (joints[:3], pairs)]


EXERCISES = {
    "01.1": Exercise(
        same_as(_to_root, _points, {"the point must be taken relative to the root first.": _turned_only,
                                    "the frame is turned the other way: at π/2 its forward axis is (1, 0).": _other_way}),
        "take the difference from the root, then its dot product with the frame's left axis and with its forward axis."),
    "01.2": Exercise(
        same_as(lambda joints: torch.tensor([48 + 12 * joints, 42 + 12 * joints]), lambda: [(25,), (17,), (31,)],
                {"z holds only the future half of the window.":
                 lambda joints: torch.tensor([48 + 12 * joints, 66 + 12 * joints]),
                 "z also holds the updates of the phases, not only the phases.":
                 lambda joints: torch.tensor([48 + 12 * joints, 34 + 12 * joints]),
                 "z also holds two foot contacts.": lambda joints: torch.tensor([48 + 12 * joints, 40 + 12 * joints])}),
        "each joint has 12 numbers, and each sample of the window has 4."),
    "01.3": Exercise(
        same_as(lambda positions, pairs: positions[:, pairs] * torch.tensor([-1.0, 1.0, 1.0]), _poses,
                {"the joints are exchanged, but the coordinate to the left has its old sign.":
                 lambda positions, pairs: positions[:, pairs],
                 "the sign is right, but left and right joints are not exchanged.":
                 lambda positions, pairs: positions * torch.tensor([-1.0, 1.0, 1.0]),
                 "you have negated the wrong coordinate.":
                 lambda positions, pairs: positions[:, pairs] * torch.tensor([1.0, 1.0, -1.0])}),
        "index the joints with pairs, and multiply by (-1, 1, 1)."),
}
