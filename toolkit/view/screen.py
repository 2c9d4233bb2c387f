"""A picture in a notebook that the kernel replaces many times a second, and that says when it is seen."""

import io
from importlib import resources

import anywidget
import traitlets
from PIL import Image

QUALITY = 88  # of the JPEG


class Screen(anywidget.AnyWidget):
    """A JPEG picture, ``value``, whose ``number`` the page sends back when it shows it; ``seen`` is the last such."""

    _esm = (resources.files("toolkit.view") / "static" / "screen.js").read_text(encoding="utf-8")
    size = traitlets.List(traitlets.Int()).tag(sync=True)
    value = traitlets.Bytes().tag(sync=True)
    number = traitlets.Int(0).tag(sync=True)
    seen = traitlets.Int(0)

    def __init__(self, size: tuple[int, int]):
        super().__init__(size=list(size))
        self.on_msg(self._answered)

    def put(self, picture: Image.Image) -> None:
        """Show another picture."""
        buffer = io.BytesIO()
        picture.save(buffer, "JPEG", quality=QUALITY)
        with self.hold_sync():
            self.value, self.number = buffer.getvalue(), self.number + 1

    def _answered(self, _widget, message: dict, _buffers) -> None:
        self.seen = message["number"]
