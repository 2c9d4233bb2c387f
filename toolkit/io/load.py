"""Motion of any format: `load` gives a clip in metres with Y up, `inspect` says what was found and guessed."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from toolkit.io import interpretation
from toolkit.io.recording import Recording
from toolkit.motion import Clip, contacts
from toolkit.motion.roles import ROLES, SIDES

READERS = {  # by suffix: module with ``read(path) -> Recording``, imported when it is first used
    ".bvh": "toolkit.io.bvh", ".glb": "toolkit.io.gltf", ".gltf": "toolkit.io.gltf",
    ".vrm": "toolkit.io.gltf", ".vrma": "toolkit.io.gltf", ".fbx": "toolkit.io.fbx", ".amc": "toolkit.io.amc",
    ".npz": "toolkit.io.npz", ".npy": "toolkit.io.npz",
}


def load(path: str | os.PathLike, unit: float | str = "auto", up: str = "auto", roles: Mapping[str, str] | None = None, *,
         style: str = "", gait: str = "") -> Clip:
    """Read a motion file as a clip in metres, seconds and with Y up.

    Unit and up axis are found from the body: people are 1.3 to 2.1 m tall, and their heads are above their feet. Roles are
    found from the joints' names and the tree. What is doubtful is said in one UserWarning, which names the option that
    decides; with ``unit`` and ``up`` given, nothing is guessed and nothing is said. The floor is not moved.

    Parameters
    ----------
    path : a file of one of the formats in `READERS`
    unit : metres of one unit of length in the file, a name of `toolkit.io.interpretation.UNITS`, or "auto"
    up : the file's axis that points up: "x", "y", "z", "-x", "-y", "-z", or "auto"
    roles : joints by role (`toolkit.motion.ROLES`), in place of those that were found
    style, gait : labels for the clip

    Raises
    ------
    ValueError
        If the format is unknown, the file cannot be read, or unit, up or roles do not fit.
    """
    path = Path(path)
    return interpretation.load(read(path), path, unit, up, roles, style, gait)


def read(path: str | os.PathLike) -> Recording:
    """The motion in a file, in its own unit and axes; ValueError in one line if it cannot be read."""
    path = Path(path)
    if path.suffix.lower() not in READERS:
        raise ValueError(f"{path.name}: no reader for this kind of file; there are readers for {', '.join(READERS)}")
    try:
        reader = import_module(READERS[path.suffix.lower()])
    except ModuleNotFoundError as error:
        raise ValueError(f"{path.name}: the reader of {path.suffix} files needs {error.name}") from error
    return reader.read(path)


@dataclass(frozen=True, eq=False)
class Inspection:
    """A motion file as `toolkit.load` reads it; ``print`` shows all of it."""

    name: str  # of the file
    format: str
    clip: Clip
    height: float  # metres, of the standing body along its bones; NaN if it has no legs or head
    unit: float  # metres of one unit of the file
    up: str  # axis of the file that points up
    floor: float  # metres: height of a toe that stands, in the middle of the clip; NaN without toes
    drift: float  # metres: change of that height over the clip
    roles: dict[str, str]  # joint by role
    rules: dict[str, str]  # by role: what showed it
    mirror_pairs: dict[str, str]  # left joint: right joint
    contact: dict[str, float]  # share of frames in contact, right and left; empty without toes
    upright: bool  # whether the head is above the feet in most frames
    doubts: list[str]  # guesses that are not safe, empty where all are

    @property
    def fps(self) -> float:
        """Frames per second."""
        return self.clip.fps

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of all joints, without End Sites."""
        skeleton = self.clip.skeleton
        return tuple(name for name in skeleton.names if name not in skeleton.ends)

    def __repr__(self) -> str:
        found = {part: "/".join(dict.fromkeys(self.rules.get(f"{side}_{part}", "not found") for side in SIDES))
                 for part in dict.fromkeys(role.split("_")[-1] for role in ROLES[1:])}
        rows = [
            ("file", f"{self.name}, {self.format}"),
            ("motion", f"{len(self.clip)} frames at {self.fps:g} Hz, {self.clip.seconds:.1f} s"),
            ("joints", f"{len(self.joints)}, and {len(self.clip.skeleton.ends)} End Sites"),
            ("unit", f"{interpretation.named(self.unit)}"), ("up", self.up), ("height", f"{self.height:.2f} m"),
            ("floor", f"toes stand at {self.floor:.3f} m, {100 * self.drift:+.1f} cm over the clip"),
            ("upright", "yes" if self.upright else "no"),
            ("contact", ", ".join(f"{side} {share:.0%}" for side, share in self.contact.items()) or "no toes"),
            ("pairs", f"{len(self.mirror_pairs)} of left and right joints"),
            ("hips", f"{self.roles.get('hips', '—')} ({self.rules.get('hips', 'not found')})"),
            *((part, f"{self.roles.get(f'left_{part}', '—')}, {self.roles.get(f'right_{part}', '—')} ({rule})")
              for part, rule in found.items()),
            *(("doubt", doubt) for doubt in self.doubts),
        ]
        return "\n".join(f"{name:<10}{value}" for name, value in rows)


def inspect(path: str | os.PathLike, unit: float | str = "auto", up: str = "auto",
            roles: Mapping[str, str] | None = None) -> Inspection:
    """What a motion file holds, and how `toolkit.load` understands it with the same arguments; see there for the errors."""
    path = Path(path)
    recording = read(path)
    clip, found = interpretation.interpret(recording, path, unit, up, roles)
    skeleton = clip.skeleton
    feet = all(f"{side}_toe" in skeleton.roles for side in SIDES)
    pairs = {skeleton.names[a]: skeleton.names[b] for a, b in enumerate(skeleton.mirror_pairs) if a != b}
    left = {role: joint for role, joint in skeleton.roles.items() if role.startswith("left")}
    first = {joint for joint in pairs if joint in left.values()}
    order = skeleton.names.index
    named = {a: b for a, b in pairs.items() if a in first or (b not in first and order(a) < order(b))}
    return Inspection(
        clip.name, recording.format, clip, found.height, found.unit, found.up, found.floor, found.drift, skeleton.roles,
        found.rules, named, dict(zip(contacts.FEET, contacts.detect(clip).mean(0).tolist(), strict=True)) if feet else {},
        found.upright, found.doubts)
