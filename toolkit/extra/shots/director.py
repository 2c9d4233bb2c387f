"""Plan shots by hand: a map for the path, a timeline for styles, speeds and pauses, and the
characters that walk it.

The browser computes what it shows, with the runtime of a page (`toolkit.view.pages.live_page`), in
a notebook too; the kernel keeps the shots as data. Of a model that does not run in a page, the
kernel renders the shots after each change, and the browser plays them.
"""

import asyncio
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import torch
import traitlets

from toolkit.extra import shots
from toolkit.extra.shots import (
    Scene,
    Shot,
    apart,
    feasibility,
    following,
    pins,
    reaching,
    scene,
)
from toolkit.io.save import figure_of
from toolkit.motion import Clip, contacts, root_frames, rotations as R
from toolkit.view.frontend import SceneWidget, running_loop
from toolkit.view.pages import live_page, page
from toolkit.view.render.skin import Character, Figure

START = (0, 0), (0.6, 2), (-0.6, 4), (0, 6)  # the path of the first shot
REST = 0.1  # seconds without a change before the kernel renders


class Director(SceneWidget):
    """A desk for shots: draw and drag the path, key styles, speeds and pauses, see the character
    walk it at once.

    Parameters
    ----------
    model, bank
        A model and its style bank, e.g. of `toolkit.pretrained`. An LPN-FiLM runs in the page;
        another model's motion comes from the kernel, and later after a change.
    shots
        The first shots, one per character, or a `toolkit.extra.shots.Scene`; by default one shot
        along a short path.
    character
        As in `toolkit.view.web`.

    Attributes
    ----------
    shots : list of toolkit.extra.shots.Shot
        The shots as the page shows them; assign others to show them.
    scene
        The same as data, as a file holds it: a trait that can be observed.
    height
        Of the widget, pixels.
    """

    data = traitlets.Dict().tag(sync=True)
    scene = traitlets.Dict().tag(sync=True)
    motion = traitlets.Dict().tag(sync=True)  # a scene as the kernel rendered it; or the problem
    height = traitlets.Int(760, min=300).tag(sync=True)

    _later: asyncio.TimerHandle | None = None

    def __init__(self, model, bank, shots: Iterable[Shot] | Scene | None = None, *,
                 character: Character = None):
        self._model, self._bank = model, bank
        super().__init__(data=pack(model, bank, character=figure_of(character)),
                         scene=first(bank, shots))

    @property
    def shots(self) -> list[Shot]:
        """The shots as the page shows them."""
        return shots.parse(self.scene)

    @shots.setter
    def shots(self, made: Iterable[Shot] | Scene) -> None:
        self.scene = first(self._bank, made)

    def render(self, character: int = 0) -> Clip:
        """The motion of a character, by `toolkit.extra.shots.Scene.render`."""
        made = Scene.parse(self.scene)
        if made.apart is None:  # the others need not be rendered
            return made.shots[character].render(self._model, self._bank)
        return made.render(self._model, self._bank)[character]

    def close(self) -> None:
        """Remove the widget; its shots stay."""
        if self._later is not None:
            self._later.cancel()
        super().close()
        self.data = self.motion = {}

    @traitlets.observe("scene")
    def _changed(self, _change: dict) -> None:
        if live_page.runs(self._model):
            return
        if self._later is not None:
            self._later.cancel()
        loop = running_loop()
        self._later = loop and loop.call_later(REST, self._move)
        if loop is None:
            self._move()

    def _move(self) -> None:
        """Render the scene for the page."""
        made = {"scene": self.scene}
        try:
            clips = Scene.parse(self.scene).render(self._model, self._bank)
            self.motion = made | {"takes": [live_page.numbers(frames(clip)) for clip in clips]}
        except Exception as error:  # of somebody's model
            self.motion = made | {"problem": str(error)}

    @traitlets.validate("scene")
    def _valid(self, proposal: dict) -> dict:
        try:
            first(self._bank, Scene.parse(proposal["value"]))
        except ValueError as error:
            raise traitlets.TraitError(str(error)) from None
        # as it came: another form would be sent back, over newer changes of the page
        return proposal["value"]


def frames(clip: Clip) -> torch.Tensor:
    """The frames of a motion as ``scene/desk.js`` reads them, ``[F, 9 + 4 J]``: place and direction
    of the root frame, contacts, place of the hips, local rotations.
    """
    roots = root_frames(clip)
    ahead = roots.rotations.new_tensor([0.0, 0.0, 1.0]).expand(len(clip), 3)
    facing = R.rotate(roots.rotations, ahead)
    return torch.cat((roots.positions[:, [0, 2]], facing[:, [0, 2]], contacts.detect(clip),
                      clip.root_positions, clip.rotations.flatten(1)), 1)


def web(model, bank, path: str | os.PathLike, shots: Iterable[Shot] | Scene | None = None, *,
        title: str = "Plan a shot", styles: Sequence[str] | None = None, half: bool = False,
        character: Character = None) -> Path:
    """Write a page with the `Director`, without server or Python; shots are saved to and opened
    from files.

    The parameters are those of `Director` and `toolkit.view.web`. Of a model that does not run in a
    page, the page plays the shots as Python renders them, nine at most, and says so.
    """
    bank = bank.select(dict.fromkeys(live_page.ordered(bank) if styles is None else styles))
    if not live_page.runs(model):
        made = Scene.parse(first(bank, shots))
        labels = [shot.name or f"shot {k + 1}" for k, shot in enumerate(made.shots)]
        caption = f"Recorded shots: the model {model.name} cannot run in a page."
        return page.html(made.render(model, bank), path, title=title, caption=caption,
                         labels=labels, character=character)
    data = pack(model, bank, half, figure_of(character)) | {"scene": first(bank, shots)}
    caption = "Draw a path, key styles over time; the character walks it at once, in this page."
    script = "globalThis.view = toolkitScene.director(stage, data);"
    return page.write(path, title, caption, data, script)


def pack(model, bank, half: bool = False, character: Figure | None = None) -> dict[str, Any]:
    """The data of ``scene/shot.js``: that of a live page, natural speeds, constants of shots."""
    return live_page.pack(model, bank, half, character) | {
        "speeds": [bank.speed(name) for name in bank.names],
        "course": live_page.constants(following),
        "limits": live_page.constants(feasibility),
        "apart": live_page.constants(scene) | live_page.constants(apart),
        "pins": live_page.constants(pins) | live_page.constants(reaching),
        "figure": reaching.figure(model.layout.skeleton),
        "joints": list(model.layout.skeleton.names),
    }


def first(bank, made: Iterable[Shot] | Scene | None) -> dict[str, Any]:
    """The data of a scene, of some shots, or of a first one; a ValueError if a style is unknown."""
    made = [Shot(START, live_page.ordered(bank)[0], name="shot 1")] if made is None else made
    made = made if isinstance(made, Scene) else Scene(made)
    for shot in made.shots:
        shot.style(bank)
    return shots.data(made)
