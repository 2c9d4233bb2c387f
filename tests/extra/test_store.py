"""The store: the same features as in memory, whatever happened while it was made."""

import os
import re
import shutil
import signal

import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.features import KINDS

STYLES = ("ProceduralNeutral", "ProceduralZombie")


@pytest.fixture(scope="module")
def root(tmp_path_factory):
    """Two styles of two takes each, as 100STYLE has them."""
    folder = tmp_path_factory.mktemp("root") / "data"
    procedural.write(folder, ["Neutral", "Zombie"], ["FW", "ID"], seconds=5.0)
    return folder


@pytest.fixture(scope="module")
def made(root, tmp_path_factory):
    """A finished store with mirror images."""
    out = tmp_path_factory.mktemp("made") / "store"
    assert preprocess(root, out)
    return out


@pytest.fixture(scope="module")
def in_memory(root):
    clips = tk.datasets.load("100style", root)
    return tk.features.build(clips, mirror=tk.datasets.may_mirror("100style", root))


def preprocess(root, out, **options):
    mirror = tk.datasets.may_mirror("100style", root)
    options = {"mirror": mirror, "workers": 1} | options
    return tk.features.store.preprocess("100style", root, out, **options)


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_it_gives_the_features_of_build_bit_for_bit(made, in_memory):
    stored = tk.features.store.load(made)
    assert stored.styles == in_memory.styles == list(STYLES)
    assert stored.n_frames == in_memory.n_frames
    for kind in (*KINDS, "takes", "frames", "spans"):
        for style in STYLES:
            rows, expected = getattr(stored, kind)[style], getattr(in_memory, kind)[style]
            for some in (slice(None), torch.tensor([1, 0, len(rows) - 1]), 1):
                assert torch.equal(rows[some], expected[some])
    # of a symmetric style all but idling twice, of the other none
    takes = {style: len(stored.takes[style]) / (300 - 111) for style in STYLES}
    assert takes == {STYLES[0]: 3, STYLES[1]: 2}


def test_a_store_of_a_list_has_its_parts_also_if_only_some_styles_are_read(tmp_path):
    root, out = tmp_path / "data", tmp_path / "store"
    procedural.write(root, ["Neutral", "Zombie"], ["FW"], seconds=25.0)
    assert preprocess(root, out, listed=True, mirror=None)
    clips, listing = tk.datasets.load("100style", root), tk.datasets.split("100style", root)
    data = tk.features.splits.listed(clips, listing)
    parts = tk.training.split(data, 0.1, 0, STYLES)
    for styles in (STYLES, STYLES[1:]):
        stored = tk.features.store.load(out, styles)
        found = tk.training.split(stored, 0.3, 5, styles)
        for kind in KINDS:
            for own, expected in zip(found, parts, strict=True):
                rows, known = getattr(own, kind), getattr(expected, kind)
                assert all(torch.equal(rows[s][:], known[s]) for s in styles)


def test_the_split_and_its_statistics_are_recorded(made, in_memory):
    stored = tk.features.store.load(made)
    for share, seed in ((0.1, 0), (0.2, 3)):
        (train, test), expected = (tk.training.split(data, share, seed, STYLES)
                                   for data in (stored, in_memory))
        assert (train.statistics is not None) == (seed == 0)
        for style in STYLES:
            assert torch.equal(test.outputs[style][:], expected[1].outputs[style])
        for kind, normaliser in train.normalisers().items():
            assert torch.equal(normaliser.mean, expected[0].normalisers()[kind].mean)
            assert torch.equal(normaliser.std, expected[0].normalisers()[kind].std)
    style = STYLES[1]  # one style holds out what it does among all
    part = tk.features.store.load(made, styles=[style])
    whole = tk.training.split(stored, 0.1, 0, STYLES)[1]
    for data in (part, stored, in_memory):
        held = tk.training.split(data, 0.1, 0, (style,))[1]
        assert torch.equal(held.inputs[style][:], whole.inputs[style][:])


def test_the_command_line_makes_the_same_bytes_in_another_process(root, made, tmp_path, command):
    """The second style; the first one, which is the larger, is there."""
    out = tmp_path / "store"
    shutil.copytree(made, out, ignore=shutil.ignore_patterns("000*"))
    call = f"preprocess --data 100style --root {root} --mirror --workers 2 --out {out}"
    for done_before in (False, True):
        assert f" frames of 2 styles in {out}" in (said := command(call).out)
        assert ("nothing to do" in said) == done_before
        assert contents(out) == contents(made)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="Windows has no SIGKILL")
