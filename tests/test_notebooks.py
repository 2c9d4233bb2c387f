"""Checks of the notebooks as files; nbval runs them."""

import ast
import json
import re
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
LONGEST = 15  # lines of a code cell
EXERCISE = "# exercise"  # first words of a cell in which the reader writes code; only such a cell may define functions


@pytest.fixture(params=NOTEBOOKS, ids=lambda path: path.stem)
def notebook(request) -> dict:
    return json.loads(request.param.read_text(encoding="utf-8"))


def code(notebook) -> list[str]:
    """Sources of the code cells."""
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def plain(source: str) -> str:
    """The Python of a cell: lines with a magic or a shell command become empty."""
    return "\n".join("" if line.lstrip().startswith(("%", "!")) else line for line in source.splitlines())


def test_there_are_notebooks_and_each_has_a_number_of_its_own():
    numbers = [path.name[:2] for path in NOTEBOOKS]
    assert all(re.fullmatch(r"\d\d_[a-z0-9_]+\.ipynb", path.name) for path in NOTEBOOKS)
    assert numbers
    assert len(set(numbers)) == len(numbers)


def test_nothing_of_a_run_is_stored(notebook):
    for cell in notebook["cells"]:
        assert not cell.get("outputs")
        assert cell.get("execution_count") is None
        assert not cell.get("attachments")
        assert "execution" not in cell["metadata"]
    assert "widgets" not in notebook["metadata"]


def test_format_kernel_and_cell_ids(notebook):
    assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 5)
    assert notebook["metadata"]["kernelspec"]["name"] == "python3"
    ids = [cell.get("id", "") for cell in notebook["cells"]]
    assert all(re.fullmatch(r"[a-zA-Z0-9_-]{1,64}", x) for x in ids)
    assert len(set(ids)) == len(ids)


def test_it_opens_with_its_question_and_the_words_outnumber_the_code(notebook):
    first = notebook["cells"][0]
    assert first["cell_type"] == "markdown"
    assert "".join(first["source"]).startswith("# ")
    assert sum(cell["cell_type"] == "markdown" for cell in notebook["cells"]) >= 5


def test_cells_are_short_and_few(notebook):
    cells = code(notebook)
    assert 10 <= len(cells) <= 25
    for source in cells:
        assert 0 < len(source.splitlines()) <= LONGEST, source


def test_the_last_cells_assert_the_finding(notebook):
    last = code(notebook)[-1]
    assert any(isinstance(node, ast.Assert) for node in ast.walk(ast.parse(plain(last)))), last


def test_library_code_is_imported_not_defined_again(notebook):
    for source in code(notebook):
        nodes = ast.walk(ast.parse(plain(source)))
        defined = [node for node in nodes if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)]
        assert not defined or source.lower().startswith(EXERCISE), source


def test_it_imports_the_package_and_no_experiment(notebook):
    nodes = [node for source in code(notebook) for node in ast.walk(ast.parse(plain(source)))]
    modules = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    modules |= {node.module for node in nodes if isinstance(node, ast.ImportFrom)}
    assert "toolkit" in modules
    assert not [name for name in modules if name.split(".")[0] in ("experiments", "tests", "robustness")]


def test_no_private_names_of_the_package(notebook):
    nodes = [node for source in code(notebook) for node in ast.walk(ast.parse(plain(source)))]
    names = [node.attr for node in nodes if isinstance(node, ast.Attribute)]
    assert not [name for name in names if name.startswith("_") and not name.endswith("__")]


def test_the_fast_setting_is_read(notebook):
    assert "TOOLKIT_FAST" in "\n".join(code(notebook))


def test_no_path_of_one_machine(notebook):
    text = "\n".join("".join(cell["source"]) for cell in notebook["cells"])
    found = re.findall(r"""["'`(\s](?:/(?:home|Users|root|work|tmp|mnt|media|opt|var|usr)/|[A-Z]:\\)\S*""", text)
    assert not found
