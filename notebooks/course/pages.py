"""Figures that answer without a kernel.

Plotly with its code once a notebook, and pages of the 3D scene in a frame.
"""

import json
import math
import tempfile
from base64 import b64encode
from collections.abc import Mapping
from html import escape
from io import BytesIO
from pathlib import Path

import plotly.io as pio
from plotly.io.base_renderers import MimetypeRenderer
from plotly.offline import get_plotlyjs

from toolkit.motion import Clip, root_frames, trajectory
from toolkit.view.frontend import embed
from toolkit.view.pages import live_page, page

NAME = "toolkit"  # of plotly's renderer
LOADED = 'data-toolkit="plotly"'  # marks plotly's code: the site loads its own copy in its place
#: Folds the code of cells with the tag ``hide-input`` in the pages of nbconvert; it opens under the
#: pointer.
FOLDED = (
    ".celltag_hide-input .jp-InputArea:not(:hover) .cm-editor "
    "{ max-height: 1.6em; overflow: hidden; opacity: .5 }"
)


class Page:
    """Something to show as HTML."""

    def __init__(self, html: str):
        self.html = html

    def __repr__(self) -> str:
        return f"a figure as {len(self.html) / 1e6:.1f} MB of HTML"

    def _repr_html_(self) -> str:
        return self.html


class Renderer(MimetypeRenderer):
    """A figure for JupyterLab, and as HTML for pages, which asks no server for anything."""

    def to_mimebundle(self, fig_dict: dict) -> dict:
        """The figure in both forms."""
        plain = json.loads(pio.json.to_json_plotly(fig_dict))
        return {"application/vnd.plotly.v1+json": plain, "text/html": chart(fig_dict)}


def charts() -> str:
    """Make figures of plotly show themselves by `Renderer`, and return plotly's code for a page."""
    pio.renderers[NAME] = Renderer()
    pio.renderers.default = NAME
    return f"<script {LOADED}>{get_plotlyjs()}</script><style>{FOLDED}</style>"


def chart(figure) -> str:
    """A plotly figure as a part of a page that has plotly's code (`charts`)."""
    return pio.to_html(
        figure, include_plotlyjs=False, include_mathjax=False, full_html=False, auto_play=False,
        validate=False, config={"responsive": True, "displaylogo": False}
    )


def show(html: str, height: int) -> Page:
    """A page in a frame, ``height`` pixels high.

    It has an origin of its own, so it rests when out of sight.
    """
    return Page(
        f'<iframe srcdoc="{escape(html)}" sandbox="allow-scripts allow-downloads" allow="gamepad; '
        f'fullscreen" '
        f'style="width: 100%; height: {height}px; border: 0" loading="lazy" title="Live '
        f'figure"></iframe>'
    )


def report(parts: Mapping[str, object], path: Path) -> str:
    """A page of titles and their texts, pandas' tables and matplotlib's pictures; a file, too."""
    body = ""
    for title, part in parts.items():
        body += f"<h3>{escape(title)}</h3>"
        if isinstance(part, str):
            body += f"<p>{escape(part)}</p>"
        elif hasattr(part, "to_html"):
            body += part.to_html()
        else:
            part.savefig(file := BytesIO(), format="png")
            image = b64encode(file.getvalue()).decode()
            body += f'<img width="100%" alt="{escape(title)}" src="data:image/png;base64,{image}">'
    path.write_text(f"<!doctype html><meta charset=utf-8>{body}", encoding="utf-8")
    return body


def film(
    clips: Clip | list[Clip], *, title: str = "", caption: str = "", height: int = 420, **options
) -> Page:
    """Clips as a film that plays in the page: drag to turn, wheel to zoom.

    Parameters
    ----------
    clips, title, caption
        One clip or several side by side; heading and the line below it.
    height, options
        Pixels; ``labels``, ``contacts`` and ``styles`` as in `toolkit.view.html`.
    """
    title = title or (clips.style if isinstance(clips, Clip) else "Motion")
    with tempfile.TemporaryDirectory() as folder:
        path = page.html(clips, Path(folder, "film.html"), title=title, caption=caption, **options)
        return show(path.read_text(encoding="utf-8"), height)


