"""Exercises of the notebooks on feet, of shots, of measuring style, and of the capstone."""

import math
from functools import cache

import torch
from course.checks import Exercise, draws, equals, same_as, shows, traced, truth

import toolkit as tk

#: Degrees of the knee of exercise 09.2, whose bones have 50 and 45 cm, with a target at 94 cm.
KNEE = math.degrees(math.acos((0.5**2 + 0.45**2 - 0.94**2) / (2 * 0.5 * 0.45)))


def _skate(places, contact, fps):
    return (places.diff(dim=0).norm(dim=1) * fps)[contact[1:] & contact[:-1]].mean()


def _toes() -> list[tuple]:
    contact = torch.tensor([1, 1, 1, 0, 1, 0, 1, 1], dtype=torch.bool)
    return [(draws(12, (8, 2))[0].cumsum(0), contact, fps) for fps in (60.0, 30.0)]


FASTEST = 2.5  # times its natural speed, at which exercise 10.1 lets a style walk


@cache
def _times_natural(seconds: float) -> float:
    bank = tk.pretrained().bank
    plan, _ = tk.shots.Shot([(0, 0), (0, 4, seconds)], "Old").plan(bank)
    return max(plan.speed) / bank.speed("Old")


def _beside(place, start, end, low=0.0, high=1.0):
    along = (end - start) @ (place - start) / (end - start).square().sum()
    return (start + along.clamp(low, high) * (end - start) - place).norm() * 100


def _sides() -> list[tuple]:
    ends = torch.tensor([[0.0, 0.0], [0.0, 2.0]])
    oblique = torch.tensor([[1.0, -1.0], [-2.0, 3.0]])
    return [
        (torch.tensor(place), *pair) for pair in (ends, oblique)
        for place in ([0.3, 1.0], [-0.4, 2.3], [0.2, -0.1], [4.0, -4.0], [0.0, 1.5])
    ]


def _arrives(places, goal, time, fps, seconds=0.2):
    first, last = (max(round((time + s) * fps), 0) for s in (-seconds, seconds))
    return bool(((places[first : last + 1] - goal).norm(dim=1) <= 0.15).any())


def _walks() -> list[tuple]:
    along = torch.stack((torch.zeros(181), torch.arange(181) / 60), 1)
    goal, aside = torch.tensor([0.0, 2.0]), torch.tensor([0.3, 0.0])
    first, late = along.new_zeros(2, 181, 2)  # at the goal in one frame only
    first[0] = late[73] = goal
    return [(along, goal, time, 60.0) for time in (2.0, 2.3, 1.6, 0.0, 2.05 + 0.3)] + [
        (along + goal, goal, 0.1, 60.0), (along + aside, goal, 2.0, 60.0),
        (along, torch.tensor([0.0, 2.14]), 1.8, 60.0),  # only the last frame comes near enough
        (first, goal, 0.1, 60.0), (late, goal, 1.0, 60.0), (along, goal + aside / 6, 2.0, 60.0),
    ]


def _result(errors, repeat, mean, better=min, half=2.0) -> dict:
    floor = better(repeat, mean)
    gain, spread = 1 - errors.mean() / floor, (errors.max() - errors.min()) / half / floor
    return {"gain": gain, "spread": spread, "clear": bool(gain > spread)}


def _kinds(values) -> set:
    return {x.item() if isinstance(x, torch.Tensor) else x for x in values}


def _useless(labels, answers) -> bool:
    return len(_kinds(answers)) == 1


def _interval(scores, draws):
    return torch.quantile(scores[draws].mean(1), torch.tensor([0.025, 0.975], dtype=scores.dtype))


def _samples() -> list[tuple]:
    draw = torch.Generator().manual_seed(5)
    return [(torch.rand(n, generator=draw), torch.randint(n, (400, n), generator=draw))
            for n in (5, 30)]


#: Of exercise 12.1: what was measured of a clip, of a style learnt from it, and of three floors.
WALKS = {
    name: dict(zip(("posture, cm", "range, cm", "lift, cm"), row, strict=True)) for name, row in {
        "clip": (1.2, 9.0, 29.0),
        "style": (4.1, 7.0, 25.0),
        "HighKnees": (9.8, 7.5, 27.0),
        "shifted": (0.5, 7.5, 9.0),
        "statue": (3.9, 0.0, 5.0),
        # not in the notebook
        "third style": (4.6, 7.4, 24.0),
        "third statue": (4.5, 1.1, 5.9),
        "third HighKnees": (9.5, 7.2, 28.1),
        "third shifted": (1.4, 8.5, 8.0),
        "second style": (5.2, 6.1, 26.0),
        "second HighKnees": (8.8, 8.0, 26.0),
        "second statue": (2.9, 0.3, 4.0),
        "second shifted": (0.3, 6.9, 10.1),
    }.items()
}


