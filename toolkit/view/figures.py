"""Charts by plotly: phases, the space of styles, training, trajectories. Everything takes plain tensors or arrays."""

from collections.abc import Mapping, Sequence

import numpy as np
import plotly.graph_objects as go
from plotly.subplots import make_subplots

from toolkit.motion import Clip
from toolkit.view.body import COLORS, CONTACT, PALETTE

LIMBS = ("left hand", "right hand", "left foot", "right foot")
INK, QUIET, GRID = "#2b323b", "#8a8f98", "#e4e0d8"
HUES = [[0.0, "#7b68c4"], [0.25, "#2fa596"], [0.5, "#e3c15a"], [0.75, "#d6598b"], [1.0, "#7b68c4"]]  # 0 and 2 pi alike
LAYOUT = {
    "template": "plotly_white", "font": {"family": "system-ui, sans-serif", "size": 13, "color": INK},
    "paper_bgcolor": "#fbfaf7", "plot_bgcolor": "#fbfaf7", "margin": {"l": 60, "r": 20, "t": 48, "b": 44},
    "hovermode": "closest",
}  # fmt: skip


def phase_figure(clip: Clip, phases, contacts=None, *, start: float = 0.0, stop: float | None = None,
                 title: str = "") -> go.Figure:  # fmt: skip
    """Local phases of the four limbs over time, after Figure 4 of Mason et al. 2022.

    For each limb: the source curve (grey), the sinusoid fitted around every frame (colour), contacts of the feet (green
    bars), and a band whose colour is the phase and whose height is the length of the phase vector, on one scale for all
    limbs, so that a limb that hardly moves has a thin band.

    Parameters
    ----------
    clip
        The motion, F frames.
    phases
        Has ``source``, ``fit``, ``phase`` (radians), ``frequency`` (Hz) and ``amplitude``, each [F, 4], and ``vector``
        [F, 4, 2]; limbs in the order of `LIMBS`.
    contacts
        Foot contacts [F, 2] (right, left), above one half where a foot stands.
    start, stop
        Seconds that are shown.
    title
        Heading.

    Raises
    ------
    ValueError
        If lengths differ or there is nothing between ``start`` and ``stop``.
    """
    fields = {name: _array(getattr(phases, name)) for name in ("source", "fit", "phase", "frequency", "amplitude", "vector")}
    bad = {name: a.shape for name, a in fields.items() if a.shape[:2] != (len(clip), 4)}
    con = None if contacts is None else _array(contacts) > 0.5
    if bad or (con is not None and con.shape != (len(clip), 2)):
        raise ValueError(f"phases must be [{len(clip)}, 4] and contacts [{len(clip)}, 2]; got "
                         f"{bad or con.shape}")  # fmt: skip
    first = round(start * clip.fps)
    last = len(clip) if stop is None else min(round(stop * clip.fps), len(clip))
    if not 0 <= first < last:
        raise ValueError(f"no frame between {start} s and {stop} s; the clip lasts {clip.seconds:.2f} s")
    show = slice(first, last)
    seconds = np.arange(len(clip))[show] / clip.fps
    magnitude = np.linalg.norm(fields["vector"], axis=-1)
    figure = make_subplots(8, 1, shared_xaxes=True, row_heights=[3, 1] * 4, vertical_spacing=0.012)
    for i, limb in enumerate(LIMBS):
        side, row = limb.split()[0], 2 * i + 1
        hover = np.stack([fields[k][show, i] for k in ("phase", "frequency", "amplitude")], -1)
        figure.add_scatter(x=seconds, y=fields["source"][show, i], name="source", legendgroup="source", showlegend=i == 0,
                           line={"color": QUIET, "width": 1.5}, row=row, col=1)  # fmt: skip
        figure.add_scatter(x=seconds, y=fields["fit"][show, i], name=f"fit, {side}", legendgroup=side, showlegend=i < 2,
                           line={"color": COLORS[side], "width": 2.5}, customdata=hover, row=row, col=1,
                           hovertemplate="%{x:.2f} s: phase %{customdata[0]:.2f} rad, "
                           "%{customdata[1]:.2f} Hz, amplitude %{customdata[2]:.2f}<extra></extra>")  # fmt: skip
        if con is not None and i >= 2:
            low = float(np.nanmin(fields["source"][show, i])) - 0.25
            stands = np.where(con[show, 1 if side == "left" else 0], low, np.nan)
            figure.add_scatter(x=seconds, y=stands, name="contact", legendgroup="contact", showlegend=i == 2, mode="lines",
                               line={"color": CONTACT, "width": 6}, hoverinfo="skip", row=row, col=1)  # fmt: skip
        figure.add_bar(x=seconds, y=magnitude[show, i], name=f"phase, {limb}", showlegend=False, width=1.02 / clip.fps,
                       marker={"color": fields["phase"][show, i], "colorscale": HUES, "cmin": 0, "cmax": 2 * np.pi,
                               "line": {"width": 0}, "showscale": i == 0,
                               "colorbar": {"title": "phase", "len": 0.35, "y": 0.18, "thickness": 12,
                                            "tickvals": [0, np.pi, 2 * np.pi], "ticktext": ["0", "π", "2π"]}},
                       hovertemplate="%{x:.2f} s: |vector| %{y:.2f}, phase %{marker.color:.2f}<extra></extra>",
                       row=row + 1, col=1)  # fmt: skip
        figure.update_yaxes(title=limb, showticklabels=False, row=row, col=1)
        figure.update_yaxes(showticklabels=False, range=[0, max(1.05 * float(magnitude[show].max()), 1e-6)], row=row + 1,
                            col=1)  # fmt: skip
    figure.update_xaxes(title="seconds", row=8, col=1)
    figure.update_xaxes(gridcolor=GRID)
    figure.update_yaxes(gridcolor=GRID, zeroline=False)
    return figure.update_layout(**LAYOUT, title=title or "Local phases", height=760, bargap=0)


