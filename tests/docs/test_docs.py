"""The pages of docs/: their code runs, errors are printed as they say, links hold. Building the
site is `make docs`.
"""

import html
import json
import pkgutil
import re
import shutil
from pathlib import Path

import pytest
import torch
from refusal import refusal

import toolkit as tk
from experiments import __main__ as experiments
from toolkit import __main__ as verbs

DOCS = Path(__file__).parents[2] / "docs"
NOTEBOOKS = DOCS.parent / "notebooks"
#: Pages whose code is run from top to bottom.
RUN = ("index", "gallery", "phase_sources", "adding_a_dataset", "adding_a_model", "shots")
#: What runs for a shorter time than the page says.
SHORTER = {"gallery": ("seconds=3)", "seconds=1.2)"), "phase_sources": ("steps=20)", "steps=2)"),
           "shots": ('"Neutral": 0.5})])', '"Neutral": 0.5})], duration=0.5)')}
PAGES = sorted(DOCS.glob("*.md"))
ROW = re.compile(r"^\| `(?P<call>.+?)` \| `(?P<said>.+)` \|$", re.MULTILINE)


def table_rows(page: str, heading: str) -> list[tuple[str, str]]:
    """First and second cell of each row of code, in the sections of a page whose heading starts
    so.
    """
    sections = re.split(r"^## ", (DOCS / f"{page}.md").read_text(encoding="utf-8"),
                        flags=re.MULTILINE)
    return [(m["call"], m["said"]) for s in sections if s.startswith(heading)
            for m in ROW.finditer(s)]


@pytest.fixture
def nonsense(tmp_path, monkeypatch):
    """The folder that the page of errors speaks of, without any data of this machine."""
    (tmp_path / "cut.bvh").write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n")
    (tmp_path / "junk.safetensors").write_bytes(b"junk")
    (tmp_path / "empty").mkdir()
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("TOOLKIT_DATA", raising=False)
    return tmp_path


@pytest.fixture(scope="module")
def names():
    """What the expressions on the page of errors may use."""
    model, bank = tk.pretrained()
    clip = tk.datasets.procedural.generate("Neutral", seconds=3.0)
    return {"tk": tk, "torch": torch, "clip": clip, "model": model, "bank": bank}


def command_line(typed: str):
    """The command line that a command is for, and its words: those of the experiments start with
    "experiments".
    """
    first, *rest = typed.split()
    return (experiments, rest) if first == "experiments" else (verbs, [first, *rest])


def blocks(page: Path, of: str = "python") -> list[str]:
    """The blocks of code on a page."""
    return re.findall(rf"^```{of}\n(.*?)^```", page.read_text(encoding="utf-8"),
                      re.MULTILINE | re.DOTALL)


def pattern(said: str) -> str:
    return ".*".join(re.escape(part) for part in said.split("…"))


@pytest.mark.parametrize(("typed", "said"), table_rows("errors", "Command line"))
def test_the_command_line_says_what_the_page_says(nonsense, capsys, typed, said):
    before = sorted(nonsense.rglob("*"))
    line, words = command_line(typed)
    assert line.main(words) == 2
    assert re.fullmatch(f"error: {pattern(said)}\n", capsys.readouterr().err)
    assert sorted(nonsense.rglob("*")) == before


@pytest.mark.parametrize(("expression", "said"), table_rows("errors", "Python"))
def test_python_says_what_the_page_says(nonsense, names, expression, said):
    with refusal(f"^{pattern(said)}$"):
        eval(expression, dict(names))


def test_the_page_of_errors_has_its_tables():
    assert len(table_rows("errors", "Command line")) > 8
    assert len(table_rows("errors", "Python")) > 8


@pytest.mark.parametrize("page", RUN)
def test_the_code_of_a_page_runs(page, tmp_path, monkeypatch):
    shutil.copytree(DOCS.parent / "examples", tmp_path / "examples")
    gate = tmp_path / "examples" / "shots" / "gate.json"  # fifty characters take minutes: two do
    scene = json.loads(gate.read_text(encoding="utf-8"))
    two = [shot | {"duration": 0.5} for shot in scene["shots"][:2]]
    gate.write_text(json.dumps(scene | {"shots": two}), encoding="utf-8")
    monkeypatch.setattr("toolkit.extra.shots.scene.TRIED", 30)  # frames of a style that is tried
    monkeypatch.chdir(tmp_path)
    long, short = SHORTER.get(page, ("", ""))
    code = "".join(blocks(DOCS / f"{page}.md"))
    assert code
    assert long in code
    exec(compile(code.replace(long, short), f"{page}.md", "exec"), {"__name__": page})


