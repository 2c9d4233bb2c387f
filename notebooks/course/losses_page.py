"""A page and a picture of `course.plane`: a switch for each of the five losses."""

import math
from collections.abc import Sequence
from pathlib import Path

from course import plane
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from torch import Tensor

from toolkit.stylization.losses import LOSSES
from toolkit.view.frontend import embed
from toolkit.view.render.mannequin import PALETTE
from toolkit.view.render.picture import Picture

NAMES = {
    "adv": "the judge accepts", "cyc": "there and back", "id": "own style",
    "sty": "the code is found again", "ds": "two codes give two results"
}
SHOWN = {
    "inside": "accepted by the judge", "content": "content kept (correlation)",
    "version": "version copied (share)", "spread": "distance of two noises",
    "own": "error in the own style"
}
GOOD = {"inside": "1", "content": "1", "version": "1", "spread": "more than 0", "own": "0"}
RANGE = (-2.2, 2.2)  # of both axes, in pictures; results outside are drawn at the edge
BOX, SOURCE = "#eeebe4", "#8a8f98"


def losses_page(toy: plane.Toy, size: int = 420) -> str:
    """HTML with a checkbox for each loss: the results of three noises and the measures of the
    stylizer with these losses.

    Raises
    ------
    ValueError
        If the toy does not have a stylizer for each of `plane.SWITCHES`, in this order.
    """
    if toy.losses != list(plane.SWITCHES):
        raise ValueError(
            f"the page needs all {len(plane.SWITCHES)} sets of losses (plane.SWITCHES), got "
            f"{len(toy.losses)}"
        )
    x, made = _shown(toy)
    measures = toy.measures()
    data = {
        "x": _rounded(x),
        "made": _rounded(made),
        "colours": PALETTE[:3],
        "losses": LOSSES,
        "range": RANGE,
        "size": size,
        "boxes": [
            [*(m - h).tolist(), *(2 * h).tolist()]
            for m, h in zip(plane.MIDDLE, plane.HALF, strict=True)
        ],
        "measures": [[SHOWN[k], GOOD[k], _rounded(measures[k])] for k in SHOWN],
    }
    switches = "".join(
        f'<label><input type="checkbox" id="{name}" checked> <b>{name}</b> {NAMES[name]}</label>'
        for name in LOSSES
    )
    page = (Path(__file__).parent / "losses.html").read_text(encoding="utf-8")
    return (
        page.replace("SWITCHES", switches).replace("DATA", embed(data)).replace("SIZE", str(size))
    )


def losses_figure(toy: plane.Toy, titles: Sequence[str]) -> Figure:
    """The results of the first stylizers of a toy, a panel each.

    Sources (grey), and the results of three noises.
    """
    x, made = _shown(toy)
    rows = math.ceil(len(titles) / 3)
    figure = Picture(figsize=(9.6, 3.5 * rows), dpi=90, layout="constrained")
    panels = figure.subplots(rows, 3, sharex=True, sharey=True, squeeze=False).flat
    for axes, title, results in zip(panels, titles, made, strict=False):
        for middle, half in zip(plane.MIDDLE, plane.HALF, strict=True):
            axes.add_patch(Rectangle((middle - half).tolist(), *(2 * half).tolist(), color=BOX))
        axes.scatter(*x.T, color=SOURCE, s=9)
        for result, colour in zip(results, PALETTE, strict=False):
            axes.scatter(*result.T, color=colour, s=5 + 14 * (x[:, 0] + 1))
        axes.set(xlim=RANGE, ylim=RANGE, title=title, aspect="equal")
    figure.supxlabel("content")
    figure.supylabel("style")
    return figure


def _shown(toy: plane.Toy) -> tuple[Tensor, Tensor]:
    x, made = toy.results()
    return x, made.clamp(*RANGE)


def _rounded(values: Tensor) -> list:
    return (values.double() * 100).round().div(100).tolist()
