"""Names of what an add-on gives to the core: readers of files, phase sources, verbs and more.

The core never imports `toolkit.extra`. It asks for a name here, and the module behind the name is
imported when it is first used. Packages of your own can register names as well:

>>> from toolkit import registry
>>> registry.register("source.hips", "my_package.sources:hips")

Then ``toolkit.phases.extract(clip, source="hips")`` uses the function.
"""

import pkgutil
from collections.abc import Callable, Iterable
from importlib import import_module
from typing import Any

import lazy_loader

_found: dict[str, Any] = {}  # by name: "module:attribute", or the part itself


def register(name: str, part: Any) -> None:
    """Give a name, such as ``"reader.fbx"``, to a part.

    The part is ``"module:attribute"``, or the object itself.
    """
    _found[name] = part


def names(kind: str) -> tuple[str, ...]:
    """The registered names of a kind: ``names("reader")`` may be ``("fbx", "glb")``."""
    return tuple(name.removeprefix(f"{kind}.") for name in _found if name.startswith(f"{kind}."))


def find(name: str) -> Any:
    """The part behind a name, imported if need be.

    Raises
    ------
    ValueError
        If nothing is registered under the name, or a package that it needs is not installed.
    """
    if name not in _found:
        kind, _, short = name.partition(".")
        known = ", ".join(names(kind)) or "none"
        raise ValueError(f"no {kind} named {short!r} is registered; there is {known}")
    part = _found[name]
    if isinstance(part, str):
        module, _, attribute = part.partition(":")
        try:
            part = getattr(import_module(module), attribute) if attribute else import_module(module)
        except ModuleNotFoundError as error:
            problem = f"{name} needs the package {error.name}, which is not installed"
            raise ValueError(problem) from error
        _found[name] = part
    return part


def attributes(package: str, otherwise: Callable[[str], Any] | None = None) -> Callable[[str], Any]:
    """A ``__getattr__`` for a package of the core: names that it does not have are looked up here.

    ``registry.register("toolkit.runtime.compile", …)`` makes ``toolkit.runtime.compile`` work.
    """
    def attribute(name: str) -> Any:
        full = f"{package}.{name}"
        if full in _found:
            return find(full)
        if otherwise is not None:
            return otherwise(name)
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return attribute


def modules(package: str, path: Iterable[str],
            names: dict[str, list[str]] | None = None) -> tuple[Callable, Callable, list[str]]:
    """``__getattr__``, ``__dir__`` and ``__all__`` of a package that imports on first use.

    It has the modules in its folder, and ``names`` by the module that defines them.
    """
    return lazy_loader.attach(package, [found.name for found in pkgutil.iter_modules(path)], names)
