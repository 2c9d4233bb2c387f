"""A character steered live in a notebook: the kernel computes 60 frames a second, the page draws
each as it arrives.

Every frame is one message with one binary buffer. The page acknowledges frames. Without an
acknowledgement for `PATIENCE` seconds (a closed tab, a cleared output) the kernel stops, until a
page asks again.
"""

import asyncio
import math
from collections import deque
from collections.abc import Mapping

import numpy as np
import torch
import traitlets

from toolkit import runtime
from toolkit.io.save import figure_of
from toolkit.motion import Clip, trajectory
from toolkit.runtime import FPS, Command
from toolkit.runtime.life import alive
from toolkit.view.frontend import SceneWidget, running_loop
from toolkit.view.pages.live_page import EASE, RUN, TURN, example, gate, ordered
from toolkit.view.pages.page import skeleton_data
from toolkit.view.render.skin import Character
from toolkit.view.widgets.corners import Corners, corners

KEPT = 600.0  # seconds of a recording, 16 MB
PATIENCE = 2.0  # seconds without a message from the page after which the character waits


class Controller(SceneWidget, Corners):
    """A character under control: keys W A S D walk, Q E turn, Shift runs; a stick, a gamepad; a
    triangle of three styles.

    Parameters
    ----------
    model, bank
        A model and its style bank, e.g. of `toolkit.pretrained`.
    character
        As in `toolkit.view.web`.

    Attributes
    ----------
    state
        The character's current `toolkit.runtime.CharacterState`.
    names, weights, speed
        Corners of the triangle and their shares; walking speed in metres per second, the
        natural one of the blend until another is set.
    size
        Width and height of the picture in pixels.
    frames
        Number of frames computed so far.
    feet, arms
        Whether foot IK and arm IK are on.
    recording
        While true, the last ten minutes are kept for `clip`; setting it to true starts a new
        recording.
    """

    skeleton, gate = traitlets.Dict().tag(sync=True), traitlets.Dict().tag(sync=True)
    styles = traitlets.List(traitlets.Unicode()).tag(sync=True)
    labels = traitlets.Dict().tag(sync=True)
    size = traitlets.List(traitlets.Int(), [640, 480]).tag(sync=True)
    speed = traitlets.Float(1.0, min=0.1, max=3.0).tag(sync=True)
    feet = traitlets.Bool(True).tag(sync=True)
    arms = traitlets.Bool(True).tag(sync=True)
    recording = traitlets.Bool(False).tag(sync=True)
    status = traitlets.Unicode("").tag(sync=True)
    _task: asyncio.Task | None = None  # None in a script, where `advance` moves the character

    def __init__(self, model, bank, *, character: Character = None):
        self._recorded: deque[np.ndarray] = deque(maxlen=round(KEPT * FPS))
        names = (ordered(bank) * 3)[:3]
        self._model, self._bank = model, bank
        self._natural = speed = _within(bank.speed(names[0]))
        self._vector = self._target = bank.blend(dict.fromkeys(names, 0.0) | {names[0]: 1.0})
        self._alive = alive(lambda _: self._vector, model.life)
        self.state = runtime.start(model, self._vector)
        self._facing = 0.0
        self._input = {"id": 0, "move": [0.0, 0.0], "turn": 0.0, "run": False, "heading": None}
        self.frames = self._seen = 0
        skeleton = skeleton_data(example(model, bank), figure_of(character))
        super().__init__(names=names, weights=[1.0, 0.0, 0.0], styles=list(bank.names),
                         labels=bank.labels(), speed=speed, skeleton=skeleton,
                         gate=gate(model.layout.skeleton))
        self.on_msg(self._receive)
        self._loop = running_loop()
        if self._loop is not None:
            self._wake = asyncio.Event()
            self._task = self._loop.create_task(self._run())

    @Corners.blend.setter
    def blend(self, weights: Mapping[str, float]) -> None:
        """Blend at the marker (style to share).

        Assign up to three styles of the bank to move the marker.
        """
        names, shares = corners(self._bank, weights, [*self.names, *ordered(self._bank)])
        with self.hold_sync():
            self.names, self.weights = names, shares

    @property
    def clip(self) -> Clip:
        """The recording, on the model's whole skeleton; a ValueError if there is none."""
        if not self._recorded:
            raise ValueError("nothing recorded yet: press Record (or set recording = True) and "
                             "walk")
        rows = torch.from_numpy(np.stack(self._recorded))
        return Clip(self._model.layout.skeleton, rows[:, 3:].unflatten(1, (-1, 4)), rows[:, :3],
                    FPS, name="controller")

    def steer(self, ahead: float = 0.0, right: float = 0.0, turn: float = 0.0, *,
              run: bool = False) -> None:
        """Steer from a program: shares in [-1, 1] of ahead, to the right and turning left."""
        self._input |= {"move": [right, ahead], "turn": turn, "run": run, "heading": None}

    def advance(self, frames: int = 1) -> None:
        """Compute frames at once, with or without a page."""
        for _ in range(frames):
            self._step()

    def close(self) -> None:
        """Stop and remove the widget, its recording and state: a notebook keeps every result."""
        if self._task is not None and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._task.cancel)
        super().close()
        self.skeleton = {}
        self._recorded.clear()
        self._task = self.state = None

    @traitlets.validate("speed")
    def _finite(self, proposal: dict) -> float:
        if not math.isfinite(proposal["value"]):
            raise traitlets.TraitError(f"the speed must be finite, got {proposal['value']}")
        return proposal["value"]

    @traitlets.observe("names", "weights")
    def _aim(self, _change: dict) -> None:
        self._target = self._bank.blend(self.blend)
        follows, self._natural = self.speed == self._natural, _within(self._bank.speed(self.blend))
        if follows:  # nobody has set another speed
            self.speed = self._natural

    @traitlets.observe("recording")
    def _record(self, change: dict) -> None:
        if change["new"]:
            self._recorded.clear()

    def _receive(self, _widget, message: dict, _buffers) -> None:
        """A message of a page (any thread): store it, wake the task."""
        kind = message.get("kind") if isinstance(message, dict) else None
        if kind == "input":
            self._input = _valid(message) or self._input
        self._seen = -math.inf if kind == "closed" else self.frames
        if self._task is not None and kind != "closed":
            self._loop.call_soon_threadsafe(self._wake.set)

    def _command(self) -> Command:
        """The user's input as a command in world coordinates."""
        held = self._input
        fast = self.speed * (RUN if held["run"] else 1.0)
        if held["heading"] is not None:
            x, z = held["heading"]
            self._facing = math.atan2(x, z)
            return Command((fast * x, fast * z), (x, z))
        self._facing += TURN / FPS * held["turn"]
        s, c = math.sin(self._facing), math.cos(self._facing)
        right, ahead = held["move"]
        scale = fast / max(1.0, math.hypot(right, ahead))
        return Command((scale * (ahead * s - right * c), scale * (ahead * c + right * s)), (s, c))

    @torch.no_grad()
    def _step(self) -> None:
        self._vector = torch.lerp(self._vector, self._target, EASE)
        style = self._alive(self.frames)
        self.state = state = runtime.step(self._model, self.state.with_style(style),
                                          self._command())
        rotations, root = runtime.pose(self._model, state, feet=self.feet, arms=self.arms)
        self.frames += 1
        past = [trajectory.PAST + o for o in self._model.layout.behind]
        parts = (root, rotations, state.history[:, past], state.future, state.contacts, state.phase)
        message = np.concatenate([part.numpy().ravel() for part in parts])
        if self.recording:
            self._recorded.append(message[: root.numel() + rotations.numel()].copy())
        self.send({"kind": "frame", "frame": self.frames, "input": self._input["id"]},
                  [message.astype(np.float32).tobytes()])

    async def _run(self) -> None:
        """One frame every 1/60 s while a page answers; late frames are dropped."""
        try:
            due = self._loop.time()
            while True:
                if self.frames - self._seen > PATIENCE * FPS:
                    self._wake.clear()
                    await self._wake.wait()
                    due = self._loop.time()
                self._step()
                due = max(due + 1 / FPS, self._loop.time() - 1 / FPS)
                await asyncio.sleep(max(0.002, due - self._loop.time()))
        except Exception as error:  # shown in the page: nothing else would report it
            self.status = f"stopped: {type(error).__name__}: {error}"


def _within(speed: float) -> float:
    """A speed within the limits of `Controller.speed`."""
    return min(max(speed, 0.1), 3.0)


def _valid(message: Mapping) -> dict | None:
    """The input in a message of a page.

    Numbers that are finite and of the right count; None for any other message.
    """
    def pair(values) -> list[float]:
        x, y = map(float, values)
        return [x, y]

    try:
        number, move, turn = int(message["id"]), pair(message["move"]), float(message["turn"])
        run, heading = bool(message["run"]), message["heading"]
        heading = None if heading is None else pair(heading)
    except (KeyError, OverflowError, TypeError, ValueError):
        return None
    if abs(number) >= 2**53 or not all(abs(x) <= 2 for x in (*move, turn, *(heading or ()))):
        return None  # JavaScript counts to 2**53
    return {"id": number, "move": move, "turn": turn, "run": run, "heading": heading}
