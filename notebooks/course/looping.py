"""The part of a clip that repeats without a jump, for moving pictures."""

import torch

from toolkit.motion import Clip, root_frames
from toolkit.motion.contacts import velocities
from toolkit.view.render.bodies import steady_frames

SECONDS = 1.6, 5.0  # of a loop, at least and at most
# metres that differences between the ends of a loop count as: of headings, a radian; of velocities,
# 1 m/s; a loop must match better by so much to be a second longer
HEADING, GLANCE, LONGER = 0.8, 0.1, 0.02


def loop(clip: Clip) -> tuple[int, int]:
    """First and last (not included) frame of the part of a clip that best ends as it began.

    Places and velocities of the joints in the root frame are compared, and the heading, in the
    first half minute. A clip too short for a loop is taken whole. ValueError if the skeleton has no
    hips or shoulders.
    """
    searched = clip.cut(stop=min(len(clip), round(30 * clip.fps)))
    shortest, longest = (round(seconds * clip.fps) for seconds in SECONDS)
    longest = min(longest, len(searched) - 3)
    if shortest > longest:
        return 0, len(clip)

    # distances between all frames; a diagonal has those of all loops of one length
    roots, positions = root_frames(searched), searched.global_positions
    places = roots.to_local(positions).flatten(1)
    moves = roots.turn_to_local(velocities(positions, clip.fps)).flatten(1)
    heading = torch.from_numpy(steady_frames(searched)[1])[:, None]
    rows = torch.cat((places, GLANCE * moves), 1) / len(clip.skeleton) ** 0.5
    rows = torch.cat((rows, HEADING * heading.to(rows)), 1)
    apart = torch.cdist(rows, rows)

    # the last frame is compared with the first, and neither is at an end of the clip
    best = []
    for frames in range(shortest, longest + 1):
        misfit, start = apart.diagonal(frames)[1:-1].min(0)
        best.append((float(misfit) + LONGER * frames / clip.fps, int(start) + 1, frames))
    _, start, frames = min(best)
    return start, start + frames
