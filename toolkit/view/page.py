"""One self-contained HTML file that plays clips in any browser: no network, no installation, made without OpenGL."""

import base64
import html as escaping
import json
import os
from collections.abc import Mapping, Sequence
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import torch

from toolkit.io.files import atomic_write
from toolkit.motion import Clip, on_cpu
from toolkit.motion import rotations as R
from toolkit.view import body
from toolkit.view.picture import contact_list, label, steady_frames

UNIT = 32767  # int16 steps of a quaternion's component

PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>
html, body {{ height: 100dvh; margin: 0; }}
body {{ display: flex; flex-direction: column; gap: 12px; padding: 16px 20px 20px; box-sizing: border-box;
  background: #e9e6df; color: #2b323b; font: 14px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }}
h1 {{ font-size: 20px; margin: 0; letter-spacing: -0.01em; }}
header p {{ margin: 2px 0 0; color: #5d6570; max-width: 100ch; }}
main {{ flex: 1; min-height: 0; }}
@media (max-width: 700px), (max-height: 500px) {{ body {{ gap: 8px; padding: 10px 12px; }} header p {{ font-size: 12px; }} }}
@media (max-height: 500px) {{ header p {{ display: none; }} }}
</style>
</head>
<body>
<header><h1>{title}</h1>{caption}</header>
<main id="stage"></main>
<noscript>This page draws the motion with JavaScript, which is switched off here.</noscript>
<script type="application/json" id="data">{data}</script>
<script>/* three.js, MIT licence:
{licence}
*/</script>
<script type="module">{bundle}</script>
<script type="module">
const stage = document.getElementById("stage"), data = JSON.parse(document.getElementById("data").textContent);
{start}
</script>
</body>
</html>
"""


def html(clips: Clip | Sequence[Clip], path: str | os.PathLike, *, title: str, caption: str = "", labels=None, contacts=None,
         styles=None) -> Path:
    """Write an animation that opens by double click in any browser.

    Poses are stored as 16-bit quaternions and float32 root positions: about 1 MB a minute at 60 Hz, beside 0.6 MB of
    three.js. Joints are within 0.5 mm of the clip's.

    Parameters
    ----------
    clips
        One clip, or up to nine that are shown side by side.
    path
        The file to write.
    title, caption
        Heading of the page and a line below it.
    labels
        Text on each clip; by default its style and gait, else its name.
    contacts
        Foot contacts [F, 2] (right, left), above one half where a foot stands, or one array (or None) per clip.
    styles
        Weights of a style blend over time: ``{name: [F]}``, or one such mapping (or None) per clip. Three styles or more are
        shown as a polygon with a moving marker.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ValueError
        If labels, contacts or styles do not fit the clips.
    """
    clips = on_cpu(clips)
    labels = [label(clip) for clip in clips] if labels is None else list(labels)
    styles = [styles] * len(clips) if styles is None or (isinstance(styles, Mapping) and len(clips) == 1) else list(styles)
    if not 1 <= len(clips) <= 9 or len(labels) != len(clips) or len(styles) != len(clips):
        raise ValueError(f"a page shows 1 to 9 clips with a label and a style mapping each; got {len(clips)} clips, "
                         f"{len(labels)} labels, {len(styles)} style mappings")
    rows = zip(clips, labels, contact_list(contacts, clips), styles, strict=True)
    packed = [pack(*row) for row in rows]
    return write(path, title, caption, {"clips": packed}, "globalThis.view = toolkitScene.player(stage, data);")


def write(path: str | os.PathLike, title: str, caption: str, data: dict[str, Any], start: str) -> Path:
    """Write a page with the scene's code in it, whole or not at all.

    Parameters
    ----------
    path
        The file.
    title, caption
        Heading of the page and a line below it.
    data
        What JSON can hold.
    start
        JavaScript that finds the page's element as ``stage``, ``data`` and the scene's code as ``toolkitScene``.
    """
    static = resources.files("toolkit.view") / "static"
    page = PAGE.format(
        title=escaping.escape(title),
        caption=f"<p>{escaping.escape(caption)}</p>" if caption else "",
        data=json.dumps(data, allow_nan=False).replace("</", "<\\/"),
        licence=(static / "THREE-LICENSE").read_text(encoding="utf-8").strip(),
        bundle=(static / "scene.js").read_text(encoding="utf-8"),
        start=start,
    )
    with atomic_write(path) as file:
        file.write(page.encode())
    return Path(path)


def pack(clip: Clip, text: str, contacts: np.ndarray | None = None, weights: Mapping | None = None) -> dict:
    """A clip as the browser's player takes it (the format is described in ``scene/player.js``)."""
    skeleton = clip.skeleton
    joints = [j for j in range(len(skeleton)) if not skeleton.is_end(j)]
    rotations = R.unroll(R.normalize(clip.rotations[:, joints]))
    styles = None
    if weights:
        columns = [np.asarray(w, dtype=np.float64) for w in weights.values()]
        if any(c.shape != (len(clip),) for c in columns):
            raise ValueError(f"style weights must be [{len(clip)}] each; got {[list(c.shape) for c in columns]}")
        styles = {"names": list(weights), "weights": _base64(np.clip(np.stack(columns, 1), 0, 1) * 255, np.uint8)}
    return {
        "label": text,
        "fps": clip.fps,
        "frames": len(clip),
        "facing": float(steady_frames(clip, 0.5)[1][0]),
        "skeleton": skeleton_data(clip),
        "joints": joints,
        "root": _base64(clip.root_positions.numpy(), np.float32),
        "rotations": _base64(rotations.numpy() * UNIT, np.int16),
        "contacts": None if contacts is None else _base64(contacts > 0.5, np.uint8),
        "styles": styles,
    }


def skeleton_data(clip: Clip) -> dict:
    """Skeleton and mannequin as the browser's scene takes them (see ``scene/scene.js``)."""
    return {
        "parents": list(clip.skeleton.parents),
        "offsets": [[round(x, 6) for x in offset] for offset in clip.skeleton.offsets.tolist()],
        "shapes": [
            {"joint": s.joint, "place": s.place.round(6).ravel().tolist(), "length": round(s.length, 6),
             "radii": [round(r, 6) for r in s.radii], "color": body.COLORS[s.tone], "foot": s.foot,
             "bends": [{"joint": b.joint, "place": b.place.round(6).ravel().tolist(), "at": round(b.at, 6),
                        "width": round(b.width, 6)} for b in s.bends]}
            for s in body.build(clip)
        ],
    }


def unpack(packed: Mapping, clip: Clip) -> Clip:
    """The clip that a packed one describes, on the same skeleton: inverse of `pack` up to its rounding."""
    rotations = R.identity(packed["frames"], len(clip.skeleton))
    values = np.frombuffer(base64.b64decode(packed["rotations"]), np.int16).reshape(packed["frames"], -1, 4)
    rotations[:, packed["joints"]] = R.normalize(torch.from_numpy(values / UNIT).float())
    root = np.frombuffer(base64.b64decode(packed["root"]), np.float32).reshape(-1, 3)
    return clip.replace(rotations=rotations, root_positions=torch.from_numpy(root.copy()), fps=packed["fps"])


def _base64(values, dtype: type) -> str:
    values = np.asarray(values)
    values = values.round() if np.issubdtype(dtype, np.integer) else values
    return base64.b64encode(np.ascontiguousarray(values, dtype=dtype).tobytes()).decode("ascii")
