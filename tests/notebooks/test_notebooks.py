"""Checks of the notebooks as files; nbval runs them."""

import ast
import json
import re
from functools import cache
from pathlib import Path

import course
import pytest
from course.floors import FLOOR

SOLUTION = re.compile(r"<summary>Solution</summary>\n\n```python\n(.*?)\n```\n\n?</details>", re.S)
NOTEBOOKS = sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb"))
LONGEST = 15  # lines of a code cell, without a floor
#: First words of the cells that may define functions.
MAY_DEFINE = "# exercise", "# by hand"

#: What stands before a number that is not a result, such as a section.
LABEL = re.compile(
    r"(?:sections?|equations?|figures?|tables?|fig\.|notebooks?|exercises?|chapter|layer|version|"
    r"dataset|et al\.|\d\d\d\d and|Komura|Lee|Shin|[A-Z]\w+ 20\d\d;)\s*"
    r"\(?[\d.]+[a-z]?(?:(?:,| and| to|–)\s*[\d.]+[a-z]?)*\)?", re.I)
NUMBER = re.compile(r"(?<![\w.])\d[\d,]*(?:\.\d+)?(?![\w]*\.\d|[a-z]?\.ipynb)")
#: Words that compare two results.
COMPARES = re.compile(
    r"\b((?:small|larg|few|high|low|fast|slow|long|short)(?:er|est)|better|best|worse|worst|wins?|"
    r"beats?|closest|nearest|stronger|weaker|farthest|furthest|twice|about half|more|less|"
    r"(?<!at )most|the least|almost|nearly|hardly|rises?|grows?|falls?|increases?|decreases?|"
    r"doubles?|halves|exceeds?|(?:does|do|did) not (?:help|work|move|change)|fails?)\b", re.I)
#: Headings of sections with recordings or published networks, and what reads them.
RECORDED = re.compile(r"^## .*(?:[Rr]ecordings|[Pp]ublished)", re.M)
READS = re.compile(r"(?:datasets|published)\.available\(|labels\.read\(|results/stylisation")
#: A comment that names the source of a number, such as ``<!-- 4 Hz: toolkit.phases.windows -->``.
NAMED = re.compile(r"<!-- ([^>:\"]*\d[^>:\"]*): .*?-->", re.S)
#: Words of a paper on which a sentence rests, in a comment: ``mason2022: "one", "another"``.
QUOTED = re.compile(r"(mason2022|park2021): (\"[^\"]+\"(?:,\s+\"[^\"]+\")*)")
#: A sentence about the papers.
ON_A_PAPER = re.compile(r"\b[Tt]he (?:papers?|authors)\b|[Pp]aper's|Mason|Park(?:, Jang| et al)")
DEFINED = {0.0, 1.0, 2.0, 3.0}  # shapes, shares, axes


@pytest.fixture(params=NOTEBOOKS, ids=lambda path: path.stem)
def notebook(request) -> dict:
    return read(request.param)


@pytest.fixture
def entry(request, notebook) -> course.Lesson:
    """What the sequence of the course says of a notebook."""
    return course.LESSONS[request.node.callspec.params["notebook"].stem.split("_")[0]]


@cache
def read(path: Path) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))


def code(notebook) -> list[str]:
    """Sources of the code cells."""
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def prose(notebook) -> list[str]:
    """Sources of the Markdown cells."""
    return ["".join(c["source"]) for c in notebook["cells"] if c["cell_type"] == "markdown"]


def plain(source: str) -> str:
    """The Python of a cell: lines with a magic or a shell command become empty."""
    return re.sub(r"^[ \t]*[%!].*", "", source, flags=re.M)


def nodes(sources: list[str]) -> list[ast.AST]:
    """Every node of the syntax trees of cells."""
    return [node for source in sources for node in ast.walk(ast.parse(plain(source)))]


def words(text: str) -> str:
    """Prose without exercises, code, formulas, comments, links, pictures, HTML tags, headings, the
    minutes of the first cell, numbers of a list and titles.
    """
    for pattern in (
            r"^### Exercise.*?(?=^## |\Z)", r"```.*?```", r"`[^`]*`", r"\$\$.*?\$\$", r"\$[^$]*\$",
            r"<!--.*?-->", r"\[\d\d[ab]?\]\([^)]*\)", r"!\[[^\]]*\]\([^)]*\)",
            r"(?<=\])\([^)]*\)", r"<[^>]*>", r"^#+ [^\n]*$", r"\*\*Time:\*\* about \d+ minutes",
            r"^\s*\d+\.\s", r"\*[A-Z][^*\n]*\*"):
        text = re.sub(pattern, " ", text, flags=re.S | re.M)
    return text


