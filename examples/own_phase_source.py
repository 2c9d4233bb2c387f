"""Your own phase source on your own BVH files: python examples/own_phase_source.py [FOLDER]

A source is a function of a clip and a limb. It returns a curve whose cycles give the limb's phase,
and toolkit.phases fits sinusoids to the curve. A source that computes the sinusoids itself has a
method `sinusoids`; then nothing is fitted.

The source of this example is the height of the toes. It is used twice: with the fit, and with the
phase of its analytic signal (Hilbert transform). Both are compared with the paper's hybrid source.
Without a folder, the script writes procedural clips, whose phases are known, to a temporary folder.
"""

import math
import os
import sys
import tempfile
from pathlib import Path

import scipy
import torch

import toolkit as tk
from toolkit.datasets import procedural

SECONDS = 6.0 if os.environ.get("TOOLKIT_FAST") else 20.0
# Hz of strides; an analytic signal needs one frequency, and curves of feet also have harmonics
BAND = (0.4, 1.5)
HANDS = tk.phases.ContactFree()  # the curve for hands, which have no contact


def height(clip, limb):
    """Negative height of the toe, metres ``[F]``, so that the curve is high during a contact; for
    hands, `HANDS`.
    """
    if limb.endswith("hand"):
        return HANDS(clip, limb)
    return -clip.global_positions[:, clip.skeleton.role(limb.replace("foot", "toe")), 1]


class Hilbert:
    """The same curve, with the phase of its analytic signal."""

    def sinusoids(self, clip):
        """Normalised, smoothed curves ``[F, 4]``, and the sinusoid of each limb in each frame."""
        raw = tk.phases.curves(clip, height)
        curve = tk.phases.smooth(tk.phases.normalise(raw - raw.mean(0), clip.fps), clip.fps)
        strides = scipy.signal.butter(2, BAND, "bandpass", fs=clip.fps, output="sos")
        signal = torch.from_numpy(scipy.signal.hilbert(scipy.signal.sosfiltfilt(
            strides, curve.numpy(), axis=0), axis=0))
        turns = (signal[1:] * signal[:-1].conj()).angle() / math.tau
        frequency = tk.phases.windows.mean(torch.cat((turns[:1], turns)), 0.5, clip.fps) * clip.fps
        phase = (signal.angle() + math.pi / 2) % math.tau  # so that its sine is the curve
        nothing = torch.zeros_like(phase)
        return curve, tk.phases.Sinusoids(phase, frequency.clamp(0.25, 4.0), signal.abs(), nothing,
                                          nothing)


def write_some(folder):
    """Write procedural walks as BVH files; returns their known phases ``[F, 4]`` by file name."""
    truth = {}
    for style in ("Neutral", "Zombie", "HighKnees"):
        clip, known = procedural.truth(style, "FW", SECONDS)
        tk.bvh.save(clip, folder / f"{style}_FW.bvh")
        truth[f"{style}_FW.bvh"] = known.phase
    return truth


def compare(folder, truth):
    """Mean phase error of the feet, radians, by file and source: against the known phases, else
    against hybrid.
    """
    errors = {}
    for path in sorted(folder.glob("**/*.bvh")):
        clip = tk.bvh.load(path).resample(60)
        found = {name: tk.phases.extract(clip, source).phase for name, source in SOURCES.items()}
        right = truth.get(path.name, found["hybrid"])
        errors[path.name] = {name: float(tk.metrics.phase_error(p, right)[0][2:].mean())
                             for name, p in found.items()}
    return errors


SOURCES = {"hybrid": "hybrid", "height, fitted": height, "height, Hilbert": Hilbert()}
with tempfile.TemporaryDirectory() as temporary:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else temporary)
    errors = compare(folder, {} if len(sys.argv) > 1 else write_some(folder))
    clips = [tk.bvh.load(path, style=path.stem) for path in sorted(folder.glob("**/*.bvh"))]
    data = tk.features.build(clips, source=Hilbert(), short="skip")

print(f"{'phase error of the feet, rad':<32}" + "".join(f"{name:>18}" for name in SOURCES))
for name, row in errors.items():
    print(f"{name:<32}" + "".join(f"{error:>18.3f}" for error in row.values()))
print(f"features with the Hilbert source: {data.n_frames:,} frames of {', '.join(data.styles)}")
