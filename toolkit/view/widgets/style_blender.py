"""Style interpolation by hand.

Three style menus, a barycentric triangle, and the motion of the blend.
"""

import asyncio
import math
import threading
from collections.abc import Callable, Iterable, Mapping

import anywidget
import ipywidgets as widgets
import traitlets

from toolkit.motion import Clip
from toolkit.view.frontend import CellWidget, escape, require_main_thread, running_loop, static
from toolkit.view.widgets.player import RATE, Player

PAUSE = 0.03  # seconds in which changes are collected before a new motion is made
BUSY = 15.0  # pictures per second at most while a motion is made: both need Python


class Corners(anywidget.AnyWidget):
    """A widget with three styles, ``names``, and their shares, ``weights``: traits that can be
    observed, linked and set.

    Names must be in the bank, where there is one; shares are scaled to sum to one.
    """

    _bank = None

    names = traitlets.List(traitlets.Unicode(), ["A", "B", "C"], minlen=3, maxlen=3).tag(sync=True)
    weights = traitlets.List(traitlets.Float(), [1 / 3, 1 / 3, 1 / 3], minlen=3, maxlen=3).tag(
        sync=True
    )

    @traitlets.validate("names")
    def _known(self, proposal: dict) -> list[str]:
        if unknown := [
            name for name in proposal["value"] if self._bank is not None and name not in self._bank
        ]:
            raise traitlets.TraitError(f"unknown style {unknown[0]!r}")
        return proposal["value"]

    @traitlets.validate("weights")
    def _sum_to_one(self, proposal: dict) -> list[float]:
        shares = proposal["value"]
        if not all(math.isfinite(w) and w >= 0 for w in shares) or not 0 < sum(shares) < math.inf:
            raise traitlets.TraitError(
                f"weights must be three shares >= 0 and not all zero, got {shares}"
            )
        return [w / sum(shares) for w in shares]

    @property
    def blend(self) -> dict[str, float]:
        """Style to share; a style at two corners has both shares."""
        blend: dict[str, float] = {}
        for name, share in zip(self.names, self.weights, strict=True):
            blend[name] = blend.get(name, 0.0) + share
        return blend


class StyleTriangle(Corners):
    """A barycentric triangle with a marker to drag."""

    _esm = static("triangle.js")


def corners(
    bank, weights: Mapping[str, float], others: Iterable[str]
) -> tuple[list[str], list[float]]:
    """Three styles and their shares, which sum to one, of a blend of one to three.

    ``others`` fill up, with share zero.
    """
    for name in weights:
        bank[name]
    shares = [float(w) for w in weights.values()]
    if (
        not 1 <= len(shares) <= 3
        or not all(math.isfinite(w) and w >= 0 for w in shares)
        or not sum(shares) > 0
    ):
        raise ValueError(
            f"a blend needs one to three weights >= 0 and not all zero, got {dict(weights)}"
        )
    names = [*weights, *(name for name in others if name not in weights), *weights, *weights]
    return names[:3], [w / sum(shares) for w in shares] + [0.0] * (3 - len(shares))


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
        The first blend, one to three styles; by default the first three names in equal parts.
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
        require_main_thread()
        self._bank, self._make_clip = bank, make_clip
        names, shares = corners(
            bank, dict.fromkeys(bank.names[:3], 1.0) if weights is None else weights, bank.names
        )
        self._menus = [
            widgets.Dropdown(options=bank.names, value=name, layout={"width": "220px"})
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
        require_main_thread()
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

    def _repr_mimebundle_(self, **kwargs) -> dict:
        """The widget, and the player's picture for pages without widgets (a notebook on GitHub,
        nbconvert).
        """
        return super()._repr_mimebundle_(**kwargs) | {
            "image/jpeg": self.player._repr_mimebundle_()["image/jpeg"]
        }

    def _set(self, weights: Mapping[str, float]) -> None:
        """Set menus and marker to a blend, without making its motion."""
        names, shares = corners(self._bank, weights, self._bank.names)
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
        elif threading.current_thread() is threading.main_thread():
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
            self.player.rate = BUSY
            try:
                clip = await asyncio.to_thread(self._make, self.weights)
            except Exception as error:  # shown beside the triangle: nothing else would report it
                self._status.value = f"<b>{type(error).__name__}</b>: {escape(error)}"
                return
            finally:
                self.player.rate = RATE
            self._status.value = ""
            if asked > self._shown:
                self.player.show(clip)
                self._shown = asked
