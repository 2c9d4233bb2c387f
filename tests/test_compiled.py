import dataclasses
import re

import pytest
import torch

import toolkit as tk
from experiments.speed import runtime as bench
from toolkit import runtime
from toolkit.networks import Sizes
from toolkit.runtime import Command
from toolkit.shots import crowd


@pytest.fixture(scope="module")
def pretrained():
    model, bank = tk.pretrained()
    return model, runtime.compile(model), bank


def inputs(model, count, seed=0):
    """Frames, phases and style vectors of ``count`` characters, all different."""
    seeded = torch.Generator().manual_seed(seed)
    kinds = map(model.normaliser, ("inputs", "phases"))
    x, phases = (n.invert(torch.randn(count, len(n.mean), generator=seeded)) for n in kinds)
    return x, phases, 1 + 0.3 * torch.randn(count, model.style_size, generator=seeded)


def errors(model, compiled, count):
    """Of compiled outputs, in deviations of each column: largest and root mean square."""
    given = inputs(model, count)
    apart = (compiled.predict(*given) - model.predict(*given)) / model.outputs_std
    return float(apart.abs().max()), float(apart.square().mean().sqrt())


def commands(frames, count):
    """Another way for every character, which turns."""
    angles = torch.arange(count) + torch.linspace(0.0, 2.0, frames)[:, None]
    ways = torch.stack((angles.sin(), angles.cos()), -1)
    return [Command(1.2 * way, way) for way in ways]


@pytest.mark.parametrize("calibrated", [False, True])
@pytest.mark.parametrize("sizes", [Sizes(hidden=40, experts=3, gating=7), Sizes(hidden=96)])
def test_the_network_is_the_models_for_any_size_and_number_of_characters(small_run, sizes, calibrated):
    """Sizes that fill no panel and numbers that fill no tile; 131 is more than are computed at once."""
    torch.manual_seed(1)
    model = tk.networks.build("lpn-film", small_run.model.layout, 2, sizes, generator=False, calibrated=calibrated)
    compiled = runtime.compile(model)
    for count in (1, 2, 3, 7, 13, 131):
        assert errors(model, compiled, count)[0] < 1e-4


def test_a_step_equals_the_plain_one_in_everything(pretrained):
    model, compiled, bank = pretrained
    state = runtime.start(model, bank.vectors[:9])
    for command in commands(90, 9):
        before = {name: value.clone() for name, value in vars(state).items()}
        with torch.inference_mode():
            plain = runtime.step(model, state, command)
        fast = runtime.step(compiled, state, command)
        for name, value in vars(plain).items():
            assert float((getattr(fast, name) - value).abs().max()) < 2e-4, name
            assert torch.equal(getattr(state, name), before[name])  # the state itself stays
        state = plain


@pytest.mark.parametrize("feet", [False, True])
@pytest.mark.parametrize("arms", [False, True])
def test_a_pose_equals_the_plain_one(pretrained, feet, arms):
    model, compiled, bank = pretrained
    run = list(runtime.states(compiled, commands(60, 5), bank.vectors[:5]))
    for state in run[::6]:
        (rotations, root), (fast, fast_root) = (runtime.pose(m, state, feet=feet, arms=arms) for m in (model, compiled))
        assert float((rotations - fast).abs().max()) < 1e-4
        assert float((root - fast_root).abs().max()) < 1e-5


def test_legs_and_arms_out_of_reach_bend_alike(pretrained):
    """Toes far away and too near, a pose turned upside down: the rare branches."""
    model, compiled, bank = pretrained
    state = runtime.start(model, bank.vectors[:4], facing=(0.6, -0.8))
    joints = state.joints.clone()
    joints[3].view(-1, 4, 3)[:, :3] *= torch.tensor([1.0, -1.0, -1.0])
    toes = state.toes + torch.tensor([[0.0, 0.0, 2.0], [0.0, 0.9, 0.0], [0.1, 0.0, 0.0], [0.0, 0.0, 0.0]])[:, None]
    state = dataclasses.replace(state, joints=joints, toes=toes)
    skeleton = model.layout.skeleton
    places = [tk.motion.forward_kinematics(skeleton, *runtime.pose(m, state))[1] for m in (model, compiled)]
    assert float((places[0] - places[1]).norm(dim=-1).max()) < 1e-3


