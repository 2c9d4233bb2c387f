"""The runtime's bookkeeping: frames of reference, commands, blends, recording.

`test_compiled` and `test_web` compare its steps with two other implementations.
"""

import copy
import itertools
import math
from dataclasses import replace

import pytest
import torch
from refusal import refusal
from test_networks import TINY
from torch.testing import assert_close

import toolkit as tk
from toolkit import runtime
from toolkit.features import Layout, split_joints


class Replay:
    """Answers every question with the true next frame of a clip: a perfect model."""

    def __init__(self, clip):
        self.layout = Layout(clip.skeleton)
        self.rows = tk.features.frames(clip)
        self.outputs_mean, self.phases_mean = self.rows.outputs.mean(0), self.rows.phases.mean(0)
        self.phases_std = self.rows.phases.std(0)
        self.frame = 0
        self.style_size, self.memory, self.life, self.lift, self.ground = 1, 0, 0.0, 1.0, 0.02

    def predict(self, x, phases, style):
        self.frame += 1
        return self.rows.outputs[self.frame - 1][None]


@pytest.fixture(scope="module")
def perfect(walk_clip):
    """A perfect model."""
    return Replay(walk_clip)


@pytest.fixture
def replayed(walk_clip, perfect):
    """A perfect model and the state that the clip is in at the first usable frame."""
    model = copy.copy(perfect)
    roots = tk.motion.root_frames(walk_clip)
    at = int(model.rows.index[0])
    forward = tk.motion.rotations.rotate(roots.rotations, torch.tensor([0.0, 0.0, 1.0]))
    world = torch.cat((roots.positions[:, [0, 2]], forward[:, [0, 2]]), -1)
    state = runtime.start(model, torch.zeros(1))
    joints = model.rows.inputs[0, model.layout.inputs["joints"]]
    state = replace(
        state,
        history=world[None, at - 60 : at + 1],
        future=world[None, at : at + 51 : 10],
        joints=joints[None],
        phase=model.rows.phases[:1],
        rest=torch.zeros(1, 1),
    )
    state = replace(state, toes=runtime.frame.predicted_toes(model.layout, state))
    return model, state, at


def test_a_perfect_model_replays_the_clip(walk_clip, replayed):
    """Roots, poses, phases and contacts come out as they were, whatever the command says."""
    model, state, at = replayed
    run = []
    for _ in range(120):
        state = runtime.step(model, state, runtime.Command((0.0, 5.0), (1.0, 0.0)))
        run.append(state)
    clip = runtime.record(model, run, feet=False, arms=False)
    sunk = torch.cat([one.drop[:, 0] for one in run])
    expected = walk_clip.global_positions[at + 1 : at + 121]
    assert (clip.global_positions - expected).abs().max() < 0.01
    assert sunk[60:].max() < 0.015  # procedural legs are nearly straight in stance
    expected_phase = model.rows.outputs[119, model.layout.outputs["phases"]]
    assert (run[-1].phase - expected_phase).abs().max() < 1e-4


def test_a_model_with_a_memory_is_given_the_frames_before(perfect):
    model, seen = copy.copy(perfect), []
    model.memory = 2

    def predict(x, *rest):
        seen.append(x)
        return replay(x, *rest)

    replay, model.predict = model.predict, predict
    list(runtime.states(model, runtime.straight(1.0, 0.1), torch.zeros(1)))
    assert seen[0].shape == (1, 3, model.layout.n_inputs)
    assert torch.equal(seen[0][:, 0], seen[0][:, 1])  # it has stood there before
    assert all(torch.equal(new[:, :2], old[:, 1:]) for old, new in itertools.pairwise(seen))
    assert all(not torch.equal(x[:, 1], x[:, 2]) for x in seen)


def test_the_pose_that_is_fed_back_is_the_drawn_one(small_run):
    """Knees, feet and toes of the next input are those of the drawn pose before its hips sink."""
    model, bank = small_run.model, small_run.bank
    state = runtime.start(model, bank.vectors[:2])
    for command in runtime.straight(1.0, 0.5):
        before, state = state, runtime.step(model, state, command)
    again = runtime.step(model, before, command)  # a state stays as it was, and can branch
    assert torch.equal(again.joints, state.joints)
    skeleton = model.layout.skeleton
    rotations, root = runtime.pose(model, replace(state, drop=0 * state.drop))
    drawn = tk.motion.forward_kinematics(skeleton, rotations, root)[1]
    here = runtime.world_joints(state.joints, state.root)["position"]
    for part in ("knee", "foot", "toe"):
        for side in ("right", "left"):
            joint = skeleton.role(f"{side}_{part}")
            fed = here[:, model.layout.names.index(skeleton.names[joint])]
            assert (drawn[:, joint] - fed).abs().max() < 1e-4


