"""What `toolkit.load` finds and guesses about a motion file, printable."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from toolkit.extra.formats.interpretation import Findings, interpret, named
from toolkit.io.load import read
from toolkit.motion import Clip, contacts
from toolkit.motion.roles import ROLES, SIDES


@dataclass(eq=False, kw_only=True)
class Inspection(Findings):
    """A motion file as `toolkit.load` reads it; ``print`` shows all of it."""

    name: str  # of the file
    format: str
    clip: Clip
    contact: dict[str, float]  # share of frames in contact, right and left; empty without toes

    @property
    def roles(self) -> dict[str, str]:
        """Joint by role."""
        return self.clip.skeleton.roles or {}

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
        clip, roles, rules = self.clip, self.roles, self.rules
        contact = ", ".join(f"{side} {share:.0%}" for side, share in self.contact.items())
        hips = f"{roles.get('hips', '—')} ({rules.get('hips', 'not found')})"
        pairs = sum(a < b for a, b in enumerate(clip.skeleton.mirror_pairs))
        rows = [
            ("file", f"{self.name}, {self.format}"),
            ("motion", f"{len(clip)} frames at {self.fps:g} Hz, {clip.seconds:.1f} s"),
            ("joints", f"{len(self.joints)}, and {len(clip.skeleton.ends)} End Sites"),
            ("unit", named(self.unit)),
            ("up", self.up),
            ("height", f"{self.height:.2f} m" if self.height > 0 else "no legs found"),
            ("floor", f"toes stand at {self.floor:.3f} m, "
                      f"{100 * self.drift:+.1f} cm over the clip"),
            ("upright", "yes" if self.upright else "no"),
            ("contact", contact or "no toes"),
            ("pairs", f"{pairs} of left and right joints"),
            ("hips", hips),
        ]
        for part in dict.fromkeys(role.split("_")[-1] for role in ROLES[1:]):
            both = [f"{side}_{part}" for side in SIDES]
            said = "/".join(dict.fromkeys(rules.get(role, "not found") for role in both))
            rows.append((part, f"{', '.join(roles.get(role, '—') for role in both)} ({said})"))
        rows += [("doubt", doubt) for doubt in self.doubts]
        return "\n".join(f"{name:<10}{value}" for name, value in rows)


def inspect(path: str | os.PathLike, unit: float | str = "auto", up: str = "auto",
            roles: Mapping[str, str] | None = None,
            animation: str | int | None = None) -> Inspection:
    """What a motion file holds, and how `toolkit.load` understands it with the same arguments."""
    path = Path(path)
    recording = read(path, animation)
    clip, found = interpret(recording, path, unit, up, roles)
    contact = {}
    if clip.skeleton.has("toe"):
        shares = contacts.detect(clip).mean(0).tolist()
        contact = dict(zip(contacts.FEET, shares, strict=True))
    return Inspection(**vars(found), name=clip.name, format=recording.format, clip=clip,
                      contact=contact)
