"""The package as a whole: what it imports, what it needs, and what the command line says to bad
input.
"""

import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
import torch
import yaml

import toolkit as tk

REPOSITORY = Path(__file__).parents[2]
DRAWING = {"IPython", "PIL", "anywidget", "av", "ipywidgets", "jupyter_client", "jupyterlab",
           "matplotlib", "pandas", "plotly", "pyvista", "sklearn", "vtkmodules"}
#: A walk as a page, where the packages of the extra "view" are not installed.
BARE = f"""
from importlib.machinery import PathFinder
find = PathFinder.find_spec
PathFinder.find_spec = lambda n, *r: None if n.split(".")[0] in {DRAWING} else find(n, *r)
assert main("rollout --style Zombie --seconds 0.1 --out walk.html".split()) == 2
PathFinder.find_spec = find"""


def test_nothing_is_loaded_before_it_is_needed_and_one_line_names_what_is_missing(tmp_path):
    heavy = {"torch", "numpy", "scipy", "numba", "lightning_fabric", "typer", "course"}
    slow = {"pyvista", "plotly", "matplotlib", "scipy.ndimage", "scipy.sparse", "numba"}
    code = "import sys"
    for step, unwanted in (
        ("import toolkit", DRAWING | heavy),
        ("from toolkit.__main__ import main; main(['--help'])", {"torch"}),
        (BARE, DRAWING),
        ("import toolkit.view", slow | {"ipywidgets"}),
        ("toolkit.view.Controller(*toolkit.pretrained())", slow),
    ):
        code += f"\n{step}\nfound = {unwanted} & {{*sys.modules}}\nassert not found, found"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False,
                          cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert re.search(r'^error: .*pyvista.*: pip install "\.\[view\]"$', done.stderr, re.MULTILINE)
    assert not list(tmp_path.iterdir())


def test_public_names_are_listed_and_there():
    assert set(dir(tk)) == set(tk.__all__)
    for name in tk.__all__:
        assert getattr(tk, name) is not None
    assert tk.Clip is tk.motion.Clip
    assert tk.pretrained is tk.training.pretrained
    for name, said in (("nothing", "nothing"), ("evalution", "did you mean 'evaluation'")):
        with pytest.raises(AttributeError, match=said):
            getattr(tk, name)


@pytest.fixture(scope="module")
def project() -> dict:
    return tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def requirements(project: dict, *extras: str) -> dict[str, str]:
    """Name and lower bound of everything that an installation with these extras asks for."""
    found = {}
    for text in [*project["dependencies"],
                 *(d for extra in extras for d in project["optional-dependencies"][extra])]:
        name, within, bound = re.fullmatch(r"([\w-]+)(?:\[([\w,]+)\])?(>=.*)?", text).groups()
        found |= requirements(project,
                              *within.split(",")) if name == project["name"] else {name: bound}
    return found


def test_conda_environment_equals_the_dev_installation(project):
    conda = {"pytorch": "torch", "playwright-python": "playwright"}
    text = (REPOSITORY / "environment.yml").read_text(encoding="utf-8")
    *listed, from_pip = yaml.safe_load(text)["dependencies"]
    assert f"python{project['requires-python']}" in listed
    assert from_pip["pip"][-1] == "--editable ."
    pairs = [re.fullmatch(r"([\w-]+)(>=.*)", text).groups()
             for text in {*listed, *from_pip["pip"][:-1]} - {"pip"}]
    assert {conda.get(name, name): bound for name, bound in pairs} == {
        "python": project["requires-python"], **requirements(project, "dev")
    }


def test_every_dependency_is_pinned(project):
    text = "".join((REPOSITORY / f"constraints{of}.txt").read_text(encoding="utf-8")
                   for of in ("", "-cpu", "-cuda"))
    pins = dict(re.findall(r"^([\w.-]+)==([^\s+]+)", text, flags=re.MULTILINE))
    assert text.count(f"\ntorch=={pins['torch']}") == 2  # with CUDA and without: one version
    pinned = {re.sub(r"[-_.]+", "-", name.lower()): number for name, number in pins.items()}
    for name, bound in requirements(project, "dev").items():
        wanted, got = (tuple(int(n) for n in number.split(".")[:2])
                       for number in (bound.removeprefix(">="), pinned[name]))
        assert got >= wanted, f"{name}: {pinned[name]} is pinned, {bound} is asked for"


