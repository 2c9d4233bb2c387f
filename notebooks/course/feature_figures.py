"""Figures of the notebook on features."""

import math
from collections.abc import Mapping

import numpy as np
import plotly.graph_objects as go
import torch
from course.charts import INK, QUIET, bones, finish, slider
from course.pages import SYMBOLS
from plotly.subplots import make_subplots
from torch import Tensor

from toolkit import features
from toolkit.features import Layout
from toolkit.motion import Clip, Skeleton, local_rotations
from toolkit.motion.trajectory import SAMPLES
from toolkit.view.render.mannequin import COLORS, CONTACT, PALETTE

X, Z = SYMBOLS["x"][0], SYMBOLS["z"][0]
ARROW = {"symbol": "arrow", "angleref": "previous", "size": 11, "standoff": 0}
# Seen from above, +X is on the left.
LEFT = {"title": "metres to the left", "autorange": "reversed"}


def carried(clip: Clip, frame: int, positions: int = 24) -> go.Figure:
    """The character carried over the floor by a slider, with the numbers of **x** and the world
    positions as bars.

    Parameters
    ----------
    clip, frame
        The motion and the frame; a window of a second on either side of it must lie inside.
    positions
        Places on a circle, in each of which all numbers are computed again.
    """
    clip = clip.cut(frame - 60, frame + 61)
    figure = make_subplots(
        2,
        2,
        specs=[[{"type": "scene", "rowspan": 2}, {}], [None, {}]],
        column_widths=[0.42, 0.58],
        subplot_titles=[
            "", "x: trajectory and joints, m, m/s or no unit", "World positions of the joints, m"
        ],
        vertical_spacing=0.17,
    )
    states = []
    for k in range(positions):
        angle = 2 * math.pi * k / positions
        there = clip.moved(turn=angle, shift=(1.6 * math.sin(angle), 0.0, 1.6 * math.cos(angle)))
        there = there.moved(
            shift=(-clip.root_positions[60] * torch.tensor([1.0, 0.0, 1.0])).tolist()
        )
        x = features.frames(there).inputs[0].numpy()  # of frame 60
        place = there.global_positions[60]
        body = go.Scatter3d(
            **bones(clip.skeleton.parents, place, (0, 1, 2)), mode="lines", hoverinfo="skip",
            line={"color": INK, "width": 6}
        )
        states.append([body, go.Bar(y=x), go.Bar(y=place.flatten().numpy())])
    for trace, place in zip(states[0], ((1, 1), (1, 2), (2, 2)), strict=True):
        figure.add_trace(trace, *place)
    figure.data[1].marker.color, figure.data[2].marker.color = X, QUIET
    figure.frames = [
        go.Frame(
            data=[state[0], {"y": state[1].y}, {"y": state[2].y}], traces=[0, 1, 2], name=str(k)
        )
        for k, state in enumerate(states)
    ]
    top = max(float(np.abs(state[1].y).max()) for state in states)
    figure.update_yaxes(range=[-top, top], row=1, col=2).update_yaxes(range=[-3, 3], row=2, col=2)
    figure.update_xaxes(title="column", row=2, col=2)
    return finish(
        figure, "Drag the slider: the character moves and turns", 480, {}, {}, scene=_floor(2.4),
        showlegend=False, bargap=0, margin_t=84,
        sliders=[slider([f"{360 * k // positions}°" for k in range(positions)], "carried by ")]
    )


def _floor(reach: float) -> dict:
    """A scene of plotly with Y up.

    A floor of ``reach`` metres around the origin, two metres high.
    """
    box = {"range": [-reach, reach], "title": "", "showticklabels": False, "showbackground": False}
    up = box | {
        "range": [0, 2],
        "showbackground": True,
        "showgrid": False,
        "backgroundcolor": "#f1eee7",
    }
    return {"xaxis": box, "yaxis": up, "zaxis": box, "aspectmode": "manual",
            "aspectratio": {"x": 1.4, "y": 1.4 / reach, "z": 1.4},
            "camera": {"up": {"x": 0, "y": 1, "z": 0}, "eye": {"x": 1, "y": 0.7, "z": 1},
                       "center": {"x": 0, "y": -0.1, "z": 0}}}


