"""Playback in a notebook: pictures drawn off screen go to the page as JPEG, widgets control them.

Widget callbacks may run in any thread (ipykernel 7 handles comms in subshells), and VTK fails
without an error outside of the main thread. So callbacks only store what the user asked for; one
asyncio task on the main loop draws the newest state. The page answers every other picture that it
shows, and the task waits for the answers: a slow page gets fewer pictures, and a closed page gets
one every `PATIENCE` seconds.
"""

import asyncio
import base64
import math
import os
import threading
import time
from collections.abc import Sequence
from contextlib import suppress

import ipywidgets as widgets
import numpy as np
from matplotlib.figure import Figure
from PIL import Image, ImageDraw, ImageFont

from toolkit.motion import Clip
from toolkit.view.frontend import (
    CellWidget,
    Screen,
    escape,
    in_notebook,
    require_main_thread,
    running_loop,
)
from toolkit.view.render import floor
from toolkit.view.render.bodies import Body, Camera, Lines, Pose, axes
from toolkit.view.render.picture import INK, PAPER, cast, steady_frames, strip
from toolkit.view.render.skin import Figure as Character, figure_of
from toolkit.view.render.stage import open_stage

IDLE = 600.0  # seconds of playback without user input after which it pauses
RATE = 60.0  # pictures per second at most
AHEAD = 3  # pictures that may be unanswered during playback
REST = 0.25  # seconds of pause before the picture is drawn again with smooth edges
PATIENCE = 2.0  # seconds after which the next picture is drawn without an answer
LIGHT, UP = np.array([-0.08, 1.0, 0.51]), np.array([0.0, 1.0, 0.0])  # the lamp, for facing +z
TILT = 0.2  # radians by which the camera looks down
SWITCHES = {"path": "Path", "contacts": "Contacts", "trajectory": "Trajectory"}


def play(clips: Clip | Sequence[Clip], *, labels: Sequence[str] | None = None, contacts=None,
         size: tuple[int, int] = (640, 480), playing: bool = False,
         character: str | os.PathLike | Character | None = None) -> "Player | Figure":
    """Play one clip or several in a notebook, side by side; elsewhere, return a picture strip.

    Parameters
    ----------
    clips
        One clip or several, which start together. A clip shorter than the longest one repeats.
    labels
        Names of the clips; by default style and gait, else the clip's name.
    contacts
        Foot contacts [F, 2] (right, left), above one half where a foot stands, or one array (or
        None) per clip.
    size, playing
        Pixels of the picture, width and height; whether to start at once.
    character
        A glTF or VRM file with a skinned mesh, drawn in place of the mannequin; the clips are put
        on its rig (`toolkit.extra.characters.character.Character`).

    Raises
    ------
    ValueError
        If there is no clip, or labels or contacts do not fit the clips.
    """
    if not in_notebook():
        return strip(clips, contacts=contacts, labels=labels, character=character)
    return Player(
        clips, labels=labels, contacts=contacts, size=size, playing=playing, character=character
    )


