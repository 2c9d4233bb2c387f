"""Phase sources against the truth of the procedural clips."""

from dataclasses import replace
from typing import Annotated

import torch
import typer
from torch import Tensor

from toolkit import phases as ph
from toolkit.datasets import procedural
from toolkit.evaluation import phases as truth

STAGGERING = ("Neutral", "Zombie")  # also measured staggering like the drunk


def run(
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    gaits: Annotated[str, typer.Option(help="Comma-separated gaits.")] = "FW",
    seconds: Annotated[float, typer.Option(help="Length of each clip.")] = 30.0,
    seed: Annotated[int, typer.Option(help="Of the clips.")] = 0,
    source: Annotated[str, typer.Option(help="Comma-separated phase sources.")] = ",".join((*ph.SOURCES, "learned")),
) -> None:
    """Extract the phases of clips whose true phases, frequencies and contacts are known, and say how far off they are."""
    sources = {name: ph.named(name) for name in source.split(",")}
    named = {name: procedural.STYLES.get(name, name) for name in (styles.split(",") if styles else procedural.STYLES)}
    if styles is None:
        named |= {f"{name} staggering": replace(procedural.STYLES[name], stagger=1.0) for name in STAGGERING}
    rows = []
    for gait in gaits.split(","):
        for name, style in named.items():
            clip, known = procedural.truth(name if name in procedural.STYLES else style, gait, seconds, seed)
            rows.append(truth.measure(f"{name} {gait}", clip, known, truth.kind(style), sources))

    print(f"{'degrees':<34}" + "".join(f"{name:>14}" for name in sources) + f"{'frequency':>12}{'contact F1':>12}")
    for group in truth.KINDS:
        members = [row for row in rows if row.kind == group]
        for row in members:
            for limbs, part in truth.PARTS.items():
                errors = "".join(_number(row.phase[s][part.columns].nanmean(), "°", 14) for s in sources)
                name, f1 = (row.name, f"{min(row.f1):>12.3f}") if limbs == "feet" else ("", "")
                print(f"{name:<26}{limbs:<8}{errors}{_number(100 * part.slip(row), ' %', 12)}{f1}")
        for limbs, part in truth.PARTS.items() if len(members) > 1 else ():
            means = {s: torch.stack([r.phase[s][part.columns] for r in members]).nanmean() for s in sources}
            name = f"= {group}" if limbs == "feet" else ""
            print(f"{name:<26}{limbs:<8}" + "".join(_number(mean, "°", 14) for mean in means.values()))
            if group == "stochastic" and {"coherent", "contact-free"} <= set(sources):
                gain = 1 - float(means["coherent"] / means["contact-free"])
                print(f"{'':<34}{limbs}: coherent is nearer to the truth than contact-free by {gain:.0%}")
    print(f"{gaits}, {seconds:g} s, seed {seed}: mean circular error while stepping, less a constant lag per limb; error of "
          "the mean\nfrequency (feet by contacts, hands contact-free). —: nothing to find, no contact or a hand that moves "
          f"under {100 * truth.STILL:g} cm.")
    failed = [f"{row.name}: {what}" for row in rows if row.kind == "cyclic" for what in truth.failures(row)]
    limits = ", ".join(f"{part.source} {limbs} {part.limit:g}°" for limbs, part in truth.PARTS.items())
    print(f"On cyclic styles, {limits}, "
          f"frequency {truth.FREQUENCY_LIMIT:.0%}, F1 {truth.F1_LIMIT}: {'; '.join(failed) or 'all kept'}")


def _number(value: Tensor, unit: str, width: int) -> str:
    return f"{'—':>{width}}" if value.isnan() else f"{f'{float(value):.1f}{unit}':>{width}}"
