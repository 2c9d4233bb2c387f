"""The failure cases of Mason et al. 2022, section 5.1, measured on the runs of a comparison."""

import math
from pathlib import Path

from experiments.seven_models import interpolation
from experiments.seven_models.models import MOVING, TABLE, Plan, average, judge, read_json, trained
from experiments.tables import Result
from toolkit.features import Features
from toolkit.training import Run

STUCK = 0.5  # range of the hands / that of the data, below which hands are stuck
COMPARED = ("lpn-onehot", "lpn-resad", "lpn-film")

Rows = dict[str, dict[str, float | list[float]]]  # numbers of each model; a list has one per seed


def stuck_hands(table: dict, model: str, than: str) -> Rows:
    """Range and correlation of the hands in closed loop of two models, relative to the data."""
    runs = {name: table["models"][name]["runs"] for name in (model, than)}
    if "ceiling" in table:
        runs["published"] = [table["ceiling"]]
    moving = [style for style, row in runs[model][0]["styles"].items()
              if row["hands_data"] > MOVING]

    def row(found: list[dict]) -> dict[str, float | list[float]]:
        hands, together = ([[run["styles"][style][key] for style in moving] for run in found]
                           for key in ("hands", "together"))
        return {"range / data": [average(values) for values in hands],
                "|corr. - data's|": [average(values) for values in together],
                f"styles below {STUCK}": [sum(v < STUCK for v in values) for values in hands],
                "of styles": len(moving), "recognised": [run["recognised"] for run in found]}

    return {name: row(found) for name, found in runs.items()}


def artifacts(table: dict) -> Rows:
    """Distance of the shoulders' and hands' mean pose from the data's in closed loop, in the mean
    and in the worst style.
    """
    def row(runs: list[dict], end: str = "") -> dict[str, list[float]]:
        found = {}
        for part in ("clavicle", "hand"):
            values = [[100 * v for r in run["styles"].values() if math.isfinite(v := r[part + end])]
                      for run in runs]
            found |= {f"{part}, cm": [average(v) for v in values],
                      f"worst {part}, cm": [max(v) for v in values]}
        return found

    rows = {name: row(table["models"][name]["runs"]) for name in COMPARED}
    if "ceiling" in table:
        rows["published"] = row([table["ceiling"]])
    return rows | {"data, other clips": row(table["models"][COMPARED[0]]["runs"][:1], "_data")}


def blends(data: Features, runs: dict[str, list[Run]], folder: Path) -> Rows:
    """Change of a walk while its style vector is interpolated to that of another style.

    The last row is of clips that are blended linearly: it shows the recogniser's own boundary.
    """
    recogniser, pairs = judge(data, folder), interpolation.style_pairs(data.styles)
    rows = {}
    for name, of in runs.items():
        found = [interpolation.blend_walks(run, data, recogniser, pairs).numbers() for run in of]
        rows[name] = {key: [numbers[key] for numbers in found] for key in found[0]}
    return rows | {"data, blended": interpolation.blend_data(data, recogniser, pairs).numbers()}


def cases(data: Features, plan: Plan, folder: Path, name: str, command: str) -> list[Result]:
    """All cases for the comparison in a folder, as results ``NAME-CASE``.

    Raises
    ------
    ValueError
        If the comparison is not finished, or one of the models is missing.
    """
    table = read_json(folder / TABLE)
    if missing := {"pfnn-film", "mann-film", *COMPARED} - table["models"].keys():
        raise ValueError(f"{folder}: its comparison has no {', '.join(sorted(missing))}; "
                         "run it with --models all")
    runs = {model: [trained(data, plan.config(model, run["seed"]), folder)
                    for run in table["models"][model]["runs"]] for model in COMPARED}
    found = {
        "5.1.1 No global phase: the one phase of the PFNN follows the feet, so hands and arms get "
        "stuck or do not swing together.": stuck_hands(table, "pfnn-film", "lpn-film"),
        "5.1.2 Artifacts: with many styles, one-hot and adapters get artifacts in shoulders and "
        "hands; FiLM does not.": artifacts(table),
        "5.1.2 Interpolation: one-hot keeps the first style until the interpolation is complete; "
        "FiLM blends smoothly.": blends(data, runs, folder),
        "5.1.3 No phase features: the MANN is competitive, but arms can get stuck where limbs "
        "have cycles of their own.": stuck_hands(table, "mann-film", "lpn-film"),
    }
    return [result(name, claim, rows, command, len(data.styles)) for claim, rows in found.items()]


def result(name: str, claim: str, rows: Rows, command: str, styles: int) -> Result:
    """A case as it is stored; the title of the paper's ``claim`` is part of its name."""
    title = claim.partition(" ")[2].partition(":")[0].lower().replace(" ", "-")
    whole = ("of ", "styles below")
    columns = {key: [key.replace("|", ""), 0 if key.startswith(whole) else 3]
               for key in next(iter(rows.values()))}
    return Result(f"{name}-{title}", claim, f"{command}, then failures",
                  {"model": ["model"], **columns},
                  [{"model": model, **row} for model, row in rows.items()], {"styles": styles})
