"""The compiled runtime against the plain one, which is its definition."""

import copy
import dataclasses

import numba
import pytest
import torch
import unchanged
from numba.core.caching import IndexDataCacheFile
from refusal import refusal
from torch.testing import assert_close

import toolkit as tk
from toolkit import runtime
from toolkit.extra.compiled import network
from toolkit.io import compilation
from toolkit.networks import Sizes
from toolkit.runtime import Command


@pytest.fixture(scope="module")
def pretrained():
    model, bank = tk.pretrained()
    return model, runtime.compile(model), bank


@pytest.fixture(scope="module")
def small(pretrained):
    """A model of two styles, untrained."""
    sizes = Sizes(hidden=16, experts=3, gating=8)
    return tk.networks.build("lpn-film", pretrained[0].layout, 2, sizes)


def inputs(model, count):
    """Frames, phases and style vectors of ``count`` characters, all different."""
    seeded = torch.Generator().manual_seed(0)
    kinds = map(model.normaliser, ("inputs", "phases"))
    x, phases = (n.invert(torch.randn(count, len(n.mean), generator=seeded)) for n in kinds)
    return x, phases, 1 + 0.3 * torch.randn(count, model.style_size, generator=seeded)


def commands(frames, count):
    """Another way for every character, which turns."""
    angles = torch.arange(count) + torch.linspace(0.0, 2.0, frames)[:, None]
    ways = torch.stack((angles.sin(), angles.cos()), -1)
    return [Command(1.2 * way, way) for way in ways]


@pytest.mark.parametrize("sizes", [Sizes(hidden=42, experts=3, gating=7), Sizes(hidden=96)])
def test_the_network_is_the_models_for_any_size_and_number_of_characters(pretrained, sizes):
    """Widths that need padding and those that do not; 131 is more than are computed at once."""
    torch.manual_seed(1)
    model = tk.networks.build("lpn-film", pretrained[0].layout, 2, sizes, generator=False)
    with torch.no_grad():
        for layer in model.experts.layers:
            layer.bias.normal_()
    compiled = runtime.compile(model)
    for count in (1, 2, 7, 131):
        given = inputs(model, count)
        z = torch.empty(count, model.layout.n_outputs)
        network.predict(*(value.numpy() for value in given), compiled.weights, z.numpy())
        apart = (z - model.predict(*given)) / model.outputs_std
        assert apart.abs().max() < 1e-4


def drawn(state):
    """The state with numbers at random, in all that steers it and its feet."""
    def some(*shape, scale=1.0):
        return scale * torch.randn(len(state.joints), *shape, generator=seeded)

    def apart(*values):  # one of these for each character, in turn
        return torch.tensor(values)[torch.arange(len(state.joints)) % len(values)][:, None]

    seeded = torch.Generator().manual_seed(3)
    look = torch.nn.functional.normalize(some(2), dim=-1)
    history = state.history.clone()
    pace = apart(0.0, 0.001, 0.01, 0.03) + some(2, scale=0.002)
    history[..., :2] += pace[:, None] * torch.linspace(-60.0, 0.0, 61)[:, None]
    history[:, -20:, :2] += some(20, 2, scale=0.002)
    future = state.future + some(*state.future.shape[1:], scale=0.1)
    future[..., 2:] = torch.nn.functional.normalize(future[..., 2:], dim=-1)
    return dataclasses.replace(
        state, history=history, future=future,
        velocity=apart(0.0, 0.02, 0.08, 0.2, 1.0, 3.0) * look,
        asked=some(2, scale=0.5), drive=apart(0.0, 0.1, 1.0, 5.0, 9.9), facing=look,
        aside=apart(-0.99, 0.0, 0.2), rest=apart(0.0, 0.03, 0.5, 0.97, 1.0, 1.0, 1.0),
        contacts=(0.5 + some(2)).clamp(0.0, 1.0), drop=some(2, scale=0.03),
        toes=state.toes + apart(0.05, 0.05, 0.5)[..., None] * some(2, 3),
        drift=some(2, 3, scale=0.2), swivel=some(2, scale=0.2),
        phase=state.phase * (1 + some(1, scale=0.3)),
        joints=state.joints + some(state.joints.shape[1], scale=0.1))


@pytest.mark.parametrize("lift", [1.0, 1.2])
def test_any_state_steps_alike_and_as_it_did(lift):
    model, bank = tk.pretrained()
    model.lift = lift
    styles = bank.vectors[torch.arange(120) % len(bank)]
    *_, state = runtime.states(model, commands(30, 120), styles)
    state = drawn(state)
    before = {name: value.clone() for name, value in vars(state).items()}
    orders = torch.stack((state.facing[:, 1], state.facing[:, 0]), -1)
    looks = orders * (torch.arange(120) % 7 > 0)[:, None]  # some keep their facing
    orders = Command(orders * torch.tensor([0.0, 0.05, 0.2, 1.2, 4.0]).repeat(24)[:, None], looks)
    with torch.inference_mode():
        plain = runtime.step(model, state, orders)
    compiled = runtime.compile(model)
    fast = runtime.step(compiled, state, orders)
    assert_close(vars(fast), vars(plain), atol=2e-4, rtol=0)
    assert_close(vars(state), before, atol=0, rtol=0)  # the state itself stays
    for name, value in vars(plain).items():
        unchanged.check(f"a step from anywhere, lift {lift}: {name}", value, near=1e-4)
    for chosen in ({"feet": False}, {"arms": False}, {}):
        right, made = (runtime.pose(runs, plain, **chosen) for runs in (model, compiled))
        assert_close(made, right, atol=1e-3, rtol=0)
    unchanged.check(f"a pose from anywhere, lift {lift}", right, near=1e-4)


