"""The failure cases of Mason et al. 2022, section 5.1, tested on the runs of a comparison.

A case confirms the paper if the measures of every seed do.
"""

import math
from dataclasses import dataclass
from pathlib import Path

from experiments.seven_models import interpolation
from experiments.seven_models.models import (
    MOVING,
    SETTINGS,
    TABLE,
    Plan,
    average,
    judge,
    read_json,
    trained,
)
from experiments.tables import cell
from toolkit.features import Features
from toolkit.training import Run

STUCK = 0.5  # range of the hands / that of the data, below which hands are stuck
# styles without a global phase, always reported
NO_GLOBAL_PHASE = ("ArmsAtOtherFrequency", "PendulumHands", "Swimming")
COMPARED = ("lpn-onehot", "lpn-resad", "lpn-film")


@dataclass(frozen=True)
class Case:
    """A failure case: the paper's ``claim``, numbers in ``rows`` by model, and the ``verdict``."""

    section: str
    title: str
    claim: str
    rows: dict[str, dict[str, float | list[float]]]  # a list has a value per seed
    verdict: str

    def __str__(self) -> str:
        """The text to print."""
        columns = next(iter(self.rows.values()))
        head = f"{'':<16}" + "".join(f"{column:>18}" for column in columns)
        body = (
            f"{name:<16}" + "".join(f"{cell(v, 3):>18}" for v in row.values())
            for name, row in self.rows.items()
        )
        return "\n".join(
            (
                f"{self.section} {self.title}",
                f"The paper: {self.claim}",
                head,
                *body,
                f"Here: {self.verdict}.",
            )
        )


def stuck_hands(table: dict, model: str, than: str, section: str, title: str, claim: str) -> Case:
    """Range and correlation of the hands in closed loop of two models, relative to the data."""
    runs = {name: table["models"][name]["runs"] for name in (model, than)}
    moving = [
        style for style, row in runs[model][0]["styles"].items() if row["hands_data"] > MOVING
    ]

    def over_styles(name: str, key: str) -> list[float]:
        return [average([run["styles"][style][key] for style in moving]) for run in runs[name]]

    def row(found: list[dict]) -> dict[str, float | list[float]]:
        return {
            "range / data": [average([run["styles"][s]["hands"] for s in moving]) for run in found],
            "|corr. - data's|": [
                average([run["styles"][s]["together"] for s in moving]) for run in found
            ],
            f"styles below {STUCK}": [
                sum(run["styles"][s]["hands"] < STUCK for s in moving) for run in found
            ],
            "of styles": len(moving),
            "recognised": [run["recognised"] for run in found],
        }

    rows = {name: row(found) for name, found in runs.items()}
    if "ceiling" in table:
        rows["published"] = row([table["ceiling"]])
    stiffer = [
        b - a for a, b in zip(over_styles(model, "hands"), over_styles(than, "hands"), strict=False)
    ]
    apart = [
        a - b
        for a, b in zip(over_styles(model, "together"), over_styles(than, "together"), strict=False)
    ]
    share = {
        style: [average([run["styles"][style]["hands"] for run in runs[name]]) for name in runs]
        for style in moving
    }
    worst = max(share, key=lambda style: share[style][1] - share[style][0])
    told = list(dict.fromkeys([*(style for style in NO_GLOBAL_PHASE if style in share), worst]))
    verdict = (
        f"{_shown(stiffer)} that the hands of {model} move less than those of {than}, in "
        f"the {len(moving)} styles "
        f"whose hands move; {_shown(apart)} that their correlation is farther from the "
        f"data's. Range / the data's of "
        f"{model} and {than}: "
        + ", ".join(f"{s} {share[s][0]:.2f} and {share[s][1]:.2f}" for s in told)
    )
    return Case(section, title, claim, rows, verdict)


