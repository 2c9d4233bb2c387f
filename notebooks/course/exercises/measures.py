"""Exercises of the notebooks on feet, of shots, of measuring style, and of the capstone."""

import math

import torch
from course.checks import Exercise, draws, same_as


def _knee(a, b, d) -> float:
    return math.degrees(math.acos(min(1.0, max(-1.0, (a * a + b * b - d * d) / (2 * a * b)))))


def _skate(places, contact, fps):
    return (places.diff(dim=0).norm(dim=1) * fps)[contact[1:] & contact[:-1]].mean()


def _toes() -> list[tuple]:
    contact = torch.tensor([1, 1, 1, 0, 0, 1, 1, 0], dtype=torch.bool)
    return [(draws(12, (8, 2))[0].cumsum(0), contact, fps) for fps in (60.0, 30.0)]


def _needed(points, seconds):
    return points.diff(dim=0).norm(dim=1).sum() / seconds


def _beside(place, start, end, low=0.0, high=1.0):
    along = (end - start) @ (place - start) / (end - start).square().sum()
    return (start + along.clamp(low, high) * (end - start) - place).norm() * 100


def _sides() -> list[tuple]:
    ends = torch.tensor([[0.0, 0.0], [0.0, 2.0]])
    return [
        (torch.tensor(place), *ends) for place in ([0.3, 1.0], [-0.4, 2.3], [0.2, -0.1], [0.0, 1.5])
    ]


def _arrives(places, goal, time, fps, seconds=0.2):
    first, last = (max(round((time + s) * fps), 0) for s in (-seconds, seconds))
    return bool(((places[first : last + 1] - goal).norm(dim=1) <= 0.15).any())


def _walks() -> list[tuple]:
    goal, places = (
        torch.tensor([0.0, 2.0]), torch.stack((torch.zeros(181), torch.arange(181) / 60), 1)
    )
    return [(places, goal, time, 60.0) for time in (2.0, 2.3, 1.6, 0.0)] + [
        (places + goal, goal, 0.1, 60.0)
    ]


def _leaks(first, second, gap) -> bool:
    early, late = sorted((first, second))
    return late[0] - early[1] < gap


LETTERS = 60  # of a finding, at least


def _finding(answer) -> str:
    """What is missing in a negative finding."""
    if not isinstance(answer, str):
        return f"a text is needed, not {type(answer).__name__}."
    if len(answer) < LETTERS:
        return "say what does not work, and how you measured it."
    if not any(letter.isdigit() for letter in answer):
        return "give a number."
    return ""