def window(positions: Tensor, facings: Tensor) -> go.Figure:
    """The trajectory window from above.

    Positions [12, 2] and facing directions [12, 2] in the root frame.
    """
    figure = go.Figure()
    for name, colour, sign in (
        ("past", COLORS["joint"], -1), ("now", "black", 0), ("future", X, 1)
    ):
        pick = [np.sign(s) == sign for s in SAMPLES]
        own, ahead = positions[pick], facings[pick]
        _arrows(figure, own, own + 0.2 * ahead, name, colour)
        figure.add_scatter(
            x=own[:, 0].numpy(), y=own[:, 1].numpy(), mode="text", showlegend=False,
            textposition="middle right",
            text=[f"   {s / 60:+.2f} s" for s, p in zip(SAMPLES, pick, strict=True) if p]
        )
    return finish(
        figure, "The trajectory window in the root frame", 560, LEFT | {"range": [1.2, -1.2]},
        {"title": "metres ahead", "scaleanchor": "x"}
    )


def row(x: Tensor, layout: Layout) -> go.Figure:
    """One row **x**, drawn from its numbers alone: from the side and from above."""
    trajectory = x[layout.inputs["trajectory"]].view(-1, 4)
    joints = features.split_joints(x[layout.inputs["joints"]])
    place, velocity = joints["position"], joints["velocity"]
    figure = make_subplots(1, 2, subplot_titles=["from the right side", "from above"])
    for column, pick in ((1, [2, 1]), (2, [0, 2])):
        for j, parent in enumerate(layout.parents):
            bone = place[[max(parent, 0), j]][:, pick].numpy()
            figure.add_scatter(
                x=bone[:, 0], y=bone[:, 1], mode="lines+markers", hoverinfo="text",
                text=layout.names[j], line={"color": _tone(layout.names[j]), "width": 3},
                showlegend=False, row=1, col=column
            )
        _arrows(
            figure, place[:, pick], (place + velocity / 8)[:, pick], "movement in ⅛ s", PALETTE[2],
            column == 1, row=1, col=column
        )
    _arrows(
        figure, trajectory[:, :2], trajectory[:, :2] + 0.2 * trajectory[:, 2:], "trajectory window",
        X, row=1, col=2
    )
    figure.update_xaxes(title="metres ahead", row=1, col=1).update_yaxes(
        title="metres", scaleanchor="x", row=1, col=1
    )
    figure.update_xaxes(**LEFT, row=1, col=2).update_yaxes(
        title="metres ahead", scaleanchor="x2", row=1, col=2
    )
    return finish(figure, "One row x", 560, {}, {}, margin_t=84)


def skeleton(known: Skeleton) -> go.Figure:
    """The skeleton from the front with all rotations zero.

    Joints that are not in the features are hollow.
    """
    rest, figure = known.rest_positions.numpy(), go.Figure()
    for j, parent in enumerate(known.parents):
        line = rest[[max(parent, 0), j]]
        figure.add_scatter(
            x=line[:, 0], y=line[:, 1], mode="lines", showlegend=False, hoverinfo="skip",
            line={"color": _tone(known.names[j]), "width": 6}
        )
    roles = {name: role for role, name in known.roles.items()}
    kept = [j in known.feature_joints for j in range(len(known))]
    for name, own in (("in the features", True), ("not in the features", False)):
        at = [j for j in range(len(known)) if kept[j] == own]
        figure.add_scatter(
            x=rest[at, 0],
            y=rest[at, 1],
            mode="markers",
            name=name,
            hoverinfo="text",
            text=[f"{known.names[j]}, {roles.get(known.names[j], 'no role')}" for j in at],
            marker={
                "size": 9, "color": INK if own else "white", "line": {"color": INK, "width": 1.5}
            },
        )
    return finish(
        figure, "From the front; the names are under the pointer", 560,
        {"title": "metres to the left"}, {"title": "metres above the hips", "scaleanchor": "x"}
    )


def simplified(clip: Clip) -> Clip:
    """The clip on a skeleton without collars, upper spine and end sites."""
    known = clip.skeleton
    keep = [j for j, n in enumerate(known.names) if not n.endswith(("Collar", "End"))
            and n not in ("Chest", "Chest2", "Chest3")]
    above = [next((a for a in known.tree.up(j)[1:] if a in keep), 0) for j in keep]
    offsets = known.rest_positions[keep] - known.rest_positions[above]
    parents = [-1] + [keep.index(a) for a in above[1:]]
    simple = Skeleton([known.names[j] for j in keep], parents, offsets)
    local = local_rotations(simple, clip.global_rotations[:, keep])
    return clip.replace(skeleton=simple, rotations=local)