def artifacts(table: dict) -> Case:
    """Distance of the shoulders' and hands' mean pose from the data's in closed loop, in the mean
    and in the worst style.
    """

    def row(runs: list[dict], end: str = "") -> dict[str, list[float]]:
        found = {}
        for part in ("clavicle", "hand"):
            values = [
                [100 * v for r in run["styles"].values() if math.isfinite(v := r[part + end])]
                for run in runs
            ]
            found |= {
                f"{part}, cm": [average(v) for v in values],
                f"worst {part}, cm": [max(v) for v in values],
            }
        return found

    runs = {name: table["models"][name]["runs"] for name in COMPARED}
    rows = {name: row(found) for name, found in runs.items()}
    verdicts = []
    for part in ("clavicle", "hand"):
        pairs = zip(
            *(rows[name][f"{part}, cm"] for name in ("lpn-film", "lpn-onehot", "lpn-resad")),
            strict=False,
        )
        worse = [min(onehot, resad) - film for film, onehot, resad in pairs]
        verdicts.append(
            f"{_shown(worse)} that one-hot and adapters are farther from the data "
            f"than FiLM ({part}, cm)"
        )
    if "ceiling" in table:
        rows["published"] = row([table["ceiling"]])
    rows["data, other clips"] = row(next(iter(runs.values()))[:1], "_data")
    claim = (
        "with many styles, one-hot and adapters get artifacts in shoulders and hands; "
        "FiLM does not."
    )
    return Case("5.1.2", "Artifacts", claim, rows, "; ".join(verdicts))


def blends(data: Features, runs: dict[str, list[Run]], folder: Path) -> Case:
    """Change of a walk while its style vector is interpolated to that of another style."""
    recogniser, pairs = judge(data, folder), interpolation.style_pairs(data.styles)
    curves = {
        name: [interpolation.blend_walks(run, data, recogniser, pairs) for run in of]
        for name, of in runs.items()
    }
    numbers = {name: [c.numbers() for c in found] for name, found in curves.items()}
    even = interpolation.blend_data(data, recogniser, pairs)
    rows = {
        name: {key: [n[key] for n in found] for key in found[0]} for name, found in numbers.items()
    }
    later, wider, rougher = (
        [a[key] - b[key] for a, b in zip(numbers["lpn-onehot"], numbers["lpn-film"], strict=False)]
        for key in ("crosses at", "widest step", "gait's widest")
    )
    return Case(
        "5.1.2",
        "Interpolation",
        "one-hot keeps the first style until the interpolation is complete; FiLM blends smoothly.",
        rows | {"data, blended": even.numbers()},
        f"{_shown(later)} that one-hot keeps the first style longer than FiLM; "
        f"{_shown(wider)} that its largest step of the "
        f"recogniser's odds is larger, and {_shown(rougher)} that its largest step of "
        "the gait is larger. "
        "The last row is "
        "for clips that are blended linearly, and shows the recogniser's own boundary",
    )


def _shown(differences: list[float]) -> str:
    """Whether the differences, one per seed, are all positive, in words."""
    least, most = min(differences), max(differences)
    if any(d != d for d in differences):
        return "cannot say"
    seeds = f"{len(differences)} seed" + ("s" if len(differences) > 1 else "")
    return (
        f"{'shows' if least > 0 else 'does not show'} (by {least:+.2f} to {most:+.2f} in {seeds})"
    )


def stored_plan(folder: Path) -> Plan:
    """Settings of the runs in a folder."""
    settings = read_json(folder / SETTINGS)
    return Plan(settings["size"], settings["steps"])


def cases(data: Features, folder: Path) -> list[Case]:
    """All cases for the comparison in a folder.

    Raises
    ------
    ValueError
        If the comparison is not finished, or one of the models is missing.
    """
    table = read_json(folder / TABLE)
    if missing := {"pfnn-film", "mann-film", *COMPARED} - table["models"].keys():
        raise ValueError(
            f"{folder}: its comparison has no {', '.join(sorted(missing))}; "
            "run it with --models all"
        )
    plan = stored_plan(folder)
    runs = {
        name: [
            trained(data, plan.config(name, run["seed"]), folder)
            for run in table["models"][name]["runs"]
        ]
        for name in COMPARED
    }
    return [
        stuck_hands(
            table,
            "pfnn-film",
            "lpn-film",
            "5.1.1",
            "No global phase",
            "the one phase of the PFNN follows the feet, so hands and arms get stuck or do not "
            "swing together.",
        ),
        artifacts(table),
        blends(data, runs, folder),
        stuck_hands(
            table,
            "mann-film",
            "lpn-film",
            "5.1.3",
            "No phase features",
            "the MANN is competitive, but arms can get stuck where limbs have cycles of their own.",
        ),
    ]