def _passes(grade, walk: str) -> bool:
    return truth(grade(dict(WALKS[walk]))) is True


def _refuses(grade, walk: str) -> bool:
    return not any(_passes(grade, name) for name in (walk, f"second {walk}", f"third {walk}"))


RUNTIME = {tk.runtime.frame.__file__, tk.runtime.recording.__file__}
UNITS = ("cm", "mm", "m", "m/s", "cm/s", "m/s²", "°", "%", "s", "Hz", "1/s", "frames", "times")


def _of_runtime(code) -> str:
    """Whether some code is of the runtime: its name, or ""."""
    return code.co_name if code.co_filename in RUNTIME else ""


def _finding(answer) -> str:
    """What is missing in a negative finding: a sentence, and a measurement that can be repeated."""
    if not isinstance(answer, dict) or set(answer) != {"what", "unit", "measure"}:
        return "give `what`, `unit` and `measure`."
    if len(set(str(answer["what"]).lower().split())) < 5:
        return "say in a sentence what does not work."
    if answer["unit"] not in UNITS:
        return f"the unit should be one of {', '.join(UNITS)}."
    if not callable(answer["measure"]):
        return "`measure` should be a function: somebody else must be able to run it again."
    if getattr(answer["measure"], "__name__", "") == "bone_error":
        return "measure something else than section 7."
    found = []
    for name in ("Mine", "Mine", "Neutral", "Zombie"):
        number, walked = traced(answer["measure"], name, note=_of_runtime)
        if not walked:
            return "`measure` should walk: by tk.runtime.states, rollout or step."
        found.append(float(number))
    mine, again, floor, other = found
    if mine != again:
        return "the second measurement gives another number: fix the seed."
    if not all(map(math.isfinite, (mine, floor, other))):
        return "a number is not finite."
    if not mine > floor + 0.05 * abs(floor):
        return "the floor has as much: then nothing is wrong with your style."
    return ""


#: Postures, cm, of a style and of a floor from several starts.
STARTS = (
    ([3.0, 4.0, 3.5, 3.2], [9.0, 9.0, 8.0, 10.0]), ([8.0, 8.5, 8.2, 8.1], [20.0, 8.3, 20.0, 20.0]),
    ([2.0, 8.0, 3.0, 4.0], [4.0, 9.0, 5.0, 5.0]), ([5.0, 3.0, 3.0, 3.0], [5.0, 9.0, 9.0, 9.0]),
    ([1.0, 2.0], [2.0, 3.0]), ([9.0, 9.1, 9.2], [2.0, 2.0, 2.0]),
)


def _beats(style, floor) -> bool:
    gain, spread = (floor - style).mean(), style.max() - style.min()
    return bool((style < floor).all() and gain > spread)


