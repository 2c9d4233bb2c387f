"""Stored results, and the tables of the documentation that come from them.

A result is a file ``docs/results/NAME.json``. A page shows its rows between two comments, which
this module fills::

    <!-- table NAME -->
    <!-- end -->

``<!-- table NAME: model mse -->`` shows only these columns, and with ``; without TEXT | TEXT``
leaves out the rows with a cell that holds such a text.
"""

import json
import math
import re
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Annotated, Any

import typer

from toolkit.io.files import atomic_write

DOCS = Path(__file__).parents[1] / "docs"
RESULTS = DOCS / "results"
#: An option of the commands that can store what they measure.
Store = Annotated[bool, typer.Option("--store", help="Write the results into docs/results.")]
TABLE = re.compile(r"(<!-- table ([\w-]+)(?:: ([\w -]+?))?(?:; without ([^>]+?))? -->\n).*?"
                   r"(<!-- end -->)", re.DOTALL)


@dataclass(frozen=True)
class Result:
    """What a command measured.

    A column is ``[title]`` for text, ``[title, decimals]`` or ``[title, decimals, scale]``: the
    table shows scale × value. A value is a number, text, None, or a list of numbers, one per seed:
    the table shows mean ± standard deviation. A number that is not finite is stored as None, and an
    absent value stays empty in the table.
    """

    name: str
    about: str  # one sentence: the data, the models, the budget
    command: str  # that measures it again
    columns: dict[str, list]  # key to title, decimals, scale
    rows: list[dict[str, Any]]  # key to value
    # of the measurement; the prose may state them
    settings: dict[str, Any] = field(default_factory=dict)
    # further results that the prose states, by what they are
    numbers: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self):
        for row in self.rows:
            if unknown := row.keys() - self.columns.keys():
                raise ValueError(f"result {self.name}: a row has {', '.join(sorted(unknown))}, "
                                 f"which no column shows; "
                                 f"columns: {', '.join(self.columns)}")

    def save(self, folder: Path = RESULTS) -> Path:
        """Write the file, one line per column, row, setting and number; returns its path."""
        held = _plain(asdict(self))
        name = held.pop("name")
        parts = (f' "{key}": {_lines(value)}' for key, value in held.items())
        path = folder / f"{name}.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as file:
            file.write(("{\n" + ",\n".join(parts) + "\n}\n").encode())
        return path

    def add(self, folder: Path = RESULTS) -> Path:
        """`save`, but the stored rows whose first column is another stay, and the stored
        numbers.
        """
        if not (folder / f"{self.name}.json").exists():
            return self.save(folder)
        old, first = Result.load(self.name, folder), next(iter(self.columns))
        rows = {row[first]: row for row in [*old.rows, *self.rows]}
        return replace(self, rows=list(rows.values()),
                       numbers=old.numbers | self.numbers).save(folder)

    def show(self, store: bool) -> None:
        """Print the table, and write the file if it should be stored."""
        print(f"{self.about}\n\n{self.markdown()}")
        if store:
            print(f"wrote {self.save()}")

    @classmethod
    def load(cls, name: str, folder: Path = RESULTS) -> "Result":
        """Read the file; ValueError if it is missing or holds something else."""
        path = folder / f"{name}.json"
        try:
            return cls(name, **json.loads(path.read_text(encoding="utf-8")))
        except FileNotFoundError:
            raise ValueError(f"{path}: no such result; known: "
                             f"{', '.join(sorted(p.stem for p in folder.glob('*.json')))}"
                             ) from None
        except (json.JSONDecodeError, TypeError) as error:
            raise ValueError(f"{path}: is not a result ({error})") from None

    def markdown(self, keys: Sequence[str] = (), without: Sequence[str] = ()) -> str:
        """The table, of all columns or of some.

        Rows that have only their first cell are left out, and rows with a cell that holds one of
        the texts ``without``.
        """
        if unknown := [key for key in keys if key not in self.columns]:
            raise ValueError(f"result {self.name} has no column {unknown[0]}; columns: "
                             f"{', '.join(self.columns)}")
        chosen = {key: self.columns[key] for key in keys or self.columns}
        head = [[column[0] for column in chosen.values()], ["---"] * len(chosen)]
        body = [[cell(row.get(key), *column[1:]) for key, column in chosen.items()]
                for row in self.rows]
        body = [row for row in body if not any(text in found for found in row for text in without)]
        return "".join(f"| {' | '.join(line)} |\n" for line in head
                       + [row for row in body if any(row[1:]) or len(row) == 1])


def cell(value: Any, decimals: int | None = None, scale: float = 1) -> str:
    """A value as a table shows it."""
    if value is None or isinstance(value, str):
        return value or ""
    if isinstance(value, float) and not math.isfinite(value):
        return ""
    if isinstance(value, list):
        known = [v for v in value if v is not None and math.isfinite(v)]
        if len(known) < 2:
            return cell(known[0] if known else None, decimals, scale)
        return (
            f"{cell(statistics.mean(known), decimals, scale)} ± "
            f"{cell(statistics.stdev(known), decimals, scale)}"
        )
    return f"{scale * value:,.{decimals or 0}f}".replace("-", "−")


def line(columns: Mapping[str, list], row: Mapping[str, Any]) -> str:
    """A row as a line of text."""
    return "  ".join(f"{columns[key][0]}: {cell(value, *columns[key][1:])}"
                     for key, value in row.items())


def fill(text: str, folder: Path = RESULTS) -> str:
    """A page with its tables drawn from the results; ValueError if one is missing."""
    def drawn(found: re.Match) -> str:
        opening, name, keys, without, closing = found.groups()
        texts = [text.strip() for text in (without or "").split("|") if text]
        table = Result.load(name, folder).markdown((keys or "").split(), texts)
        return f"{opening}{table}{closing}"

    return TABLE.sub(drawn, text)


def _lines(value: Any) -> str:
    """JSON text of a part of a result, one line per entry."""
    if not isinstance(value, dict | list) or not value:
        return json.dumps(value, ensure_ascii=False)
    named, (first, last) = isinstance(value, dict), "{}" if isinstance(value, dict) else "[]"
    entries = (f"{json.dumps(key, ensure_ascii=False)}: "
               for key in value) if named else [""] * len(value)
    held = value.values() if named else value
    lines = (f"  {key}{json.dumps(one, ensure_ascii=False)}"
             for key, one in zip(entries, held, strict=True))
    return f"{first}\n" + ",\n".join(lines) + f"\n {last}"


def _plain(value: Any) -> Any:
    """JSON values: numbers with six digits, None for those that are not finite."""
    if isinstance(value, Mapping):
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(one) for one in value]
    if isinstance(value, float):
        return float(f"{value:.6g}") if math.isfinite(value) else None
    return value


def run() -> None:
    """Write the tables of the documentation from the stored results in docs/results."""
    for page in sorted(DOCS.glob("*.md")):
        text = page.read_text(encoding="utf-8")
        if (filled := fill(text, RESULTS)) != text:
            with atomic_write(page) as file:
                file.write(filled.encode())
            print(f"wrote {page}")
