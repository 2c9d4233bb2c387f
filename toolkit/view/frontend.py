"""What widgets share: files for the browser, the notebook's event loop and main thread, a picture that changes often."""

import asyncio
import html
import io
import json
import sys
import threading
from importlib import resources
from typing import Any

import anywidget
import traitlets
from PIL import Image

from toolkit.motion.names import printable

QUALITY = 88  # of the JPEG of a screen


def static(name: str) -> str:
    """Text of a file for the browser."""
    return (resources.files("toolkit.view") / "static" / name).read_text(encoding="utf-8")


def escape(text: object) -> str:
    """A text as HTML shows it, and plotly, which reads some tags in names and labels."""
    return html.escape(printable(text))


def embed(data: Any) -> str:
    """JSON for a script element: no text in it can end the element or start a comment."""
    return json.dumps(data, allow_nan=False).replace("<", "\\u003c")


def in_notebook() -> bool:
    """Whether the program runs in a Jupyter kernel."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    return getattr(shell, "kernel", None) is not None


def running_loop() -> asyncio.AbstractEventLoop | None:
    """The event loop of the notebook; None in a script, where every change is drawn at once."""
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None


def require_main_thread() -> None:
    """Raise RuntimeError outside of the main thread, where VTK draws wrong pictures without an error."""
    if threading.current_thread() is not threading.main_thread():
        raise RuntimeError("the player draws in the main thread only; call it from there (loop.call_soon_threadsafe)")


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