def test_the_start_does_not_matter_to_the_motion(small_run):
    """A character that starts elsewhere, facing elsewhere, makes the same moves there."""
    model, style = copy.deepcopy(small_run.model).double(), small_run.bank.vectors[0].double()
    here = runtime.start(model, style)
    there = runtime.start(model, style, position=(5.0, -3.0), facing=(1.0, 0.0))
    # it has stood there for a second
    assert there.history[0].tolist() == [[5.0, -3.0, 1.0, 0.0]] * 61
    for _ in range(15):
        here = runtime.step(model, here, runtime.Command((0.0, 1.0), (0.0, 1.0)))
        there = runtime.step(model, there, runtime.Command((1.0, 0.0), (1.0, 0.0)))
    assert (here.joints - there.joints).abs().max() < 1e-6
    assert (there.root[0, :2] - torch.tensor([5.0, -3.0])).tolist() == pytest.approx(
        [float(here.root[0, 1]), -float(here.root[0, 0])], abs=1e-3
    )


def test_the_trajectory_bends_towards_the_command(small_run):
    state, command = runtime.start(small_run.model, small_run.bank.vectors[0]), ((1.0, 0.0),) * 2
    # one that stands follows the command alone
    target = torch.arange(1, 6) * 10 / 60
    standing = replace(state, velocity=torch.tensor(command[:1]), rest=state.aside)
    future = runtime.steer(standing, runtime.Command(*command)).future
    assert future[0, 1:, 0].tolist() == pytest.approx(target.tolist(), abs=1e-3)
    # another has walked to here
    history = state.history.clone()
    history[0, :, 0] = torch.arange(-60, 1) / 60
    state = replace(state, history=history)
    for _ in range(60):
        steered = runtime.steer(state, runtime.Command(*command))
        velocity, facing, future = steered.velocity, steered.facing, steered.future
        state = replace(state, velocity=velocity, facing=facing, rest=steered.rest)
    assert velocity[0].tolist() == pytest.approx([1.0, 0.0], abs=1e-3)
    assert facing[0].tolist() == pytest.approx([1.0, 0.0], abs=1e-3)
    # each step of a standing trajectory goes this far to the target's
    share = 1 - (1 - torch.arange(1, 6) / 5) ** 0.75
    expected = (share.cumsum(0) * 10 / 60).tolist()
    assert future[0, 1:, 0].tolist() == pytest.approx(expected, abs=1e-3)
    assert future[0, -1, 2:].tolist() == pytest.approx([1.0, 0.0], abs=1e-3)


def test_pilots_keep_to_the_path(perfect):
    """The commands of `follow`, obeyed to the letter."""
    points = torch.tensor([[0.0, 0.0], [0.0, 3.0], [3.0, 3.0]])
    state, trail = runtime.start(perfect, torch.zeros(1), position=(0.5, -0.5)), []
    for pilot in runtime.follow(points, speed=1.0, seconds=8.0):
        history = state.history.clone()
        history[..., :2] += torch.as_tensor(pilot(state).velocity) / 60
        state = replace(state, history=history)
        trail.append(state.root[0, :2])
    trail = torch.stack(trail)
    assert (trail[-1] - points[-1]).norm() < 0.05
    # on the first leg by then, before the corner is near
    assert trail[120:148, 0].abs().max() < 0.05
    assert trail[[270, 300, 340], 0].tolist() == pytest.approx([1.53, 2.02, 2.66], abs=0.02)


def test_bad_commands_are_refused(small_run):
    model, bank, way = small_run.model, small_run.bank, [(0.0, 0.0), (0.0, 1.0)]
    three = runtime.start(model, bank.vectors[:1].repeat(3, 1))
    two = runtime.Command((0.0, 1.0), torch.ones(2, 2))
    text, shape = "^speed.* must be numbers in a tensor", r"^velocity must be one pair \(x, z\), or"
    limits = "a positive speed and 0 to 86400 s; got .*, .* m/s, .* s"
    for said, call, *given in (
        ("no frames to record", runtime.record, model, []),
        ("two or more different", runtime.follow, [(0.0, 0.0), (0.0, 0.0)]),
        ("all finite", runtime.follow, [(0.0, 0.0), (0.0, math.nan)]),
        ("facing is the direction of the walk", runtime.straight, 1.0, 10.0, (0.0, 0.0)),
        (text, runtime.straight, "1"),
        (r"^velocity must be finite, up to 1e\+06", runtime.straight, math.inf),
        *(("^seconds must be from 0 to 86400, got", runtime.straight, 1.0, bad)
          for bad in (-1.0, 86_401.0, math.nan)),
        *((r"^velocity must be finite, up to 1e\+06", runtime.Command, bad)
          for bad in ((-2e6, 0.0), torch.tensor([[0.0, 1.001e6]]))),
        *((limits, runtime.follow, way, *bad)
          for bad in ((0.0,), (1.0, -1.0), (1.0, math.inf), (1.0, 86_401.0))),
        (shape, runtime.Command, (1.0, 2.0, 3.0)),
        (r"^facing must be finite, up to 1e\+06; got .*nan.*$", runtime.Command, (0.0, 1.0),
         torch.tensor([[0.0, 1.0], [math.nan, 1.0]])),
        (r"facing must be one pair \(x, z\), or \[3, 2\] of", runtime.step, model, three, two),
    ):
        with refusal(said):
            call(*given)


