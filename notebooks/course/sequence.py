"""The notebooks of the course in their order, and the map with one place lit."""

from dataclasses import dataclass
from html import escape

from course.pages import Page, charts

# Width and height of a box and of the space between boxes, in pixels.
BOX, GAP = (150, 46), (20, 26)
INK, QUIET, LIT, PAPER, LINE = "#2b323b", "#5d6570", "#7b3fb5", "#fbfaf7", "#c9c4b8"


@dataclass(frozen=True)
class Lesson:
    """One notebook."""

    number: str  # such as "02a": the first characters of the file's name
    name: str  # the rest of the file's name
    title: str  # short, for the map
    question: str  # that the notebook answers
    minutes: int  # for a reader who runs all cells and does the exercises
    needs: tuple[str, ...]  # numbers of the notebooks to read before
    place: tuple[int, int]  # column and row on the map

    @property
    def file(self) -> str:
        """Name of the file in ``notebooks/``."""
        return f"{self.number}_{self.name}.ipynb"


LESSONS = {
    lesson.number: lesson
    for lesson in (
        Lesson(
            "00", "walk", "A first walk", "What can I do with this toolkit in twenty minutes?", 20,
            (), (0, 0)
        ),
        Lesson("01", "features", "Features", "What does the network see?", 50, ("00",), (1, 0)),
        Lesson("02a", "phase", "Phase", "What is the phase of a limb?", 60, ("01",), (2, 0)),
        Lesson(
            "02b", "laboratory", "Laboratory",
            "From which curve should a limb's phase be measured?", 70, ("02a",), (3, 1)
        ),
        Lesson(
            "03a", "network", "The network", "What does the network compute?", 60, ("02a",), (3, 0)
        ),
        Lesson(
            "03b", "training", "Training", "How does one network learn many styles?", 60, ("03a",),
            (4, 0)
        ),
        Lesson(
            "04", "blending", "Blending", "What does a style blend look like when it walks?", 50,
            ("03a",), (4, 1)
        ),
        Lesson(
            "05", "style_space", "Style space", "What does the space of styles look like?", 50,
            ("04",), (5, 1)
        ),
        Lesson(
            "06", "a_new_style", "A new style",
            "How does a character learn a new way of walking from one clip?", 60, ("03b", "04"),
            (5, 0)
        ),
        Lesson(
            "07", "seven_models", "Seven models", "How do the seven models of Table 2 compare?", 50,
            ("03b",), (5, 3)
        ),
        Lesson(
            "08a", "five_losses", "Five losses", "What does each loss of a stylisation network do?",
            45, ("01",), (1, 1)
        ),
        Lesson(
            "08b", "restyle", "Restyling", "Can a finished walk be given another style?", 65,
            ("08a",), (1, 2)
        ),
        Lesson("09", "feet", "Feet", "How do feet stay where they stand?", 50, ("01",), (2, 1)),
        Lesson(
            "10", "the_shot", "The shot",
            "How does one plan a walk, see what cannot be met, and export it?", 50, ("04",),
            (4, 3)
        ),
        Lesson(
            "11", "measuring_style", "Measuring style",
            "When may one say that a motion has a style?", 55, ("08b", "07"), (6, 2)
        ),
        Lesson(
            "12", "capstone", "Capstone", "What does my own motion become?", 240, ("06", "11"),
            (6, 0)
        ),
    )
}


def here(number: str) -> Page:
    """The map of the course with one place lit; also makes plotly's figures work without a kernel.

    Parameters
    ----------
    number
        Of the notebook that is open, such as "02a".

    Raises
    ------
    ValueError
        If there is no such notebook.
    """
    if number not in LESSONS:
        raise ValueError(f"no notebook {number!r} in the course; there are {', '.join(LESSONS)}")
    return Page(charts() + picture(number))


def picture(number: str) -> str:
    """The map as SVG."""
    lesson, width, height = (
        LESSONS[number], *(max(x.place[k] for x in LESSONS.values()) + 1 for k in (0, 1))
    )
    size = width * (BOX[0] + GAP[0]) + GAP[0], height * (BOX[1] + GAP[1]) + GAP[1]
    lines = [
        _arrow(LESSONS[before], x, x is lesson) for x in LESSONS.values() for before in x.needs
    ]
    boxes = [_box(x, x is lesson) for x in LESSONS.values()]
    label = f"Map of the course; you are at {lesson.number}, {lesson.title}"
    return (
        f'<svg role="img" aria-label="{escape(label)}" viewBox="0 0 {size[0]} {size[1]}" '
        f'style="width: 100%; max-width: {size[0]}px; background: {PAPER}" '
        f'font-family="system-ui, sans-serif" '
        f'xmlns="http://www.w3.org/2000/svg">{"".join(lines + boxes)}</svg>'
    )


def _corner(lesson: Lesson) -> tuple[int, int]:
    return tuple(GAP[k] + lesson.place[k] * (BOX[k] + GAP[k]) for k in (0, 1))


def _box(lesson: Lesson, lit: bool) -> str:
    x, y = _corner(lesson)
    fill, ink, quiet = (LIT, "white", "white") if lit else ("white", INK, QUIET)
    return (
        f'<g><title>{escape(lesson.question)}</title><rect x="{x}" y="{y}" width="{BOX[0]}" '
        f'height="{BOX[1]}" rx="7" '
        f'fill="{fill}" stroke="{LIT if lit else LINE}"/>'
        f'<text x="{x + 10}" y="{y + 19}" font-size="12" font-weight="600" fill="{ink}">'
        f"{lesson.number} {escape(lesson.title)}</text>"
        f'<text x="{x + 10}" y="{y + 36}" font-size="11" fill="{quiet}">{lesson.minutes} '
        f'minutes</text></g>'
    )


def _arrow(start: Lesson, end: Lesson, lit: bool) -> str:
    (x0, y0), (x1, y1) = _corner(start), _corner(end)
    if start.place[0] == end.place[0]:  # down or up
        down = y1 > y0
        x0, y0, x1, y1 = (
            x0 + BOX[0] / 2, y0 + BOX[1] * down, x1 + BOX[0] / 2, y1 + BOX[1] * (not down)
        )
        path = f"M{x0} {y0} L{x1} {y1} m-4 {-6 if down else 6} L{x1} {y1} l4 {-6 if down else 6}"
    else:
        x0, y0, y1 = x0 + BOX[0], y0 + BOX[1] / 2, y1 + BOX[1] / 2
        path = (
            f"M{x0} {y0} C{x0 + GAP[0]} {y0} {x1 - GAP[0]} {y1} {x1} {y1} m-6 -4 L{x1} {y1} l-6 4"
        )
    return (f'<path d="{path}" fill="none" stroke="{LIT if lit else LINE}" '
            f'stroke-width="{2.5 if lit else 1.5}"/>')