def numbers(text: str) -> set[float]:
    return {float(x.replace(",", "").rstrip(".")) for x in NUMBER.findall(LABEL.sub(" ", text))}


def calls(notebook, *names: str) -> list[ast.Call]:
    """Calls of functions of the course in the code cells."""
    return [node for node in nodes(code(notebook)) if isinstance(node, ast.Call)
            and ast.unparse(node.func) in {f"course.{name}" for name in names}]


def literals(trees) -> set[float]:
    """Numbers that are written in code, also as percent of a share."""
    found = {float(n.value) for tree in trees for n in ast.walk(tree)
             if isinstance(n, ast.Constant) and type(n.value) in (int, float)}
    return found | {round(100 * x, 6) for x in found}


# --- every notebook


def test_format_kernel_and_cell_ids_and_nothing_of_a_run(notebook):
    for cell in notebook["cells"]:
        assert not cell.get("outputs")
        assert cell.get("execution_count") is None
        assert not cell.get("attachments")
        assert "execution" not in cell["metadata"]
    assert "widgets" not in notebook["metadata"]
    assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 5)
    assert notebook["metadata"]["kernelspec"]["name"] == "python3"
    ids = [cell.get("id", "") for cell in notebook["cells"]]
    assert all(re.fullmatch(r"[a-zA-Z0-9_-]{1,64}", x) for x in ids)
    assert len(set(ids)) == len(ids)


def test_cells_are_short_and_few_and_the_last_one_asserts_the_finding(notebook):
    cells = code(notebook)
    assert 8 <= len(cells) <= 40
    for source in cells:
        lines = [line for line in source.splitlines() if not FLOOR.match(line)]
        assert 0 < len(lines) <= LONGEST, source
    assert any(isinstance(node, ast.Assert) for node in nodes(cells[-1:])), cells[-1]


def test_library_code_is_imported_and_no_private_names_and_no_experiments(notebook):
    for source in code(notebook):
        defined = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
        assert source.lower().startswith(MAY_DEFINE) or not any(
            isinstance(node, defined) for node in nodes([source])), source
        assert not re.search(r"^\s*(?:from|import) (?:experiments|tests)", source, re.M)
    names = [node.attr for node in nodes(code(notebook)) if isinstance(node, ast.Attribute)]
    assert not [name for name in names if name.startswith("_") and not name.endswith("__")]


# --- notebooks of the course


def test_it_is_in_the_sequence_and_opens_with_goals_minutes_and_needs(entry, notebook):
    first = "".join(notebook["cells"][0]["source"])
    assert first.startswith(f"# {entry.question}\n")
    moving = r"^!\[[^\]]+\]\(\.\./docs/\S+\.(?:webp|gif|apng)\)"
    assert re.search(moving, first, re.M), "a moving picture of the result"
    assert "**You will be able to**" in first
    assert f"**Time:** about {entry.minutes} minutes." in first
    needs = re.search(r"\*\*Before this notebook:\*\* (.*?)\.\s", first, re.S).group(1)
    assert tuple(re.findall(r"\[(\d\d[ab]?)\]", needs)) == entry.needs
    assert [call.args[0].value for call in calls(notebook, "here")] == [entry.number]


def test_the_run_answers_each_question_that_is_asked_before_it(notebook):
    turns = ""
    for text in ("".join(cell["source"]) for cell in notebook["cells"]):
        answers = text.startswith("# after the run") and "course.claim(" in text
        turns += "?" if "**Before you run.**" in text else "!" * answers
    assert re.fullmatch(r"(\?!+)+", turns)


def test_each_claim_has_a_floor(notebook):
    claims = [text for text in code(notebook) if "course.claim(" in text]
    assert all(FLOOR.search(text) for text in claims)


def test_recordings_are_read_in_a_last_section_alone(notebook):
    cells = [(cell["cell_type"], "".join(cell["source"])) for cell in notebook["cells"]]
    heads, reads = ([i for i, (kind, text) in enumerate(cells) if kind == of and has.search(text)]
                    for of, has in (("markdown", RECORDED), ("code", READS)))
    if reads:
        assert len(heads) == 1
        assert heads[0] < reads[0]
        later = "\n".join(text for kind, text in cells[heads[0] + 1 :] if kind == "markdown")
        assert not re.search(r"^## \d", later, re.M)
        assert len(cells[heads[0]][1].split("##")[-1].split()) > 25  # prose of their own


def test_it_ends_with_what_was_learnt_and_three_questions_with_folded_answers(notebook):
    assert len(calls(notebook, "learnt")) == 1
    (quiz,) = [text for text in prose(notebook) if text.startswith("## Three questions")]
    assert quiz.count("<details>") == quiz.count("</details>") == 3
    assert len(re.findall(r"<summary>[^<]+\?</summary>\n\n", quiz)) == 3


