"""Style interpolation by hand: three style menus, a barycentric triangle, and the motion that the blend gives."""

import asyncio
import math
import threading
from collections.abc import Callable, Mapping, Sequence
from importlib import resources

import anywidget
import ipywidgets as widgets
import traitlets

from toolkit.motion import Clip
from toolkit.view.frontend import require_main_thread
from toolkit.view.player import RATE, Player

PAUSE = 0.03  # seconds in which moves are gathered before a new motion is made
BUSY = 15.0  # pictures per second at most while a motion is made: both need Python


class StyleTriangle(anywidget.AnyWidget):
    """Three corners and a marker to drag.

    Attributes
    ----------
    names
        What the corners are called.
    weights
        Three shares that sum to one; a trait, so it can be observed, linked and set.
    """

    _esm = (resources.files("toolkit.view") / "static" / "triangle.js").read_text(encoding="utf-8")
    names = traitlets.List(traitlets.Unicode(), ["A", "B", "C"], minlen=3, maxlen=3).tag(sync=True)
    weights = traitlets.List(traitlets.Float(), [1 / 3, 1 / 3, 1 / 3], minlen=3, maxlen=3).tag(sync=True)

    @traitlets.validate("weights")
    def _sum_to_one(self, proposal: dict) -> list[float]:
        shares = proposal["value"]
        if not all(math.isfinite(w) and w >= 0 for w in shares) or not sum(shares) > 0:
            raise traitlets.TraitError(f"weights must be three shares >= 0 and not all zero, got {shares}")
        return [w / sum(shares) for w in shares]


class StyleBlender(widgets.HBox):
    """A player whose motion follows a blend of three styles.

    Parameters
    ----------
    bank
        Style bank; its ``names`` fill the menus.
    make_clip
        Takes ``{style: weight}`` (weights sum to one) and returns the motion, which is labelled with the blend unless it
        has a style. It runs in a worker thread while widgets are dragged, one call at a time, again and again; of the moves
        made meanwhile only the newest counts.
    weights
        The first blend, one to three styles; by default the first three names in equal parts.
    size
        Pixels of the picture: width, height.

    Attributes
    ----------
    weights
        The blend ``{style: weight}``; assigning one makes and shows its motion before it returns.
    player
        The `Player`.
    triangle
        The `StyleTriangle`.

    Raises
    ------
    ValueError
        If a style is unknown, or weights are negative or all zero.
    """

    def __init__(self, bank, make_clip: Callable[[dict[str, float]], Clip], *, weights: Mapping[str, float] | None = None,
                 size: tuple[int, int] = (640, 480)):
        require_main_thread()
        self._names, self._make_clip = tuple(bank.names), make_clip
        weights = dict.fromkeys(self._names[:3], 1.0) if weights is None else weights
        chosen, shares = self._corners(weights)
        self._menus = [widgets.Dropdown(options=self._names, value=name, layout={"width": "220px"}) for name in chosen]
        self.triangle = StyleTriangle(names=chosen, weights=shares)
        self._status = widgets.HTML(layout={"width": "220px"})
        self._serial, self._settled, self._task, self._setting = 0, 0, None, False  # moves made, move shown
        try:
            self._loop = asyncio.get_running_loop()
        except RuntimeError:
            self._loop = None  # a script: every change is made at once
        self.player = Player(self._make(self.weights), size=size)
        for menu in self._menus:
            menu.observe(self._changed, "value")
        self.triangle.observe(self._changed, "weights")
        super().__init__([self.player, widgets.VBox([*self._menus, self.triangle, self._status])])

    @property
    def weights(self) -> dict[str, float]:
        """The blend: style to share, summing to one."""
        blend: dict[str, float] = {}
        for menu, share in zip(self._menus, self.triangle.weights, strict=True):
            blend[menu.value] = blend.get(menu.value, 0.0) + share
        return blend

    @weights.setter
    def weights(self, weights: Mapping[str, float]) -> None:
        require_main_thread()
        self._set(weights)
        self._serial += 1
        self.player.show(self._make(self.weights))
        self._settled = self._serial

    def close(self) -> None:
        """Stop and take the widgets away."""
        self._settled = math.inf
        self.player.close()
        super().close()

    def _repr_mimebundle_(self, **kwargs) -> dict:
        """The widget, and the player's picture for pages that show none (a notebook on GitHub, nbconvert)."""
        return super()._repr_mimebundle_(**kwargs) | {"image/jpeg": self.player._repr_mimebundle_()["image/jpeg"]}

    def _set(self, weights: Mapping[str, float]) -> None:
        """Menus and marker at a blend, with no motion made for it."""
        names, shares = self._corners(weights)
        self._setting = True
        try:
            for menu, name in zip(self._menus, names, strict=True):
                menu.value = name
            self.triangle.names, self.triangle.weights = names, shares
        finally:
            self._setting = False

    def _corners(self, weights: Mapping[str, float]) -> tuple[list[str], list[float]]:
        """Three names and shares; missing corners are filled with other styles at zero."""
        unknown = [n for n in weights if n not in self._names]
        shares = [float(w) for w in weights.values()]
        if unknown:
            raise ValueError(f"unknown style {unknown[0]!r}; the bank has {', '.join(self._names)}")
        if not 1 <= len(shares) <= 3 or not all(math.isfinite(w) and w >= 0 for w in shares) or not sum(shares) > 0:
            raise ValueError(f"a blend needs one to three weights >= 0 and not all zero, got {dict(weights)}")
        others: Sequence[str] = [n for n in self._names if n not in weights] + [next(iter(weights))] * 2
        missing = 3 - len(shares)
        return [*weights, *others[:missing]], [w / sum(shares) for w in shares] + [0.0] * missing

    def _make(self, blend: dict[str, float]) -> Clip:
        clip = self._make_clip(blend)
        named = ", ".join(f"{share:.0%} {name}" for name, share in blend.items() if share >= 0.005)
        return clip if clip.style else clip.replace(style=named)

    def _changed(self, _change: dict) -> None:
        """A menu or the marker moved (any thread): make its motion."""
        if self._setting:
            return
        self.triangle.names = [menu.value for menu in self._menus]
        self._serial += 1
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._plan)
        elif threading.current_thread() is threading.main_thread():
            self.player.show(self._make(self.weights))

    def _plan(self) -> None:
        if self._task is None or self._task.done():
            self._task = self._loop.create_task(self._follow())

    async def _follow(self) -> None:
        """Make motions until the newest blend is shown; one that was assigned meanwhile stays."""
        while self._settled < self._serial:
            await asyncio.sleep(PAUSE)
            serial = self._serial
            self._status.value = "making the motion …"
            self.player.rate = BUSY
            try:
                clip = await asyncio.to_thread(self._make, self.weights)
            except Exception as error:  # shown beside the triangle: nothing else would report it
                self._status.value = f"<b>{type(error).__name__}</b>: {error}"
                return
            finally:
                self.player.rate = RATE
            self._status.value = ""
            if serial > self._settled:
                self.player.show(clip)
                self._settled = serial