class _Cell:
    """A clip in the player: its stage, its floor and the camera."""

    def __init__(self, size: tuple[int, int], *shown):
        self.size, self.stage = size, open_stage(size, Lines())
        self.load(*shown)

    def load(self, clip: Clip, contacts: np.ndarray | None, figure: Character | None) -> None:
        """Show another clip."""
        self.clip, self.body = clip, Body(clip, contacts, figure)
        self.path, facing = steady_frames(clip, 0.8)
        self.facing = float(facing[0])
        # The camera looks at the middle of the body.
        self.middle = 0.54 * float(clip.global_positions[0, :, 1].max()) * UP
        light = LIGHT @ axes(self.facing, 0.0)
        self.stage.load([self.body], light, floor.layers(clip, contacts))

    def draw(self, frame: int, angle: float, distance: float, follow: bool, shown: set[str],
             fine: bool) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a frame with the layers that are ``shown`` on the floor."""
        target = self.path[frame if follow else len(self.path) // 2] + self.middle
        camera = Camera(target, self.facing + np.radians(angle), TILT, 0.58 * distance, True)
        pose = Pose(self.body, frame, feet="contacts" in shown)
        return self.stage.draw([pose], camera, frame=frame, shown=shown, fine=fine)


class Player(CellWidget, widgets.VBox):
    """Clips with widgets for play, frame, speed, camera and everything drawn beside the bodies.

    One player plays at a time. The parameters are those of `play`.

    Attributes
    ----------
    image
        The widget that shows the current picture as JPEG.
    clips
        The motions that are shown.
    rate
        Maximal number of pictures per second; a lower rate needs less processor time.
    """

    _current: "Player | None" = None

    def __init__(self, clips: Clip | Sequence[Clip], *, labels: Sequence[str] | None = None,
                 contacts=None, size: tuple[int, int] = (640, 480), playing: bool = False,
                 character: str | os.PathLike | Character | None = None):
        require_main_thread()
        self._figure = figure_of(character)
        self.rate, self._size, self._font = RATE, size, ImageFont.load_default(15)
        self._cells: list[_Cell] = []
        self._frame, self._stale, self._fine, self._touched = 0.0, False, False, time.monotonic()
        self._wake = self._task = None
        self.image = Screen(size)
        self.image.observe(lambda _change: self._notify(), "seen")
        self._title = widgets.HTML()
        self._play = widgets.ToggleButton(
            icon="play", tooltip="Play or pause", layout={"width": "44px"}
        )
        self._slider = widgets.IntSlider(
            min=0, max=0, readout=False, layout={"flex": "1", "min_width": "120px"}
        )
        self._clock = widgets.Label(layout={"width": "110px"})
        self._speeds = widgets.Dropdown(
            options=[(f"{s:g}×", s) for s in (0.1, 0.25, 0.5, 1, 2)], value=1,
            layout={"width": "72px"}
        )
        self._angle = widgets.IntSlider(
            value=-50, min=-180, max=180, description="Angle", readout=False
        )
        self._distance = widgets.FloatSlider(
            value=3.8, min=1.5, max=9, description="Distance", readout=False
        )
        look = {"layout": {"width": "90px"}}
        self._follow = widgets.ToggleButton(value=True, description="Follow", **look)
        self._switches = {
            kind: widgets.ToggleButton(value=kind != "trajectory", description=text, **look)
            for kind, text in SWITCHES.items()
        }
        controls = self._play, self._slider, self._speeds, self._angle, self._distance, self._follow
        for widget in (*controls, *self._switches.values()):
            widget.observe(self._changed, "value")
        wide = {"layout": {"width": f"{size[0]}px"}}
        super().__init__([
            self._title, self.image,
            widgets.HBox([self._play, self._slider, self._clock, self._speeds], **wide),
            widgets.HBox([self._angle, self._distance], **wide),
            widgets.HBox([self._follow, *self._switches.values()])
        ])
        self.show(clips, labels=labels, contacts=contacts)
        self._loop = running_loop()
        if self._loop is not None:
            self._wake = asyncio.Event()
            self._task = self._loop.create_task(self._run())
        self.playing = playing

    @property
    def clip(self) -> Clip:
        """The clip that is shown; of several clips the longest, which defines the frame numbers."""
        return max(self.clips, key=lambda clip: clip.seconds)

    @property
    def frame(self) -> int:
        """The frame that is shown."""
        return int(self._frame)

    @property
    def playing(self) -> bool:
        """Whether the clip plays; starting it pauses any other player."""
        return self._play.value

    @playing.setter
    def playing(self, on: bool) -> None:
        self._play.value = bool(on)

    def seek(self, frame: int) -> None:
        """Show a frame (clamped to the clip)."""
        self._frame = float(np.clip(frame, 0, len(self.clip) - 1))
        self._refresh()

    def render(self, frame: int) -> np.ndarray:
        """Picture ``[H, W, 3]`` uint8 of a frame, without showing it (main thread only)."""
        require_main_thread()
        if not 0 <= frame < len(self.clip):
            raise ValueError(f"{self.clip.name}: frame {frame} is not one of {len(self.clip)}")
        return np.asarray(self._picture(int(frame), fine=True))

    def show(
        self, clips: Clip | Sequence[Clip], *, labels: Sequence[str] | None = None, contacts=None
    ) -> None:
        """Show other clips, from the current frame on if they are long enough.

        Arguments as in `play`.
        """
        require_main_thread()
        self.clips, self._labels, contacts = cast(clips, labels, contacts, self._figure)
        rows, n = [*zip(self.clips, contacts, strict=True)], len(self.clips)
        self._columns = n if n < 4 else math.ceil(math.sqrt(n))
        self._cell = self._size[0] // self._columns, self._size[1] // -(-n // self._columns)
        if [cell.size for cell in self._cells] == [self._cell] * n:
            for cell, row in zip(self._cells, rows, strict=True):
                cell.load(*row, self._figure)
        else:
            for cell in self._cells:
                cell.stage.close()
            self._cells = [_Cell(self._cell, *row, self._figure) for row in rows]
        self._switches["contacts"].disabled = all(feet is None for feet in contacts)
        self._frame = self._frame % len(self.clip)
        self._slider.value, self._slider.max = self.frame, len(self.clip) - 1
        names = ", ".join(map(escape, self._labels))
        self._title.value = (
            f"<b>{names}</b> &nbsp;{self.clip.seconds:.1f} s at {self.clip.fps:g} Hz"
        )
        self._show()

    def close(self) -> None:
        """Stop, free the windows and remove the widgets."""
        if self._task is not None and not self._loop.is_closed():
            self._task.cancel()
        self._wake = self._task = None
        if Player._current is self:
            Player._current = None
        for cell in self._cells:
            cell.stage.close()
        super().close()
        # A notebook keeps every result in `Out`.
        self.children, self._cells, self._switches = (), [], {}
        self.image.value, self._font = b"", None
        for name, value in [*vars(self).items()]:
            if isinstance(value, widgets.Widget) and name[0] == "_":
                delattr(self, name)

    def _repr_mimebundle_(self, **kwargs) -> dict:
        """The widget, and the picture for pages without widgets (GitHub, nbconvert)."""
        return super()._repr_mimebundle_(**kwargs) | {
            "image/jpeg": base64.b64encode(self.image.value).decode("ascii")
        }

    def _changed(self, change: dict) -> None:
        """A widget changed (any thread): store the new values."""
        if change["owner"] is self._slider and change["new"] == self.frame:
            return  # the slider follows the clip
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

    def _notify(self) -> None:
        """Wake the task (any thread)."""
        if self._wake is not None and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._wake.set)

    def _refresh(self) -> None:
        self._stale = True
        self._notify()
        if threading.current_thread() is threading.main_thread() and not self.playing:
            self._show()

    def _picture(self, frame: int, fine: bool) -> Image.Image:
        """All cells with their labels (main thread)."""
        sheet, seconds = Image.new("RGB", self._size, PAPER), frame / self.clip.fps
        shown = {kind for kind, switch in self._switches.items() if switch.value}
        for i, (cell, label) in enumerate(zip(self._cells, self._labels, strict=True)):
            own = round(seconds * cell.clip.fps) % len(cell.clip)
            at = frame if cell.clip is self.clip else own
            x, y = i % self._columns * self._cell[0], i // self._columns * self._cell[1]
            camera = self._angle.value, self._distance.value, self._follow.value
            picture = cell.draw(at, *camera, shown, fine)
            sheet.paste(Image.fromarray(picture), (x, y))
            if len(self.clips) > 1:
                ImageDraw.Draw(sheet).text((x + 10, y + 6), label, INK, self._font)
        return sheet

    def _show(self, *, fine: bool = False) -> None:
        """Draw the wanted state now (main thread)."""
        self._stale, self._fine = False, fine
        frame = min(int(self._frame), len(self.clip) - 1)
        self.image.put(self._picture(frame, fine))
        if not self.playing or self.image.number % 6 == 0:  # each update is a message
            self._clock.value = f"{frame / self.clip.fps:.2f} / {self.clip.seconds:.2f} s"
            self._slider.value = self.frame

    async def _run(self) -> None:
        """Draw the newest state.

        During playback the frame follows the clock, however long drawing takes.
        """
        last = time.monotonic()
        while True:
            if not self.playing:
                with suppress(TimeoutError):
                    await asyncio.wait_for(self._wake.wait(), None if self._fine else REST)
                if not self._wake.is_set():
                    self._show(fine=True)
                    continue
                last = time.monotonic()
            elif self.image.number - self.image.seen > AHEAD:
                with suppress(TimeoutError):
                    await asyncio.wait_for(self._wake.wait(), PATIENCE)
            self._wake.clear()
            now = time.monotonic()
            if self.playing:
                self._frame = (
                    self._frame + (now - last) * self.clip.fps * self._speeds.value
                ) % len(self.clip)
                if now - self._touched > IDLE:
                    self.playing = False
            last = now
            if self.playing or self._stale:
                self._show()
            await asyncio.sleep(max(0.004, 1 / self.rate - (time.monotonic() - now)))