def test_at_least_three_exercises_are_checked_and_have_folded_solutions(entry, notebook):
    known = list(course.exercises_of(entry.number))
    assert len(known) >= 3
    assert [call.args[0].value for call in calls(notebook, "check")] == known
    solved = SOLUTION.findall("\n".join(prose(notebook)))
    asks = re.compile(r'course\.check\("([^"]+)", ')
    assert [asks.match(text.splitlines()[-1])[1] for text in solved] == known


# --- what prose says is what the run shows


def quotations(text: str) -> list[tuple[str, str]]:
    """Paper and words of each quotation in a cell."""
    return [(paper, plainly(words)) for paper, found in QUOTED.findall(text)
            for words in re.findall(r'"([^"]+)"', found)]


def plainly(text: str) -> str:
    return re.sub(r"\s+", " ", text.replace("\u2019", "'")).lower()


def held(cell: str) -> set[float]:
    """Numbers of a cell's quotations, and those whose source a comment names."""
    named = " ".join([*NAMED.findall(cell), *(words for _, words in quotations(cell))])
    return DEFINED | numbers(named)


def test_no_markdown_cell_has_a_number_that_no_assert_holds(notebook):
    """A number in prose comes from an assert or a claim, or its source is named in a comment; an
    exercise may set its own.
    """
    found = literals([n.test for n in nodes(code(notebook)) if isinstance(n, ast.Assert)])
    found |= literals([arg for call in calls(notebook, "claim") for arg in call.args[1:]])
    for text in prose(notebook):
        assert not numbers(words(text)) - found - held(text), text


def test_a_sentence_about_a_paper_stands_beside_the_words_it_rests_on(notebook):
    said = prose(notebook) + [text for text in code(notebook) if "course.claim(" in text]
    for text in said:
        assert quotations(text) or not ON_A_PAPER.search(text), text


def test_the_quoted_words_are_in_the_papers(shared, notebook):
    folder = shared.parent / "papers"
    if not folder.is_dir():
        pytest.skip(f"no papers in {folder}")
    for cell in prose(notebook) + code(notebook):
        for paper, said in quotations(cell):
            texts = [x.read_text(encoding="utf-8") for x in sorted(folder.glob(f"{paper}*.txt"))]
            assert any(said in plainly(text) for text in texts), said


def shape(node: ast.AST) -> str:
    """An expression without the names of its variables."""
    named = {}
    return re.sub(r"Name\(id='(\w+)'", lambda m: named.setdefault(m[1], f"Name({len(named)}"),
                  ast.dump(node))


def test_no_answer_is_printed_above_its_exercise(notebook):
    above = set()
    for cell in notebook["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "code":
            above |= {shape(node) for node in nodes([text]) if isinstance(node, ast.expr)}
        for answer in SOLUTION.findall(text):
            for node in nodes([answer]):
                if isinstance(node, ast.Return) and not isinstance(node.value, ast.Name):
                    assert shape(node.value) not in above, answer


def test_claims_take_their_numbers_from_the_run(notebook):
    """In the constant part of a claim's sentence, a number stands only if the claim's condition has
    it.
    """
    found = [(call.args[0], call.args[1:]) for call in calls(notebook, "claim")]
    found += [(key, [value]) for call in calls(notebook, "learnt") for key, value in
              zip(call.args[0].keys, call.args[0].values, strict=True)]
    quoted = held("\n".join(code(notebook)))
    for sentence, conditions in found:
        parts = sentence.values if isinstance(sentence, ast.JoinedStr) else [sentence]
        text = "".join(part.value for part in parts if isinstance(part, ast.Constant))
        assert not numbers(words(text)) - literals(conditions) - quoted, text
        # A condition that cannot fail.
        assert not any(isinstance(node, ast.Constant) for node in conditions), text
        said = {n.id for part in parts for n in ast.walk(part) if isinstance(n, ast.Name)}
        tested = {n.id for node in conditions for n in ast.walk(node) if isinstance(n, ast.Name)}
        # It compares what it does not test.
        assert not COMPARES.search(text) or not said or said & tested, text


# --- the page for lecturers


def test_the_page_for_lecturers_names_every_notebook_in_its_plan():
    page = (NOTEBOOKS[0].parents[1] / "docs" / "lecturers.md").read_text(encoding="utf-8")
    parts = dict(part.split("\n", 1) for part in page.split("\n## ")[1:])
    table = "\n".join(line for line in parts["A week"].splitlines()
                      if line.startswith("|") or "capstone" in line)
    assert set(course.LESSONS) <= set(re.findall(r"\b\d\d[ab]?\b", table))
