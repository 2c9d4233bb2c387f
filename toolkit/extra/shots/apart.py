"""Characters that keep apart: velocities without collisions, from those that everyone wants (van
den Berg et al. 2011).

Optimal reciprocal collision avoidance: for each neighbour, a character keeps to a half-plane of
velocities. Both of a pair take half of the change that avoids a collision within `HORIZON`. The
velocity is the one in all half-planes that is nearest to the wanted one, by Hildreth's method
(1957). Ours: where none is in all of them, all are missed by little; characters that meet turn to
the right.
"""

import numpy as np
from scipy.spatial import cKDTree

# seconds: collisions within this time are avoided; in which characters too close part
HORIZON, AT_ONCE = 2.0, 0.3
BRAKE = 1.0  # seconds in which a character comes to its least distance from a wall, at the soonest
NEIGHBOURS, SIGHT = 8, 5.0  # most that a character avoids, and metres to them
SWEEPS = 12  # of Hildreth's method
PASSES, SPARE = 30, 1e-3  # of `parted`; metres that it adds to the least distance
# radians by which those who meet want to go to the right, metres between them beyond their least
# distance, and metres to the next wall
ASIDE, CLOSE, ROOM = 0.7, 0.5, 2.0
SOFT = 0.1  # share by which half-planes may be missed: of many, all are missed by little


def velocities(places: np.ndarray, moving: np.ndarray, wanted: np.ndarray,
               radii: np.ndarray, walls: np.ndarray, margin: float) -> np.ndarray:
    """Velocities ``[N, 2]``, m/s, near the wanted ones, that keep N characters apart.

    Parameters
    ----------
    places, moving, wanted
        World (x, z) of each character, its present and its wanted velocity, ``[N, 2]``.
    radii
        Metres ``[N]``: the least distance of two characters is the sum of theirs.
    walls
        Both ends of straight walls, ``[W, 2, 2]``.
    margin
        Least distance from a wall, metres.
    """
    count = len(places)
    tree = cKDTree(places)
    _, near = tree.query(places, k=min(NEIGHBOURS + 1, count), distance_upper_bound=SIGHT)
    near = near.reshape(count, -1)[:, 1:]
    there = near < count
    near = np.where(there, near, 0)
    apart = radii[:, None] + radii[near]
    to = places[near] - places[:, None]
    close = np.linalg.norm(to, axis=-1) < apart + CLOSE
    normal, least = _half_planes(to, moving[:, None] - moving[near], apart)
    least = np.where(there, (normal * moving[:, None]).sum(-1) + least / 2, -np.inf)
    free = np.ones(count, bool)
    if len(walls):
        off = np.stack([to_wall(places, *wall) for wall in walls], 1)
        away = np.maximum(np.linalg.norm(off, axis=-1), 1e-6)
        free = (away > ROOM).all(1)
        still, bound = -off / away[..., None], (margin - away) / BRAKE
        normal, least = np.concatenate((normal, still), 1), np.concatenate((least, bound), 1)
    velocity = _sidestepped(wanted, wanted[near], to, there & free[:, None] & close)
    force = np.zeros_like(least)
    for _ in range(SWEEPS):
        for k in range(force.shape[1]):
            soft = SOFT if k < near.shape[1] else 0.0
            short = least[:, k] - (normal[:, k] * velocity).sum(-1)
            more = np.maximum((short - soft * force[:, k]) / (1 + soft), -force[:, k])
            force[:, k] += more
            velocity += more[:, None] * normal[:, k]
    return velocity


def parted(places: np.ndarray, radii: np.ndarray, walls: np.ndarray, margin: float) -> np.ndarray:
    """Places ``[N, 2]`` near the given ones that keep their distances, by one projection after
    another: off each wall, then each pair that is too close, both by the half.

    Characters do not walk exactly as they are told to, so velocities alone do not keep them apart.
    """
    moved, apart = places.copy(), radii[:, None] + radii + SPARE
    for _ in range(PASSES):
        for start, end in walls:
            to = to_wall(moved, start, end)
            away = np.maximum(np.linalg.norm(to, axis=-1, keepdims=True), 1e-6)
            moved -= to / away * np.maximum(margin - away, 0.0)
        distance = np.linalg.norm(moved[:, None] - moved, axis=-1)
        close = np.argwhere(np.triu(distance < apart - SPARE / 2, 1))
        if not len(close):
            break
        for a, b in close:
            to = moved[b] - moved[a]
            size = max(np.hypot(*to), 1e-6)
            push = to / size * max(apart[a, b] - size, 0.0) / 2
            moved[a] -= push
            moved[b] += push
    return moved


def to_wall(places: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """From places ``[N, 2]`` to the nearest points of a wall."""
    way = end - start
    share = np.clip((places - start) @ way / (way @ way), 0.0, 1.0)
    return start + share[:, None] * way - places


def _sidestepped(wanted: np.ndarray, theirs: np.ndarray, to: np.ndarray,
                 there: np.ndarray) -> np.ndarray:
    """Wanted velocities ``[N, 2]``, to the right where a neighbour in front wants to come nearer.

    Ours: without it, those who meet in one place stand against each other for ever.
    """
    meets = there & ((to * wanted[:, None]).sum(-1) > 0) & ((to * theirs).sum(-1) < 0)
    turn = np.where(meets.any(1), ASIDE, 0.0)
    return _turned(wanted, np.cos(turn), np.sin(turn))


def _turned(vectors: np.ndarray, cos: np.ndarray, sin: np.ndarray) -> np.ndarray:
    """Vectors ``[..., 2]``, turned from x towards z."""
    x, z = vectors[..., 0], vectors[..., 1]
    return np.stack((cos * x - sin * z, sin * x + cos * z), -1)


def _half_planes(to: np.ndarray, relative: np.ndarray,
                 apart: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Normals ``[..., 2]``, and least changes ``[...]`` of relative velocities, to avoid places.

    The velocities that collide within `HORIZON` are a cone with its apex at zero, cut off by a
    circle of the radius ``apart / HORIZON``. The change leads to the nearest point of its border.
    """
    distance = np.maximum(np.linalg.norm(to, axis=-1), 1e-6)
    close = distance < apart
    within = np.where(close, AT_ONCE, HORIZON)[..., None]
    centre = to / within
    off = relative - centre
    length = np.maximum(np.linalg.norm(off, axis=-1), 1e-9)
    normal, change = off / length[..., None], apart / within[..., 0] - length
    leg = np.sqrt(np.maximum(distance**2 - apart**2, 0.0))
    beside = ~close & ((off * to).sum(-1) > -apart * length)  # nearer to a side than to the circle
    side = np.where(to[..., 0] * off[..., 1] - to[..., 1] * off[..., 0] >= 0, 1.0, -1.0)
    # the side is a line from zero that touches the circle; its normal is perpendicular to it
    out = _turned(to, -apart / distance**2, side * leg / distance**2)
    normal = np.where(beside[..., None], out, normal)
    return normal, np.where(beside, -(relative * out).sum(-1), change)
