"""Sentences about results, which a run shows only if they are true."""

from collections.abc import Mapping


class Sentences:
    """Markdown of one or several true sentences."""

    def __init__(self, *lines: str):
        self.lines = lines

    def __repr__(self) -> str:
        return "\n".join(self.lines)

    def _repr_markdown_(self) -> str:
        return "\n".join(self.lines)


def claim(sentence: str, *conditions: bool) -> Sentences:
    """Show a sentence about a result, if all conditions hold.

    Numbers in the sentence come from the run (an f-string). What the sentence says of them is a condition.

    Raises
    ------
    ValueError
        If there is no condition.
    AssertionError
        If one does not hold: then the sentence and the run disagree.
    """
    if not conditions:
        raise ValueError(f"give the conditions under which this is true: {sentence}")
    for i, condition in enumerate(conditions):
        if not bool(condition):
            raise AssertionError(f"condition {i + 1} of {len(conditions)} does not hold, so this is not true: {sentence}")
    return Sentences(sentence)


def learnt(sentences: Mapping[str, bool]) -> Sentences:
    """The list *What you learnt*: sentence -> the condition under which it is true.

    Raises
    ------
    AssertionError
        If one is not true.
    """
    return Sentences(*(f"* {claim(sentence, condition)}" for sentence, condition in sentences.items()))
