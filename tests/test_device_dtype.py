"""Results have the device and the dtype of the inputs: no tensor is made on the CPU or in float32 by accident.

Three ways to see it. In float64 a new tensor must be told its device and must not be float32. On the
``meta`` device, where tensors have no numbers, one of the CPU is an error. Where there is a graphics card, all runs there.
"""

import contextlib
import dataclasses
import inspect

import pytest
import torch
from torch.overrides import TorchFunctionMode

import toolkit as tk
from toolkit import phases, runtime
from toolkit.evaluation import metrics
from toolkit.features import Layout
from toolkit.motion import contacts, ik, trajectory
from toolkit.motion import rotations as R
from toolkit.motion.clip import frame_reflections
from toolkit.motion.tensors import through_numpy
from toolkit.phases import coherent, sinusoids, sources, steps, windows
from toolkit.runtime import steering

FACTORIES = (torch.zeros, torch.ones, torch.empty, torch.full, torch.arange, torch.linspace, torch.logspace, torch.eye,
             torch.tensor, torch.rand, torch.randn, torch.fft.fftfreq, torch.fft.rfftfreq)
MODULES = (R, tk.motion.clip, tk.motion.skeleton, trajectory, contacts, ik, phases, windows, sources, coherent, sinusoids,
           tk.features.features, tk.features.layout, metrics, runtime.frame, steering)
AUTOMATIC = "hybrid", "contact", "contact-free", "velocity", "coherent", "learned"


class Strict(TorchFunctionMode):
    """Refuse new tensors that are not told their device, and such of float32."""

    def __torch_function__(self, func, types, args=(), kwargs=None):
        made = func(*args, **(kwargs or {}))
        if func in FACTORIES:
            assert (kwargs or {}).get("device") is not None, f"{func.__name__} without a device"
            assert made.dtype != torch.float32, f"{func.__name__} makes float32"
        return made


class Material:
    """What the cases take: a clip, a model after a few steps, and what is made of both."""

    def __init__(self, clip, run, device="cpu", dtype=torch.float64):
        self.skeleton, self.layout = clip.skeleton, Layout(clip.skeleton)
        _ = phases.named("learned"), clip.skeleton.facing_axis  # are kept
        self.clip = clip.to(device, dtype)
        self.q, self.root = self.clip.rotations, self.clip.root_positions
        self.v, self.turn = self.root, self.root[:, 0]
        self.on = (self.root[:, :2] > 0).to(dtype)  # contacts, of a kind
        self.curves = self.root - self.root.mean(0)
        self.frames = torch.arange(100, 110, device=device)
        self.points = self.clip.global_positions
        self.joints = self.points[:, list(clip.skeleton.feature_joints)]
        self.bank = tk.networks.bank.StyleBank(run.bank.names, run.bank.vectors.to(dtype))
        self.model = tk.networks.build("lpn-film", self.layout, 2, run.model.sizes).to(dtype)
        self.model.load_state_dict(run.model.state_dict())
        self.model = self.model.to(device)
        self.state = runtime.start(self.model, run.bank["Zombie"].expand(3, -1))  # which is float32, on the CPU
        self.command = runtime.Command((0.0, 1.0), (1.0, 0.0))


