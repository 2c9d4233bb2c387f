"""Speed of the sinusoid fit, compared with scipy's `curve_fit`, and residuals, compared with the
best known ones.
"""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import numpy as np
import typer


def run(
    clips: Annotated[list[Path]
                     | None, typer.Option(help="BVH files; default: procedural clips.")] = None,
    windows: Annotated[int, typer.Option(min=1, help="Number of windows that scipy fits.")] = 500,
    seed: Annotated[int, typer.Option(help="Seed of the choice of windows.")] = 0,
) -> None:
    """Speed and residuals of the sinusoid fit in windows of one second, compared with scipy's
    `curve_fit`, on one core.
    """
    import torch

    from toolkit import datasets
    from toolkit.io import bvh
    from toolkit.phases import LIMBS, Hybrid, fit, normalise, smooth

    torch.set_num_threads(1)
    motions = [bvh.load(c) for c in clips] if clips else datasets.load("procedural", seconds=20.0)
    source = Hybrid()
    curves = []
    for clip in motions:
        clip = clip if clip.fps == 60 else clip.resample(60)
        own = source.fitted([clip])
        raw = torch.stack([torch.as_tensor(own(clip, limb)).double() for limb in LIMBS], 1)
        curves.append(smooth(normalise(raw, 60.0), 60.0))

    total = sum(c.numel() for c in curves)
    fit(curves[0], 60.0)  # compiles
    found, ours = _least_time(lambda: [fit(c, 60.0) for c in curves])

    moving = [(f.amplitude[30:-30] > 0).nonzero().tolist() for f in found]
    inner = [(c, frame + 30, limb) for c, places in enumerate(moving) for frame, limb in places]
    picked = [inner[i] for i in np.random.default_rng(seed).permutation(len(inner))[:windows]]
    windows = len(picked)
    samples = np.stack([curves[c][f - 30 : f + 31, limb].numpy() for c, f, limb in picked])
    residual = np.array([float(found[c].residual[f, limb]) for c, f, limb in picked])
    started, started_time = _least_time(lambda: [_curve_fit(w, *_fft_start(w)) for w in samples],
                                        repeats=1)
    best = np.minimum(residual, [best_known(w) for w in samples])

    print(f"{'':<24}{'us/window':>10}{'> 1e-6':>8}{'> 1 %':>8}{'> 5 %':>8}{'worst (%)':>11}")
    for name, seconds, count, residuals in (("fit", ours, total, residual),
                                            ("curve_fit", started_time, windows, started)):
        excess = residuals / best - 1
        shares = (100 * np.mean(excess > limit) for limit in (1e-6, 0.01, 0.05))
        print(f"{name:<24}{1e6 * seconds / count:>10.2f}"
              + "".join(f"{x:>8.2f}" for x in shares) + f"{100 * excess.max():>11.4f}")
    print(f"{total:,} windows of 61 frames by the toolkit, {windows} of them by scipy's curve_fit "
          "from the largest peak of the spectrum,\n"
          "without bounds, which is faster for it; CPU time, one thread. Last columns: % of "
          "windows with a residual above the best known\n"
          "by this much. Best known: the least residual of the toolkit, of curve_fit with bounds "
          "from eight starts, and of a refined dense grid.\n"
          "If curve_fit fails, its residual is infinite.")


