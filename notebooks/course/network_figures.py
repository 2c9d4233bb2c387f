"""Figures of the notebooks on the network and its training."""

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd
import plotly.graph_objects as go
import torch
from course.pages import SYMBOLS
from plotly.subplots import make_subplots
from torch import Tensor

from toolkit.view.charts import bones, colours, finish, slider
from toolkit.view.render.mannequin import COLORS, PALETTE

STYLE, OUTPUT = SYMBOLS["γ, β"][0], SYMBOLS["z"][0]


def poses(
    parents: Sequence[int], plain: Tensor, sliders: Mapping[str, Mapping[str, Tensor]], title: str,
    colour: str = OUTPUT
) -> go.Figure:
    """One pose in grey, and another that sliders choose, from the side and from the front.

    Parameters
    ----------
    parents
        Of the J joints.
    plain
        The pose that stays, [J, 3] metres in the root frame.
    sliders
        Name of a slider -> {label: pose [J, 3]}. A slider shows its own poses, from its first.
    title, colour
        The heading, and the colour of the pose that changes.
    """
    figure = make_subplots(
        1, 2, subplot_titles=["from the right side, metres", "from the front, metres"]
    )
    first = next(iter(next(iter(sliders.values())).values()))
    for pose, line in (
        (plain, {"color": "#c9ccd1", "width": 9}),
        (first, {"color": colour, "width": 4}),
    ):
        for column, lines in enumerate(_both(parents, pose), 1):
            figure.add_scatter(**lines, mode="lines", line=line, row=1, col=column)
    frames, controls, rows = [], [], len(sliders)
    for k, (name, steps) in enumerate(sliders.items()):
        frames += [go.Frame(data=_both(parents, pose), traces=[2, 3], name=f"{k}-{i}")
                   for i, pose in enumerate(steps.values())]
        controls.append(slider(list(steps), f"{name}: ", frames=f"{k}-", row=k))
    figure.frames = frames
    every = torch.cat([plain, *(pose for steps in sliders.values() for pose in steps.values())])
    low, high = float(every[:, 1].min()) - 0.1, float(every[:, 1].max()) + 0.1
    figure.update_yaxes(range=[low, high], row=1, col=1).update_yaxes(
        range=[low, high], scaleanchor="x2", row=1, col=2
    )
    figure.update_yaxes(scaleanchor="x", row=1, col=1)
    figure.update_xaxes(range=[-1, 1])
    return finish(
        figure, title, 400 + 92 * rows, {}, {}, showlegend=False, margin_t=84,
        margin_b=60 + 92 * rows, sliders=controls
    )


def gates(seconds: Tensor, alpha: Tensor, stands: Tensor, title: str) -> go.Figure:
    """Shares of the experts [F, K] over time, stacked, and below them the contacts [F, 2] (right,
    left).
    """
    figure = make_subplots(2, 1, shared_xaxes=True, row_heights=[5, 1], vertical_spacing=0.05)
    for k, colour in enumerate(colours(alpha.shape[1])):
        figure.add_scatter(
            x=seconds.numpy(), y=alpha[:, k].numpy(), stackgroup="one", name=f"expert {k + 1}",
            mode="none", fillcolor=colour, row=1, col=1
        )
    for i, foot in enumerate(("right", "left")):
        figure.add_scatter(
            x=seconds.numpy(), y=np.where(stands[:, i].numpy() > 0.5, foot, None), mode="lines",
            name=f"{foot} foot stands", line={"color": COLORS[foot], "width": 12}, row=2, col=1
        )
    figure.update_yaxes(title="share α", range=[0, 1], row=1, col=1).update_xaxes(
        title="seconds", row=2, col=1
    )
    return finish(figure, title, 440, {}, {})


