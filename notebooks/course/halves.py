"""Windows of motions in two parts without a common take."""

import torch

from toolkit.features.splits import generator
from toolkit.stylization import Motions


def split(motions: Motions, share: float, seed: int) -> tuple[Motions, Motions]:
    """Two sets of windows with different takes, the second with a ``share`` of the takes.

    It is about this share of the takes of every domain and content. A take and its mirror image are
    in the same set. What a seed chooses of a domain and content depends on no other one.

    Raises
    ------
    ValueError
        If ``share`` is not between 0 and 1.
    """
    if not 0 < share < 1:
        raise ValueError(f"the share of the second part must lie between 0 and 1, got {share}")
    second = torch.zeros(int(motions.take.max()) + 1, dtype=torch.bool)
    labels = torch.stack((motions.take, motions.domain, motions.content), 1).flip(0).tolist()
    # by flipping, a take gets the labels of the original, which come before its mirror image's
    originals = {t: (d, c) for t, d, c in labels}
    for d, c in sorted(set(originals.values())):
        takes = torch.tensor(sorted(t for t, kind in originals.items() if kind == (d, c)))
        draw = generator(seed, motions.domains[d], motions.contents[c])
        order = torch.randperm(len(takes), generator=draw)
        second[takes[order[: round(share * len(takes))]]] = True
    mask = second[motions.take]
    return motions.select(~mask), motions.select(mask)