EXERCISES = {
    "09.1": Exercise(
        equals(0.08, {
            "with this step the offset is gone after two frames": 0.04,
            "this is in frames per second": 12.5,
        }, tolerance=0.03),
        "by which factor does Euler's method multiply an offset that decays with the rate λ?",
        "1 − λ · step is below −1 if the step is longer than 2 / λ.",
    ),
    "09.2": Exercise(
        equals(180 - KNEE, {
            "this is the angle: a straight leg has 180 degrees": KNEE,
            "this is in radians": math.radians(180 - KNEE),
        }, tolerance=0.03),
        "which angle has the knee of a straight leg, and which after that?",
        "law of cosines with d = 0.94 m, acos, degrees; subtract it from 180.",
    ),
    "09.3": Exercise(
        same_as(
            _skate,
            _toes,
            {
                "multiply by the frames per second.": lambda places, contact, fps: _skate(
                    places, contact, 1.0
                ),
                "leave out the steps in which only one frame is in contact.":
                    lambda places, contact, fps: (
                        (places.diff(dim=0).norm(dim=1) * fps)[contact[1:]].mean()),
            },
        ),
        "a step has two frames. Which contacts do they need?",
        "diff over the frames, norm, times fps; keep contact[1:] & contact[:-1]; mean.",
    ),
    "10.1": Exercise(
        shows(
            ("the plan is too fast with so little time",
             lambda seconds: _times_natural(round(float(seconds), 3)) <= FASTEST),
            ("there is a plan with less time",
             lambda seconds: _times_natural(round(float(seconds) - 0.25, 3)) > FASTEST),
        ),
        "is the mean speed the largest one? The character must start and stop.",
        "try times from 2 s to 6 s in steps of 0.1 s, and print max(plan.speed) / natural.",
    ),
    "10.2": Exercise(
        same_as(
            _beside,
            _sides,
            {
                "beyond an end, the nearest place of the path is that end.":
                    lambda place, start, end: _beside(place, start, end, -1e9, 1e9),
                "this is in metres.": lambda place, start, end: _beside(place, start, end) / 100,
            },
        ),
        "which place of the path is nearest, and what if it lies before the start?",
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
        "which frames count, and what is the number of the first one if time is 0?",
        "cut out the frames from time − 0.2 to time + 0.2 seconds; is any of them near enough?",
    ),
    "11.1": Exercise(
        shows(
            ("give ten labels or more, and as many answers",
             lambda labels, answers: len(labels) == len(answers) > 9),
            ("less than 90 % of the answers are right", lambda labels, answers: sum(
                a == b for a, b in zip(labels, answers, strict=True)) >= 0.9 * len(labels)),
            ("there is only one style: no judge is needed",
             lambda labels, answers: len(_kinds(labels)) > 1),
            ("this judge gives several answers: it may know something", _useless),
            parts=2,
        ),
        "what does a judge answer that never looks at the motion?",
        "nine of ten clips have one style, and the judge always names it.",
    ),
    "11.2": Exercise(
        same_as(
            _result,
            lambda: [
                (torch.tensor(errors), *floors) for errors, floors in (
                    ([0.05, 0.07, 0.066], (0.08, 0.96)), ([0.5, 0.85], (1.2, 0.9)),
                    ([0.21, 0.19, 0.25], (0.2, 0.9)), ([0.06, 0.061], (0.9, 0.08)))
            ],
            {
                "the better floor has the smaller error.":
                    lambda *case: _result(*case, better=max),
                "this is the whole range of the seeds.": lambda *case: _result(*case, half=1.0),
            },
        ),
        "which floor is harder to beat, and are gain and spread in one unit?",
        "floor = min(repeat, mean); gain = 1 - errors.mean() / floor; half the range / floor.",
    ),
    "11.3": Exercise(
        same_as(
            _interval, _samples,
            {
                "these are the quantiles of the scores, not of their means.": lambda scores, draws:
                    torch.quantile(scores, torch.tensor([0.025, 0.975])),
                "this is the interval of 90 %.": lambda scores, draws: torch.quantile(
                    scores[draws].mean(1), torch.tensor([0.05, 0.95])),
            },
        ),
        "what would the mean have been if other clips had been drawn?",
        "scores[draws].mean(1) are the means; their quantiles 0.025 and 0.975 are the interval.",
    ),
    "12.1": Exercise(
        shows(
            ("a function of one row is needed", callable),
            ("no answer yet", lambda f: f(dict(WALKS["clip"])) is not ...),
            ("the clip itself is refused", lambda f: _passes(f, "clip")),
            ("a style is refused: set limits that it meets",
             lambda f: all(_passes(f, f"{nth}style") for nth in ("", "second ", "third "))),
            ("HighKnees passes: a grade that a floor passes is no grade",
             lambda f: _refuses(f, "HighKnees")),
            ("a statue passes: look at the movement, too", lambda f: _refuses(f, "statue")),
            ("the shifted walk passes: look at a movement of its own",
             lambda f: _refuses(f, "shifted")),
        ),
        "in which column is HighKnees worse than the style, and in which the shifted walk?",
        "limit the posture from above and the lift from below.",
    ),
    "12.2": Exercise(
        same_as(_beats, lambda: [tuple(map(torch.tensor, case)) for case in STARTS], {
            "one start where the floor is as near is enough to refuse.": lambda style, floor: bool(
                (floor - style).mean() > style.max() - style.min()),
            "a gain that is smaller than the range may be luck.": lambda style, floor: bool(
                (style < floor).all()),
        }),
        "two things can make it luck: a start where the floor is as near, and what else?",
        "(style < floor).all(), and (floor − style).mean() above style.max() − style.min().",
    ),
    "12.3": Exercise(
        _finding,
        "could somebody else measure it again, and what would a floor have there?",
        "`what`: a sentence; `unit`: such as \"mm\"; `measure`: a function of a style's name that "
        "walks in it and returns a number.",
    ),
}
