"""Table 1 of Mason et al. 2022, counted from the tables of 100STYLE."""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from toolkit.datasets import style100


def rows(root: Path | None = None) -> list[tuple[str, int, int, float]]:
    """Gait, frames, minutes and share of all frames in percent: eight gaits (TR1 to TR3 merged) and
    the total.

    The paper does not say how it rounds. All printed numbers result if minutes and ratios are
    rounded by the largest remainder, so that each column adds up to a rounded total. The ratios add
    up to 100.0 % (Backwards Walk is 18.949 %, printed 19.0). The minutes add up to 1125: the frames
    last 1126.7 minutes at 60 Hz, which is 1125 to the nearest quarter of an hour. So Backwards Run
    and Transitions, 120.6 and 218.6 minutes, are printed 120 and 218.
    """
    frames = dict.fromkeys(style100.GAITS.values(), 0)
    for (_, gait), (start, stop) in style100.frame_cuts(root).items():
        frames[style100.GAITS[gait]] += stop - start
    if not (total := sum(frames.values())):
        raise ValueError(f"{style100.SOURCE.folder(root)}: Frame_Cuts.csv has no frame of any take")
    total_minutes = 15 * round(total / style100.RATE / 60 / 15)
    minutes, tenths = (_apportion(list(frames.values()), n) for n in (total_minutes, 1000))
    found = [(gait, n, m, t / 10)
             for (gait, n), m, t in zip(frames.items(), minutes, tenths, strict=True)]
    return [*found, ("Total", total, total_minutes, 100.0)]


def _apportion(counts: list[int], total: int) -> list[int]:
    """Whole numbers proportional to ``counts`` that add up to ``total`` (method of the largest
    remainder).
    """
    shares = [n * total / sum(counts) for n in counts]
    whole = np.floor(shares).astype(int)
    whole[np.argsort(whole - shares, kind="stable")[: total - whole.sum()]] += 1
    return whole.tolist()


def run(root: Annotated[Path | None, typer.Option(help="Folder of 100STYLE.")] = None) -> None:
    """Frames, minutes and share of each gait of 100STYLE, as in Table 1 of Mason et al. 2022.

    The frames are those that ``Frame_Cuts.csv`` names; no recording is read.
    """
    print(f"{'Motion gait':<16}{'Frames':>11}{'Time (m)':>10}{'Ratio (%)':>11}")
    for gait, frames, minutes, ratio in rows(root):
        print(f"{gait:<16}{frames:>11,}{minutes:>10}{ratio:>11.1f}")
