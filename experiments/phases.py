"""Phase sources, compared with the truth about procedural clips, and with labelled phases."""

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated

import torch
import typer
from course import labels
from course.labels import STILL, Row, measure
from torch import Tensor

from experiments.tables import Result, Store
from toolkit import phases as ph
from toolkit.datasets import home, procedural
from toolkit.motion.contacts import FEET

STAGGERING = ("Neutral", "Zombie")  # also measured with the random steps of the Drunk
FREQUENCY_LIMIT, F1_LIMIT = 0.03, 0.95
CASES = ("cyclic", "asymmetric", "no global phase", "one leg never touches", "stochastic")
PLANNED = ("Neutral", "Old", "Zombie", "Drunk")  # styles that are labelled by their true contacts
#: Columns of the stored results that are no errors.
TITLES = {"case": ["styles"], "styles": ["of them", 0], "limbs": ["limbs"], "take": ["take"],
          "foot": ["foot"]}
LABEL_LIMIT, FLOOR_LIMIT = 20.0, 10.0  # degrees, of the default source: in all, above the floor


@dataclass(frozen=True)
class Part:
    """Limbs by their columns in `toolkit.phases.LIMBS`; a source and its error limit, degrees."""

    columns: slice
    source: str
    limit: float

    def frequency_error(self, row: Row) -> Tensor:
        """Larger relative error of the mean frequencies of both limbs, by that source."""
        found = row.frequency.get(self.source, torch.full((4,), math.nan))[self.columns]
        return found.nan_to_num().max() if not found.isnan().all() else found.max()


PARTS = {"feet": Part(slice(2, 4), "contact", 20.0),
         "hands": Part(slice(0, 2), "contact-free", 15.0)}


def run(
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; default: all.")] = None,
    gaits: Annotated[str, typer.Option(help="Comma-separated gaits.")] = "FW",
    seconds: Annotated[float, typer.Option(help="Length of each clip.")] = 30.0,
    seed: Annotated[int, typer.Option(help="Seed of the clips.")] = 0,
    source: Annotated[str, typer.Option(help="Comma-separated phase sources.")] = ",".join(
        ph.SOURCES),
    labelled: Annotated[Path | None, typer.Option(
        help="Folder of labelled takes (Holden et al. 2017); default: "
             f"{labels.NAME} in the folder of datasets.")] = None,
    store: Store = False,
) -> None:
    """Errors of the phase sources against the truth about procedural clips and against labels."""
    sources = {name: ph.named(name) for name in source.split(",")}
    chosen = styles.split(",") if styles else procedural.STYLES
    named = {name: procedural.STYLES.get(name, name) for name in chosen}
    if styles is None:
        for name in STAGGERING:
            named[f"{name} staggering"] = replace(procedural.STYLES[name], stagger=1.0)
    rows: dict[str, list[Row]] = {case: [] for case in CASES}
    for gait in gaits.split(","):
        for name, style in named.items():
            made = name if name in procedural.STYLES else style
            clip, known = procedural.truth(made, gait, seconds, seed)
            rows[case(style)].append(measure(f"{name} {gait}", clip, known, sources))

    kept = []
    titles = "".join(f"{name:>14}" for name in sources)
    print(f"{'degrees':<34}{titles}{'frequency':>12}{'contact F1':>12}")
    for group, members in rows.items():
        for row in members:
            _print_row(row, sources)
        for limbs, part in PARTS.items() if members else ():
            means = {}
            for name in sources:
                errors = torch.stack([row.phase[name][part.columns] for row in members])
                means[name] = errors.nanmean()
            numbers = {name: float(mean) for name, mean in means.items()}
            kept.append({"case": group, "styles": len(members), "limbs": limbs, **numbers})
            name = f"= {group}" if limbs == "feet" else ""
            shown = "".join(_number(mean, "°", 14) for mean in means.values())
            print(f"{name:<26}{limbs:<8}{shown}")
    print(f"{gaits}, {seconds:g} s, seed {seed}: mean circular error while stepping, less a "
          "constant lag per limb; error of the mean\nfrequency (feet: contact, hands: "
          "contact-free). —: undefined, for hands without contact or a hand that moves under "
          f"{100 * STILL:g} cm.")
    failed = [f"{row.name}: {what}" for row in rows["cyclic"] for what in failures(row)]
    limits = ", ".join(f"{part.source} {limbs} {part.limit:g}°" for limbs, part in PARTS.items())
    print(f"Limits for cyclic styles: {limits}, "
          f"frequency {FREQUENCY_LIMIT:.0%}, F1 {F1_LIMIT}: {'; '.join(failed) or 'all kept'}")
    print()
    against = _labels(sources, labelled, seconds, seed)
    if store:
        walks = f"Mean circular error in procedural walks of {seconds:g} s, degrees, less a lag of"
        tables = {
            "phases": (f"{walks} each limb", kept),
            "phases-labelled": ("Mean errors of the feet in moving frames against labelled phases, "
                                "degrees, less a constant lag of each", against)}
        for name, (about, members) in tables.items():
            keys = dict.fromkeys(key for row in members for key in row)
            columns = {key: TITLES.get(key, [f"`{key}`" if key in sources else key, 1])
                       for key in keys}
            numbers = worst(rows["cyclic"]) if name == "phases" else {}
            command = "python -m experiments phases --store"
            Result(name, about, command, columns, members, {}, numbers).save()


