"""Answers to the exercises: a right one by another way than the notebook's solution, wrong ones."""

# ruff: noqa: B905, C408 (as a reader writes them)

import math

import numpy as np
import torch

import toolkit as tk

PI = math.pi
LEG = torch.tensor([[0.0, 1.0, 0.0], [0.0, 0.55, 0.1], [0.0, 0.1, 0.0]])  # of exercise 03b.3
RIGHT, WRONG = {}, {}
RIGHT["00.1"] = [dict(Old=1/4, Zombie=3/4), dict(Zombie=.75, Old=.25), dict(Old=-.5, Zombie=1.5)]
WRONG["00.1"] = [
    dict(Old=.75, Zombie=.25), dict(Old=25, Zombie=75), dict(Zombie=.75), dict(Old=1/3, Zombie=2/3),
    dict(Old=.2, Zombie=.8),
]
RIGHT["00.2"] = [.7, .71, 3 - 2.3]
WRONG["00.2"] = [2.3, -.7, .65, .75, 3., .0383]
RIGHT["00.3"] = [dict(Neutral=0.59, Aeroplane=0.41)]
WRONG["00.3"] = [
    dict(Neutral=1.0, Aeroplane=0.0), dict(Neutral=0.5, Aeroplane=0.5),
    dict(Neutral=0.4, Aeroplane=0.6),
]
RIGHT["01.1"] = [
    lambda own, root, angle: torch.view_as_real(
        torch.view_as_complex(root.flip(0).contiguous())
        + torch.view_as_complex(own.flip(0).contiguous()) * torch.exp(1j * angle)
    ).flip(0),
]
RIGHT["01.2"] = [(2 * PI, (0, 0, -4))]
WRONG["01.2"] = [(1, (4, 0, 0)), (0, (0, 3, 0)), (0, (1, 0, 1)), (2 * PI, (0, 0, 0))]
RIGHT["01.3"] = [
    lambda turns, pairs: (
        torch.stack([turns[:, k] for k in pairs], 1)
        * torch.outer(torch.tensor([-1.0, 1, 1]), torch.tensor([-1.0, 1, 1]))
    ),
]
RIGHT["02a.1"] = [
    lambda contact, half: (
        np.convolve(np.pad(contact.numpy(), half, mode="edge"), np.ones(2 * half + 1), "valid")
        > half
    ),
]
RIGHT["02a.2"] = [
    lambda phase, fps: (
        float(np.unwrap(phase.numpy())[-1] - phase[0]) / (len(phase) - 1) * fps / (2 * PI)
    ),
]
RIGHT["02a.3"] = [
    lambda s: np.sqrt(2 * (1 - np.cos(2 * PI * s)) / (s - s * s)) / PI,
]
RIGHT["02b.1"] = [(torch.arange(30.) + 2 * PI * (torch.arange(30) > 14), torch.arange(30.))]
WRONG["02b.1"] = [
    (torch.zeros(20), torch.zeros(20)), (torch.arange(20.) + 2, torch.arange(20.)),
    (1.05 * torch.arange(20.) + 2, torch.arange(20.)),
]
RIGHT["03a.1"] = [lambda first, second: np.roots([second - first, first])[0].real]
RIGHT["03a.2"] = [(torch.arange(9.), 3 * torch.arange(9.) - 2), ([.01, .02, .04], [.02, .04, .08])]
WRONG["03a.2"] = [
    ([1, 2], [2, 1]), (torch.arange(9.), torch.arange(9.) ** 2), ([1.], [2.]),
    ([1000, 2000, 4000], [1000, 2000, 4008]),
]
RIGHT["03a.3"] = [
    lambda a, h, b, k: k * (torch.nn.Linear(a, h).weight.numel() + h * h + h * b + 2 * h + b),
]
RIGHT["03b.1"] = [
    lambda p, q, parents: np.abs(
        np.linalg.norm((p[:, 1:] - p[:, parents[1:]]).numpy(), axis=2)
        - np.linalg.norm((q[:, 1:] - q[:, parents[1:]]).numpy(), axis=2)
    ).mean(),
]
RIGHT["03b.2"] = [
    lambda a, b, n: torch.tensor([b * sum(a**k for k in range(i)) for i in range(1, n + 1)]),
]
UP = torch.tensor([0.0, 1.0, 0.0])  # the hip
RIGHT["03b.3"] = [
    (LEG - UP) @ torch.tensor([[0., -1, 0], [1, 0, 0], [0, 0, 1]]) + UP,
    [(0, 1, 0), (0, 0.55, 0.1), (0, 1, 0.2)],  # the lower leg folded up
]
WRONG["03b.3"] = [LEG + 1, LEG + .01, 2 * LEG - UP, LEG[:2]]
RIGHT["04.1"] = [
    dict(Aeroplane=.4, Zombie=.25, Neutral=.35), dict(Neutral=.34, Zombie=.27, Aeroplane=.39),
    dict(Neutral=.36, Zombie=.25, Aeroplane=.39),
]
WRONG["04.1"] = [
    dict(Neutral=.25, Zombie=.25, Aeroplane=.5), dict(Neutral=1/3, Zombie=1/3, Aeroplane=1/3),
    dict(Neutral=0, Zombie=.5, Aeroplane=.5), dict(Neutral=.35, Zombie=.39, Aeroplane=.26),
    dict(Zombie=.6, Aeroplane=.4), dict(Neutral=.2, Zombie=.4, Aeroplane=.4),
]
RIGHT["04.2"] = [[(0, .1 * math.sin(k), 0) for k in range(60)]]
WRONG["04.2"] = [
    torch.ones(20, 3), torch.arange(60.).view(20, 3), torch.zeros(20, 2),
]
RIGHT["04.3"] = [
    lambda point, corners: (
        torch.stack(
            [
                torch.det(torch.stack([corners[(i + 1) % 3] - point, corners[(i + 2) % 3] - point]))
                for i in range(3)
            ]
        )
        / torch.det(corners[1:] - corners[:1])
    ),
]
RIGHT["05.1"] = [
    lambda a, b, v: torch.linalg.lstsq((b - a)[:, None], (v - a)[:, None]).solution[0, 0],
]
RIGHT["05.2"] = [
    ((0, 0), (0, 1), (0, 1.5)), [[5, 5], [1, 1], [0, 0]], torch.tensor([[9., 0], [0, 0], [0, 8]]),
    ((-3, 4), (0, 0), (1, -1)),
]
WRONG["05.2"] = [
    ((0, 0), (1, 0), (2, 0)), ((0, 0), (2, 0), (-1, 0)), ((0, 0), (1, 0), (3, 0)),
    ((0,), (2,), (3,)), ((0, 0), (2, 0)), ((1, 1), (1, 1), (1, 1)), ((3, 0), (2, 0), (0, 0)),
]
RIGHT["05.3"] = [lambda length, angle: length * ((1 + angle.cos()) / 2).sqrt()]
RIGHT["06.1"] = [
    lambda k, a, lam, mean, d: a + (mean - a) * lam / (k * d * d + lam),
]
RIGHT["06.2"] = [lambda v, m, z, rate: v.sub_(rate * 2 * m.T @ (m @ v - z))]
RIGHT["06.3"] = [dict(before=9.0, after=4, mean=1, repeat=2)]
WRONG["06.3"] = [
    dict(before=9.0, after=4, mean=1, repeat=5), dict(before=0.4, after=0.1, mean=1, repeat=0.05),
    dict(before=1, after=0.4, mean=1, repeat=0.5), dict(before=1, after=0.5, mean=1, repeat=0.1),
    dict(before=0.2, after=0.4, mean=1, repeat=0.3),
    dict(before=1, after=0.3, mean=0.3, repeat=0.4),
]
RIGHT["07.1"] = [math.degrees(math.acos(.5))]
WRONG["07.1"] = [30, 90, 120]
RIGHT["07.2"] = [441344 / 256, 1724]
WRONG["07.2"] = [215.5, 1720, 3530752]
RIGHT["07.3"] = [
    lambda e: (
        lambda r: np.mean(r[1]) - np.mean(r[0]) > max(np.std(r[0], ddof=1), np.std(r[1], ddof=1))
    )(sorted(e.tolist(), key=np.mean)),
]
RIGHT["08a.1"] = [['cyc', 'id'], ['id', 'cyc'], ('id', 'cyc'), {'id', 'cyc'}]
WRONG["08a.1"] = [set(), {'cyc'}, {'id'}]
RIGHT["08a.2"] = [
    [(x, y / 10) for x, y in zip((.9, .1, .8, .2, .5, .5, .2, .8, .1, .9), range(5, 15))],
]
WRONG["08a.2"] = [
    torch.tensor([[0., 1]] * 10), [[k / 10 - .5, .5 + k / 10] for k in range(10)],
    [[.5 - k / 10, .5 + k / 10] for k in range(10)], [[0, .5 + k / 10] for k in range(10)],
]
RIGHT["08a.3"] = [dict(zip('ABC', ('ds', 'adv', 'cyc'))), dict(C='cyc', B='adv', A='ds')]
WRONG["08a.3"] = [
    dict(A='ds', B='adv', C='id'), dict(A='adv', B='ds', C='cyc'), dict(A='sty', B='adv', C='cyc'),
]
RIGHT["08b.1"] = [
    lambda r: torch.stack((r.square().mean(1).sub(r.mean(1) ** 2).sqrt() - 1, r.sum(1) / 20)),
]
RIGHT["08b.2"] = [(4, 5, 0, 1, 2, 3)]
WRONG["08b.2"] = [
    [1, 0, 3, 2, 5, 4], [2, 3, 4, 5, 0], [2, 2, 4, 4, 0, 0],
]
RIGHT["08b.3"] = [lambda m, s, n, r: (m - n) ** 2 + s * s + r * r - 2 * s * r]
RIGHT["09.1"] = [1 / 12.5]
WRONG["09.1"] = [0.04, 25, 12.5]
RIGHT["09.2"] = [
    180 - math.degrees(2 * math.asin(math.sqrt((0.94**2 - 0.05**2) / (4 * 0.5 * 0.45)))), 16.5
]
WRONG["09.2"] = [163.3, 0.291, 13.3, 33.3, 17.6]
RIGHT["09.3"] = [
    lambda x, c, fps: torch.stack(
        [(x[k + 1] - x[k]).norm() * fps for k in range(len(x) - 1) if c[k] and c[k + 1]]
    ).mean(),
]
RIGHT["10.1"] = [3.6, 3.75]
WRONG["10.1"] = [2, 3, 3.3]
RIGHT["10.2"] = [
    lambda p, a, b: (
        100 * (a + (b - a) * torch.linspace(0, 1, 200001)[:, None] - p).norm(dim=1).min()
    ),
]
RIGHT["10.3"] = [
    lambda x, goal, t, fps: any(
        math.dist(x[k], goal) <= 0.15 for k in range(len(x)) if abs(k / fps - t) <= 0.2001
    ),
]
RIGHT["11.1"] = [
    (('Old',) * 10 + ('Zombie',), ('Old',) * 11), [[True] * 19 + [False], [True] * 20],
    (np.array([2] * 10 + [1]), np.array([2] * 11)), (torch.tensor([0] * 10 + [1]), [0] * 11),
]
WRONG["11.1"] = [
    ([0] * 10, [0] * 10), ([0] * 9 + [1], [1] * 10), ([0] * 8 + [1, 1], [0] * 10),
]
RIGHT["11.2"] = [
    lambda e, *floors: dict(
        gain=(min(floors) - e.mean()) / min(floors), spread=np.ptp(e.numpy()) / 2 / min(floors),
        clear=min(floors) - e.mean() > np.ptp(e.numpy()) / 2,
    ),
]
RIGHT["11.3"] = [lambda s, d: s[d].sum(1).div(len(s)).quantile(torch.tensor([.025, .975]))]
RIGHT["12.1"] = [lambda r: int(r['posture, cm'] < 6 and 33 / 2 < r['lift, cm'] < 33)]
WRONG["12.1"] = [
    lambda r: r["posture, cm"] < 6 and r["range, cm"] > 0.31,
    lambda r: r["posture, cm"] < 6 and r["range, cm"] > 4.5,  # shifted passes
    lambda r: True, lambda r: r['posture, cm'] < 5, lambda r: r['lift, cm'] > 17,
    lambda r: r['lift, cm'] in (29, 25), lambda r: r['range, cm'] in (9, 7),
]
RIGHT["12.2"] = [
    lambda s, f: int(all(a < b for a, b in zip(s, f)) and np.ptp(s.numpy()) < f.mean() - s.mean()),
]
WRONG["12.2"] = [lambda s, f: True, lambda s, f: False, lambda s, f: bool(s.mean() < f.mean())]


