"""Playback in a notebook: pyvista draws off screen, the picture goes as JPEG into a widget, widgets steer it.

Widget callbacks may run in any thread (ipykernel 7 handles comms in subshells), and VTK breaks silently off the main one. So
callbacks only store what is wanted; one asyncio task on the main loop draws the newest state and nothing else.
"""

import asyncio
import io
import threading
import time
from contextlib import contextmanager

import ipywidgets as widgets
import numpy as np
from matplotlib.figure import Figure
from PIL import Image

from toolkit.motion import Clip
from toolkit.view import stage
from toolkit.view.picture import contact_list, label, strip

IDLE = 600.0  # seconds of playback without a touch after which it pauses by itself
RATE = 60.0  # pictures per second at most


def play(clip: Clip, *, contacts=None, size: tuple[int, int] = (640, 480), playing: bool = False) -> "Player | Figure":
    """Play a clip in a notebook.

    Parameters
    ----------
    clip
        The motion.
    contacts
        Foot contacts [F, 2] (right, left), above one half where a foot stands.
    size
        Pixels of the picture: width, height.
    playing
        Start at once.

    Returns
    -------
    Player or Figure
        A strip picture outside of notebooks, where no widget could be shown.
    """
    if not _in_notebook():
        return strip(clip, contacts=contacts)
    return Player(clip, contacts=contacts, size=size, playing=playing)


def _in_notebook() -> bool:
    try:
        from IPython import get_ipython
    except ImportError:
        return False
    return getattr(get_ipython(), "kernel", None) is not None


