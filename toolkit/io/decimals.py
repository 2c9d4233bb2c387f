"""Compiled loops of `toolkit.io.bvh`: rows of decimal numbers, and rotations from their angles."""

import numpy as np

from toolkit.io.compilation import compiled

POWERS = 10.0 ** np.arange(23)  # the powers of ten that a double holds exactly
ZEROS, OVER, HIGH = (np.uint64(byte * 0x0101010101010101) for byte in (0x30, 0x76, 0x80))  # one byte of a word each
PAIRS, FOURS, EIGHT = np.uint64(0x00FF00FF00FF00FF), np.uint64(0x0000FFFF0000FFFF), np.uint64(0xFFFFFFFF)
_1, _4, _8, _10, _16, _32, _100, _10000 = map(np.uint64, (1, 4, 8, 10, 16, 32, 100, 10000))  # numba: others make floats
TAB, NEWLINE, RETURN, SPACE, PLUS, MINUS, POINT, ZERO, UPPER_E, LOWER_E = b"\t\n\r +-.0Ee"


def read(data: np.ndarray, at: int, columns: np.ndarray) -> bool:
    """Fill ``columns [C, F]`` with the F rows of C numbers that ``data`` (bytes) holds from ``at`` to its end.

    Every number is the nearest double to its decimal text: digits up to 2⁵³ and the power of ten are exact, and their
    quotient or product is rounded once (Clinger 1990). Returns False if the rows differ, or a number has more digits.

    The digits behind a point are read eight bytes at a time (Lemire 2021, "Number parsing at a gigabyte per second",
    section 6). Most files write as many in every number, so that their count is looked up only where it changes.
    """
    words = np.ndarray(max(0, len(data) - 7), np.uint64, np.ascontiguousarray(data).data, 0, 1)  # the eight bytes from each
    return _read(data, words, at, columns)


@compiled()
def _read(data: np.ndarray, words: np.ndarray, at: int, columns: np.ndarray) -> bool:
    width, rows = columns.shape
    row = column = count = 0
    power, last = 1, _1
    end = len(data)
    while True:
        while at < end and (data[at] == SPACE or data[at] == TAB):
            at += 1
        if at == end or data[at] == NEWLINE or data[at] == RETURN:
            if 0 < column < width:
                return False
            if column:
                row, column = row + 1, 0
            if at == end:
                return row == rows
            at += 1
            continue
        if row == rows or column == width:
            return False
        negative = data[at] == MINUS
        if negative or data[at] == PLUS:
            at += 1
        digits, first = 0, at
        while at < end and ZERO <= data[at] <= ZERO + 9:
            digits, at = digits * 10 + (data[at] - ZERO), at + 1
        length, places = at - first, 0
        if at < end and data[at] == POINT:
            at, first = at + 1, at + 1
            if at < len(words):
                word = words[at] ^ ZEROS  # digits are bytes from 0 to 9
                stop = ((word + OVER) | word) & HIGH
                stop &= ~stop + _1  # the high bit of the first byte that is no digit
                if stop != last:
                    last, count, power = stop, 0, 1
                    while count < 8 and ZERO <= data[at + count] <= ZERO + 9:
                        count, power = count + 1, power * 10
                shift = _4 * np.uint64(8 - count)
                word = (word << shift) << shift
                word = (word * _10 + (word >> _8)) & PAIRS
                word = (word * _100 + (word >> _16)) & FOURS
                digits = digits * power + np.int64((word * _10000 + (word >> _32)) & EIGHT)
                at += count
            while at < end and ZERO <= data[at] <= ZERO + 9:
                digits, at = digits * 10 + (data[at] - ZERO), at + 1
            places = at - first
        if not 0 < length + places <= 18 or digits > 2**53:
            return False
        if at < end and (data[at] == UPPER_E or data[at] == LOWER_E):
            at += 1
            down = at < end and data[at] == MINUS
            if down or (at < end and data[at] == PLUS):
                at += 1
            exponent, first = 0, at
            while at < end and at < first + 3 and ZERO <= data[at] <= ZERO + 9:
                exponent, at = exponent * 10 + (data[at] - ZERO), at + 1
            if at == first:
                return False
            places += exponent if down else -exponent
        if abs(places) > 22 or (at < end and data[at] > SPACE):
            return False
        value = digits / POWERS[places] if places >= 0 else digits * POWERS[-places]
        columns[column, row] = -value if negative else value
        column += 1


@compiled()
def compose(cosines: np.ndarray, sines: np.ndarray, rows: np.ndarray, axes: tuple[int, int, int], joints: np.ndarray,
            made: np.ndarray, first: int) -> None:
    """Write quaternions of N joints into ``made [F, J, 4]``, as `rotations.from_euler` and `rotations.unroll` do.

    ``cosines, sines [C, P]`` are of the halves of angles in P frames from the ``first``; those of a joint about the three
    ``axes`` are in its ``rows [N, 3]``. Earlier frames are in ``made``.
    """
    i, j, k = axes
    sign = np.float32(1.0 if (j - i) % 3 == 1 else -1.0)
    frames, flips, lasts = cosines.shape[1], np.ones(len(joints), np.float32), np.zeros((len(joints), 4), np.float32)
    if first:
        for n in range(len(joints)):
            last = made[first - 1, joints[n]]
            lasts[n, 0], lasts[n, 1], lasts[n, 2], lasts[n, 3] = last[0], last[1 + i], last[1 + j], last[1 + k]
    for start in range(0, frames, 64):  # frames whose rows stay in the cache
        for n in range(len(joints)):
            joint, flip = joints[n], flips[n]
            p, q, r = rows[n]
            lw, lx, ly, lz = lasts[n]
            for f in range(start, min(start + 64, frames)):
                a, b, c = cosines[p, f], cosines[q, f], cosines[r, f]
                x, y, z = sines[p, f], sines[q, f], sines[r, f]
                cc, ss, sc, cs = a * b, sign * x * y, x * b, sign * a * y
                w, x, y, z = cc * c - ss * z, sc * c + cs * z, sign * (cs * c - sc * z), cc * z + ss * c
                if w * lw + x * lx + y * ly + z * lz < 0:
                    flip = -flip
                lw, lx, ly, lz = w, x, y, z
                made[first + f, joint, 0] = flip * w
                made[first + f, joint, 1 + i] = flip * x
                made[first + f, joint, 1 + j] = flip * y
                made[first + f, joint, 1 + k] = flip * z
            flips[n] = flip
            lasts[n, 0], lasts[n, 1], lasts[n, 2], lasts[n, 3] = lw, lx, ly, lz