EXERCISES = {
    "09.1": Exercise(
        same_as(
            lambda x, v, rate, t: (x + (v + rate * x) * t) * math.exp(-rate * t),
            lambda: [(1.0, 0.0, 10.0, 0.1), (0.0, 2.0, 5.0, 0.3), (-1.0, 1.0, 2.0, 0.0)],
            {
                "the velocity at the start is missing.": lambda x, v, rate, t: (
                    (x + rate * x * t) * math.exp(-rate * t)
                ),
                "this is not critically damped: it leaves the rest with the wrong "
                "velocity.": lambda x, v, rate, t: (
                    x * math.exp(-rate * t)
                ),
            },
        ),
        "put x, v, λ and t into the formula of section 2.",
    ),
    "09.2": Exercise(
        same_as(
            _knee,
            lambda: [(0.43, 0.42, 0.6), (0.4, 0.4, 0.4), (0.43, 0.42, 1.2)],
            {
                "this is in radians.": lambda a, b, d: math.radians(_knee(a, b, d)),
                "this is the bend: a straight leg has 180 degrees.": lambda a, b, d: (
                    180 - _knee(a, b, d)
                ),
            },
        ),
        "law of cosines, clamp the cosine to [-1, 1], acos, degrees.",
    ),
    "09.3": Exercise(
        same_as(
            _skate,
            _toes,
            {
                "multiply by the frames per second.": lambda places, contact, fps: _skate(
                    places, contact, 1.0
                ),
                "leave out the steps in which only one frame is in "
                "contact.": lambda places, contact, fps: (
                    (places.diff(dim=0).norm(dim=1) * fps)[contact[1:]].mean()
                ),
            },
        ),
        "diff over the frames, norm, times fps; keep contact[1:] & contact[:-1]; mean.",
    ),
    "10.1": Exercise(
        same_as(
            _needed,
            lambda: [
                (torch.tensor([[0.0, 0.0], [1.0, 2.0], [0.0, 3.0]]), 4.0),
                (draws(3, (5, 2))[0], 2.5)
            ],
            {
                "the path is longer than the distance of its ends.": lambda points, seconds: (
                    (points[-1] - points[0]).norm() / seconds
                ),
                "this is the length of the path: divide it by the "
                "seconds.": lambda points, seconds: (
                    _needed(points, 1.0)
                ),
            },
        ),
        "diff of the points, norm of each difference, sum, divided by the seconds.",
    ),
    "10.2": Exercise(
        same_as(
            _beside,
            _sides,
            {
                "beyond an end, the nearest place of the path is that "
                "end.": lambda place, start, end: (
                    _beside(place, start, end, -1e9, 1e9)
                ),
                "this is in metres.": lambda place, start, end: _beside(place, start, end) / 100,
            },
        ),
        "project place − start on end − start, clamp the share to [0, 1], take the distance.",
    ),
    "10.3": Exercise(
        same_as(
            _arrives,
            _walks,
            {
                "a little too early or too late is allowed.": lambda *case: _arrives(
                    *case, seconds=0.0
                ),
                "look only at the frames around the time.": lambda *case: _arrives(
                    *case, seconds=1e3
                ),
            },
        ),
        "cut out the frames from time − 0.2 to time + 0.2 seconds; is any of them near enough?",
    ),
    "11.1": Exercise(
        same_as(
            lambda styles: max(styles.count(style) for style in styles) / len(styles),
            lambda: [(["Old", "Old", "Strut"],), (["Old", "Strut", "Zombie", "Strut", "Strut"],)],
            {"this is the chance of a random guess.": lambda styles: 1 / len(set(styles))}
        ),
        "count each style, take the largest count, divide by the number of clips.",
    ),
    "11.2": Exercise(
        same_as(
            _leaks,
            lambda: [
                ((0, 100), (150, 200), 50), ((150, 200), (0, 101), 50), ((0, 100), (50, 60), 10),
                ((500, 600), (0, 100), 240)
            ],
            {
                "a gap of exactly `gap` frames is allowed.": lambda first, second, gap: (
                    sorted((first, second))[1][0] - sorted((first, second))[0][1] <= gap
                ),
                "the blocks may come in any order.": lambda first, second, gap: (
                    second[0] - first[1] < gap
                ),
            },
        ),
        "sort both blocks; compare the start of the second with the stop of the first.",
    ),
    "11.3": Exercise(
        same_as(
            lambda scores: torch.stack((scores.mean(), scores.std() / len(scores) ** 0.5)),
            lambda: [(torch.tensor([0.2, 0.4, 0.9]),), (torch.tensor([1.0, 2.0]),)],
            {
                "this is the standard deviation, not the standard error.": lambda scores: (
                    torch.stack((scores.mean(), scores.std()))
                )
            },
        ),
        "torch.stack((mean, std / root of the number)).",
    ),
    "12.1": Exercise(
        same_as(
            lambda value, limit, small: value <= limit if small else value >= limit,
            lambda: [(3.0, 5.0, True), (5.0, 5.0, True), (0.4, 0.5, False), (0.9, 0.5, False)],
            {
                "a value equal to the limit passes.": lambda value, limit, small: (
                    value < limit if small else value > limit
                ),
                "look at `small_is_good`, too.": lambda value, limit, small: value <= limit,
            },
        ),
        "use <= or >=, as small_is_good says.",
    ),
    "12.2": Exercise(
        same_as(
            lambda mine, floor: (floor - mine) / floor,
            lambda: [(0.1, 0.4), (0.4, 0.4), (0.6, 0.3)],
            {
                "this is the share that is left.": lambda mine, floor: mine / floor,
                "the sign is wrong.": lambda mine, floor: (mine - floor) / floor
            },
        ),
        "(floor − mine) / floor.",
    ),
    "12.3": Exercise(_finding, "one or two sentences: what, how measured, a number."),
}