def changes(values: Mapping[str, float]) -> go.Figure:
    """Largest change of each block after the clip was moved, on a logarithmic axis."""
    figure = go.Figure(
        go.Bar(
            x=[max(v, 1e-8) for v in values.values()], y=list(values), orientation="h",
            marker={"color": [{"x": X, "z": Z}.get(name.split()[0], QUIET) for name in values]}
        )
    )
    return finish(
        figure,
        "After the clip was moved and turned",
        420,
        {
            "type": "log", "title": "largest change of a number, in the block's own unit",
            "exponentformat": "power"
        },
        {"autorange": "reversed"},
    )


def paths(curves: Mapping[str, Tensor], title: str) -> go.Figure:
    """Paths over the floor from above, [N, 2] (left, ahead) each.

    The first wide and pale, the others thin.
    """
    figure = go.Figure()
    for i, (name, path) in enumerate(curves.items()):
        line = (
            {"color": "#cfd3da", "width": 10} if i == 0 else {"color": PALETTE[i - 1], "width": 2}
        )
        figure.add_scatter(
            x=path[:, 0].numpy(), y=path[:, 1].numpy(), mode="lines", name=name, line=line
        )
    return finish(figure, title, 480, LEFT, {"title": "metres ahead", "scaleanchor": "x"})


def contacts(
    clip: Clip, stands: Tensor, height: Tensor, speed: Tensor, limits: tuple[float, float]
) -> go.Figure:
    """Height [F] (cm) and speed [F] (m/s) of a toe with their limits, and the frames where it
    stands, [F].
    """
    seconds = np.arange(len(clip)) / clip.fps
    figure = make_subplots(2, 1, shared_xaxes=True, vertical_spacing=0.06)
    for i, (curve, limit, label) in enumerate(
        ((height, limits[0], "height, cm"), (speed, limits[1], "speed, m/s")), 1
    ):
        top = float(curve.max())
        figure.add_scatter(
            x=seconds, y=np.where(stands > 0.5, top, 0), fill="tozeroy", mode="none",
            name="contact", line={"shape": "hv"}, fillcolor="rgba(53, 196, 106, 0.25)",
            showlegend=i == 1, row=i, col=1
        )
        for name, values, line in (
            ("toe", curve.numpy(), {"color": COLORS["left"], "width": 2}),
            ("limit", np.full(len(seconds), limit), {"color": INK, "dash": "dash", "width": 1})
        ):
            figure.add_scatter(
                x=seconds, y=values, name=name, line=line, showlegend=i == 1, row=i, col=1
            )
        figure.update_yaxes(title=label, row=i, col=1)
    figure.update_xaxes(title="seconds", row=2, col=1)
    return finish(figure, "Left toe: low and slow, then a vote of neighbouring frames", 420, {}, {})


def footprints(clip: Clip, stands: Tensor) -> go.Figure:
    """Paths of both toes from above, with a mark where they stand.

    ``stands`` [F, 2] right, left.
    """
    figure = go.Figure()
    for i, foot in enumerate(("right", "left")):
        toe = clip.global_positions[:, clip.skeleton.index(f"{foot}_toe")].numpy()
        figure.add_scatter(x=toe[:, 2], y=toe[:, 0], mode="lines", showlegend=False,
                           line={"color": COLORS[foot], "width": 1})
        held = toe[stands[:, i].numpy() > 0.5]
        figure.add_scatter(
            x=held[:, 2], y=held[:, 0], mode="markers", name=f"{foot} toe in contact",
            marker={"color": COLORS[foot], "size": 9, "line": {"color": CONTACT, "width": 1.5}}
        )
    return finish(
        figure, "Footprints", 320, {"title": "world z, metres"},
        {"title": "world x, metres", "scaleanchor": "x"}
    )


def _arrows(
    figure: go.Figure, start: Tensor, end: Tensor, name: str, colour: str, legend: bool = True,
    **place
) -> None:
    gap = torch.full_like(start[:, :1], math.nan)
    x, y = (torch.stack((start[:, k], end[:, k], gap[:, 0]), 1).flatten().numpy() for k in (0, 1))
    figure.add_scatter(
        x=x, y=y, mode="lines+markers", name=name, marker=ARROW | {"size": [0, 10, 0] * len(start)},
        line={"color": colour, "width": 2}, showlegend=legend, hoverinfo="skip", **place
    )


def _tone(name: str) -> str:
    return COLORS[
        "left" if name.startswith("Left") else "right" if name.startswith("Right") else "joint"
    ]
