"""Pictures of phases, after Figure 4 of Mason et al.

2022: curves over time, principal axes on the body, the manifold.
"""


import numpy as np
import plotly.graph_objects as go
import torch
from course.charts import INK, LAYOUT, QUIET, colours, finish
from plotly.subplots import make_subplots

from toolkit import phases as ph
from toolkit.evaluation import metrics
from toolkit.motion import Clip, root_frames, rotations as R
from toolkit.view.frontend import escape
from toolkit.view.render import mannequin as body
from toolkit.view.render.mannequin import COLORS, CONTACT

# 0 and 2 pi alike.
HUES = [[0.0, "#7b68c4"], [0.25, "#2fa596"], [0.5, "#e3c15a"], [0.75, "#d6598b"], [1.0, "#7b68c4"]]
AXIS, SIDE = "#7b3fb5", 0.34  # colour of a principal axis, metres along the edge of its plane


def phase_figure(
    clip: Clip, phases: ph.Phases, contacts=None, truth=None, *, start: float = 0.0,
    stop: float | None = None, title: str = ""
) -> go.Figure:
    """Local phases of the four limbs over time.

    For each limb: the source curve (grey), the sinusoid fitted around every frame (colour) with a
    ribbon of its residual, contacts of the feet (green bars), and a band. The band's colour is the
    phase, its height the length of the phase vector on one scale for all limbs, so that a limb that
    hardly moves has a thin band.

    Parameters
    ----------
    clip, phases, contacts
        The motion, its phases (`toolkit.phases.extract`), and contacts [F, 2] (right, left), above
        0.5 where a foot stands.
    truth
        The true phases [F, 4] where they are known, radians. They are drawn as a thin dark line:
        the fit with the true phase in place of its own, without the constant lag between the two.
    start, stop, title
        Seconds that are shown; the heading.

    Raises
    ------
    ValueError
        If lengths differ or there is no frame between ``start`` and ``stop``.
    """
    names = ("source", "fit", "phase", "frequency", "amplitude", "residual", "vector")
    fields = {name: np.asarray(getattr(phases, name), dtype=np.float64) for name in names}
    if truth is not None:
        fields["truth"] = np.asarray(truth, dtype=np.float64)
    if bad := [
        f"{name} {list(a.shape)}" for name, a in fields.items() if a.shape[:2] != (len(clip), 4)
    ]:
        raise ValueError(f"phases must be [{len(clip)}, 4]; got {', '.join(bad)}")
    stands = None if contacts is None else np.asarray(contacts)
    if stands is not None and stands.shape != (len(clip), 2):
        raise ValueError(f"contacts must be [{len(clip)}, 2]; got {list(stands.shape)}")
    first = round(start * clip.fps)
    last = len(clip) if stop is None else min(round(stop * clip.fps), len(clip))
    if not 0 <= first < last:
        raise ValueError(
            f"no frame between {start} s and {stop} s; the clip lasts {clip.seconds:.2f} s"
        )
    show = slice(first, last)
    seconds = np.arange(len(clip))[show] / clip.fps
    magnitude = np.linalg.norm(fields["vector"], axis=-1)[show]
    figure = make_subplots(8, 1, shared_xaxes=True, row_heights=[3, 1] * 4, vertical_spacing=0.012)
    for i, limb in enumerate(ph.LIMBS):
        side, row = limb.split("_")[0], {"row": 2 * i + 1, "col": 1}
        curve, fit, phase, frequency, amplitude, residual = (
            fields[name][show, i] for name in names[:6]
        )

        def draw(y: np.ndarray, name: str, shown: bool, line: dict, row=row, **options) -> None:
            options = {"legendgroup": name} | options | row
            figure.add_scatter(x=seconds, y=y, name=name, showlegend=shown, line=line, **options)

        for edge, fill in ((fit - residual, None), (fit + residual, "tonexty")):
            draw(
                edge, "residual", i == 0 and bool(fill), {"width": 0}, fill=fill,
                fillcolor="rgba(138, 143, 152, 0.22)", mode="lines", hoverinfo="skip"
            )
        draw(curve, "source", i == 0, {"color": QUIET, "width": 1.5})
        draw(
            fit,
            f"fit, {side}",
            i < 2,
            {"color": COLORS[side], "width": 2.5},
            legendgroup=side,
            customdata=np.stack((phase, frequency, amplitude, residual), -1),
            hovertemplate="%{x:.2f} s: phase %{customdata[0]:.2f} rad, %{customdata[1]:.2f} Hz, "
            "amplitude %{customdata[2]:.2f}, residual %{customdata[3]:.2f}<extra></extra>",
        )
        if truth is not None:
            known = torch.as_tensor(truth)[:, i]
            lag = metrics.phase_error(phases.phase[:, i], known)[1]
            draw(
                fit + amplitude * ((known + lag).sin().numpy()[show] - np.sin(phase)), "truth",
                i == 0, {"color": INK, "width": 1, "dash": "dot"}, hoverinfo="skip",
                legendrank=1001
            )
        if stands is not None and i >= 2:
            bar = np.where(
                stands[show, 1 if side == "left" else 0] > 0.5, float(np.nanmin(curve)) - 0.25,
                np.nan
            )
            draw(
                bar, "contact", i == 2, {"color": CONTACT, "width": 6}, mode="lines",
                hoverinfo="skip"
            )
        figure.update_yaxes(title=limb.replace("_", " "), showticklabels=False, **row)
        row = row | {"row": 2 * i + 2}
        scale = {
            "title": "phase", "len": 0.35, "y": 0.18, "thickness": 12,
            "tickvals": [0, np.pi, 2 * np.pi], "ticktext": ["0", "π", "2π"]
        }
        figure.add_bar(
            x=seconds,
            y=magnitude[:, i],
            name=f"phase, {limb}",
            showlegend=False,
            width=1.02 / clip.fps,
            marker={
                "color": phase, "colorscale": HUES, "cmin": 0, "cmax": 2 * np.pi,
                "line": {"width": 0}, "showscale": i == 0, "colorbar": scale
            },
            hovertemplate="%{x:.2f} s: |vector| %{y:.2f} m/s, phase "
                          "%{marker.color:.2f}<extra></extra>",
            **row,
        )
        figure.update_yaxes(
            showticklabels=False, range=[0, max(1.05 * float(magnitude.max()), 1e-6)], **row
        )
    figure.update_xaxes(title="seconds", row=8, col=1)
    return finish(figure, title or "Local phases", 760, {}, {"zeroline": False}, bargap=0)


