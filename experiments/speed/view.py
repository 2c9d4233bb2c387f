"""Speed of drawing, encoding and slider response, off screen: the OpenGL renderer compared with the software renderer."""

import asyncio
import io
import time
from collections.abc import Callable
from typing import Annotated

import numpy as np
import torch
import typer
from PIL import Image

TARGET = 60.0  # pyvista pictures per second of one character at 1024 x 768
LATENCY = 80.0  # milliseconds from slider to picture, with the browser's part, which is not measured here


def run(
    frames: Annotated[int, typer.Option(help="Pictures per measurement.")] = 200,
    width: Annotated[int, typer.Option(help="Pixels.")] = 1024,
    height: Annotated[int, typer.Option(help="Pixels.")] = 768,
) -> None:
    """Pictures per second of the OpenGL renderer, compared with the software renderer and a target; slider latency.

    Wall times include other load on the machine; CPU times do not.
    """
    from toolkit import datasets
    from toolkit.motion import contacts
    from toolkit.view import renderers
    from toolkit.view.frontend import QUALITY
    from toolkit.view.opengl import opengl_works
    from toolkit.view.player import Player

    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    clips = [datasets.load("procedural", styles=[style], gaits=["FW"], seconds=8.0)[0] for style in ("Neutral", "Zombie")]
    feet = [contacts.detect(clip).numpy() for clip in clips]
    size = width, height
    print(f"{width} x {height}, {frames} pictures each       median   fastest   CPU time")

    def drawing(name: str, renderer: type, count: int) -> tuple[float, np.ndarray]:
        scene = renderer(size, clips[0], feet[0])
        try:
            times = _times(lambda k: scene.draw(k % len(clips[0])), count)
            return _row(name, times), scene.draw(0)
        finally:
            scene.close()

    if opengl_works():
        rate, picture = drawing("pyvista", renderers.PyvistaRenderer, frames)
    else:
        print("pyvista finds no OpenGL here: python -m toolkit.view.opengl")
    slow, sketch = drawing("software renderer", renderers.SoftwareRenderer, max(frames // 10, 2))
    if not opengl_works():
        rate, picture = slow, sketch
    image = Image.fromarray(picture)
    _row("JPEG", _times(lambda k: image.save(io.BytesIO(), "JPEG", quality=QUALITY), frames))
    player = Player(clips, contacts=feet, size=size)
    _row("player, two side by side", _times(lambda k: player.seek(k % len(player.clip)), frames))
    player.close()
    print(f"one character {'meets' if rate >= TARGET else 'MISSES'} {TARGET:g} pictures/s (wall or CPU time)")
    player_size = 640, 480
    waits = asyncio.run(_latency(lambda: Player(clips[0], contacts=feet[0], size=player_size), frames // 2))
    for name, wait in waits.items():
        middle, worst = np.quantile(wait, (0.5, 0.95))
        print(f"slider to picture, 640 x 480, {name:8} {middle:5.0f} ms median, {worst:4.0f} ms 95 %   (target {LATENCY:g}, "
              "browser included)")
    torch.set_num_threads(threads)


def _times(work: Callable[[int], object], count: int) -> np.ndarray:
    """Wall and CPU seconds [count, 2] of ``work(k)``, after three calls that are not measured."""
    for k in range(3):
        work(k)
    times = []
    for k in range(count):
        clock, processor = time.perf_counter(), time.process_time()
        work(k)
        times.append((time.perf_counter() - clock, time.process_time() - processor))
    return np.array(times)


def _row(name: str, times: np.ndarray) -> float:
    """Print a line and return the pictures per second of an idle machine, at least."""
    median, fastest, processor = np.median(times[:, 0]), times[:, 0].min(), np.median(times[:, 1])
    print(f"{name:32}{1e3 * median:8.1f} ms{1e3 * fastest:7.1f} ms{1e3 * processor:8.1f} ms = {1 / processor:5.0f}/s")
    return 1 / min(median, processor)


async def _latency(make: Callable, count: int) -> dict[str, list[float]]:
    """Milliseconds from a change of a slider (in another thread) to the new picture; paused and playing."""
    player, waits = make(), {}
    player.image.observe(lambda change: setattr(player.image, "seen", change["new"]), "number")  # a page without delay
    for name, playing in (("paused", False), ("playing", True)):
        player.playing, waits[name] = playing, []
        for k in range(count):
            await asyncio.sleep(0.02)
            before, start = player.image.number, time.perf_counter()
            await asyncio.to_thread(setattr, player._angle, "value", 30 + 10 * (k % 2))
            while player.image.number == before or player._stale:
                await asyncio.sleep(0.001)
            waits[name].append(1e3 * (time.perf_counter() - start))
    player.close()
    return waits
