"""The package as a whole: what it imports, what it needs, and what the command line says to bad input."""

import ast
import os
import re
import shutil
import subprocess
import sys
import textwrap
import tomllib
import zipfile
from pathlib import Path

import pytest
import torch
import yaml

import toolkit as tk
from toolkit import __main__
from toolkit.__main__ import main

REPOSITORY = Path(__file__).parents[1]
DRAWING = {"IPython", "PIL", "anywidget", "av", "ipywidgets", "jupyter_client", "jupyterlab", "matplotlib", "pandas",
           "plotly", "pyvista", "sklearn", "vtkmodules"}


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
    call = [sys.executable, "-m", "toolkit", "data", "list", "100style", "--root", "nowhere"]
    done = subprocess.run(call, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.fullmatch(r"error: .*nowhere.*\n", done.stderr)


def python(code: str, **options) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, **options)


def loaded(code: str) -> set[str]:
    """Top-level modules that a process has after it ran the code."""
    done = python(f"import sys\n{code}\nprint(*{{name.split('.')[0] for name in sys.modules}})")
    assert done.returncode == 0, done.stderr
    return set(done.stdout.split())


def test_import_alone_pulls_in_nothing_heavy():
    code = "import time; began = time.perf_counter(); import toolkit; assert time.perf_counter() - began < 2"
    assert not loaded(code) & (DRAWING | {"torch", "numpy", "scipy", "numba", "lightning_fabric", "typer"})


def test_the_pipeline_pulls_in_no_drawing_library():
    code = "import toolkit as tk; tk.bvh, tk.features, tk.training, tk.runtime, tk.styles, tk.metrics, tk.pretrained"
    modules = loaded(code)
    assert "torch" in modules
    assert not modules & (DRAWING | {"lightning_fabric", "distributed", "onnx", "typer"})


def test_help_is_quick_and_says_what_the_verbs_say():
    assert "torch" not in loaded("from toolkit.__main__ import main\ntry: main(['--help'])\nexcept SystemExit: pass")
    for name, command in __main__.app.commands.items():
        own = " ".join(command.imported.help.split("\n\n")[0].split())
        assert own.startswith(__main__.VERBS[name][1].removesuffix(".")), name


def test_public_names_are_listed_and_there():
    assert {"Clip", "Skeleton", "pretrained", "bvh", "view", "runtime"} <= set(dir(tk)) == set(tk.__all__)
    for name in tk.__all__:
        assert getattr(tk, name) is not None
    assert tk.Clip is tk.motion.Clip
    assert tk.pretrained is tk.training.pretrained
    with pytest.raises(AttributeError, match="nothing"):
        tk.nothing  # noqa: B018


def test_the_package_has_at_most_sixteen_rooms():
    rooms = [path.name for path in (REPOSITORY / "toolkit").iterdir() if path.is_dir() and path.name != "__pycache__"]
    assert len(rooms) <= 16, rooms
    assert not [path.name for path in (REPOSITORY / "toolkit").glob("[!_]*.py")]


def test_every_module_is_an_attribute_of_its_package_right_after_import():
    """And nothing else has its name; in a fresh state for each package, as imports of one module bring others along."""
    code = """
        import pkgutil, sys, toolkit
        walk = pkgutil.walk_packages(toolkit.__path__, "toolkit.")
        packages = ["toolkit", *(m.name for m in walk if m.ispkg and m.name != "toolkit.cli")]  # cli is no library
        for package in packages:
            for name in [name for name in sys.modules if name.split(".")[0] == "toolkit"]:
                del sys.modules[name]
            import toolkit
            found = toolkit
            for part in package.split(".")[1:]:
                found = getattr(found, part)
            there = dict(vars(found))
            for name in {m.name for m in pkgutil.iter_modules(found.__path__)} - {"cli", "__main__"}:
                module = there[name] if name in there else found.__getattr__(name)
                assert module is sys.modules[f"{package}.{name}"], f"{package}.{name} is {module}"
    """
    done = python(textwrap.dedent(code))
    assert done.returncode == 0, done.stderr


def made(command: list[str], folder: Path, commands: dict[str, str]) -> subprocess.CompletedProcess:
    """A run of make that finds these commands alone, each a line of a shell, in a folder."""
    for name, line in commands.items():
        (folder / name).write_text(f"#!/bin/sh\n{line}\n", encoding="utf-8")
        (folder / name).chmod(0o755)
    return subprocess.run(command, cwd=REPOSITORY, env={"PATH": str(folder)}, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("works", "user", "called"), [(True, 0, 0), (False, 1000, 0), (False, 0, 2)])