LIMITED = {"phases.extract learned"}  # its network is float32 on the CPU
META = {  # what runs on any device, numbers or not
    "rotations.identity": lambda m: R.identity(3, dtype=m.q.dtype, device=m.q.device),
    "rotations.normalize": lambda m: R.normalize(m.v),
    "rotations.multiply": lambda m: R.multiply(m.q, m.q),
    "rotations.multiply_parts": lambda m: R.multiply_parts(m.q.unbind(-1), m.q.unbind(-1)),
    "rotations.inverse": lambda m: R.inverse(m.q),
    "rotations.rotate": lambda m: R.rotate(m.q[:, 0], m.v),
    "rotations.rotate_parts": lambda m: R.rotate_parts(m.q[:, 0].unbind(-1), m.v.unbind(-1)),
    "rotations.from_axis_angle": lambda m: R.from_axis_angle(R.normalize(m.v), m.turn),
    "rotations.yaw": lambda m: R.yaw(m.turn),
    "rotations.between": lambda m: (R.between(m.v, m.v.flip(-1)), R.between(m.v[0], m.v[1])),
    "rotations.least_axis": lambda m: (R.least_axis(m.v), R.least_axis(m.v[0])),
    "rotations.to_matrix": lambda m: R.to_matrix(m.q),
    "rotations.from_matrix": lambda m: R.from_matrix(R.to_matrix(m.q)),
    "rotations.to_forward_up": lambda m: R.to_forward_up(m.q),
    "rotations.from_forward_up": lambda m: R.from_forward_up(*R.to_forward_up(m.q)),
    "rotations.from_euler": lambda m: R.from_euler(m.v, "YXZ"),
    "rotations.to_euler": lambda m: R.to_euler(m.q, "YXZ"),
    "rotations.slerp": lambda m: (R.slerp(m.q[:-1], m.q[1:], 0.3), R.slerp(m.q[0], m.q[1], m.turn[: m.q.shape[1]])),
    "rotations.unroll": lambda m: R.unroll(m.q),
    "skeleton.forward_kinematics": lambda m: tk.motion.forward_kinematics(m.skeleton, m.q, m.root),
    "skeleton.local_rotations": lambda m: tk.motion.local_rotations(m.skeleton, m.clip.global_rotations),
    "clip.root_frames": lambda m: tk.motion.root_frames(m.clip),
    "clip.RootFrames": lambda m: (tk.motion.root_frames(m.clip).to_local(m.points),
                                  tk.motion.root_frames(m.clip).turn_to_local(m.points)),
    "clip.Clip": lambda m: (m.clip[10:20], m.clip.cut(10, 20), m.clip.without_ends(), m.clip.mirrored(),
                            m.clip.moved(0.3, (1.0, 0.0, 2.0)), m.clip.replace(fps=30.0), m.clip.resample(m.clip.fps)),
    "clip.frame_reflections": lambda m: frame_reflections(m.skeleton, R.to_matrix(m.q).mean(0)),
    "trajectory.heading": lambda m: trajectory.heading(m.q),
    "contacts.detect": lambda m: (contacts.detect(m.clip), contacts.detect(m.clip, floor=0.02)),
    "contacts.floor_height": lambda m: contacts.floor_height(m.clip),
    "contacts.line": lambda m: contacts.line(m.points[:, 0, 1], 30, 0.0),
    "contacts.standing_range": lambda m: contacts.standing_range(m.points[:, :2, 1], m.on > 0.5),
    "contacts.standing_height": lambda m: contacts.standing_height(m.clip),
    "contacts.toes_of": lambda m: contacts.toes_of(m.clip),
    "contacts.velocities": lambda m: (contacts.velocities(m.points, 60.0), contacts.velocities(m.points[:1], 60.0)),
    "ik.two_bone": lambda m: (ik.two_bone(m.v, m.v + 0.1, m.v.flip(-1), m.v - 0.2),
                              ik.two_bone(m.v, m.v + 0.1, m.v.flip(-1), m.v - 0.2, m.v, soft=0.02)),
    "ik.foot_lock": lambda m: ik.foot_lock(m.points[:, :2], m.points[:, :2, :2], m.points[:, 2:4], m.points[:, 4:6], m.on,
                                           m.v[:, :2], 1 / 60),
    "ik.sink": lambda m: ik.sink(m.points[:, 0, :2], m.points[:, :2], m.points[:, 2:4], m.points[:, :2, 1], m.on, 1 / 60),
    "ik.solve_legs": lambda m: ik.solve_legs(m.skeleton, lambda j: m.q[:, j], m.root, m.points[:, :2], m.on,
                                          m.points[:, 0, :2], 1 / 60),
    "ik.plant_feet": lambda m: ik.plant_feet(m.skeleton, m.q, m.root, m.points[:, :2]),
    "ik.turn_arms": lambda m: ik.turn_arms(m.skeleton, m.q, m.root, m.points + 0.01),
    "windows.normalise": lambda m: windows.normalise(m.curves, 60.0),
    "windows.speed": lambda m: windows.speed(m.root, 60.0),
    "windows.mean": lambda m: windows.mean(m.curves, 0.5, 60.0),
    "sources.local_positions": lambda m: [phases.local_positions(m.clip, limb) for limb in phases.LIMBS],
    "coherent.wavelets": lambda m: coherent.wavelets(m.curves, 60.0, 2.5).abs(),
    "windows.regression": lambda m: windows.regression(m.turn, m.turn.sin(), 0.5, 60.0),
    "features.joint_features": lambda m: tk.features.joint_features(m.clip, tk.motion.root_frames(m.clip)),
    "features.moments": lambda m: tk.features.moments(m.root)[1:],
    "features.mean_velocity": lambda m: tk.features.mean_velocity(
        tk.features.joint_features(m.clip, tk.motion.root_frames(m.clip))[None, :240]),
    "features.Normaliser": lambda m: (n := tk.features.Normaliser.of(m.root), n.invert(n.apply(m.root))),
    "layout.pack_joints": lambda m: tk.features.pack_joints(*[m.points] * 4),
    "layout.split_joints": lambda m: tk.features.split_joints(tk.features.pack_joints(*[m.points] * 4)),
    "metrics.on_feet": lambda m: metrics.on_feet(m.skeleton, m.points[..., 1]),
    "metrics.posture": lambda m: metrics.posture(m.layout, m.joints),
    "metrics.hand_swing": lambda m: metrics.hand_swing(m.layout, m.joints),
    "metrics.phase_error": lambda m: metrics.phase_error(m.points[..., 0], m.points[..., 1]),
    "frame.start": lambda m: (runtime.start(m.model, m.bank["Zombie"]), runtime.start(
        m.model, m.bank.vectors, position=[[1, 2], [3, 4]], facing=m.root[0, :2].abs() + 1)),
    "state.CharacterState": lambda m: (m.state.with_style(m.bank["Neutral"]), m.state.root),
    "frame.step": lambda m: runtime.step(m.model, m.state, m.command),
    "frame.pose": lambda m: runtime.pose(m.model, m.state),
    "frame.predicted": lambda m: runtime.frame.predicted(m.model, m.state, m.command),
    "frame.planted": lambda m: runtime.frame.planted(m.model.layout, m.state, m.state),
    "frame.predicted_toes": lambda m: runtime.frame.predicted_toes(m.model.layout, m.state),
    "frame.world_joints": lambda m: runtime.world_joints(m.model.layout, m.state),
    "frame.states": lambda m: list(runtime.states(m.model, [m.command] * 3, m.bank["Zombie"])),
    "frame.record": lambda m: runtime.record(m.model, iter([m.state, m.state])),
    "frame.rollout": lambda m: runtime.rollout(m.model, runtime.straight(1.0, 0.1), m.bank["Zombie"]),
    "steering.steer": lambda m: (runtime.steer(m.state, m.command),
                                 runtime.steer(m.state, runtime.Command(m.state.velocity.cpu() if m.state.velocity.is_cuda
                                                                        else m.state.velocity, [0, 1]))),
    "steering.speed_controller": lambda m: runtime.speed_controller(m.state, m.state.velocity),
    "steering.follow": lambda m: [runtime.follow([(0, 0), (0, 3)], seconds=0.1)[5](m.state).velocity],
    "steering.towards": lambda m: steering.towards(m.state, torch.tensor([1.0, 2.0], dtype=torch.float64,
                                                                           device=m.root.device), (0, 1), 1.0).velocity,
    "steering.unit": lambda m: steering.unit(m.v),
    "steering.turn": lambda m: steering.turn(m.v[:, :2], m.v[:, 1:], 0.3),
}
NUMBERS = {  # what looks at numbers, or goes through scipy and numba
    "clip.Clip resample": lambda m: (m.clip.resample(30.0), m.clip.to(m.clip.rotations.device)),
    "rotations.slerp list": lambda m: R.slerp(m.q[0, 0], m.q[1, 0], [0.0, 0.5]),
    "ik.two_bone soft": lambda m: ik.two_bone(m.v, m.v + 0.1, m.v.flip(-1), m.v - 0.2, soft=[0.02]),
    "tensors.through_numpy": lambda m: through_numpy(lambda values: values[::-1], m.root),
    "trajectory.sample": lambda m: trajectory.sample(tk.motion.root_frames(m.clip), m.frames),
    **{f"phases.extract {source}": lambda m, source=source: phases.extract(m.clip, source) for source in AUTOMATIC},
    "phases.extract_group": lambda m: phases.extract_group([m.clip, m.clip[:200]], lambda clip, limb: m.turn[: len(clip)]),
    "phases.named": lambda m: phases.named("velocity").fitted([m.clip]),
    "sources.curves": lambda m: phases.curves(m.clip, lambda clip, limb: m.turn.tolist()),
    "windows.half_window": lambda m: windows.half_window(m.turn, 60.0),
    "windows.smooth": lambda m: windows.smooth(m.curves, 60.0),
    "sinusoids.fit": lambda m: phases.fit(m.curves, 60.0),
    "sinusoids.frequencies": lambda m: sinusoids.frequencies(1.0),
    "coherent.ridge": lambda m: coherent.ridge(m.points[..., 0].abs().T, 6, 0.5),
    "steps.signal": lambda m: steps.signal((torch.sin(20 * m.root[:, 2]) > 0).to(m.q)).real,
    "steps.Steps": lambda m: [steps.Steps()(m.clip, limb) for limb in phases.LIMBS],
    "sinusoids.along": lambda m: list(vars(sinusoids.along(torch.exp(1j * m.turn), m.turn.sin(), 60.0, 0.5)).values()),
    "coherent.denoised": lambda m: coherent.denoised(torch.complex(m.root, m.root.flip(-1)), 1).real,
    "features.own_features": lambda m: tk.features.own_features(m.clip, phases.extract(m.clip)),
    "features.frames": lambda m: tk.features.frames(m.clip),
    "features.build": lambda m: tk.features.build(m.clip, mirror=True),
    "features.style_rows": lambda m: tk.features.build(m.clip.cut(0, 200)),
    "features.group_features": lambda m: list(tk.features.group_features([(0, m.clip)], "hybrid", False, "raise")),
    "features.usable": lambda m: tk.features.usable(300, m.root.device),
    "features.clip_starts": lambda m: tk.features.clip_starts(300, m.root.device),
    "features.Rows": lambda m: tk.features.Rows(lambda at: m.root[at], m.frames)[2:4],
    "features.Features": lambda m: tk.features.build([m.clip]).normalisers(),
    "metrics.feet": lambda m: (metrics.feet(m.clip), metrics.feet(m.clip, m.on.tolist())),
    "metrics.foot_skate": lambda m: (metrics.foot_skate(m.clip), metrics.foot_skate(m.clip, m.on.tolist())),
    "metrics.step_rate": lambda m: metrics.step_rate(m.on, 60.0),
    "metrics.speed": lambda m: metrics.speed(m.clip),
    "metrics.hips_height": lambda m: metrics.hips_height(m.clip),
    "metrics.upright": lambda m: metrics.upright(m.clip),
    "metrics.path_error": lambda m: metrics.path_error(m.clip, [(0, 0), (0, 3)]),
    "metrics.frechet_distance": lambda m: metrics.frechet_distance(m.root, m.root + 1),
    "steering.straight": lambda m: runtime.straight(1.0, 0.1),
}
CASES = META | NUMBERS
#: No tensors, or always the CPU's.
ELSEWHERE = {"clip.on_cpu", "contacts.check_height", "features.check_style",
             "features.check_style_clips", "features.natural_speed"}


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
    assert {t.device.type for t in found} <= {device}
    assert {t.dtype for t in found if t.is_floating_point()} <= {dtype}


