"""Least-squares sinusoids a·sin(2π(f·t − s)) + b in a window around every frame.

The model is that of Starke et al. 2020, section 5.2. `toolkit.phases.variable_projection` has the
mathematics.
"""

import math
from dataclasses import dataclass

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.motion.tensors import summary
from toolkit.phases import windows

MIN_FREQUENCY, MAX_FREQUENCY = 0.25, 4.0
DENSITY = 6.0  # grid frequencies per additional cycle in the window, and per factor e


def frequencies(seconds: float) -> np.ndarray:
    """Grid in Hz for a window of that length, finest at low frequencies.

    Its steps are 1 / `DENSITY` in cycles + ln cycles: small compared with the width of the
    narrowest valley of the error, which is about the inverse length of the window.
    """
    fine = np.geomspace(MIN_FREQUENCY, MAX_FREQUENCY, 1000)
    steps = DENSITY * (fine * seconds + np.log(fine))
    even = np.linspace(steps[0], steps[-1], math.ceil(steps[-1] - steps[0]) + 1)
    grid = np.interp(even, steps, fine)
    grid[[0, -1]] = MIN_FREQUENCY, MAX_FREQUENCY
    return grid


@dataclass(frozen=True)
class Sinusoids:
    """Fitted parameters of every frame, each ``[F, L]``.

    ``phase`` is the angle 2π(f·t − s) at the frame itself, radians in [0, 2π); ``frequency`` in Hz;
    ``amplitude``, ``offset`` and ``residual`` (root mean square over the window) in the source's
    unit.
    """

    phase: Tensor
    frequency: Tensor
    amplitude: Tensor
    offset: Tensor
    residual: Tensor
    __repr__ = summary


def fit(source: Tensor, fps: float, half_window: float = 0.5) -> Sinusoids:
    """Fit a sinusoid around every frame, in a window of ``half_window`` seconds on either side.

    ``source [F, L]`` has one curve per limb, finite; mirrored at its ends. Any device and dtype,
    which the result has too; the fit itself runs on the processor, in float64. ValueError if it is
    not ``[F, L]`` or shorter than half a window, or `fps` is too low for 4 Hz.

    Bounds as published: a in [0, max − min], f in [0.25, 4] Hz, b in [min, max] of the window.

    Departure: the published fit added a term for continuity with the neighbours' fits to the
    root-mean-square error, and used an evolutionary search. Here every frame has the least error of
    its own window.
    """
    from toolkit.phases.variable_projection import minima

    half = max(2, round(half_window * fps))
    n = 2 * half + 1
    if source.ndim != 2 or len(source) <= half:
        raise ValueError(f"a source must be [frames, limbs] with more than {half} frames, not "
                         f"{list(source.shape)}")
    if fps <= 2 * MAX_FREQUENCY:
        raise ValueError(f"fits up to {MAX_FREQUENCY:g} Hz need over {2 * MAX_FREQUENCY:g} frames "
                         f"per second, not {fps:g}")
    per_frame = 2 * np.pi / fps
    grid = frequencies(n / fps) * per_frame
    curves = np.ascontiguousarray(source.detach().double().cpu().numpy().T)  # [L, F]
    low = scipy.ndimage.minimum_filter1d(curves, n, mode="mirror")
    high = scipy.ndimage.maximum_filter1d(curves, n, mode="mirror")
    found = np.zeros((len(curves), 5, len(source)))
    for limb, curve in enumerate(np.pad(curves, ((0, 0), (half, half)), mode="reflect")):
        spread, middle = high[limb] - low[limb], (low[limb] + high[limb]) / 2
        minima(curve, spread, middle, grid, found[limb])
    theta, u, v, offset, error = found.swapaxes(0, 1)
    # rounding must not leave the bounds
    columns = (np.arctan2(v, u) % (2 * np.pi),
               np.clip(theta / per_frame, MIN_FREQUENCY, MAX_FREQUENCY),
               np.minimum(np.hypot(u, v), high - low), np.clip(offset, low, high),
               np.sqrt(error / n))
    return Sinusoids(*(torch.from_numpy(column.T.copy()).to(source) for column in columns))


def along(signal: Tensor, curve: Tensor, fps: float, half_window: float) -> Sinusoids:
    """The sinusoids of ``curve [F, ...]`` whose phase is the angle of a complex signal plus π / 2.

    So a sinusoid is highest where the ``signal [F, ...]`` is real and positive. The frequency is
    the mean growth of the phase in the window; amplitude and offset are the least-squares ones for
    that phase.
    """
    phase = (signal.angle() + math.pi / 2) % (2 * math.pi)
    turns = (signal[1:] * signal[:-1].conj()).angle() / (2 * math.pi)
    frequency = windows.mean(torch.cat((turns[:1], turns)), half_window, fps) * fps
    return Sinusoids(phase, frequency.clamp(MIN_FREQUENCY, MAX_FREQUENCY),
                     *windows.regression(curve, phase.sin(), half_window, fps))