def style_space(vectors, names: Sequence[str], labels: Sequence[str] | None = None, *, marked: Mapping | None = None,
                title: str = "Style space") -> go.Figure:  # fmt: skip
    """Styles as points in the plane.

    Parameters
    ----------
    vectors
        Positions [S, 2] (embed wider style vectors first).
    names
        S names, shown on hover, and as text where there are at most forty.
    labels
        S groups: one colour and one entry of the legend each.
    marked
        Further points to stand out, name -> position [2], such as a blend.
    title
        Heading.

    Raises
    ------
    ValueError
        If the numbers of points, names and labels differ.
    """
    points, names = _array(vectors), list(names)
    groups = [""] * len(names) if labels is None else [str(x) for x in labels]
    if points.shape != (len(names), 2) or len(groups) != len(names):
        raise ValueError(f"{len(names)} names need positions [{len(names)}, 2] and as many labels; got "
                         f"{list(points.shape)} and {len(groups)}")  # fmt: skip
    figure = go.Figure()
    for i, group in enumerate(dict.fromkeys(groups)):
        own = [k for k, g in enumerate(groups) if g == group]
        figure.add_scatter(
            x=points[own, 0], y=points[own, 1], text=[names[k] for k in own], name=group or "styles",
            textposition="top center",
            mode="markers+text" if len(names) <= 40 else "markers", textfont={"size": 11}, showlegend=labels is not None,
            marker={"size": 11, "color": PALETTE[i % len(PALETTE)], "line": {"color": "white", "width": 1.5}},
            hovertemplate="<b>%{text}</b><br>" + group + "<extra></extra>",
        )  # fmt: skip
    for name, place in (marked or {}).items():
        x, y = _array(place)
        figure.add_scatter(x=[x], y=[y], text=[name], name=name, mode="markers+text", textposition="bottom center",
                           marker={"size": 16, "color": INK, "symbol": "star"})  # fmt: skip
    figure.update_xaxes(showticklabels=False, gridcolor=GRID, zeroline=False)
    figure.update_yaxes(showticklabels=False, gridcolor=GRID, zeroline=False, scaleanchor="x")
    return figure.update_layout(**LAYOUT, title=title, height=620)


