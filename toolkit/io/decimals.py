"""Compiled loops of `toolkit.io.bvh`: rows of decimal numbers, and rotations from their angles."""

import numpy as np

from toolkit.io.compilation import compiled

POWERS = 10.0 ** np.arange(23)  # the powers of ten that a double holds exactly
TAB, NEWLINE, RETURN, SPACE, PLUS, MINUS, POINT, ZERO, UPPER_E, LOWER_E = b"\t\n\r +-.0Ee"


@compiled()
def read(data: np.ndarray, at: int, columns: np.ndarray) -> bool:
    """Fill ``columns [C, F]`` with the F rows of C numbers that ``data`` (bytes) holds from ``at`` to its end.

    Every number is the nearest double to its decimal text: digits up to 2⁵³ and the power of ten are exact, and their
    quotient or product is rounded once (Clinger 1990). Returns False if the rows differ, or a number has more digits.
    """
    width, rows = columns.shape
    row = column = 0
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
def compose(cosines: np.ndarray, sines: np.ndarray, axes: tuple[int, int, int], joints: np.ndarray,
            made: np.ndarray, first: int) -> None:
    """Write quaternions of N joints into ``made [F, J, 4]``, as `rotations.from_euler` and `rotations.unroll` do.

    ``cosines, sines [3, N, P]`` are of the halves of the angles about three ``axes`` in P frames from the ``first``. Earlier
    ones are in ``made``.
    """
    i, j, k = axes
    sign = np.float32(1.0 if (j - i) % 3 == 1 else -1.0)
    frames, flips, lasts = cosines.shape[2], np.ones(len(joints), np.float32), np.zeros((len(joints), 4), np.float32)
    if first:
        for n in range(len(joints)):
            last = made[first - 1, joints[n]]
            lasts[n, 0], lasts[n, 1], lasts[n, 2], lasts[n, 3] = last[0], last[1 + i], last[1 + j], last[1 + k]
    for start in range(0, frames, 64):  # frames whose rows stay in the cache
        for n in range(len(joints)):
            joint, flip = joints[n], flips[n]
            lw, lx, ly, lz = lasts[n]
            for f in range(start, min(start + 64, frames)):
                a, b, c = cosines[0, n, f], cosines[1, n, f], cosines[2, n, f]
                x, y, z = sines[0, n, f], sines[1, n, f], sines[2, n, f]
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
