import asyncio

import numpy as np
import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.view.widgets import controller as module
from toolkit.view.widgets.controller import Controller


@pytest.fixture
def control(fast):
    made = Controller(*fast)
    made.sent = []
    made.send = lambda content, buffers: made.sent.append((content, buffers[0]))
    yield made
    made.close()


def hand(control, **wish):
    blank = {"kind": "input", "id": 1, "move": [0, 0], "turn": 0, "run": False, "heading": None}
    control._receive(control, blank | wish, [])


def test_keys_go_ahead_sideways_and_round(control):
    hand(control, move=[0, 1])
    control.advance(90)
    x, z, _, ahead = control.state.root[0].tolist()
    assert z > 0.6 > 2 * abs(x)
    assert ahead > 0.9
    hand(control, move=[0, 1], turn=1)
    control.advance(45)
    assert control.state.root[0, 2] > 0.5  # looking left, +x
    hand(control, move=[-1, 0])  # to its left
    facing, place = control.state.facing[0].clone(), control.state.root[0, :2].clone()
    control.advance(60)
    left = torch.tensor([facing[1], -facing[0]])
    assert float((control.state.root[0, :2] - place) @ left) > 0.15


def test_the_stick_points_in_the_world_and_shift_runs(control):
    for run, least, most in ((False, 0.5, 1.5), (True, 1.5, 3.3)):
        hand(control, heading=[1.0, 0.0], run=run)
        control.advance(150)
        history = control.state.history[0]
        speed = (history[-1, :2] - history[0, :2]).tolist()
        assert least < speed[0] < most, f"run {run}: {speed}"
        assert abs(speed[1]) < 0.3


def test_the_speed_is_that_of_the_blend_until_another_is_set(fast):
    model, bank = fast
    control = Controller(model, bank)
    control.blend = {"Zombie": 0.5, "Neutral": 0.5}
    assert control.speed == pytest.approx((bank.speed("Zombie") + bank.speed("Neutral")) / 2)
    control.speed = 1.7
    control.blend = {"Zombie": 1}
    assert control.speed == 1.7


def test_the_marker_changes_the_style_smoothly(control, fast):
    control.blend = {"Zombie": 3, "Old": 1}
    assert control.names == ["Zombie", "Old", "Neutral"]
    assert control.blend == {"Zombie": 0.75, "Old": 0.25, "Neutral": 0.0}
    target = fast[1].blend({"Zombie": 0.75, "Old": 0.25})
    far = [float((control.state.style[0] - target).norm())]
    for frames in (1, 80):
        control.advance(frames)
        far.append(float((control.state.style[0] - target).norm()))
    assert 0.7 * far[0] < far[1] < far[0]
    assert far[2] < 1e-3 * far[0]
    control.names = ["Zombie"] * 3
    assert control.blend == {"Zombie": pytest.approx(1.0)}


def test_feet_and_arms_are_switched_apart(control):
    hand(control, move=[0, 1])
    control.advance(60)
    skeleton = control._model.layout.skeleton
    arm, leg = (skeleton.index(f"left_{part}") for part in ("elbow", "knee"))
    poses = {}
    for control.feet, control.arms in ((False, False), (True, False), (False, True)):
        state = control.state
        control.advance(1)
        numbers = np.frombuffer(control.sent[-1][1], np.float32)[3 : 3 + 4 * len(skeleton)]
        poses[control.feet, control.arms] = numbers.reshape(-1, 4)
        control.state = state
    plain, feet, arms = poses.values()
    assert np.allclose(arms[leg], plain[leg], atol=1e-6)
    assert np.allclose(feet[arm], plain[arm], atol=1e-6)
    assert np.abs(feet - plain).max() > 1e-3
    assert np.abs(arms - plain).max() > 1e-3


def test_a_model_without_phases_walks_too(small_run):
    """The frame's end is as long as the model's phase."""
    made = tk.networks.build("mann-film", small_run.model.layout, 2, small_run.model.sizes)
    control = Controller(made, small_run.bank)
    sent = []
    control.send, control.recording = lambda content, buffers: sent.append(buffers[0]), True
    control.advance(3)
    joints = len(made.layout.skeleton)
    assert len(sent[-1]) == 4 * (3 + 4 * joints + 12 * 4 + 2)
    assert len(control.clip) == 3
    control.close()


def test_a_recording_becomes_a_clip(fast):
    control = Controller(*fast)
    with refusal("nothing recorded"):
        _ = control.clip
    control.advance(5)
    control.recording = True
    control.steer(ahead=1)
    control.advance(60)
    control.recording = False
    assert not control.state.joints.is_inference()  # a loss may use them
    control.advance(5)
    assert (len(control.clip), control.clip.fps) == (60, 60)
    assert tk.metrics.upright(control.clip)
    control.recording = True
    control.advance(3)
    assert len(control.clip) == 3
    control.close()
    with refusal("nothing recorded"):  # in Out, it takes no memory
        _ = control.clip


def test_a_long_recording_keeps_its_end(fast, monkeypatch):
    monkeypatch.setattr("toolkit.view.widgets.controller.KEPT", 0.1)
    made = Controller(*fast)
    made.recording = True
    made.steer(ahead=1)
    made.advance(20)
    assert len(made.clip) == 6
    torch.testing.assert_close(made.clip.root_positions[-1, [0, 2]], made.state.root[0, :2],
                               atol=0.1, rtol=0)
    made.close()


def test_bad_wishes_are_refused(control):
    with refusal("Zombi"):
        control.blend = {"Zombi": 1}
    with refusal("one to three weights"):
        control.blend = {"Zombie": -1}


def test_it_runs_while_a_page_looks_and_waits_otherwise(fast, monkeypatch):
    monkeypatch.setattr(module, "PATIENCE", 0.1)  # six frames

    async def until(test):
        async with asyncio.timeout(60):
            while not test():
                await asyncio.sleep(0.005)

    async def watch():
        control = Controller(*fast)
        control.send = lambda content, buffers: None
        await until(lambda: control.frames == 7)  # no page said anything
        for _ in range(20):
            await asyncio.sleep(0)
        assert control.frames == 7
        control._receive(control, {"kind": "seen", "frame": 7}, [])
        await until(lambda: control.frames == 14)
        control._receive(control, {"kind": "seen", "frame": 14}, [])
        control._receive(control, {"kind": "closed"}, [])
        for _ in range(20):
            await asyncio.sleep(0)
        assert control.frames <= 15
        control._model = None  # whatever fails is said in the view, once
        control._receive(control, {"kind": "seen", "frame": 14}, [])
        await until(lambda: control.status)
        assert control.status.startswith("stopped: ")
        task = control._task
        control.close()
        await until(task.done)

    asyncio.run(watch())
