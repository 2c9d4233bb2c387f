"""Exercises of the notebooks on blends, the space of styles, a new style, the five losses, and
restyling.
"""

from functools import cache

import torch
from course import plane
from course.checks import Exercise, draws, equals, same_as, shows

import toolkit as tk
from toolkit.motion.contacts import velocities

CORNERS = "Neutral", "Zombie", "Aeroplane"  # of exercise 04.1


@cache
def _embedded() -> tuple:
    """The embedded model, compiled if that pays, and its styles."""
    model, bank = tk.pretrained()
    return tk.runtime.quick(model, 180), bank


@cache
def _hands(*weights: float) -> tuple[float, float]:
    """How far the hands of a blend of `CORNERS` are ahead, and apart; metres."""
    model, bank = _embedded()
    style = sum(weight * bank[name] for weight, name in zip(weights, CORNERS, strict=True))
    walk = tk.runtime.rollout(model, tk.runtime.straight(1.0, 3.0), style=style)
    hands = [walk.skeleton.index(f"{side}_hand") for side in ("left", "right")]
    places = tk.motion.root_frames(walk).to_local(walk.global_positions)[60:, hands]
    return float(places[..., 2].mean()), float((places[:, 0] - places[:, 1]).norm(dim=-1).mean())


def _went(weights: dict) -> tuple[float, float]:
    """The share of the way from Neutral to Zombie ahead, and to Aeroplane apart."""
    here = _hands(*(round(float(weights[name]), 3) for name in CORNERS))
    low, ahead, apart = _hands(1, 0, 0), _hands(0, 1, 0)[0], _hands(0, 0, 1)[1]
    return (here[0] - low[0]) / (ahead - low[0]), (here[1] - low[1]) / (apart - low[1])


def _toe(places) -> torch.Tensor:
    return torch.as_tensor(places).double()


def _weights_at(point, corners):
    sides = torch.stack((corners[1] - corners[0], corners[2] - corners[0]), 1)
    second, third = torch.linalg.solve(sides, point - corners[0])
    return torch.stack((1 - second - third, second, third))


def _triangles() -> list[tuple]:
    corners = torch.tensor([[0.0, 0.0], [1.0, 0.0], [0.5, 0.87]])
    points = corners.mean(0), corners[1], torch.tensor([0.4, 0.1]), torch.tensor([1.2, 0.3])
    return [(point, corners) for point in points] + [(points[2], 2 * corners.flip(0) + 1)]


def _place(first, second, vector):
    way = second - first
    return (vector - first) @ way / (way @ way)


def _three(vectors) -> torch.Tensor:
    return torch.stack([torch.as_tensor(vector).double() for vector in vectors])


def _nearer(vectors, query: int, near: int, far: int) -> bool:
    """Whether the vector ``near`` is nearer to the query than ``far`` is."""
    query, near, far = _three(vectors)[[query, near, far]]
    return float((near - query).norm()) < float((far - query).norm())


def _better_than_nothing(errors: dict) -> bool:
    return 0 < errors["after"] < errors["before"] / 2


def _places(points) -> torch.Tensor:
    return torch.as_tensor(points).float()


def _code_of(reference):
    return torch.stack((reference.std(1, correction=0) - 1, reference.mean(1)))


CONTENTS = [0, 0, 1, 1, 2, 2]  # of the six windows of exercise 08b.2

def _best(k, a, lam, mean, deviation):
    pull = lam / deviation**2
    return (k * a + pull * mean) / (k + pull)


