"""Walks of equal blends of two styles beside those of the styles: how many have a defect?"""

from itertools import combinations

import torch
from tqdm import tqdm

from experiments.closed_loop import measures_of, walked
from experiments.tables import Result, Store
from toolkit import pretrained, runtime

COLUMNS = {"model": ["model"], "what": ["walks of"], "walks": ["walks", 0],
           "any": ["with a finding, %", 0], "found": ["seconds with a finding, %", 1]}


def run(store: Store = False) -> None:
    """Natural walks of all styles, and of all pairs of styles half and half."""
    rows = []
    for name in ("procedural", "recorded"):
        net, bank = pretrained(name)
        fast = runtime.compile(net)
        pairs = [{a: 0.5, b: 0.5} for a, b in combinations(bank.names, 2)]
        for what, weights in (("styles", [{style: 1.0} for style in bank.names]),
                              ("half and half", pairs)):
            vectors = torch.stack([bank.blend(each) for each in weights])
            pace = torch.tensor([[bank.speed(each)] for each in weights])
            walks = walked(fast, vectors, "natural", pace)
            found = [measures_of(net, walk, "natural", float(p))
                     for walk, p in zip(tqdm(walks, disable=None), pace, strict=True)]
            share = torch.tensor([row["found"] for row in found])  # of the seconds, %
            rows.append({"model": name, "what": what, "walks": len(found),
                         "any": 100 * float((share > 0).float().mean()),
                         "found": float(share.mean())})
    Result("blends", "Eight seconds at natural speed, after three; one rollout each",
           "python -m experiments blends --store", COLUMNS, rows).show(store)
