"""Exercises of the notebooks on the five losses and of restyling."""

from toolkit.course.checks import Exercise, draws, equals, same_as


def _cycle(x, code, restyle, encode):
    return (restyle(restyle(x, code), encode(x)) - x).square().sum(-1).mean()


def _cases() -> list[tuple]:
    x, code = draws(8, (6, 2), (6, 1))
    return [(x, code, lambda p, c: 0.8 * p + c, lambda p: p[:, 1:] / 3), (x, code, lambda p, c: p * c, lambda p: p[:, :1])]


def _adain(h, gamma, beta):
    mean, std = h.mean(1, keepdim=True), h.std(1, keepdim=True, correction=0)
    return (1 + gamma[:, None]) * (h - mean) / std + beta[:, None]


EXERCISES = {
    "08a.1": Exercise(
        same_as(_cycle, _cases,
                {"this is the identity loss: there is no way there and back.":
                 lambda x, code, restyle, encode: (restyle(x, encode(x)) - x).square().sum(-1).mean(),
                 "the way back needs the source's own code.":
                 lambda x, code, restyle, encode: (restyle(restyle(x, code), code) - x).square().sum(-1).mean(),
                 "the squared distance of a point is a sum over its coordinates.":
                 lambda x, code, restyle, encode: (restyle(restyle(x, code), encode(x)) - x).square().mean()}),
        "restyle with the code, restyle the result with encode(x), compare with x."),
    "08a.2": Exercise(
        same_as(lambda a, b, bound: (a - b).abs().mean(-1).clamp(max=bound).mean(),
                lambda: [(*draws(9, (9, 2), (9, 2)), bound) for bound in (0.3, 1.0, 9.0)],
                {"the bound is for each point, before the mean over the points.":
                 lambda a, b, bound: (a - b).abs().mean().clamp(max=bound),
                 "there is no bound.": lambda a, b, bound: (a - b).abs().mean()}),
        "abs, mean over the last axis, clamp(max=bound), mean."),
    "08a.3": Exercise(
        equals({"A": "ds", "B": "adv", "C": "cyc"}),
        "do three noises lie on each other? Are results outside the box? Are large dots not on the right?"),
    "08b.1": Exercise(
        same_as(_adain, lambda: [draws(10, (c, 20), (c,), (c,)) for c in (1, 4)],
                {"the scale is 1 + γ.": lambda h, gamma, beta: _adain(h, gamma - 1, beta),
                 "mean and deviation are over the frames, axis 1.":
                 lambda h, gamma, beta: (1 + gamma[:, None]) * (h - h.mean()) / h.std(correction=0) + beta[:, None]}),
        "subtract the mean over axis 1, divide by the deviation, multiply by 1 + γ, add β; use [:, None]."),
    "08b.2": Exercise(
        same_as(lambda x, plain, target: x + (target.mean((0, 2)) - plain.mean((0, 2)))[None, :, None],
                lambda: [tuple(x + k for k, x in enumerate(draws(11, (2, 5, 8), (6, 5, 8), (9, 5, 8))))],
                {"the sign is wrong: go from plain to target.":
                 lambda x, plain, target: x + (plain.mean((0, 2)) - target.mean((0, 2)))[None, :, None],
                 "take a mean for each number, not one of all.":
                 lambda x, plain, target: x + target.mean() - plain.mean()}),
        "mean((0, 2)) is the mean over windows and frames."),
    "08b.3": Exercise(
        same_as(lambda m, s, n, r: (m - n) ** 2 + (s - r) ** 2, lambda: [(0.0, 1.0, 2.0, 3.0), (1.0, 2.0, 1.0, 0.5)],
                {"this leaves the deviations out.": lambda m, s, n, r: (m - n) ** 2,
                 "the last term is missing: − 2 s r.": lambda m, s, n, r: (m - n) ** 2 + s**2 + r**2}),
        "Σ is the square of the deviation: s² + r² − 2 s r."),
}
