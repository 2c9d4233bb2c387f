"""Exercises of the notebook on measuring style."""

import torch

from toolkit.course.checks import Exercise, same_as


def _leaks(first, second, gap) -> bool:
    early, late = sorted((first, second))
    return late[0] - early[1] < gap


EXERCISES = {
    "11.1": Exercise(
        same_as(lambda styles: max(styles.count(style) for style in styles) / len(styles),
                lambda: [(["Old", "Old", "Strut"],), (["Old", "Strut", "Zombie", "Strut", "Strut"],)],
                {"this is the chance of a random guess.": lambda styles: 1 / len(set(styles))}),
        "count each style, take the largest count, divide by the number of clips."),
    "11.2": Exercise(
        same_as(_leaks, lambda: [((0, 100), (150, 200), 50), ((150, 200), (0, 101), 50), ((0, 100), (50, 60), 10),
                                 ((500, 600), (0, 100), 240)],
                {"a gap of exactly `gap` frames is allowed.":
                 lambda first, second, gap: sorted((first, second))[1][0] - sorted((first, second))[0][1] <= gap,
                 "the blocks may come in any order.": lambda first, second, gap: second[0] - first[1] < gap}),
        "sort both blocks; compare the start of the second with the stop of the first."),
    "11.3": Exercise(
        same_as(lambda scores: torch.stack((scores.mean(), scores.std() / len(scores) ** 0.5)),
                lambda: [(torch.tensor([0.2, 0.4, 0.9]),), (torch.tensor([1.0, 2.0]),)],
                {"this is the standard deviation, not the standard error.":
                 lambda scores: torch.stack((scores.mean(), scores.std()))}),
        "torch.stack((mean, std / root of the number))."),
}
