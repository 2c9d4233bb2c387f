"""Rotations as unit quaternions ``(w, x, y, z)``, and as two axes ``(forward, up)`` of networks.

Every function takes tensors of any leading shape. Forward and up are a rotated +Z and +Y (Zhang et
al. 2018, the form used in Mason et al. 2022, section 3.2).
"""

from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.motion.tensors import as_tensor

AXES = {"X": 0, "Y": 1, "Z": 2}


def identity(*shape: int, dtype: torch.dtype | None = None,
             device: torch.device | None = None) -> Tensor:
    """Unit quaternions of shape ``[*shape, 4]``."""
    q = torch.zeros(*shape, 4, dtype=dtype, device=device)
    q[..., 0] = 1.0
    return q


def normalize(v: Tensor) -> Tensor:
    """``v`` scaled to unit length along its last axis (a zero vector stays zero)."""
    return v / torch.linalg.vector_norm(v, dim=-1, keepdim=True).clamp_min(1e-12)


def length(v: Tensor) -> Tensor:
    """Lengths ``[..., 1]`` of vectors."""
    return v.norm(dim=-1, keepdim=True)


def limited(v: Tensor, most: float) -> Tensor:
    """Vectors in the directions of ``v``, no longer than ``most``."""
    return v * (most / length(v).clamp_min(most))


def multiply(a: Tensor, b: Tensor) -> Tensor:
    """Hamilton product ``a b``: the rotation ``b`` followed by ``a``."""
    return torch.stack(multiply_parts(a.unbind(-1), b.unbind(-1)), -1)


def multiply_parts(a: Sequence[Tensor],
                   b: Sequence[Tensor]) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """`multiply` of quaternions given by component; fastest if each tensor is contiguous."""
    (aw, ax, ay, az), (bw, bx, by, bz) = a, b
    return (_sum(aw * bw, (ax, bx, -1), (ay, by, -1), (az, bz, -1)),
            _sum(aw * bx, (ax, bw, 1), (ay, bz, 1), (az, by, -1)),
            _sum(aw * by, (ax, bz, -1), (ay, bw, 1), (az, bx, 1)),
            _sum(aw * bz, (ax, by, 1), (ay, bx, -1), (az, bw, 1)))


def _sum(total: Tensor, *products: tuple[Tensor, Tensor, int]) -> Tensor:
    """``total``, to which products with signs are added in place, in one pass each."""
    for a, b, sign in products:
        total.addcmul_(a, b, value=sign)
    return total


def inverse(q: Tensor) -> Tensor:
    """Inverse of unit quaternions."""
    return torch.cat((q[..., :1], -q[..., 1:]), -1)


def rotate(q: Tensor, v: Tensor) -> Tensor:
    """Vectors ``v [..., 3]`` turned by unit quaternions ``q [..., 4]``."""
    w = q[..., :1]
    u, v = torch.broadcast_tensors(q[..., 1:], v)
    t = 2.0 * torch.linalg.cross(u, v)
    return v + w * t + torch.linalg.cross(u, t)


def rotate_parts(q: Sequence[Tensor], v: Sequence[Tensor]) -> tuple[Tensor, Tensor, Tensor]:
    """`rotate` of quaternions and vectors given by component."""
    (w, x, y, z), (a, b, c) = q, v
    i = 2 * _sum(y * c, (z, b, -1))
    j = 2 * _sum(z * a, (x, c, -1))
    k = 2 * _sum(x * b, (y, a, -1))
    return (_sum(torch.addcmul(a, w, i), (y, k, 1), (z, j, -1)),
            _sum(torch.addcmul(b, w, j), (z, i, 1), (x, k, -1)),
            _sum(torch.addcmul(c, w, k), (x, j, 1), (y, i, -1)))


def from_axis_angle(axis: Tensor, angle: Tensor) -> Tensor:
    """Rotation by ``angle`` [...] radians about unit ``axis [..., 3]``."""
    half = angle[..., None] / 2
    return torch.cat((half.cos(), half.sin() * axis), -1)


def yaw(angle: Tensor) -> Tensor:
    """Rotation by ``angle`` radians about +Y; 0 faces +Z, positive turns towards +X (left)."""
    zero = torch.zeros_like(angle)
    return torch.stack(((angle / 2).cos(), zero, (angle / 2).sin(), zero), -1)


def between(a: Tensor, b: Tensor) -> Tensor:
    """Shortest rotation that turns direction ``a [..., 3]`` into direction ``b [..., 3]``."""
    a, b = normalize(a), normalize(b)
    w = 1.0 + (a * b).sum(-1, keepdim=True)
    q = torch.cat((w, torch.linalg.cross(*torch.broadcast_tensors(a, b))), -1)
    # Opposite directions: half a turn about any axis across.
    helper = least_axis(a).expand_as(q[..., 1:])
    across = normalize(torch.linalg.cross(a.expand_as(helper), helper))
    half_turn = torch.cat((torch.zeros_like(w), across), -1)
    return torch.where(w < 1e-6, half_turn, normalize(q))


def angle(a: Tensor, b: Tensor) -> Tensor:
    """Radians ``[...]`` between vectors ``[..., 3]``, 0 to π."""
    return torch.atan2(torch.linalg.cross(a, b).norm(dim=-1), (a * b).sum(-1))


def least_axis(v: Tensor) -> Tensor:
    """The coordinate axis ``[..., 3]`` of the smallest component of ``v``; never parallel to it."""
    return (torch.arange(3, device=v.device) == v.abs().argmin(-1, keepdim=True)).to(v.dtype)


