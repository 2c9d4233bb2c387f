"""Playback in a notebook: the page draws the clips, with the code that draws them in a web page."""

from collections.abc import Sequence

import traitlets
from matplotlib.figure import Figure

from toolkit.io.save import figure_of
from toolkit.motion import Clip
from toolkit.view.frontend import SceneWidget, in_notebook
from toolkit.view.pages.page import pack
from toolkit.view.render.picture import strip
from toolkit.view.render.skin import Character


def play(clips: Clip | Sequence[Clip], *, labels: Sequence[str] | None = None, contacts=None,
         character: Character = None) -> "Player | Figure":
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
    return Player(clips, labels=labels, contacts=contacts, character=character)


class Player(SceneWidget):
    """Clips side by side, with a bar for time, speed and what is drawn; drag turns the camera.

    The parameters are those of `play`, and ``size``, width and height of the picture in pixels.

    Attributes
    ----------
    shown
        The motions that are shown.
    playing
        Whether they play; can be set and observed.
    """

    skeletons = traitlets.List(traitlets.Dict()).tag(sync=True)
    clips = traitlets.List(traitlets.Dict()).tag(sync=True)
    size = traitlets.List(traitlets.Int()).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)

    def __init__(self, clips: Clip | Sequence[Clip], *, labels: Sequence[str] | None = None,
                 contacts=None, size: tuple[int, int] = (640, 480),
                 character: Character = None):
        self._figure, self._bodies = figure_of(character), {}
        super().__init__(size=list(size), **self._pack(clips, labels, contacts))

    def show(self, clips: Clip | Sequence[Clip]) -> None:
        """Show other clips."""
        state = self._pack(clips)
        with self.hold_sync():
            self.skeletons, self.clips = state["skeletons"], state["clips"]

    def _pack(self, clips, labels=None, contacts=None) -> dict:
        """The traits for other clips."""
        self.shown, self._bodies, packed = pack(
            clips, labels, contacts, None, self._figure, self._bodies
        )
        return {"skeletons": list(self._bodies.values()), "clips": packed}

    @property
    def clip(self) -> Clip:
        """The longest motion that is shown."""
        return max(self.shown, key=lambda clip: clip.seconds)

    def still(self) -> bytes:
        """A strip of poses, PNG."""
        labels = [clip["label"] for clip in self.clips]
        return strip(self.shown, labels=labels, character=self._figure, frames=5, width=8,
                     dpi=80)._repr_png_()

    def close(self) -> None:
        """Remove the widget, and what the page was sent: a notebook keeps every result."""
        super().close()
        self.skeletons, self.clips, self.shown, self._bodies = [], [], [], {}
