"""Names of joints, styles and files, which may come from anywhere: one line that can be shown."""

import unicodedata
from collections import Counter
from collections.abc import Iterable

HIDDEN = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")  # they reorder text
KINDS = frozenset(("Cc", "Cs", "Zl", "Zp"))  # controls, halves of pairs, line and paragraph ends


def shows(text: str) -> bool:
    """Whether no character moves the cursor, ends the line, reorders text or cannot be encoded."""
    return text.isprintable() or not any(
        c in HIDDEN or unicodedata.category(c) in KINDS for c in text)


def printable(text: object) -> str:
    """A text in which such characters are replaced by their escapes, such as ``\\x1b``."""
    return "".join(c if shows(c) else ascii(c)[1:-1] for c in str(text))


def checked(names: Iterable[str], what: str) -> tuple[str, ...]:
    """The names; ValueError if one is no text, empty, not to be shown, or comes twice.

    ``what`` they name begins the message.
    """
    if isinstance(names, str):
        raise ValueError(f"{what}: expected a list of names, got the text {names!r:.60}")
    names = tuple(names)
    for name in names:
        if not isinstance(name, str) or not name:
            raise ValueError(f"{what} must be named by a text, got {name!r:.60}")
        if not shows(name):
            raise ValueError(f"the name of {what} has characters that cannot be printed: "
                             f"{repr(name)[1:-1]:.60}")
    if twice := sorted(name for name, times in Counter(names).items() if times > 1):
        raise ValueError(f"{what} is named twice: {', '.join(twice)}")
    return names
