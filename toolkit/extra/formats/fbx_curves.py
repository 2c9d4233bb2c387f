"""Animation curves of FBX: key frames with tangents, after ufbx, Samuli Raivio's reader in C."""

from dataclasses import dataclass

import numpy as np

from toolkit.extra.formats.fbx_records import Record, Records
from toolkit.extra.formats.key_times import around, hermite

CONSTANT, CUBIC, TCB, USER = 0x2, 0x8, 0x200, 0x400  # flags of a key
NEXT, CLAMP, TIME_INDEPENDENT = 0x100, 0x1000, 0x2000
PROGRESSIVE, WEIGHTED = 0x4000, 0x3000000
LARGEST = 1e30
REPEATED = "some curves go on beyond their keys by a rule; their last values were held"
ROUGH = "some curves have weighted or TCB tangents between key frames; plain tangents were used"


@dataclass
class Curve:
    """One number of a property over K keys."""

    times: np.ndarray  # [K] seconds
    values: np.ndarray  # [K]
    flags: np.ndarray  # [K]
    # [K, 4] that the user gave: to the right, to the next key's left, two weights
    slopes: np.ndarray
    repeated: bool  # whether it goes on beyond its keys by a rule

    def __call__(self, at: np.ndarray) -> tuple[np.ndarray, list[str]]:
        """Values at times ``at`` [F], and what is doubtful about them."""
        times, values = self.times, self.values
        beyond = times[0] >= at[0] + 1e-3 or times[-1] <= at[-1] - 1e-3
        doubts = [REPEATED] if self.repeated and beyond else []
        if len(times) == 1:
            return np.full(len(at), values[0]), doubts

        i, span, t = around(times, at, 1e-7)

        # A key's flags say how the curve goes on to the next key
        kind = self.flags[i]
        cubic = kind & CUBIC > 0
        made = values[i] + t * (values[i + 1] - values[i])
        if cubic.any():
            right, left = self._tangents()
            curved = hermite(t, values[i], values[i + 1], right[i] * span, left[i + 1] * span)
            made = np.where(cubic, curved, made)
        held = np.where(kind & NEXT > 0, values[i + (t > 1e-4)], values[i + (t > 1 - 1e-4)])
        made = np.where(kind & CONSTANT > 0, held, made)

        between = (t > 1e-4) & (t < 1 - 1e-4)
        if (between & cubic & (kind & (WEIGHTED | TCB) > 0)).any():
            doubts.append(ROUGH)
        return made, doubts

    def _tangents(self) -> tuple[np.ndarray, np.ndarray]:
        """Slopes ``[K]`` to the right and to the left of each key, per second."""
        step, rise = np.diff(self.times), np.diff(self.values)
        slope = rise / step
        before, after = np.append(slope[0], slope), np.append(slope, slope[-1])

        # Automatic tangents: the slope from the key before to the key after, or its mean with
        # that of the two parts, weighted by their times
        whole = (rise[:-1] + rise[1:]) / (step[:-1] + step[1:])
        whole = np.concatenate((slope[:1], whole, slope[-1:]))
        share = np.concatenate(([0.0], step[:-1] / (step[:-1] + step[1:]), [0.0]))
        parts = before * (1 - share) + after * share
        auto = np.where(self.flags & TIME_INDEPENDENT, whole, 0.5 * whole + 0.5 * parts)

        # Clamped: flat where a neighbour has the same value
        near = np.minimum(np.append(np.inf, np.abs(rise)), np.append(np.abs(rise), np.inf))
        auto = np.where((self.flags & CLAMP > 0) & (near <= 1e-3), 0.0, auto)

        # Progressive: flat at the ends, and never so steep that the curve goes beyond its keys
        sign = np.sign(auto)
        limit = 3.0 * np.maximum(np.minimum(sign * before, sign * after), 0.0)
        limit[[0, -1]] = 0.0
        limited = sign * np.minimum(np.abs(auto), limit)
        auto = np.where(self.flags & PROGRESSIVE, limited, auto)

        # The user's slopes in place of the automatic ones
        own = (self.flags & CUBIC > 0) & ((self.flags & USER == 0) | (self.flags & TCB > 0))
        given = self.slopes.astype(np.float64)
        right = np.where(own, auto, given[:, 0])
        left = np.where(own, auto, np.append(0.0, given[:-1, 1]))
        right, left = (np.nan_to_num(x, posinf=0.0, neginf=0.0) for x in (right, left))
        return right, left


def read_curve(file: Records, record: Record, second: int) -> Curve:
    """The curve of a record; a second has ``second`` of the file's units of time."""
    arrays, repeated, empty = {}, False, np.zeros(0)
    for part in file.children(record):
        if part.name in (b"Pre-Extrapolation", b"Post-Extrapolation"):
            rules = [file.values(of)[:1] for of in file.children(part) if of.name == b"Type"]
            constant = [ord("C")], [b"C"]
            repeated = repeated or any(rule not in constant for rule in rules)
        elif part.name.startswith(b"Key"):
            value = (file.values(part) or [None])[0]
            arrays[part.name] = value if isinstance(value, np.ndarray) else empty
    times = arrays.get(b"KeyTime", empty).astype(np.float64) / second
    values = arrays.get(b"KeyValueFloat", empty).astype(np.float64)
    if len(times) != len(values) or not (np.abs(values) < LARGEST).all():
        raise ValueError("a curve has numbers that are not finite, or not a time for each value")
    if not (np.diff(times) > 0).all():
        raise ValueError(f"the {len(times)} key times of a curve do not increase")

    # Flags and slopes are stored once for neighbouring keys that have the same
    counts = arrays.get(b"KeyAttrRefCount", empty).astype(np.int64)
    flags = arrays.get(b"KeyAttrFlags", empty).astype(np.int64)
    slopes = arrays.get(b"KeyAttrDataFloat", empty).astype(np.float32)
    fit = len(counts) == len(flags) and 4 * len(counts) == len(slopes) and (counts >= 0).all()
    if not fit or counts.sum() != len(times):
        counts, flags, slopes = np.array([len(times)]), np.zeros(1, np.int64), np.zeros(4)
    slopes = np.repeat(slopes.reshape(-1, 4), counts, axis=0)
    return Curve(times, values, np.repeat(flags, counts), slopes, repeated)
