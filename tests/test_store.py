"""The store: the same features as in memory, whatever happened while it was made."""

import logging
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import torch
from test_networks import TINY

import toolkit as tk
from toolkit.__main__ import main
from toolkit.datasets import procedural
from toolkit.features import KINDS

STYLES = ("ProceduralNeutral", "ProceduralZombie")


@pytest.fixture(scope="module")
def root(tmp_path_factory):
    """Two styles of three takes each, as 100STYLE has them."""
    folder = tmp_path_factory.mktemp("root") / "data"
    procedural.write(folder, ["Neutral", "Zombie"], ["FW", "ID", "SW"], seconds=7.0)
    return folder


@pytest.fixture(scope="module")
def made(root, tmp_path_factory):
    """A finished store with mirror images."""
    out = tmp_path_factory.mktemp("made") / "store"
    assert preprocess(root, out)
    return out


@pytest.fixture(scope="module")
def in_memory(root):
    return tk.features.build(tk.datasets.load("100style", root), mirror=tk.datasets.may_mirror("100style", root))


def preprocess(root, out, **options):
    mirror = tk.datasets.may_mirror("100style", root)
    return tk.features.store.preprocess("100style", root, out, **{"mirror": mirror, "workers": 1} | options)


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_it_gives_the_features_of_build_bit_for_bit(made, in_memory):
    stored = tk.features.store.load(made)
    assert stored.styles == in_memory.styles == list(STYLES)
    assert stored.n_frames == in_memory.n_frames
    for kind in (*KINDS, "takes"):
        for style in STYLES:
            rows, expected = getattr(stored, kind)[style], getattr(in_memory, kind)[style]
            assert torch.equal(rows[:], expected)
            some = torch.tensor([5, 0, len(rows) - 1])
            assert torch.equal(rows[some], expected[some])
            assert torch.equal(rows[3], expected[3])
    for style in STYLES:
        assert torch.equal(stored.frames[style], in_memory.frames[style])
        assert torch.equal(stored.spans[style], in_memory.spans[style])
    takes = {style: len(stored.takes[style]) / (420 - 111) for style in STYLES}
    assert takes == {STYLES[0]: 5, STYLES[1]: 3}  # of a symmetric style all but idling twice, of the other none


def test_contacts_follow_the_height_that_is_given(root, tmp_path):
    style = [STYLES[0]]
    assert preprocess(root, tmp_path / "store", styles=style, mirror=None, contact_height=-0.5)  # below the floor: none
    clips = tk.datasets.load("100style", root, style)
    given, usual = (tk.features.build(clips, contact_height=height).outputs[style[0]] for height in (-0.5, None))
    assert torch.equal(tk.features.store.load(tmp_path / "store").outputs[style[0]][:], given)
    assert not torch.equal(given, usual)


def test_a_store_of_a_list_has_its_parts_also_if_only_some_styles_are_read(tmp_path, capsys, monkeypatch):
    root, out = tmp_path / "data", tmp_path / "store"
    procedural.write(root, ["Neutral", "Zombie"], ["FW"], seconds=25.0)
    assert preprocess(root, out, listed=True, mirror=None)
    data = tk.features.splits.listed(tk.datasets.load("100style", root), tk.datasets.split("100style", root))
    parts = tk.training.split(data, 0.1, 0, STYLES)
    assert {style: len(x) for style, x in parts[1].inputs.items()} == dict.fromkeys(STYLES, 240 - 111)
    stored = tk.features.store.load(out)
    for styles in (STYLES, STYLES[1:]):
        found = tk.training.split(tk.features.store.load(out, styles), 0.3, 5, styles)
        for kind in KINDS:
            for own, expected in zip(found, parts, strict=True):
                assert all(torch.equal(getattr(own, kind)[s][:], getattr(expected, kind)[s]) for s in styles)
    statistics = tk.training.split(stored, 0.1, 0, STYLES)[0].statistics
    assert all(torch.equal(statistics[kind].mean, own.mean) for kind, own in parts[0].normalisers().items())
    trained = []
    monkeypatch.setattr(tk.training, "fit", lambda data, *_, **__: trained.append(data) or sys.exit(0))
    train = ["train", "--out", str(tmp_path / "run.safetensors"), "--listed", "--data"]
    with pytest.raises(SystemExit, match="0"):
        main([*train, "100style", "--root", str(root)])
    assert all(torch.equal(trained[0].split.held_out[style], data.split.held_out[style]) for style in STYLES)
    for other, said in ((str(out), "a store has its own --root, --gaits, --mirror and --listed"),
                        ("procedural", "no split of 'procedural'; known: 100style, bandai")):
        assert main([*train, other]) == 2
        assert said in capsys.readouterr().err


