"""Hostile files, names and machines: what comes from outside is refused in one line, or read
without harm.
"""

import dataclasses
import json
import os
import re
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest
import torch
from motion_files import Document
from refusal import refusal
from robustness import fuzz
from safetensors.torch import save_file

import toolkit as tk
from toolkit import networks
from toolkit.evaluation.recognition import Recogniser
from toolkit.extra import store
from toolkit.extra.formats import gltf
from toolkit.io import model_files
from toolkit.io.files import atomic_write
from toolkit.networks import Sizes
from toolkit.networks.bank import StyleBank


def test_sizes_in_a_model_file_take_no_memory_before_they_are_checked(tmp_path):
    """With a gigabyte at most: what was asked for is more."""
    path = tmp_path / "run.safetensors"
    tk.pretrained().save(path)
    tensors, parts = model_files.read(path, "run")
    parts["model"]["sizes"]["hidden"] = 20_000
    model_files.write(path, tensors, parts)
    with fuzz.limited(), refusal(r"the model.*differs in tensor"):
        tk.training.load(path)


def test_weights_that_are_not_finite_are_not_written_or_read(tmp_path):
    from toolkit import view

    model, bank = tk.pretrained()
    with torch.no_grad():
        model.experts.layers[1].bias[3, 7] = float("nan")
    with refusal(r"not finite|must be finite"):
        view.web(model, bank, tmp_path / "page.html")
    assert not list(tmp_path.iterdir())
    tk.training.Run(model, bank).save(tmp_path / "model.safetensors")
    with refusal(r"model\.safetensors: .* damaged \(the tensor model.*not finite"):
        tk.training.load(tmp_path / "model.safetensors")


@pytest.mark.parametrize(("name", "value", "why"), [
    ("model.inputs_std", lambda t: t * 0, "deviations that are not positive"),
    ("model.outputs_mean", lambda t: t + 1e30, "not finite, or beyond 1e+30"),
    ("model.experts.layers.0.weight", lambda t: t.long(), "expected 'float', got torch.int64"),
    ("bank.vectors", lambda t: t[:, :4], "style vectors [4] of a model that takes"),
    ("bank.speeds", lambda t: t / 0, "bank.speeds has numbers that are not finite"),
    ("bank", lambda names: "ab"[: len(names)], "expected a list of names, got the text 'ab'"),
    ("n_styles", lambda _: 2**62, "a model has 1 to 100000 styles, got"),
    ("n_styles", lambda _: True, "a model has 1 to 100000 styles, got True"),
    ("layout", lambda of: of | {"offsets": [[1e30] * 3] * len(of["names"])}, "at most 1e+06 m"),
    ("layout", lambda of: of | {"phase_limbs": ["left_hand", 1]}, "must be named by a text, got 1"),
    ("history", lambda _: "abc", "its history is 'abc'"),
])
def test_models_of_numbers_that_no_training_makes_are_refused(name, value, why, tmp_path):
    path = tmp_path / "run.safetensors"
    sizes = Sizes(hidden=8, experts=2, gating=4, film_channels=4, film_kernel=5, film_dense=8)
    model = networks.build("lpn-film", tk.pretrained().model.layout, 2, sizes)
    bank = StyleBank(("a", "b"), torch.zeros(2, model.style_size), torch.ones(2))
    tk.training.Run(model, bank).save(path)
    tensors, parts = model_files.read(path, "run")
    for of in (tensors, parts, parts["model"], parts["run"]):
        if name in of:
            of[name] = value(of[name])
    model_files.write(path, tensors, parts)
    with refusal(re.escape(why)) as error:
        tk.training.load(path)
    assert str(error.value).startswith(f"{path}: ")