def lowered(style, frames=12):
    """How far the hips of a walk are below one metre, cm; Old is the new style."""
    model, bank = tk.pretrained()
    style, ahead = bank["Old" if style == "Mine" else style], tk.runtime.straight(1.0, frames / 60)
    return 100 - 100 * float(list(tk.runtime.states(model, ahead, style))[-1].joints[0, 1])


RIGHT["12.3"] = [
    dict(what='the hips are too low in the walk', unit='cm', measure=lowered),
    dict(what='it is lower by as many metres as that', unit='m',
         measure=lambda name: lowered(name, 30) / 100),
]
WRONG["12.3"] = [
    dict(what='the character drifts off its path', unit='cm',
         measure=dict(Mine=9, Neutral=2, Zombie=3).get),
    dict(what='the character drifts off its path', unit='cm', measure=lambda name: -len(name)),
    dict(what='the hips are too high in the walk', unit='cm', measure=lambda name: -lowered(name)),
    'Everything works perfectly and nothing fails in 12 tests',
    dict(what='bones', unit='mm', measure=len),
    dict(what='the moon is made of cheese', unit='mm', measure=lambda x: 8),
    dict(what='the head is wrong in every frame', unit='mm', measure=lambda x: 0),
    dict(what='bones of the arm get longer', unit='mm', measure=dict(Mine=1, Neutral=5).get),
    dict(what='bones of the arm get longer', unit='mm', measure=8),
    dict(what='bones of the arm get longer', unit='mm', measure=lambda x: x == 'Mine'),
]
