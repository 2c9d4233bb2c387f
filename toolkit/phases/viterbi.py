"""The cheapest path through states (Viterbi 1967), compiled."""

import numpy as np

from toolkit.io.compilation import compiled


@compiled()
def smoothest(cost, jump):
    """The path ``[F]`` of states with the least sum of costs ``[F, M]`` and jumps ``[M, M]``."""
    total, back = cost[0].copy(), np.empty(cost.shape, np.int64)
    for frame in range(1, len(cost)):
        before = total.copy()
        for new in range(len(jump)):
            reached = before + jump[:, new]
            back[frame, new] = np.argmin(reached)
            total[new] = reached[back[frame, new]] + cost[frame, new]
    path = np.empty(len(cost), np.int64)
    path[-1] = np.argmin(total)
    for frame in range(len(cost) - 1, 0, -1):
        path[frame - 1] = back[frame, path[frame]]
    return path