class Player(widgets.VBox):
    """A clip with play, scrub, speed, camera, contacts and trail.

    Parameters
    ----------
    clip
        The motion.
    contacts
        Foot contacts [F, 2] (right, left).
    size
        Pixels of the picture: width, height.
    playing
        Start at once; one player plays at a time.

    Attributes
    ----------
    image
        The widget that shows the current picture as JPEG.
    clip
        The motion that is shown.
    rate
        Pictures per second at most; fewer leave more of the processor to others.
    """

    _current: "Player | None" = None

    def __init__(self, clip: Clip, *, contacts=None, size: tuple[int, int] = (640, 480), playing: bool = False):
        require_main_thread()
        self.clip, self.contacts = clip, contact_list(contacts, [clip])[0]
        self.drawn, self.rate = 0, RATE
        self._frame, self._stale, self._touched = 0.0, False, time.monotonic()
        self._wake: asyncio.Event | None = None
        self._task: asyncio.Task | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._own: threading.Thread | None = None
        self._stage = stage.make(clip, self.contacts, size)
        self.image = widgets.Image(format="jpeg", width=size[0], height=size[1])
        self._title = widgets.HTML()
        self._play = widgets.ToggleButton(icon="play", tooltip="Play or pause", layout={"width": "44px"})
        self._slider = widgets.IntSlider(min=0, max=len(clip) - 1, readout=False, layout={"flex": "1", "min_width": "120px"})
        self._clock = widgets.Label(layout={"width": "110px"})
        self._speeds = widgets.Dropdown(options=[(f"{s:g}×", s) for s in (0.1, 0.25, 0.5, 1, 2)], value=1,
                                        layout={"width": "72px"})  # fmt: skip
        self._angle = widgets.IntSlider(value=-50, min=-180, max=180, description="Angle", readout=False)
        self._distance = widgets.FloatSlider(value=3.8, min=1.5, max=9, description="Distance", readout=False)
        switch = {"layout": {"width": "90px"}, "value": True}
        self._follow = widgets.ToggleButton(description="Follow", **switch)
        self._trail = widgets.ToggleButton(description="Path", **switch)
        self._contacts = widgets.ToggleButton(description="Contacts", disabled=self.contacts is None, **switch)
        for widget in (self._play, self._slider, self._speeds, self._angle, self._distance, self._follow, self._trail,
                       self._contacts):  # fmt: skip
            widget.observe(self._changed, "value")
        super().__init__([
            self._title, self.image,
            widgets.HBox([self._play, self._slider, self._clock, self._speeds], layout={"width": f"{size[0]}px"}),
            widgets.HBox([self._angle, self._distance], layout={"width": f"{size[0]}px"}),
            widgets.HBox([self._follow, self._trail, self._contacts]),
        ])  # fmt: skip
        self._caption()
        self._show()
        self._start()
        self.playing = playing

    @property
    def frame(self) -> int:
        """The frame that is shown."""
        return int(self._frame)

    @property
    def playing(self) -> bool:
        """Whether time runs; it pauses any other player."""
        return self._play.value

    @playing.setter
    def playing(self, on: bool) -> None:
        self._play.value = bool(on)

    def seek(self, frame: int) -> None:
        """Show a frame (clamped to the clip)."""
        self._frame = float(np.clip(frame, 0, len(self.clip) - 1))
        self._refresh()

    def render(self, frame: int) -> np.ndarray:
        """Picture ``[H, W, 3]`` uint8 of a frame, without showing it.

        Raises
        ------
        ValueError
            If the clip has no such frame.
        RuntimeError
            If called outside of the main thread.
        """
        require_main_thread()
        if not 0 <= frame < len(self.clip):
            raise ValueError(f"{self.clip.name}: frame {frame} is not one of {len(self.clip)}")
        return self._stage.draw(int(frame))

    def set_clip(self, clip: Clip, *, contacts=None) -> None:
        """Show another clip, from where the last one was if it is long enough."""
        require_main_thread()
        self.contacts = contact_list(contacts, [clip])[0]
        self.clip = clip
        self._stage.load(clip, self.contacts)
        self._contacts.disabled = self.contacts is None
        self._frame = self._frame % len(clip)
        with self._quiet():
            self._slider.max = len(clip) - 1
        self._caption()
        self._show()

    def close(self) -> None:
        """Stop, free the window and take the widgets away."""
        if self._task is not None and not self._loop.is_closed():
            self._task.cancel()
        self._wake = self._task = None
        if Player._current is self:
            Player._current = None
        self._stage.close()
        super().close()

    def _caption(self) -> None:
        self._title.value = f"<b>{label(self.clip)}</b> &nbsp;{self.clip.seconds:.1f} s at {self.clip.fps:g} Hz"

    def _changed(self, change: dict) -> None:
        """A widget moved: remember what is wanted (any thread)."""
        if threading.current_thread() is self._own:
            return
        self._touched = time.monotonic()
        if change["owner"] is self._slider:
            self._frame = float(self._slider.value)
        elif change["owner"] is self._play:
            self._play.icon = "pause" if self._play.value else "play"
            if self._play.value:
                other, Player._current = Player._current, self
                if other is not None and other is not self:
                    other.playing = False
        self._refresh()

    def _refresh(self) -> None:
        self._stale = True
        if self._wake is not None and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._wake.set)
        if threading.current_thread() is threading.main_thread() and not self.playing:
            self._show()

    @contextmanager
    def _quiet(self):
        """While active, changes made by this thread are the player's own."""
        self._own = threading.current_thread()
        yield
        self._own = None

    def _show(self) -> None:
        """Draw the wanted state now (main thread)."""
        self._stale = False
        view, frame = self._stage, min(int(self._frame), len(self.clip) - 1)
        view.angle, view.distance = self._angle.value, self._distance.value
        view.follow, view.show_trail, view.show_contacts = self._follow.value, self._trail.value, self._contacts.value
        picture = view.draw(frame)
        buffer = io.BytesIO()
        Image.fromarray(picture).save(buffer, "JPEG", quality=88)
        self.image.value = buffer.getvalue()
        self.drawn += 1
        with self._quiet():
            self._clock.value = f"{frame / self.clip.fps:.2f} / {self.clip.seconds:.2f} s"
            if not self.playing or self.drawn % 4 == 0:
                self._slider.value = frame

    def _start(self) -> None:
        try:
            self._loop = asyncio.get_running_loop()
        except RuntimeError:
            return  # a script: every change is drawn at once
        self._wake = asyncio.Event()
        self._task = self._loop.create_task(self._run())

    async def _run(self) -> None:
        """Draw the newest state; time advances by the clock, whatever drawing takes."""
        last = time.monotonic()
        while True:
            if not self.playing:
                await self._wake.wait()
                last = time.monotonic()
            self._wake.clear()
            now = time.monotonic()
            if self.playing:
                self._frame = (self._frame + (now - last) * self.clip.fps * self._speeds.value) % len(self.clip)
                if now - self._touched > IDLE:
                    self.playing = False
            last = now
            if self.playing or self._stale:
                self._show()
            await asyncio.sleep(max(0.004, 1 / self.rate - (time.monotonic() - now)))


def require_main_thread() -> None:
    """Raise RuntimeError outside of the main thread, where VTK would draw garbage without saying so."""
    if threading.current_thread() is not threading.main_thread():
        raise RuntimeError("the player draws in the main thread only; call it from there (loop.call_soon_threadsafe)")
