"""Random bodies and motions for the property tests."""

import torch
from hypothesis import strategies as st

from toolkit.motion import Clip, Skeleton, rotations as R

seeds = st.integers(0, 2**31 - 1)

#: A joint, its parent and its offset in each line.
HUMAN = """Hips - 0 0 0
Chest Hips 0 .3 .02
Head Chest 0 .3 .02
HeadEnd Head 0 .2 0
LeftShoulder Chest .15 .2 0
LeftElbow LeftShoulder .3 0 0
LeftHand LeftElbow .25 0 .01
LeftHandEnd LeftHand .1 0 0
RightShoulder Chest -.15 .2 0
RightElbow RightShoulder -.3 0 0
RightHand RightElbow -.25 0 .01
RightHandEnd RightHand -.1 0 0
LeftHip Hips .1 -.05 0
LeftKnee LeftHip 0 -.4 0
LeftFoot LeftKnee 0 -.4 0
LeftToe LeftFoot 0 -.05 .15
RightHip Hips -.1 -.05 0
RightKnee RightHip 0 -.4 0
RightFoot RightKnee 0 -.4 0
RightToe RightFoot 0 -.05 .15"""


def human() -> Skeleton:
    """A symmetric body in a T-pose: +Z forward, left +X."""
    rows = [line.split() for line in HUMAN.splitlines()]
    names = [row[0] for row in rows]
    parents = [-1] + [names.index(row[1]) for row in rows[1:]]
    return Skeleton(names, parents, torch.tensor([[float(v) for v in row[2:]] for row in rows]))


def quaternions(seed: int, *shape: int, dtype=torch.float64) -> torch.Tensor:
    return R.normalize(
        torch.randn(*shape, 4, generator=torch.Generator().manual_seed(seed), dtype=dtype)
    )


def human_clip(seed: int, frames: int = 12, fps: float = 30.0, bend: float = 0.5) -> Clip:
    """A body that bends every joint by up to about ``bend`` radians."""
    generator = torch.Generator().manual_seed(seed)
    skeleton = human()
    angles = bend * (2 * torch.rand(frames, len(skeleton), 3, generator=generator) - 1)
    angles[:, [j for j in range(len(skeleton)) if skeleton.is_end(j)]] = 0
    position = torch.randn(frames, 3, generator=generator).cumsum(0) * 0.02 + torch.tensor(
        [0.0, 1.0, 0.0]
    )
    return Clip(skeleton, R.from_euler(angles, "YXZ"), position, fps)


@st.composite
def clips(draw) -> Clip:
    """Any tree of 1 to 8 joints, each leaf with or without an End Site, in any rotation."""
    n = draw(st.integers(1, 8))
    parents = [-1] + [draw(st.integers(0, j - 1)) for j in range(1, n)]
    names = [f"joint{j}" for j in range(n)]
    for j in range(n):
        if j not in parents and draw(st.booleans()):
            names.append(f"joint{j}End")
            parents.append(j)
    seed, frames = draw(seeds), draw(st.integers(1, 5))
    generator = torch.Generator().manual_seed(seed)
    rotations = quaternions(seed, frames, len(names), dtype=torch.float32)
    rotations[:, n:] = R.identity(frames, len(names) - n)
    offsets = torch.randn(len(names), 3, generator=generator)
    offsets[0] = 0
    fps = draw(st.sampled_from([24.0, 30.0, 60.0, 120.0, 29.97]))
    return Clip(Skeleton(tuple(names), tuple(parents), offsets), rotations,
                torch.randn(frames, 3, generator=generator), fps)