def test_rollouts_stay_together_and_do_not_drift_apart(pretrained):
    """1 mm after a second; after ten, where the smallest difference has grown, the same walk still."""
    model, compiled, bank = pretrained
    styles = torch.stack([bank[name] for name in ("Neutral", "Zombie", "Old")])
    ways = [*runtime.straight(1.0, 5.0), *runtime.straight(1.0, 5.0, (1.0, 0.0))]
    runs = [list(runtime.states(m, ways, styles)) for m in (model, compiled)]
    for i in range(len(styles)):
        plain, fast = (runtime.record(m, run, character=i) for m, run in zip((model, compiled), runs, strict=True))
        apart = (plain.global_positions - fast.global_positions).norm(dim=-1).amax(-1)
        assert float(apart[59]) < 1e-3
        assert tk.metrics.speed(fast) == pytest.approx(tk.metrics.speed(plain), abs=0.01)
        assert tk.metrics.hips_height(fast) == pytest.approx(tk.metrics.hips_height(plain), abs=0.01)
        assert float((fast.root_positions[-1] - plain.root_positions[-1]).norm()) < 0.2


def test_published_parameters_run_alike(shared):
    model, bank = tk.published.load(shared / "lpn_film_100style")
    compiled = runtime.compile(model)
    styles = torch.stack([bank[name] for name in ("Neutral", "Zombie", "Aeroplane")])
    *_, plain = runtime.states(model, runtime.straight(1.2, 1.0), styles)
    *_, fast = runtime.states(compiled, runtime.straight(1.2, 1.0), styles)
    places = [runtime.world_joints(model.layout, state)["position"] for state in (plain, fast)]
    assert float((places[0] - places[1]).norm(dim=-1).max()) < 1e-3


def test_threads_share_characters(pretrained):
    model, compiled, bank = pretrained
    two = runtime.compile(model, threads=2)
    state = runtime.start(model, bank.vectors[:19])
    for command in commands(20, 19):
        one, other = (runtime.step(m, state, command) for m in (compiled, two))
        assert all(torch.allclose(getattr(one, name), getattr(other, name), atol=1e-4) for name in vars(one))
        assert torch.allclose(runtime.pose(compiled, one)[0], runtime.pose(two, one)[0], atol=1e-5)
        state = one
    assert "_pool" in vars(two)  # made when it is first used


def test_half_precision_halves_memory_and_says_its_error(pretrained):
    model, compiled, _ = pretrained
    half = runtime.compile(model, precision="bfloat16")
    assert half.weights.bytes < 0.55 * compiled.weights.bytes
    for count in (1, 13):
        assert 1e-5 < errors(model, half, count)[1] < 4e-3  # 5e-4 for styles that there are
        assert errors(model, compiled, count)[1] < 1e-5


def test_experts_of_little_weight_are_left_out(pretrained):
    """What is left is the plain network whose gates were cut, and sum to one again."""
    model, _, _ = pretrained
    skipping = runtime.compile(model, skip=0.05)
    x, phases, style = inputs(model, 21)
    gates = model.gating(model.normaliser("phases").apply(phases))
    kept = torch.where(gates < 0.05, 0.0, gates)
    assert float((kept == 0).float().mean()) > 0.2
    kept = kept / kept.sum(-1, keepdim=True)
    with torch.no_grad():
        h = model.experts(model.normaliser("inputs").apply(x), kept, lambda i, f, _: model.modulation(i, f, style))
    right = model.normaliser("outputs").invert(h)
    assert float(((skipping.predict(x, phases, style) - right) / model.outputs_std).abs().max()) < 1e-4