@pytest.fixture(scope="module")
def double(walk_clip, small_run):
    return Material(walk_clip, small_run)


@pytest.fixture(scope="module")
def meta(walk_clip, small_run):
    return Material(walk_clip, small_run, "meta")


@pytest.mark.parametrize("name", CASES)
def test_float64_stays_float64_and_every_new_tensor_is_told_its_device(name, double):
    with contextlib.nullcontext() if name in LIMITED else Strict():
        found = tensors(CASES[name](double))
    check(found, "cpu", torch.float64)
    assert all(bool(t.isfinite().all()) for t in found if t.is_floating_point())


@pytest.mark.parametrize("name", META)
def test_the_meta_device_meets_no_tensor_of_the_cpu(name, meta):
    check(tensors(META[name](meta)), "meta", torch.float64)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.skipif(not torch.cuda.is_available(), reason="no graphics card")
def test_a_graphics_card_keeps_what_it_is_given(name, walk_clip, small_run):
    check(tensors(CASES[name](Material(walk_clip, small_run, "cuda", torch.float32))), "cuda", torch.float32)


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_no_public_function_is_left_out(module):
    short = module.__name__.split(".")[-1]
    public = {f"{short}.{name}" for name, f in vars(module).items() if not name.startswith("_")
              and inspect.isfunction(inspect.unwrap(f)) and f.__module__ == module.__name__}
    assert public - ELSEWHERE <= {name.split()[0] for name in CASES}


