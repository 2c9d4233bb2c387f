import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from toolkit import ik
from toolkit import rotations as R

coordinate = st.floats(-2, 2, width=32)
point = st.tuples(coordinate, coordinate, coordinate).map(lambda p: torch.tensor(p, dtype=torch.float64))
HIP, KNEE, ANKLE = torch.tensor([[0.1, 0.95, 0.0], [0.1, 0.513, 0.02], [0.1, 0.081, 0.0]], dtype=torch.float64)
UPPER, LOWER = float((KNEE - HIP).norm()), float((ANKLE - KNEE).norm())
FORWARD = torch.tensor([0.0, 0.0, 1.0], dtype=torch.float64)
LEFT = torch.tensor([1.0, 0.0], dtype=torch.float64)


@given(point, point)
def test_two_bone_keeps_lengths_and_meets_what_it_can_reach(target, pole):
    knee, ankle = ik.two_bone(HIP, KNEE, ANKLE, target, pole if pole.norm() > 1e-3 else None)
    assert float((knee - HIP).norm()) == pytest.approx(UPPER, abs=1e-6)
    assert float((ankle - knee).norm()) == pytest.approx(LOWER, abs=1e-6)
    distance = float((target - HIP).norm())
    if abs(UPPER - LOWER) + 0.01 < distance < 0.98 * (UPPER + LOWER):
        torch.testing.assert_close(ankle, target, atol=1e-9, rtol=0)


@given(st.floats(0.1, 0.85), st.floats(-1.2, 1.2))
def test_two_bone_bends_towards_the_pole(distance, swing):
    line = torch.tensor([0.0, -1.0, swing], dtype=torch.float64)
    target = HIP + distance * R.normalize(line)
    knee, ankle = ik.two_bone(HIP, KNEE, ANKLE, target, FORWARD)
    side = knee - HIP - ((knee - HIP) * R.normalize(ankle - HIP)).sum() * R.normalize(ankle - HIP)
    assert float(side @ FORWARD) > 0
    assert abs(float(knee[0] - HIP[0])) < 1e-9  # no sideways motion when pole and target lie in one plane


def test_two_bone_approaches_full_stretch_without_a_pop():
    distance = torch.linspace(0.7, 1.0, 301, dtype=torch.float64)
    target = HIP + distance[:, None] * torch.tensor([0.0, -1.0, 0.0], dtype=torch.float64)
    chain = (x.expand(301, 3) for x in (HIP, KNEE, ANKLE))
    knee, ankle = ik.two_bone(*chain, target, FORWARD, soft=0.03)
    reached = (ankle - HIP).norm(dim=-1)
    assert bool((reached.diff() >= -1e-12).all())
    assert float(reached.max()) < UPPER + LOWER
    hard = ik.two_bone(HIP.expand(301, 3), KNEE, ANKLE, target, FORWARD, soft=0.0)[0]
    assert knee[:, 2].diff().abs().max() < 0.35 * hard[:, 2].diff().abs().max()


def test_two_bone_without_a_pole_keeps_the_plane_it_bends_in():
    knee, ankle = ik.two_bone(HIP, KNEE, ANKLE, ANKLE, soft=0.0)
    torch.testing.assert_close(torch.stack((knee, ankle)), torch.stack((KNEE, ANKLE)), atol=1e-9, rtol=0)
    knee, _ = ik.two_bone(HIP, KNEE, ANKLE, ANKLE + torch.tensor([0.0, 0.2, 0.0], dtype=torch.float64))
    assert float(knee[2]) > 0.1


def test_two_bone_takes_any_leading_shape_and_degenerate_input():
    a, b, c = (x.float().expand(2, 5, 3) for x in (HIP, KNEE, ANKLE))
    target = torch.randn(2, 5, 3, generator=torch.Generator().manual_seed(0))
    target[0, 0] = HIP.float()  # on the root itself
    target[0, 1] = HIP.float() + torch.tensor([0.0, 0.0, 0.5])  # along the pole
    knee, ankle = ik.two_bone(a, b, c, target, FORWARD.float(), soft=torch.full((2, 5, 1), 0.02))
    assert knee.shape == ankle.shape == (2, 5, 3)
    assert bool(torch.isfinite(knee).all() and torch.isfinite(ankle).all())
    torch.testing.assert_close((knee - a).norm(dim=-1), torch.full((2, 5), UPPER), atol=1e-5, rtol=0)


