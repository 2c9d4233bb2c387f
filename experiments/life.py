"""The life of styles beside its floors: none, the same noise without smoothing, and on all of FiLM.
"""

from unittest import mock

import torch
from torch import Tensor

from experiments.closed_loop import MISBEHAVES, measures_of, walked
from experiments.tables import Result, Store
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.runtime import life

SHOWN = {"slow": "slow motion, cm", "toes": "toes in contact, cm/s", "direction": "direction, °",
         "found": "seconds with a finding, %"}


def run(parameters: verbs.Published, store: Store = False) -> None:
    """Natural walks of the published styles, with life and with its floors."""
    net, bank = published.either(None, parameters)
    bank = bank.select([name for name in bank.names if name != MISBEHAVES])
    fast, vectors = runtime.compile(net), bank.vectors
    pace = torch.tensor([[bank.speed(name)] for name in bank.names])

    def whole(frame: int) -> Tensor:
        quarter = vectors.shape[-1] // 4
        scales = life.alive(vectors.roll(-quarter, -1), net.life)(frame).roll(quarter, -1)
        return shifts(frame) + scales - vectors

    shifts, rows = life.alive(vectors, net.life), []
    for name, style, period in (("none", vectors, life.PERIOD), ("life", shifts, life.PERIOD),
                                ("new numbers in each frame", life.alive(vectors, net.life), 1),
                                ("scales as well", whole, life.PERIOD)):
        with mock.patch.object(life, "PERIOD", period):
            walks = walked(fast, style, "alive", pace)
        found = [measures_of(net, walk, "alive", float(p))
                 for walk, p in zip(walks, pace, strict=True)]
        middle = {key: torch.tensor([row[key] for row in found]).median() for key in SHOWN}
        share = sum(row["found"] for row in found) / len(found)
        rows.append({"noise": name} | {key: float(x) for key, x in middle.items()}
                    | {"found": share})
    columns = {"noise": ["noise"]} | {key: [title, 2] for key, title in SHOWN.items()}
    Result("life", f"Natural walks of {len(bank)} published styles, one seed: medians, and the "
                   "mean share of seconds", "python -m experiments life --published FOLDER --store",
           columns, rows).show(store)
