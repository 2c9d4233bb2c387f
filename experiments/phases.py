"""Phase sources, compared with the truth about procedural clips, and with labelled phases."""

import math
from dataclasses import dataclass, replace

import torch
from course import labels
from course.labels import Row, measure
from torch import Tensor

from experiments.tables import Result, Store
from toolkit import phases as ph
from toolkit.datasets import home, procedural
from toolkit.motion.contacts import FEET

STAGGERING = ("Neutral", "Zombie")  # also measured with the random steps of the Drunk
CASES = ("cyclic", "asymmetric", "no global phase", "one leg never touches", "stochastic")
SECONDS = 30.0  # of a clip
PLANNED = ("Neutral", "Old", "Zombie", "Drunk")  # styles that are labelled by their true contacts
#: Columns of the stored results that are no errors.
TITLES = {"case": ["styles"], "styles": ["of them", 0], "limbs": ["limbs"], "take": ["take"],
          "foot": ["foot"]}


@dataclass(frozen=True)
class Part:
    """Limbs by their columns in `toolkit.phases.LIMBS`, and a source."""

    columns: slice
    source: str

    def frequency_error(self, row: Row) -> Tensor:
        """Larger relative error of the mean frequencies of both limbs, by that source."""
        found = row.frequency.get(self.source, torch.full((4,), math.nan))[self.columns]
        return found.nan_to_num().max() if not found.isnan().all() else found.max()


PARTS = {"feet": Part(slice(2, 4), "contact"),
         "hands": Part(slice(0, 2), "contact-free")}


def run(store: Store = False) -> None:
    """Errors of the phase sources against the truth about procedural clips and against labels.

    The labels are those of the takes of Holden et al. 2017 in the folder of datasets.
    """
    sources = {name: ph.named(name) for name in ph.SOURCES}
    named = dict(procedural.STYLES)
    for name in STAGGERING:
        named[f"{name} staggering"] = replace(procedural.STYLES[name], stagger=1.0)
    rows: dict[str, list[Row]] = {case: [] for case in CASES}
    for name, style in named.items():
        made = name if name in procedural.STYLES else style
        clip, known = procedural.truth(made, "FW", SECONDS, 0)
        rows[case(style)].append(measure(f"{name} FW", clip, known, sources))

    kept = []
    for group, members in rows.items():
        for limbs, part in PARTS.items() if members else ():
            means = {name: float(torch.stack([row.phase[name][part.columns]
                                              for row in members]).nanmean()) for name in sources}
            kept.append({"case": group, "styles": len(members), "limbs": limbs, **means})
    walks = f"Mean circular error in procedural walks of {SECONDS:g} s, degrees, less a lag of"
    about = {
        "phases": f"{walks} each limb",
        "phases-labelled": "Mean errors of the feet in moving frames against labelled phases, "
                           "degrees, less a constant lag of each"}
    for name, members in zip(about, (kept, against(sources)), strict=True):
        keys = dict.fromkeys(key for row in members for key in row)
        columns = {key: TITLES.get(key, [f"`{key}`" if key in sources else key, 1]) for key in keys}
        numbers = worst(rows["cyclic"]) if name == "phases" else {}
        found = Result(name, about[name], "python -m experiments phases --store", columns, members,
                       {}, numbers)
        if numbers:
            print("Largest errors in a cyclic style, and the least F1 of contacts: "
                  + ", ".join(f"{what} {value:.3g}" for what, value in numbers.items()))
        found.show(store)


def worst(rows: list[Row]) -> dict[str, float]:
    """The largest errors of `PARTS` in some styles, degrees and shares; the least F1 of contacts.

    The errors are means of both sides.
    """
    found = {}
    for limbs, part in PARTS.items():
        means = [float(row.phase[part.source][part.columns].nanmean()) for row in rows]
        found[f"{part.source}, {limbs}"] = max(mean for mean in means if not math.isnan(mean))
    found["frequency"] = max(float(p.frequency_error(row)) for row in rows for p in PARTS.values())
    return found | {"F1": min(min(row.f1) for row in rows)}


def against(sources: dict[str, ph.Source]) -> list[dict]:
    """Errors against labelled phases: of procedural transitions, and of recorded takes.

    The label is straight between the touch-downs of both feet, the floor between those of one.
    """
    takes = [(f"{style} TR1 (procedural)", labels.planned(style, "TR1", SECONDS, 0))
             for style in PLANNED]
    place = home.folder(labels.NAME)
    if place.is_dir():
        takes += [(f"{take.clip.name} (recorded)", take) for take in labels.read(place)]
    else:
        print(f"no labelled recordings: {place} does not exist")
    kept = []
    for name, take in takes:
        errors = {"floor": labels.floor(take)}
        errors |= {label: labels.errors(take, source) for label, source in sources.items()}
        kept += [{"take": name, "foot": side,
                  **{label: float(error[i]) for label, error in errors.items()}}
                 for i, side in enumerate(FEET)]
    return kept


def case(style: procedural.Style) -> str:
    """The one of `CASES` of a style."""
    if style.stagger > 0:
        return "stochastic"
    legs, arms = ([part("left"), part("right")] for part in (style.leg, style.arm))
    if any(leg.raised for leg in legs):
        return "one leg never touches"
    if style.asymmetry or legs[0] != legs[1]:
        return "asymmetric"
    return "no global phase" if any(arm.ratio != 1 or arm.phase for arm in arms) else "cyclic"
