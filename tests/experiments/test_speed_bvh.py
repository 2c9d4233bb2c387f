"""The comparison of BVH readers."""

import re

import pytest
from test_bvh import GOOD, load, write

from experiments.speed import bvh as bench


@pytest.mark.filterwarnings("ignore:walk.bvh. no joint was found")
def test_the_benchmark_compares_with_peers_and_says_which_are_missing(
    tmp_path, monkeypatch, capsys
):
    def no_peer():
        raise ImportError

    def cannot():
        return lambda path: [][0]

    def same():  # in the file's units, moved by half a unit, without End Sites
        return lambda path: load(path).without_ends().global_positions.numpy() * 100 + 0.5

    monkeypatch.setattr(bench, "PEERS", {"absent": no_peer, "numpy": cannot, "torch": same})
    bench.run(write(tmp_path, GOOD))
    said = capsys.readouterr().out
    assert "walk.bvh: 3 frames, 2 joints" in said
    assert re.search(r"torch [\d.+a-z]+ .*x +0\.5000\d units", said)
    assert re.search(r"numpy [\d.]+: cannot read this file \(IndexError", said)
    assert "not installed: absent; pip install absent" in said
