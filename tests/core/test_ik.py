import math

import pytest
import torch
from hypothesis import given, strategies as st
from torch.testing import assert_close

from toolkit.motion import contacts, forward_kinematics, ik, rotations as R

coordinate = st.floats(-2, 2, width=32)
point = st.tuples(*[coordinate] * 3).map(lambda p: torch.tensor(p, dtype=torch.float64))
HIP, KNEE, ANKLE = torch.tensor(
    [[0.1, 0.95, 0.0], [0.1, 0.513, 0.02], [0.1, 0.081, 0.0]], dtype=torch.float64
)
UPPER, LOWER = float((KNEE - HIP).norm()), float((ANKLE - KNEE).norm())
FORWARD = torch.tensor([0.0, 0.0, 1.0], dtype=torch.float64)
STILL = R.identity(1, dtype=torch.float64)


@given(point, point)
def test_two_bone_keeps_lengths_and_meets_what_it_can_reach(target, pole):
    knee, ankle = ik.two_bone(HIP, KNEE, ANKLE, target, pole if pole.norm() > 1e-3 else None)
    assert float((knee - HIP).norm()) == pytest.approx(UPPER, abs=1e-6)
    assert float((ankle - knee).norm()) == pytest.approx(LOWER, abs=1e-6)
    distance = float((target - HIP).norm())
    if abs(UPPER - LOWER) + 0.01 < distance < 0.98 * (UPPER + LOWER):
        assert_close(ankle, target, atol=1e-9, rtol=0)


@given(st.floats(0.3, 0.86), st.floats(-0.6, 1.0), st.floats(-3.1, 3.1))
def test_a_knee_that_bends_backwards_is_mirrored_to_the_front(distance, swing, turned):
    """Knees bent to any side; the line from right to left hip is +x, whatever its length."""
    bent = torch.tensor([0.1 * math.sin(turned), -0.43, 0.1 * math.cos(turned)])
    target = HIP + distance * R.normalize(torch.tensor([0.1, -1.0, swing], dtype=torch.float64))
    chain = HIP, HIP + bent.double(), HIP + torch.tensor([0.0, -0.86, 0.0]).double()
    left = torch.tensor([0.2, 0.0, 0.0], dtype=torch.float64)
    before, knee = (ik.two_bone(*chain, target, left=axis)[0] for axis in (None, left))
    line = R.normalize(target - HIP)
    front = torch.linalg.cross(line, R.normalize(left))
    ahead, were = ((place - HIP) @ front for place in (knee, before))
    assert float(ahead) > -1e-9
    if float(were) > 0:
        assert_close(knee, before)


def test_two_bone_takes_any_leading_shape_and_degenerate_input():
    a, b, c = (x.float().expand(2, 5, 3) for x in (HIP, KNEE, ANKLE))
    target = torch.randn(2, 5, 3, generator=torch.Generator().manual_seed(0))
    target[0, 0] = HIP.float()  # on the root itself
    target[0, 1] = HIP.float() + torch.tensor([0.0, 0.0, 0.5])  # along the pole
    knee, ankle = ik.two_bone(a, b, c, target, FORWARD.float(), soft=torch.full((2, 5, 1), 0.02))
    assert knee.shape == ankle.shape == (2, 5, 3)
    assert bool(torch.isfinite(knee).all() and torch.isfinite(ankle).all())
    # where no direction is known, that of the limb is kept
    assert float((ankle - a)[0, 0] @ (c - a)[0, 0]) > 0
    lengths = (knee - a).norm(dim=-1)
    assert_close(lengths, torch.full((2, 5), UPPER), atol=1e-5, rtol=0)


def test_a_limb_whose_end_stays_where_it_is_does_not_move():
    knee, ankle = ik.two_bone(HIP, KNEE, ANKLE, ANKLE, soft=0.0)
    assert_close((knee, ankle), (KNEE, ANKLE))


@pytest.mark.parametrize("distance", [0.02, 0.7, 0.85, 0.868, 1.4])
def test_two_bone_against_bisection(distance):
    """The limb is swung open until the lower bone fits; the soft limit is walked in steps."""
    soft, full = 0.03, UPPER + LOWER
    reached, step = min(distance, full * (1 - soft)), 1e-5
    for _ in range(round((distance - reached) / step)):
        reached += step * (full - reached) / (soft * full)  # slower near full stretch
    line = R.normalize(torch.tensor([0.3, -1.0, 0.2], dtype=torch.float64))
    across = R.normalize(FORWARD - (FORWARD @ line) * line)
    low, high = 0.0, math.pi
    for _ in range(60):
        angle = (low + high) / 2
        middle = HIP + UPPER * (math.cos(angle) * line + math.sin(angle) * across)
        fits = float((HIP + reached * line - middle).norm()) < LOWER
        low, high = (angle, high) if fits else (low, angle)
    knee, ankle = ik.two_bone(HIP, KNEE, ANKLE, HIP + distance * line, 3 * FORWARD, soft=soft)
    assert_close(ankle, HIP + reached * line, atol=1e-5, rtol=0)
    assert_close(knee, middle, atol=1e-3 if reached > 0.84 else 1e-7, rtol=0)