def to_matrix(q: Tensor) -> Tensor:
    """Rotation matrices ``[..., 3, 3]``; columns are the rotated X, Y, Z axes."""
    w, x, y, z = q.unbind(-1)
    x2, y2, z2 = 2 * x, 2 * y, 2 * z
    xx, yy, zz = x * x2, y * y2, z * z2
    xy, xz, yz = x * y2, x * z2, y * z2
    wx, wy, wz = w * x2, w * y2, w * z2
    rows = (1 - yy - zz, xy - wz, xz + wy,
            xy + wz, 1 - xx - zz, yz - wx,
            xz - wy, yz + wx, 1 - xx - yy)
    return torch.stack(rows, -1).unflatten(-1, (3, 3))


def from_matrix(m: Tensor) -> Tensor:
    """Unit quaternions (w >= 0) of rotation matrices ``m [..., 3, 3]``."""
    m00, m01, m02, m10, m11, m12, m20, m21, m22 = m.flatten(-2).unbind(-1)
    x, y, z = m21 - m12, m02 - m20, m10 - m01
    xy, xz, yz = m10 + m01, m02 + m20, m21 + m12
    # Each row is a multiple of the same quaternion; the one with the largest diagonal is exact.
    parts = (1 + m00 + m11 + m22, x, y, z,
             x, 1 + m00 - m11 - m22, xy, xz,
             y, xy, 1 - m00 + m11 - m22, yz,
             z, xz, yz, 1 - m00 - m11 + m22)
    rows = torch.stack(parts, -1).unflatten(-1, (4, 4))
    best = rows.diagonal(dim1=-2, dim2=-1).argmax(-1)
    q = normalize(rows.gather(-2, best[..., None, None].expand(*best.shape, 1, 4)).squeeze(-2))
    return torch.where(q[..., :1] < 0, -q, q)


def to_forward_up(q: Tensor) -> tuple[Tensor, Tensor]:
    """The rotated +Z (forward) and +Y (up), each ``[..., 3]``."""
    _, up, forward = torch.eye(3, dtype=q.dtype, device=q.device)
    return rotate(q, forward), rotate(q, up)


def from_forward_up(forward: Tensor, up: Tensor) -> Tensor:
    """Unit quaternions of axes ``[..., 3]``; forward is kept, up is made orthogonal to it."""
    z = normalize(forward)
    x = normalize(torch.linalg.cross(up, z))
    return from_matrix(torch.stack((x, torch.linalg.cross(z, x), z), -1))


def from_euler(angles: Tensor, order: str) -> Tensor:
    """Quaternions of intrinsic Euler ``angles [..., 3]``, radians; ``order="YXZ"`` is Ry·Rx·Rz."""
    i, j, k = (AXES[a] for a in order)
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    half = angles / 2
    (c1, c2, c3), (s1, s2, s3) = half.cos().unbind(-1), half.sin().unbind(-1)
    cc, ss, sc, cs = c1 * c2, sign * s1 * s2, s1 * c2, sign * c1 * s2
    first, second, third = sc * c3 + cs * s3, sign * (cs * c3 - sc * s3), cc * s3 + ss * c3
    vector = dict(zip((i, j, k), (first, second, third), strict=True))
    return torch.stack((cc * c3 - ss * s3, vector[0], vector[1], vector[2]), -1)


def to_euler(q: Tensor, order: str) -> Tensor:
    """Intrinsic Euler angles ``[..., 3]`` in radians; inverse of `from_euler`.

    Near gimbal lock the first and the third angle are uncertain; the third is computed from the
    first, so that their product is right. At the lock it is 0.
    """
    i, j, k = (AXES[a] for a in order)
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    m = to_matrix(q)
    cosine = torch.hypot(m[..., i, i], m[..., i, j])
    middle = torch.atan2(sign * m[..., i, k], cosine)
    first = torch.atan2(-sign * m[..., j, k], m[..., k, k])
    locked = torch.atan2(sign * m[..., k, j], m[..., j, j])
    first = torch.where(cosine < 10 * torch.finfo(m.dtype).eps, locked, first)
    row = first.cos()[..., None] * m[..., j, :] + sign * first.sin()[..., None] * m[..., k, :]
    return torch.stack((first, middle, torch.atan2(sign * row[..., i], row[..., j])), -1)


def slerp(a: Tensor, b: Tensor, t: Tensor | float) -> Tensor:
    """Spherical interpolation from ``a`` to ``b`` by ``t`` [...] along the shorter arc."""
    t = as_tensor(t, "t", a)
    dot = (a * b).sum(-1)
    b = torch.where(dot[..., None] < 0, -b, b)
    near = dot.abs() > 1 - 1e-7  # linear here: acos has no finite gradient at 1, so it gets 0
    angle = torch.acos(torch.where(near, 0.0, dot.abs()))
    wa = torch.where(near, 1 - t, ((1 - t) * angle).sin() / angle.sin())
    wb = torch.where(near, t, (t * angle).sin() / angle.sin())
    return normalize(wa[..., None] * a + wb[..., None] * b)


def unroll(q: Tensor) -> Tensor:
    """Quaternions ``[F, ..., 4]`` with signs chosen so that neighbouring frames are close."""
    w, x, y, z = (q[1:] * q[:-1]).unbind(-1)
    apart = w + x + y + z < 0
    if not (q.is_meta or bool(apart.any())):
        return q
    return torch.cat((q[:1], q[1:] * (1 - 2 * apart.to(q.dtype)[..., None]).cumprod(0)))
