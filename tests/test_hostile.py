"""Hostile files, names and machines: what comes from outside is refused in one line, or read without harm."""

import asyncio
import contextlib
import dataclasses
import functools
import json
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
import warnings
import zlib
from pathlib import Path

import numpy as np
import pytest
import torch
from motion_files import Document, textured

import toolkit as tk
from toolkit.__main__ import main
from toolkit.io import gltf_mesh
from toolkit.io.files import atomic_write

LOADED = """
import warnings
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    import toolkit as tk
    clip = tk.bvh.load({file!r}, unit=0.01, up="y")
    tk.bvh.save(clip, {copy!r})
    tk.phases.extract(clip)
print(tk.__file__, len(clip), *(one.message for one in said if "compiled code" in str(one.message)), sep="|")
"""


@pytest.fixture
def installed(tmp_path):
    """A folder with a copy of the package, without caches and without permission to write; a home like this."""
    site = tmp_path / "site"
    ignored = shutil.ignore_patterns("__pycache__", "scene", "static")
    shutil.copytree(Path(tk.__file__).parent, site / "toolkit", ignore=ignored)
    folders = [site, *(path for path in site.rglob("*") if path.is_dir())]
    for folder in folders:
        folder.chmod(0o555)
    yield site
    for folder in folders:
        folder.chmod(0o755)


def as_another(command: list[str]) -> list[str]:
    """A command without the privileges of root, as which the tests may run."""
    if not hasattr(os, "geteuid") or os.geteuid():
        return command
    if shutil.which("setpriv") is None:
        pytest.skip("root may write everywhere, and setpriv is missing, which takes that away")
    return ["setpriv", "--inh-caps=-all", "--bounding-set=-all", *command]


def test_a_read_only_install_without_a_home_reads_and_says_where_a_cache_would_go(installed, walk_clip, tmp_path):
    tk.bvh.save(walk_clip.cut(0, 120), tmp_path / "walk.bvh")
    code = LOADED.format(file=str(tmp_path / "walk.bvh"), copy=str(tmp_path / "copy.bvh"))
    kept = {k: v for k, v in os.environ.items() if k not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME", "PYTHONPATH")}
    env = kept | {"PYTHONPATH": str(installed), "HOME": str(installed / "nobody"), "OMP_NUM_THREADS": "1"}
    command = as_another([sys.executable, "-B", "-c", code])
    done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    module, frames, *said = done.stdout.strip().split("|")
    assert module == str(installed / "toolkit" / "__init__.py")
    assert frames == "120"
    assert len(said) == 1, said
    assert "NUMBA_CACHE_DIR" in said[0]


def forged(folder: Path) -> dict[str, Path]:
    """Small model files whose sizes promise gigabytes, by loader."""
    from toolkit.evaluation.recognition import Recogniser
    from toolkit.features import Normaliser
    from toolkit.io import model_files
    from toolkit.phases.learned import PARTS, Learned, PeriodicAutoencoder
    from toolkit.stylization.graph import SkeletonGraph
    from toolkit.stylization.networks import Sizes, build

    skeleton = tk.datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=2.0)[0].without_ends().skeleton
    sizes = Sizes(channels=1, code=1, latent=1, hidden=2)
    stylizer = build(SkeletonGraph.of(skeleton), ("old",), sizes)[0]
    recogniser = Recogniser(("a", "b"), Normaliser(torch.zeros(12), torch.ones(12)), 2)
    learned = Learned({part: PeriodicAutoencoder(hidden=1) for part in PARTS}, dict.fromkeys(PARTS, 1.0))
    files = {}
    for made, part, change in (
        (stylizer, "stylizer", lambda about: about["sizes"].update(channels=2000)),
        (recogniser, "recogniser", lambda about: about.update(hidden=6000)),
        (learned, "learned", lambda about: about["hidden"].update(hand=2_000_000)),
    ):
        made.save(folder / part)
        tensors, parts = model_files.read(folder / part, part)
        change(parts[part])
        files[part] = folder / f"{part}.safetensors"
        model_files.write(files[part], {}, parts)
        if part == "recogniser":
            model_files.write(files[part], {k: v for k, v in tensors.items() if k.endswith(("mean", "std"))}, parts)
    return files


MEASURED = """
import resource, sys
import toolkit as tk
from toolkit.__main__ import main
from toolkit.io.files import atomic_write
from toolkit.evaluation.recognition import Recogniser
from toolkit.phases.learned import Learned
from toolkit.stylization.networks import Stylizer
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
resource.setrlimit(resource.RLIMIT_DATA, (8 << 30, 8 << 30))
load = {"stylizer": Stylizer.load, "recogniser": Recogniser.load, "learned": Learned.load,
        "bvh": lambda path: tk.load(path, unit=0.01, up="y").resample(60.0)}[sys.argv[1]]
try:
    load(sys.argv[2])
    print("read")
except ValueError as error:
    print(error)
print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) // 1024)
"""


