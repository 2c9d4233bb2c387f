"""Rubbish in, one line out: a short `fuzz`. Nothing is half-written."""

import contextlib
import tracemalloc

import pytest
from robustness import fuzz
from robustness.fuzz import targets

from toolkit.io import bvh
from toolkit.io.files import atomic_write


@pytest.fixture(scope="module")
def readers(tmp_path_factory):
    return targets.make(tmp_path_factory.mktemp("fuzz"))


@pytest.mark.parametrize("target", fuzz.TARGETS)
def test_mutated_inputs_are_read_or_refused_in_one_line(readers, target):
    tally = fuzz.fuzz(readers[target], 36, seed=1)
    assert not tally.failures
    assert tally.counts["refused"] > 1


def chain(joints: int, channels: str = "") -> str:
    """The hierarchy of a BVH file in which each joint hangs on the one before."""
    return "".join(f"JOINT j{i}\n{{\n{channels}" for i in range(joints)) + "}\n" * joints


def test_a_small_bvh_takes_little_memory_whatever_it_claims(tmp_path):
    joints, rows = 3000, 30_000  # 3 × 3000 channels by 30,000 frames would be 2 GB
    three = chain(joints, "CHANNELS 3 Xrotation Yrotation Zrotation\n")
    path = tmp_path / "walk.bvh"
    path.write_text(f"HIERARCHY\nROOT r\n{{\n{three}}}\nMOTION\nFrames: {rows}\nFrame Time: 0.1\n"
                    + "1\n" * rows)
    tracemalloc.start()
    with pytest.raises(bvh.BVHError, match=rf"walk\.bvh.*expected {3 * joints} numbers, got 1"):
        bvh.load(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 60 * path.stat().st_size


def test_joints_without_channels_times_frames_are_not_taken_at_their_word(tmp_path):
    path = tmp_path / "walk.bvh"
    said = r"walk\.bvh.*2001 joints in 2000 frames, but only 1 channels"
    for frames, loads in ((100, contextlib.nullcontext()),
                          (2000, pytest.raises(bvh.BVHError, match=said))):
        motion = f"MOTION\nFrames: {frames}\nFrame Time: 0.1\n" + "1\n" * frames
        path.write_text("HIERARCHY\nROOT r\n{\nCHANNELS 1 Xrotation\n" + chain(2000) + "}\n"
                        + motion)
        with loads:
            assert len(bvh.load(path, unit=0.01, up="y")) == frames


def test_two_writers_of_one_file_do_not_mix(tmp_path):
    path = tmp_path / "new" / "a[1].bin"
    with atomic_write(path) as first:
        first.write(b"first")
        with atomic_write(path) as second:
            second.write(b"second")
        assert path.read_bytes() == b"second"
    assert path.read_bytes() == b"first"
    assert list(path.parent.iterdir()) == [path]


def test_what_cannot_be_written_is_named(tmp_path):
    path = tmp_path / "a.bin"
    path.write_bytes(b"old")
    named = pytest.raises(OSError, match=r"\(No space left on device\): '.*a\.bin'")
    with named, atomic_write(path):
        raise OSError(28, "No space left on device")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