def blend_of_lines(weights: Sequence[float], biases: Sequence[float], steps: int = 21) -> go.Figure:
    """Two experts that are straight lines, and their blend.

    A slider moves the share of the second expert.
    """
    x = np.linspace(-1, 1, 2)
    figure = go.Figure()
    for k, colour in ((0, PALETTE[0]), (1, PALETTE[1])):
        figure.add_scatter(
            x=x, y=weights[k] * x + biases[k], name=f"expert {k + 1}",
            line={"color": colour, "width": 3}
        )
    shares = np.linspace(0, 1, steps)
    curves = [
        ((1 - a) * weights[0] + a * weights[1]) * x + (1 - a) * biases[0] + a * biases[1]
        for a in shares
    ]
    figure.add_scatter(
        x=x, y=curves[steps // 2], name="blend", line={"color": SYMBOLS["α"][0], "width": 6}
    )
    figure.frames = [
        go.Frame(data=[{"x": x, "y": y}], traces=[2], name=str(k)) for k, y in enumerate(curves)
    ]
    return finish(
        figure, "Two experts of one number each", 400, {"title": "x"},
        {"title": "W x + b", "range": [-2, 2]},
        sliders=[slider([f"{a:.2f}" for a in shares], "share of expert 2: ", steps // 2)]
    )


def modulation(values: Tensor, steps: int = 21) -> go.Figure:
    """Units of a hidden layer after normalisation, scale γ and shift β, before and after ELU, with
    a slider for each.
    """
    order = values.sort().values.numpy()
    figure = make_subplots(
        1, 2, subplot_titles=["γ LN(F) + β, units in order", "h = ELU(γ LN(F) + β), units in order"]
    )
    units = np.arange(len(order))
    for column, shown in enumerate((order, _elu(order)), 1):
        figure.add_scatter(
            x=units, y=shown, line={"color": "#c9ccd1", "width": 6}, row=1, col=column
        )
        figure.add_scatter(x=units, y=shown, line={"color": STYLE, "width": 3}, row=1, col=column)
    frames, controls = [], []
    for k, (name, reach) in enumerate(
        (("γ", np.linspace(0, 2, steps)), ("β", np.linspace(-2, 2, steps)))
    ):
        curves = [order * v if name == "γ" else order + v for v in reach]
        frames += [
            go.Frame(
                data=[{"x": units, "y": y}, {"x": units, "y": _elu(y)}], traces=[1, 3],
                name=f"{name}{i}"
            )
            for i, y in enumerate(curves)
        ]
        controls.append(
            slider([f"{v:.1f}" for v in reach], f"{name} = ", steps // 2, frames=name, row=k)
        )
    figure.frames = frames
    figure.update_yaxes(range=[-6.5, 6.5])
    return finish(
        figure, "One hidden layer under a style", 560, {}, {}, showlegend=False, margin_t=84,
        margin_b=240, sliders=controls
    )


def baselines(table: pd.DataFrame) -> go.Figure:
    """Errors of the network and of predictions without training, a group of bars for each row,
    logarithmic.
    """
    figure = go.Figure()
    for column, label, colour in (
        ("mean", "predict the mean", "#9aa1ab"),
        ("repeat", "repeat the frame", PALETTE[2]),
        ("error", "network", PALETTE[0]),
    ):
        figure.add_bar(
            y=list(table.index), x=table[column], name=label, orientation="h",
            marker={"color": colour}
        )
    return finish(
        figure, "Error on held-out frames (shorter is better)", 160 + 60 * len(table),
        {"type": "log", "dtick": "D2", "title": "mean squared error, normalised units"},
        {"autorange": "reversed"}
    )


def confusions(tables: Mapping[str, Tensor], styles: Sequence[str]) -> go.Figure:
    """Error of frames (rows) with the style vectors of all styles (columns).

    A panel for each model.
    """
    figure = make_subplots(
        1, len(tables), subplot_titles=list(tables), shared_yaxes=True, horizontal_spacing=0.04
    )
    for column, table in enumerate(tables.values(), 1):
        text = [[f"{v:.2f}" for v in row] for row in table.tolist()]
        figure.add_heatmap(
            z=table.log().numpy(), x=list(styles), y=list(styles), text=text,
            texttemplate="%{text}", zmin=-4, zmax=1, colorscale="Magma_r", showscale=False, row=1,
            col=column, hovertemplate="frames of %{y}, vector of %{x}: %{text}<extra></extra>"
        )
        figure.update_xaxes(title="style vector", row=1, col=column)
    figure.update_yaxes(title="frames of", autorange="reversed", row=1, col=1)
    figure.update_yaxes(autorange="reversed")
    return finish(
        figure, "Error with a right and with a wrong style vector", 470, {}, {}, margin_t=84
    )


def _both(parents: Sequence[int], pose: Tensor) -> list[dict]:
    """Bones from the side (ahead, up) and from the front (left, up).

    To the left is on the right, as one meets a person.
    """
    return [bones(parents, pose, axes) for axes in ((2, 1), (0, 1))]


def _elu(values: np.ndarray) -> np.ndarray:
    return np.where(values > 0, values, np.expm1(np.minimum(values, 0)))