def _print_row(row: Row, sources: dict[str, ph.Source]) -> None:
    for limbs, part in PARTS.items():
        means = (row.phase[name][part.columns].nanmean() for name in sources)
        errors = "".join(_number(mean, "°", 14) for mean in means)
        frequency = _number(100 * part.frequency_error(row), " %", 12)
        name, f1 = (row.name, f"{min(row.f1):>12.3f}") if limbs == "feet" else ("", "")
        print(f"{name:<26}{limbs:<8}{errors}{frequency}{f1}")


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


def _labels(sources: dict[str, ph.Source], folder: Path | None, seconds: float,
            seed: int) -> list[dict]:
    """Print the errors against labelled phases: procedural transitions, and recorded takes."""
    takes = [(f"{style} TR1", labels.planned(style, "TR1", seconds, seed)) for style in PLANNED]
    place = folder or home.folder(labels.NAME)
    if folder is not None or place.is_dir():
        takes += [(take.clip.name, take) for take in labels.read(place)]
    else:
        print(f"no labelled recordings: {place} does not exist")
    titles = "".join(f"{name:>14}" for name in sources)
    print(f"{'degrees, labelled':<26}{'frames':>8}{'floor':>14}{titles}")
    failed, kept = [], []
    for name, take in takes:
        errors = {"floor": labels.floor(take)}
        errors |= {label: labels.errors(take, source) for label, source in sources.items()}
        for i, side in enumerate(FEET):
            frames = f"{int(take.labelled.sum()):>8}" if i == 0 else " " * 8
            numbers = "".join(_number(error[i], "°", 14) for error in errors.values())
            kind = "procedural" if name.endswith("TR1") else "recorded"
            row = {"take": f"{name} ({kind})", "foot": side}
            kept.append(row | {label: float(error[i]) for label, error in errors.items()})
            print(f"{f'{name[:19]:<20}{side}':<26}{frames}{numbers}")
            limit = min(LABEL_LIMIT, errors["floor"][i] + FLOOR_LIMIT)
            if "hybrid" in errors and errors["hybrid"][i] > limit:
                failed.append(f"{name} {side} {float(errors['hybrid'][i]):.1f}°")
    print("Feet in moving frames, less a constant lag of each. The label is straight between the "
          "touch-downs of both feet,\nthe floor between those of one. The contact source is the "
          "paper's, and was the default's for feet.\n"
          f"Limits of hybrid, the default: {LABEL_LIMIT:g}°, {FLOOR_LIMIT:g}° above the floor: "
          f"{'; '.join(failed) or 'all kept'}")
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


def failures(row: Row) -> list[str]:
    """The limits that a row exceeds, in words."""
    found = []
    for limbs, part in PARTS.items():
        errors = row.phase.get(part.source, torch.zeros(4))
        worst = errors[part.columns].nan_to_num().max()
        if worst > part.limit:
            found.append(f"{part.source} {limbs} {worst:.1f}°")
        if part.frequency_error(row) > FREQUENCY_LIMIT:
            found.append(f"frequency of the {limbs} {float(part.frequency_error(row)):.1%}")
    if min(row.f1) < F1_LIMIT:
        found.append(f"F1 {min(row.f1):.3f}")
    return found


def _number(value: Tensor, unit: str, width: int) -> str:
    return f"{'—':>{width}}" if value.isnan() else f"{f'{float(value):.1f}{unit}':>{width}}"