def test_the_split_and_its_statistics_are_recorded(made, in_memory):
    stored = tk.features.store.load(made)
    for share, seed in ((0.1, 0), (0.2, 3)):
        (train, test), expected = (tk.training.split(data, share, seed, STYLES) for data in (stored, in_memory))
        assert (train.statistics is not None) == (seed == 0)
        for style in STYLES:
            assert torch.equal(test.outputs[style][:], expected[1].outputs[style])
        for kind, normaliser in train.normalisers().items():
            assert torch.equal(normaliser.mean, expected[0].normalisers()[kind].mean)
            assert torch.equal(normaliser.std, expected[0].normalisers()[kind].std)
    part = tk.features.store.load(made, styles=["ProceduralZombie"])
    assert part.split is None
    whole = tk.training.split(stored, 0.1, 0, STYLES)[1]
    for data in (part, stored, in_memory):  # one style holds out what it does among all
        held = tk.training.split(data, 0.1, 0, ("ProceduralZombie",))[1]
        assert torch.equal(held.inputs["ProceduralZombie"][:], whole.inputs["ProceduralZombie"][:])


def test_training_from_it_gives_the_same_weights(made, in_memory):
    config = tk.training.Config(sizes=TINY, steps=6, batch=16, clips_per_batch=4, pose_mixup=0.3, evaluate_every=3,
                                rate=1e-3)
    runs = [tk.training.fit(data, config) for data in (tk.features.store.load(made), in_memory)]
    for a, b in zip(*(run.model.state_dict().values() for run in runs), strict=True):
        assert torch.equal(a, b)
    assert torch.equal(runs[0].bank.vectors, runs[1].bank.vectors)
    assert runs[0].held_out == runs[1].held_out
    assert runs[0].baselines == runs[1].baselines


def test_the_command_line_makes_the_same_bytes_with_two_processes(root, made, tmp_path, capsys):
    call = ["preprocess", "--data", "100style", "--root", str(root), "--out", str(tmp_path / "store"), "--mirror",
            "--workers", "2"]
    for done_before in (False, True):
        with pytest.raises(SystemExit, match="0"):
            main(call)
        assert f" frames of 2 styles in {tmp_path / 'store'}" in (out := capsys.readouterr().out)
        assert ("nothing to do" in out) == done_before
        assert contents(tmp_path / "store") == contents(made)


def test_two_dask_workers_make_the_same_bytes(root, made, tmp_path):
    distributed = pytest.importorskip("distributed", reason='Dask is not installed: pip install ".[scale]"')
    quiet = {"dashboard_address": ":0", "silence_logs": logging.ERROR}
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, **quiet) as cluster:
        assert preprocess(root, tmp_path / "store", scheduler=cluster.scheduler_address)
    assert contents(tmp_path / "store") == contents(made)


