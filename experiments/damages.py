"""What damages of recorded takes change in the table of `tk.evaluation.report`."""

from pathlib import Path
from typing import Annotated

import pandas as pd
import typer
from core import damages

from experiments.stylewalk import parts
from experiments.tables import Result, Store
from toolkit.evaluation import report

SIZES = {"noise": 1.0, "shaken": 0.005, "carried": 0.3, "leg": 0.02, "frozen": 0.5,
         "through": 0.9, "slowed": 0.7, "shortened": 0.7}


def run(
    data: Annotated[Path, typer.Option(help="Folder that holds bandai/.")], store: Store = False
) -> None:
    """Signed effects of damages on the rows of the table, with 95 % intervals."""
    found = {}
    for n, take in enumerate(takes := parts(data)[3]):
        made = {name: getattr(damages, name)(take, size) for name, size in SIZES.items()}
        rows = pd.DataFrame(report(made | {"whole": take}, take).rows[:-1], [*made, "whole"])
        rows = rows.select_dtypes("number").drop(columns="n")
        found[n] = rows - rows.loc["whole"]
    effects, rows = pd.concat(found).dropna(axis=1, how="all").swaplevel(), []
    for name, size in SIZES.items():
        one = effects.loc[name]
        drawn = [one.sample(frac=1, replace=True, random_state=k).mean() for k in range(1000)]
        ends = pd.DataFrame(drawn).quantile([0.025, 0.975])
        shown = pd.concat([one.mean().to_frame().T, ends]).where(lambda v: v.abs() > 1e-6, 0)
        rows.append({"damage": f"{name} {size}"} | {
            key: "{:+.2g} [{:+.2g}, {:+.2g}]".format(*shown[key]) for key in shown})
    Result("damages", f"Changes of {len(takes)} recorded takes (a quarter of Bandai-Namco 2): "
           "mean, interval of 95 %.", "python -m experiments damages --data DATA --store",
           {"damage": ["damage, size"]} | {key: [key] for key in effects}, rows).show(store)