EXERCISES = {
    "04.1": Exercise(
        shows(
            ("give a dictionary with weights of Neutral, Zombie and Aeroplane",
             lambda x: isinstance(x, dict) and set(x) == set(CORNERS)),
            ("the weights should sum to one", lambda x: abs(sum(x.values()) - 1) < 1e-3),
            ("the hands are not half way ahead", lambda x: abs(_went(x)[0] - 0.5) < 0.04),
            ("the hands are not half way apart", lambda x: abs(_went(x)[1] - 0.5) < 0.04),
        ),
        "which of the two styles moves the hands ahead, and with which share are they half way?",
        "compute both lengths of section 3 for shares of 0.2, 0.25 … and take the nearest.",
    ),
    "04.2": Exercise(
        shows(
            ("give ten places or more, [F, 3]", lambda x: len(x) > 9 and _toe(x).shape[1:] == (3,)),
            ("the measure sees this: the toe moves over the floor", lambda x: float(
                velocities(_toe(x), 60.0)[:, [0, 2]].norm(dim=1).mean()) < 0.001),
            ("the toe stands still", lambda x: float(
                velocities(_toe(x), 60.0).norm(dim=1).mean()) > 0.05),
        ),
        "which of the three coordinates does the measure not read?",
        "let the toe go up and down.",
    ),
    "04.3": Exercise(
        same_as(
            _weights_at,
            _triangles,
            {
                "these are distances: a weight is one in its own corner.": lambda point, corners: (
                    corners - point
                ).norm(dim=1),
                "a marker outside has a negative weight.": lambda point, corners: (
                    _weights_at(point, corners).abs() / _weights_at(point, corners).abs().sum()),
            },
        ),
        "how many unknowns are there, and which equations do they fulfil?",
        "weights @ corners = point has two equations, and the sum of the weights is one.",
    ),
    "05.1": Exercise(
        same_as(
            _place, lambda: [draws(5, (4,), (4,), (4,)), draws(6, (9,), (9,), (9,))],
            {
                "divide by the square of the distance of the two ends.":
                    lambda first, second, vector: _place(first, second, vector)
                    * (second - first).norm(),
                "this is the place seen from the other end.":
                    lambda first, second, vector: _place(second, first, vector),
            },
        ),
        "which number is t if the vector is at the first end, at the second, in the middle?",
        "the dot product of vector − first with second − first, over that of second − first "
        "with itself.",
    ),
    "05.2": Exercise(
        shows(
            ("give three vectors of two numbers", lambda three: _three(three).shape == (3, 2)),
            ("the nearest to `a` is not `b`", lambda three: _nearer(three, 0, 1, 2)),
            ("the nearest to `b` is `a`, too", lambda three: _nearer(three, 1, 2, 0)),
        ),
        "where must a third vector be, so that b has a nearer neighbour than a?",
        "put the three on a line: a, then b, and c on the far side of b, closer to b.",
    ),
    "05.3": Exercise(
        same_as(
            lambda length, angle: length * (angle / 2).cos(),
            lambda: [(0.6, torch.tensor(a)) for a in (0.0, 2.0)] + [(0.3, torch.tensor(2.6))],
            {
                "this is half of the distance between the two positions of the hand.":
                    lambda length, angle: length * (angle / 2).sin(),
                "use half of the angle: the middle is on the line that halves it.":
                    lambda length, angle: length * angle.cos(),
            },
        ),
        "draw the shoulder and both positions of the hand. Which triangle is it?",
        "an isosceles triangle: its height is length · cos(angle / 2).",
    ),
    "06.1": Exercise(
        same_as(
            _best,
            lambda: [(2.0, 1.0, 0.15, -1.0, 0.5), (1.0, 3.0, 15.0, 0.5, 2.0)],
            {
                "divide λ by the square of the deviation.":
                    lambda k, a, lam, mean, d: _best(k, a, lam * d, mean, d),
                "the error counts, too: it is k times as steep.":
                    lambda k, a, lam, mean, d: _best(1.0, a, lam, mean, d),
            },
        ),
        "what is the slope of the sum, and what is it at the smallest value?",
        "k · (v − a) + λ / σ² · (v − μ) = 0: solve for v.",
    ),
    "06.2": Exercise(
        same_as(
            lambda v, matrix, z, rate: v - 2 * rate * matrix.T @ (matrix @ v - z),
            lambda: [(*draws(12, (2,), (3, 2), (3,)), 0.03), (*draws(13, (4,), (9, 4), (9,)), 0.1)],
            {
                "this goes up the slope.": lambda v, matrix, z, rate: (
                    v + 2 * rate * matrix.T @ (matrix @ v - z)
                ),
                "the derivative of a square has the factor two.": lambda v, matrix, z, rate: (
                    v - rate * matrix.T @ (matrix @ v - z)
                ),
            },
        ),
        "what is the derivative of ‖W v − z‖² by v?",
        "the slope is 2 Wᵀ (W v − z); go against it, times the rate.",
    ),
    "06.3": Exercise(
        shows(
            ("give the four numbers by name, all above zero", lambda x: isinstance(x, dict) and set(
                x) == {"before", "after", "mean", "repeat"} and min(x.values()) > 0),
            ("the rule refuses these errors", _better_than_nothing),
            ("a floor is worse than this vector",
             lambda x: x["after"] > max(x["mean"], x["repeat"])),
        ),
        "what does the rule not look at?",
        "make `before` large, `after` less than half of it, and both floors smaller.",
    ),
    "08a.1": Exercise(
        equals({"cyc", "id"}, {
            "`adv` is large: a plain walk is not in the target domain": {"adv", "cyc", "id"},
            "`cyc` is small, too: there and back is the source": {"id"},
            "`id` is small, too": {"cyc"},
            "`ds` should be large, and it is zero": {"cyc", "id", "ds"},
            "the code cannot be read back from a result that ignores it": {"cyc", "id", "sty"},
        }),
        "put G(x, s) = x into each formula of the table. What is left?",
        "two formulas become zero; the other three do not become what they should.",
    ),
    "08a.2": Exercise(
        shows(
            ("give ten results, [10, 2]", lambda x: _places(x).shape == (10, 2)),
            ("the judge refuses a result", lambda x: plane.outside(_places(x), 1).max() < 1e-6),
            ("two results have the same height",
             lambda x: _places(x)[:, 1].sort().values.diff().min() > 1e-3),
            ("the results have one content: a correlation needs several",
             lambda x: _places(x)[:, 0].std() > 0.05),
            ("the contents are still correlated",
             lambda x: torch.corrcoef(torch.stack(
                 (torch.linspace(-0.9, 0.9, 10), _places(x)[:, 0])))[0, 1].abs() < 0.1),
        ),
        "does the judge know from which source a result comes?",
        "give contents that are the same on the left and on the right, such as |content|.",
    ),
    "08a.3": Exercise(
        equals({"A": "ds", "B": "adv", "C": "cyc"}),
        "where do three noises lie on each other? Which results are outside the box?",
        "A: one colour covers the others. B: outside. C: compare the two measures above.",
    ),
    "08b.1": Exercise(
        same_as(
            _code_of,
            lambda: [draws(10, (c, 20)) for c in (1, 4)],
            {
                "the scale of AdaIN is 1 + γ.": lambda r: _code_of(r) + torch.tensor([[1.0], [0]]),
                "γ is the first row.": lambda r: _code_of(r).flip(0),
                "mean and deviation are over the frames, axis 1.": lambda r: _code_of(r.T),
            },
        ),
        "after IN, mean and deviation are 0 and 1. Which are they after AdaIN?",
        "AdaIN makes the deviation 1 + γ and the mean β: set both to those of the reference.",
    ),
    "08b.2": Exercise(
        shows(
            ("give the numbers 0 to 5, each once", lambda x: sorted(map(int, x)) == list(range(6))),
            ("a result has the content of its source", lambda x: all(
                CONTENTS[int(k)] != content for k, content in zip(x, CONTENTS, strict=True))),
        ),
        "the FMD compares two sets. Does it know which result belongs to which source?",
        "give each source a window of another content, such as [2, 3, 4, 5, 0, 1].",
    ),
    "08b.3": Exercise(
        same_as(
            lambda m, s, n, r: (m - n) ** 2 + (s - r) ** 2,
            lambda: [(0.0, 1.0, 2.0, 3.5), (1.0, 2.0, 1.0, 0.5), (3.0, 1.0, -1.0, 1.0)],
            {
                "this leaves the deviations out.": lambda m, s, n, r: (m - n) ** 2,
                "the last term is missing: − 2 s r.": lambda m, s, n, r: (m - n) ** 2 + s**2 + r**2
            },
        ),
        "what is Σ of one feature, and what is the square root of the product of two of them?",
        "Σ is the square of the deviation: s² + r² − 2 s r = (s − r)².",
    ),
}
