"""Style interpolation by hand.

Three style menus, a barycentric triangle, and the motion of the blend.
"""

import asyncio
import math
from collections.abc import Callable, Mapping

import ipywidgets as widgets
import traitlets

from toolkit.motion import Clip
from toolkit.view.frontend import CellWidget, escape, running_loop, static
from toolkit.view.pages.live_page import ordered
from toolkit.view.widgets.corners import Corners, corners
from toolkit.view.widgets.player import Player

PAUSE = 0.03  # seconds in which changes are collected before a new motion is made


class StyleTriangle(Corners):
    """A barycentric triangle with a marker to drag."""

    code = traitlets.Unicode(static("triangle.js")).tag(sync=True)


class StyleBlender(CellWidget, widgets.HBox):
    """A player whose motion follows a blend of three styles.

    Parameters
    ----------
    bank
        Style bank; its ``names`` fill the menus.
    make_clip
        Takes ``{style: weight}`` (weights sum to one) and returns the motion, which is labelled
        with the blend unless it has a style. While widgets are dragged it runs in a worker thread,
        one call at a time, for the newest blend.
    weights
        The first blend, one to three styles; by default three styles that differ, in equal parts.
    size
        Pixels of the picture: width, height.

    Attributes
    ----------
    weights
        The blend ``{style: weight}``; assigning one makes and shows its motion before it returns.
    player, triangle
        The `Player` and the `StyleTriangle`.

    Raises
    ------
    ValueError
        If a style is unknown, or weights are negative or all zero.
    """

    player: Player | None = None  # until it is made; a refused blend leaves it so

    def __init__(
        self, bank, make_clip: Callable[[dict[str, float]], Clip], *,
        weights: Mapping[str, float] | None = None, size: tuple[int, int] = (640, 480)
    ):
        self._bank, self._make_clip = bank, make_clip
        first = dict.fromkeys(ordered(bank)[:3], 1.0) if weights is None else weights
        names, shares = corners(bank, first, ordered(bank))
        options = [(label, style) for style, label in bank.labels().items()]
        self._menus = [
            widgets.Dropdown(options=options, value=name, layout={"width": "220px"})
            for name in names
        ]
        self.triangle = StyleTriangle(names=names, weights=shares)
        self._status = widgets.HTML(layout={"width": "220px"})
        self._asked = self._shown = 0  # changes of the blend, and the change whose motion is shown
        self._task, self._setting, self._loop = None, False, running_loop()
        self.player = Player(self._make(self.weights), size=size)
        for menu in self._menus:
            menu.observe(self._changed, "value")
        self.triangle.observe(self._changed, "weights")
        super().__init__([self.player, widgets.VBox([*self._menus, self.triangle, self._status])])

    @property
    def weights(self) -> dict[str, float]:
        """The blend: style to share, summing to one."""
        return self.triangle.blend

    @weights.setter
    def weights(self, weights: Mapping[str, float]) -> None:
        self._set(weights)
        self._asked += 1
        self.player.show(self._make(self.weights))
        self._shown = self._asked

    def close(self) -> None:
        """Stop and remove the widgets."""
        self._shown = math.inf
        if self.player is not None:
            self.player.close()
        super().close()

    def still(self) -> bytes:
        """The player's picture."""
        return self.player.still()

    def _set(self, weights: Mapping[str, float]) -> None:
        """Set menus and marker to a blend, without making its motion."""
        names, shares = corners(self._bank, weights, ordered(self._bank))
        self._setting = True
        try:
            for menu, name in zip(self._menus, names, strict=True):
                menu.value = name
            self.triangle.names, self.triangle.weights = names, shares
        finally:
            self._setting = False

    def _make(self, blend: dict[str, float]) -> Clip:
        clip = self._make_clip(blend)
        named = ", ".join(f"{share:.0%} {name}" for name, share in blend.items() if share >= 0.005)
        return clip if clip.style else clip.replace(style=named)

    def _changed(self, _change: dict) -> None:
        """A menu or the marker changed (any thread): make its motion."""
        if self._setting:
            return
        self.triangle.names = [menu.value for menu in self._menus]
        self._asked += 1
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._plan)
        else:
            self.player.show(self._make(self.weights))

    def _plan(self) -> None:
        if self._task is None or self._task.done():
            self._task = self._loop.create_task(self._run())

    async def _run(self) -> None:
        """Make motions until the newest blend is shown; one that was assigned meanwhile stays."""
        while self._shown < self._asked:
            await asyncio.sleep(PAUSE)
            asked = self._asked
            self._status.value = "making the motion …"
            try:
                clip = await asyncio.to_thread(self._make, self.weights)
            except Exception as error:  # shown beside the triangle: nothing else would report it
                self._status.value = f"<b>{type(error).__name__}</b>: {escape(error)}"
                return
            self._status.value = ""
            if asked > self._shown:
                self.player.show(clip)
                self._shown = asked