def test_make_env_says_what_it_installs_into_the_system_before(tmp_path, works, user, called):
    make = shutil.which("make") or pytest.skip("no make here")
    commands = {"id": f"echo {user}", "python": f"exit {int(not works)}", "apt-get": 'echo "called $@"'}
    done = made([make, "opengl", f"BIN={tmp_path}"], tmp_path, commands)
    said, packages = done.stdout.splitlines(), "libegl1 libgl1-mesa-dri"
    assert done.returncode == 0
    assert said == ["Installing OpenGL into the system, as root: apt-get install " + packages, "called update -qq"][:called]
    plan = made([make, "--dry-run", "env", "VENV=nowhere"], tmp_path, commands).stdout
    assert plan.index("into the system by apt-get") < plan.index("pip install") < plan.index("-m toolkit.view.opengl")
    assert packages in plan


@pytest.mark.parametrize(("there", "user", "said", "status"), [
    ("chromium", 0, "{bin}/chromium", 0),
    ("google-chrome", 1000, "{bin}/google-chrome", 0),
    ("apt-get", 0, "Installing Chromium into the system, as root: apt-get install chromium", 0),
    ("apt-get", 1000, "Chromium is missing. Debian: sudo apt-get install chromium. Elsewhere: ", 2),
])
def test_make_chromium_finds_it_or_says_what_it_installs(tmp_path, there, user, said, status):
    make = shutil.which("make") or pytest.skip("no make here")
    commands = {"id": f"echo {user}", there: f'echo "$@" >> {tmp_path}/called'}
    done = made([make, "chromium"], tmp_path, commands)
    assert (done.returncode, len(done.stdout.splitlines())) == (status, 1)
    assert done.stdout.startswith(said.format(bin=tmp_path))
    called = tmp_path / "called"
    assert (called.read_text(encoding="utf-8").split() if called.exists() else []) == (
        ["update", "-qq", "install", "-qq", "--no-install-recommends", "chromium"] if said.startswith("Installing") else [])


def test_without_the_view_extra_one_line_names_it(tmp_path):
    code = f"""
        import sys
        from importlib.machinery import PathFinder
        find = PathFinder.find_spec
        PathFinder.find_spec = lambda name, *rest: None if name.split(".")[0] in {DRAWING} else find(name, *rest)
        from toolkit.__main__ import main
        sys.exit(main("rollout --style Zombie --seconds 0.1 --out walk.html".split()))
    """
    done = python(textwrap.dedent(code), cwd=tmp_path)
    assert done.returncode == 2
    said = done.stderr.strip().splitlines()[-1]  # after the progress bar
    assert re.fullmatch(r'error: .*pyvista.*: pip install "\.\[view\]"', said)
    assert not list(tmp_path.iterdir())


def test_output_in_a_narrow_encoding_is_no_error():
    code = "from toolkit import __main__ as m; m.app = lambda *_, **__: print('0 → 1'); raise SystemExit(m.main([]))"
    done = python(code, env=os.environ | {"PYTHONIOENCODING": "cp1252"})
    assert (done.returncode, done.stdout) == (0, "0 ? 1\n")


@pytest.fixture(scope="module")
def project() -> dict:
    return tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def requirements(project: dict, *extras: str) -> dict[str, str]:
    """Name and lower bound of everything that an installation with these extras asks for."""
    found = {}
    for text in [*project["dependencies"], *(d for extra in extras for d in project["optional-dependencies"][extra])]:
        name, within, bound = re.fullmatch(r"([\w-]+)(?:\[([\w,]+)\])?(>=.*)?", text).groups()
        found |= requirements(project, *within.split(",")) if name == project["name"] else {name: bound}
    return found


def test_conda_environment_equals_the_dev_installation(project):
    conda = {"pytorch": "torch", "playwright-python": "playwright"}
    *listed, from_pip = yaml.safe_load((REPOSITORY / "environment.yml").read_text(encoding="utf-8"))["dependencies"]
    assert f"python{project['requires-python']}" in listed
    assert from_pip["pip"][-1] == "--editable ."
    pairs = [re.fullmatch(r"([\w-]+)(>=.*)", text).groups() for text in {*listed, *from_pip["pip"][:-1]} - {"pip"}]
    assert {conda.get(name, name): bound for name, bound in pairs} == {
        "python": project["requires-python"], **requirements(project, "dev")
    }