def test_legs_and_arms_out_of_reach_bend_alike(pretrained):
    """Toes far away and too near, a pose turned upside down."""
    model, compiled, bank = pretrained
    state = runtime.start(model, bank.vectors[:4], facing=(0.6, -0.8))
    joints = state.joints.clone()
    joints[3].view(-1, 4, 3)[:, :3] *= torch.tensor([1.0, -1.0, -1.0])
    shifts = torch.tensor([[0.0, 0.0, 2.0], [0.0, 0.9, 0.0], [0.1, 0.0, 0.0], [0.0, 0.0, 0.0]])
    state = dataclasses.replace(state, joints=joints, toes=state.toes + shifts[:, None])
    skeleton = model.layout.skeleton
    poses = [runtime.pose(m, state) for m in (model, compiled)]
    places = [tk.motion.forward_kinematics(skeleton, *pose)[1] for pose in poses]
    assert (places[0] - places[1]).norm(dim=-1).max() < 1e-3


def test_roll_gives_the_same_bits(pretrained):
    model, compiled, bank = pretrained
    first, vector = runtime.start(model, bank["Old"]), bank["Old"]
    rolled = compiled.roll(first, 4, lambda k, place: ((0.1 * k, 1.0), (place[1], 1.0), vector))
    state = first
    for k in range(4):
        looks = float(state.root[0, 1]), 1.0
        state = runtime.step(compiled, state, Command((0.1 * k, 1.0), looks))
        assert torch.equal(rolled.joints[k], state.joints[0])


def test_bad_input_is_refused(pretrained, small):
    model, compiled, bank = pretrained
    calibrated = copy.deepcopy(small)
    calibrated.calibrated = True
    with refusal("calibrated model cannot be compiled"):
        runtime.compile(calibrated)
    state = runtime.start(model, bank.vectors[:3])
    for wrong, part in (
        (state.with_style(torch.zeros(7)), "style"),
        (dataclasses.replace(state, joints=state.joints[:, :-12]), "joints"),
        (dataclasses.replace(state, phase=state.phase[:1]), "phase"),
    ):
        with refusal(f"{part} needs"):
            runtime.step(compiled, wrong, Command())
    with refusal("one pair of numbers or 3, got 2"):
        runtime.step(compiled, state, Command(torch.zeros(2, 2)))
    one = runtime.start(model, bank["Old"])
    with refusal(r"a style needs \d+ columns"):
        compiled.roll(one, 1, lambda *_: ((0.0, 0.0), (0.0, 1.0), torch.zeros(3)))
    with refusal("is a compiled one already"):
        runtime.compile(compiled)


def add(a, b):
    return a + b


def test_where_compiled_code_cannot_be_stored_there_is_no_error(monkeypatch):
    """As in a container where nothing can be written, and on a disk that is full."""
    compilation._without_cache.cache_clear()
    with monkeypatch.context() as patch:
        patch.setattr(compilation, "Cache", lambda _: raised(RuntimeError("no locator available")))
        with pytest.warns(UserWarning, match="NUMBA_CACHE_DIR"):
            made = compilation.compiled()(add)
    assert made(1, 2) == 3
    assert not runtime.compiled._kept(made)
    monkeypatch.setattr(IndexDataCacheFile, "save", lambda *_: raised(PermissionError("full")))
    assert compilation.compiled()(add)(1, 2) == 3


@pytest.mark.parametrize("damage", [b"", b"cmath\nnone\n."])  # no pickle, and one of what is not
@pytest.mark.parametrize("suffix", [".nbi", ".nbc"])
def test_damaged_compiled_code_is_compiled_again_and_stored(damage, suffix, tmp_path, monkeypatch):
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    assert compilation.compiled()(add)(1, 2) == 3
    (path,) = tmp_path.rglob(f"*{suffix}")
    path.write_bytes(damage)
    for hits in (0, 1):
        made = compilation.compiled()(add)
        assert made(1, 2) == 3
        assert len(made.stats.cache_hits) == hits


def raised(error):
    raise error


@pytest.mark.parametrize(("kept", "frames", "compiles", "words"), [
    (False, 1499, False, 0), (False, 1500, True, 1), (True, 119, False, 0), (True, 120, True, 0),
])
def test_long_work_is_compiled_with_a_word(small, monkeypatch, kept, frames, compiles, words):
    said, made = [], object()
    monkeypatch.setattr("toolkit.extra.compiled._kept", lambda kernel: kept)
    monkeypatch.setattr("toolkit.extra.compiled.CompiledModel", lambda model: made)
    found = tk.runtime.quick(small, frames, said.append)
    assert found is (made if compiles else small)
    assert len(said) == words
    other = tk.networks.build("pfnn-film", small.layout, 2, small.sizes)
    assert tk.runtime.quick(other, 10_000) is other


def test_the_kernels_on_the_disk_are_found(pretrained):
    compiled = tk.runtime.compiled
    assert all(map(compiled._kept, compiled.KERNELS))
