"""A motion as a file stores it: before its unit of length and its up axis are known."""

from dataclasses import dataclass

from torch import Tensor


@dataclass(frozen=True, eq=False)
class Recording:
    """J joints over F frames in the file's unit and axes; `toolkit.load` makes a `Clip` of it."""

    format: str  # name of the file format: "BVH", "glTF" …
    names: tuple[str, ...]  # J, unique
    parents: tuple[int, ...]  # the root comes first with -1
    offsets: Tensor  # [J, 3] from the parent, in its frame, in the file's unit, float64
    rotations: Tensor  # [F, J, 4] local, w first
    root_positions: Tensor  # [F, 3] in the file's unit and axes, float64
    fps: float  # frames per second, as the file says
    ends: tuple[str, ...] = ()  # leaves that are End Sites
    unit: float | None = None  # metres of one unit where the format or the file says so
    up: str | None = None  # "x", "y" or "z" where the format or the file says so
    roles: dict[str, str] | None = None  # from a role to a joint where the file says so (VRM)
    doubts: tuple[str, ...] = ()  # what the reader assumed, left out or rounded; one sentence each
