"""Recordings of three makers of BVH files, read, written and read again: the same motion."""

import pytest

import toolkit as tk

# metres; the unit of xia is that of the CMU skeleton
UNITS = {"100style": tk.bvh.CENTIMETRE, "bandai": tk.bvh.CENTIMETRE, "xia": 0.05644}


@pytest.mark.parametrize("dataset", UNITS)
def test_joint_positions_after_writing_and_reading(shared, tmp_path, dataset):
    files = sorted((shared / dataset).rglob("*.bvh"))
    files = files[:: len(files) // 4 or 1]
    assert files
    worst = {}
    for file in files:
        clip = tk.bvh.load(file, unit=UNITS[dataset], up="y")
        tk.bvh.save(clip, tmp_path / "again.bvh")
        again = tk.bvh.load(tmp_path / "again.bvh", unit=0.01, up="y")
        assert again.skeleton.names == clip.skeleton.names
        assert again.skeleton.parents == clip.skeleton.parents
        assert again.fps == pytest.approx(clip.fps, abs=1e-4)
        worst[file.name] = float((again.global_positions - clip.global_positions).abs().max())
    name = max(worst, key=worst.get)
    assert worst[name] <= 1e-5, f"{name}: {1000 * worst[name]:.4f} mm"