@pytest.mark.parametrize("name", ["phases.extract hybrid", "features.frames", "frame.rollout", "contacts.detect"])
def test_float32_and_float64_say_the_same(name, double, walk_clip, small_run):
    single = Material(walk_clip, small_run, "cpu", torch.float32)
    for a, b in zip(tensors(CASES[name](single)), tensors(CASES[name](double)), strict=True):
        assert a.dtype == torch.float32 or not a.is_floating_point()
        near = (a - b).abs() < 1e-2
        assert float(near.float().mean()) > 0.99


def test_networks_of_float32_take_motion_of_float64(walk_clip, small_run):
    clips = [walk_clip.to(torch.float64), walk_clip.to(torch.float64).replace(style="Zombie")]
    data = tk.features.build(clips)
    run = tk.training.fit(data, tk.training.Config.quick(steps=2, sizes=small_run.config.sizes))
    made = tk.styles.fine_tune(small_run.model, clips[0], "Mine", small_run.bank, steps=2)
    found = tk.evaluation.recognition.train(data, steps=2).of_clip(clips[0])
    check([*run.model.state_dict().values(), run.bank.vectors, made.bank.vectors, found], "cpu", torch.float32)
    known, same = (tk.published.one_step(*small_run, clip, "Neutral") for clip in (walk_clip, clips[0]))
    assert same["joint_mse"] == pytest.approx(known["joint_mse"], rel=1e-3)


def test_files_and_pictures_of_float64_motion_are_those_of_float32(walk_clip, tmp_path):
    double, short = walk_clip.to(torch.float64), walk_clip[:20]
    assert tk.motion.on_cpu(short)[0] is short
    assert tk.motion.on_cpu([double, short])[0].rotations.equal(walk_clip.rotations)
    for name in ("a.glb", "a.html", "a.png"):
        for clip, folder in ((short, tmp_path / "single"), (double[:20], tmp_path / "double")):
            tk.export.write(clip, folder / name)
        assert (tmp_path / "single" / name).read_bytes() == (tmp_path / "double" / name).read_bytes(), name
    assert tk.stylization.data.prepare(double).rotations.dtype == torch.float32


def test_a_gradient_is_not_lost_on_the_way_through_scipy(walk_clip):
    clip = walk_clip.replace(root_positions=walk_clip.root_positions.clone().requires_grad_())
    clip.moved(0.3).global_positions.sum().backward()
    assert float(clip.root_positions.grad.abs().min()) > 0
    with pytest.raises(RuntimeError, match="requires grad"):
        clip.resample(30.0)
