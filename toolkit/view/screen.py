"""A picture in a notebook that the kernel replaces many times a second."""

import io

import anywidget
import traitlets
from PIL import Image

from toolkit.view.frontend import static

QUALITY = 88  # of the JPEG


class Screen(anywidget.AnyWidget):
    """The picture ``number`` as JPEG ``value``; ``seen`` is the number of the last picture that the page has shown."""

    _esm = static("screen.js")
    size = traitlets.List(traitlets.Int()).tag(sync=True)
    value = traitlets.Bytes().tag(sync=True)
    number = traitlets.Int(0).tag(sync=True)
    seen = traitlets.Int(0)

    def __init__(self, size: tuple[int, int]):
        super().__init__(size=list(size))
        self.on_msg(lambda _widget, message, _buffers: self.set_trait("seen", message["number"]))

    def put(self, picture: Image.Image) -> None:
        """Show another picture."""
        buffer = io.BytesIO()
        picture.save(buffer, "JPEG", quality=QUALITY)
        with self.hold_sync():
            self.value, self.number = buffer.getvalue(), self.number + 1