KILLED = """
import os, signal, sys
from pathlib import Path
import test_store

renamed, rename = [], os.replace

def replace(source, target):
    renamed.append(target)
    if len(renamed) == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    return rename(source, target)

os.replace = replace
test_store.preprocess(Path(sys.argv[1]), Path(sys.argv[2]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_a_killed_run_goes_on_with_nothing_lost_or_doubled(root, made, tmp_path):
    out = tmp_path / "store"
    for left in ("a whole file without its name", "a file that the manifest does not list"):
        call = [sys.executable, "-c", KILLED, str(root), str(out)]
        code = subprocess.run(call, cwd=Path(__file__).parent, check=False)
        assert code.returncode == -9
        with pytest.raises(ValueError, match="not finished"):
            tk.features.store.load(out)
        found = set(contents(out)) - {"manifest.json"}
        partial = [name for name in found if name.endswith(".partial")]
        assert len(partial) == 1
        assert len(found) == (1 if left == "a whole file without its name" else 2)
    assert preprocess(root, out)
    assert contents(out) == contents(made)


def test_a_damaged_or_missing_file_is_made_again(root, made, tmp_path):
    out = tmp_path / "store"
    shutil.copytree(made, out)
    for name in (f"{STYLES[1]}.safetensors", "split.safetensors"):
        whole = (out / name).read_bytes()
        (out / name).write_bytes(whole[:-8])
        with pytest.raises(ValueError, match=rf"{name}: missing or not whole"):
            tk.features.store.load(out)
        (out / name).write_bytes(whole[:-8] + b"\1" * 8)
        assert preprocess(root, out)
        assert contents(out) == contents(made)
    assert not preprocess(root, out)


def test_other_settings_or_files_are_refused(root, made, tmp_path):
    for options, difference in (({"mirror": None}, "mirror: expected True, got False"), ({"seed": 1}, "seed"),
                                ({"source": "contact"}, "source: expected 'hybrid', got 'contact'"),
                                ({"contact_height": 0.02}, "contact_height")):
        with pytest.raises(ValueError, match=rf"made with other settings \(.*{difference}"):
            preprocess(root, made, **options)
    other = tmp_path / "data"
    shutil.copytree(root, other)
    path = other / f"{STYLES[0]}_FW.bvh"
    path.write_text(path.read_text().replace("Frame Time", "Frame  Time"))
    with pytest.raises(ValueError, match=f"the files of style {STYLES[0]} are not those"):
        preprocess(other, made)


def test_a_broken_file_is_named_and_all_other_styles_are_stored(root, made, tmp_path):
    other, out = tmp_path / "data", tmp_path / "store"
    shutil.copytree(root, other)
    path = other / f"{STYLES[0]}_ID.bvh"
    whole = path.read_text()
    path.write_text(whole[:-200])
    with pytest.raises(ValueError, match=rf"1 of 2 styles could not be stored.*{path.name}") as error:
        preprocess(other, out)
    assert "\n" not in str(error.value)
    assert f"{STYLES[1]}.safetensors" in contents(out)
    path.write_text(whole)
    assert preprocess(other, out)
    assert contents(out) == contents(made)


def test_what_cannot_work_is_refused_before_the_work(root, made, tmp_path, monkeypatch):
    (tmp_path / "empty").mkdir()
    (tmp_path / "file").write_text("")
    with pytest.raises(ValueError, match=r"no .*in .*empty"):
        tk.features.store.preprocess("100style", tmp_path / "empty", tmp_path / "store")
    for out in (root, tmp_path / "file"):
        with pytest.raises(ValueError, match="expected a store or an empty folder"):
            preprocess(root, out)
    with pytest.raises(ValueError, match="procedural dataset is computed"):
        tk.features.store.preprocess("procedural", None, tmp_path / "store")
    with pytest.raises(ValueError, match="holds no store"):
        tk.features.store.load(tmp_path / "empty")
    assert main(["train", "--data", str(made), "--mirror", "--out", str(tmp_path / "run.safetensors")]) == 2
    usage = shutil.disk_usage(tmp_path)._replace(free=1000)
    monkeypatch.setattr(shutil, "disk_usage", lambda _: usage)
    with pytest.raises(OSError, match=r"needs about 0\.0 GB more"):
        preprocess(root, tmp_path / "store")
