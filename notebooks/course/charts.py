"""Charts by plotly: the space of styles, training, trajectories.

Everything takes plain tensors or arrays.
"""

import colorsys
from collections.abc import Mapping, Sequence

import numpy as np
import plotly.graph_objects as go

from toolkit.motion import Clip, on_cpu
from toolkit.view.frontend import escape
from toolkit.view.render.mannequin import PALETTE

INK, QUIET, GRID = "#2b323b", "#8a8f98", "#e4e0d8"
# Of a row of a training history; the other numbers are errors.
TIMES = "step", "elapsed", "processor"
LAYOUT = {
    "template": "plotly_white",
    "font": {"family": "system-ui, sans-serif", "size": 13, "color": INK},
    "paper_bgcolor": "#fbfaf7",
    "plot_bgcolor": "#fbfaf7",
    "margin": {"l": 60, "r": 20, "t": 48, "b": 44},
    "hovermode": "closest",
}


def colours(n: int) -> list[str]:
    """``n`` different colours: those of the palette, then hues that lie far from one another."""
    more = (
        colorsys.hls_to_rgb((0.02 + 0.381966 * k) % 1, 0.32 + 0.12 * (k % 3), 0.55)
        for k in range(n - len(PALETTE))
    )
    return [*PALETTE[:n], *("#" + "".join(f"{round(255 * c):02x}" for c in rgb) for rgb in more)]


def style_space(
    vectors, names: Sequence[str], labels: Sequence[str] | None = None, *,
    marked: Mapping | None = None, title: str = "Style space"
) -> go.Figure:
    """Styles as points in the plane.

    Parameters
    ----------
    vectors
        Positions [S, 2] (embed wider style vectors first).
    names
        S names, shown on hover, and as text where there are at most forty.
    labels
        S groups, with a colour and an entry of the legend each.
    marked, title
        Further points, name -> position [2], shown as stars, such as a blend; the heading.

    Raises
    ------
    ValueError
        If the numbers of points, names and labels differ.
    """
    points, names = _array(vectors), list(names)
    groups = [""] * len(names) if labels is None else [str(x) for x in labels]
    if points.shape != (len(names), 2) or len(groups) != len(names):
        raise ValueError(
            f"{len(names)} names need positions [{len(names)}, 2] and as many labels; got "
            f"{list(points.shape)} and {len(groups)}"
        )
    figure = go.Figure()
    kinds = list(dict.fromkeys(groups))
    for group, colour in zip(kinds, colours(len(kinds)), strict=True):
        own = [k for k, g in enumerate(groups) if g == group]
        figure.add_scatter(
            x=points[own, 0],
            y=points[own, 1],
            text=[escape(names[k]) for k in own],
            name=escape(group) or "styles",
            mode="markers+text" if len(names) <= 40 else "markers",
            textposition="top center",
            textfont={"size": 11},
            marker={"size": 11, "color": colour, "line": {"color": "white", "width": 1.5}},
            showlegend=labels is not None,
            hovertemplate="<b>%{text}</b>"
            + ("<br>%{fullData.name}" if group else "")
            + "<extra></extra>",
        )
    for name, place in (marked or {}).items():
        x, y = _array(place)
        figure.add_scatter(
            x=[x], y=[y], text=[escape(name)], name=escape(name), mode="markers+text",
            textposition="middle right", marker={"size": 16, "color": INK, "symbol": "star"}
        )
    plain = {"showticklabels": False, "zeroline": False}
    return finish(figure, title, 620, plain, plain | {"scaleanchor": "x"})


def training_curves(
    history: Sequence[Mapping], *, title: str = "Training"
) -> go.Figure:
    """Errors over training, on a logarithmic axis.

    Parameters
    ----------
    history, title
        A row per evaluation with ``step`` and numbers such as ``train`` and ``test``.
        ``elapsed`` is shown on hover, ``processor`` (seconds of it) is not. Values that
        are not positive are left out. The heading.

    Raises
    ------
    ValueError
        If there are no rows or no ``step``.
    """
    rows = list(history)
    if not rows or any("step" not in row for row in rows):
        raise ValueError(f"a training history needs rows with 'step'; got {len(rows)} rows")
    names = [n for n in dict.fromkeys(k for row in rows for k in row) if n not in TIMES]
    figure = go.Figure()
    for name, colour in zip(names, colours(len(names)), strict=True):
        kept = [r for r in rows if isinstance(r.get(name), int | float) and r[name] > 0]
        if kept:
            figure.add_scatter(
                x=[r["step"] for r in kept],
                y=[r[name] for r in kept],
                name=escape(name),
                mode="lines+markers",
                marker={"size": 5},
                customdata=[r.get("elapsed", float("nan")) for r in kept],
                line={"color": colour, "width": 2.5},
                hovertemplate="%{fullData.name} %{y:.4g} at step %{x:,}, %{customdata:.0f} "
                              "s<extra></extra>",
            )
    return finish(
        figure, title, 420, {"title": "step"},
        {"title": "loss, its terms, held-out error", "type": "log",
         "tickvals": [base * 10.0**k for k in range(-4, 4) for base in (1, 2, 5)]}
    )