def test_every_dependency_is_pinned_by_version_and_hashes(project):
    text = "".join((REPOSITORY / f"constraints{of}.txt").read_text(encoding="utf-8") for of in ("", "-cuda"))
    hashes = r"(?: \\\n    --hash=sha256:[0-9a-f]{64})+"
    assert not re.sub(rf"^[\w.-]+==\S+(?: ; [^\\\n]+)?{hashes}\n", "", text, flags=re.MULTILINE)
    pins = dict(re.findall(r"^([\w.-]+)==(\S+)", text, flags=re.MULTILINE))
    pinned = {re.sub(r"[-_.]+", "-", name.lower()): number for name, number in pins.items()}
    for name, bound in requirements(project, "dev").items():
        wanted, got = (tuple(int(n) for n in number.split(".")[:2]) for number in (bound.removeprefix(">="), pinned[name]))
        assert got >= wanted, f"{name}: {pinned[name]} is pinned, {bound} is asked for"


def test_every_dependency_has_a_reason(project):
    """docs/dependencies.md has a row for each, under the extra that brings it."""
    text = (REPOSITORY / "docs" / "dependencies.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("| `")]
    assert all(len(row) == 4 and all(row) for row in rows)
    extras = project["optional-dependencies"]
    wanted = {(re.match(r"[\w-]+", d)[0], extra) for extra in extras for d in extras[extra] if "toolkit[" not in d}
    wanted |= {(re.match(r"[\w-]+", d)[0], "base") for d in project["dependencies"]}
    listed = [(name.strip("`"), extra.strip("`")) for name, extra, *_ in rows]
    assert len(listed) == len(set(listed))
    assert set(listed) == wanted


def test_the_wheel_has_the_model_and_no_sources_of_the_page(tmp_path):
    unwanted = shutil.ignore_patterns("node_modules", "__pycache__")
    shutil.copytree(REPOSITORY / "toolkit", tmp_path / "toolkit", ignore=unwanted)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(REPOSITORY / name, tmp_path)
    modules = tmp_path / "toolkit" / "view" / "scene" / "node_modules" / "three"
    modules.mkdir(parents=True)
    (modules / "three.js").touch()
    (tmp_path / "notebooks").mkdir()
    command = "-m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir wheel ."
    subprocess.run([sys.executable, *command.split()], cwd=tmp_path, check=True, capture_output=True)
    (wheel,) = (tmp_path / "wheel").iterdir()
    files = zipfile.ZipFile(wheel).namelist()
    assert {"toolkit/__init__.pyi", "toolkit/training/pretrained.safetensors", "toolkit/phases/learned.safetensors",
            "toolkit/view/static/scene.js"} <= set(files)
    assert not [file for file in files if re.search("node_modules|view/scene/|__pycache__|notebooks|tests", file)]
    assert wheel.stat().st_size < 20e6


def test_text_files_name_their_encoding():
    """Windows would take its own otherwise."""
    silent = []
    for path in sorted((REPOSITORY / "toolkit").rglob("*.py")):
        for call in (node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call)):
            method = getattr(call.func, "attr", None)
            text_mode = [a for a in call.args[:1] if isinstance(a, ast.Constant) and set(str(a.value)) <= set("rwxat+")]
            text = method in ("read_text", "write_text") or (method == "open" and text_mode)
            if (text or getattr(call.func, "id", None) == "open") and "encoding" not in {k.arg for k in call.keywords}:
                silent.append(f"{path.name}:{call.lineno}: {ast.unparse(call)}")
    assert not silent


def test_pretrained_knows_every_style_and_stands_when_told():
    model, bank = tk.pretrained()
    assert set(bank.names) == set(tk.datasets.procedural.STYLES)
    assert (REPOSITORY / "toolkit" / "training" / "pretrained.safetensors").stat().st_size < 15e6
    vectors = torch.stack([bank[name] for name in bank.names])
    stop = [*tk.runtime.straight(1.0, 1.5), *tk.runtime.straight(0.0, 3.0)]
    places = torch.stack([s.root[:, :2] for s in tk.runtime.states(model, stop, vectors)])
    assert (places[89] - places[0]).norm(dim=-1).min() > 0.3
    drift = (places[-1] - places[-91]).norm(dim=-1)  # metres in 1.5 s; 0.18 without `steering.RETURN`
    assert drift.mean() < 0.09
    assert drift.max() < 0.25


def test_pretrained_starts_at_the_speed_that_is_asked_for():
    model, bank = tk.pretrained()
    style = bank.blend({"ArmsAboveHead": 0.5, "Old": 0.5})  # 1.9 times as far with the speed factor alone
    *_, last = tk.runtime.states(model, tk.runtime.straight(0.6, 2.0), style)
    assert float(last.root[0, 1]) == pytest.approx(1.2, rel=0.3)


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
    cut.write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n", encoding="utf-8")
    junk.write_bytes(b"junk")
    empty.mkdir()
    walk = ("rollout", "--out", tmp_path / "out.bvh", "--model", run, "--style")
    assert "cut.bvh, line" in refused("export", "clip", cut, "--out", tmp_path / "out.html")
    assert "unknown style 'Zombi'; close to it: Zombie" in refused(*walk, "Zombi")
    assert "sum to 1" in refused(*walk, "Zombie=0.5,Neutral=0.1")
    assert "written like" in refused(*walk, "Zombie=much")
    assert "can write .bvh, " in refused("rollout", "--style", "Zombie", "--out", tmp_path / "out.avi")
    assert "either --model" in refused(*walk, "Zombie", "--published", empty)
    assert "not a whole safetensors" in refused(*walk, "Zombie", "--model", junk)
    assert "Xmean.bin: missing" in refused("rollout", "--published", empty, "--style", "a", "--out", tmp_path / "out.bvh")
    assert "Frame_Cuts.csv" in refused("train", "--data", "100style", "--root", empty, "--out", tmp_path / "new.safetensors")
    assert "unknown" in refused("train", "--data", "procedural", "--styles", "Zombi", "--out", tmp_path / "new.safetensors")
    assert {p.name for p in tmp_path.iterdir()} == {"cut.bvh", "empty", "junk.safetensors", "run.safetensors"}


def test_a_datasets_name_means_the_dataset_where_a_folder_has_that_name(tmp_path, monkeypatch, refused):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bandai").mkdir()
    (tmp_path / "recordings").mkdir()
    train = ("train", "--out", tmp_path / "new.safetensors", "--data")
    assert "bandai: no matching BVH file in recordings" in refused(*train, "bandai", "--root", "recordings")
    assert "recordings: no file can be used; expected recordings" in refused(*train, "recordings")
    (tmp_path / "bandai" / "manifest.json").write_text("{}", encoding="utf-8")
    assert "bandai/manifest.json" in refused(*train, "bandai")


def test_a_checkpoint_of_another_layout_is_refused(tmp_path, small_run, walk_clip):
    small_run.save(tmp_path / "run.safetensors")
    other = tk.features.Layout(walk_clip.without_ends().skeleton)
    with pytest.raises(ValueError, match=r"run\.safetensors: the layout differs"):
        tk.networks.Model.load(tmp_path / "run.safetensors", layout=other)


def test_the_demo_works_on_a_small_budget(tmp_path):
    from toolkit.cli import demo

    assert "toolkitScene" in demo.embedded(tmp_path / "demo").read_text(encoding="utf-8")
    files = demo.make(tmp_path / "demo", seconds=2.0, data_seconds=10.0)
    assert [f.name for f in files] == ["walk.bvh", "walk.html", "strip.png", "report.txt", "model.safetensors",
                                       "controller.html"]
    frames = len(tk.bvh.load(files[0]))
    assert not re.search(r"""(src|href)\s*=\s*["']?https?:""", files[1].read_text(encoding="utf-8"))
    report = files[3].read_text(encoding="utf-8")
    assert f" {frames:,} frames" in report
    error, repeat = re.search(r"squared error (\S+) .* repeating the frame (\S+)\)", report).groups()
    assert ("no better than repeating the frame" in report) == (float(error) >= float(repeat))
    weights = demo.blend_weights(frames)
    assert weights.shape == (frames, 3)
    assert (weights.sum(1) - 1).abs().max() < 1e-5
    alone = torch.tensor([[1.0, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0], [1 / 3, 1 / 3, 1 / 3]])
    for k, share in enumerate(alone):
        assert torch.allclose(weights[round(k * (frames - 1) / 4)], share)


def test_version_is_the_same_everywhere():
    citation = yaml.safe_load((REPOSITORY / "CITATION.cff").read_text(encoding="utf-8"))
    changes = (REPOSITORY / "CHANGELOG.md").read_text(encoding="utf-8")
    number, date = re.search(r"^## \[(\d+\.\d+\.\d+)\] - (\S+)$", changes, re.MULTILINE).groups()
    assert number == str(citation["version"]) == tk.__version__
    assert date == str(citation["date-released"])
