"""The sinusoid of least squared error in every window of a curve, compiled.

The method is variable projection (Golub and Pereyra 1973). In a window of n = 2h + 1 samples y(t),
t from −h to h, the sinusoid of angle θ per frame

    u·sin θt + v·cos θt + b,   u = a·cos φ,   v = a·sin φ,   φ the phase at t = 0

is linear in (u, v, b). So for a given θ the best (u, v, b) is known in closed form (`_project`),
and what is left is a search over θ alone (`minima`, `_refine`). The search looks at the gain: how
much less the squared error is than Σ y².

The window enters only by its inner products gs = Σ y·sin θt, gc = Σ y·cos θt and g1 = Σ y. Those of
the waves with each other, ss = Σ sin², cc = Σ cos² and c1 = Σ cos, depend on θ alone; Σ sin and
Σ sin·cos are 0, because the window is symmetric.
"""

import math

import numpy as np

from toolkit.io.compilation import compiled

GOLDEN = (math.sqrt(5.0) - 1) / 2
PRECISION = 3e-3  # of an angle: where the golden section ends, and a parabola does the rest
PEAKS = 2  # of the gain on the grid that are refined
ENOUGH = 0.9  # of the best gain that another peak on the grid must have, to be refined as well


@compiled(error_model="numpy")
def minima(curve, spread, middle, grid, out):
    """Write the sinusoid of least error in each of F windows to the columns of ``out`` [5, F].

    The rows of ``out`` are angle per frame, u, v, b and squared error. ``curve`` has F + 2h
    samples; ``spread`` and ``middle`` [F] are the difference and the mean of the extremes of each
    window; ``grid`` [G] has angles per frame, its ends the bounds. All are float64.
    """
    frames = len(spread)
    half = (len(curve) - frames) // 2
    n = 2 * half + 1
    gains = np.empty(len(grid))
    odd, even = np.zeros(half + 1), np.empty(half + 1)

    # on the grid: inner products of the waves with each other, and of the first window with them
    sine, cosine = np.sin(grid), np.cos(grid)
    end_sine, end_cosine = np.sin(half * grid), np.cos(half * grid)
    ss, cc, c1 = _waves(grid, n)
    sums_sine, sums_cosine = np.zeros(len(grid)), np.zeros(len(grid))
    for t in range(n):
        sums_sine += curve[t] * np.sin((t - half) * grid)
        sums_cosine += curve[t] * np.cos((t - half) * grid)

    for frame in range(frames):
        # The next window: a sample leaves, the others turn by θ, a sample enters. For S = Σ y e^iθt
        # this is S ← e^−iθ (S − y_leaves e^−iθh) + y_enters e^iθh.
        for k in range(len(grid) if frame > 0 else 0):
            s = sums_sine[k] + curve[frame - 1] * end_sine[k]
            c = sums_cosine[k] - curve[frame - 1] * end_cosine[k]
            enters = curve[frame + n - 1]
            sums_sine[k] = cosine[k] * s - sine[k] * c + enters * end_sine[k]
            sums_cosine[k] = cosine[k] * c + sine[k] * s + enters * end_cosine[k]

        # the window less its middle: odd and even part, g1, and the sum of squares
        even[0] = g1 = curve[frame + half] - middle[frame]
        squares = g1 * g1
        for t in range(1, half + 1):
            before = curve[frame + half - t] - middle[frame]
            after = curve[frame + half + t] - middle[frame]
            odd[t], even[t] = after - before, after + before
            g1 += even[t]
            squares += before * before + after * after

        # the gain on the grid, and its highest peaks refined between the angles beside them
        for k in range(len(grid)):
            gc = sums_cosine[k] - middle[frame] * c1[k]
            gains[k] = _project(sums_sine[k], gc, g1, ss[k], cc[k], c1[k], n, spread[frame])[3]
        out[4, frame] = math.inf
        for _ in range(PEAKS):
            k = np.argmax(gains)
            if gains[k] < ENOUGH * (squares - out[4, frame]):
                break
            left, right = grid[max(k - 1, 0)], grid[min(k + 1, len(grid) - 1)]
            best = _refine(odd, even, g1, left, right, spread[frame])
            for theta in (grid[k], best):
                u, v, b, gain = _evaluate(odd, even, g1, theta, spread[frame])
                if squares - gain < out[4, frame]:
                    out[0, frame], out[1, frame], out[2, frame] = theta, u, v
                    out[3, frame], out[4, frame] = b + middle[frame], max(squares - gain, 0.0)
            _level(gains, k)


