"""Results have the device and the dtype of the inputs: no tensor is made elsewhere by accident.

In float64 a new tensor must be told its device and must not be float32. On the ``meta`` device,
where tensors have no numbers, a tensor of the CPU is an error. A graphics card runs all of it.
"""

import dataclasses

import pytest
import torch
from torch.overrides import TorchFunctionMode

import toolkit as tk
from toolkit import phases, runtime
from toolkit.evaluation import metrics
from toolkit.features import Layout
from toolkit.motion import contacts, ik, rotations as R, trajectory

FACTORIES = (torch.zeros, torch.ones, torch.empty, torch.full, torch.arange, torch.linspace,
             torch.logspace, torch.eye, torch.tensor, torch.rand, torch.randn, torch.fft.fftfreq,
             torch.fft.rfftfreq)


class Strict(TorchFunctionMode):
    """Refuse new tensors that are not told their device, and such of float32."""

    def __torch_function__(self, func, types, args=(), kwargs=None):
        made = func(*args, **(kwargs or {}))
        if func in FACTORIES:
            assert (kwargs or {}).get("device") is not None, f"{func.__name__} without a device"
            assert made.dtype != torch.float32, f"{func.__name__} makes float32"
        return made


class Material:
    """A clip, a model after a few steps, and a state, on a device and in a dtype."""

    def __init__(self, clip, run, device="cpu", dtype=torch.float64):
        _ = clip.skeleton.facing_axis  # is kept
        self.clip = clip.to(device, dtype)
        self.style = run.bank["Zombie"].to(dtype)
        layout = Layout(clip.skeleton)
        self.model = tk.networks.build("lpn-film", layout, 2, run.model.sizes).to(dtype)
        self.model.load_state_dict(run.model.state_dict())
        self.model = self.model.to(device)
        self.state = runtime.start(self.model, run.bank["Zombie"].expand(3, -1))  # float32, CPU


def motion(m: Material) -> list:
    clip, q, v = m.clip, m.clip.rotations, m.clip.root_positions
    skeleton, toes = clip.skeleton, clip.global_positions[:, :2]
    frames = tk.motion.root_frames(clip)
    flags = (v[:, :2] > 0).to(v.dtype)
    return [
        R.identity(3, dtype=q.dtype, device=q.device), R.yaw(v[:, 0]),
        R.from_matrix(R.to_matrix(q)), R.from_forward_up(*R.to_forward_up(q)),
        R.from_euler(R.to_euler(q, "YXZ"), "YXZ"), R.slerp(q[:-1], q[1:], 0.3), R.unroll(q),
        R.between(v, v.flip(-1)), R.from_axis_angle(R.normalize(v), v[:, 0]),
        clip.cut(10, 20), clip.mirrored(), clip.moved(0.3, (1.0, 0.0, 2.0)), frames,
        trajectory.heading(q), contacts.detect(clip), contacts.standing_height(clip),
        contacts.velocities(toes, 60.0), ik.two_bone(v, v + 0.1, v.flip(-1), v - 0.2, soft=0.02),
        ik.plant_feet(skeleton, q, v, toes), ik.turn_arms(skeleton, q, v, clip.global_positions),
        ik.foot_lock(toes, toes, toes + 0.1, toes, flags, flags, v[:, :2], 0.02, flags, 1 / 60),
        tk.features.joint_features(clip, frames), phases.local_positions(clip, phases.LIMBS[0]),
    ]


def walking(m: Material) -> list:
    command = runtime.Command((0.0, 1.0), (1.0, 0.0))
    ways = [command]
    return [
        runtime.start(m.model, m.style, position=[1, 2]), runtime.step(m.model, m.state, command),
        runtime.pose(m.model, m.state), runtime.record(m.model, [m.state, m.state]),
        list(runtime.states(m.model, ways, m.style)), runtime.rollout(m.model, ways, m.style),
        runtime.follow([(0, 0), (0, 3)], seconds=0.1)[5](m.state).velocity,
    ]


def numbers(m: Material) -> list:
    """What looks at numbers, or goes through scipy and numba."""
    built = tk.features.build(m.clip, mirror=True)
    frames = torch.arange(100, 110, device=m.clip.root_positions.device)
    return [
        m.clip.resample(30.0), [phases.extract(m.clip, s) for s in ("hybrid", "contact-free")],
        phases.extract(m.clip, "contact"), built.inputs, built.clips, built.normalisers(),
        metrics.feet(m.clip), metrics.path_error(m.clip, [(0, 0), (0, 3)]),
        trajectory.sample(tk.motion.root_frames(m.clip), frames),
    ]


def tensors(value) -> list[torch.Tensor]:
    """All tensors in a result; of a clip without those of its skeleton."""
    if isinstance(value, torch.Tensor):
        return [value]
    if isinstance(value, tk.Clip):
        return [value.rotations, value.root_positions, value.global_positions]
    if dataclasses.is_dataclass(value):
        value = [] if isinstance(value, Layout) else list(vars(value).values())
    if isinstance(value, dict):
        value = list(value.values())
    return [t for part in value for t in tensors(part)] if isinstance(value, list | tuple) else []


def check(found: list[torch.Tensor], device: str, dtype: torch.dtype) -> None:
    assert len(found) > 10
    assert {t.device.type for t in found} <= {device}
    assert {t.dtype for t in found if t.is_floating_point()} == {dtype}


@pytest.mark.parametrize("work", [motion, walking, numbers])
def test_float64_stays_float64_and_every_new_tensor_is_told_its_device(work, walk_clip, small_run):
    material = Material(walk_clip, small_run)
    with Strict():
        found = tensors(work(material))
    check(found, "cpu", torch.float64)
    assert all(bool(t.isfinite().all()) for t in found if t.is_floating_point())


@pytest.mark.parametrize("work", [motion, walking])
def test_the_meta_device_meets_no_tensor_of_the_cpu(work, walk_clip, small_run):
    check(tensors(work(Material(walk_clip, small_run, "meta"))), "meta", torch.float64)


def test_networks_of_float32_take_motion_of_float64(walk_clip, small_run):
    double = walk_clip.to(torch.float64)
    data = tk.features.build([double, double.replace(style="Zombie")])
    run = tk.training.fit(data, tk.training.Config.quick(steps=2, sizes=small_run.config.sizes))
    made = *run.model.state_dict().values(), run.bank.vectors
    assert {v.dtype for v in made} == {torch.float32}
    known, same = (tk.published.one_step(*small_run, c, "Neutral") for c in (walk_clip, double))
    assert same["joint_mse"] == pytest.approx(known["joint_mse"], rel=1e-3)


if torch.cuda.is_available():

    @pytest.mark.parametrize("work", [motion, walking, numbers])
    def test_a_graphics_card_keeps_what_it_is_given(work, walk_clip, small_run):
        material = Material(walk_clip, small_run, "cuda", torch.float32)
        check(tensors(work(material)), "cuda", torch.float32)
