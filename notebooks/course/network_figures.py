"""Figures of the notebooks on the network and its training."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pandas as pd
import plotly.graph_objects as go
import torch
from course.charts import bones, colours, finish, slider
from course.pages import SYMBOLS, Page, show
from plotly.subplots import make_subplots
from torch import Tensor

from toolkit.view.render.mannequin import COLORS, PALETTE

OUTPUT = SYMBOLS["z"][0]
GREY = {"color": "#c9ccd1", "width": 9}


def poses(
    parents: Sequence[int], plain: Tensor, steps: Mapping[str, Tensor], title: str,
    colour: str = OUTPUT
) -> go.Figure:
    """One pose in grey, and another that a slider chooses, from the side and from the front.

    Parameters
    ----------
    parents
        Of the J joints.
    plain
        The pose that stays, [J, 3] metres in the root frame.
    steps
        Label -> pose [J, 3] of the slider, which begins with the first.
    title, colour
        The heading, and the colour of the pose that changes.
    """
    views = {"from the right side, metres": (2, 1), "from the front, metres": (0, 1)}
    figure = make_subplots(1, 2, subplot_titles=list(views))
    for pose, line in ((plain, GREY), (next(iter(steps.values())), {"color": colour, "width": 4})):
        for column, axes in enumerate(views.values(), 1):
            figure.add_scatter(
                **bones(parents, pose, axes), mode="lines", line=line, row=1, col=column
            )
    figure.frames = [
        go.Frame(data=[bones(parents, pose, axes) for axes in views.values()], traces=[2, 3],
                 name=str(k))
        for k, pose in enumerate(steps.values())
    ]
    heights = torch.stack([plain, *steps.values()])[..., 1]
    low, high = float(heights.min()) - 0.1, float(heights.max()) + 0.1
    for column, axis in enumerate(("x", "x2"), 1):
        figure.update_yaxes(range=[low, high], scaleanchor=axis, row=1, col=column)
    figure.update_xaxes(range=[-1, 1])
    return finish(
        figure, title, 500, {}, {}, showlegend=False, margin_t=84,
        sliders=[slider(list(steps), "")]
    )


def seven() -> Page:
    """The seven models of Table 2: a row for each synthesis network, a column for each modulation.

    Above the three layers is what blends their experts; in violet what the style does.
    """
    gates = {"PFNN": "one phase φ → spline", "MANN": "velocities → Ω", "LPN": "phases p → Ω"}
    kinds = {"one-hot": ("+ Σ αs", ""), "adapter": ("", "+ h A + b"),
             "FiLM": ("γ LN + β",) * 2}
    drawn = []
    for row, (network, gate) in enumerate(gates.items()):
        for column, (kind, marks) in enumerate(kinds.items()):
            if network == "MANN" and kind != "FiLM":
                continue
            if (network, kind) == ("PFNN", "adapter"):
                marks = "", "+ h V diag(Σ αc) U + b"
            x, y = 20 + 300 * column, 30 + 130 * row
            parts = [f'<text x="{x}" y="{y}" font-weight="600">{network} {kind}</text>',
                     f'<text x="{x + 60}" y="{y + 22}" fill="{SYMBOLS["α"][0]}">{gate} → α</text>',
                     f'<text x="{x}" y="{y + 57}">x →</text>',
                     f'<text x="{x + 245}" y="{y + 57}">→ z</text>']
            for layer, mark in enumerate((*marks, "")):
                at = x + 35 + 70 * layer
                parts.append(f'<rect x="{at}" y="{y + 34}" width="62" height="36" rx="6" '
                             f'fill="white" stroke="{SYMBOLS["α"][0]}"/>'
                             f'<text x="{at + 31}" y="{y + 57}" '
                             f'text-anchor="middle">F{"₁₂₃"[layer]}</text>')
                if mark:
                    parts.append(f'<text x="{at + 31}" y="{y + 88}" text-anchor="middle" '
                                 f'fill="{SYMBOLS["γ, β"][0]}">{mark}</text>')
            drawn += parts
    return Page(f'<svg role="img" aria-label="The seven models" viewBox="0 0 920 400" '
                f'style="width: 100%; max-width: 920px; background: #fbfaf7" '
                f'font-family="system-ui, sans-serif" font-size="14" fill="#2b323b" '
                f'xmlns="http://www.w3.org/2000/svg">{"".join(drawn)}</svg>')


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


def modulation(values: Tensor) -> Page:
    """Units of a hidden layer after normalisation, scale γ and shift β, before and after ELU.

    The page computes them, so the two sliders act together.
    """
    page = (Path(__file__).parent / "modulation.html").read_text(encoding="utf-8")
    order = [round(value, 3) for value in values.sort().values.tolist()]
    return show(page.replace("DATA", json.dumps(order)), 400)


def baselines(table: pd.DataFrame) -> go.Figure:
    """Errors of the network and of predictions without training, a group of bars for each row."""
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
        {"title": "mean squared error, normalised units"},
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
        figure, "Mean squared error (no unit) with right and wrong style vectors", 470, {}, {},
        margin_t=84
    )