def test_states_leave_the_callers_mode_alone_and_can_be_used_in_a_loss(small_run):
    model, style = small_run.model, small_run.bank.vectors[0]
    paused = runtime.states(model, runtime.straight(1.0, 0.05), style)
    state = next(paused)
    assert torch.is_grad_enabled()
    assert not torch.is_inference_mode_enabled()
    weight = torch.ones_like(state.joints, requires_grad=True)
    (weight * state.joints).sum().backward()
    assert torch.equal(weight.grad, state.joints)


def test_a_rollout_drops_nothing_out_of_a_model_in_training_mode(walk_clip):
    model = tk.networks.build("lpn-film", Layout(walk_clip.skeleton), 1, tk.networks.Sizes.small())
    commands, style = runtime.straight(1.0, 0.1), torch.randn(model.style_size)
    expected = runtime.rollout(model, commands, style)
    recorded = runtime.record(model, runtime.states(model, commands, style))
    assert torch.equal(recorded.rotations, expected.rotations)
    for without in ({"feet": False}, {"arms": False}):
        other = runtime.record(model, runtime.states(model, commands, style), **without)
        assert not torch.equal(other.rotations, expected.rotations)
    model.train().gating.eval()  # a part that its user froze stays frozen
    assert torch.equal(runtime.rollout(model, commands, style).rotations, expected.rotations)
    assert model.training
    assert model.experts.dropout.training
    assert not model.gating.dropout.training


def test_straight_commands():
    commands = runtime.straight(speed=2.0, seconds=1.5, facing=(3.0, 4.0))
    assert len(commands) == 90
    assert commands[0].velocity == pytest.approx((1.2, 1.6))
    assert runtime.straight()[599].velocity == (0.0, 1.2)  # for ten seconds
    assert vars(runtime.Command()) == {"velocity": (0.0, 0.0), "facing": (0.0, 1.0)}
    assert len(runtime.straight(1.0, 86_400.0)) == 60 * 86_400
    assert runtime.Command((-1e6, 1e6)).velocity == (-1e6, 1e6)


KINDS = "pfnn-onehot", "lpn-resad", "mann-film", "lpn-film"


@pytest.fixture(scope="module")
def drawn(two_styles):
    """Models with each kind of phase and of modulation, of drawn weights, with their banks."""
    found = {}
    for name in KINDS:
        torch.manual_seed(0)
        model = tk.networks.build(name, two_styles.layout, 2, TINY).eval()
        model.normalise(tk.networks.normalisers(model.layout, two_styles))
        found[name] = model, tk.training.make_bank(model, two_styles, 2)
    return found


@pytest.mark.parametrize("name", KINDS)
def test_each_kind_of_model_moves_a_character(drawn, name):
    """As each would alone in a crowd of several styles, and through a live blend."""
    model, bank = drawn[name]
    model = copy.deepcopy(model).double()  # such a model amplifies rounding
    blend = bank.blend({"Neutral": 0.4, "Zombie": 0.6})
    commands = runtime.straight(1.0, 0.1)
    vectors = torch.stack((*bank.vectors, blend)).double()
    crowd = list(runtime.states(model, commands, vectors))
    for i, vector in enumerate(vectors):
        *_, alone = runtime.states(model, commands, vector)
        for part in ("joints", "root", "phase"):
            apart = getattr(crowd[-1], part)[i] - getattr(alone, part)[0]
            assert apart.abs().sum() < 1e-8, part
        assert crowd[-1].phase[i].shape == (model.layout.n_phases,)
    one, other, _ = crowd[-1].joints
    assert (one - other).abs().max() > 1e-4  # the vector counts

    def blended(frame):
        return bank.blend({"Neutral": 1 - frame / 6, "Zombie": frame / 6}).double()

    clip = runtime.rollout(model, commands, blended)
    assert len(clip) == 6
    assert clip.global_positions.isfinite().all()
    switched = runtime.step(model, crowd[-1].with_style(vectors[1]), commands[0])
    assert torch.equal(switched.style, vectors[1].expand(3, -1))