def test_a_description_of_more_than_16_megabytes_is_refused_before_it_is_parsed(tmp_path):
    """Parsed, each of its values would take up to 70 bytes (`toolkit.io.files.parsed`)."""
    path, most = tmp_path / "a.safetensors", model_files.METADATA
    about = {"format": model_files.FORMAT, "recogniser": f"[{'0,' * (most // 2 + 1)}0]"}
    save_file({"a": torch.zeros(1)}, path, about)
    with fuzz.limited(), refusal(r"its metadata is .*larger than"):
        Recogniser.load(path)


PLANTED = ("<img src=x onerror=window.hacked=1>", "</script><script>window.hacked=1</script>",
           "<!--<script>", "$\\frac$", "a%{x}b")


def test_no_text_from_outside_is_html_or_a_formula_in_a_chart(walk_clip, monkeypatch):
    """Of pages: test_view.py, extra/test_director.py and the tests in a browser."""
    from course import charts

    from toolkit.view.render import picture, stage

    monkeypatch.setattr(stage, "opengl_works", lambda: False)  # which takes seconds
    picture.strip(walk_clip, labels=[PLANTED[3]])._repr_png_()  # no formula
    figure = charts.style_space(torch.rand(5, 2), PLANTED, PLANTED, title=PLANTED[0])
    assert not {text for text in PLANTED[:3] if text in json.dumps(figure.to_dict(), default=str)}
    assert "%{x}b" not in str([trace.hovertemplate for trace in figure.data])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
