"""Concatenation of clips to one long motion of several contents (heterogeneous motion, Park et al.
2021, Figure 5).
"""

from collections.abc import Sequence

import torch

from toolkit.motion import Clip, root_frames, rotations as R


def medley(clips: Sequence[Clip], overlap: float = 0.5) -> Clip:
    """Several clips in one: each starts where the clip before it ends, with the same facing, and
    the two are cross-faded.

    The clips have one skeleton and rate. Poses and paths are cross-faded for ``overlap`` seconds.
    The result has the labels of the first clip, but a ``gait`` that lists all gaits.

    Raises
    ------
    ValueError
        If there is no clip, the clips differ in skeleton or rate, or one is shorter than its
        cross-fades.
    """
    if not clips or any(
        (c.skeleton.names, c.fps) != (clips[0].skeleton.names, clips[0].fps) for c in clips
    ):
        rates = ", ".join(sorted({f"{c.fps:g} Hz" for c in clips}))
        raise ValueError(
            f"a medley needs clips of one skeleton and rate, got {len(clips)} clips of "
            f"{rates or 'none'}"
        )
    fade = max(1, round(overlap * clips[0].fps))
    if short := [c for c in clips if len(c) < 2 * fade]:
        raise ValueError(
            f"{short[0].name}: its fades of {overlap} s need {2 * fade} frames, it has "
            f"{len(short[0])}"
        )
    whole, share = clips[0], torch.linspace(0, 1, fade + 2)[1:-1]
    share = share * share * (3 - 2 * share)
    for clip in clips[1:]:
        here, there = root_frames(whole.cut(len(whole) - fade)), root_frames(clip.cut(0, 1))
        turn = 2 * torch.atan2(
            *R.multiply(here.rotations[0], R.inverse(there.rotations[0]))[[2, 0]]
        )
        clip = clip.moved(float(turn))
        clip = clip.moved(
            shift=(here.positions[0] - root_frames(clip.cut(0, 1)).positions[0]).tolist()
        )
        old, new = whole.cut(len(whole) - fade), clip.cut(0, fade)
        path = torch.lerp(old.root_positions, new.root_positions, share[:, None])
        turned = R.slerp(old.rotations, new.rotations, share[:, None])
        rotations = torch.cat((whole.rotations[:-fade], turned, clip.rotations[fade:]))
        positions = torch.cat((whole.root_positions[:-fade], path, clip.root_positions[fade:]))
        whole = whole.replace(rotations=R.unroll(rotations), root_positions=positions)
    return whole.replace(gait=" → ".join(clip.gait for clip in clips), name="medley")
