"""Figures of the notebooks on styles.

Vectors, pairs of styles, a line of blends, curves.
"""

from collections.abc import Mapping, Sequence

import numpy as np
import plotly.graph_objects as go
from course.charts import INK, QUIET, bones, finish, slider, style_space
from matplotlib.figure import Figure
from plotly.subplots import make_subplots
from torch import Tensor

from toolkit.features import Layout
from toolkit.motion import Clip, contacts
from toolkit.styles.comparison import periodicity
from toolkit.view.frontend import escape
from toolkit.view.render.mannequin import COLORS, PALETTE
from toolkit.view.render.picture import Picture, strip

# Ten colours that are told apart.
WHEEL = (*PALETTE[:5], "#d9772b", "#3f7d3a", "#1f4e79", "#a0522d", "#101820")


def vectors_figure(vectors: Tensor, names: Sequence[str]) -> Figure:
    """Style vectors ``[S, 4 H]`` as their difference from the mean: a row per style, a panel for
    each of γ₁, β₁, γ₂, β₂.

    The units of each panel are sorted by their standard deviation over the styles.
    """
    figure = Picture(figsize=(10, 0.19 * len(names) + 1.3), dpi=80, layout="constrained")
    panels = figure.subplots(1, 4, sharey=True)
    for axes, part, title in zip(
        panels, (vectors - vectors.mean(0)).chunk(4, 1), ("γ₁", "β₁", "γ₂", "β₂"), strict=True
    ):
        image = axes.imshow(
            part[:, part.std(0).argsort(descending=True)], aspect="auto", cmap="PuOr", vmin=-1,
            vmax=1, interpolation="nearest"
        )
        axes.set(title=title, xlabel="hidden units, sorted")
    panels[0].set_yticks(range(len(names)), names, fontsize=8)
    figure.colorbar(image, ax=panels, label="difference from the mean style", shrink=0.8)
    return figure


def map_figure(
    points, names: Sequence[str], labels: Sequence[str], *, marked: Mapping | None = None,
    always: Sequence[str] = (), title: str = ""
) -> go.Figure:
    """Styles in the plane as `toolkit.view.style_space`, with the names of crowded points under the
    mouse alone, but those ``always``.
    """
    figure, at = style_space(points, names, labels, marked=marked, title=title), np.asarray(points)
    stars = [np.asarray(place) for place in (marked or {}).values()]
    near = np.abs(at[:, None] - np.concatenate([at, *(star[None] for star in stars)])) / np.ptp(
        at, axis=0
    )
    letters = np.array([*map(len, names), *([10] * len(stars))])
    crowded = (
        (near[..., 0] < 0.008 * np.add.outer(letters[: len(at)], letters)) & (near[..., 1] < 0.035)
    ).sum(1) > 1
    alone = {escape(name) for name, other in zip(names, crowded, strict=True)
             if not other or name in always}
    for trace in figure.data[: len(dict.fromkeys(labels))]:
        trace.hovertext, trace.text = (
            trace.text, [name if name in alone else "" for name in trace.text]
        )
        trace.hovertemplate = "<b>%{hovertext}</b><br>%{fullData.name}<extra></extra>"
    return figure


def pairs_figure(x, y, names: Sequence[str], x_title: str, y_title: str, *, title: str = "",
                 colour: int = 0, floor: Mapping[str, float] | None = None) -> go.Figure:
    """A point per pair (or per style) with its name under the mouse.

    ``floor`` are horizontal lines, name -> height.
    """
    figure = go.Figure()
    figure.add_scatter(
        x=np.asarray(x), y=np.asarray(y), text=[escape(name) for name in names], mode="markers",
        marker={"size": 7, "color": WHEEL[colour], "opacity": 0.65}, showlegend=False,
        hovertemplate="<b>%{text}</b><br>%{x:.3g}, %{y:.3g}<extra></extra>"
    )
    for name, height in (floor or {}).items():
        figure.add_hline(
            y=height, line={"color": INK, "dash": "dash", "width": 1}, annotation_text=escape(name)
        )
    return finish(figure, title, 420, {"title": x_title}, {"title": y_title})


