"""One self-contained HTML file that plays clips in any browser.

No network, no installation, made without OpenGL.
"""

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from string import Template
from types import MappingProxyType
from typing import Any

import numpy as np

from toolkit.io.files import write_whole
from toolkit.io.save import figure_of
from toolkit.motion import Clip, Skeleton, rotations as R
from toolkit.view.frontend import embed, escape, static
from toolkit.view.render import mannequin as body
from toolkit.view.render.bodies import cast, steady_frames
from toolkit.view.render.skin import Character, Figure, encoded, tree

UNIT = 32767  # int16 steps of a quaternion's component


def html(
    clips: Clip | Sequence[Clip], path: str | os.PathLike, *, title: str = "Motion",
    caption: str = "", labels=None, contacts=None, styles=None,
    character: Character = None
) -> Path:
    """Write a page with the motion of clips, which opens by double click in any browser.

    Poses are stored as 16-bit quaternions and float32 root positions: about 1 MB a minute at 60 Hz,
    beside 0.6 MB of three.js. Joints are within 0.5 mm of the clip's.

    Parameters
    ----------
    clips, labels, contacts, character
        As in `toolkit.view.play`; up to nine clips.
    title, caption
        Heading of the page and a line below it.
    styles
        Weights of a style blend over time: ``{name: [F]}``, or one such mapping (or None) per clip.
        Three styles or more are shown as a polygon with a moving marker.

    Raises
    ------
    ValueError
        If the styles do not fit the clips, or as of `toolkit.view.play`.
    """
    _, bodies, packed = pack(clips, labels, contacts, styles, figure_of(character))
    data = {"skeletons": list(bodies.values()), "clips": packed}
    return write(path, title, caption, data, "globalThis.view = toolkitScene.player(stage, data);")


def write(
    path: str | os.PathLike, title: str, caption: str, data: dict[str, Any], start: str
) -> Path:
    """Write a page with the scene's code and ``data`` in it, whole or not at all.

    ``start`` is JavaScript that starts the page, from its element ``stage``, ``data`` and the
    scene's code ``toolkitScene``.
    """
    page = Template(static("page.html")).substitute(
        title=escape(title), caption=f"<p>{escape(caption)}</p>" if caption else "",
        data=embed(data), licence=static("THREE-LICENSE").strip(), bundle=static("scene.js"),
        start=start
    )
    write_whole(path, page.encode())
    return Path(path)


def pack(
    clips: Clip | Sequence[Clip], labels, contacts, styles, figure: Figure | None,
    known: Mapping[Skeleton, dict] = MappingProxyType({})
) -> tuple[list[Clip], dict[Skeleton, dict], list[dict]]:
    """Clips, their skeletons with bodies, and their motion, as the browser's player takes them
    (``scene/player.js`` describes the format).

    Bodies that are ``known`` are not made again.
    """
    clips, labels, contacts = cast(clips, labels, contacts, figure)
    if styles is None or (isinstance(styles, Mapping) and len(clips) == 1):
        styles = [styles] * len(clips)
    if len(clips) > 9 or len(styles) != len(clips):
        raise ValueError(f"a page shows 1 to 9 clips with a style mapping each; got {len(clips)} "
                         f"clips, {len(styles)} style mappings")
    bodies: dict[Skeleton, dict] = {}
    for clip in clips:
        rig = clip.skeleton
        if rig not in bodies:
            bodies[rig] = known.get(rig) or (skeleton_data(clip) if figure is None else
                                             tree(rig) | {"mesh": figure.packed()})
    numbers = list(bodies)
    packed = [_packed(clip, *row) | {"skeleton": numbers.index(clip.skeleton)}
              for clip, *row in zip(clips, labels, contacts, styles, strict=True)]
    return clips, bodies, packed


def _packed(clip: Clip, label: str, contacts: np.ndarray | None,
            weights: Mapping | None) -> dict[str, Any]:
    """A clip without its skeleton."""
    joints = [j for j in range(len(clip.skeleton)) if not clip.skeleton.is_end(j)]
    rotations = R.unroll(R.normalize(clip.rotations[:, joints]))
    styles = None
    if weights:
        columns = [np.asarray(w, dtype=np.float64) for w in weights.values()]
        if any(c.shape != (len(clip),) for c in columns):
            raise ValueError(f"style weights must be [{len(clip)}] each; got "
                             f"{[list(c.shape) for c in columns]}")
        shares = np.stack(columns, 1).clip(0, 1)
        styles = {"names": list(weights), "weights": encoded(shares * 255, "u1")}
    return {
        "label": label,
        "fps": clip.fps,
        "frames": len(clip),
        "facing": float(steady_frames(clip)[1][0]),
        "joints": joints,
        "root": encoded(clip.root_positions, "<f4"),
        "rotations": encoded(rotations * UNIT, "<i2"),
        "contacts": None if contacts is None else encoded(contacts > 0.5, "u1"),
        "styles": styles,
    }


def skeleton_data(clip: Clip, character: Figure | None = None, *,
                  vertices: int = body.VERTICES) -> dict:
    """Skeleton and mannequin as the scene takes them (``scene/body.js`` describes the format).

    The mannequin has about as many ``vertices``. A ``character`` takes the mannequin's place and
    follows the clip's joints (``scene/figure.js``).
    """
    if character is not None:
        return tree(clip.skeleton) | {"mesh": character.packed(character.following(clip))}
    return tree(clip.skeleton) | {"mesh": body.build(clip, vertices).packed(clip.skeleton)}
