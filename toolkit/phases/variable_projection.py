"""The compiled part of `toolkit.phases.sinusoids`, whose docstring has the mathematics."""

import math

import numpy as np

from toolkit.io.compilation import compiled


@compiled(error_model="numpy")
def _in_ball(p, q, alpha, beta, radius):
    """The (u, v) no longer than ``radius`` that minimises αu² + βv² − 2pu − 2qv.

    Where the ball binds it is (p / (α + λ), q / (β + λ)), λ found by Newton on 1 / length, which is concave and nearly
    linear in λ, so that steps from 0 never overshoot (Moré and Sorensen 1983).
    """
    u, v = p / alpha, q / beta
    square = u * u + v * v
    if square <= radius * radius:
        return u, v
    shift = 0.0
    for _ in range(30):
        excess = math.sqrt(square) / radius - 1.0
        if not 1e-8 < excess < math.inf:
            break
        shift += excess * square / (u * u / (alpha + shift) + v * v / (beta + shift))
        u, v = p / (alpha + shift), q / (beta + shift)
        square = u * u + v * v
    scale = radius / math.sqrt(square)
    return u * scale, v * scale


@compiled(error_model="numpy")
def _project(gs, gc, g1, ss, cc, c1, n, spread):
    """The best (u, v, b) within the bounds for one frequency, and its gain, from the inner products of a window.

    The error minimised over (u, v) is convex in b, so a b out of bounds is set to its bound.
    """
    u, v = _in_ball(gs, gc - g1 * c1 / n, ss, cc - c1 * c1 / n, spread)
    b = (g1 - v * c1) / n
    if abs(b) > spread / 2:
        b = math.copysign(spread / 2, b)
        u, v = _in_ball(gs, gc - b * c1, ss, cc, spread)
    return u, v, b, 2 * (u * gs + v * gc + b * g1) - u * u * ss - v * v * cc - b * b * n - 2 * b * v * c1


@compiled(error_model="numpy")
def _evaluate(odd, even, g1, theta, spread):
    """`_project` at angle ``theta`` per frame, and the derivative of the gain with respect to it.

    ``odd`` and ``even`` [half + 1] are the parts of the window about its middle.
    """
    n = 2 * len(odd) - 1
    s2, c2 = math.sin(theta / 2), math.cos(theta / 2)
    sine, cosine = 2 * s2 * c2, 1 - 2 * s2 * s2
    gs, gc, ts, tc = 0.0, even[0], 0.0, 0.0
    gs_too, gc_too, ts_too, tc_too = 0.0, 0.0, 0.0, 0.0
    double = 2 * sine * cosine, 1 - 2 * sine * sine
    s, s_before, c, c_before = sine, -sine, cosine, cosine  # at odd t; below at even t: two independent recurrences
    s_too, s_too_before, c_too, c_too_before = double[0], 0.0, double[1], 1.0
    ahead = 2 * double[1]
    for t in range(1, len(odd) - 1, 2):
        gs += odd[t] * s
        gc += even[t] * c
        ts += t * odd[t] * c
        tc += t * even[t] * s
        gs_too += odd[t + 1] * s_too
        gc_too += even[t + 1] * c_too
        ts_too += (t + 1) * odd[t + 1] * c_too
        tc_too += (t + 1) * even[t + 1] * s_too
        s, s_before, c, c_before = ahead * s - s_before, s, ahead * c - c_before, c
        s_too, s_too_before, c_too, c_too_before = ahead * s_too - s_too_before, s_too, ahead * c_too - c_too_before, c_too
    if len(odd) % 2 == 0:
        t = len(odd) - 1
        gs, gc, ts, tc = gs + odd[t] * s, gc + even[t] * c, ts + t * odd[t] * c, tc + t * even[t] * s
    else:
        s, c = s_too_before, c_too_before
    gs, gc, ts, tc = gs + gs_too, gc + gc_too, ts + ts_too, tc + tc_too
    # cos(θt) sums to sin(nθ/2) / sin(θ/2) over the window; the same at 2θ gives the sums of squares
    top, slope = s * c2 + c * s2, c * c2 - s * s2
    c1 = top / s2
    twice = 2 * top * slope / sine
    c1_slope = (n * slope - c1 * c2) / (2 * s2)
    twice_slope = (n * (1 - 2 * top * top) - twice * cosine) / sine
    u, v, b, gain = _project(gs, gc, g1, (n - twice) / 2, (n + twice) / 2, c1, n, spread)
    return u, v, b, gain, 2 * (u * ts - v * tc - b * v * c1_slope) + (u * u - v * v) * twice_slope / 2


