"""The package as a whole: what it imports, what it needs, and what the command line says to bad input."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import torch
import yaml

import toolkit as tk

REPOSITORY = Path(__file__).parents[1]


def command(*arguments):
    """Run the command line as a person does."""
    return subprocess.run([sys.executable, "-m", "toolkit", *map(str, arguments)], capture_output=True, text=True, check=False)


def refused(*arguments):
    """The one line that bad input gets."""
    done = command(*arguments)
    assert done.returncode != 0
    lines = [line for line in done.stderr.splitlines() if line.strip()]
    assert len(lines) == 1, done.stderr
    assert "Traceback" not in done.stderr
    return lines[0]


def test_import_pulls_in_no_drawing_library():
    code = ("import sys, toolkit; "
            "print([m for m in ('matplotlib', 'pyvista', 'plotly', 'ipywidgets', 'IPython') if m in sys.modules])")  # fmt: skip
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_environment_lists_what_the_package_needs():
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]
    needed = {d.replace("torch>", "pytorch>") for d in project["dependencies"] + project["optional-dependencies"]["dev"]}
    listed = {d for d in yaml.safe_load((REPOSITORY / "environment.yml").read_text())["dependencies"] if isinstance(d, str)}
    assert listed - {"pip", "python>=3.11"} == needed
    assert f"python{project['requires-python']}" in listed


def test_every_dependency_is_pinned():
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]
    pinned = {line.split("==")[0].lower().replace("_", "-") for line in (REPOSITORY / "constraints.txt").read_text().splitlines()}
    needed = {re.split(r"[>=\[]", d)[0] for d in project["dependencies"] + project["optional-dependencies"]["dev"]}
    assert needed <= pinned


def test_pretrained_walks_in_the_style_that_is_asked_for():
    model, bank = tk.pretrained()
    assert {"Neutral", "Zombie", "Aeroplane", "Crouch"} <= set(bank.names)
    heights = {}
    for style in ("Neutral", "Zombie", "Crouch"):
        clip = tk.runtime.rollout(model, tk.runtime.straight(speed=1.0, seconds=8.0), bank[style])
        assert tk.metrics.upright(clip)
        assert tk.metrics.speed(clip.cut(240)) == pytest.approx(1.0, abs=0.25)
        hands = clip.global_positions[240:, [clip.skeleton.index(f"{side}_hand") for side in ("left", "right")], 1]
        heights[style] = float(hands.mean()), float(clip.root_positions[240:, 1].mean())
    assert heights["Zombie"][0] > heights["Neutral"][0] + 0.2  # arms raised
    assert heights["Crouch"][1] < heights["Neutral"][1] - 0.1  # hips low


def test_rollout_writes_what_the_suffix_says(tmp_path, small_run):
    small_run.save(tmp_path / "run.safetensors")
    for suffix in ("bvh", "html", "png"):
        out = tmp_path / "new" / f"walk.{suffix}"
        done = command("rollout", "--model", tmp_path / "run.safetensors", "--style", "Neutral=0.5,Zombie=0.5", "--seconds", 0.5,
                       "--out", out)  # fmt: skip
        assert done.returncode == 0, done.stderr
        assert out.stat().st_size > 1000
        assert re.search(r"30 frames, \d\.\d\d m/s", done.stdout)


def test_bad_input_gets_one_line_and_leaves_nothing(tmp_path, small_run):
    small_run.save(tmp_path / "run.safetensors")
    (tmp_path / "cut.bvh").write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n")
    (tmp_path / "empty").mkdir()
    (tmp_path / "junk.safetensors").write_bytes(b"junk")
    run, out = tmp_path / "run.safetensors", tmp_path / "out.bvh"
    assert "cut.bvh, line" in refused("bench", "one-step", "--model", run, "--clip", tmp_path / "cut.bvh", "--style", "Neutral")
    assert "unknown style 'Zombi'; close to it: Zombie" in refused("rollout", "--model", run, "--style", "Zombi", "--out", out)
    assert "sum to 1" in refused("rollout", "--model", run, "--style", "Zombie=0.5,Neutral=0.1", "--out", out)
    assert "written like" in refused("rollout", "--model", run, "--style", "Zombie=much", "--out", out)
    assert ".bvh, .html and .png" in refused("rollout", "--model", run, "--style", "Zombie", "--out", tmp_path / "out.mp4")
    assert "either --model" in refused("rollout", "--style", "Zombie", "--out", out)
    assert "not a whole safetensors" in refused("rollout", "--model", tmp_path / "junk.safetensors", "--style", "a", "--out", out)
    assert "Xmean.bin: missing" in refused("rollout", "--published", tmp_path / "empty", "--style", "Zombie", "--out", out)
    assert "empty" in refused("data", "table1", "--root", tmp_path / "empty")
    assert "unknown" in refused("train", "--data", "procedural", "--styles", "Zombi", "--out", tmp_path / "new.safetensors")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["cut.bvh", "empty", "junk.safetensors", "run.safetensors"]


def test_a_checkpoint_of_another_layout_is_refused(tmp_path, small_run, walk_clip):
    small_run.save(tmp_path / "run.safetensors")
    other = tk.features.Layout(walk_clip.without_ends().skeleton)
    with pytest.raises(ValueError, match=r"run\.safetensors: the layout differs"):
        tk.networks.Model.load(tmp_path / "run.safetensors", layout=other)


def test_the_demo_works_on_a_small_budget(tmp_path):
    from toolkit import demo

    made = demo.make(seconds=2.0, data_seconds=10.0)
    files = demo.write(made, tmp_path / "demo")
    assert [f.name for f in files] == ["walk.bvh", "walk.html", "strip.png", "report.txt", "model.safetensors"]
    assert len(tk.bvh.load(files[0])) == len(made.clip)
    assert not re.search(r"""(src|href)\s*=\s*["']?https?:""", files[1].read_text())
    assert torch.tensor([*made.weights.values()]).sum(0).sub(1).abs().max() < 1e-5
    assert files[3].read_text().count("\n") == len(made.report)