def line_figure(
    layout: Layout, poses: Tensor, t: Tensor, measured: Tensor, *, ends: tuple[str, str], what: str,
    title: str = ""
) -> go.Figure:
    """A slider along the line between two styles: the body at ``t``, seen from the front, beside a
    measured curve.

    Parameters
    ----------
    layout, poses
        The skeleton of the features, and a pose [T, J, 3] for each blend, in the root frame,
        metres.
    t, measured
        Weight of the second style [T], and what was measured of each blend [T].
    ends, what, title
        Names of both styles; name of the measure with its unit; the heading.
    """
    t, measured = np.asarray(t, dtype=float), np.asarray(measured, dtype=float)
    figure = make_subplots(1, 2, column_widths=[0.4, 0.6], horizontal_spacing=0.12)
    shown = len(t) // 2
    for side in ("left", "right", "middle"):
        figure.add_scatter(
            **_body(poses[shown], layout, side), mode="lines", showlegend=False, hoverinfo="skip",
            line={"color": COLORS[side] if side != "middle" else QUIET, "width": 6}, row=1, col=1
        )
    figure.add_scatter(
        x=t, y=measured, mode="lines+markers", line={"color": QUIET, "width": 2},
        marker={"size": 4}, showlegend=False, row=1, col=2,
        hovertemplate="t = %{x:.2f}: %{y:.3g}<extra></extra>"
    )
    figure.add_scatter(
        x=t[shown : shown + 1], y=measured[shown : shown + 1], mode="markers", showlegend=False,
        marker={"size": 15, "color": WHEEL[0]}, row=1, col=2, hoverinfo="skip"
    )
    frames = [
        go.Frame(
            name=str(k),
            traces=[0, 1, 2, 4],
            data=[
                *(
                    {"type": "scatter", **_body(poses[k], layout, side)}
                    for side in ("left", "right", "middle")
                ),
                {"type": "scatter", "x": [t[k]], "y": [measured[k]]},
            ],
        )
        for k in range(len(t))
    ]
    figure.frames = frames
    figure.add_vrect(x0=0, x1=1, fillcolor="#eeebe4", line_width=0, layer="below", row=1, col=2)
    finish(
        figure, title, 500, {}, {}, sliders=[slider([f"{value:.2f}" for value in t], "t = ", shown)]
    )
    figure.update_xaxes(range=[-1.0, 1.0], title="metres, seen from the front", row=1, col=1)
    figure.update_yaxes(range=[-0.1, 2.1], scaleanchor="x", row=1, col=1)
    figure.update_xaxes(title=f"t: 0 is {ends[0]}, 1 is {ends[1]}", row=1, col=2)
    figure.update_yaxes(title=what, row=1, col=2)
    return figure


def _body(pose: Tensor, layout: Layout, side: str) -> dict[str, np.ndarray]:
    """The bones of one side of the body, or of its middle, seen from the front.

    The left side is on the right.
    """
    owners = [
        next((s for s in ("left", "right") if s in name.lower()), "middle") for name in layout.names
    ]
    return bones(
        [p if own == side else -1 for p, own in zip(layout.parents, owners, strict=True)], pose
    )


def curves_figure(
    x, curves: Mapping[str, Sequence[float]], x_title: str, y_title: str, *, title: str = "",
    marks: Mapping[str, float] | None = None, dots: bool = False
) -> go.Figure:
    """Curves over the same ``x``, a colour each; ``marks`` are vertical lines, name -> x."""
    figure = go.Figure()
    for k, (name, y) in enumerate(curves.items()):
        figure.add_scatter(
            x=np.asarray(x), y=np.asarray(y), name=escape(name),
            mode="lines+markers" if dots else "lines",
            line={"color": WHEEL[k % len(WHEEL)], "width": 2.5}, marker={"size": 6}
        )
    for name, place in (marks or {}).items():
        figure.add_vline(
            x=place, line={"color": QUIET, "dash": "dot", "width": 1}, annotation_text=escape(name),
            annotation_font_size=11
        )
    return finish(figure, title, 400, {"title": x_title}, {"title": y_title})


def graph_figure(graph, place: Tensor) -> Figure:
    """The levels of a `toolkit.stylization.SkeletonGraph`, a panel each.

    ``place [2, N]`` are x and y of its joints.
    """
    levels = len(graph.sizes)
    figure = Picture(figsize=(2.9 * levels, 3.4), dpi=80, layout="constrained")
    for level, axes in enumerate(figure.subplots(1, levels, sharex=True, sharey=True)):
        for node, parent in enumerate(graph.parents[level][1:], 1):
            axes.plot(
                -place[0, [node, parent]], place[1, [node, parent]], color="#c9ccd1", linewidth=3
            )
        axes.plot(-place[0], place[1], "o", color=WHEEL[level])
        axes.set(
            title=f"{graph.sizes[level]} nodes", xlabel="metres", aspect="equal", xticks=(-0.3, 0.3)
        )
        place = place @ graph.pool(level) if level < levels - 1 else place
    figure.supylabel("height, metres")
    return figure


def cycles_figure(clips: Mapping[str, Clip]) -> Figure:
    """Two steps of each walk, from a landing of the right foot, so that columns show one phase."""
    return strip([_cycle(clip) for clip in clips.values()], labels=list(clips))


def _cycle(clip: Clip) -> Clip:
    length = periodicity(clip)[1] or len(clip) - 1
    on = contacts.detect(clip)[: len(clip) - length, 0] > 0.5
    landings = (on[1:] & ~on[:-1]).nonzero()[:, 0].tolist() or [0]
    begin = landings[len(landings) // 2]
    return clip.cut(begin, begin + length + 1)
