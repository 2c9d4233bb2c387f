"""Text and phase dials over a picture of a moving body."""

import colorsys
import math
from collections.abc import Sequence
from functools import cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from toolkit.motion.clip import LIMBS
from toolkit.view.picture import INK, PAPER

FINE = 3  # a dial is drawn this many times larger, then averaged
RIM = "#cfc8bb"


def write(picture: Image.Image, cell: tuple[int, int, int, int], labels: Sequence[tuple[str, str]],
          phases: Sequence[np.ndarray | None]) -> None:
    """Write names and phase dials of characters down the left side of a cell (left, top, width, height) of the picture.

    ``labels`` are text and colour of each character, ``phases`` its vectors [4, 2] (sin, cos) of the `LIMBS`, or None.
    """
    left, top, _, height = cell
    x, y = left + 10, top + 6
    for text, color in labels:
        if text:
            picture.paste(color, (x, y), _text(text, 15))
            y += 20
    size = min(max(height // 10, 16), 44)
    for (_, color), vectors in zip(labels, phases, strict=True):
        if vectors is None:
            continue
        for i, vector in enumerate(np.asarray(vectors, dtype=float)):
            place = x + 6, y + 6 + i * (size + 14)
            picture.paste(_dial(vector, size, color if len(labels) > 1 else RIM), place, _disc(size))
            text = _text(LIMBS[i].replace("_", " "), 10)
            picture.paste(INK, (round(place[0] + size / 2 - text.width / 2), place[1] + size), text)
        x += size + 20


@cache
def _text(text: str, size: int) -> Image.Image:
    font = ImageFont.load_default(size)
    mask = Image.new("L", tuple(math.ceil(x) + 1 for x in font.getbbox(text)[2:]))
    ImageDraw.Draw(mask).text((0, 0), text, 255, font)
    return mask


@cache
def _disc(size: int) -> Image.Image:
    disc = Image.new("L", (size * FINE,) * 2)
    ImageDraw.Draw(disc).ellipse((0, 0, size * FINE - 1, size * FINE - 1), fill=255)
    return disc.reduce(FINE)


def _dial(vector: np.ndarray, size: int, rim: str) -> Image.Image:
    """A hand with the phase's angle and colour, as long as the vector (1.4 m/s fill the dial)."""
    size *= FINE
    dial, middle = Image.new("RGB", (size, size), rim), size / 2
    draw = ImageDraw.Draw(dial)
    draw.ellipse((FINE, FINE, size - 1 - FINE, size - 1 - FINE), fill=PAPER)
    strength = float(np.hypot(*vector))
    end = middle + 0.8 * middle * min(1.0, 0.7 * strength) / max(strength, 1e-9) * vector * [1, -1]
    turn = np.arctan2(*vector) / (2 * np.pi) % 1.0
    color = tuple(round(255 * c) for c in colorsys.hls_to_rgb(turn, 0.45, 0.62))
    draw.line((middle, middle, *end), fill=color, width=size // 11)
    draw.circle((middle, middle), size // 22, fill=color)
    return dial.reduce(FINE)
