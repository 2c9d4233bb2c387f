"""What content restyled motions lose: which actions are taken for which, and by what of the motion the judge goes."""

import numpy as np
import torch
from torch import Tensor

from experiments.stylization import evaluation, sets
from experiments.stylization.judges import Judges
from toolkit.stylization.data import Motions

KEPT = ("style", "both", "movement", "fmd", "domain_fmd", "diversity", "bone", "contact_f1", "acceleration")


def of_style_and_content(train: Motions, sources: Motions, target: Tensor) -> Tensor | None:
    """The training motion of the target style and the source's content that is nearest to the source, by its positions.

    It is recorded motion of what was asked for, and the judges do not see the root path, which every method takes from the
    source. So no way of restyling can be expected to be above it. None if a style has no motion of a content.
    """
    names = np.array([{**sets.OTHERS, **sets.CONTENTS}.get(name, name) for name in train.contents])[train.content.numpy()]
    made = torch.empty_like(sources.x)
    for row in range(len(made)):
        fits = (train.domain == target[row]) & torch.from_numpy(names == sources.contents[sources.content[row]])
        if not fits.any():
            return None
        own = train.x[fits]
        made[row] = own[torch.cdist(sources.x[row : row + 1, :3].flatten(1), own[:, :3].flatten(1)).argmin()]
    return made


def named(judges: Judges, made: Tensor, sources: Motions, recorded: Tensor | None) -> dict[str, float]:
    """Shares of results ``[P, 7, T, N]`` whose content is recognised, by content and with parts of recorded motions.

    ``content`` in all; ``gait``, if walks with and without turns count as one; that of each content; and
    ``movement_of_recorded`` and ``pose_of_recorded``: if the deviations and speeds, or the means, that the judge sees are
    those of ``recorded``.
    """
    own = judges.content.described(made)
    truth, gaits = sources.content.numpy(), np.array([name.partition("-")[0] for name in sources.contents])
    right = judges.content.pipeline.predict(own)
    found = {"content": right == truth, "gait": gaits[right] == gaits[truth]}
    found |= {name: right[truth == k] == k for k, name in enumerate(sources.contents)}
    if recorded is not None:
        real, means = judges.content.described(recorded), own.shape[1] // 3
        for key, pose, movement in (("movement_of_recorded", own, real), ("pose_of_recorded", real, own)):
            mixed = np.concatenate((pose[:, :means], movement[:, means:]), 1)
            found[key] = judges.content.pipeline.predict(mixed) == truth
    return {key: float(each.mean()) for key, each in found.items()}


def line(judges: Judges, made: list[Tensor], sources: Motions, target: Tensor, recorded: Tensor | None) -> dict[str, float]:
    """`named` of one or two results for the same sources, and of `evaluation.measures` those that are `KEPT`."""
    shares = evaluation.measures(sources, target, made, judges)
    times = torch.arange(len(sources)).repeat(len(made))
    again = None if recorded is None else recorded[times]
    return named(judges, torch.cat(made), sources.select(times), again) | {key: shares[key] for key in KEPT}