@compiled(error_model="numpy")
def _refine(odd, even, g1, gg, theta, ends, spread):
    """The peak of the gain between ``ends`` (two angles and their gains): Newton on its slope from ``theta``.

    The first second derivative is that of the cubic through the known values, the later ones are differences of the slope. A
    step out of the interval goes to its end, or to the middle if that end was passed before.
    """
    left, right, left_gain, right_gain = ends
    left_is_new, right_is_new = True, True
    last, last_slope = theta, math.inf
    for _ in range(40):
        u, v, b, gain, slope = _evaluate(odd, even, g1, theta, spread)
        before, after = left - theta, right - theta
        if last != theta:
            bend = (slope - last_slope) / (theta - last)
        elif before < 0 and after > 0:
            at_left = (left_gain - gain - slope * before) / before**2
            at_right = (right_gain - gain - slope * after) / after**2
            bend = 2 * (at_left * after - at_right * before) / (after - before)
        else:
            bend = 0.0
        if slope > 0:
            left, left_is_new = theta, False
        else:
            right, right_is_new = theta, False
        if left >= right or slope * slope <= -2 * bend * 5e-7 * max(gg - gain, 1e-15 * gg):
            break
        target = theta - slope / bend if bend < 0 else math.copysign(math.inf, slope)
        if target >= right:
            target = right if right_is_new else (left + right) / 2
        elif target <= left:
            target = left if left_is_new else (left + right) / 2
        if target == theta:
            break
        last, last_slope, theta = theta, slope, target
    return theta, u, v, b, gain


@compiled(error_model="numpy")
def _peaks(gains, grid, peaks):
    """Peaks of the gain on the grid, one row each: upper estimate of the gain, index, first angle per frame.

    The first angle is the vertex of the parabola through three neighbours. The estimate adds eight times the rise of the
    parabola, because a peak is not a parabola where a bound becomes active.
    """
    found, last = 0, len(grid) - 1
    for k in range(last + 1):
        if (k == 0 or gains[k] > gains[k - 1]) and (k == last or gains[k] >= gains[k + 1]):
            m = min(max(k, 1), last - 1)
            before, after = grid[m] - grid[m - 1], grid[m + 1] - grid[m]
            below, above = (gains[m] - gains[m - 1]) / before, (gains[m + 1] - gains[m]) / after
            bend = 2 * (above - below) / (before + after)
            slope = below + bend * (before / 2 + grid[k] - grid[m])
            start = grid[k] - slope / bend if bend < 0 else grid[k]
            start = min(max(start, grid[max(k - 1, 0)]), grid[min(k + 1, last)])
            peaks[found, 0], peaks[found, 1], peaks[found, 2] = gains[k] + 4 * (start - grid[k]) * slope, k, start
            found += 1
    return found


