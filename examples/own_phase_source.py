"""A phase source of your own on BVH files of your own: python examples/own_phase_source.py [FOLDER]

A source is a function of a clip and a limb that gives one curve whose cycles are the limb's phase; toolkit.phases fits
sinusoids to it. A source that knows the sinusoids itself has a method `sinusoids`, and nothing is fitted. Here: the toes'
height, once with the fit and once with the phase of its analytic signal (Hilbert transform), beside the paper's hybrid.
Without a folder, procedural clips are written to a temporary one, and the true phases are known.
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
BAND = (0.4, 1.5)  # Hz, of strides: an analytic signal has a phase only where one frequency rules, and feet have harmonics
HANDS = tk.phases.ContactFree()  # hands touch nothing: for them, how far they are ahead


def height(clip, limb):
    """Height of the foot's toe joint, metres ``[F]``; the lower, the higher the curve, as a contact is."""
    if limb.endswith("hand"):
        return HANDS(clip, limb)
    return -clip.global_positions[:, clip.skeleton.role(limb.replace("foot", "toe")), 1]


class Hilbert:
    """The same curve, its phase read from the analytic signal."""

    def sinusoids(self, clip):
        """The normalised, smoothed curves ``[F, 4]``, and the sinusoid of each limb in each frame."""
        raw = tk.phases.curves(clip, height)
        curve = tk.phases.smooth(tk.phases.normalise(raw - raw.mean(0), clip.fps), clip.fps)
        strides = scipy.signal.butter(2, BAND, "bandpass", fs=clip.fps, output="sos")
        signal = torch.from_numpy(scipy.signal.hilbert(scipy.signal.sosfiltfilt(strides, curve.numpy(), axis=0), axis=0))
        turns = (signal[1:] * signal[:-1].conj()).angle() / math.tau
        frequency = tk.phases.windows.mean(torch.cat((turns[:1], turns)), 0.5, clip.fps) * clip.fps
        phase = (signal.angle() + math.pi / 2) % math.tau  # so that its sine is the curve
        nothing = torch.zeros_like(phase)
        return curve, tk.phases.Sinusoids(phase, frequency.clamp(0.25, 4.0), signal.abs(), nothing, nothing)


def write_some(folder):
    """Procedural walks as BVH files; their true phases ``[F, 4]`` by file name."""
    truth = {}
    for style in ("Neutral", "Zombie", "HighKnees"):
        clip, known = procedural.truth(style, "FW", SECONDS)
        tk.bvh.save(clip, folder / f"{style}_FW.bvh")
        truth[f"{style}_FW.bvh"] = known.phase
    return truth


def compare(folder, truth):
    """Of every file and source the feet's mean phase error, radians, against the truth, or against hybrid where unknown."""
    errors = {}
    for path in sorted(folder.glob("**/*.bvh")):
        clip = tk.bvh.load(path).resample(60)
        found = {name: tk.phases.extract(clip, source).phase for name, source in SOURCES.items()}
        right = truth.get(path.name, found["hybrid"])
        errors[path.name] = {name: float(tk.metrics.phase_error(p, right)[0][2:].mean()) for name, p in found.items()}
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
