"""Figures of the notebooks on phases."""

import math
from collections.abc import Mapping

import numpy as np
import pandas as pd
import plotly.graph_objects as go
import torch
from course.charts import INK, QUIET, bones, colours, finish, slider
from course.pages import SYMBOLS
from plotly.subplots import make_subplots
from torch import Tensor

from toolkit import phases as ph
from toolkit.motion import Clip, root_frames
from toolkit.view.render.mannequin import COLORS

P = SYMBOLS["p"][0]


def cycle(
    clip: Clip, phase: Tensor, first: int, last: int, limb: str = "left_hand", steps: int = 24
) -> go.Figure:
    """The body from its side, a clock with the phase of one limb, and the limb's curve; a slider
    moves the frame.

    Parameters
    ----------
    clip, phase
        The motion and the phase of the limb, [F] radians.
    first, last
        Frames of the slider.
    """
    frames = torch.linspace(first, last, steps).round().long()
    local = root_frames(clip).to_local(clip.global_positions)
    curve = ph.local_positions(clip, limb)[:, 2].numpy()
    figure = make_subplots(
        1, 3, column_widths=[0.3, 0.25, 0.45],
        subplot_titles=["body, m", "phase", f"{limb.replace('_', ' ')} ahead of hips, m"]
    )
    seconds = np.arange(first, last + 1) / clip.fps
    figure.add_scatter(
        x=seconds, y=curve[first : last + 1], line={"color": COLORS["left"]}, row=1, col=3
    )
    ring = np.linspace(0, 2 * math.pi, 60)
    figure.add_scatter(
        x=np.sin(ring), y=np.cos(ring), line={"color": QUIET, "width": 1}, row=1, col=2
    )
    states = [[bones(clip.skeleton.parents, local[f], (2, 1)), _hand(float(phase[f])),
               {"x": [f / clip.fps], "y": [curve[f]]}] for f in frames.tolist()]
    for state, place, line in zip(states[0], (1, 2, 3), (INK, P, P), strict=True):
        figure.add_scatter(
            **state, mode="lines" if place == 1 else "lines+markers",
            line={"color": line, "width": 4}, marker={"size": 12, "color": P}, row=1, col=place
        )
    figure.frames = [
        go.Frame(data=state, traces=[2, 3, 4], name=str(k)) for k, state in enumerate(states)
    ]
    figure.update_xaxes(range=[-0.7, 0.7], row=1, col=1).update_yaxes(
        range=[0, 1.9], scaleanchor="x", row=1, col=1
    )
    figure.update_xaxes(visible=False, row=1, col=2).update_yaxes(
        visible=False, scaleanchor="x2", row=1, col=2
    )
    figure.update_xaxes(title="seconds", row=1, col=3)
    labels = [f"{f / clip.fps:.2f} s" for f in frames.tolist()]
    return finish(
        figure, "Drag the slider through one cycle", 440, {}, {}, showlegend=False, margin_t=84,
        sliders=[slider(labels, "")]
    )


def frequencies(
    t: Tensor, window: Tensor, fits: Mapping[float, tuple[Tensor, float]], best: float
) -> go.Figure:
    """One window with the best sinusoid of the frequency that a slider chooses, and the residual of
    every frequency.

    Parameters
    ----------
    t, window
        Seconds from the frame and the curve, [N] each.
    fits
        Frequency in hertz -> the sinusoid [N] and its residual.
    best
        The frequency of the smallest residual; the slider starts near it.
    """
    figure = make_subplots(
        1, 2, subplot_titles=["The window (grey) and a sinusoid", "Residual, no unit"]
    )
    t, fits = t.numpy(), {f: (wave.numpy(), r) for f, (wave, r) in fits.items()}
    figure.add_scatter(
        x=t, y=window.numpy(), name="curve", line={"color": QUIET, "width": 5}, row=1, col=1
    )
    hertz, residuals = list(fits), [r for _, r in fits.values()]
    figure.add_scatter(
        x=hertz, y=residuals, name="residual", line={"color": INK, "width": 2}, row=1, col=2
    )
    states = [[{"x": t, "y": wave}, {"x": [f], "y": [r]}] for f, (wave, r) in fits.items()]
    start = int(np.abs(np.array(hertz) - best).argmin())
    for column, state in enumerate(states[start], 1):
        figure.add_scatter(
            **state, mode="lines" if column == 1 else "markers", line={"color": P, "width": 3},
            marker={"size": 13, "color": P}, row=1, col=column
        )
    figure.frames = [
        go.Frame(data=state, traces=[2, 3], name=str(k)) for k, state in enumerate(states)
    ]
    figure.update_xaxes(title="seconds from the frame", row=1, col=1).update_xaxes(
        title="f, Hz", row=1, col=2
    )
    figure.update_yaxes(rangemode="tozero", row=1, col=2)
    return finish(figure, "Drag the frequency", 430, {}, {}, showlegend=False, margin_t=84,
                  sliders=[slider([f"{f:.2f} Hz" for f in hertz], "f = ", start)])