@compiled(error_model="numpy")
def minima(curve, low, high, grid, out):
    """Write the least error of every window over frequency to ``out`` float64 [5, F].

    The rows of ``out`` are angle per frame, u, v, b and squared error. ``curve`` has [F + 2 half] samples; ``low`` and
    ``high`` [F] are the extremes of each window; ``grid`` [G] has the angles per frame, its ends the bounds. All float64.
    """
    frames, size = len(low), len(grid)
    half = (len(curve) - frames) // 2
    n = 2 * half + 1
    cosine, sine = np.cos(grid), np.sin(grid)
    end_cosine, end_sine = np.cos(half * grid), np.sin(half * grid)
    c1 = np.sin(n * grid / 2) / np.sin(grid / 2)
    twice = np.sin(n * grid) / sine
    ss, cc = (n - twice) / 2, (n + twice) / 2
    per_ss, per_cc, c1_mean = 1 / ss, 1 / (cc - c1 * c1 / n), c1 / n

    sums_sine, sums_cosine = np.zeros(size), np.zeros(size)
    for t in range(n):
        sums_sine += curve[t] * np.sin((t - half) * grid)
        sums_cosine += curve[t] * np.cos((t - half) * grid)
    gains, outside = np.empty(size), np.empty(size)
    peaks = np.empty((size, 3))
    odd, even = np.zeros(half + 1), np.empty(half + 1)

    for frame in range(frames):
        if frame > 0:
            gone, come = curve[frame - 1], curve[frame + n - 1]
            for k in range(size):
                s = sums_sine[k] + gone * end_sine[k]
                c = sums_cosine[k] - gone * end_cosine[k]
                sums_sine[k] = cosine[k] * s - sine[k] * c + come * end_sine[k]
                sums_cosine[k] = cosine[k] * c + sine[k] * s + come * end_cosine[k]
        spread, middle = high[frame] - low[frame], (low[frame] + high[frame]) / 2
        centre = curve[frame + half] - middle
        even[0], g1, gg = centre, centre, centre * centre
        for t in range(1, half + 1):
            before, after = curve[frame + half - t] - middle, curve[frame + half + t] - middle
            odd[t], even[t] = after - before, after + before
            g1 += even[t]
            gg += before * before + after * after
        for k in range(size):
            gc = sums_cosine[k] - middle * c1[k] - g1 * c1_mean[k]
            u, v = sums_sine[k] * per_ss[k], gc * per_cc[k]
            b = g1 / n - v * c1_mean[k]
            gains[k] = u * sums_sine[k] + v * gc + g1 * g1 / n
            outside[k] = max(u * u + v * v - spread * spread, abs(b) - spread / 2)
        floor = -math.inf  # largest gain within bounds; smaller ones need no projection
        for k in range(size):
            if outside[k] <= 0 and gains[k] > floor:
                floor = gains[k]
        for k in range(size):
            if outside[k] > 0 and gains[k] > floor:
                gc = sums_cosine[k] - middle * c1[k]
                gains[k] = _project(sums_sine[k], gc, g1, ss[k], cc[k], c1[k], n, spread)[3]

        out[4, frame] = math.inf
        found = _peaks(gains, grid, peaks)
        for _ in range(found):
            best = np.argmax(peaks[:found, 0])
            if peaks[best, 0] <= gg - out[4, frame]:
                break
            peaks[best, 0] = -math.inf
            k, start = int(peaks[best, 1]), peaks[best, 2]
            left, right = max(k - 1, 0), min(k + 1, size - 1)
            ends = grid[left], grid[right], gains[left], gains[right]
            theta, u, v, b, gain = _refine(odd, even, g1, gg, start, ends, spread)
            if gg - gain < out[4, frame]:
                out[0, frame], out[1, frame], out[2, frame] = theta, u, v
                out[3, frame], out[4, frame] = b + middle, max(gg - gain, 0.0)


@compiled()
def smoothest(cost, jump):
    """The path ``[F]`` through M states with the least sum of costs ``[F, M]`` and jumps ``[M, M]`` (Viterbi 1967)."""
    total, back = cost[0].copy(), np.empty(cost.shape, np.int64)
    for frame in range(1, len(cost)):
        before = total.copy()
        for new in range(len(jump)):
            reached = before + jump[:, new]
            back[frame, new] = np.argmin(reached)
            total[new] = reached[back[frame, new]] + cost[frame, new]
    path = np.empty(len(cost), np.int64)
    path[-1] = np.argmin(total)
    for frame in range(len(cost) - 1, 0, -1):
        path[frame - 1] = back[frame, path[frame]]
    return path