def _least_time(job: Callable, repeats: int = 5) -> tuple:
    """Result of a job, and its least CPU time, seconds."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        result = job()
        times.append(time.process_time() - start)
    return result, min(times)


def _sinusoid(t: np.ndarray, a: float, f: float, s: float, b: float) -> np.ndarray:
    return a * np.sin(2 * np.pi * (f * t - s)) + b


def _times(window: np.ndarray, fps: float) -> np.ndarray:
    return (np.arange(len(window)) - len(window) // 2) / fps


def _curve_fit(window: np.ndarray, frequency: float, shift: float, *, fps: float = 60.0,
               bounded: bool = False) -> float:
    """Residual of `scipy.optimize.curve_fit` from one start; infinite if it fails."""
    from scipy.optimize import curve_fit

    t, low, high = _times(window, fps), window.min(), window.max()
    limits = {"bounds": ([0, 0.25, -1, low - 1e-9],
                         [high - low + 1e-9, 4, 1, high + 1e-9])} if bounded else {}
    try:
        found = curve_fit(_sinusoid, t, window, [(high - low) / 2, frequency, shift, window.mean()],
                          **limits)[0]
    except RuntimeError:  # too many evaluations
        return np.inf
    return float(np.sqrt(np.mean((_sinusoid(t, *found) - window) ** 2)))


def _fft_start(window: np.ndarray, fps: float = 60.0) -> tuple[float, float]:
    """Frequency and shift of the largest peak of the zero-padded spectrum within the bounds."""
    size = 8 * len(window)
    spectrum = np.fft.rfft(window - window.mean(), size)
    hertz = np.fft.rfftfreq(size, 1 / fps)
    inside = np.flatnonzero((hertz >= 0.25) & (hertz <= 4))
    peak = inside[np.argmax(np.abs(spectrum[inside]))]
    # of a cosine
    at_frame = np.angle(spectrum[peak]) + 2 * np.pi * hertz[peak] * (len(window) // 2) / fps
    return hertz[peak], -(((at_frame + np.pi / 2) / (2 * np.pi) + 0.5) % 1 - 0.5)


def best_known(window: np.ndarray, fps: float = 60.0, frequencies: int = 300,
               phases: int = 64) -> float:
    """Least residual within the bounds by slow methods that share no code with
    `toolkit.phases.sinusoids`.

    A dense grid of frequencies and phases with the best amplitude and offset within the bounds; its
    five best valleys over frequency, refined by scipy's bounded `least_squares`; and `curve_fit`
    with bounds from eight starts.
    """
    from scipy.optimize import least_squares

    t, n, low, high = _times(window, fps), len(window), window.min(), window.max()
    spread = high - low
    scale = max(spread, 1e-12)
    hertz, angles = np.linspace(0.25, 4, frequencies), 2 * np.pi * np.arange(phases) / phases
    wave = np.sin(2 * np.pi * hertz[:, None, None] * t + angles[:, None])
    ss, s1, gs, g1 = (wave**2).sum(-1), wave.sum(-1), wave @ window, window.sum()
    free = (gs * n - g1 * s1) / np.maximum(ss * n - s1**2, 1e-12)
    corners = [(free, (g1 - free * s1) / n)]
    corners += [(np.full_like(ss, a), np.clip((g1 - a * s1) / n, low, high)) for a in (0.0, spread)]
    corners += [(np.clip((gs - b * s1) / ss, 0, spread), np.full_like(ss, b)) for b in (low, high)]
    a, b = (np.stack(x) for x in zip(*corners, strict=True))
    error = (window @ window) - 2 * (a * gs + b * g1) + a**2 * ss + b**2 * n + 2 * a * b * s1
    error[(a < 0) | (a > spread) | (b < low) | (b > high)] = np.inf
    corner, error = error.argmin(0), error.min(0)
    phase, valley = error.argmin(1), np.pad(error.min(1), 1, constant_values=np.inf)
    valleys = np.flatnonzero((valley[1:-1] <= valley[:-2]) & (valley[1:-1] <= valley[2:]))
    found = [error.min()]
    for k in sorted(valleys, key=lambda k: error[k].min())[:5]:
        place = corner[k, phase[k]], k, phase[k]
        start, edge = [a[place], hertz[k], angles[phase[k]], b[place]], 1e-12 * scale
        found.append(2 * least_squares(
            lambda p: p[0] * np.sin(2 * np.pi * p[1] * t + p[2]) + p[3] - window, start,
            x_scale=[scale, 1, 1, scale],
            bounds=([-edge, 0.25 - 1e-12, -10, low - edge],
                    [spread + edge, 4 + 1e-12, 10, high + edge]),
            ftol=1e-14, xtol=1e-12, gtol=1e-14, max_nfev=300).cost)
    starts = [_curve_fit(window, f, s, fps=fps, bounded=True) for f in (0.4, 1.0, 2.0, 3.0)
              for s in (-0.25, 0.25)]
    return float(min(np.sqrt(max(min(found), 0.0) / n), *starts))
