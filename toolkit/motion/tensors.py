"""Conversion of numbers to tensors, array functions on tensors, short representations."""

import dataclasses
import difflib
import math
import textwrap
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
import scipy
import torch
from torch import Tensor, nn

from toolkit.motion.text import printable

WIDTH, LINES, NAMES = 125, 5, 6  # columns, lines and names of a list in a representation


def as_tensor(values: Any, what: str, like: Tensor | torch.dtype | None = None) -> Tensor:
    """A tensor, an array, a number, or nested lists of them as a floating tensor.

    ``like`` is a tensor with the wanted device and dtype, or a dtype. By default a floating tensor
    is unchanged, and other values get torch's default dtype. ValueError, which names ``what``, if
    they are not numbers or rows differ in length.
    """
    if not isinstance(values, Tensor):
        try:
            if isinstance(values, list | tuple) and any(isinstance(v, Tensor) for v in values):
                values = torch.stack([as_tensor(v, what, like) for v in values])
            else:
                array = np.array(values, order="C")
                if array.dtype.kind not in "biuf":
                    array = array.astype(np.float64, casting="safe")
                values = torch.from_numpy(array)
        except (TypeError, ValueError, RuntimeError):
            raise ValueError(f"{what} must be numbers in a tensor, array or list; "
                             f"got {shown(values)}") from None
        like = torch.get_default_dtype() if like is None else like
    elif values.is_complex():
        raise ValueError(f"{what} must be real numbers, got {shown(values)}")
    elif like is None:
        like = values.dtype if values.is_floating_point() else torch.get_default_dtype()
    return values.to(like)


def through_numpy(function: Callable[[np.ndarray], np.ndarray], values: Tensor) -> Tensor:
    """Result of a function of float64 arrays, as a tensor like ``values``, without gradient."""
    made = function(values.double().cpu().numpy())
    return torch.from_numpy(np.ascontiguousarray(made)).to(values)


def at_rate(values: Tensor, old: float, new: float) -> Tensor:
    """Values ``[F, ...]`` at another rate, by cubic splines, which keep velocities continuous."""
    times = np.arange(len(values)) / old
    wanted = np.arange(math.floor(times[-1] * new + 1e-6) + 1) / new
    return through_numpy(lambda v: scipy.interpolate.CubicSpline(times, v)(wanted), values)


def summary(thing: Any, facts: Mapping[str, Any] | None = None) -> str:
    """A representation of at most `LINES` lines; ``facts`` are by default a dataclass's fields."""
    if facts is None:
        facts = {f.name: getattr(thing, f.name) for f in dataclasses.fields(thing)}
    inside = ", ".join(f"{name}={shown(value)}" for name, value in facts.items())
    return textwrap.fill(f"{type(thing).__name__}({inside})", WIDTH, subsequent_indent="    ",
                         max_lines=LINES, placeholder=" …)", break_on_hyphens=False)


def shown(value: Any) -> str:
    """A short text for a value: a tensor's shape and unusual dtype or device; the first names."""
    match value:
        case Tensor():
            odd = (str(value.dtype).removeprefix("torch."), str(value.device))
            odd = [word for word in odd if word not in ("float32", "cpu")]
            return " ".join((str(list(value.shape)), *odd))
        case np.ndarray():
            return f"array {list(value.shape)} {value.dtype}"
        case nn.Module():
            return type(value).__name__
        case str() if len(value) <= 60:
            return repr(value)
        case float():
            return f"{value:g}"
        case Mapping():
            return "{" + few(printable(f"{name}: {shown(v)}" if isinstance(v, Tensor)
                                       else str(name)[:60]) for name, v in value.items()) + "}"
        case list() | tuple():
            inside = (printable(v[:60]) if isinstance(v, str) else shown(v) for v in value)
            return "(" + few(inside) + ")"
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:59] + "…"


def few(names: Iterable[str]) -> str:
    """The first `NAMES` names, and how many more there are."""
    names = list(names)
    more = f" and {len(names) - NAMES} more" if len(names) > NAMES else ""
    return ", ".join(names[:NAMES]) + more


def similar(name: object, known: Iterable[str]) -> list[str]:
    """At most three known names that are like a name, in any case."""
    spelt = {one.lower(): one for one in known}
    return [spelt[one] for one in difflib.get_close_matches(str(name).lower(), spelt, cutoff=0.5)]
