"""Recordings of three makers of BVH files, read, written and read again: the same motion."""

import itertools
import math

import pytest
import torch

import toolkit as tk
from toolkit.motion import rotations

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


@pytest.mark.parametrize("order", ["".join(p) for p in itertools.permutations("XYZ")])
@pytest.mark.parametrize(("dtype", "error"), [(torch.float64, 1e-14), (torch.float32, 3e-6)])
def test_angles_at_and_near_gimbal_lock(order, dtype, error):
    """The file holds Euler angles, of which two run together where the middle one is near 90°."""
    off = torch.tensor([0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 4e-4, 1e-3, 1e-2]).double()
    middle = torch.cat([sign * math.pi / 2 + side * off for sign in (-1, 1) for side in (-1, 1)])
    generator = torch.Generator().manual_seed(0)
    outer = 6 * torch.rand(len(middle), 2, dtype=torch.float64, generator=generator) - 3
    angles = torch.stack((outer[:, 0], middle, outer[:, 1]), 1)
    q = rotations.from_euler(angles, order).to(dtype)
    again = rotations.from_euler(rotations.to_euler(q, order), order)
    expected = rotations.to_matrix(rotations.normalize(q.double()))
    apart = rotations.to_matrix(again.double()) - expected
    assert float(apart.abs().max()) < error