def test_a_killed_run_goes_on_with_nothing_lost_or_doubled(root, made, tmp_path, monkeypatch):
    """The first time before its manifest was whole; then the second style's file is left behind
    whole, but without its name.
    """
    out = tmp_path / "store"
    out.mkdir()
    (out / ".manifest.json.0123abcd.partial").write_text("{")
    first, second = "001.safetensors", "000.safetensors"  # the larger one comes first
    write = os.replace

    def replace(source, target):
        if target.name == second:
            os.kill(os.getpid(), signal.SIGKILL)
        return write(source, target)

    if not (child := os.fork()):
        signal.alarm(60)
        monkeypatch.setattr(os, "replace", replace)
        try:
            preprocess(root, out)
        finally:
            os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == -signal.SIGKILL
    with refusal("not finished"):
        tk.features.store.load(out)
    partial, *left = sorted(contents(out))
    assert re.fullmatch(rf"\.{second}\..*\.partial", partial)
    assert left == [first, "manifest.json"]
    assert preprocess(root, out)
    assert contents(out) == contents(made)


def test_what_is_damaged_or_older_than_its_files_is_made_again(root, made, tmp_path):
    out, data = tmp_path / "store", tmp_path / "data"
    shutil.copytree(made, out)
    shutil.copytree(root, data)
    name = "001.safetensors"
    whole = (out / name).read_bytes()
    (out / name).write_bytes(whole[:-8])
    with refusal(rf"{name}: missing or damaged .*; run the command"):
        tk.features.store.load(out)
    assert preprocess(data, out)
    assert contents(out) == contents(made)
    assert not preprocess(data, out)
    path = data / f"{STYLES[1]}_FW.bvh"
    path.write_text(path.read_text().replace("HIERARCHY", "HIERARCHY "))
    os.utime(path, (2e9, 2e9))
    assert preprocess(data, out)
    assert contents(out) == contents(made)


def test_other_settings_are_refused(root, made):
    for options, difference in (({"mirror": None}, "mirror: expected True, got False"),
                                ({"styles": [STYLES[0]]}, "styles"),
                                ({"source": "contact"}, "source: expected 'hybrid', got 'contact'")
                                ):
        with refusal(rf"made with other settings \(.*{difference}"):
            preprocess(root, made, **options)


def test_a_broken_file_is_named_and_all_other_styles_are_stored(root, made, tmp_path):
    other, out = tmp_path / "data", tmp_path / "store"
    shutil.copytree(root, other)
    path = other / f"{STYLES[0]}_ID.bvh"
    whole = path.read_text()
    path.write_text(whole[:-200])
    with refusal(rf"1 of 2 styles could not be .*{path.name}"):
        preprocess(other, out)
    assert sorted(contents(out)) == ["001.safetensors", "manifest.json"]
    path.write_text(whole)
    assert preprocess(other, out)
    assert contents(out) == contents(made)


def test_a_style_may_have_any_name(walk_clip, tmp_path):
    names = ("../up", "Old", "old", "é 骨", "con", "x" * 200)
    folder, out = tmp_path / "in", tmp_path / "out"
    folder.mkdir()
    rows = [f"{number}.bvh,{name},walk" for number, name in enumerate(names)]
    table = "\n".join(["file,style,gait", *rows])
    (folder / "labels.csv").write_text(table, encoding="utf-8")
    for number in range(len(names)):
        tk.bvh.save(walk_clip.cut(0, 360), folder / f"{number}.bvh")
    assert tk.features.store.preprocess("folder", folder, out, workers=1, source="contact")
    assert tk.features.store.load(out).styles == sorted(names)
    assert len(list(out.iterdir())) == len(names) + 1


def test_what_cannot_work_is_refused_before_the_work(root, made, tmp_path, command):
    (tmp_path / "empty").mkdir()
    (tmp_path / "file").write_text("")
    with refusal(r"no .*in .*empty"):
        preprocess(tmp_path / "empty", tmp_path / "store", mirror=None)
    for out in (root, tmp_path / "file"):
        with refusal("a store or an empty folder, and it is neither"):
            preprocess(root, out)
    train = f"train --data {made} --mirror --out {tmp_path}/run.safetensors"
    said = command(train, status=2).err
    assert "a store has its own --root, --gaits, --mirror and --listed" in said
