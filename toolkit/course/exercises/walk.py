"""Exercises of the first walk."""

from toolkit.course.checks import Exercise, equals, same_as
from toolkit.datasets import procedural


def _clips() -> list[tuple]:
    walk = procedural.generate("HighKnees", seconds=2.0)
    return [(walk, "left_toe"), (walk, "right_hand"), (walk.moved(shift=(0.0, 0.3, 0.0)), "hips")]


EXERCISES = {
    "00.1": Exercise(
        equals({"Old": 0.25, "Zombie": 0.75},
               {"these are the weights of the other walk: a quarter should be Old.": {"Old": 0.75, "Zombie": 0.25},
                "the weights should be shares of one, not percent.": {"Old": 25, "Zombie": 75}}),
        "the names are the keys, and the weights are shares of one."),
    "00.2": Exercise(
        same_as(lambda speed, fps: speed / fps, lambda: [(1.2, 60), (3.0, 30), (0.0, 120)],
                {"this is the number of frames per metre.": lambda speed, fps: fps / max(speed, 1e-9),
                 "this is far too long: in one second the character moves `speed` metres.": lambda speed, fps: speed * fps}),
        "in one second there are fps frames, and the character moves speed metres."),
    "00.3": Exercise(
        same_as(lambda clip, joint: clip.global_positions[:, clip.skeleton.index(joint), 1].max(), _clips,
                {"this is the mean height, not the highest point.":
                 lambda clip, joint: clip.global_positions[:, clip.skeleton.index(joint), 1].mean(),
                 "this is the largest coordinate of any axis; the height is number 1.":
                 lambda clip, joint: clip.global_positions[:, clip.skeleton.index(joint)].max()}),
        "take all frames, one joint and coordinate 1, then the maximum."),
}
