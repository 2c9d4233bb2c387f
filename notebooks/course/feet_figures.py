"""A figure of the notebooks on blends and on feet: a toe over time."""

from collections.abc import Mapping

import numpy as np
import plotly.graph_objects as go
from course.charts import GRID, LAYOUT
from course.style_figures import WHEEL
from plotly.subplots import make_subplots

from toolkit.motion import Clip
from toolkit.motion.contacts import velocities
from toolkit.motion.skeleton import FEET
from toolkit.view.frontend import escape
from toolkit.view.render.mannequin import CONTACT

FAST = 80  # cm/s: a swinging toe is faster, a standing one is not


def toe_figure(
    clips: Mapping[str, Clip], contact, *, side: str = "right", start: float = 1.0,
    stop: float = 3.0, title: str = "", stand: float | None = None
) -> go.Figure:
    """Speed (in three dimensions, up to `FAST`) and height of a toe over time, a curve per clip.

    It is green where the foot is in contact; a line is at the height ``stand``, metres, if given.

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
    if stand is not None:
        figure.add_hline(100 * float(stand), row=2, col=1, line={"color": GRID, "dash": "dash"},
                         annotation_text="standing")
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