def test_a_global_phase_stays_an_angle_and_goes_on(drawn):
    model, bank = drawn["pfnn-onehot"]
    start = runtime.start(model, bank["Neutral"])
    # about to step: the right foot back, the left ahead
    assert float(start.phase) == pytest.approx(1.5 * math.pi)
    states = list(runtime.states(model, runtime.straight(1.0, 0.75), bank["Neutral"], start))
    angle = torch.stack([s.phase[0, 0] for s in states])
    assert ((angle >= 0) & (angle < math.tau)).all()
    steps = (angle.diff() + math.pi) % math.tau - math.pi
    assert 0.02 < steps.mean() < 0.3  # radians per frame; a walk has 0.1


def test_a_model_without_phases_starts_with_its_limbs_amid_a_stride(drawn):
    poses = {}
    for name in ("mann-film", "lpn-film"):
        model, bank = drawn[name]
        block = model.layout.outputs["joints"]
        state = runtime.start(model, bank["Neutral"])
        mean, deviation = model.outputs_mean[block], model.outputs_std[block]
        shift = split_joints((state.joints[0] - mean) / deviation)
        poses[name] = {channel: shift[channel] for channel in ("position", "velocity")}
    ahead = torch.tensor([-2.0, 2.0, 2.0, -2.0])  # left foot and right hand
    limbs, moved = model.layout.limbs, poses["mann-film"]
    assert_close(moved["position"][limbs, 2], ahead, rtol=1e-3, atol=1e-3)
    assert_close(moved["velocity"][limbs, 2], -ahead, rtol=1e-3, atol=1e-3)
    assert int((torch.cat((*moved.values(),)).abs() > 1e-3).sum()) == 8  # nothing else
    assert all(float(values.abs().max()) < 1e-3 for values in poses["lpn-film"].values())


def test_pilots_command_their_speed_along_the_path_and_half_more_if_late(replayed):
    """Of two characters, the second is two metres behind the first."""
    state = runtime.start(replayed[0], torch.zeros(2, 1), position=[(3.0, -2.0), (3.0, -4.0)])
    pilots = runtime.follow([(3.0, -2.0), (3.0, 18.0)], speed=2.0)
    for frame, speed in ((0, 2.0), (300, 3.0), (-1, 3.0)):  # ten metres late, and twenty
        command = pilots[frame](state)
        expected = torch.tensor([[0.0, speed], [0.0, 3.0]])
        assert_close(command.velocity, expected, atol=1e-4, rtol=0)
        look = torch.nn.functional.normalize(command.facing, dim=-1)
        assert_close(look, torch.tensor([0.0, 1.0]), check_dtype=False)


def test_future_directions_turn_towards_the_command_by_the_weight_of_their_time(replayed):
    """The facing turns from +z to +x, by 3 degrees in a frame at most.

    The samples ahead take a growing share of that.
    """
    state = runtime.start(replayed[0], torch.zeros(1))
    state = replace(state, rest=torch.zeros(1, 1))
    command, ahead = runtime.Command((0.0, 0.0), (1.0, 0.0)), (0, 10, 20, 30, 40, 50)
    steered = runtime.steering.steer(state, command, ahead)
    facing, future = steered.facing, steered.future
    turned = math.pi / 60
    assert_close(facing[0], torch.tensor([math.sin(turned), math.cos(turned)]))
    angles = torch.atan2(future[0, :, 2], future[0, :, 3]).tolist()
    rest = 1 / 36  # after one frame of standing
    expected = [0.0, *(turned * (1 - (1 - rest) * (1 - k / 5) ** 1.25) for k in range(1, 6))]
    assert angles == pytest.approx(expected, abs=1e-6)


def test_no_controller_jumps_when_a_command_passes_through_standing(replayed):
    """The lateral velocity is corrected with a speed factor of 9; the command is 0.1 m/s."""
    state = runtime.start(replayed[0], torch.zeros(1))
    state = replace(state, aside=torch.ones(1, 1), drive=torch.full((1, 1), 9.0))
    futures = [
        runtime.steering.steer(replace(state, velocity=torch.tensor([[0.0, speed]])),
                               runtime.Command((0.0, speed)), (0, 10, 20, 30, 40, 50)).future
        for speed in (0.099, 0.101)
    ]
    assert (futures[0] - futures[1]).abs().max() < 0.05  # metres


def test_a_start_goes_where_it_is_told():
    """Of people who also walk backwards, some began with that, by up to a metre."""
    model, bank = tk.pretrained("recorded")
    model = runtime.compile(model)
    asked = [runtime.Command()] * 60 + [runtime.Command((0.0, 1.0))] * 90
    vectors = torch.stack([bank[name] for name in ("normal", "masculinity", "exhausted")])
    roots = torch.stack([state.root for state in runtime.states(model, asked, vectors)])
    assert roots[..., 1].min() > -0.15
    assert roots[-1, :, 1].min() > 0.4
