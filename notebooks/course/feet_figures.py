"""Figures of the notebook on feet: a leg that reaches for a target, and a toe over time."""

from collections.abc import Mapping

import numpy as np
import plotly.graph_objects as go
import torch
from course.style_figures import WHEEL
from plotly.subplots import make_subplots

from toolkit.motion import Clip
from toolkit.motion.clip import FEET
from toolkit.motion.contacts import velocities
from toolkit.motion.ik import two_bone
from toolkit.view.charts import GRID, LAYOUT, QUIET, finish, slider
from toolkit.view.frontend import escape
from toolkit.view.render.mannequin import COLORS, CONTACT

# Of the leg, metres.
HIP, KNEE, ANKLE = (
    torch.tensor([x]) for x in ((0.0, 0.0, 0.0), (0.0, -0.43, 0.1), (0.0, -0.8, 0.0))
)

FAST = 80  # cm/s: a swinging toe is faster, a standing one is not


def leg_figure(
    soft: float = 0.05, title: str = "Move the slider: the ankle follows the target"
) -> go.Figure:
    """A leg seen from the side.

    A slider moves the target of the ankle down, past the reach of the leg.
    """
    targets, lines, angles = np.linspace(0.35, 1.0, 27), [], []
    for target in targets:
        middle, end = two_bone(
            HIP, KNEE, ANKLE, torch.tensor([[0.0, -target, 0.05]], dtype=torch.float32), soft=soft
        )
        leg = torch.cat((HIP, middle, end))[:, [2, 1]]
        lines.append(leg.numpy())
        a, b = leg[0] - leg[1], leg[2] - leg[1]
        angles.append(
            float(torch.rad2deg(torch.acos((a @ b / (a.norm() * b.norm())).clamp(-1, 1))))
        )
    figure = make_subplots(1, 2, column_widths=[0.45, 0.55], horizontal_spacing=0.14)
    shown = len(targets) // 2
    figure.add_scatter(
        x=lines[shown][:, 0], y=lines[shown][:, 1], mode="lines+markers", showlegend=False, row=1,
        col=1, line={"color": COLORS["left"], "width": 9},
        marker={"size": 14, "color": COLORS["joint"]}
    )
    figure.add_scatter(
        x=[0.05], y=[-float(targets[shown])], mode="markers", showlegend=False, row=1, col=1,
        marker={"symbol": "x", "size": 13, "color": WHEEL[2]}
    )
    figure.add_scatter(
        x=targets, y=angles, mode="lines", showlegend=False, row=1, col=2,
        line={"color": QUIET, "width": 2}
    )
    figure.add_scatter(
        x=targets[shown : shown + 1], y=angles[shown : shown + 1], mode="markers", showlegend=False,
        row=1, col=2, marker={"size": 14, "color": WHEEL[0]}
    )
    figure.frames = [go.Frame(name=str(k), traces=[0, 1, 3], data=[
        {"type": "scatter", "x": line[:, 0].tolist(), "y": line[:, 1].tolist()},
        {"type": "scatter", "x": [0.05], "y": [-float(target)]},
        {"type": "scatter", "x": [float(target)], "y": [angle]}
    ]) for k, (line, target, angle) in enumerate(zip(lines, targets, angles, strict=True))]
    control = slider([f"{float(v):.2f}" for v in targets], "target, metres below the hip: ", shown)
    finish(figure, title, 520, {}, {}, sliders=[control])
    figure.update_xaxes(range=[-0.5, 0.6], title="metres ahead", row=1, col=1)
    figure.update_yaxes(
        range=[-1.1, 0.15], scaleanchor="x", title="metres above the hip", row=1, col=1
    )
    figure.update_xaxes(title="target, metres below the hip", row=1, col=2)
    figure.update_yaxes(title="angle of the knee, degrees", range=[30, 185], row=1, col=2)
    return figure


def toe_figure(
    clips: Mapping[str, Clip], contact, *, side: str = "right", start: float = 1.0,
    stop: float = 3.0, title: str = ""
) -> go.Figure:
    """Speed (in three dimensions, up to `FAST`) and height of a toe over time, a curve per clip.

    It is green where the foot is in contact.

    ``contact [F, 2]`` are contacts of all clips, right and left, above one half where a foot
    stands; they have the same number of frames.
    """
    figure = make_subplots(2, 1, shared_xaxes=True, vertical_spacing=0.06)
    for k, (name, clip) in enumerate(clips.items()):
        toe = clip.global_positions[:, clip.skeleton.role(f"{side}_toe")]
        speed = velocities(toe, clip.fps).norm(dim=-1)
        show = slice(round(start * clip.fps), round(stop * clip.fps))
        seconds = np.arange(len(clip))[show] / clip.fps
        for row, value in ((1, 100 * speed), (2, 100 * toe[:, 1])):
            figure.add_scatter(
                x=seconds, y=value[show].numpy(), name=escape(name), legendgroup=name,
                showlegend=row == 1, line={"color": WHEEL[k], "width": 2.5}, row=row, col=1
            )
    stands = np.asarray(contact)[:, FEET.index(side)] > 0.5
    fps = next(iter(clips.values())).fps
    edges = (
        np.flatnonzero(np.diff(np.concatenate(([0], stands.astype(int), [0])))).reshape(-1, 2) / fps
    )
    for a, b in edges:
        if b > start and a < stop:
            figure.add_vrect(
                x0=max(a, start), x1=min(b, stop), fillcolor=CONTACT, opacity=0.15, line_width=0
            )
    figure.update_xaxes(gridcolor=GRID, title="seconds", row=2, col=1)
    figure.update_yaxes(gridcolor=GRID, title="speed, cm/s", range=[0, FAST], row=1, col=1)
    figure.update_yaxes(gridcolor=GRID, title="height, cm", row=2, col=1)
    return figure.update_layout(**LAYOUT, title=escape(title), height=460)
