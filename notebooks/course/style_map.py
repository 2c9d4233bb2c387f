"""The space of styles as a map.

Hover names a style, click plays it, and a ring dragged between points plays the blend.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path

import ipywidgets as widgets
import plotly.graph_objects as go
import torch
import traitlets
from course.charts import INK, style_space
from course.style_blender import StyleBlender
from plotly.offline import get_plotlyjs
from scipy.spatial import Delaunay, QhullError
from sklearn.manifold import TSNE
from torch import Tensor

from toolkit import runtime
from toolkit.motion import Clip
from toolkit.networks import Predictor
from toolkit.networks.bank import StyleBank
from toolkit.runtime import CharacterState
from toolkit.view.frontend import PageWidget, escape, in_notebook
from toolkit.view.pages.live_page import ordered
from toolkit.view.render.picture import PAPER, Picture

SIDE = 560  # pixels of the map, both ways
SECONDS, SPEED = 2.0, 1.0  # of the walk that is played, metres per second
SETTLE = 0.4  # seconds of walking before, in which the character goes into the style
PERPLEXITY = 30.0  # of t-SNE, about the number of neighbours; at most a third of the points


def explore(
    model: Predictor, bank: StyleBank, *, points: Tensor | None = None,
    groups: Sequence[str] | None = None,
    make_clip: Callable[[dict[str, float]], Clip] | None = None, size: tuple[int, int] = (480, 420)
) -> "StyleExplorer | go.Figure":
    """A map of styles to explore; outside of notebooks, the map alone as a plotly figure.

    Parameters
    ----------
    model, bank
        A model and its styles, three or more.
    points
        Positions of the styles on the map, ``[S, 2]``; by default the t-SNE of their vectors
        (`embed`).
    groups
        S labels, a colour each.
    make_clip, size
        Takes ``{style: weight}`` and returns the motion to play, by default a walk straight ahead;
        pixels of its picture.
    """
    points = embed(bank.vectors) if points is None else torch.as_tensor(points)
    if not in_notebook():
        return chart(bank, points, groups)
    return StyleExplorer(model, bank, points, groups, make_clip=make_clip, size=size)


def embed(vectors: Tensor) -> Tensor:
    """The t-SNE of style vectors (Figure 11): points ``[N, 2]`` of ``vectors [N, D]``, three or
    more, the same in each call. It keeps neighbours together.
    """
    if vectors.dim() != 2 or len(vectors) < 3:
        raise ValueError(f"a map needs three or more vectors [N, D], got {list(vectors.shape)}")
    tsne = TSNE(perplexity=min(PERPLEXITY, (len(vectors) - 1) / 3), init="pca", random_state=0)
    return torch.from_numpy(tsne.fit_transform(vectors.detach().double().cpu().numpy())).float()


def chart(bank: StyleBank, points: Tensor, groups: Sequence[str] | None = None) -> go.Figure:
    """The map as a plotly figure; see `explore`."""
    figure = style_space(points, bank.names, groups, title="Style space")
    return figure.update_layout(
        width=SIDE, height=SIDE, dragmode="pan", margin={"l": 16, "r": 16, "t": 44, "b": 16},
        legend={"orientation": "h", "y": 0.0, "yanchor": "top"}
    )


class StyleMap(PageWidget):
    """A plotly figure with a ring to drag, at ``place`` [x, y] in the figure's units, a trait that
    can be observed and set.

    Plotly's own FigureWidget shows nothing with some versions of anywidget.
    """

    code = traitlets.Unicode(Path(__file__).with_name("map.js").read_text("utf-8")).tag(sync=True)
    plotly = traitlets.Unicode(get_plotlyjs()).tag(sync=True)
    figure = traitlets.Unicode().tag(sync=True)
    place = traitlets.List(traitlets.Float(), [0.0, 0.0], minlen=2, maxlen=2).tag(sync=True)


class StyleExplorer(StyleBlender):
    """The map of `explore` beside a `StyleBlender`, which plays what is chosen.

    A place between styles stands for a blend of three: its barycentric weights in the triangle
    around it, from the Delaunay triangulation of the points. A place outside of all triangles
    stands for the nearest place inside.

    The parameters are those of `explore`. ``map`` is the `StyleMap`; ``weights``, ``player`` and
    ``triangle`` are those of the blender. Assigning weights also moves the ring.

    Raises
    ------
    ValueError
        If there are fewer than three styles, or all lie on one line.
    """

    def __init__(
        self, model: Predictor, bank: StyleBank, points: Tensor,
        groups: Sequence[str] | None = None, *,
        make_clip: Callable[[dict[str, float]], Clip] | None = None,
        size: tuple[int, int] = (480, 420)
    ):
        walk = runtime.straight(SPEED, SETTLE + SECONDS)

        @cache
        def warm() -> tuple[Predictor, CharacterState]:
            """The model, and a character that walks in the first style."""
            quick = runtime.quick(model, len(walk))
            return quick, list(runtime.states(quick, walk[: runtime.FPS], bank.vectors[0]))[-1]

        def play(blend: dict[str, float]) -> Clip:
            quick, first = warm()
            made = runtime.rollout(quick, walk, bank.blend(blend), first=first)
            return made.cut(round(SETTLE * runtime.FPS))

        super().__init__(bank, make_clip or play, weights={ordered(bank)[0]: 1.0}, size=size)
        self.points = torch.as_tensor(points).double()
        try:
            self._triangles = Delaunay(self.points.numpy())
        except (QhullError, ValueError) as error:
            got = list(self.points.shape)
            raise ValueError(
                f"a map needs three styles or more, not on one line; got points {got}"
            ) from error
        self.map = StyleMap(
            figure=chart(bank, self.points, groups).to_json(), place=self._place(),
            layout={"flex": f"0 0 {SIDE}px"}
        )
        self.map.on_msg(self._clicked)
        self.map.observe(self._dragged, "place")
        for widget, trait in (
            (self.triangle, "weights"), *((menu, "value") for menu in self._menus)
        ):
            widget.observe(self._follow, trait)
        self.children = (self.map, widgets.VBox(self.children, layout={"align_items": "center"}))
        self.layout.flex_flow = "row wrap"

    def blend_at(self, x: float, y: float) -> dict[str, float]:
        """The blend at a place on the map: up to three styles, weights that sum to one."""
        place = self.points.new_tensor([x, y])
        triangle = int(self._triangles.find_simplex(place.numpy()))
        if triangle < 0:
            place, triangle = self._inside(place)
        transform = self._triangles.transform[triangle]  # to barycentric coordinates
        first, second = transform[:2] @ (place.numpy() - transform[2])
        shares = [max(0.0, float(w)) for w in (first, second, 1 - first - second)]
        styles = [self._bank.names[i] for i in self._triangles.simplices[triangle]]
        return {name: w / sum(shares) for name, w in zip(styles, shares, strict=True) if w > 1e-6}

    def aim(self, blend: dict[str, float]) -> None:
        """Play a blend of up to three styles, from any thread.

        Of several calls in a row only the newest is played.
        """
        self._set(blend)
        self._changed({})
        self._follow()

    @StyleBlender.weights.setter
    def weights(self, weights: Mapping[str, float]) -> None:
        """Make and show the motion of a blend, and move the ring there."""
        StyleBlender.weights.fset(self, weights)
        self._follow()

    def still(self) -> bytes:
        """A picture of the map, PNG."""
        figure = Picture(figsize=(7, 6), facecolor=PAPER, layout="constrained", dpi=110)
        axes = figure.subplots()
        axes.plot(*self.points.T.numpy(), "o", color="#7b68c4", markersize=5)
        for name, at in zip(self._bank.names, self.points.tolist(), strict=True):
            axes.annotate(
                name, at, (0, 4), textcoords="offset points", fontsize=6, color=INK, ha="center",
                parse_math=False
            )
        axes.set(title="Style space", xticks=[], yticks=[], aspect="equal")
        return figure._repr_png_()

    def _inside(self, place: Tensor) -> tuple[Tensor, int]:
        """The point of the triangulation nearest to a place outside, and its triangle."""
        hull = self._triangles.convex_hull
        a, b = self.points[hull[:, 0]], self.points[hull[:, 1]]
        along = (((place - a) * (b - a)).sum(-1) / (b - a).square().sum(-1)).clamp(0.0, 1.0)
        nearest = a + along[:, None] * (b - a)
        edge = int((nearest - place).norm(dim=-1).argmin())
        ends = set(hull[edge].tolist())
        return nearest[edge], next(
            i for i, t in enumerate(self._triangles.simplices.tolist()) if ends <= set(t)
        )

    def _place(self) -> list[float]:
        return sum(
            share * self.points[self._bank.names.index(name)]
            for name, share in self.weights.items()
        ).tolist()

    def _clicked(self, _widget, message: dict, _buffers) -> None:
        shown = {escape(name): name for name in self._bank.names}
        if message.get("style") in shown:
            self.aim({shown[message["style"]]: 1.0})

    def _dragged(self, change: dict) -> None:
        """The user moved the ring.

        `_follow` moves it too, but only to the position of the blend.
        """
        if not math.isfinite(sum(change["new"])):
            self._follow()
        elif max(abs(a - b) for a, b in zip(change["new"], self._place(), strict=True)) > 1e-9:
            self.aim(self.blend_at(*change["new"]))

    def _follow(self, _change: dict | None = None) -> None:
        """Move the ring to the blend, after menus, triangle or weights changed."""
        if not self._setting:
            self.map.place = self._place()