def principal_axes(
    clip: Clip, source: str | ph.Hybrid | ph.ContactFree = "hybrid", *, second: float | None = None,
    title: str = ""
) -> go.Figure:
    """The body at one moment, and for each limb that is measured contact-free: its path, principal
    axis and plane.

    The path is that of the whole clip in the hips' frame, drawn at the hips of this moment. The
    source is the distance from the plane, positive along the arrow.

    Parameters
    ----------
    clip
        The motion.
    source
        "hybrid" (only the limbs for which it chooses contact-free), "contact-free", "velocity" or
        one of these objects, whose axes are used if it is fitted, and else computed from the clip.
    second
        The moment; by default the middle.
    title
        The heading.

    Raises
    ------
    ValueError
        If the source has no principal axes, or the clip has no such moment.
    """
    source = ph.named(source) if isinstance(source, str) else source
    hybrid = isinstance(source, ph.Hybrid)
    free = source.contact_free if hybrid else source
    if not isinstance(free, ph.ContactFree):
        raise ValueError(
            f"principal axes are those of a contact-free or hybrid source, not of {source!r}"
        )
    axes = (free if free.axes else free.fitted([clip])).axes
    frame = len(clip) // 2 if second is None else round(second * clip.fps)
    if not 0 <= frame < len(clip):
        raise ValueError(f"no frame at {second} s; the clip lasts {clip.seconds:.2f} s")
    hips = clip.skeleton.role("hips")
    turn, place = clip.global_rotations[frame, hips], clip.global_positions[frame, hips]
    parts = []
    # The first is nearly that of the axes.
    for limb, color in zip(ph.LIMBS, colours(5)[1:], strict=True):
        if hybrid and source.choice(clip, limb) != "contact-free":
            continue
        path = R.rotate(turn, ph.local_positions(clip, limb)) + place
        arrow, plane = _arrow_and_plane(
            path.mean(0).numpy(), R.rotate(turn, axes[limb].float()).numpy()
        )
        parts.append((limb.replace("_", " "), color, path.numpy(), arrow, plane))
    mannequin = body.build(clip)
    vertices, _ = mannequin.skin.pose(clip.global_rotations[frame], clip.global_positions[frame])
    i, j, k = mannequin.skin.triangles.T
    figure = go.Figure(
        go.Mesh3d(
            **_xyz(vertices), i=i, j=j, k=k, vertexcolor=mannequin.colors(), name="body",
            hoverinfo="skip", lighting={"ambient": 0.65, "diffuse": 0.5, "specular": 0.1}
        )
    )
    for limb, color, path, arrow, plane in parts:
        first = limb == parts[0][0]
        figure.add_scatter3d(
            **_xyz(path), mode="lines", name=limb, line={"color": color, "width": 5},
            hoverinfo="name"
        )
        figure.add_scatter3d(
            **_xyz(arrow), mode="lines", line={"color": AXIS, "width": 8}, hoverinfo="skip",
            name="principal axis", legendgroup="axis", showlegend=first
        )
        u, v, w = ([c] for c in np.diff(arrow, axis=0)[0] / np.linalg.norm(np.diff(arrow, axis=0)))
        figure.add_cone(
            **_xyz(arrow[1:]), u=u, v=v, w=w, sizemode="absolute", sizeref=0.09, anchor="tail",
            hoverinfo="skip", showscale=False, colorscale=[[0, AXIS], [1, AXIS]],
            lighting={"ambient": 1}
        )
        figure.add_mesh3d(
            **_xyz(plane), i=[0, 0], j=[1, 2], k=[2, 3], color=AXIS, opacity=0.25, hoverinfo="skip",
            name="plane", legendgroup="plane", showlegend=first
        )
    # From the right, in front.
    eye = R.rotate(root_frames(clip).rotations[frame], torch.tensor([-1.5, 0.5, 1.3]))
    camera = {"up": {"x": 0, "y": 1, "z": 0}, "eye": dict(zip("xyz", eye.tolist(), strict=True))}
    hidden = {f"{axis}axis": {"visible": False} for axis in "xyz"}
    return figure.update_layout(
        **LAYOUT, title=escape(title or f"Principal axes, {clip.style} {clip.gait}"), height=620,
        scene={"aspectmode": "data", "camera": camera} | hidden
    )


def _arrow_and_plane(centre: np.ndarray, axis: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Both ends of an arrow [2, 3] from the plane's middle along ``axis``, and the corners [4, 3]
    of the plane.
    """
    across = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    across = across / np.linalg.norm(across)
    other = np.cross(axis, across)
    corners = [
        centre + SIDE / 2 * (a * across + b * other)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    return np.stack((centre, centre + 0.8 * SIDE * axis)), np.stack(corners)


def _xyz(points: np.ndarray) -> dict[str, np.ndarray]:
    return dict(zip("xyz", points.T, strict=True))