def test_the_code_of_the_readme_runs(tmp_path, monkeypatch):
    """As written, but for the length of the walk, of the data and of the trainings."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("toolkit.styles.fine_tuning.WALK", (1.0, 0.2))
    code = "".join(blocks(DOCS.parent / "README.md"))
    for long, short in (("seconds=10", "seconds=1"), ("seconds=90", "steps=3"),
                        ('"Strut"]', '"Strut"], gaits="FW", seconds=6'),
                        ("bank=bank)", "bank=bank, steps=40)")):
        assert long in code
        code = code.replace(long, short)
    space: dict = {"__name__": "readme"}
    exec(compile(code, "README.md", "exec"), space)
    assert {path.name for path in tmp_path.iterdir()} == {"walk.bvh", "walk.html", "character.html",
                                                          "run.safetensors"}
    after = space["new"].held_out["MyStyle"]
    assert after["after"] < after["before"]


def test_every_command_of_the_reproduction_exists():
    rows = [line.split(" | ")[-1]
            for line in (DOCS / "reproducing.md").read_text(encoding="utf-8").splitlines()
            if line.startswith("| ")]
    commands = [c for row in rows for c in re.findall(r"`([a-z].+?)`", row)
                if not c.startswith("pytest")]
    assert len(commands) > 20
    for command in commands:
        line, words = command_line(command)
        at = line.app
        while getattr(at, "commands", None) and words and words[0] in at.commands:
            at = at.commands[words.pop(0)]
            at = getattr(at, "imported", at)
        known = {name for parameter in at.params
                 for name in (*parameter.opts, *parameter.secondary_opts)}
        assert not words or words[0].startswith(("--", "…")), command
        assert {word for word in words if word.startswith("--")} <= known, command


def test_every_page_notebook_and_module_is_in_the_tree_of_contents(monkeypatch):
    listed = [line for tree in blocks(DOCS / "index.md", r"\{toctree\}")
              for line in tree.splitlines() if line and not line.startswith(":")]
    assert len(set(listed)) == len(listed)
    pages = {path.stem for path in PAGES} - {"index"}
    assert {name for name in listed if "/" not in name} == pages
    # all notebooks; the reference is written when the site is built
    assert {"notebooks/*", "api/index"} <= set(listed)
    monkeypatch.syspath_prepend(DOCS)
    import reference

    listed = [name for group in reference.GROUPS.values() for name in group]
    there = {m.name for m in pkgutil.iter_modules(tk.__path__)} - {"__main__"}
    assert sorted(listed) == sorted(there)


def test_a_stored_run_is_shown_if_its_code_is_that_of_the_notebook(monkeypatch):
    monkeypatch.syspath_prepend(DOCS)
    import stored

    def book(prose: str, code: str, **run) -> str:
        cells = [{"cell_type": "markdown", "source": [prose], "metadata": {}},
                 {"cell_type": "code", "source": [code], "metadata": {}, "outputs": [],
                  "execution_count": None} | run]
        return json.dumps({"cells": cells, "metadata": {}})

    said = [{"output_type": "stream", "name": "stdout", "text": ["4"]}]
    fresh, run = book("new prose", "print(4)"), {"outputs": said, "execution_count": 1}
    prose, code = json.loads(stored.merged(fresh, book("old", "print(4)", **run)))["cells"]
    assert (prose["source"], code["outputs"]) == (["new prose"], said)
    assert stored.merged(fresh, book("old", "print(5)", **run)) == ""
    assert stored.merged(fresh, book("old", "print(4)", outputs=said)) == ""  # it was stopped


@pytest.mark.parametrize("page", [*PAGES, *sorted(NOTEBOOKS.glob("*.ipynb"))],
                         ids=lambda path: path.stem)
def test_formulas_of_a_page_have_no_command_that_the_site_cannot_draw(page):
    convert = pytest.importorskip("latex2mathml.converter",
                                  reason='needs pip install ".[docs]"').convert
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        cells = (cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown")
        text = "\n\n".join("".join(cell["source"]) for cell in cells)
    text = re.sub(r"^```.*?^```|`[^`\n]*`", "", text, flags=re.MULTILINE | re.DOTALL)
    for formula in re.findall(r"\$\$.+?\$\$|\$[^$\n]+\$", text, re.DOTALL):
        drawn = html.unescape(convert(formula.strip("$").strip()))
        assert "\\" not in drawn, formula
