"""Figures of the notebook on blends."""

from collections.abc import Mapping, Sequence

import numpy as np
import plotly.graph_objects as go
from course.charts import finish
from matplotlib.colors import to_hex, to_rgb
from plotly.subplots import make_subplots
from scipy.spatial import Delaunay
from torch import Tensor

from toolkit.view.render.mannequin import PALETTE

LINE = "#d9d4c8"


def mixtures(weights: Tensor) -> list[str]:
    """Colours of blends, weights [N, 3]: mixtures of the first three colours of the palette."""
    corners = np.array([to_rgb(colour) for colour in PALETTE[:3]])
    return [to_hex(rgb) for rgb in (np.asarray(weights) @ corners).clip(0, 1)]


def triangles(
    weights: Tensor, measured: tuple[Tensor, Tensor], names: Sequence[str], axes: tuple[str, str]
) -> go.Figure:
    """Points of a triangle of styles, and beside them what was measured in the walk of each.

    Parameters
    ----------
    weights
        Barycentric weights [N, 3].
    measured, axes
        Two numbers [N] for each walk, and the names of both.
    names
        Of the three styles.
    """
    places = np.asarray(weights) @ np.array([[0.5, 0.87], [1.0, 0.0], [0.0, 0.0]])
    mesh = Delaunay(places).simplices
    figure = make_subplots(1, 2, subplot_titles=["weights", "measured in the walk"])
    for column, (x, y) in enumerate((places.T, np.stack([np.asarray(m) for m in measured])), 1):
        edges = np.concatenate([np.append(t, [t[0], -1]) for t in mesh])
        figure.add_scatter(
            x=np.append(x, np.nan)[edges], y=np.append(y, np.nan)[edges], mode="lines",
            hoverinfo="skip", line={"color": LINE, "width": 1}, row=1, col=column
        )
        corner = {
            int(i): name for i, name in zip(np.asarray(weights).argmax(0), names, strict=True)
        }
        figure.add_scatter(
            x=x,
            y=y,
            mode="markers+text",
            text=[corner.get(i, "") for i in range(len(x))],
            textposition="top center",
            cliponaxis=False,
            marker={"size": 15, "color": mixtures(weights)},
            row=1,
            col=column,
            customdata=100 * np.asarray(weights),
            hovertemplate="<br>".join(
                f"{name} %{{customdata[{k}]:.0f}} %" for k, name in enumerate(names)
            )
            + "<extra></extra>",
        )
    figure.update_xaxes(visible=False, range=[-0.15, 1.15], row=1, col=1).update_yaxes(
        visible=False, row=1, col=1
    )
    figure.update_yaxes(range=[-0.12, 1.02], scaleanchor="x", row=1, col=1)
    figure.update_xaxes(title=axes[0], row=1, col=2).update_yaxes(title=axes[1], row=1, col=2)
    return finish(figure, "A triangle of styles", 480, {}, {}, showlegend=False, margin_t=84)


def footprints(
    path: Tensor, toes: Tensor, stands: Tensor, weights: Tensor, names: Sequence[str]
) -> go.Figure:
    """Toes in contact from above, in the colour of the blend at that moment.

    Parameters
    ----------
    path
        The commanded path, [N, 2] (x, z).
    toes, stands, weights
        Positions [F, 2, 3] of the right and the left toe, contacts [F, 2] and weights [F, 3].
    names
        Of the three styles.
    """
    figure = go.Figure()
    figure.add_scatter(
        x=path[:, 1].numpy(),
        y=path[:, 0].numpy(),
        mode="lines",
        name="commanded path",
        line={"color": "#e4dfd5", "width": 14},
    )
    for i, (foot, symbol) in enumerate((("right", "circle-open"), ("left", "square-open"))):
        on = stands[:, i] > 0.5
        figure.add_scatter(
            x=toes[on, i, 2].numpy(),
            y=toes[on, i, 0].numpy(),
            mode="markers",
            name=f"{foot} foot",
            marker={
                "symbol": symbol, "size": 8, "color": mixtures(weights[on]), "line": {"width": 2}
            },
        )
    for name, colour in zip(names, PALETTE, strict=False):
        figure.add_scatter(
            x=[None], y=[None], mode="markers", name=name, marker={"color": colour, "size": 12}
        )
    return finish(
        figure, "Footprints from above; the colour is the blend", 380, {"title": "z, metres"},
        {"title": "x, metres", "scaleanchor": "x"}
    )


def follows(seconds: Tensor, curves: Mapping[str, tuple[Tensor, Tensor]]) -> go.Figure:
    """For each style the weight (wide, pale) and what was measured (thin), [F] each, in a panel of
    its own.
    """
    figure = make_subplots(
        len(curves), 1, shared_xaxes=True, vertical_spacing=0.08, subplot_titles=list(curves)
    )
    for i, ((weight, measured), colour) in enumerate(
        zip(curves.values(), PALETTE[1:], strict=False), 1
    ):
        for name, curve, line in (("weight", weight, {"color": "#c9ccd1", "width": 9}),
                                  ("measured", measured, {"color": colour, "width": 2.5})):
            figure.add_scatter(
                x=seconds.numpy(), y=curve.numpy(), name=name, line=line, showlegend=i == 1, row=i,
                col=1
            )
    figure.update_xaxes(title="seconds", row=len(curves), col=1).update_yaxes(title="share")
    return finish(figure, "The body follows the weights", 440, {}, {}, margin_t=84)
