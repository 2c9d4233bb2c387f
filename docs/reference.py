"""The pages of the API reference, one for each module, from what the package exports; `conf.py` puts them into `api/`."""

import importlib
import inspect
import pkgutil
import sys
from dataclasses import dataclass
from pathlib import Path

#: Modules in the order of the README's map; those inside a package follow from it.
GROUPS = {
    "Motion and files": ("motion", "io", "datasets"),
    "From motion to numbers": ("phases", "features"),
    "Networks and training": ("networks", "training", "published"),
    "The character under control": ("runtime", "styles"),
    "Restyling a clip": ("stylization",),
    "Measures, pictures and exports": ("evaluation", "view", "export"),
    "The command line": ("cli",),
}
INTRODUCTION = """
Made from the docstrings. ``import toolkit as tk``; a name that a package passes on, such as ``tk.phases.Hybrid``, is
described on the package's page. Shapes are written ``[F, J, 3]``: B batch, F frames, J joints, K experts, D features.
Metres, seconds, radians; Y up, left is +X. The command line describes itself: ``python -m toolkit VERB --help``.
"""


@dataclass(frozen=True)
class Page:
    """What a module's page describes: its own names, those described on other pages, and the modules inside a package."""

    name: str
    own: list[str]
    elsewhere: list[str]
    modules: list[str]

    @classmethod
    def of(cls, name: str) -> "Page":
        """The page of a module by its full name."""
        module = importlib.import_module(name)
        own, elsewhere = [], []
        for n in getattr(module, "__all__", vars(module)):
            value = getattr(module, n)
            if n.startswith("_") or inspect.ismodule(value):
                continue
            code = inspect.isclass(value) or inspect.isroutine(value)
            page = home(value) if code else name
            if page == name:
                own.append(n)
            elif page.startswith("toolkit") and (value.__module__ == name or hasattr(module, "__all__")):
                elsewhere.append(f"{page}.{n}")
        inside = pkgutil.iter_modules(getattr(module, "__path__", []), f"{name}.")
        return cls(name, own, elsewhere, [m.name for m in inside])

    @property
    def shadowed(self) -> bool:
        """Whether its package has something else of the same name, as `toolkit.phases.sinusoids` is a function too."""
        package, _, last = self.name.rpartition(".")
        return not inspect.ismodule(getattr(sys.modules[package], last))

    def text(self) -> str:
        """The page as reStructuredText."""
        lines = [self.name, "=" * len(self.name), "", f".. automodule:: {self.name}"]
        lines += [f"   :members: {', '.join(self.own)}" if self.own else "   :no-members:"]
        lines += ["   :no-index:"] * self.shadowed
        if self.elsewhere:
            lines += ["", f"Described elsewhere: {', '.join(f'`{name}`' for name in self.elsewhere)}."]
        if self.modules:
            lines += ["", ".. rubric:: Modules", "", *table(self.modules)]
        return "\n".join([*lines, ""])


def home(value) -> str:
    """The module on whose page a function or class is described: a package that passes it on, or where it is defined."""
    parts = value.__module__.split(".")
    packages = [".".join(parts[:k]) for k in range(2, len(parts))]
    passing = [p for p in packages if value.__name__ in getattr(sys.modules[p], "__all__", ())
               and getattr(sys.modules[p], value.__name__) is value]
    return passing[0] if passing else value.__module__


def table(modules: list[str]) -> list[str]:
    """Modules with the first line of their docstrings, and the tree that puts their pages below this one."""
    lines = [".. list-table::", "   :widths: 30 70", ""]
    for name in modules:
        first = inspect.getdoc(importlib.import_module(name)).splitlines()[0]
        lines += [f"   * - :doc:`{name} <{name}>`", f"     - {first}"]
    return [*lines, "", ".. toctree::", "   :hidden:", "", *(f"   {name}" for name in modules)]


def pages() -> dict[str, str]:
    """All pages, the index first: file name and text."""
    title = "API reference"
    index = [title, "=" * len(title), INTRODUCTION]
    waiting = []
    for group, modules in GROUPS.items():
        names = [f"toolkit.{m}" for m in modules]
        index += [group, "-" * len(group), "", *table(names), ""]
        waiting += names
    texts = {"index.rst": "\n".join(index)}
    while waiting:
        page = Page.of(waiting.pop())
        texts[f"{page.name}.rst"] = page.text()
        waiting += page.modules
    return texts


def put(folder: Path, texts: dict[str, str]) -> None:
    """Write files into a folder that is for them alone; one that has not changed is not touched, one not named goes."""
    folder.mkdir(exist_ok=True)
    for path in folder.iterdir():
        if path.is_file() and path.name not in texts:
            path.unlink()
    for name, text in texts.items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
