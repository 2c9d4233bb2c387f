"""What widgets share: files for the browser, the notebook's event loop and main thread, a picture
that changes often.
"""

import asyncio
import html
import io
import json
import sys
import threading
import weakref
from collections.abc import Iterator
from importlib import resources
from typing import Any, ClassVar

import anywidget
import ipywidgets as widgets
import traitlets
from PIL import Image

from toolkit.motion.text import printable

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
    """Raise RuntimeError outside of the main thread, where VTK draws wrong pictures without an
    error.
    """
    if threading.current_thread() is not threading.main_thread():
        raise RuntimeError(
            "the player draws in the main thread only; call it from there "
            "(loop.call_soon_threadsafe)"
        )


class CellWidget(widgets.Widget):
    """A widget that is closed, with all its parts, when the notebook cell that made it runs again.

    No page shows it then.
    """

    # By cell: its last run, and what that made.
    _made: ClassVar[dict[str, tuple[str, list[weakref.ref]]]] = {}

    def __init__(self, *arguments, **traits):
        super().__init__(*arguments, **traits)
        parent = sys.modules["IPython"].get_ipython().kernel.get_parent() if in_notebook() else {}
        if cell := parent.get("metadata", {}).get("cellId"):
            run, made = self._made.get(cell, ("", []))
            if run != parent["header"]["msg_id"]:
                for widget in filter(None, [reference() for reference in made]):
                    widget.close()
                made = []
                self._made[cell] = parent["header"]["msg_id"], made
            made.append(weakref.ref(self))

    def close(self) -> None:
        """Remove the widget and its parts, which ipywidgets would keep."""
        for part in _parts(self):
            part.close()
        super().close()


def _parts(widget: widgets.Widget) -> Iterator[widgets.Widget]:
    """What a widget consists of: its children, their layouts and styles, the innermost first."""
    for value in [*widget._trait_values.values()]:
        for part in value if isinstance(value, tuple) else (value,):
            if isinstance(part, widgets.Widget):
                yield from _parts(part)
                yield part


class Screen(anywidget.AnyWidget):
    """The picture ``number`` as JPEG ``value``.

    ``seen`` is the number of the last picture that the page has shown.
    """

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