def trajectory_figure(
    clips: Clip | Sequence[Clip], target=None, *, labels: Sequence[str] | None = None,
    title: str = "Path of the hips"
) -> go.Figure:
    """Paths over the floor seen from above, a mark each second.

    Parameters
    ----------
    clips
        One motion or several.
    target
        The path that was asked for, [N, 2] (x, z) in metres.
    labels, title
        Names of the clips, and the heading.
    """
    clips = on_cpu(clips)
    labels = [escape(x) for x in ([c.style or c.name for c in clips] if labels is None else labels)]
    figure = go.Figure()
    if target is not None:
        path = _array(target)
        figure.add_scatter(
            x=-path[:, 0], y=path[:, 1], name="asked for", mode="lines", hoverinfo="skip",
            line={"color": QUIET, "width": 8}, opacity=0.35
        )
    for clip, name, color in zip(clips, labels, colours(len(clips)), strict=True):
        # Seen from above, +X is on the left.
        x, z = -_array(clip.root_positions)[:, 0], _array(clip.root_positions)[:, 2]
        figure.add_scatter(x=x, y=z, name=name, mode="lines", line={"color": color, "width": 2.5},
                           customdata=np.arange(len(clip)) / clip.fps,
                           hovertemplate="%{customdata:.2f} s<extra>%{fullData.name}</extra>")
        marks = np.unique(
            (np.arange(0, clip.seconds) * clip.fps).round().astype(int).clip(max=len(clip) - 1)
        )
        figure.add_scatter(
            x=x[marks], y=z[marks], name=f"{name}, each second", mode="markers", showlegend=False,
            hoverinfo="skip", marker={"size": 7, "color": color}
        )
    return finish(
        figure, title, 520, {"title": "metres to the right"},
        {"title": "metres ahead", "scaleanchor": "x"}
    )


def slider(labels: Sequence[str], prefix: str, start: int = 0) -> dict:
    """A slider of plotly through the frames of a figure, whose names are "0", "1", ….

    It has a label for each place, with ``prefix`` before it, and begins at place ``start``.
    """
    now = {
        "mode": "immediate", "frame": {"duration": 0, "redraw": True},
        "transition": {"duration": 0}
    }
    steps = [
        {"method": "animate", "label": label, "args": [[str(k)], now]}
        for k, label in enumerate(labels)
    ]
    # The last label is centred on the end of the slider.
    pad = {"t": 62, "r": 3 * len(labels[-1])}
    return {"steps": steps, "active": start, "currentvalue": {"prefix": prefix}, "pad": pad}


def bones(parents: Sequence[int], places, axes: Sequence[int] = (0, 1)) -> dict[str, np.ndarray]:
    """All bones as one line with gaps, from places [J, D] of the joints.

    Two or three of the axes as ``x``, ``y``, ``z``.
    """
    place = _array(places)[:, list(axes)]
    gap = np.full((1, place.shape[1]), np.nan)
    line = [
        np.concatenate((place[[parent, j]], gap)) for j, parent in enumerate(parents) if parent >= 0
    ]
    return dict(zip("xyz", np.concatenate(line).T, strict=False))


def finish(
    figure: go.Figure, title: str, height: int, x: Mapping, y: Mapping, **layout
) -> go.Figure:
    """The figure with the layout of all charts.

    ``x`` and ``y`` are further properties of the axes.
    """
    figure.update_xaxes(gridcolor=GRID, **x)
    figure.update_yaxes(gridcolor=GRID, **y)
    return figure.update_layout(**LAYOUT, title=escape(title), height=height, **layout)


def _array(values) -> np.ndarray:
    return np.asarray(
        values.detach().cpu() if hasattr(values, "detach") else values, dtype=np.float64
    )
