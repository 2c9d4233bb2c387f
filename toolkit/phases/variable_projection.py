"""The compiled part of `toolkit.phases.sinusoids`, whose docstring has the mathematics."""

import math

import numpy as np

from toolkit.io.compilation import compiled


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
    """The best (u, v, b) within the bounds for one frequency, and its gain, from inner products.

    The error minimised over (u, v) is convex in b, so a b out of bounds is set to its bound.
    """
    u, v = _in_ball(gs, gc - g1 * c1 / n, ss, cc - c1 * c1 / n, spread)
    b = (g1 - v * c1) / n
    if abs(b) > spread / 2:
        b = math.copysign(spread / 2, b)
        u, v = _in_ball(gs, gc - b * c1, ss, cc, spread)
    gain = 2 * (u * gs + v * gc + b * g1) - u * u * ss - v * v * cc - b * b * n - 2 * b * v * c1
    return u, v, b, gain


@compiled(error_model="numpy")
def _evaluate(odd, even, g1, theta, spread):
    """`_project` at angle ``theta`` per frame, and the derivative of the gain with respect to it.

    ``odd`` and ``even`` [half + 1] are the parts of the window about its middle.
    """
    n = 2 * len(odd) - 1
    sine, cosine = math.sin(theta), math.cos(theta)
    # inner products with sin θt and cos θt, and their derivatives; sin and cos by recurrence
    gs, gc, gs_slope, gc_slope = 0.0, even[0], 0.0, 0.0
    s, s_before, c, c_before = sine, 0.0, cosine, 1.0
    for t in range(1, len(odd)):
        gs += odd[t] * s
        gc += even[t] * c
        gs_slope += t * odd[t] * c
        gc_slope -= t * even[t] * s
        s, s_before = 2 * cosine * s - s_before, s
        c, c_before = 2 * cosine * c - c_before, c
    # cos(θt) sums to sin(nθ/2) / sin(θ/2) over the window; the same at 2θ gives the sums of squares
    half_sine, half_cosine = math.sin(theta / 2), math.cos(theta / 2)
    top, slope = math.sin(n * theta / 2), math.cos(n * theta / 2)
    c1 = top / half_sine
    twice = 2 * top * slope / sine
    c1_slope = (n * slope - c1 * half_cosine) / (2 * half_sine)
    twice_slope = (n * (1 - 2 * top * top) - twice * cosine) / sine
    u, v, b, gain = _project(gs, gc, g1, (n - twice) / 2, (n + twice) / 2, c1, n, spread)
    gain_slope = 2 * (u * gs_slope + v * gc_slope - b * v * c1_slope)
    return u, v, b, gain, gain_slope + (u * u - v * v) * twice_slope / 2


@compiled(error_model="numpy")
def _refine(odd, even, g1, gg, theta, ends, spread):
    """The peak of the gain between ``ends`` (two angles and their gains), by Newton on its slope.

    A step out of the interval goes to its end, or to the middle if that end was passed before.
    """
    left, right, left_gain, right_gain = ends
    left_is_new, right_is_new = True, True
    last, last_slope = theta, math.inf
    for _ in range(40):
        u, v, b, gain, slope = _evaluate(odd, even, g1, theta, spread)
        # second derivative: a difference of slopes, at first that of the cubic through the gains
        before, after = left - theta, right - theta
        if last != theta:
            bend = (slope - last_slope) / (theta - last)
        elif before < 0 and after > 0:
            at_left = (left_gain - gain - slope * before) / before**2
            at_right = (right_gain - gain - slope * after) / after**2
            bend = 2 * (at_left * after - at_right * before) / (after - before)
        else:
            bend = 0.0
        # the peak lies where the slope points to
        if slope > 0:
            left, left_is_new = theta, False
        else:
            right, right_is_new = theta, False
        # Newton expects to gain slope² / (−2 bend) more: stop where that is next to nothing
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
    """Peaks of the gain on the grid, one row each: upper estimate of the gain, index, first angle.

    The first angle is the vertex of the parabola through three neighbours. The estimate adds eight
    times the rise of the parabola, because a peak is no parabola where a bound becomes active.
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
            peaks[found, 0] = gains[k] + 4 * (start - grid[k]) * slope
            peaks[found, 1], peaks[found, 2] = k, start
            found += 1
    return found


@compiled(error_model="numpy")
def minima(curve, low, high, grid, out):
    """Write the least error of every window over frequency to ``out`` float64 [5, F].

    The rows of ``out`` are angle per frame, u, v, b and squared error. ``curve`` has [F + 2 half]
    samples; ``low`` and ``high`` [F] are the extremes of each window; ``grid`` [G] has angles per
    frame, its ends the bounds.
    """
    # what the grid needs in all windows: the inner products of sin, cos and 1 with each other
    frames, size = len(low), len(grid)
    half = (len(curve) - frames) // 2
    n = 2 * half + 1
    cosine, sine = np.cos(grid), np.sin(grid)
    end_cosine, end_sine = np.cos(half * grid), np.sin(half * grid)
    c1 = np.sin(n * grid / 2) / np.sin(grid / 2)
    twice = np.sin(n * grid) / sine
    ss, cc = (n - twice) / 2, (n + twice) / 2
    per_ss, per_cc, c1_mean = 1 / ss, 1 / (cc - c1 * c1 / n), c1 / n

    # inner products of the first window with sin and cos, which the next windows continue
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
        # the window less its middle: odd and even part, sum, sum of squares
        spread, middle = high[frame] - low[frame], (low[frame] + high[frame]) / 2
        centre = curve[frame + half] - middle
        even[0], g1, gg = centre, centre, centre * centre
        for t in range(1, half + 1):
            before, after = curve[frame + half - t] - middle, curve[frame + half + t] - middle
            odd[t], even[t] = after - before, after + before
            g1 += even[t]
            gg += before * before + after * after
        # gains of the free optimum on the grid, and how far it is out of bounds
        for k in range(size):
            gc = sums_cosine[k] - middle * c1[k] - g1 * c1_mean[k]
            u, v = sums_sine[k] * per_ss[k], gc * per_cc[k]
            b = g1 / n - v * c1_mean[k]
            gains[k] = u * sums_sine[k] + v * gc + g1 * g1 / n
            outside[k] = max(u * u + v * v - spread * spread, abs(b) - spread / 2)
        # a free gain is an upper limit: only those above the largest within bounds are projected
        floor = -math.inf
        for k in range(size):
            if outside[k] <= 0 and gains[k] > floor:
                floor = gains[k]
        for k in range(size):
            if outside[k] > 0 and gains[k] > floor:
                gc = sums_cosine[k] - middle * c1[k]
                gains[k] = _project(sums_sine[k], gc, g1, ss[k], cc[k], c1[k], n, spread)[3]

        # refine the peaks, the most promising first, until none can be better
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
    """The path ``[F]`` of states with the least sum of costs ``[F, M]`` and jumps ``[M, M]``.

    Viterbi 1967.
    """
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
