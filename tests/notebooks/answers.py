"""Answers to the exercises: right ones in other forms than the notebook's solution, wrong ones."""

# ruff: noqa: B905, C408, C416, RUF007, SIM905 (as a reader writes them)

import math

import numpy as np
import torch
from torch.nn import functional as F

PI = math.pi
LEG = torch.tensor([[0.0, 1.0, 0.0], [0.0, 0.55, 0.1], [0.0, 0.1, 0.0]])  # of exercise 03b.3
RIGHT, WRONG = {}, {}
RIGHT["00.1"] = [
    {'Zombie': .75, 'Old': .25}, dict(Old=1/4, Zombie=3/4),
    {'Old': np.float64(.25), 'Zombie': torch.tensor(.75)}, dict(zip(['Old', 'Zombie'], [.25, .75])),
]
WRONG["00.1"] = [
    dict(Old=.75, Zombie=.25), dict(Old=25, Zombie=75), dict(Zombie=.75),
]
RIGHT["00.2"] = [
    lambda speed, fps: speed * (1 / fps), lambda speed, fps: np.float32(speed / fps),
    lambda speed, fps: torch.tensor(speed) / fps, lambda speed, fps: float(speed) / float(fps),
]
WRONG["00.2"] = [
    lambda speed, fps: fps / speed, lambda speed, fps: speed,
]
RIGHT["00.3"] = [
    dict(Neutral=0.59, Aeroplane=0.41), dict(Neutral=0.585, Aeroplane=0.415),
    dict(Neutral=0.58, Aeroplane=0.42), dict(Neutral=0.575, Aeroplane=0.425),
]
WRONG["00.3"] = [
    dict(Neutral=1.0, Aeroplane=0.0), dict(Neutral=0.5, Aeroplane=0.5),
    dict(Neutral=0.4, Aeroplane=0.6),
]
RIGHT["01.1"] = [
    lambda own, root, angle: (
        torch.tensor([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
        @ own
        + root
    ),
    lambda own, root, angle: torch.tensor(
        [
            float(root[0] + own[0] * np.cos(float(angle)) + own[1] * np.sin(float(angle))),
            float(root[1] + own[1] * np.cos(float(angle)) - own[0] * np.sin(float(angle))),
        ]
    ),
    lambda own, root, angle: torch.view_as_real(
        torch.view_as_complex(root.flip(0).contiguous())
        + torch.view_as_complex(own.flip(0).contiguous()) * torch.exp(1j * angle)
    ).flip(0),
    lambda own, root, angle: (
        own[0] * torch.stack([angle.cos(), -angle.sin()])
        + own[1] * torch.stack([angle.sin(), angle.cos()])
        + root
    ),
]
RIGHT["01.2"] = [
    (PI, (1, 0, 3)), (-.5, [0., 0., 0.]), (np.pi / 2, (4, 0, 0)),
    (torch.tensor(2.), torch.zeros(3).tolist()),
]
WRONG["01.2"] = [(0, (4, 0, 0)), (0, (0, 2, 0)), (2 * PI, (0, 0, 0))]
RIGHT["01.3"] = [
    lambda turns, pairs: (
        torch.diag(torch.tensor([-1.0, 1, 1]))
        @ turns[:, pairs]
        @ torch.diag(torch.tensor([-1.0, 1, 1]))
    ),
    lambda turns, pairs: torch.einsum(
        "i,fjik,k->fjik", torch.tensor([-1.0, 1, 1]), turns[:, pairs], torch.tensor([-1.0, 1, 1])
    ),
    lambda turns, pairs: (
        torch.stack([turns[:, k] for k in pairs], 1)
        * torch.outer(torch.tensor([-1.0, 1, 1]), torch.tensor([-1.0, 1, 1]))
    ),
    lambda turns, pairs: (
        turns.index_select(1, torch.tensor(pairs))
        * torch.tensor([-1.0, 1, 1])
        * torch.tensor([-1.0, 1, 1])[:, None]
    ),
]
RIGHT["02a.1"] = [
    lambda contact, half: F.avg_pool1d(
        F.pad(contact[None], (half, half), mode="replicate"), 2 * half + 1, 1
    )[0].round(),
    lambda contact, half: (
        torch.cat((contact[:1].expand(half), contact, contact[-1:].expand(half)))
        .unfold(0, 2 * half + 1, 1)
        .median(1)
        .values
    ),
    lambda contact, half: (
        np.convolve(np.pad(contact.numpy(), half, mode="edge"), np.ones(2 * half + 1), "valid")
        > half
    ),
    lambda contact, half: (
        F.pad(contact[None], (half, half), mode="replicate")[0].unfold(0, 2 * half + 1, 1).sum(1)
        > half
    ).float(),
]
RIGHT["02a.2"] = [
    lambda phase, fps: torch.atan2(phase.diff().sin(), phase.diff().cos()).mean() * fps / (2 * PI),
    lambda phase, fps: (
        float(np.unwrap(phase.numpy())[-1] - phase[0]) / (len(phase) - 1) * fps / (2 * PI)
    ),
    lambda phase, fps: torch.exp(1j * phase.diff()).angle().mean() / (2 * PI) * fps,
    lambda phase, fps: (
        torch.remainder(phase[1:] - phase[:-1] + PI, 2 * PI).sub(PI).sum()
        * fps
        / (2 * PI * (len(phase) - 1))
    ),
]
RIGHT["02a.3"] = [
    ((1, 0, 0), (0, 2, 1)), ((1, 1, 0), (1, -1, PI)), [(0, 0, 0), (0, 0, 3)],
    ((2, 0., 1), (3, 0., 2)),
]
WRONG["02a.3"] = [
    ((1, 1, 0), (1, 1, 1)), ((1, 1, 0), (1, 1, 2 * PI)), ((0, 1, 0), (1, 1, 2)),
]
RIGHT["02b.1"] = [
    (torch.arange(12.) + 2 * PI, torch.arange(12.)), (torch.ones(50), -torch.ones(50)),
    (torch.arange(30.) - 3, torch.arange(30.)), (2 * PI * torch.arange(10.), torch.zeros(10)),
]
WRONG["02b.1"] = [
    (torch.zeros(20), torch.zeros(20)), (torch.zeros(20) + .5, torch.zeros(20)),
    (torch.arange(20.), torch.zeros(20)),
]
RIGHT["03a.1"] = [
    lambda first, second: 1 / (1 - second / first), lambda first, second: -first / (second - first),
    lambda first, second: 1 + second / (first - second),
    lambda first, second: np.roots([second - first, first])[0].real,
]
RIGHT["03a.2"] = [
    ([1, 2], [3, 4]), (torch.arange(9.), torch.arange(9.) + 1),
    (torch.arange(9.), 3 * torch.arange(9.) - 2), (np.array([0., 1, 5]), np.array([1., 3, 11])),
]
WRONG["03a.2"] = [
    ([1, 2], [2, 1]), (torch.arange(9.), torch.arange(9.) ** 2), ([1.], [2.]),
]
RIGHT["03a.3"] = [
    lambda a, h, b, k: torch.tensor(k * (a * h + h * h + h * b + h + h + b)),
    lambda a, h, b, k: sum(k * (i + 1) * o for i, o in ((a, h), (h, h), (h, b))),
    lambda a, h, b, k: k * h * (a + h + b + 2) + k * b,
    lambda a, h, b, k: k * (torch.nn.Linear(a, h).weight.numel() + h * h + h * b + 2 * h + b),
]
RIGHT["03b.1"] = [
    lambda p, q, parents: (
        ((p[:, 1:] - p[:, parents[1:]]).norm(dim=-1) - (q[:, 1:] - q[:, parents[1:]]).norm(dim=-1))
        .abs()
        .mean()
    ),
    lambda p, q, parents: (
        (
            torch.linalg.vector_norm(p[:, 1:] - p[:, parents[1:]], dim=2)
            - torch.linalg.vector_norm(q[:, 1:] - q[:, parents[1:]], dim=2)
        )
        .abs()
        .mean()
    ),
    lambda p, q, parents: F.l1_loss(
        (p[:, 1:] - p[:, parents[1:]]).square().sum(-1).sqrt(),
        (q[:, 1:] - q[:, parents[1:]]).square().sum(-1).sqrt(),
    ),
    lambda p, q, parents: np.abs(
        np.linalg.norm((p[:, 1:] - p[:, parents[1:]]).numpy(), axis=2)
        - np.linalg.norm((q[:, 1:] - q[:, parents[1:]]).numpy(), axis=2)
    ).mean(),
]
RIGHT["03b.2"] = [
    lambda x, s: (x.diff(dim=0) / s).square().mean(),
    lambda x, s: F.mse_loss(x[1:] / s, x[:-1] / s),
    lambda x, s: ((x / s).diff(dim=0) ** 2).mean(0).mean(),
    lambda x, s: torch.stack([((b - a) / s).pow(2) for a, b in zip(x[:-1], x[1:])]).mean(),
]
RIGHT["03b.3"] = [
    LEG * torch.tensor([1., -1, 1]), LEG + torch.tensor([0., 2., 0.]),
    LEG @ torch.tensor([[0., -1, 0], [1, 0, 0], [0, 0, 1]]), (LEG - 3).numpy(),
]
WRONG["03b.3"] = [LEG + .01, 2 * LEG, LEG[:2]]
RIGHT["04.1"] = [
    lambda style, corners: F.normalize(torch.tensor([style[c] for c in corners]), p=1, dim=0),
    lambda style, corners: np.array([style[c] for c in corners]) / sum(style.values()),
    lambda style, corners: [style[c] / sum(style.values()) for c in corners],
    lambda style, corners: torch.tensor([style[c] for c in corners]).div(sum(style.values())),
]
WRONG["04.1"] = [
    lambda style, corners: [style[c] for c in corners],
    lambda style, corners: torch.tensor([*style.values()]) / sum(style.values()),
    lambda style, corners: torch.softmax(torch.tensor([style[c] for c in corners]), 0),
]
RIGHT["04.2"] = [
    [[1, k % 2, 1] for k in range(12)], np.cumsum(np.tile([0, .01, 0], (30, 1)), 0),
    torch.linspace(0, 1, 30)[:, None] * torch.tensor([0, 1, 0]),
    [(0, .1 * math.sin(k), 0) for k in range(60)],
]
WRONG["04.2"] = [
    torch.ones(20, 3), torch.arange(60.).view(20, 3), torch.zeros(20, 2),
]
RIGHT["04.3"] = [
    lambda point, corners: torch.linalg.lstsq(
        torch.cat((corners.T, torch.ones(1, 3))), torch.cat((point, torch.ones(1)))[:, None]
    ).solution[:, 0],
    lambda point, corners: (
        torch.linalg.inv(torch.cat((corners.T, torch.ones(1, 3))))
        @ torch.cat((point, torch.ones(1)))
    ),
    lambda point, corners: (
        torch.stack(
            [
                torch.det(torch.stack([corners[(i + 1) % 3] - point, corners[(i + 2) % 3] - point]))
                for i in range(3)
            ]
        )
        / torch.det(corners[1:] - corners[:1])
    ),
    lambda point, corners: np.linalg.solve(
        np.vstack((corners.numpy().T, np.ones(3))), np.append(point, 1)
    ),
]
RIGHT["05.1"] = [
    lambda a, b, v: ((v - a) * (b - a)).sum() / (b - a).square().sum(),
    lambda a, b, v: torch.dot(v - a, b - a) / (b - a).norm() ** 2,
    lambda a, b, v: 1 - (v - b) @ (a - b) / ((a - b) @ (a - b)),
    lambda a, b, v: torch.linalg.lstsq((b - a)[:, None], (v - a)[:, None]).solution[0, 0],
]
RIGHT["05.2"] = [
    lambda vectors, query: (
        (vectors - vectors[query]).square().sum(1).topk(2, largest=False).indices[1]
    ),
    lambda vectors, query: torch.cdist(vectors, vectors)[query].argsort()[1].item(),
    lambda vectors, query: min(
        (k for k in range(len(vectors)) if k != query),
        key=lambda k: float((vectors[k] - vectors[query]).norm()),
    ),
    lambda vectors, query: np.argsort(np.linalg.norm((vectors - vectors[query]).numpy(), axis=1))[
        1
    ],
]
RIGHT["05.3"] = [
    lambda length, angle: length * math.cos(angle / 2),
    lambda length, angle: length * ((1 + angle.cos()) / 2).sqrt(),
    lambda length, angle: length * np.cos(float(angle) / 2),
    lambda length, angle: length * torch.sin(PI / 2 - angle / 2),
]
RIGHT["06.1"] = [
    lambda v, vectors: ((v - vectors.mean(0)) ** 2 / vectors.var(0)).mean(),
    lambda v, vectors: F.mse_loss(v / vectors.std(0), vectors.mean(0) / vectors.std(0)),
    lambda v, vectors: (((v - vectors.mean(dim=0)) / vectors.std(dim=0)) ** 2).sum() / len(v),
    lambda v, vectors: (((v - vectors.mean(0)) / vectors.std(0)).norm() ** 2) / v.numel(),
]
RIGHT["06.2"] = [
    lambda v, m, z, rate: v + 2 * rate * m.T @ (z - m @ v),
    lambda v, m, z, rate: v - 2 * rate * (m @ v - z) @ m,
    lambda v, m, z, rate: v.sub_(rate * 2 * m.T @ (m @ v - z)),
    lambda v, m, z, rate: v - rate * 2 * (m * (m @ v - z)[:, None]).sum(0),
]
RIGHT["06.3"] = [
    dict(before=2, after=0.9, mean=0.5, repeat=0.1),
    dict(before=0.5, after=0.2, mean=1, repeat=0.05),
    dict(before=0.591, after=0.113, mean=1, repeat=0.084),
    dict(before=9.0, after=4, mean=1, repeat=5),
]
WRONG["06.3"] = [
    dict(before=1, after=0.4, mean=1, repeat=0.5), dict(before=1, after=0.5, mean=1, repeat=0.1),
    dict(before=0.2, after=0.4, mean=1, repeat=0.3),
]
RIGHT["07.1"] = [60.0, np.float32(60), math.degrees(math.acos(.5)), torch.tensor(60.)]
WRONG["07.1"] = [30, 90, 120]
RIGHT["07.2"] = [
    lambda w, b, g, t: torch.vstack((w * g, g * b + t)),
    lambda w, b, g, t: torch.cat((w @ torch.diag(g), (b * g + t)[None])),
    lambda w, b, g, t: torch.cat((w, b[None])) * g + torch.cat((torch.zeros_like(w), t[None])),
    lambda w, b, g, t: np.vstack((w.numpy() * g.numpy(), (g * b + t).numpy())),
]
RIGHT["07.3"] = [
    lambda e: (lambda m, s, i: m[i[1]] - m[i[0]] > torch.maximum(s[i[0]], s[i[1]]))(
        e.mean(1), e.std(1), e.mean(1).argsort()
    ),
    lambda e: (lambda k: e[k[1]].mean() - e[k[0]].mean() > e[k].std(1).max())(
        e.mean(1).argsort()[:2]
    ),
    lambda e: (lambda k: int(e[k].mean(1).diff() > e[k].std(1).amax()))(e.mean(1).argsort()[:2]),
    lambda e: (
        lambda r: np.mean(r[1]) - np.mean(r[0]) > max(np.std(r[0], ddof=1), np.std(r[1], ddof=1))
    )(sorted(e.tolist(), key=np.mean)),
]
RIGHT["08a.1"] = [['cyc', 'id'], ('id', 'cyc'), frozenset({'cyc', 'id'}), set('cyc id'.split())]
WRONG["08a.1"] = [set(), {'cyc'}, {'id'}]
RIGHT["08a.2"] = [[[.5, .8]] * 12, np.full((20, 2), .9), torch.ones(30, 2), [(0, 1)] * 10]
WRONG["08a.2"] = [
    torch.tensor([[0., -1]] * 10), [[0, 1]] * 9, [[0, 1], [.5, 1]] * 5,
]
RIGHT["08a.3"] = [
    {'C': 'cyc', 'B': 'adv', 'A': 'ds'}, dict(zip('ABC', ('ds', 'adv', 'cyc'))),
    {k: v for k, v in zip('ABC', ['ds', 'adv', 'cyc'])}, dict(A='ds') | dict(B='adv', C='cyc'),
]
WRONG["08a.3"] = [
    dict(A='ds', B='adv', C='id'), dict(A='adv', B='ds', C='cyc'), dict(A='sty', B='adv', C='cyc'),
]
RIGHT["08b.1"] = [
    lambda h, g, b: F.instance_norm(h[None], eps=0)[0] * (1 + g)[:, None] + b[:, None],
    lambda h, g, b: ((h.T - h.mean(1)) / h.std(1, correction=0) * (1 + g) + b).T,
    lambda h, g, b: F.layer_norm(h, h.shape[1:], eps=0) * (1 + g[:, None]) + b[:, None],
    lambda h, g, b: torch.stack(
        [(1 + g[i]) * (x - x.mean()) / x.std(correction=0) + b[i] for i, x in enumerate(h)]
    ),
]
RIGHT["08b.2"] = [
    (4, 5, 0, 1, 2, 3), torch.tensor([3, 2, 5, 4, 1, 0]), np.roll(np.arange(6), 2),
    [2, 4, 0, 5, 1, 3],
]
WRONG["08b.2"] = [
    [1, 0, 3, 2, 5, 4], [2, 3, 4, 5, 0], [2, 2, 4, 4, 0, 0],
]
RIGHT["08b.3"] = [
    lambda m, s, n, r: abs(m - n) ** 2 + abs(s - r) ** 2,
    lambda m, s, n, r: (m - n) ** 2 + s * s + r * r - 2 * s * r,
    lambda m, s, n, r: (m - n) ** 2 + s**2 + r**2 - 2 * math.sqrt(s**2 * r**2),
    lambda m, s, n, r: torch.tensor([m - n, s - r]).square().sum(),
]
RIGHT["09.1"] = [2 / 25, np.float64(.08), torch.tensor(.08), 1 / 12.5]
WRONG["09.1"] = [0.04, 25, 12.5]
RIGHT["09.2"] = [
    lambda a, b, d: np.degrees(np.arccos(np.clip((a**2 + b**2 - d**2) / (2 * a * b), -1, 1))),
    lambda a, b, d: torch.rad2deg(
        torch.tensor((a**2 + b**2 - d**2) / (2 * a * b)).clamp(-1, 1).acos()
    ),
    lambda a, b, d: (
        180.0 if d >= a + b else math.acos((a * a + b * b - d * d) / (2 * a * b)) * 180 / PI
    ),
    lambda a, b, d: (
        2 * math.degrees(math.asin(min(1, math.sqrt(max(0, (d * d - (a - b) ** 2) / (4 * a * b))))))
    ),
]
RIGHT["09.3"] = [
    lambda x, c, fps: fps * (x[1:] - x[:-1])[c[1:] & c[:-1]].norm(dim=1).mean(),
    lambda x, c, fps: torch.stack(
        [(x[k + 1] - x[k]).norm() * fps for k in range(len(x) - 1) if c[k] and c[k + 1]]
    ).mean(),
    lambda x, c, fps: (
        (x.diff(dim=0).norm(dim=1) * (c[1:] * c[:-1])).sum() / (c[1:] * c[:-1]).sum() * fps
    ),
    lambda x, c, fps: (
        np.linalg.norm(np.diff(x.numpy(), axis=0), axis=1)[(c[1:] & c[:-1]).numpy()].mean() * fps
    ),
]
RIGHT["10.1"] = [3.6, 3.65, np.float32(3.7), torch.tensor(3.7), 3.75]
WRONG["10.1"] = [2, 3, 3.3]
RIGHT["10.2"] = [
    lambda p, a, b: (
        100
        * torch.dist(p, torch.lerp(a, b, ((p - a) @ (b - a) / (b - a).square().sum()).clamp(0, 1)))
    ),
    lambda p, a, b: (
        100 * (a + (b - a) * torch.linspace(0, 1, 200001)[:, None] - p).norm(dim=1).min()
    ),
    lambda p, a, b: (
        100
        * math.dist(p, a + min(1, max(0, float((p - a) @ (b - a) / (b - a).norm() ** 2))) * (b - a))
    ),
    lambda p, a, b: (
        (p - a - (b - a) * ((p - a).dot(b - a) / (b - a).dot(b - a)).clip(0, 1)).norm() * 100
    ),
]
RIGHT["10.3"] = [
    lambda x, goal, t, fps: ((x - goal).norm(dim=1) <= 0.15)[
        max(0, round(t * fps - 0.2 * fps)) : round(t * fps + 0.2 * fps) + 1
    ].any(),
    lambda x, goal, t, fps: any(
        math.dist(x[k], goal) <= 0.15 for k in range(len(x)) if abs(k / fps - t) <= 0.2001
    ),
    lambda x, goal, t, fps: int(
        (
            ((x - goal).norm(dim=1) <= 0.15) & ((torch.arange(len(x)) / fps - t).abs() <= 0.2001)
        ).any()
    ),
    lambda x, goal, t, fps: np.any(
        np.linalg.norm((x - goal).numpy(), axis=1)[np.abs(np.arange(len(x)) / fps - t) < 0.2001]
        <= 0.15
    ),
]
RIGHT["11.1"] = [
    (list('aaaaaaaaab'), list('aaaaaaaaaa')), ([1] * 19 + [2], [1] * 20),
    (('Old',) * 10 + ('Zombie',), ('Old',) * 11), ([3] * 95 + [4] * 5, [3] * 100),
]
WRONG["11.1"] = [
    ([0] * 10, [0] * 10), ([0] * 9 + [1], [1] * 10), ([0] * 8 + [1, 1], [0] * 10),
]
RIGHT["11.2"] = [
    lambda a, b, gap: not (a[1] + gap <= b[0] or b[1] + gap <= a[0]),
    lambda a, b, gap: np.bool_(max(a, b)[0] - min(a, b)[1] < gap),
    lambda a, b, gap: torch.tensor(sorted((a, b))[1][0] - sorted((a, b))[0][1] < gap),
    lambda a, b, gap: int(a[0] < b[1] + gap and b[0] < a[1] + gap),
]
RIGHT["11.3"] = [
    lambda s, d: np.quantile(s.numpy()[d.numpy()].mean(1), [.025, .975]),
    lambda s, d: torch.stack([s[d].mean(1).quantile(q) for q in (.025, .975)]),
    lambda s, d: np.percentile(s[d].mean(1), [2.5, 97.5]),
    lambda s, d: s[d].sum(1).div(len(s)).quantile(torch.tensor([.025, .975])),
]
RIGHT["12.1"] = [
    lambda r: r['posture, cm'] <= .8 * 9.8 and r['range, cm'] >= 4.5,
    lambda r: np.bool_(r['posture, cm'] < 6) & (r['range, cm'] > 1),
    lambda r: torch.tensor([r['posture, cm'] < 6, r['range, cm'] > 1]).all(),
    lambda r: int(r['posture, cm'] < 6 and 9 / 2 < r['range, cm'] < 18),
]
WRONG["12.1"] = [
    lambda r: True, lambda r: r['posture, cm'] < 5, lambda r: r['range, cm'] > 3,
]
RIGHT["12.2"] = [
    lambda mine, floor: 1 - mine / floor, lambda mine, floor: -(mine - floor) / floor,
    lambda mine, floor: torch.tensor(1 - mine / floor),
    lambda mine, floor: (1 / mine - 1 / floor) * mine,
]
RIGHT["12.3"] = [
    dict(what='bones of the arm get too long', unit='mm', measure=lambda: (8.1, 5.2)),
    dict(what='a turn on the spot lifts no foot', unit='cm', measure=lambda: (2.1, 6.0)),
    dict(what='the character drifts off its path', unit='cm', measure=lambda: (31, 12)),
    dict(what='hands pass through the trunk often', unit='frames', measure=lambda: [14, 0]),
    dict(what='it is slower than my own clip', unit='m/s', measure=lambda: torch.tensor([.8, 1.2])),
]
WRONG["12.3"] = [
    'Everything works perfectly and nothing fails in 12 tests',
    dict(what='bones', unit='mm', measure=lambda: (8, 5)),
    dict(what='bones of the arm get longer', unit='mm', measure=8),
]
