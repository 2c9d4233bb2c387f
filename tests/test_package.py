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
from toolkit.__main__ import main

REPOSITORY = Path(__file__).parents[1]


@pytest.fixture
def refused(capsys):
    """Calls the command line with bad input and gives the one line that it says."""

    def call(*arguments):
        assert main([str(a) for a in arguments]) == 2
        said = capsys.readouterr().err.strip()
        assert "\n" not in said
        return said

    return call


def test_the_command_line_exits_with_one_line_on_bad_input():
    call = [sys.executable, "-m", "toolkit", "data", "table1", "--root", "nowhere"]
    done = subprocess.run(call, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.fullmatch(r"error: .*nowhere.*\n", done.stderr)


def test_import_pulls_in_no_drawing_library():
    unwanted = {"matplotlib", "pyvista", "plotly", "ipywidgets", "IPython"}
    code = f"import sys, toolkit; print([m for m in {unwanted} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_environment_lists_what_the_package_needs():
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]
    conda = {"torch": "pytorch", "playwright": "playwright-python"}
    needed = {re.sub(r"^[a-z-]+", lambda name: conda.get(name[0], name[0]), d)
              for d in project["dependencies"] + project["optional-dependencies"]["dev"]}  # fmt: skip
    *listed, from_pip = yaml.safe_load((REPOSITORY / "environment.yml").read_text())["dependencies"]
    listed = {*listed, *from_pip["pip"]} - {"--editable ."}
    assert listed - {"pip", "python>=3.11"} == needed
    assert f"python{project['requires-python']}" in listed


def test_every_dependency_is_pinned():
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]
    pins = (REPOSITORY / "constraints.txt").read_text().splitlines()
    pinned = {line.split("==")[0].lower().replace("_", "-") for line in pins}
    needed = {re.split(r"[>=\[]", d)[0] for d in project["dependencies"] + project["optional-dependencies"]["dev"]}
    assert needed <= pinned


def test_pretrained_knows_every_style_and_stands_when_told():
    model, bank = tk.pretrained()
    assert set(bank.names) == set(tk.datasets.procedural.STYLES)
    assert (REPOSITORY / "toolkit" / "data" / "pretrained.safetensors").stat().st_size < 15e6
    vectors = torch.stack([bank[name] for name in bank.names])
    stop = [*tk.runtime.straight(1.0, 1.5), *tk.runtime.straight(0.0, 3.0)]
    places = torch.stack([s.root[:, :2] for s in tk.runtime.states(model, stop, vectors)])
    assert (places[89] - places[0]).norm(dim=-1).min() > 0.3
    drift = (places[-1] - places[-91]).norm(dim=-1)  # metres in 1.5 s; 0.18 without `steering.RETURN`
    assert drift.mean() < 0.09
    assert drift.max() < 0.25


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


def test_rollout_writes_what_the_suffix_says(tmp_path, small_run, capsys):
    run = tmp_path / "run.safetensors"
    small_run.save(run)
    for suffix in ("bvh", "html", "png"):
        out = tmp_path / "new" / f"walk.{suffix}"
        with pytest.raises(SystemExit) as done:
            main([*f"rollout --model {run} --style Neutral=0.5,Zombie=0.5 --seconds 0.5 --out {out}".split()])
        assert done.value.code == 0
        assert out.stat().st_size > 1000
        assert re.search(r"30 frames, \d\.\d\d m/s", capsys.readouterr().out)


def test_bad_input_gets_one_line_and_leaves_nothing(tmp_path, small_run, refused):
    run, cut, junk, empty = (tmp_path / name for name in ("run.safetensors", "cut.bvh", "junk.safetensors", "empty"))
    small_run.save(run)
    cut.write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n")
    junk.write_bytes(b"junk")
    empty.mkdir()
    walk = ("rollout", "--out", tmp_path / "out.bvh", "--model", run, "--style")
    assert "cut.bvh, line" in refused("bench", "one-step", "--model", run, "--clip", cut, "--style", "Neutral")
    assert "unknown style 'Zombi'; close to it: Zombie" in refused(*walk, "Zombi")
    assert "sum to 1" in refused(*walk, "Zombie=0.5,Neutral=0.1")
    assert "written like" in refused(*walk, "Zombie=much")
    assert "can write .bvh, .html, .png, .mp4" in refused("rollout", "--style", "Zombie", "--out", tmp_path / "out.avi")
    assert "either --model" in refused(*walk, "Zombie", "--published", empty)
    assert "not a whole safetensors" in refused(*walk, "Zombie", "--model", junk)
    assert "Xmean.bin: missing" in refused("rollout", "--published", empty, "--style", "a", "--out", tmp_path / "out.bvh")
    assert "Frame_Cuts.csv" in refused("data", "table1", "--root", empty)
    assert "unknown" in refused("train", "--data", "procedural", "--styles", "Zombi", "--out", tmp_path / "new.safetensors")
    assert {p.name for p in tmp_path.iterdir()} == {"cut.bvh", "empty", "junk.safetensors", "run.safetensors"}


def test_a_checkpoint_of_another_layout_is_refused(tmp_path, small_run, walk_clip):
    small_run.save(tmp_path / "run.safetensors")
    other = tk.features.Layout(walk_clip.without_ends().skeleton)
    with pytest.raises(ValueError, match=r"run\.safetensors: the layout differs"):
        tk.networks.Model.load(tmp_path / "run.safetensors", layout=other)


def test_the_demo_works_on_a_small_budget(tmp_path):
    from toolkit import demo

    assert "toolkitScene" in demo.greet(tmp_path / "demo").read_text(encoding="utf-8")
    made = demo.make(seconds=2.0, data_seconds=10.0)
    files = demo.write(made, tmp_path / "demo")
    assert [f.name for f in files] == ["walk.bvh", "walk.html", "strip.png", "report.txt", "model.safetensors"]
    assert len(tk.bvh.load(files[0])) == len(made.clip)
    assert not re.search(r"""(src|href)\s*=\s*["']?https?:""", files[1].read_text())
    assert torch.tensor([*made.weights.values()]).sum(0).sub(1).abs().max() < 1e-5
    assert files[3].read_text().count("\n") == len(made.report)
