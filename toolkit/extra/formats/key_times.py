"""The frame rate of key frames, and the frames at which an animation is sampled."""

from collections.abc import Sequence

import numpy as np

# tried where keys are unevenly spaced
RATES = (30.0, 24.0, 25.0, 60.0, 50.0, 48.0, 120.0, 100.0, 240.0)
FRAMES = 500_000  # of an animation, and keys of a curve: more than two hours at 60 Hz
MOST = 1_000_000  # joints times frames that a file of any size may have


def frame_rate(times: Sequence[np.ndarray], usual: float) -> float:
    """Frames per second at which all key times (seconds, one array for each curve) lie on frames.

    It is the keys' own rate if they are at equal distances and at least 12 a second, otherwise
    ``usual`` or the first of `RATES` that meets them, otherwise ``usual``.
    """
    if (most := max(map(len, times))) > FRAMES:
        raise ValueError(f"a curve of {most} keys, more than {FRAMES}")
    # with very many curves, the one with the most keys stands for all of them
    keys = max(times, key=len) if len(times) > 64 else np.concatenate(times)
    keys = np.unique(np.round(keys, 5))
    if len(keys) < 2:
        return usual
    own = (len(keys) - 1) / float(keys[-1] - keys[0])
    if abs(own - round(own)) < 0.02:
        own = float(round(own))
    for rate in ([own] if own >= 12 else []) + [usual, *RATES]:
        places = (keys - keys[0]) * rate
        if np.abs(places - np.round(places)).max() < 0.05:
            return rate
    return usual


def sampled(times: Sequence[np.ndarray], usual: float, joints: int,
            size: int) -> tuple[np.ndarray, float]:
    """Times ``[F]`` of the frames from the first key to the last, and `frame_rate`.

    One frame if there is no key. ValueError if a file of ``size`` bytes cannot hold so many frames
    of so many joints.
    """
    if not times:
        return np.zeros(1), usual
    rate = frame_rate(times, usual)
    begin, end = min(t[0] for t in times), max(t[-1] for t in times)
    length = (end - begin) * rate
    if not length * joints < max(MOST, size / 8):
        raise ValueError(f"{length:.0f} frames of {joints} joints are more than {size} bytes "
                         "can hold")
    if length > FRAMES:
        raise ValueError(f"{length:.0f} frames, more than {FRAMES}")
    return begin + np.arange(round(length) + 1) / rate, rate


def around(keys: np.ndarray, at: np.ndarray,
           early: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For times ``at [F]`` the key before, the seconds to the next, the share of the way to it.

    A time counts as that of a key from ``early`` seconds before it on. There are two or more keys.
    """
    at = np.clip(at, keys[0], keys[-1])
    i = np.clip(np.searchsorted(keys, at + early, "right") - 1, 0, len(keys) - 2)
    span = keys[i + 1] - keys[i]
    return i, span, np.maximum((at - keys[i]) / span, 0.0)


def hermite(t: np.ndarray, first: np.ndarray, second: np.ndarray, out: np.ndarray,
            into: np.ndarray) -> np.ndarray:
    """The cubic curve at the share ``t`` of the way between two values, with its slopes there."""
    return ((2 * t**3 - 3 * t**2 + 1) * first + (t**3 - 2 * t**2 + t) * out
            + (3 * t**2 - 2 * t**3) * second + (t**3 - t**2) * into)
