"""Notebooks with the results of a stored run.

`conf.py` shows them instead of running the notebook again.
"""

import json
from datetime import datetime
from pathlib import Path


def merged(notebook: str, run: str) -> str:
    """The text of a notebook file with the results of a run.

    The text is "" if the code of the run is another, or if the run was stopped.

    Parameters
    ----------
    notebook, run
        The contents of two files: one without results, and what ``jupyter nbconvert --execute``
        made of it. Prose is taken from the first.
    """
    bare, full = json.loads(notebook), json.loads(run)
    cells, results = (
        [cell for cell in book["cells"] if cell["cell_type"] == "code"] for book in (bare, full)
    )
    if [cell["source"] for cell in cells] != [cell["source"] for cell in results]:
        return ""
    for cell, result in zip(cells, results, strict=True):
        stopped = result["execution_count"] is None
        if stopped or any(output["output_type"] == "error" for output in result["outputs"]):
            return ""
        cell["outputs"], cell["execution_count"] = result["outputs"], result["execution_count"]
    return json.dumps(bare | {"metadata": full["metadata"]})


def seconds(run: str) -> float:
    """How long a run took, from its first to its last cell."""
    cells = json.loads(run)["cells"]
    times = [
        datetime.fromisoformat(time)
        for cell in cells
        for time in cell["metadata"].get("execution", {}).values()
    ]
    return (max(times) - min(times)).total_seconds()


def results(folder: Path, notebooks: list[Path]) -> tuple[dict[str, str], dict[str, float]]:
    """By file name: the text of each notebook, and how long the stored runs took.

    A text has results where the folder holds them.
    """
    texts, took = {}, {}
    for path in notebooks:
        texts[path.name] = path.read_text(encoding="utf-8")
        if (stored := folder / path.name).is_file():
            run = stored.read_text(encoding="utf-8")
            if text := merged(texts[path.name], run):
                texts[path.name], took[path.name] = text, seconds(run)
    return texts, took
