"""Compiled parser for rows of decimal numbers, used by `toolkit.io.bvh`."""

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