def test_two_bone_refuses_a_soft_limit_outside_its_range():
    with pytest.raises(ValueError, match=r"\[0, 1\), got 1.5"):
        ik.two_bone(HIP, KNEE, ANKLE, ANKLE, soft=1.5)


def walked(contacts: torch.Tensor, predicted: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """Targets of `ik.hold` over the frames of predicted toes ``[F, 2, 3]``, and how fast they part from them."""
    toes, drift = [predicted[0]], [torch.zeros(2, 2, dtype=predicted.dtype)]
    for frame in range(1, len(predicted)):
        new = ik.hold(toes[-1], drift[-1], predicted[frame - 1], predicted[frame], contacts[frame], LEFT, 1 / 60)
        toes.append(new[0])
        drift.append(new[1])
    return torch.stack(toes), torch.stack(drift)


def test_a_held_toe_stands_and_then_returns_as_a_spring_at_rest():
    """The right toe creeps back for half a second of contact, then goes on; the left one is never in contact."""
    t = torch.arange(90, dtype=torch.float64) / 60
    creeping = torch.stack((-0.05 * t, 0.02 + 0.01 * t.sin(), -0.2 * t), -1)
    predicted = torch.stack((creeping, creeping + 0.2), 1)
    contacts = torch.zeros(90, 2)
    contacts[10:40, 0] = 0.51
    toes, _ = walked(contacts, predicted)
    torch.testing.assert_close(toes[:, 1], predicted[:, 1])
    torch.testing.assert_close(toes[..., 1], predicted[..., 1])
    torch.testing.assert_close(toes[10:40, 0, ::2], toes[9, 0, ::2].expand(30, 2))
    offset, speed = (toes - predicted)[39, 0, ::2], torch.tensor([0.05, 0.2], dtype=torch.float64)
    for frame in range(40, 90):  # slowly: a thousand small steps of the equation of a critically damped spring
        for _ in range(1000):
            speed = speed - (2 * ik.RETURN * speed + ik.RETURN**2 * offset) / 60000
            offset = offset + speed / 60000
        torch.testing.assert_close((toes - predicted)[frame, 0, ::2], offset, atol=1e-4, rtol=0)
    pushed_off = toes[40, 0].sub(toes[39, 0]).norm() * 60
    assert float(pushed_off) < 0.15 < 0.2 < float((predicted[40] - predicted[39])[0].norm() * 60)


def test_a_toe_left_far_behind_is_dragged():
    predicted = torch.zeros(200, 2, 3, dtype=torch.float64)
    predicted[:, :, 2] = torch.arange(200)[:, None] / 60
    toes, _ = walked(torch.ones(200, 2), predicted)
    behind = (predicted - toes)[..., 2]
    assert float(behind.max()) == pytest.approx(ik.SLACK)
    assert behind[-1].tolist() == pytest.approx([ik.SLACK] * 2)
    assert toes[8, :, 2].tolist() == [0.0, 0.0]  # two centimetres before that they still stand


def test_a_body_that_turns_or_shifts_does_not_cross_its_legs():
    """Both toes are predicted ever further to the right; the left one stays on its side of the right one."""
    predicted = torch.tensor([[-0.1, 0.0, 0.0], [0.1, 0.0, 0.0]], dtype=torch.float64).repeat(30, 1, 1)
    predicted[:, :, 0] -= torch.arange(30)[:, None] / 60
    toes, _ = walked(torch.ones(30, 2), predicted)
    assert (toes - predicted)[-1, :, 0].tolist() == pytest.approx([0.05, 0.15])  # a quarter of 20 cm; outwards `SLACK`
    assert float((toes[:, 1] - toes[:, 0])[:, 0].min()) > 0.1
