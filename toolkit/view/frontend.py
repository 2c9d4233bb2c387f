"""What widgets share: files for the browser, the notebook's event loop, a picture for pages without
a kernel.
"""

import asyncio
import base64
import html
import json
import uuid
import weakref
from collections.abc import Iterator
from importlib import resources
from typing import Any, ClassVar

import anywidget
import ipywidgets as widgets
import traitlets
from IPython.display import HTML, display

from toolkit.io.progress import kernel
from toolkit.motion.text import printable

# Beside a widget; its code in the page hides this (scene/index.js).
STILL = """<div class="tk-still"><img src="data:image/png;base64,{picture}" style="max-width: 100%"
 alt="{name}"><br>A picture: there is no kernel here. Run the notebook for the {name}.</div>"""


STATIC = resources.files("toolkit.view") / "static"


def static(name: str) -> str:
    """Text of a file for the browser."""
    return (STATIC / name).read_text(encoding="utf-8")


def escape(text: object) -> str:
    """A text as HTML shows it, and plotly, which reads some tags in names and labels."""
    return html.escape(printable(text))


def embed(data: Any) -> str:
    """JSON for a script element: no text in it can end the element or start a comment."""
    return json.dumps(data, allow_nan=False).replace("<", "\\u003c")


def in_notebook() -> bool:
    """Whether the program runs in a Jupyter kernel."""
    return kernel() is not None


def running_loop() -> asyncio.AbstractEventLoop | None:
    """The event loop of the notebook; None in a script, where every change is drawn at once."""
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None


class CellWidget(widgets.Widget):
    """A widget that is closed, with all its parts, when the notebook cell that made it runs again.

    No page shows it then.
    """

    # By cell: its last run, and what that made.
    _made: ClassVar[dict[str, tuple[str, weakref.WeakSet]]] = {}

    def __init__(self, *arguments, **traits):
        super().__init__(*arguments, **traits)
        parent = kernel().get_parent() if in_notebook() else {}
        if cell := parent.get("metadata", {}).get("cellId"):
            run, made = self._made.get(cell, ("", weakref.WeakSet()))
            if run != parent["header"]["msg_id"]:
                for widget in list(made):
                    widget.close()
                    _forget(widget)
                made = weakref.WeakSet()
                self._made[cell] = parent["header"]["msg_id"], made
            made.add(self)

    def __repr__(self) -> str:
        """What a page without a kernel shows below the picture."""
        return f"{type(self).__name__}, a widget"

    def still(self) -> bytes:
        """A picture of such a widget, PNG."""
        return (STATIC / f"{type(self).__name__.lower()}.png").read_bytes()

    def _repr_mimebundle_(self, **kwargs):
        """The widget; above it, the page gets its picture, which is seen where nothing runs it."""
        picture = base64.b64encode(self.still()).decode("ascii")
        display(HTML(STILL.format(picture=picture, name=type(self).__name__)))
        return super()._repr_mimebundle_(**kwargs)

    def close(self) -> None:
        """Remove the widget and its parts, which ipywidgets would keep."""
        for part in _parts(self):
            part.close()
        super().close()


class PageWidget(anywidget.AnyWidget):
    """A widget drawn by ``code``, a JavaScript module whose default export has ``render``."""

    _esm = static("widget.js")
    code = traitlets.Unicode().tag(sync=True)
    key = traitlets.Unicode().tag(sync=True)  # by which the page finds the widget's model

    def __init__(self, **traits):
        key = uuid.uuid4().hex
        super().__init__(key=key, model_id=key, **traits)


class SceneWidget(CellWidget, PageWidget):
    """A widget that the code of the scene draws."""

    code = traitlets.Unicode(static("scene.js")).tag(sync=True)


def _forget(result: object) -> None:
    """Take a result out of IPython's, which hold it in ``Out`` and under names such as ``_1``."""
    shell = kernel().shell
    results = shell.user_ns["_oh"]
    for number in [number for number, kept in results.items() if kept is result]:
        del results[number]
        for names in (shell.user_ns, shell.user_ns_hidden):
            names.pop(f"_{number}", None)


def _parts(widget: widgets.Widget) -> Iterator[widgets.Widget]:
    """What a widget consists of: its children, their layouts and styles, the innermost first."""
    for value in [*widget._trait_values.values()]:
        for part in value if isinstance(value, tuple) else (value,):
            if isinstance(part, widgets.Widget):
                yield from _parts(part)
                yield part