@compiled()
def _level(gains, k):
    """Set the peak at ``k`` and its slopes, down to the valleys on both sides, to −∞."""
    peak = gains[k]
    gains[k] = -math.inf
    for step in (-1, 1):
        height, at = peak, k + step
        while 0 <= at < len(gains) and -math.inf < gains[at] <= height:
            height, gains[at] = gains[at], -math.inf
            at += step


@compiled(error_model="numpy")
def _refine(odd, even, g1, left, right, spread):
    """The angle of the largest gain between two angles.

    Golden section (Kiefer 1953), and at its end the vertex of the parabola through three gains.
    """
    inner, outer = right - GOLDEN * (right - left), left + GOLDEN * (right - left)
    low = _evaluate(odd, even, g1, inner, spread)[3]
    high = _evaluate(odd, even, g1, outer, spread)[3]
    while right - left > PRECISION * right:
        if low > high:
            right, outer, high = outer, inner, low
            inner = right - GOLDEN * (right - left)
            low = _evaluate(odd, even, g1, inner, spread)[3]
        else:
            left, inner, low = inner, outer, high
            outer = left + GOLDEN * (right - left)
            high = _evaluate(odd, even, g1, outer, spread)[3]
    middle, step = (inner + outer) / 2, (outer - inner) / 2
    bend = low + high - 2 * _evaluate(odd, even, g1, middle, spread)[3]
    vertex = middle - step * (high - low) / (2 * bend) if bend < 0 else middle
    return min(max(vertex, left), right)


@compiled(error_model="numpy")
def _evaluate(odd, even, g1, theta, spread):
    """The best (u, v, b) at an angle, and the gain; ``odd``, ``even`` [h + 1] are of the window."""
    # gs and gc; sin θt and cos θt by recurrence
    sine, cosine = math.sin(theta), math.cos(theta)
    gs, gc = 0.0, even[0]
    s, s_before, c, c_before = sine, 0.0, cosine, 1.0
    for t in range(1, len(odd)):
        gs += odd[t] * s
        gc += even[t] * c
        s, s_before = 2 * cosine * s - s_before, s
        c, c_before = 2 * cosine * c - c_before, c
    n = 2 * len(odd) - 1
    ss, cc, c1 = _waves(theta, n)
    return _project(gs, gc, g1, ss, cc, c1, n, spread)


@compiled(error_model="numpy")
def _waves(theta, n):
    """ss, cc and c1 of an angle: Σ cos θt is sin(nθ/2) / sin(θ/2), and sin², cos² have 2θ."""
    c1, twice = np.sin(n * theta / 2) / np.sin(theta / 2), np.sin(n * theta) / np.sin(theta)
    return (n - twice) / 2, (n + twice) / 2, c1


@compiled(error_model="numpy")
def _project(gs, gc, g1, ss, cc, c1, n, spread):
    """The best (u, v, b) at an angle within the bounds, and its gain, from inner products.

    The bounds, a ≤ ``spread`` and b in ± ``spread`` / 2, are convex, and so is the error. Without
    them u = gs / ss, v follows from cos less its mean, and b = (g1 − v·c1) / n. Where b passes an
    end of its interval, it is set to this end, and (u, v) is solved again for that b. So this is
    the bounded optimum, not the clamped free one.
    """
    u, v = _in_ball(gs, gc - g1 * c1 / n, ss, cc - c1 * c1 / n, spread)
    b = (g1 - v * c1) / n
    if abs(b) > spread / 2:
        b = math.copysign(spread / 2, b)
        u, v = _in_ball(gs, gc - b * c1, ss, cc, spread)
    gain = 2 * (u * gs + v * gc + b * g1) - u * u * ss - v * v * cc - b * b * n - 2 * b * v * c1
    return u, v, b, gain


@compiled(error_model="numpy")
def _in_ball(p, q, alpha, beta, radius):
    """The (u, v) no longer than ``radius`` that minimises αu² + βv² − 2pu − 2qv.

    Where the ball binds it is (p / (α + λ), q / (β + λ)), λ found by Newton on 1 / length, which is
    concave and nearly linear in λ, so that steps from 0 never overshoot (Moré and Sorensen 1983).
    """
    u, v = p / alpha, q / beta
    square = u * u + v * v
    if square <= radius * radius:
        return u, v
    shift = 0.0
    # λ ← λ + (‖x‖/r − 1) ‖x‖² / xᵀ (A + λ)⁻¹ x, with x = (u, v) and A = diag(α, β)
    for _ in range(30):
        excess = math.sqrt(square) / radius - 1.0
        if not 1e-8 < excess < math.inf:
            break
        shift += excess * square / (u * u / (alpha + shift) + v * v / (beta + shift))
        u, v = p / (alpha + shift), q / (beta + shift)
        square = u * u + v * v
    scale = radius / math.sqrt(square)
    return u * scale, v * scale
