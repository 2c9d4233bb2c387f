"""The browser and the notebook around a widget: its files, whether there is a notebook, its event loop and main thread."""

import asyncio
import sys
import threading
from importlib import resources


def static(name: str) -> str:
    """Text of a file for the browser."""
    return (resources.files("toolkit.view") / "static" / name).read_text(encoding="utf-8")


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