def training_curves(history: Sequence[Mapping] | Mapping[str, Sequence], *, title: str = "Training") -> go.Figure:
    """Errors over training, on a logarithmic axis.

    Parameters
    ----------
    history
        A row per evaluation with ``step`` and numbers such as ``train`` and ``test``, or the same as columns. ``elapsed``
        is shown on hover. Values that are not positive are left out.
    title
        Heading.

    Raises
    ------
    ValueError
        If there are no rows or no ``step``.
    """
    rows = list(history) if not isinstance(history, Mapping) else [
        dict(zip(history, values, strict=True)) for values in zip(*history.values(), strict=True)
    ]  # fmt: skip
    if not rows or any("step" not in row for row in rows):
        raise ValueError(f"a training history needs rows with 'step'; got {len(rows)} rows")
    names = [n for n in dict.fromkeys(k for row in rows for k in row) if n not in ("step", "elapsed", "epoch")]
    figure = go.Figure()
    for i, name in enumerate(names):
        kept = [r for r in rows if isinstance(r.get(name), int | float) and r[name] > 0]
        if kept:
            figure.add_scatter(x=[r["step"] for r in kept], y=[r[name] for r in kept], name=name, mode="lines+markers",
                               customdata=[r.get("elapsed", float("nan")) for r in kept],
                               line={"color": PALETTE[i % len(PALETTE)], "width": 2.5}, marker={"size": 5},
                               hovertemplate=f"{name} %{{y:.4g}} at step %{{x:,}}, %{{customdata:.0f}} s<extra></extra>",
                               )  # fmt: skip
    figure.update_xaxes(title="step", gridcolor=GRID)
    figure.update_yaxes(title="error", type="log", gridcolor=GRID)
    return figure.update_layout(**LAYOUT, title=title, height=420)


def trajectory_figure(clips: Clip | Sequence[Clip], target=None, *, labels: Sequence[str] | None = None,
                      title: str = "Path of the hips") -> go.Figure:  # fmt: skip
    """Paths over the floor seen from above, a mark each second.

    Parameters
    ----------
    clips
        One motion or several.
    target
        Path that was asked for, [N, 2] (x, z) in metres.
    labels
        Names of the clips.
    title
        Heading.
    """
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    labels = [c.style or c.name for c in clips] if labels is None else list(labels)
    figure = go.Figure()
    if target is not None:
        path = _array(target)
        figure.add_scatter(x=-path[:, 0], y=path[:, 1], name="asked for", mode="lines", hoverinfo="skip",
                           line={"color": QUIET, "width": 8}, opacity=0.35)  # fmt: skip
    for i, (clip, name) in enumerate(zip(clips, labels, strict=True)):
        x, z = -_array(clip.root_positions)[:, 0], _array(clip.root_positions)[:, 2]  # seen from above, +X is on the left
        line = {"color": PALETTE[i % len(PALETTE)], "width": 2.5}
        figure.add_scatter(x=x, y=z, name=name, mode="lines", line=line, customdata=np.arange(len(clip)) / clip.fps,
                           hovertemplate="%{customdata:.2f} s<extra>" + name + "</extra>")  # fmt: skip
        marks = np.unique((np.arange(0, clip.seconds) * clip.fps).round().astype(int).clip(max=len(clip) - 1))
        figure.add_scatter(x=x[marks], y=z[marks], name=f"{name}, each second", mode="markers", showlegend=False,
                           hoverinfo="skip", marker={"size": 7, "color": line["color"]})  # fmt: skip
    figure.update_xaxes(title="metres to the right", gridcolor=GRID)
    figure.update_yaxes(title="metres ahead", scaleanchor="x", gridcolor=GRID)
    return figure.update_layout(**LAYOUT, title=title, height=520)


def _array(values) -> np.ndarray:
    return np.asarray(values.detach().cpu() if hasattr(values, "detach") else values, dtype=np.float64)
