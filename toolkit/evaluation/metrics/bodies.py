"""Where a body is: speed, height, path."""

from torch import Tensor

from toolkit.motion import Clip, Skeleton
from toolkit.motion.tensors import as_tensor


def speed(clip: Clip) -> float:
    """Mean horizontal speed of the hips, smoothed over half a second, m/s."""
    hips = hips_path(clip)
    lag = max(1, min(len(clip) - 1, round(clip.fps / 2)))
    return float((hips[lag:] - hips[:-lag]).norm(dim=-1).mean() * clip.fps / lag)


def hips_height(clip: Clip) -> tuple[float, float]:
    """Lowest and highest height of the hips in the clip, metres."""
    height = clip.global_positions[:, clip.skeleton.role("hips"), 1]
    return float(height.min()), float(height.max())


def upright(clip: Clip) -> bool:
    """Whether the character is on its feet in every frame, see `on_feet`."""
    return bool(on_feet(clip.skeleton, clip.global_positions[..., 1]).all())


def on_feet(skeleton: Skeleton, height: Tensor) -> Tensor:
    """Whether the chest is above the hips and the hips above both ankles ``[...]``.

    ``height [..., J]`` are heights of the joints.
    """
    hips, chest = height[..., skeleton.role("hips")], height[..., skeleton.trunk[0]]
    return (chest > hips) & (hips > height[..., skeleton.both("foot")].amax(-1))


def path_error(clip: Clip, points: Tensor) -> float:
    """Mean distance of the hips on the floor from a polyline, (x, z) ``points [P, 2]``, metres."""
    hips = hips_path(clip)[:, None]
    points = as_tensor(points, "points", hips)
    a, b = points[None, :-1], points[None, 1:]
    # where on each piece of the line the nearest point lies: 0 at its start, 1 at its end
    along = ((hips - a) * (b - a)).sum(-1) / (b - a).square().sum(-1).clamp_min(1e-12)
    nearest = a + along.clamp(0.0, 1.0)[..., None] * (b - a)
    return float((hips - nearest).norm(dim=-1).amin(1).mean())


def hips_path(clip: Clip) -> Tensor:
    """Positions (x, z) of the hips on the floor, ``[F, 2]``."""
    return clip.global_positions[:, clip.skeleton.role("hips")][:, [0, 2]]
