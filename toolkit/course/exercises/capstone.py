"""Exercises of the last notebook, the project."""

from toolkit.course.checks import Exercise, same_as

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
    "12.1": Exercise(
        same_as(lambda value, limit, small: value <= limit if small else value >= limit,
                lambda: [(3.0, 5.0, True), (5.0, 5.0, True), (0.4, 0.5, False), (0.9, 0.5, False)],
                {"a value equal to the limit passes.": lambda value, limit, small: value < limit if small else value > limit,
                 "look at `small_is_good`, too.": lambda value, limit, small: value <= limit}),
        "use <= or >=, as small_is_good says."),
    "12.2": Exercise(
        same_as(lambda mine, floor: (floor - mine) / floor, lambda: [(0.1, 0.4), (0.4, 0.4), (0.6, 0.3)],
                {"this is the share that is left.": lambda mine, floor: mine / floor,
                 "the sign is wrong.": lambda mine, floor: (mine - floor) / floor}),
        "(floor − mine) / floor."),
    "12.3": Exercise(_finding, "one or two sentences: what, how measured, a number."),
}
