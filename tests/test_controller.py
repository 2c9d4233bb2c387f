import asyncio

import numpy as np
import pytest
import torch

import toolkit as tk
from toolkit.view.controller import PATIENCE, Controller


@pytest.fixture(scope="module")
def trained():
    return tk.pretrained()


@pytest.fixture
def control(trained):
    made = Controller(*trained, styles=["Neutral", "Zombie", "Aeroplane"])
    made.sent = []
    made.send = lambda content, buffers: made.sent.append((content, buffers[0]))
    yield made
    made.close()


def hand(control, **wish):
    blank = {"kind": "input", "id": 1, "move": [0, 0], "turn": 0, "run": False, "heading": None}
    control._receive(control, blank | wish, [])


def test_keys_go_ahead_sideways_and_round(control):
    hand(control, move=[0, 1])
    control.advance(150)
    x, z, _, ahead = control.state.root[0].tolist()
    assert z > 1.0 > abs(x)
    assert ahead > 0.9
    hand(control, move=[0, 1], turn=1)
    control.advance(45)
    assert control.state.root[0, 2] > 0.5  # looking left, +x
    hand(control, move=[-1, 0])  # to its left
    facing, place = control.state.facing[0].clone(), control.state.root[0, :2].clone()
    control.advance(120)
    left = torch.tensor([facing[1], -facing[0]])
    assert float((control.state.root[0, :2] - place) @ left) > 0.3


def test_the_stick_points_in_the_world_and_shift_runs(control):
    for run, least, most in ((False, 0.5, 1.5), (True, 1.5, 3.3)):
        hand(control, heading=[1.0, 0.0], run=run)
        control.advance(180)
        speed = (control.state.history[0, -1, :2] - control.state.history[0, 0, :2]).tolist()
        assert least < speed[0] < most, f"run {run}: {speed}"
        assert abs(speed[1]) < 0.3


def test_a_frame_is_one_small_buffer(control):
    hand(control, id=7, move=[0, 1])
    control.advance(2)
    content, buffer = control.sent[-1]
    assert content == {"kind": "frame", "frame": 2, "input": 7}
    numbers = np.frombuffer(buffer, np.float32)
    joints = len(control._model.layout.skeleton)
    assert len(numbers) == 3 + 4 * joints + 12 * 4 + 8 + 2
    assert len(buffer) < 1600
    assert np.isfinite(numbers).all()
    assert np.allclose(np.linalg.norm(numbers[3 : 3 + 4 * joints].reshape(-1, 4), axis=1), 1, atol=1e-4)
    now = 3 + 4 * joints + 6 * 4
    assert np.allclose(numbers[now : now + 4], control.state.root[0], atol=1e-6)


def test_the_marker_changes_the_style_smoothly(control, trained):
    _, bank = trained
    control.blend = {"Zombie": 3, "Old": 1}
    assert control.names == ["Zombie", "Old", "Neutral"]
    assert control.blend == {"Zombie": 0.75, "Old": 0.25, "Neutral": 0.0}
    target = bank.blend({"Zombie": 0.75, "Old": 0.25})
    before = float((control.state.style[0] - target).norm())
    control.advance(1)
    once = float((control.state.style[0] - target).norm())
    control.advance(80)
    assert 0.7 * before < once < before
    assert float((control.state.style[0] - target).norm()) < 1e-3 * before
    control.names = ["Zombie"] * 3
    assert control.blend == {"Zombie": pytest.approx(1.0)}


def test_feet_and_arms_are_switched_apart(control):
    hand(control, move=[0, 1])
    control.advance(60)
    poses = {}
    for feet in (False, True):
        for arms in (False, True):
            poses[feet, arms] = tk.runtime.pose(control._model.layout, control.state, feet=feet, arms=arms)[0][0]
    skeleton = control._model.layout.skeleton
    arm, leg = (skeleton.index(f"left_{part}") for part in ("elbow", "knee"))
    assert torch.allclose(poses[False, True][leg], poses[False, False][leg], atol=1e-6)
    assert torch.allclose(poses[True, False][arm], poses[False, False][arm], atol=1e-6)
    assert float((poses[True, False] - poses[False, False]).abs().max()) > 1e-3
    assert float((poses[False, True] - poses[False, False]).abs().max()) > 1e-3