def test_only_regular_files_are_read_and_written(tmp_path):
    os.mkfifo(tmp_path / "pipe.bvh")
    (tmp_path / "endless.bvh").symlink_to("/dev/zero")
    for name in ("pipe.bvh", "endless.bvh"):
        for read in (tk.load, tk.bvh.load, tk.training.load):
            with refusal(rf"{name}: cannot be read \(a device, pipe or socket"):
                read(tmp_path / name)
        with pytest.raises(OSError,
                           match="a device, pipe or socket"), atomic_write(tmp_path / name):
            pass
        assert not (tmp_path / name).is_file()
    with pytest.raises(OSError, match="cannot be written"), atomic_write(tmp_path):
        pass
    assert sorted(path.name for path in tmp_path.iterdir()) == ["endless.bvh", "pipe.bvh"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
@pytest.mark.parametrize("kind", ["pipe", "endless"])
def test_devices_behind_references_are_not_read(kind, tmp_path):
    """A file beside the one that is read: a buffer, a table, a manifest. Without a check, reading
    never ends.
    """
    def plant(path: Path) -> Path:
        path.parent.mkdir(exist_ok=True)
        os.mkfifo(path) if kind == "pipe" else path.symlink_to("/dev/zero")
        return path

    plant(tmp_path / "a.bin")
    made = Document([{"name": "a"}, {"name": "b", "children": [0]}])
    made.animate((0, "rotation", [0.0, 1.0], np.float32([[0, 0, 0, 1]] * 2), "LINEAR"))
    made.json["buffers"] = [{"uri": "a.bin", "byteLength": len(made.data)}]
    (tmp_path / "a.gltf").write_text(json.dumps(made.json))
    plant(tmp_path / "table" / "Frame_Cuts.csv")
    plant(tmp_path / "store" / "manifest.json")
    for read in (lambda: tk.load(tmp_path / "a.gltf"),
                 lambda: tk.shots.Scene.load(tmp_path / "a.bin"),
                 lambda: tk.datasets.style100.frame_cuts(tmp_path / "table"),
                 lambda: store.load(tmp_path / "store")):
        with pytest.raises((ValueError, OSError)) as said:
            read()
        assert str(tmp_path) in f"{said.value} {getattr(said.value, 'filename', '')}"


@pytest.mark.parametrize("text", ["[" + "[]," * 1_100_000 + "0]", "[" * 100_000, "9" * 5000],
                         ids=["many", "deep", "digits"])
def test_json_text_of_many_or_deep_values_is_refused(text, tmp_path):
    for name, read in (("manifest.json", tk.shots.Scene.load), ("manifest.gltf", gltf.read),
                       ("manifest.json", lambda path: store.load(path.parent))):
        (tmp_path / name).write_text(text)
        with refusal(rf"{name}.*(2000000 values|too deeply|of digits)"):
            read(tmp_path / name)


def test_everything_is_written_whole_or_not_at_all():
    """No other way to write a file but `atomic_write`, except the part of a download, which is for
    that.
    """
    found = set()
    for path in Path(tk.__file__).parent.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        opened = r"(?<!av\.)open\([^)\n]*[\"'][wax]b?\+?[\"']"
        if re.search(rf"write_text\(|write_bytes\(|tofile\(|{opened}", text):
            found.add(path.name)
    assert found <= {"files.py", "download.py", "fetch.py"}


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


def renamed(clip: tk.Clip, name: str) -> tk.Clip:
    """The clip with another name of joint 3, which has no role."""
    skeleton = clip.skeleton
    names = [*skeleton.names[:3], name, *skeleton.names[4:]]
    return clip.replace(skeleton=dataclasses.replace(skeleton, names=names))


@pytest.mark.parametrize("name", ["a\nJOINT b", "a\u202eb", "", 7])
def test_names_that_no_program_can_show_are_refused_where_they_enter(name, walk_clip):
    with refusal("name") as said:
        renamed(walk_clip, name)
    assert str(said.value).isprintable()
    with refusal("name"):
        StyleBank((name,), torch.zeros(1, 4))
    if name:
        with refusal("name"):
            walk_clip.replace(style=name)
    if isinstance(name, str):
        assert walk_clip.replace(name=name).name.isprintable()


@pytest.mark.parametrize("name", ["骨盤", "نیم\u200cفاصله", "MOTION", "End Site", "x}", " a"])
def test_a_bvh_file_keeps_every_name_or_is_not_written(name, walk_clip, tmp_path):
    clip = renamed(walk_clip.cut(0, 5), name)
    if "}" in name or name != " ".join(name.split()):
        with refusal("cannot hold the joint name"):
            tk.bvh.save(clip, tmp_path / "a.bvh")
        return
    tk.bvh.save(clip, tmp_path / "a.bvh")
    assert tk.bvh.load(tmp_path / "a.bvh", unit=0.01, up="y").skeleton.names[3] == name


def test_a_controller_goes_on_after_messages_of_the_wrong_kind(fast):
    traitlets = pytest.importorskip("traitlets")
    pytest.importorskip("ipywidgets")
    from toolkit.view.widgets.controller import Controller

    control, nan = Controller(*fast), float("nan")
    good = {"kind": "input", "id": 1, "move": [0.0, 1.0], "turn": 0.0, "run": False,
            "heading": None}
    control._handle_custom_msg(good, [])
    for message in (good | {"turn": nan}, good | {"move": [1.0]}, good | {"id": {}}, [],
                    good | {"id": 10**400}, {"kind": ["input"]}, "input", None):
        control._handle_custom_msg(message, [])
    assert control._input | {"kind": "input"} == good

    before = control.names, control.weights, control.blend, control.speed
    for state in ({"weights": [nan, 0, 0]}, {"weights": [1, 0]}, {"names": ["x", "y", "z"]},
                  {"speed": nan}):
        with pytest.raises(traitlets.TraitError):
            control.set_state(state)
        assert (control.names, control.weights, control.blend, control.speed) == before
    control.advance(2)
    assert control.state.root.isfinite().all()
    control.close()


@pytest.mark.parametrize("unit", ["1e308", "1e-9"])
def test_a_body_of_any_size_is_drawn_or_refused_in_one_line(unit, walk_clip, tmp_path, command):
    tk.bvh.save(walk_clip.cut(0, 5), tmp_path / "good.bvh")
    out = tmp_path / "a.html"
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        said = command(f"export clip {tmp_path}/good.bvh --out {out} --unit {unit} --up y",
                       status=2).err
    error = said.splitlines()[-1]
    assert re.match(r"error: good\.bvh: .*(not finite|at most 1e\+06 m|no bone)", error)
    assert not out.exists()


def test_a_file_of_holes_takes_no_memory(tmp_path):
    with (tmp_path / "hole.bvh").open("wb") as file:
        file.truncate(1 << 40)
    with refusal(r"cannot be read .more than 4000000000 bytes"):
        tk.load(tmp_path / "hole.bvh")


def test_an_error_that_quotes_a_long_text_is_cut(walk_clip, tmp_path, command):
    tk.bvh.save(walk_clip.cut(0, 5), tmp_path / "a.bvh")
    long = "x" * 10**5
    for words in (f"{tmp_path}/a.bvh --roles hips={long}", f"{long}.bvh"):
        assert len(command(f"inspect {words}", status=2).err) < 1100


def test_what_a_command_reads_is_not_written_over(walk_clip, tmp_path, command):
    clip, link, other = (tmp_path / name for name in ("a.bvh", "link.bvh", "b.bvh"))
    for path in (clip, other):
        tk.bvh.save(walk_clip, path)
    link.symlink_to(clip)
    before = clip.read_bytes()
    stylize = f"stylize --clip {clip} --domain old --reference {other} --out"
    add = "style add --name New --steps 1 --clips"
    for words in (f"{stylize} {link}", f"{stylize} {other}", f"export clip {clip} --out {link}",
                    f"export clip {other} --skeleton {clip} --out {clip}",
                    f"{add} {clip} --out {clip}", f"{add} {tmp_path} --out {other}",
                    f"train --data {tmp_path} --small --epochs 0.01 --out {clip}",
                    f"train-stylizer --data {tmp_path} --small --iterations 1 --out {clip}",
                    f"evaluate {tmp_path} --out {clip}",
                    f"data split 100style --out {tmp_path}/Frame_Cuts.csv"):
        assert re.search("is a file that is read|is the name of a motion file|can write .json",
                         command(words, status=2).err)
    assert clip.read_bytes() == other.read_bytes() == before


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such file names")
def test_names_of_files_that_are_read_and_written_are_printed_without_control_characters(
    walk_clip, tmp_path, command):
    """All verbs print by one function, which escapes them."""
    bad = tmp_path / "a\x1b[31m\u202eb.bvh"
    tk.bvh.save(walk_clip, bad)
    for words in (f"inspect {bad}", f"export clip {bad} --out {bad}.glb",
                  f"rollout --style Old --seconds 0.1 --out {bad}"):
        said = command(words)
        assert "\\x1b[31m\\u202e" in said.out
        assert not {"\x1b", "\u202e"} & {*said.out, *said.err}
    assert "\x1b" not in repr(tk.inspect(bad, unit=0.01, up="y"))
    verbs = (Path(tk.__file__).parent / "cli").glob("*.py")
    assert [path.name for path in verbs
            if re.search(r"\bprint\(", path.read_text("utf-8"))] == ["verbs.py"]


#: Variables that an odd machine lacks.
LACKS = {"LANG", "HOME", "USERPROFILE", "XDG_CACHE_HOME", "XDG_DATA_HOME", "TOOLKIT_DATA"}


def test_commands_run_on_an_odd_machine(walk_clip, tmp_path):
    """In the C locale, and without a home."""
    name = "walk_歩く_مشي_é"
    source, out = tmp_path / f"{name}.bvh", tmp_path / f"{name} copy.bvh"
    tk.bvh.save(renamed(walk_clip.cut(0, 30), name), source)
    env = {key: value for key, value in os.environ.items() if key not in LACKS}
    env |= {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0",
            "PYTHONPATH": str(Path(tk.__file__).parents[1])}
    command = [sys.executable, "-m", "toolkit", "export", "clip", source, "--out", out]
    done = subprocess.run(command, env=env, capture_output=True, cwd=tmp_path)
    assert not done.returncode, done.stderr.decode(errors="replace")[-400:]
    assert name in tk.bvh.load(out, unit=0.01, up="y").skeleton.names
    assert done.stdout.isascii()