def test_every_dependency_has_a_reason(project):
    """docs/dependencies.md has a row for each, under the extra that brings it."""
    text = (REPOSITORY / "docs" / "dependencies.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines()
            if line.startswith("| `")]
    assert all(len(row) == 3 and all(row) for row in rows)
    extras = project["optional-dependencies"]
    wanted = {(re.match(r"[\w-]+", d)[0], extra) for extra in extras for d in extras[extra]
              if "toolkit[" not in d}
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
    subprocess.run([sys.executable, *command.split()], cwd=tmp_path, check=True,
                   capture_output=True)
    (wheel,) = (tmp_path / "wheel").iterdir()
    files = zipfile.ZipFile(wheel).namelist()
    assert {"toolkit/__init__.pyi", "toolkit/training/pretrained.safetensors",
            "toolkit/view/static/scene.js"} <= set(files)
    assert not [file for file in files
                if re.search("node_modules|view/scene/|__pycache__|notebooks|tests", file)]
    assert wheel.stat().st_size < 20e6


def test_pretrained_knows_every_style_and_stands_when_told(fast):
    model, bank = fast
    assert set(bank.names) == set(tk.datasets.procedural.STYLES)
    assert (REPOSITORY / "toolkit" / "training" / "pretrained.safetensors").stat().st_size < 15e6
    vectors = torch.stack([bank[name] for name in bank.names])
    stop = [*tk.runtime.straight(1.0, 1.5), *tk.runtime.straight(0.0, 3.0)]
    places = torch.stack([s.root[:, :2] for s in tk.runtime.states(model, stop, vectors)])
    assert (places[89] - places[0]).norm(dim=-1).min() > 0.3
    # metres in 1.5 s; 0.18 without `steering.RETURN`
    drift = (places[-1] - places[-91]).norm(dim=-1)
    assert drift.mean() < 0.09
    assert drift.max() < 0.25


def test_a_datasets_name_means_the_dataset_where_a_folder_has_that_name(tmp_path, monkeypatch,
                                                                        command):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bandai").mkdir()
    (tmp_path / "recordings").mkdir()

    def refused(data: str) -> str:
        """The one line that is said."""
        (said,) = command(f"train --out new.safetensors --data {data}", status=2).err.splitlines()
        return said

    said = refused("bandai --root recordings")
    assert "bandai: no matching BVH file in recordings" in said
    assert "recordings: no file can be used; expected recordings" in refused("recordings")
    (tmp_path / "bandai" / "manifest.json").write_text("{}", encoding="utf-8")
    assert "bandai/manifest.json" in refused("bandai")


@pytest.mark.filterwarnings("ignore:walk.bvh: ")  # on a busy machine the training is no training
def test_the_demo_works_on_a_small_budget(tmp_path, monkeypatch):
    from toolkit.cli import demo

    monkeypatch.setattr(demo, "SPEED", 20.0)  # the figure of eight in few frames
    monkeypatch.setattr(demo, "GAITS", ["FW", "BW"])
    page = demo.embedded(tmp_path / "demo")
    for linked in re.findall('href="(.+?)"', page.read_text(encoding="utf-8")):
        assert "toolkitScene" in (page.parent / linked).read_text(encoding="utf-8")
    files = demo.make(tmp_path / "demo", seconds=0.5, data_seconds=5.0)
    assert [f.name for f in files] == ["walk.bvh", "walk.html", "report.txt", "model.safetensors",
                                       "controller.html"]
    frames = len(tk.bvh.load(files[0]))
    report = files[2].read_text(encoding="utf-8")
    assert f" {frames:,} frames" in report
    error, repeat = re.search(r"squared error (\S+) .* repeating the frame (\S+)\)",
                              report).groups()
    assert ("no better than repeating the frame" in report) == (float(error) >= float(repeat))
    weights = demo.blend_weights(frames)
    alone = torch.tensor([[1.0, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0], [1 / 3, 1 / 3, 1 / 3]])
    for k, share in enumerate(alone):
        for at in (k, min(k + 0.2, 4)):  # it stays a while
            assert torch.allclose(weights[round(at * (frames - 1) / 4)], share)


def test_version_is_the_same_everywhere():
    citation = yaml.safe_load((REPOSITORY / "CITATION.cff").read_text(encoding="utf-8"))
    changes = (REPOSITORY / "CHANGELOG.md").read_text(encoding="utf-8")
    number, date = re.search(r"^## \[(\d+\.\d+\.\d+)\] - (\S+)$", changes, re.MULTILINE).groups()
    assert number == str(citation["version"]) == tk.__version__
    assert date == str(citation["date-released"])