def stacked(
    seconds: Tensor, curves: Mapping[str, Tensor], title: str, *, stop: float = 6.0
) -> go.Figure:
    """Curves [F] below one another over the same seconds, each with an axis of its own."""
    figure = make_subplots(len(curves), 1, shared_xaxes=True, vertical_spacing=0.04)
    for i, (name, curve) in enumerate(curves.items(), 1):
        figure.add_scatter(x=seconds.numpy(), y=curve.numpy(), name=name, row=i, col=1,
                           line={"color": P if "phase" in name else COLORS["left"], "width": 2})
        figure.update_yaxes(
            title={"text": name.replace(", ", "<br>"), "font": {"size": 11}}, row=i, col=1
        )
    figure.update_xaxes(range=[1, stop]).update_xaxes(title="seconds", row=len(curves), col=1)
    return finish(figure, title, 120 + 120 * len(curves), {}, {}, showlegend=False)


def bars(table: pd.DataFrame, title: str, axis: str) -> go.Figure:
    """A group of bars for each row, a bar for each column."""
    figure = go.Figure()
    for name, colour in zip(table.columns, colours(len(table.columns)), strict=True):
        figure.add_bar(
            x=[str(x) for x in table.index], y=table[name], name=str(name), marker={"color": colour}
        )
    return finish(figure, title, 400, {}, {"title": axis})


def errors(table: pd.DataFrame, title: str) -> go.Figure:
    """Errors in degrees as a heat map: a row for each clip, a column for each source."""
    figure = go.Figure(
        go.Heatmap(
            z=table.to_numpy(), x=list(table.columns), y=list(table.index), zmin=0, zmax=60,
            colorscale="YlOrRd",
            text=table.round().map(lambda v: "" if np.isnan(v) else f"{v:.0f}"),
            texttemplate="%{text}", hoverongaps=False, colorbar={
                "title": "degrees", "tickvals": [0, 20, 40, 60],
                "ticktext": ["0", "20", "40", "60 and more"]}
        )
    )
    return finish(
        figure, title, 140 + 30 * len(table), {"showgrid": False},
        {"autorange": "reversed", "showgrid": False}
    )


def against(table: pd.DataFrame, measures: list[str], truth: str, kind: str) -> go.Figure:
    """Points of each ``kind`` with a measure on one axis and the ``truth`` on the other.

    A panel for each measure.
    """
    figure = make_subplots(1, len(measures), shared_yaxes=True, horizontal_spacing=0.03)
    kinds = list(table[kind].unique())
    for column, measure in enumerate(measures, 1):
        for name, colour in zip(kinds, colours(len(kinds)), strict=True):
            own = table[table[kind] == name]
            figure.add_scatter(
                x=own[measure], y=own[truth], mode="markers", name=name, text=own["clip"],
                legendgroup=name, marker={"color": colour, "size": 9}, showlegend=column == 1,
                row=1, col=column
            )
        figure.update_xaxes(title=measure, row=1, col=column)
    figure.update_yaxes(title=truth, row=1, col=1)
    return finish(
        figure, "Measures without truth, against the true error of the feet", 400, {}, {}
    )


def ranking(table: pd.Series, own: str) -> go.Figure:
    """The leaderboard: errors in ascending order, with one entry lit."""
    table = table.sort_values()
    figure = go.Figure(
        go.Bar(
            x=table, y=list(table.index), orientation="h", text=[f"{v:.1f}°" for v in table],
            marker={"color": [P if name == own else QUIET for name in table.index]}
        )
    )
    return finish(
        figure, "Leaderboard: mean error in degrees", 120 + 36 * len(table), {"title": "degrees"},
        {"autorange": "reversed"}
    )


def _hand(phase: float) -> dict:
    return {"x": [0, math.sin(phase)], "y": [0, math.cos(phase)]}