@pytest.mark.parametrize("model", ["pfnn-film", "mann-film"])
def test_models_with_other_phases_walk_too(model):
    """One angle for the whole body, or no phase: the frame's last part is as long as the model's phase."""
    clips = tk.datasets.load("procedural", styles=["Neutral", "Old"], gaits=["FW"], seconds=8.0)
    run = tk.training.fit(tk.features.build(clips, short="skip"), tk.training.Config.quick(model=model, seconds=1.0))
    control = Controller(run.model, run.bank)
    control.send = lambda content, buffers: control.sent.append(buffers[0])
    control.sent, control.recording = [], True
    control.advance(5)
    layout = run.model.layout
    assert len(control.sent[-1]) == 4 * (3 + 4 * len(layout.skeleton) + 12 * 4 + 2 + layout.n_phases)
    assert layout.n_phases < 8
    assert len(control.clip) == 5
    control.close()


def test_the_server_extension_sends_at_once():
    from types import SimpleNamespace

    from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection

    from toolkit.view import server

    settings = {"kernel_websocket_connection_class": ZMQChannelsWebsocketConnection}
    server._load_jupyter_server_extension(SimpleNamespace(web_app=SimpleNamespace(settings=settings)))
    assert settings["kernel_websocket_connection_class"] is server.PromptConnection
    settings["kernel_websocket_connection_class"] = object  # somebody's own
    server._load_jupyter_server_extension(SimpleNamespace(web_app=SimpleNamespace(settings=settings)))
    assert settings["kernel_websocket_connection_class"] is object


def test_a_recording_becomes_a_clip(control):
    with pytest.raises(ValueError, match="nothing recorded"):
        _ = control.clip
    control.advance(5)
    control.recording = True
    control.steer(ahead=1)
    control.advance(90)
    control.recording = False
    assert not control.state.joints.is_inference()  # a loss may use them
    control.advance(5)
    assert (len(control.clip), control.clip.fps) == (90, 60)
    assert tk.metrics.upright(control.clip)
    control.recording = True
    control.advance(3)
    assert len(control.clip) == 3


def test_bad_wishes_are_refused(control, trained):
    with pytest.raises(ValueError, match="three styles"):
        Controller(*trained, styles=["Neutral"])
    with pytest.raises(ValueError, match="Zombi"):
        control.blend = {"Zombi": 1}
    with pytest.raises(ValueError, match="one to three weights"):
        control.blend = {"Zombie": -1}


def test_it_runs_while_a_page_looks_and_waits_otherwise(trained):
    async def watch():
        control = Controller(*trained)
        control.send = lambda content, buffers: None
        looked = control.frames
        while control.frames < PATIENCE * 60 + 1:  # no page said anything
            await asyncio.sleep(0.02)
        await asyncio.sleep(0.3)
        waited = control.frames
        await asyncio.sleep(0.3)
        assert control.frames == waited > looked
        control._receive(control, {"kind": "seen", "frame": waited}, [])
        await asyncio.sleep(0.3)
        resumed = control.frames
        assert resumed > waited
        control._receive(control, {"kind": "closed"}, [])
        await asyncio.sleep(0.2)
        gone = control.frames
        await asyncio.sleep(0.3)
        assert control.frames == gone
        control._model = None  # whatever fails is said in the view, once
        control._receive(control, {"kind": "seen", "frame": gone}, [])
        await asyncio.sleep(0.3)
        assert control.status.startswith("stopped: ")
        control.close()
        await asyncio.sleep(0)
        assert control._task.done()

    asyncio.run(watch())
