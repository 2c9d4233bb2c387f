"""The pages of the API reference, one for each module, from the names that it exports.

`conf.py` writes them to `api/`.
"""

import importlib
import inspect
import pkgutil
import sys
from dataclasses import dataclass
from pathlib import Path

#: Modules in the order of the README's table; modules inside a package are found.
GROUPS = {
    "Motion and files": ("motion", "io", "datasets"),
    "From motion to numbers": ("phases", "features"),
    "Networks and training": ("networks", "training"),
    "Runtime and styles": ("runtime", "styles"),
    "Motion stylisation": ("stylization",),
    "Measures and pictures": ("evaluation", "view"),
    "Add-ons": ("registry", "extra"),
    "The command line": ("cli",),
}
INTRODUCTION = """
These pages are made from the docstrings. ``tk`` stands for ``toolkit``. If a package exports a
name of one of its modules, such as ``tk.phases.Hybrid``, the page of the package describes it.
Shapes are written ``[F, J, 3]``, with B for batch, F for frames, J for joints, K for experts and D
for features. Units are metres, seconds and radians; Y is up, and +X is the left side.
``python -m toolkit VERB --help`` describes the command line.
"""


@dataclass(frozen=True)
class Page:
    """The contents of a module's page.

    These are its own names, names that another page describes, and the modules of a package.
    """

    name: str
    own: list[str]
    elsewhere: list[str]
    modules: list[str]

    @classmethod
    def of(cls, name: str) -> "Page":
        """Collect the page of a module, given by its full name."""
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
            elif page.startswith("toolkit") and (
                value.__module__ == name or hasattr(module, "__all__")
            ):
                elsewhere.append(f"{page}.{n}")
        inside = pkgutil.iter_modules(getattr(module, "__path__", []), f"{name}.")
        return cls(name, own, elsewhere, [m.name for m in inside])

    @property
    def shadowed(self) -> bool:
        """Whether its package exports a function or class of the same name."""
        package, _, last = self.name.rpartition(".")
        return not inspect.ismodule(getattr(sys.modules[package], last))

    def text(self) -> str:
        """The page as reStructuredText."""
        lines = [self.name, "=" * len(self.name), "", f".. automodule:: {self.name}"]
        lines += [f"   :members: {', '.join(self.own)}" if self.own else "   :no-members:"]
        lines += ["   :no-index:"] * self.shadowed
        if self.elsewhere:
            lines += [
                "",
                f"Described elsewhere: {', '.join(f'`{name}`' for name in self.elsewhere)}.",
            ]
        if self.modules:
            lines += ["", ".. rubric:: Modules", "", *table(self.modules)]
        return "\n".join([*lines, ""])


def home(value) -> str:
    """The module whose page describes a function or class.

    It is a package that exports the name, else the module that defines it.
    """
    parts = value.__module__.split(".")
    packages = [".".join(parts[:k]) for k in range(2, len(parts))]
    passing = [p for p in packages if value.__name__ in getattr(sys.modules[p], "__all__", ())
               and getattr(sys.modules[p], value.__name__) is value]
    return passing[0] if passing else value.__module__


def table(modules: list[str]) -> list[str]:
    """A table of modules with the first lines of their docstrings, and a tree of their pages."""
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
    """Write files into their own folder.

    Unchanged files are not touched, and files without a text are deleted.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        if path.is_file() and path.name not in texts:
            path.unlink()
    for name, text in texts.items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