def test_a_foot_that_stands_keeps_its_direction():
    """Also a steep one that rolls; at most so far off the prediction, and back to it in the air."""
    steep = R.from_axis_angle(torch.tensor([1.0, 0.0, 0.0]), torch.tensor(1.2))
    before = R.multiply(R.yaw(torch.tensor([2.9, -1.0])), steep)
    after = R.multiply(R.yaw(torch.tensor([3.2, -2.0])), steep)  # beyond half a turn, and too far
    swivel = torch.tensor([0.1, 0.1])
    turned = ik.hold_feet(swivel, before, after, torch.tensor([1.0, 0.6]), 1 / 60)
    assert turned == pytest.approx([-0.2, ik.SWIVEL], abs=1e-5)
    turned = ik.hold_feet(swivel, before, after, torch.tensor([0.0, 0.25]), 1 / 60)
    free = 0.1 * math.exp(-ik.RETURN / 60)
    assert turned == pytest.approx([free, (free + ik.SWIVEL) / 2], abs=1e-5)


def test_hips_do_not_sink_to_an_ankle_that_is_a_leg_ahead():
    """Half of the leg's length is the least height that the hips keep above it."""
    hips, ankles = torch.zeros(2, 3), torch.tensor([[0.0, -0.4, 0.88], [0.0, -0.8, 0.0]])
    sunk = ik.sink(torch.zeros(2), hips, ankles, torch.full((2,), 0.9), torch.ones(2), 1 / 60)
    assert sunk.tolist() == [0.0, 0.0]


@pytest.mark.parametrize(("where", "contacts", "moved"), [
    ((0.02, 0.0), (1.0, 0.0), (0.0, 0.025)),  # 4.5 cm of a leg of 90
    ((0.02, 0.13), (0.0, 1.0), (0.025, 0.0)),
    ((0.02, 0.14), (1.0, 0.25), (0.0, 0.5 * (0.025 - 1.5 * 0.005))),  # the foot lands
    ((-0.1, 0.02), (0.0, 1.0), (1 / 30, 0.0)),  # at most with 2 m/s
    ((-0.1, 0.3), (0.0, 0.0), (0.0, 0.0)),  # legs cross in front of each other
    ((0.2, 0.0), (0.0, 0.0), (0.0, 0.0)),
])
def test_an_ankle_in_the_air_passes_beside_the_other(where, contacts, moved):
    """Sideways and ahead of the right ankle the left one is ``where``; hips look anywhere."""
    angle, (aside, ahead) = torch.tensor(0.7), where
    left, forward = (R.rotate(R.yaw(angle), torch.eye(3)[i]) for i in (0, 2))
    right = torch.tensor([3.0, 0.1, -2.0])
    ankles = torch.stack((right, right + aside * left + ahead * forward))
    made = ik.uncross(ankles, 0.2 * left[None] + torch.tensor([0.0, 0.05, 0.0]),
                      torch.full((2,), 0.9), torch.tensor(contacts), 1 / 60)
    wanted = torch.tensor([[-moved[0]], [moved[1]]]) * left
    assert made - ankles == pytest.approx(wanted, abs=1e-6)


@pytest.fixture
def poses(walk_clip):
    """Skeleton, rotations ``[2, 3, J, 4]`` and roots ``[2, 3, 3]`` of moments of a walk.

    Networks predict a rotation for the End Sites of hands; a file has no room for it.
    """
    rotations = R.normalize(walk_clip.rotations[60:420:60].double())
    rotations[:, ends_of(walk_clip.skeleton)] = R.yaw(torch.tensor(0.5, dtype=torch.float64))
    roots = walk_clip.root_positions[60:420:60].double()
    return walk_clip.skeleton, *(x.unflatten(0, (2, 3)) for x in (rotations, roots))


def ends_of(skeleton) -> list[int]:
    return [j for j in range(len(skeleton)) if skeleton.is_end(j)]


def joints_of(skeleton, *parts) -> list[int]:
    return [skeleton.index(f"{side}_{part}") for part in parts for side in contacts.FEET]


def angles(a, b) -> torch.Tensor:
    """By how much rotations differ, radians."""
    return 2 * R.multiply(R.inverse(a), b)[..., 1:].norm(dim=-1).clamp_max(1.0).asin()