def ahead(clip: Clip) -> Clip:
    """The clip, turned so that its first frame looks ahead."""
    sine, cosine = trajectory.heading(root_frames(clip).rotations[0])
    return clip.moved(turn=-math.atan2(sine, cosine))


def steer(
    model, bank, *, title: str = "Walk: W A S D, blend: drag the marker", height: int = 600,
    **options
) -> Page:
    """A character that keys, touch and a style triangle steer.

    The network runs in the page (`toolkit.view.web`).
    """
    with tempfile.TemporaryDirectory() as folder:
        path = live_page.web(
            model, bank, Path(folder, "walk.html"), title=title, half=True, **options
        )
        return show(path.read_text(encoding="utf-8"), height)


def switch(pages: dict[str, Page]) -> Page:
    """Pages by label, of which one is open at a time, first the first one."""
    parts = [f'<details name="switch"{"" if i else " open"}><summary style="cursor: pointer">'
             f'<b>{escape(label)}</b></summary>{one.html}</details>'
             for i, (label, one) in enumerate(pages.items())]
    return Page("".join(parts))


def two_bone() -> Page:
    """A leg of two bones whose ankle follows the pointer, with the law of cosines beside it."""
    return show((Path(__file__).parent / "two_bone.html").read_text(encoding="utf-8"), 270)


def blind(
    pairs: dict[str, tuple[Clip, Clip]], question: str, seconds: float = 2.5
) -> Page:
    """A blind test of people: which of two motions is the first of its pair?

    The page shows each pair in a random order, from its side, and counts the reader's answers.
    ``pairs`` have names; all clips have one skeleton, and at least so many ``seconds``.
    """
    shown, step = [], 2  # 30 frames per second
    for name, clips in pairs.items():
        local = (root_frames(clip).to_local(clip.global_positions) for clip in clips)
        motions = [places[: round(seconds * clip.fps) : step, :, [2, 1]].flatten(1)
                   for places, clip in zip(local, clips, strict=True)]
        shown.append({"name": name, "motions": [
            (motion * 1000).round().div(1000).tolist() for motion in motions]})
    first = next(iter(pairs.values()))[0]
    data = {"pairs": shown, "question": question, "fps": first.fps / step,
            "parents": list(first.skeleton.parents)}
    page = (Path(__file__).parent / "blind.html").read_text(encoding="utf-8")
    return show(page.replace("DATA", embed(data)), 460)


#: Symbol -> (colour in formulas, tables and figures, what it is, its name in code).
SYMBOLS = {
    "x": ("#1f6fb5", "input: this frame, its pose and its trajectory", "data.inputs[style]"),
    "p": ("#c9701e", "phases of both hands and both feet", "data.phases[style]"),
    "α": (
        "#c9701e",
        "gates: shares of the experts, computed from normalised p by the gating network Ω",
        "model.gating(p)",
    ),
    "z": ("#2f8f5b", "output: the next frame", "data.outputs[style]"),
    "y": ("#b0408a", "style clip: 240 frames of one style", "data.clips[style]"),
    "γ, β": (
        "#7b3fb5",
        "scales and shifts of the hidden layers: the style vector, computed from y by the "
        "generator Ψ",
        "bank[style]",
    ),
}


def symbols() -> Page:
    """A table of the symbols."""
    rows = "".join(
        f'<tr><td style="color: {colour}; font: italic 600 18px serif">{name}</td><td '
        f'style="text-align: left">'
        f'{text}</td><td style="text-align: left"><code>{code}</code></td></tr>'
        for name, (colour, text, code) in SYMBOLS.items()
    )
    return Page(f"<table><tr><th>symbol</th><th>what it is</th><th>in code</th></tr>{rows}</table>")
