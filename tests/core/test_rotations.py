import itertools
import math

import numpy as np
import pytest
import torch
from hypothesis import given, strategies as st
from strategies import quaternions, seeds
from torch.testing import assert_close

from toolkit.motion import rotations as R

ORDERS = ["".join(p) for p in itertools.permutations("XYZ")]


def angle_between(a, b):
    """Angle of the rotation from a to b; q and -q are the same rotation."""
    difference = R.multiply(R.inverse(a), b)
    return 2 * torch.atan2(difference[..., 1:].norm(dim=-1), difference[..., 0].abs())


def axis_matrix(axis, angle):
    """The textbook matrix of a turn about one axis."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array({"X": [[1, 0, 0], [0, c, -s], [0, s, c]],
                     "Y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
                     "Z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis])


@given(seeds)
def test_matrix_round_trip(seed):
    q = quaternions(seed, 7, 3)
    m = R.to_matrix(q)
    assert_close(m @ m.transpose(-1, -2), torch.eye(3, dtype=q.dtype).expand_as(m))
    assert angle_between(q, R.from_matrix(m)).max() < 1e-7


def test_matrix_of_half_turns():
    q = R.from_axis_angle(torch.eye(3).double(), torch.full((3,), math.pi, dtype=torch.float64))
    assert_close(q[:, 1:], torch.eye(3).double())
    assert angle_between(q, R.from_matrix(R.to_matrix(q))).max() < 1e-7


@pytest.mark.parametrize("order", ORDERS)
@given(angles=st.tuples(*[st.floats(-math.pi, math.pi)] * 3))
def test_euler_is_the_product_of_axis_matrices(order, angles):
    q = R.from_euler(torch.tensor(angles, dtype=torch.float64), order)
    first, second, third = map(axis_matrix, order, angles)
    np.testing.assert_allclose(R.to_matrix(q), first @ second @ third, atol=1e-12)


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("dtype", "error"), [(torch.float64, 1e-14), (torch.float32, 3e-6)])
def test_euler_round_trip_also_at_the_gimbal_lock(order, dtype, error):
    """Two of the angles run together where the middle one is near 90°; at it, the third is 0."""
    off = torch.tensor([0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 4e-4, 1e-3, 1e-2, 0.3, 0.8,
                        1.4]).double()
    middle = torch.cat([sign * math.pi / 2 + side * off for sign in (-1, 1) for side in (-1, 1)])
    generator = torch.Generator().manual_seed(0)
    outer = 6 * torch.rand(len(middle), 2, dtype=torch.float64, generator=generator) - 3
    angles = torch.stack((outer[:, 0], middle, outer[:, 1]), 1)
    q = R.from_euler(angles, order).to(dtype)
    found = R.to_euler(q, order)
    assert found[:: len(off), 2].abs().max() < error
    apart = R.to_matrix(R.from_euler(found, order).double()) - R.to_matrix(R.normalize(q.double()))
    assert apart.abs().max() < error


def test_a_vector_without_length_stays_as_it_is():
    assert torch.equal(R.normalize(torch.zeros(2, 3)), torch.zeros(2, 3))


@given(seeds)
def test_forward_up_round_trip_also_when_up_leans(seed):
    q = quaternions(seed, 9)
    forward, up = R.to_forward_up(q)
    assert angle_between(q, R.from_forward_up(forward, up)).max() < 1e-6
    leaning = R.from_forward_up(2 * forward, up + 0.3 * forward)
    assert_close(R.to_forward_up(leaning)[0], forward)


@given(seeds)
def test_products_and_vectors_agree_with_matrices(seed):
    a, b = quaternions(seed, 2, 5)
    v = quaternions(seed + 1, 5)[:, :3]
    assert_close(R.to_matrix(R.multiply(a, b)), R.to_matrix(a) @ R.to_matrix(b))
    assert_close(R.rotate(a, v), (R.to_matrix(a) @ v[..., None]).squeeze(-1))
    parts = R.rotate_parts(a.unbind(-1), v.unbind(-1))
    assert_close(torch.stack(parts, -1), R.rotate(a, v))
    assert_close(R.rotate(R.inverse(a), R.rotate(a, v)), v)


@given(seeds)
def test_slerp_ends_and_middle(seed):
    a, b = quaternions(seed, 2, 6)
    whole = angle_between(a, b)
    assert angle_between(R.slerp(a, b, 0.0), a).max() < 1e-6
    assert angle_between(R.slerp(a, b, 1.0), b).max() < 1e-6
    assert_close(angle_between(a, R.slerp(a, b, 0.25)), whole / 4, atol=1e-6, rtol=0)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
def test_slerp_has_the_gradient_of_its_limit_where_both_ends_are_equal(sign, dtype):
    a = quaternions(3, 6, dtype=dtype)
    ends = a.clone().requires_grad_(), (sign * a).requires_grad_()
    R.slerp(*ends, 0.25)[..., 0].sum().backward()
    # What moves along the sphere counts, by its share.
    across = torch.eye(4, dtype=dtype)[0] - a[:, :1] * a
    assert_close(ends[0].grad, 0.75 * across)
    assert_close(ends[1].grad, sign * 0.25 * across)


def test_slerp_times_broadcast():
    a, b = quaternions(3, 2)
    t = torch.linspace(0, 1, 5)
    assert R.slerp(a, b, t).shape == (5, 4)
    assert_close(R.slerp(a, a, t), a.expand(5, 4))


@given(seeds)
def test_between_turns_one_direction_into_the_other(seed):
    a, b = R.normalize(quaternions(seed, 2, 6)[..., :3])
    q = R.between(a, 3 * b)
    assert_close(R.rotate(q, a), b, atol=1e-6, rtol=0)
    angle = 2 * torch.acos(q[..., 0].clamp(-1, 1))
    assert_close(angle, torch.acos((a * b).sum(-1)), atol=1e-6, rtol=0)


def test_between_opposite_directions():
    v = R.normalize(torch.tensor([[1.0, 0, 0], [0, -1, 0], [0, 0, 1], [1, 1, 1]]))
    assert_close(R.rotate(R.between(v, -v), v), -v, atol=1e-6, rtol=0)
    assert_close(R.rotate(R.between(v, v), v), v)


def test_the_least_axis_is_that_of_the_smallest_component():
    v = torch.tensor([[3.0, -0.1, 2.0], [0.2, 1.0, -5.0]])
    assert R.least_axis(v).tolist() == [[0, 1, 0], [1, 0, 0]]


def test_yaw_turns_forward_towards_left():
    forward = R.rotate(R.yaw(torch.tensor(math.pi / 2)), torch.tensor([0.0, 0, 1]))
    assert_close(forward, torch.tensor([1.0, 0, 0]), atol=1e-6, rtol=0)


@given(seeds)
def test_unroll_keeps_rotations_and_removes_jumps(seed):
    q = quaternions(seed, 1).expand(6, 4) * torch.tensor([1, -1, -1, 1, -1, 1.0])[:, None]
    assert_close(R.unroll(q), q[:1].expand(6, 4))