def taken(kind: str, path: Path) -> tuple[str, int]:
    """What a loader says about a file, and the megabytes that it took at most."""
    if sys.platform != "linux":
        pytest.skip("memory is measured on Linux")
    done = subprocess.run([sys.executable, "-c", MEASURED, kind, str(path)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    message, megabytes = done.stdout.splitlines()
    return message, int(megabytes)


@pytest.mark.parametrize("kind", ["stylizer", "recogniser", "learned"])
def test_sizes_in_a_model_file_take_no_memory_before_they_are_checked(kind, tmp_path):
    path = forged(tmp_path)[kind]
    assert path.stat().st_size < 20_000
    message, megabytes = taken(kind, path)
    assert message.startswith(f"{path}: the {kind}")
    assert "differs in tensor" in message
    assert megabytes < 200


def test_a_description_of_more_than_16_megabytes_is_refused_before_it_is_parsed(tmp_path):
    """Parsed, each of its values would take up to 70 bytes (`toolkit.io.files.parsed`)."""
    from safetensors.torch import save_file

    from toolkit.io import model_files

    path, most = tmp_path / "a.safetensors", model_files.METADATA
    for values, said in ((most // 2 + 1, f"larger than {most} bytes"), (most // 2 - 9, "more than 2000000 values")):
        save_file({"a": torch.zeros(1)}, path, {"format": model_files.FORMAT, "recogniser": f"[{'0,' * values}0]"})
        message, megabytes = taken("recogniser", path)
        assert message.startswith(f"{path}: its metadata is ")
        assert said in message
        assert megabytes < 10 * path.stat().st_size / 1e6 + 200


def test_a_slow_recording_is_not_resampled_into_gigabytes(tmp_path):
    rows = "0 0 0 0 0 0\n" * 9000
    channels = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"
    header = f"HIERARCHY\nROOT hips\n{{\nOFFSET 0 0 0\n{channels}\n}}\n"
    path = tmp_path / "slow.bvh"
    path.write_text(f"{header}MOTION\nFrames: 9000\nFrame Time: 3.9\n{rows}")
    message, megabytes = taken("bvh", path)
    assert "0.25641 Hz" in message
    assert megabytes < 200


@pytest.mark.parametrize("seconds", ["1e7", "1e300", "inf", "nan", "-1"])
def test_a_rollout_without_end_is_refused_before_it_starts(seconds, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(["rollout", "--style", "Neutral", "--out", "never.bvh", "--seconds", seconds])
    assert stopped.value.code == 2
    assert "--seconds" in capsys.readouterr().err
    with pytest.raises(ValueError, match=r"at most 86400|finite and seconds not negative"):
        tk.runtime.straight(1.0, float(seconds))
    with pytest.raises(ValueError, match="at most"):
        tk.runtime.follow([(0.0, 0.0), (1.0, 0.0)], seconds=float(seconds))


@pytest.mark.parametrize("speed", ["1e308", "-1e39", "2e6", "inf", "nan"])
def test_a_speed_that_no_network_can_take_is_refused_by_its_name(speed, capsys, tmp_path):
    out = tmp_path / "a.bvh"
    assert main(["rollout", "--style", "Neutral", "--out", str(out), "--seconds", "0.1", "--speed", speed]) == 2
    said = capsys.readouterr().err
    assert re.match(r"error: (velocity must be finite, up to 1e\+06|speed and seconds must be finite).* got ", said)
    assert said.count("\n") == 1
    assert not out.exists()


def test_the_largest_command_gives_finite_motion():
    model, bank = tk.pretrained()
    for velocity in ((0.0, 1e6), (-1e6, 1e6)):
        clip = tk.runtime.rollout(model, [tk.runtime.Command(velocity)] * 30, bank["Neutral"])
        assert bool(clip.root_positions.isfinite().all())


def test_a_path_without_end_is_refused():
    with pytest.raises(ValueError, match="at most"):
        tk.runtime.follow([(0.0, 0.0), (1e30, 0.0)])


def test_a_very_long_frame_time_is_no_error_about_its_sign(tmp_path):
    path = tmp_path / "slow.bvh"
    path.write_text("HIERARCHY\nROOT hips\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\nMOTION\nFrames: 1\nFrame Time: 80\n0\n")
    assert tk.bvh.load(path, unit=0.01, up="y").fps == pytest.approx(1 / 80)


PLANTED = ("<img src=x onerror=window.hacked=1>", "</script><script>window.hacked=1</script>", "<!--<script>", "$\\frac$",
           "a%{x}b")


def test_no_text_from_outside_reaches_html_as_html(walk_clip, tmp_path):
    pytest.importorskip("ipywidgets")
    from toolkit.view import figures, frontend, page, phase_figures, picture, player

    clips = [walk_clip.cut(0, 60).replace(style=text) for text in PLANTED]
    written = page.html(clips, tmp_path / "page.html", title=PLANTED[0], caption=PLANTED[1], labels=PLANTED,
                        styles=[{text: torch.ones(60) for text in PLANTED}] * len(clips)).read_text("utf-8")
    assert "<img" not in written
    data = written.split('id="data">')[1].split("</script>")[0]
    assert "<" not in data
    assert [clip["label"] for clip in json.loads(data)["clips"]] == list(PLANTED)

    shown = player.Player(clips, size=(160, 120))
    assert "<img" not in shown._title.value
    assert shown._title.value.count("<") == 2  # of its own <b>
    shown.close()
    picture.strip(clips[3], labels=[PLANTED[3]])._repr_png_()  # no formula

    points = torch.rand(len(PLANTED), 2)
    rows = [{"step": 1, **dict.fromkeys(PLANTED, 1.0)}]
    phases = dict.fromkeys(PLANTED, tk.phases.extract(walk_clip))
    for figure in (figures.style_space(points, PLANTED, PLANTED, marked={PLANTED[0]: [0, 0]}, title=PLANTED[0]),
                   figures.training_curves(rows, title=PLANTED[0]), figures.trajectory_figure(clips, title=PLANTED[0]),
                   phase_figures.phase_manifold(phases, walk_clip.fps, title=PLANTED[0])):
        assert not {text for text in PLANTED[:3] if text in json.dumps(figure.to_dict(), default=str)}
        assert "%{x}b" not in str([trace.hovertemplate for trace in figure.data])
    assert frontend.escape(PLANTED[0]) == "&lt;img src=x onerror=window.hacked=1&gt;"


def test_an_error_in_a_widget_is_shown_as_text(walk_clip):
    pytest.importorskip("ipywidgets")
    from toolkit.networks.bank import StyleBank
    from toolkit.view.style_blender import StyleBlender

    def fails(_blend):
        raise ValueError(f"{PLANTED[0]}.bvh: cannot be read")

    async def drag():
        shown = StyleBlender(StyleBank(("A", "B", "C"), torch.eye(3)), lambda _blend: walk_clip.cut(0, 30), size=(160, 120))
        shown._make_clip = fails
        shown.triangle.weights = [0.0, 1.0, 0.0]
        for _ in range(200):
            await asyncio.sleep(0.02)
            if "ValueError" in shown._status.value:
                break
        shown.close()
        return shown._status.value

    assert asyncio.run(drag()) == "<b>ValueError</b>: &lt;img src=x onerror=window.hacked=1&gt;.bvh: cannot be read"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
def test_only_regular_files_are_read_and_written(tmp_path):
    os.mkfifo(tmp_path / "pipe.bvh")
    (tmp_path / "endless.bvh").symlink_to("/dev/zero")
    for name in ("pipe.bvh", "endless.bvh"):
        for read in (tk.load, tk.bvh.load, tk.training.load):
            with pytest.raises(ValueError, match=rf"{name}: cannot be read \(a device, pipe or socket is no file\)"):
                read(tmp_path / name)
        with pytest.raises(OSError, match="a device, pipe or socket is no file"), atomic_write(tmp_path / name):
            pass
        assert not (tmp_path / name).is_file()
    with pytest.raises(OSError, match="cannot be written"), atomic_write(tmp_path):
        pass
    assert sorted(path.name for path in tmp_path.iterdir()) == ["endless.bvh", "pipe.bvh"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
@pytest.mark.parametrize("kind", ["pipe", "endless"])
def test_devices_behind_references_are_not_read(kind, walk_clip, tmp_path):
    """A file beside the one that is read: a skeleton, a buffer, a table, a manifest. Without a check, reading never ends."""
    from toolkit.datasets import leaks, parameters, style100
    from toolkit.features import store

    def plant(path: Path) -> Path:
        path.parent.mkdir(exist_ok=True)
        os.mkfifo(path) if kind == "pipe" else path.symlink_to("/dev/zero")
        return path

    (tmp_path / "a.amc").write_text(":FULLY-SPECIFIED\n1\nroot 0 0 0 0 0 0\n")
    plant(tmp_path / "a.asf")
    plant(tmp_path / "a.bin")
    document = {"asset": {"version": "2.0"}, "buffers": [{"uri": "a.bin", "byteLength": 8}],
                "bufferViews": [{"buffer": 0, "byteLength": 8}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "type": "SCALAR", "count": 2}],
                "nodes": [{"name": "a"}, {"name": "b", "children": [0]}],
                "animations": [{"samplers": [{"input": 0, "output": 0}],
                                "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}]}
    (tmp_path / "a.gltf").write_text(json.dumps(document))
    plant(tmp_path / "table" / "Frame_Cuts.csv")
    plant(tmp_path / "store" / "manifest.json")
    plant(tmp_path / "parameters" / "Xmean.bin")
    for read in (lambda: tk.load(tmp_path / "a.amc"), lambda: tk.load(tmp_path / "a.gltf"),
                 lambda: tk.io.amc.read(tmp_path / "a.asf"), lambda: tk.io.fbx.read(tmp_path / "a.asf"),
                 lambda: tk.io.npz.read(tmp_path / "a.bin"), lambda: style100.frame_cuts(tmp_path / "table"),
                 lambda: leaks.find(tmp_path / "a.bin"), lambda: store.load(tmp_path / "store"),
                 lambda: parameters.check(tmp_path / "parameters")):
        with pytest.raises((ValueError, OSError)) as said:
            read()
        assert str(tmp_path) in f"{said.value} {getattr(said.value, 'filename', '')}"


@pytest.mark.parametrize("text", ["[" + "[]," * 1_500_000 + "0]", "[" * 100_000, '{"a":' * 50_000 + "0" + "}" * 50_000,
                                  "[" * 101 + "]" * 101, "9" * 5000], ids=range(5))
def test_json_text_of_many_or_deep_values_is_refused(text, tmp_path):
    from toolkit.datasets import leaks
    from toolkit.features import store

    path = tmp_path / "manifest.json"
    path.write_text(text)
    for read, place in ((leaks.find, path), (tk.shots.load, path), (store.load, tmp_path)):
        with pytest.raises(ValueError, match=r"manifest\.json.*(2000000 values|nested too deeply|thousands of digits)"):
            read(place)


def shot_file(folder: Path, **fields) -> Path:
    path = folder / "shots.json"
    shot = {"path": [[0, 0], [0, 2]], "styles": "Neutral", "duration": 1} | fields
    path.write_text(json.dumps({"version": 1, "shots": [shot]}))
    return path


def test_a_shot_has_no_path_beyond_what_can_be_walked(tmp_path):
    path = shot_file(tmp_path, path=[[(-1) ** k * 999, k] for k in range(20)])
    with pytest.raises(ValueError, match=r"shots\.json: shots\[0\]: path: is 379.. m long, a path has at most 12000 m"):
        tk.shots.load(path)


@pytest.mark.parametrize("value", [functools.reduce(lambda held, _: [held], range(80), []), "x" * 10**6,
                                   ["\x1b[31m" * 10**5], {"\x1b[31m" * 10**5: 1}], ids=range(4))
def test_a_wrong_value_in_a_shot_is_shown_in_a_short_line(value, tmp_path):
    _, bank = tk.pretrained()
    for fields in ({"path": [[value, 0], [0, 2]]}, {"seed": value}, {"styles": [[0, value]]}, {"name": value}):
        with pytest.raises(ValueError, match=r"shots\.json: shots\[0\]|unknown style") as said:
            tk.shots.load(shot_file(tmp_path, **fields)).pop().plan(bank)
        assert str(said.value).isprintable()
        assert len(str(said.value)) < 1000


def test_a_style_that_a_file_of_shots_names_wrongly_is_said_with_the_file(tmp_path, capsys):
    path = shot_file(tmp_path, styles="Neutrl")
    assert main(["shot", str(path), "--out", str(tmp_path / "a.bvh")]) == 2
    assert capsys.readouterr().err.startswith(f"error: {path}: shots[0]: unknown style 'Neutrl'; close to it: Neutral")


def test_the_leaks_of_a_large_split_are_found_in_time_and_a_thousand_are_listed(tmp_path):
    from toolkit.datasets import leaks

    def split(count: int, apart: int) -> dict:
        return {part: [["a", "FW", first + apart * k, first + apart * k + 9] for k in range(count)]
                for part, first in (("train", 0), ("test", apart // 2))}

    assert leaks.find(split(40_000, 1000)) == []
    assert timed(leaks.find, split(40_000, 1000)) < 24 * timed(leaks.find, split(5_000, 1000)) + 0.1
    found = leaks.find(split(4000, 0))
    assert len(found) == 1001
    assert found[-1] == "and more: only 1000 leaks are listed"
    (line,) = leaks.find({"train": [["a\x1b[31m" * 1000, "F\nW", 0, 9]], "test": [["a\x1b[31m" * 1000, "F\nW", 0, 9]]})
    assert line.isprintable()
    assert len(line) < 500


@pytest.mark.parametrize("change", [
    {"train": "abc"}, {"train": 7}, {"train": {"a": 1}}, {"unseen": [["a"]]}, {"gap": "x" * 10**6},
    {"train": [["x" * 10**6, 0]]}, {"train": [["a", "x" * 10**6, 5, "x" * 10**6]]}, {"train": [["a", "FW", 0, 10**400]]},
    {"train": [["a", "FW", False, True]]}], ids=range(9))
def test_what_is_no_split_is_refused_in_a_short_line(change):
    from toolkit.datasets import leaks

    with pytest.raises(ValueError, match=r"^split: (expected|block 0 of train)") as said:
        leaks.find({"train": [], "test": []} | change)
    assert len(str(said.value)) < 500


@pytest.mark.parametrize(("table", "said"), [
    (b"file,style\na.bvh," + b"x" * 200_000, r"line 2: field larger than field limit"),
    (b"", "line 1: expected the columns"), (b"file,style\na.bvh,\xff\n", "not UTF-8 text, from byte 17 on"),
    (b"file,style\na\0.bvh,b\n", "line 2: (line contains NUL|no file)"),
    (b"file,style\n" + b"a.bvh,b\n" * 500_001, "a table has at most 4000000"),
], ids=range(5))
def test_a_bad_table_of_labels_is_refused_in_one_line(table, said, walk_clip, tmp_path):
    from toolkit.datasets import folder

    tk.bvh.save(walk_clip.cut(0, 5), tmp_path / "a.bvh")
    (tmp_path / "labels.csv").write_bytes(table)
    with pytest.raises(ValueError, match=rf"labels\.csv.*{said}"):
        folder.labelled(tmp_path)


def test_a_measure_uses_the_unit_of_the_table(walk_clip, tmp_path, capsys):
    tk.bvh.save(walk_clip.cut(0, 60), tmp_path / "a.bvh")
    (tmp_path / "labels.csv").write_text("file,style,unit\na.bvh,Old,nan\n")
    assert main(["evaluate", str(tmp_path)]) == 2
    said = capsys.readouterr()
    assert said.out == "left out: a.bvh: unit is metres of one unit, or one of auto, m, cm, mm, inch, dm, CMU; got nan\n"
    assert "no motion file that can be measured" in said.err


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such file names")
def test_names_of_files_reach_the_terminal_without_control_characters(walk_clip, tmp_path, capsys):
    for name in ("good.bvh", "bad\x1b[31m.bvh"):
        tk.bvh.save(walk_clip.cut(0, 60), tmp_path / name)
    (tmp_path / "bad\x1b[31m.bvh").write_text("HIERARCHY\n")
    with pytest.raises(SystemExit, match="0"):
        main(["evaluate", str(tmp_path)])
    assert r"left out: bad\x1b[31m.bvh: " in capsys.readouterr().out


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such file names")
def test_doubts_about_a_file_name_it_without_control_characters(walk_clip, tmp_path, capsys):
    path = tmp_path / "doubtful\x1b[31m.bvh"
    tk.bvh.save(walk_clip.cut(0, 60), path)
    path.write_text(re.sub(r"Frame Time: .*", "Frame Time: 0.5", path.read_text()))
    with pytest.raises(SystemExit, match="0"):
        main(["export", "clip", str(path), "--out", str(tmp_path / "a.bvh"), "--unit", "0.03"])
    said = capsys.readouterr().err
    assert r"doubtful\x1b[31m.bvh: " in said
    assert "\x1b" not in said


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such locales")
def test_a_locale_that_is_not_utf_8_reads_styles_from_names_of_folders(walk_clip, tmp_path):
    """Styles from folders and from a table, whose columns name files; in the C locale names arrive as single bytes."""
    folder, listed = tmp_path / "歩く", tmp_path / "listed"
    for place in (folder / "مشي" / "é.bvh", listed / "é.bvh"):
        place.parent.mkdir(parents=True)
        tk.bvh.save(walk_clip.cut(0, 120), place)
    (listed / "labels.csv").write_text("file,style\né.bvh,Ärger\n", encoding="utf-8")
    command = ("import sys; from pathlib import Path; from toolkit.datasets import folder\n"
               "for at in sys.argv[1:]: print(ascii([take.style for take in folder.labelled(Path(at))[0]]))")
    env = os.environ | {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0",
                        "PYTHONPATH": str(Path(tk.__file__).parents[1])}
    done = subprocess.run([sys.executable, "-c", command, folder, listed], env=env, capture_output=True, text=True)
    assert done.stdout.split() == [ascii(["مشي"]), ascii(["Ärger"])], done.stderr


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root gives files away")
def test_writing_keeps_the_owner(tmp_path):
    path = tmp_path / "theirs"
    path.write_bytes(b"old")
    path.chmod(0o640)
    os.chown(path, 12345, 23456)
    with atomic_write(path) as file:
        assert not file.closed
        file.write(b"new")
    found = path.stat()
    assert (found.st_uid, found.st_gid, found.st_mode & 0o777) == (12345, 23456, 0o640)
    assert path.read_bytes() == b"new"


def test_everything_is_written_whole_or_not_at_all():
    """No other way to write a file but `atomic_write`, except the part of a download, which is for that."""
    found = set()
    for path in Path(tk.__file__).parent.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if re.search(r"write_text\(|write_bytes\(|tofile\(|(?<!av\.)open\([^)\n]*[\"'][wax]b?\+?[\"']", text):
            found.add(path.name)
    assert found == {"files.py", "download.py"}


@pytest.mark.skipif(os.name == "nt", reason="Windows has other permissions")
def test_writing_keeps_links_and_permissions(tmp_path):
    private, link, dangling = tmp_path / "private", tmp_path / "link", tmp_path / "dangling"
    private.write_bytes(b"old")
    private.chmod(0o600)
    link.symlink_to(private)
    dangling.symlink_to(tmp_path / "new")
    for path in (link, dangling):
        with atomic_write(path) as file:
            file.write(b"new")
        assert path.is_symlink()
    assert private.read_bytes() == (tmp_path / "new").read_bytes() == b"new"
    assert private.stat().st_mode & 0o777 == 0o600


def png(side: int) -> bytes:
    """The beginning of a picture that says how large it is."""
    head = b"IHDR" + struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    data = b"IDAT" + zlib.compress(b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(struct.pack(">I", len(x) - 4) + x + struct.pack(">I", zlib.crc32(x))
                                            for x in (head, data))


def with_picture(doc: Document, side: int) -> None:
    textured(doc, doc.json["meshes"][0]["primitives"][0], np.zeros((60, 2), "f4"), png(side))


def many_meshes(doc: Document, count: int) -> None:
    doc.json["meshes"].append({"primitives": [{"mode": 0}] * count})
    doc.json["nodes"][1]["children"] = [*range(3, 3 + count)]
    doc.json["nodes"].extend([{"mesh": 1}] * count)


@pytest.mark.parametrize(("spoil", "said"), [
    (lambda doc: with_picture(doc, 12_000), "too many pixels"), (lambda doc: with_picture(doc, 30_000), "too many pixels"),
    (lambda doc: doc.json["nodes"].extend([{}] * 50_000), "more than 50000 nodes"),
    (lambda doc: doc.json["skins"].extend([{"joints": [1]}] * 1000), "more than 1000 skins"),
    (lambda doc: doc.json["meshes"][0]["primitives"].extend(doc.json["meshes"][0]["primitives"] * 100_000), "vertices in"),
    (lambda doc: doc.json["skins"].extend([doc.json["skins"][0] | {"inverseBindMatrices": doc.wide}] * 50), "values from"),
    (lambda doc: many_meshes(doc, 5000), "vertices in"),
], ids=["large picture", "larger picture", "nodes", "skins", "primitives", "matrices", "nodes of many primitives"])
def test_a_character_takes_no_more_than_its_file_can_hold(spoil, said, tmp_path):
    doc = Document([{"name": "top", "children": [1]}, {"name": "hips"}, {"mesh": 0, "skin": 0}])
    points, weights = doc.add(np.zeros((60, 3), "f4")), doc.add(np.ones((60, 4), "f4"))
    attributes = {"POSITION": points, "WEIGHTS_0": weights, "JOINTS_0": doc.add(np.zeros((60, 4), "u1"))}
    doc.json |= {"skins": [{"joints": [1]}], "meshes": [{"primitives": [{"attributes": attributes}]}]}
    doc.wide = doc.add(np.ones((120_000, 4), "f4"))
    doc.json["accessors"][-1] |= {"type": "MAT4", "count": 30_000}
    spoil(doc)
    path = tmp_path / "a.glb"
    path.write_bytes(doc.glb())
    with pytest.raises(ValueError, match=rf"^{re.escape(str(path))}: .*{said}"):
        gltf_mesh.read(path)


@pytest.mark.parametrize("deep", [True, False])
def test_a_character_of_many_joints_of_one_name_is_read_in_time(deep, tmp_path):
    def made(count: int) -> Path:
        chain = [{"name": "a", "mesh": 0, "children": [j + 1]} for j in range(1, count)]
        flat = [{"name": "a", "mesh": 0} for j in range(1, count)]
        joints, below = (chain, [1]) if deep else (flat, [*range(1, count + 1)])
        doc = Document([{"children": below}, *joints, {"mesh": 1, "skin": 0}])
        attributes = {"POSITION": doc.add(np.zeros((1, 3), "f4")), "WEIGHTS_0": doc.add(np.ones((1, 4), "f4")),
                      "JOINTS_0": doc.add(np.zeros((1, 4), "u1"))}
        doc.json |= {"skins": [{"joints": [*range(1, count)]}],
                     "meshes": [{"primitives": []}, {"primitives": [{"attributes": attributes}]}]}
        (tmp_path / f"{count}.glb").write_bytes(doc.glb())
        return tmp_path / f"{count}.glb"

    names = gltf_mesh.read(made(300)).names
    assert len(set(names)) == len(names) >= 299
    assert timed(gltf_mesh.read, made(4000)) < 24 * timed(gltf_mesh.read, made(500)) + 0.1


@pytest.mark.parametrize("line", ["Frames: \u00b2", "Frames: " + "9" * 5000, "Frames: -1", "Frames:"])
def test_a_split_of_files_with_a_wrong_number_of_frames_names_the_file(line, tmp_path):
    for k in range(3):
        (tmp_path / f"dataset-1_walk_active_{k:03}.bvh").write_text(f"HIERARCHY\n{line}\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"_walk_active_\d+\.bvh: no line 'Frames: N'"):
        tk.datasets.split("bandai", tmp_path)


def test_what_cannot_be_written_is_said_before_the_work(walk_clip, tmp_path, capsys):
    tk.bvh.save(walk_clip.cut(0, 60), tmp_path / "a.bvh")
    for words in (("export", "pack", "--style", "Neutral", "--out", str(tmp_path / "a.bvh")),
                  ("evaluate", str(tmp_path), "--out", str(tmp_path))):
        assert main(list(words)) == 2
        said = capsys.readouterr()
        assert re.match(r"error: .*(is not a folder that can be written to|is a folder; a file name is needed)\n$", said.err)
        assert not said.out


def renamed(clip: tk.Clip, old: str, new: str) -> tk.Clip:
    """The clip with another name of a joint."""
    skeleton = clip.skeleton
    swap = {old: new}
    return clip.replace(skeleton=tk.Skeleton(
        [swap.get(name, name) for name in skeleton.names], skeleton.parents, skeleton.offsets,
        {role: swap.get(name, name) for role, name in skeleton.roles.items()}, [swap.get(x, x) for x in skeleton.ends]))


@pytest.mark.parametrize("name", ["a\nJOINT b", "a\rb", "a\x1b[31mb", "a\u2028b", "a\u202eb", "a\udc80b", "", 7])
def test_names_that_no_program_can_show_are_refused_where_they_enter(name, walk_clip):
    from toolkit.networks.bank import StyleBank

    with pytest.raises(ValueError, match="name") as said:
        renamed(walk_clip, walk_clip.skeleton.names[3], name)
    assert str(said.value).isprintable()
    with pytest.raises(ValueError, match="name"):
        StyleBank((name,), torch.zeros(1, 4))
    if name:
        with pytest.raises(ValueError, match="name"):
            walk_clip.replace(style=name)
    if isinstance(name, str):
        assert walk_clip.replace(name=name).name.isprintable()


KEPT = ("骨盤", "تكتب", "क्षि", "نیم\u200cفاصله", "MOTION", "JOINT", "End Site", "a b", "x}", " a",
        "a  b")


@pytest.mark.parametrize("name", KEPT)
def test_a_bvh_file_keeps_every_name_or_is_not_written(name, walk_clip, tmp_path):
    clip = renamed(walk_clip.cut(0, 5), walk_clip.skeleton.names[3], name)
    if "}" in name or name != " ".join(name.split()):
        with pytest.raises(ValueError, match="cannot hold the joint name"):
            tk.bvh.save(clip, tmp_path / "a.bvh")
        return
    tk.bvh.save(clip, tmp_path / "a.bvh")
    assert tk.bvh.load(tmp_path / "a.bvh", unit=0.01, up="y").skeleton.names[3] == name


def test_a_page_takes_a_joint_called_motion(tmp_path):
    from toolkit.view import live_page

    model, bank = tk.pretrained()
    layout = dataclasses.replace(model.layout, skeleton=renamed(
        tk.Clip(model.layout.skeleton, torch.eye(4)[:1].expand(1, len(model.layout.skeleton), 4), torch.zeros(1, 3), 60.0),
        model.layout.skeleton.names[3], "MOTION").skeleton)
    model.layout = layout
    packed = live_page.pack(model, bank.select(["Neutral"]))
    assert packed["bvh"]["header"].endswith("}\n")
    assert "JOINT MOTION" in packed["bvh"]["header"]


def test_a_file_name_that_is_not_utf_8_is_read_and_shown(walk_clip, tmp_path):
    path = Path(os.fsdecode(os.fsencode(tmp_path) + b"/walk\xff.bvh"))
    try:
        tk.bvh.save(walk_clip.cut(0, 5), path)
    except OSError:
        pytest.skip("this file system takes UTF-8 names only")
    clip = tk.bvh.load(path, unit=0.01, up="y")
    assert clip.name == "walk\\udcff.bvh"
    tk.view.html(clip, tmp_path / "a.html", title=path.name)


def timed(work, *given) -> float:
    """Least processor time of three runs, seconds."""
    def once() -> float:
        began = time.process_time()
        work(*given)
        return time.process_time() - began

    return min(once() for _ in range(3))


def tree(folder: Path, joints: int, ends: int, deep: bool) -> Path:
    """A BVH file with many joints or End Sites."""
    lines, open_ = ["HIERARCHY", "ROOT j0", "{", "OFFSET 0 0 0", "CHANNELS 1 Xrotation"], 1
    for j in range(1, joints):
        lines += [f"JOINT j{j}", "{", "OFFSET 0 1 0", "CHANNELS 1 Xrotation", *([] if deep else ["}"])]
        open_ += deep
    lines += ["End Site", "{", "OFFSET 0 1 0", "}"] * ends + ["}"] * open_
    lines += ["MOTION", "Frames: 1", "Frame Time: 0.01", " ".join("0" * joints)]
    path = folder / f"{joints}-{ends}-{deep}.bvh"
    path.write_text("\n".join(lines))
    return path


@pytest.mark.parametrize(("joints", "ends"), [(1, 2000), (2000, 1)])
def test_time_grows_with_the_file_and_not_with_its_square(joints, ends, tmp_path):
    small, large = (tree(tmp_path, joints * k if joints > 1 else 1, ends * k if ends > 1 else 1, False) for k in (1, 8))
    read = lambda path: tk.bvh.load(path, unit=0.01, up="y")  # noqa: E731
    read(small)
    assert timed(read, large) < 24 * timed(read, small) + 0.1


def test_a_bank_of_many_names_is_made_in_time():
    from toolkit.networks.bank import StyleBank

    def make(n: int) -> None:
        StyleBank(tuple(map(str, range(n))), torch.zeros(n, 2))

    assert timed(make, 32_000) < 24 * timed(make, 4_000) + 0.1


def test_a_long_chain_of_joints_is_read_and_written(tmp_path):
    clip = tk.bvh.load(tree(tmp_path, 1500, 1, True), unit=0.01, up="y")
    tk.bvh.save(clip, tmp_path / "copy.bvh")
    assert tk.bvh.load(tmp_path / "copy.bvh", unit=0.01, up="y").skeleton.names == clip.skeleton.names


@pytest.mark.parametrize("wrong", [{"turn": float("nan")}, {"move": [1.0]}, {"move": "ab"}, {"heading": [float("inf"), 0.0]},
                                   {"turn": None}, {"id": {}}, {"turn": 1e300}])
def test_a_controller_goes_on_after_a_message_of_the_wrong_kind(wrong):
    traitlets = pytest.importorskip("traitlets")
    pytest.importorskip("ipywidgets")
    from toolkit.view.controller import Controller

    control = Controller(*tk.pretrained())
    good = {"kind": "input", "id": 1, "move": [0.0, 1.0], "turn": 0.0, "run": False, "heading": None}
    control._handle_custom_msg(good, [])
    for message in (good | wrong, {}, {"kind": ["input"]}, [], "input", None):
        control._handle_custom_msg(message, [])
    with pytest.raises(traitlets.TraitError, match="finite"):
        control.speed = float("nan")
    control.advance(2)
    assert control._input["move"] == [0.0, 1.0]
    assert bool(control.state.root.isfinite().all())
    control.close()


@pytest.mark.parametrize("state", [
    *({"weights": weights} for weights in ([float("nan"), 0, 0], [float("inf"), 0, 0], [0, 0, 0], [1e308, 1e308, 1e308],
                                           ["a", 0, 0], [1, 0], None, [-5, 3, 3])),
    *({"names": names} for names in (["x", "y", "z"], [], [1, 2, 3])), {"speed": float("nan")}, {"speed": "a"}])
def test_a_controller_keeps_its_state_when_a_page_sends_a_wrong_one(state):
    traitlets = pytest.importorskip("traitlets")
    pytest.importorskip("ipywidgets")
    from toolkit.view.controller import Controller

    control = Controller(*tk.pretrained())
    before = control.names, control.weights, control.blend, control.speed
    with pytest.raises(traitlets.TraitError):
        control.set_state(state)
    assert (control.names, control.weights, control.blend, control.speed) == before
    control.advance(2)
    assert bool(control.state.root.isfinite().all())
    control.close()


def spoilt_model(value: float):
    model, bank = tk.pretrained()
    with torch.no_grad():
        model.experts.layers[1].bias[3, 7] = value
    return model, bank


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_weights_that_are_not_finite_are_not_written_or_read(value, tmp_path):
    from toolkit import view

    model, bank = spoilt_model(value)
    said = "not finite|must be finite"
    with pytest.raises(ValueError, match=said):
        view.web(model, bank, tmp_path / "page.html")
    pytest.importorskip("onnxscript")
    with pytest.raises(ValueError, match=said):
        tk.export.onnx.save(model, tmp_path / "a.onnx", bank)
    assert not list(tmp_path.iterdir())
    model.save(tmp_path / "model.safetensors")
    with pytest.raises(ValueError, match=r"model\.safetensors: the model is damaged \(the tensor experts.*not finite"):
        tk.networks.Model.load(tmp_path / "model.safetensors")


@pytest.mark.parametrize("unit", ["1e308", "1e30", "1e7", "1e-9", "1e-300"])
@pytest.mark.parametrize("suffix", [".png", ".glb", ".html", ".gif"])
def test_a_body_of_any_size_is_drawn_or_refused_in_one_line(unit, suffix, walk_clip, tmp_path, capsys):
    tk.bvh.save(walk_clip.cut(0, 5), tmp_path / "good.bvh")
    out = tmp_path / f"a{suffix}"
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        assert main(["export", "clip", str(tmp_path / "good.bvh"), "--out", str(out), "--unit", unit, "--up", "y"]) == 2
    error = capsys.readouterr().err.splitlines()[-1]
    assert re.match(r"error: good\.bvh: .*(not finite|at most 1e\+06 m|no bone)", error)
    assert not out.exists()


@pytest.mark.parametrize("unit", [1e308, 1e300, 1e30])
def test_a_body_of_any_size_is_inspected_or_refused_in_one_line(unit, walk_clip, tmp_path):
    tk.bvh.save(walk_clip.cut(0, 5), tmp_path / "good.bvh")
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        warnings.simplefilter("ignore", UserWarning)
        try:
            doubts = tk.inspect(tmp_path / "good.bvh", unit=unit).doubts
            assert any("m tall" in doubt or "m/s" in doubt for doubt in doubts)
        except ValueError as error:
            assert re.search(r"good\.bvh: .*not finite", str(error))  # noqa: PT017


STORED = ("../up", "split", "Old", "old", "a/b", "é 骨", "con", "x" * 200)


def test_a_store_takes_styles_of_any_name(walk_clip, tmp_path):
    from toolkit.features import store
    from toolkit.features.store import files

    folder, out = tmp_path / "in", tmp_path / "parts" / "out"
    folder.mkdir()
    rows = [f"{number}.bvh,{name},walk" for number, name in enumerate(STORED)]
    (folder / "labels.csv").write_text("\n".join(["file,style,gait", *rows]), encoding="utf-8")
    for number in range(len(STORED)):
        tk.bvh.save(walk_clip, folder / f"{number}.bvh")
    assert store.preprocess("folder", folder, out, workers=1)
    assert sorted(store.load(out, check=True).styles) == sorted(STORED)
    assert sorted(path.name for path in out.parent.iterdir()) == [".out.lock", "out"]
    stored = [path.name for path in out.iterdir()]
    assert len({name.casefold() for name in stored}) == len(stored) == len(STORED) + 2
    assert all(re.fullmatch(r"[A-Za-z0-9_.-]{1,120}", name) for name in stored)
    assert files.names(["Neutral", "Old-Man_2"]) == {"Neutral": "Neutral.safetensors", "Old-Man_2": "Old-Man_2.safetensors"}


def test_a_changed_store_is_found_when_its_checksums_are_looked_at(walk_clip, tmp_path):
    from toolkit.features import store

    (tmp_path / "in").mkdir()
    tk.bvh.save(walk_clip, tmp_path / "in" / "Neutral_walk.bvh")
    store.preprocess("folder", tmp_path / "in", tmp_path / "out", workers=1)
    path = next(path for path in (tmp_path / "out").glob("*.safetensors") if path.name != "split.safetensors")
    data = bytearray(path.read_bytes())
    data[-3] ^= 1
    path.unlink()
    path.write_bytes(data)
    assert store.load(tmp_path / "out").n_frames  # the sizes are right
    with pytest.raises(ValueError, match=rf"{path.name}: is not the file that was stored; run the command"):
        store.load(tmp_path / "out", check=True)
    assert main(["train", "--data", str(tmp_path / "out"), "--out", str(tmp_path / "run.safetensors"), "--small"]) == 2
    assert store.preprocess("folder", tmp_path / "in", tmp_path / "out", workers=1)
    assert store.load(tmp_path / "out", check=True).n_frames


@pytest.mark.parametrize("change", [{"style": "a\x1b[31mb"}, {"style": ""}, {"gait": "a\nb"}, {"gait": 7}])
def test_names_in_a_manifest_are_checked(change, walk_clip, tmp_path):
    from toolkit.features import store

    (tmp_path / "in").mkdir()
    tk.bvh.save(walk_clip, tmp_path / "in" / "Neutral_walk.bvh")
    store.preprocess("folder", tmp_path / "in", tmp_path / "out", workers=1)
    path = tmp_path / "out" / "manifest.json"
    manifest = json.loads(path.read_text())
    ((style, entry),) = manifest["partitions"].items()
    entry["clips"][0]["gait"] = change.get("gait", "walk")
    path.write_text(json.dumps(manifest | {"partitions": {change.get("style", style): entry}}))
    with pytest.raises(ValueError, match=r"manifest\.json: the manifest is damaged \(.*a (style|gait)") as said:
        store.load(tmp_path / "out")
    assert str(said.value).isprintable()


def test_columns_of_a_store_are_those_of_its_layout(walk_clip, tmp_path):
    from toolkit.features import store

    (tmp_path / "in").mkdir()
    tk.bvh.save(walk_clip, tmp_path / "in" / "Neutral_walk.bvh")
    store.preprocess("folder", tmp_path / "in", tmp_path / "out", workers=1)
    path = tmp_path / "out" / "manifest.json"
    manifest = json.loads(path.read_text())
    (entry,) = manifest["partitions"].values()
    layout = json.loads(entry["layout"])
    entry["layout"] = json.dumps(layout | {"ends": layout["ends"][1:]})  # one joint more has features
    path.write_text(json.dumps(manifest))
    with pytest.raises(ValueError, match=r"\.safetensors: this part of the store is damaged \(columns of joints: expected"):
        store.load(tmp_path / "out")


def test_a_file_name_that_cannot_be_shown_gives_no_style(walk_clip, tmp_path):
    from toolkit.datasets import folder

    (tmp_path / "a\x1b[31mb").mkdir()
    tk.bvh.save(walk_clip, tmp_path / "a\x1b[31mb" / "walk.bvh")
    with pytest.raises(ValueError, match=r"the name of a style of .* has characters that cannot be printed"):
        folder.survey(tmp_path)


@contextlib.contextmanager
def within(seconds: float):
    """Fails if what is inside waits or computes for longer."""
    def late(*_):
        raise AssertionError(f"took more than {seconds} s")

    signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
@pytest.mark.parametrize("name", ["a.bvh", "a.glb", "a.fbx", "a.npz", "a.amc", "shots.json"])
def test_a_name_that_leads_to_a_pipe_once_it_was_checked_is_not_waited_for(name, monkeypatch, tmp_path):
    """Another program may exchange a file between the look at it and its opening."""
    from toolkit.io import files

    path, status = tmp_path / name, files.status
    for beside in (path, tmp_path / "a.asf"):
        beside.write_bytes(b"old")

    def swapped(*given):
        found = status(*given)
        if not path.is_fifo():
            path.unlink()
            os.mkfifo(path)
        return found

    monkeypatch.setattr(files, "status", swapped)
    with within(20), pytest.raises((ValueError, OSError), match=r"a device, pipe or socket is no file|no section :root"):
        tk.shots.load(path) if path.suffix == ".json" else tk.load(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
def test_a_take_that_is_a_pipe_stops_the_preprocessing_in_one_line(walk_clip, tmp_path, capsys):
    for style in ("Old", "Neutral"):
        tk.bvh.save(walk_clip.replace(style=style), tmp_path / f"{style}_FW.bvh")
    for name, columns in tk.datasets.style100.TABLES.items():
        rows = [[style, *("N/A" if "FW" not in column else "0" if "START" in column else "480" for column in columns[1:])]
                for style in ("Old", "Neutral")] if name.startswith("Frame") else [["Old", "", "No", "No", ""]]
        (tmp_path / name).write_text("\n".join(map(",".join, [columns, *rows])), encoding="utf-8")
    (tmp_path / "Old_FW.bvh").unlink()
    os.mkfifo(tmp_path / "Old_FW.bvh")
    words = ["--data", "100style", "--root", str(tmp_path), "--out", str(tmp_path / "out")]
    with within(60):
        assert main(["preprocess", *words, "--workers", "1"]) == 2
    assert "Old_FW.bvh: a device, pipe or socket is no file" in capsys.readouterr().err


@pytest.mark.skipif(sys.platform != "linux", reason="these files are Linux's")
@pytest.mark.parametrize("suffix", [".bvh", ".glb", ".fbx", ".npz", ".npy", ".amc"])
def test_files_of_the_kernel_and_files_of_holes_are_refused(suffix, tmp_path):
    """The first kind says that it has no bytes, and may have no end; the second takes no disk, but memory if it is read."""
    hole, kernel = tmp_path / f"hole{suffix}", tmp_path / f"kernel{suffix}"
    (tmp_path / "hole.asf").write_text(":root\n:bonedata\n:hierarchy\n")
    (tmp_path / "kernel.asf").write_text(":root\n:bonedata\n:hierarchy\n")
    with hole.open("wb") as file:
        file.truncate(1 << 40)
    with pytest.raises(ValueError, match=rf"hole\{suffix}: cannot be read \(more than 4000000000 bytes"):
        tk.load(hole)
    for source in ("/proc/kmsg", "/proc/self/pagemap", "/proc/kcore"):
        if os.access(source, os.R_OK):
            kernel.unlink(missing_ok=True)
            kernel.symlink_to(source)
            with within(20), pytest.raises(ValueError, match=rf"kernel\{suffix}"):
                tk.load(kernel)


@pytest.fixture
def deep(walk_clip, tmp_path):
    """A folder with 1200 folders in each other and a take in the last; pytest could not remove it."""
    here, top = os.getcwd(), tmp_path / "top"
    top.mkdir()
    os.chdir(top)
    for _ in range(1200):
        os.mkdir("a")
        os.chdir("a")
    tk.bvh.save(walk_clip.cut(0, 5), "Old_FW.bvh")
    os.chdir(here)
    yield top
    os.chdir(top)
    for _ in range(1200):
        os.chdir("a")
    os.unlink("Old_FW.bvh")
    for _ in range(1200):
        os.chdir("..")
        os.rmdir("a")
    os.chdir(here)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no paths that long")
def test_a_thousand_folders_in_each_other_are_searched(deep, tmp_path):
    from toolkit.datasets import folder, style100

    assert [take.style for take in folder.labelled(deep)[0]] == ["a"]
    assert [take.style for take in style100.SOURCE.find(deep)] == ["Old"]
    with pytest.raises(ValueError, match=r"no Frame_Cuts\.csv"):
        style100.frame_cuts(deep)
    said = ["style", "add", "--clips", str(deep), "--name", "New", "--out", str(tmp_path / "m.safetensors")]
    assert main(said) == 2  # the clip is too short


def test_a_rate_of_megahertz_takes_no_memory_for_its_windows(walk_clip, tmp_path):
    with pytest.raises(ValueError, match="at most 10000, got 1e\\+07"):
        walk_clip.cut(0, 3).replace(fps=1e7)
    path = tree(tmp_path, 3, 1, True)
    path.write_text(path.read_text().replace("Frame Time: 0.01", "Frame Time: 1e-7"))
    with pytest.raises(ValueError, match=rf"{path.name}: frames per second"):
        tk.inspect(path)


def test_an_error_that_quotes_a_long_text_is_cut(walk_clip, tmp_path, capsys):
    tk.bvh.save(walk_clip.cut(0, 5), tmp_path / "a.bvh")
    for words in (["inspect", str(tmp_path / "a.bvh"), "--roles", "hips=" + "x" * 10**5], ["inspect", "x" * 10**5 + ".bvh"],
                  ["rollout", "--style", "x" * 10**5, "--seconds", "1", "--out", str(tmp_path / "b.bvh")]):
        assert main(words) == 2
        assert len(capsys.readouterr().err) < 1100


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".vrm", ".vrma"])
@pytest.mark.parametrize("held", [b"HIERARCHY\nROOT a\n", b"Kaydara FBX Binary  \0\x1a\xe8", b"\x89PNG\r\n", b"", b"PK\3\4"])
def test_a_file_with_the_ending_of_gltf_is_said_to_be_none(held, suffix, tmp_path):
    path = tmp_path / f"a{suffix}"
    path.write_bytes(held)
    with pytest.raises(ValueError, match=rf"a\{suffix}: no GLB file, and no JSON text \("):
        tk.load(path)


@pytest.mark.parametrize("height", ["nan", "inf", "1e308", "1.5", "-2"])
def test_a_contact_height_is_a_height(height, walk_clip, tmp_path, capsys):
    (tmp_path / "in").mkdir()
    tk.bvh.save(walk_clip, tmp_path / "in" / "Neutral_walk.bvh")
    words = ["preprocess", "--data", str(tmp_path / "in"), "--out", str(tmp_path / "out"), "--contact-height", height]
    assert main([*words, "--workers", "1"]) == 2
    assert "the contact height must be from -1 to 1 metres" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    with pytest.raises(ValueError, match="the contact height must be from -1 to 1 metres"):
        tk.contacts.detect(walk_clip, height=float(height))


@pytest.mark.parametrize("added", [7, "abc", None, {}])
def test_a_damaged_list_of_added_styles_is_said_before_the_work(added, tmp_path, walk_clip, capsys):
    from toolkit.io import model_files

    path = tmp_path / "m.safetensors"
    tensors, parts = model_files.read(Path(tk.training.__file__).parent / "pretrained.safetensors", "model")
    model_files.write(path, tensors, parts | {"added": added})
    tk.bvh.save(walk_clip, tmp_path / "a.bvh")
    words = ["style", "add", "--clips", str(tmp_path / "a.bvh"), "--name", "New", "--out", str(tmp_path / "n.safetensors")]
    with within(60):
        assert main([*words, "--model", str(path)]) == 2
    assert capsys.readouterr().err == f"error: {path}: its list of added styles is damaged\n"


def test_what_a_command_reads_is_not_written_over(walk_clip, tmp_path, capsys):
    clip, link, model = tmp_path / "a.bvh", tmp_path / "link.bvh", tmp_path / "m.safetensors"
    other = tmp_path / "b.bvh"
    for path in (clip, other):
        tk.bvh.save(walk_clip, path)
    link.symlink_to(clip)
    before = clip.read_bytes()
    stylize = ["stylize", "--clip", str(clip), "--domain", "old", "--reference", str(other), "--out"]
    for words in ([*stylize, str(clip)], [*stylize, str(link)], [*stylize, str(other)],
                  ["export", "clip", str(clip), "--out", str(link)],
                  ["export", "clip", str(other), "--skeleton", str(clip), "--out", str(clip)],
                  ["style", "add", "--clips", str(clip), "--name", "New", "--steps", "1", "--out", str(clip)],
                  ["style", "add", "--clips", str(tmp_path), "--name", "New", "--steps", "1", "--out", str(other)],
                  ["train", "--data", str(tmp_path), "--small", "--epochs", "0.01", "--out", str(clip)],
                  ["train-stylizer", "--data", str(tmp_path), "--small", "--iterations", "1", "--out", str(clip)],
                  ["evaluate", str(tmp_path), "--out", str(clip)],
                  ["data", "split", "100style", "--out", str(tmp_path / "Frame_Cuts.csv")]):
        assert main(words) == 2
        assert re.search("is a file that is read|is the name of a motion file|can write .json", capsys.readouterr().err)
    assert clip.read_bytes() == other.read_bytes() == before
    assert not model.exists()


def test_shots_of_a_scene_are_written_together_or_not_at_all(tmp_path, capsys):
    walks = [{"path": [[3 * k, 0], [3 * k, 2]], "styles": style, "duration": 0.1} for k, style in enumerate(("Old", "Nope"))]
    path = tmp_path / "shots.json"
    for more in ({}, {"apart": 1}):
        path.write_text(json.dumps({"version": 1, "shots": walks, **more}))
        assert main(["shot", str(path), "--out", str(tmp_path / "a.bvh")]) == 2
        assert capsys.readouterr().err.startswith(f"error: {path}: shots[1]: unknown style 'Nope'")
    (tmp_path / "a_1.bvh").mkdir()
    walks[1]["styles"] = "Old"
    path.write_text(json.dumps({"version": 1, "shots": walks}))
    assert main(["shot", str(path), "--out", str(tmp_path / "a.bvh")]) == 2
    assert "a_1.bvh: is a folder" in capsys.readouterr().err
    assert not (tmp_path / "a_0.bvh").exists()


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such file names")
def test_names_of_files_that_are_read_and_written_are_printed_without_control_characters(walk_clip, tmp_path, capsys):
    """All verbs print by one function, which escapes them."""
    bad = tmp_path / "a\x1b[31m\u202eb.bvh"
    tk.bvh.save(walk_clip, bad)
    shots, walk = shot_file(tmp_path, duration=0.1), ["rollout", "--style", "Old", "--seconds", "0.1"]
    for words in (["inspect", str(bad)], ["export", "clip", str(bad), "--out", f"{bad}.glb"],
                  [*walk, "--out", str(bad)], ["shot", str(shots), "--out", str(bad)]):
        with contextlib.suppress(SystemExit):
            assert main(words) == 0
        said = capsys.readouterr()
        assert "\\x1b[31m\\u202e" in said.out
        assert not {"\x1b", "\u202e"} & {*said.out, *said.err}
    assert "\x1b" not in repr(tk.inspect(bad, unit=0.01, up="y"))
    verbs = (Path(tk.__file__).parent / "cli").glob("*.py")
    assert [path.name for path in verbs if re.search(r"\bprint\(", path.read_text("utf-8"))] == ["verbs.py"]


MACHINES = {  # changes of the environment (None: without the variable), and options of Python
    "C locale": ({"LC_ALL": "C", "LANG": None, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}, ()),
    "ASCII output": ({"PYTHONIOENCODING": "ascii"}, ()),
    "no home": (dict.fromkeys(("HOME", "USERPROFILE", "XDG_CACHE_HOME", "XDG_DATA_HOME", "TOOLKIT_DATA")), ()),
    "without asserts": ({}, ("-O",)),
    "without docstrings": ({}, ("-OO",)),
}
VISITED = """
import sys
from toolkit.__main__ import main
source, out = sys.argv[1:]
sys.exit(main(["export", "clip", source, "--out", out]) or main(["inspect", out]))
"""


@pytest.mark.parametrize("machine", MACHINES)
def test_commands_run_on_odd_machines(machine, walk_clip, tmp_path):
    name, (changes, options) = "walk_歩く_مشي_é", MACHINES[machine]
    try:
        source, out = tmp_path / f"{name}.bvh", tmp_path / f"{name} copy.bvh"
        tk.bvh.save(renamed(walk_clip.cut(0, 30), walk_clip.skeleton.names[3], name), source)
    except UnicodeEncodeError:
        pytest.skip("file names on this machine are ASCII")
    env = {key: value for key, value in os.environ.items() if key not in changes}
    env |= {key: value for key, value in changes.items() if value is not None}
    env["PYTHONPATH"] = str(Path(tk.__file__).parents[1])
    command = [sys.executable, *options, "-c", VISITED, os.fsencode(source), os.fsencode(out)]
    done = subprocess.run(command, env=env, capture_output=True, cwd=tmp_path)
    assert b"Traceback" not in done.stderr, done.stderr.decode(errors="replace")[-400:]
    assert out.exists(), done.stderr
    assert name in tk.bvh.load(out, unit=0.01, up="y").skeleton.names
    if machine in ("C locale", "ASCII output"):
        assert done.stdout.isascii()
