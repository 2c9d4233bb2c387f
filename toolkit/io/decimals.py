"""Compiled loops of `toolkit.io.bvh`: rows of decimal numbers, and rotations from their angles."""

import numpy as np

from toolkit.io.compilation import compiled

POWERS = 10.0 ** np.arange(19)  # a double holds powers of ten up to 10²² exactly
TAB, NEWLINE, RETURN, SPACE, PLUS, MINUS, POINT, ZERO = b"\t\n\r +-.0"


@compiled()
def read(data: np.ndarray, at: int, columns: np.ndarray) -> bool:
    """Fill ``columns [C, F]`` with the F rows of C numbers in ``data`` (bytes) from ``at`` on.

    Every number is the nearest double to its decimal text: digits up to 2⁵³ and the power of ten
    are exact, and their quotient is rounded once (Clinger 1990). Returns False if the rows differ
    in length, or a word is no such number without an exponent.
    """
    width, rows = columns.shape
    row = column = 0
    end = len(data)
    while at < end:
        first = data[at]
        if first in (SPACE, TAB):
            at += 1
            continue
        if first in (NEWLINE, RETURN):  # the end of a row, unless the line is empty
            if 0 < column < width:
                return False
            if column:
                row, column = row + 1, 0
            at += 1
            continue
        if row == rows or column == width:
            return False
        if first in (MINUS, PLUS):
            at += 1
        # The digits on both sides of the point are one whole number.
        digits = np.int64(0)
        start = at
        while at < end:
            digit = data[at] - ZERO
            if not 0 <= digit <= 9:
                break
            digits = digits * 10 + digit
            at += 1
        count = at - start
        places = 0
        if at < end and data[at] == POINT:
            at += 1
            start = at
            while at < end:
                digit = data[at] - ZERO
                if not 0 <= digit <= 9:
                    break
                digits = digits * 10 + digit
                at += 1
            places = at - start
            count += places
        if not 0 < count <= 18 or digits > 2**53 or (at < end and data[at] > SPACE):
            return False
        value = digits / POWERS[places]
        columns[column, row] = -value if first == MINUS else value
        column += 1
    if column == width:  # no line end behind the last row
        row, column = row + 1, 0
    return column == 0 and row == rows


@compiled()
def compose(cosines: np.ndarray, sines: np.ndarray, axes: tuple[int, int, int],
            joints: np.ndarray, made: np.ndarray) -> None:
    """`rotations.from_euler` and `rotations.unroll` in one pass through the memory.

    ``cosines, sines [3, N, F]`` are of half the angles of N ``joints`` about three ``axes`` in
    turn. The quaternions are written into ``made [F, J, 4]``.
    """
    i, j, k = axes
    sign = np.float32(1.0 if (j - i) % 3 == 1 else -1.0)
    for n in range(len(joints)):
        joint = joints[n]
        w0 = x0 = y0 = z0 = np.float32(0.0)  # of the frame before
        for f in range(cosines.shape[2]):
            a, b, c = cosines[0, n, f], cosines[1, n, f], cosines[2, n, f]
            x, y, z = sines[0, n, f], sines[1, n, f], sines[2, n, f]
            cc, ss, sc, cs = a * b, sign * x * y, x * b, sign * a * y
            w, x, y, z = cc * c - ss * z, sc * c + cs * z, sign * (cs * c - sc * z), cc * z + ss * c
            if w * w0 + x * x0 + y * y0 + z * z0 < 0:
                w, x, y, z = -w, -x, -y, -z
            w0, x0, y0, z0 = w, x, y, z
            made[f, joint, 0] = w
            made[f, joint, 1 + i] = x
            made[f, joint, 1 + j] = y
            made[f, joint, 1 + k] = z