def test_planted_toes_meet_their_targets_and_nothing_but_the_legs_moves(poses):
    """The targets are 10 to 20 cm above the toes of a walk."""
    skeleton, rotations, root = poses
    turned, places = forward_kinematics(*poses)
    toes = places[..., joints_of(skeleton, "toe"), :]
    moved = torch.rand(toes.shape, generator=torch.Generator().manual_seed(0))
    toes = toes + moved * torch.tensor([0.02, 0.1, 0.02]) + torch.tensor([-0.01, 0.1, -0.01])
    planted = ik.plant_feet(skeleton, rotations, root, toes)
    assert planted.shape == rotations.shape
    turned_now, now = forward_kinematics(skeleton, planted, root)
    assert_close(now[..., joints_of(skeleton, "toe"), :], toes, atol=1e-9, rtol=0)
    ends, legs = ends_of(skeleton), joints_of(skeleton, "hip", "knee")
    assert angles(planted[..., ends, :], STILL).max() < 1e-7
    others = [j for j in range(len(skeleton)) if j not in (*ends, *legs)]
    # The feet keep their orientation.
    assert angles(turned, turned_now)[..., others].max() < 1e-7
    assert angles(turned, turned_now)[..., legs].min() > 0.05
    below = joints_of(skeleton, "knee", "foot", "toe")
    above = [j for j in others if j not in below and skeleton.parents[j] not in below]
    assert_close(now[..., above, :], places[..., above, :], atol=1e-12, rtol=0)


@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.15), (-0.1, 0.05, 0.1)])
def test_a_nearly_straight_leg_keeps_its_knee_forwards(walk_clip, shift):
    """The knee of a leg that is swung as a whole stays on its side of it."""
    skeleton, rotations = walk_clip.skeleton, walk_clip.rotations.double()
    root = walk_clip.root_positions.double()
    turned, places = forward_kinematics(skeleton, rotations, root)
    hips = turned[:, :1]
    move = R.rotate(hips, torch.tensor(shift, dtype=torch.float64))
    toes = places[:, joints_of(skeleton, "toe")] + move
    now = forward_kinematics(skeleton, ik.plant_feet(skeleton, rotations, root, toes), root)[1]
    hip, knee, foot = (R.rotate(R.inverse(hips), now[:, joints_of(skeleton, part)])
                       for part in ("hip", "knee", "foot"))
    line = R.normalize(foot - hip)
    bend = (knee - hip) - ((knee - hip) * line).sum(-1, keepdim=True) * line
    assert (bend[..., 2] / bend.norm(dim=-1)).min() > 0.7


def arms_of(skeleton) -> list[int]:
    return [skeleton.index(f"{side}{part}") for side in ("Right", "Left")
            for part in ("Collar", "Shoulder", "Elbow", "Wrist")]


def waved(skeleton, rotations, root) -> torch.Tensor:
    """Positions of the same poses with every arm bone turned by up to a radian or so."""
    arms, generator = arms_of(skeleton), torch.Generator().manual_seed(3)
    shape = *rotations.shape[:-2], len(arms), 3
    axes = torch.randn(shape, generator=generator, dtype=rotations.dtype)
    turn = R.from_axis_angle(R.normalize(axes), 0.4 * axes.norm(dim=-1))
    rotations = rotations.clone()
    rotations[..., arms, :] = R.multiply(turn, rotations[..., arms, :])
    return forward_kinematics(skeleton, rotations, root)[1]


def test_turned_arms_reach_predicted_positions_of_their_own_bones(poses):
    skeleton, rotations, root = poses
    wanted, arms, ends = waved(*poses), arms_of(skeleton), ends_of(skeleton)
    read = {j for j in range(len(skeleton)) if skeleton.parents[j] in arms}
    unread = [j for j in range(len(skeleton)) if j not in read]
    before = forward_kinematics(*poses)[1]
    assert (wanted - before)[..., sorted(read), :].norm(dim=-1).mean() > 0.1
    expected, predicted = wanted.clone(), wanted.clone()
    predicted[..., unread, :] = float("nan")
    turned = ik.turn_arms(skeleton, rotations, root, predicted)
    now = forward_kinematics(skeleton, turned, root)[1]
    assert_close(now, expected, atol=1e-9, rtol=0)
    assert angles(turned[..., ends, :], STILL).max() < 1e-7
    others = [j for j in range(len(skeleton)) if j not in (*arms, *ends)]
    assert angles(rotations, turned)[..., others].max() < 1e-7
    # Arms that are there stay.
    assert angles(turned, ik.turn_arms(skeleton, turned, root, predicted)).max() < 1e-6


def test_a_hand_without_an_end_site_keeps_its_orientation(walk_clip):
    clip = walk_clip.without_ends().cut(100, 104)
    skeleton, rotations, root = clip.skeleton, clip.rotations, clip.root_positions
    wanted = waved(skeleton, rotations, root)
    made = ik.turn_arms(skeleton, rotations, root, wanted)
    turned, places = forward_kinematics(skeleton, made, root)
    assert_close(places, wanted, atol=1e-5, rtol=0)
    hands = joints_of(skeleton, "hand")
    assert angles(turned, clip.global_rotations)[..., hands].max() < 1e-3