def test_one_line_makes_everything_fast(pretrained):
    model, compiled, bank = pretrained
    plain, fast = (runtime.rollout(m, runtime.straight(1.0, 0.5), bank["Zombie"]) for m in (model, compiled))
    assert float((plain.global_positions - fast.global_positions).norm(dim=-1).max()) < 1e-3
    controllers = [tk.view.Controller(m, bank) for m in (model, compiled)]
    for controller in controllers:
        controller.steer(ahead=1.0, turn=0.5)
        controller.advance(20)
    roots = [controller.state.root for controller in controllers]
    assert float((roots[0] - roots[1]).abs().max()) < 1e-3
    assert re.search(r"lpn-film, float32, 7\.\d MB, 1 thread; .* in \d+\.\d s", repr(compiled))


def test_bad_input_is_refused(pretrained, small_run):
    model, compiled, bank = pretrained
    other = tk.networks.build("mann-film", small_run.model.layout, 2, Sizes(hidden=16, gating=8), generator=False)
    with pytest.raises(ValueError, match="only lpn-film can be compiled, got mann-film"):
        runtime.compile(other)
    for option, value in (("precision", "int4"), ("skip", 0.2), ("threads", 0)):
        with pytest.raises(ValueError, match=f"{option} .*got {value!r}"):
            runtime.compile(model, **{option: value})
    state = runtime.start(model, bank.vectors[:3])
    with pytest.raises(ValueError, match="style needs"):
        runtime.step(compiled, state.with_style(torch.zeros(7)), Command())
    with pytest.raises(ValueError, match="joints needs"):
        runtime.step(compiled, dataclasses.replace(state, joints=state.joints[:, :-12]), Command())
    with pytest.raises(ValueError, match="phase needs"):
        runtime.step(compiled, dataclasses.replace(state, phase=state.phase[:1]), Command())
    with pytest.raises(ValueError, match="one pair of numbers or 3, got 2"):
        runtime.step(compiled, state, Command(torch.zeros(2, 2)))
    with pytest.raises(ValueError, match="x needs"):
        compiled.predict(*(value[:, :5] for value in inputs(model, 2)))


def test_crowds_cross_and_keep_apart(pretrained, tmp_path):
    _, compiled, bank = pretrained
    made = crowd.walk(compiled, bank, 12, 9.0)
    assert len({clip.style for clip in made.clips}) == 12
    roots = torch.stack([clip.root_positions[:, ::2] for clip in made.clips], 1)
    assert min(float((torch.cdist(at, at) + 9 * torch.eye(12)).min()) for at in roots) > 0.9
    through = (roots[-1] - roots[0])[torch.arange(12), torch.arange(1, 13) % 2]  # along the way of each
    assert float(through.min()) > 1.0  # a slow style, which others overtake
    assert float(through.median()) > 5.0
    picture = tk.view.crowd(made.clips[:3], tmp_path / "crowd.gif", fps=2.0, width=120)
    assert picture.stat().st_size > 1000
    assert "12 characters, 540 frames" in made.report
    with pytest.raises(ValueError, match="one length"):
        tk.view.crowd([made.clips[0], made.clips[1].cut(5)], tmp_path / "crowd.gif")
    with pytest.raises(ValueError, match=r"crowd\.svg"):
        tk.view.crowd(made.clips, tmp_path / "crowd.svg")


def test_the_bench_reports_floor_targets_and_equality(small_run, tmp_path, capsys):
    small_run.save(tmp_path / "run.safetensors")
    options = {"parameters": None, "characters": "1,3", "threads": "1,2", "rounds": 1, "peers": False, "styles": 2}
    bench.run(tmp_path / "run.safetensors", equality=False, plot=tmp_path / "cost.png", **options)
    said = capsys.readouterr().out
    assert len(re.findall(r"^floor +\d", said, re.M)) == 2
    assert len(re.findall(r": (met|MISSED)", said)) == 5
    assert len(re.findall(r"^ +3 characters", said, re.M)) == 2
    assert (tmp_path / "cost.png").stat().st_size > 1000
    bench.run(None, equality=True, plot=None, **options)
    assert "under 1 mm at frame 60: met" in capsys.readouterr().out
