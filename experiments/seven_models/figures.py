"""Figures of a comparison of models: errors like Figure 10 of Mason et al. 2022, and the failure cases of section 5.1."""

import os
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

from experiments.seven_models.failures import Case
from toolkit.evaluation import metrics
from toolkit.features import Layout
from toolkit.io.files import atomic_write
from toolkit.motion import Clip, root_frames
from toolkit.view.body import PALETTE
from toolkit.view.picture import INK, PAPER, Picture

GRID, QUIET = "#e4e0d8", "#8a8f98"


def errors(table: Mapping) -> Picture:
    """Held-out error of every model (Figure 10): squared error of shared columns, bone lengths; whiskers over the seeds."""
    return bars(table, {"shared": ("mean squared error", 1), "bone": ("bone length error, mm", 1000)})


def closed_loop(table: Mapping) -> Picture:
    """Measures in closed loop of every model: range of the hands, recognised styles, foot skate and path."""
    return bars(table, {"hands": ("hands: range / data's", 1), "recognised": ("styles recognised", 1),
                        "skate": ("foot skate, cm/s", 100), "path": ("from the path, cm", 100)})


def bars(table: Mapping, measures: Mapping[str, tuple[str, float]]) -> Picture:
    """A panel per measure ``{key: (title, scale)}`` of a comparison's table, with a bar per model."""
    figure, axes = _panels(len(measures), height=0.38 * len(table["models"]) + 1.2)
    names = list(table["models"])
    for axis, (key, (title, scale)) in zip(axes, measures.items(), strict=True):
        mean, spread = ([scale * table["models"][n][part][key] for n in names] for part in ("mean", "spread"))
        axis.barh(names, mean, xerr=spread, color=[_colour(n) for n in names], ecolor=INK, error_kw={"lw": 1.2})
        axis.invert_yaxis()
        axis.set_title(title, loc="left", size=10, color=INK)
        axis.grid(axis="y", visible=False)
        if axis is not axes[0]:
            axis.set_yticklabels([])
    return figure


def capacity(case: Case) -> Picture:
    """Error of the same styles as a function of the number of styles in a model."""
    figure, (axis,) = _panels(1, width=6.5, height=3.6)
    counts = case.drawn["counts"]
    for name, row in case.rows.items():
        axis.plot(counts, list(row.values()), "o-", color=_colour(name), lw=2.2, label=name)
    axis.set_xscale("log", base=2)
    axis.set_xticks(counts, [str(n) for n in counts])
    axis.set_xlabel("styles in the model", color=INK)
    axis.set_ylabel("held-out error of the same four", color=INK)
    axis.legend(frameon=False)
    return figure


def interpolation(case: Case) -> Picture:
    """Odds of the second style and position of the gait as functions of the blend: a thin line per pair, a thick mean."""
    curves = case.drawn["models"] | {"data, blended": case.drawn["data"]}
    figure, axes = _panels(2, width=10.0, height=4.0)
    titles = {"odds": "recogniser's odds of the second style", "gait": "position of the gait between both styles"}
    for axis, (kind, title) in zip(axes, titles.items(), strict=True):
        axis.plot((0, 1), (0, 1), color=GRID, lw=6, zorder=0)
        for name, found in curves.items():
            lines = getattr(found, kind)[found.recognised]
            for line in lines:
                axis.plot(case.drawn["shares"], line, color=_colour(name), lw=0.7, alpha=0.35)
            if len(lines):
                axis.plot(case.drawn["shares"], lines.mean(0), color=_colour(name), lw=2.6, label=name)
        axis.set(ylim=(-0.3, 1.3), xlabel="weight of the second style")
        axis.set_title(title, loc="left", size=10, color=INK)
    axes[0].legend(frameon=False, fontsize=9)
    return figure


def hands(clips: Mapping[str, Clip], seconds: float = 3.0) -> Picture:
    """Forward positions of both hands relative to the hips over time (compare Figures 5 and 9), a panel per clip."""
    figure, axes = _panels(len(clips), height=2.8)
    for axis, (name, clip) in zip(axes, clips.items(), strict=True):
        part = clip.cut(0, round(seconds * clip.fps))
        joints = list(part.skeleton.feature_joints)
        local = root_frames(part).to_local(part.global_positions[:, joints])
        swing = float(metrics.hand_swing(Layout(part.skeleton), local)["together"])
        for side, colour in (("left", PALETTE[4]), ("right", PALETTE[3])):
            hand = local[:, joints.index(part.skeleton.index(f"{side}_hand")), 2]
            axis.plot(np.arange(len(hand)) / part.fps, hand, color=colour, lw=2, label=f"{side} hand")
        axis.set_title(f"{name}: {clip.style}, correlation {swing:+.2f}", loc="left", size=10, color=INK)
        axis.set_xlabel("seconds", color=INK)
        axis.sharey(axes[0])
    axes[0].set_ylabel("metres ahead", color=INK)
    axes[0].legend(frameon=False, fontsize=9)
    return figure


def save(figure: Picture, path: str | os.PathLike) -> None:
    """Write a PNG file."""
    with atomic_write(path) as file:
        figure.savefig(file, format="png", dpi=figure.dpi, facecolor=PAPER)


def _colour(name: str) -> str:
    """Colour of a modulation; paler for PFNN and MANN, grey for data."""
    colours = {"film": PALETTE[0], "onehot": PALETTE[2], "resad": PALETTE[1]}
    synthesis, _, style = name.partition("-")
    return colours.get(style, QUIET) + {"pfnn": "88", "mann": "bb"}.get(synthesis, "")


def _panels(count: int, width: float = 12.0, height: float = 3.4) -> tuple[Picture, Sequence]:
    figure = Picture(figsize=(width, height), dpi=110, facecolor=PAPER, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(1, count, squeeze=False)[0]
    for axis in axes:
        axis.set_facecolor(PAPER)
        axis.grid(color=GRID, lw=0.8)
        axis.set_axisbelow(True)
        axis.tick_params(colors=INK, labelsize=9, length=0)
        for spine in axis.spines.values():
            spine.set_visible(False)
    return figure, axes
