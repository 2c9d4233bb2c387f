"""The scripts in examples/, run as a reader runs them, small."""

import json
import runpy
import socket
import sys
from pathlib import Path

import numpy as np
import pytest
from refusal import refusal

import toolkit as tk

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def ran(monkeypatch):
    """Run a script with arguments: its globals."""

    def ran(name, *arguments):
        monkeypatch.setenv("TOOLKIT_FAST", "1")
        monkeypatch.setattr(sys, "argv", [name, *map(str, arguments)])
        return runpy.run_path(str(EXAMPLES / name), run_name="__main__")

    return ran


def test_own_phase_source_on_procedural_clips_and_on_own_files(ran, tmp_path, walk_clip):
    found = ran("own_phase_source.py")
    assert len(found["errors"]) == 3
    for row in found["errors"].values():  # noise comes near π/2
        assert row["hybrid"] < 0.3
        assert row["height, fitted"] < 0.4
        assert row["height, Hilbert"] < 0.8
    assert all(bool(p.isfinite().all()) for p in found["data"].phases.values())
    tk.bvh.save(walk_clip, tmp_path / "mine.bvh")
    found = ran("own_phase_source.py", tmp_path)
    assert found["errors"]["mine.bvh"]["hybrid"] == pytest.approx(0.0, abs=1e-6)
    assert 0.01 < found["errors"]["mine.bvh"]["height, fitted"] < 0.4


def test_own_models_learn_and_are_listened_to(ran):
    found = ran("own_model.py", "low_rank")
    model = found["runs"]["low-rank"].model
    assert model.style_size == model.modulation.size == 2 * (32 + 64)
    for run in found["runs"].values():
        assert all(row["error"] < min(row["other"], 0.9 * row["mean"]) for row in run.table())
    assert all(len(clip) == 120 for clip in found["clips"].values())
    # as no FiLM, whose file it might be taken for
    with refusal("low-rank"):
        tk.runtime.compile(model)


def test_gym_loop_rewards_the_better_policy_and_repeats_itself(ran):
    found = ran("gym_loop.py")
    walk, play, rewards = found["Walk"], found["play"], found["rewards"]
    assert rewards["heuristic"].min() > 0.6 > 1.5 * rewards["random"].mean()
    again = play(walk(8), found["policies"]["heuristic"])
    np.testing.assert_array_equal(again, rewards["heuristic"])
    one = walk(seconds=2.0)
    one.reset(seed=3)
    results = [one.step(np.zeros(2, np.float32)) for _ in range(20)]
    assert [truncated for *_, truncated, _ in results] == [False] * 19 + [True]
    assert results[-1][1] < results[0][1]  # it stood, the path went on
    assert not results[-1][2]
    one = walk(seconds=5.0)
    (seen, _), strayed = one.reset(seed=3), False
    for _ in range(50):
        seen, _, strayed, _, _ = one.step(-2 * seen[:2])  # away from the path
    assert strayed
    checker = pytest.importorskip("gymnasium.utils.env_checker", reason="needs gymnasium")
    # which warns, and so fails here, where it is not content
    checker.check_env(walk(), skip_render_check=True)


def test_the_link_to_blender_sends_the_joints_and_poses(monkeypatch, fast):
    monkeypatch.syspath_prepend(EXAMPLES)
    import blender_link

    with socket.socket(type=socket.SOCK_DGRAM) as plug:
        plug.bind(("127.0.0.1", 0))
        monkeypatch.setattr(blender_link, "PORT", plug.getsockname())
        blender_link.walk("Old", 0.1)
        packets = [plug.recv(65536) for _ in range(7)]
    joints = json.loads(packets[0])
    skeleton = fast[0].layout.skeleton
    assert tuple(name for name, _, _ in joints) == skeleton.names
    numbers = np.frombuffer(packets[-1], np.float32).copy()
    assert numbers.shape == (3 + 4 * len(skeleton),)
    assert 0.7 < numbers[1] < 1.1
    assert np.allclose(np.linalg.norm(numbers[3:].reshape(-1, 4), axis=1), 1, atol=1e-5)
