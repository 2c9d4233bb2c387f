"""Motion features of Park et al. 2021 (section 4): windows of positions and rotations of joints.

A motion is ``x [7, T, N]`` at 30 Hz: the position (metres) and the unit quaternion of every joint
in the root frame, whose origin is the root on the ground. The velocity of the root is no feature,
it is never changed. End Sites have no features.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import torch
from torch import Tensor, nn

from toolkit.motion import Clip, Skeleton, local_rotations, root_frames, rotations as R
from toolkit.motion.ik import aim
from toolkit.motion.tensors import summary
from toolkit.motion.trajectory import heading
from toolkit.stylization.graph import SkeletonGraph

FPS = 30.0
FRAMES = 64  # T of a training window
CHANNELS = 7  # position 3, quaternion 4
# Departure: least standard deviation, metres or quaternion components, of the z-score, so that
# nearly constant features are not amplified.
LEAST_STD = 0.01


class Statistics(nn.Module):
    """Mean pose and standard deviation ``[7, 1, N]``, between physical units and z-scores.

    ``poses [D, 7, 1, N]`` are the mean poses of the D domains, ``amplitudes`` the root mean square
    deviations from the mean pose of a window; z-scores. q and −q are the same rotation: `apply`
    chooses the sign nearest to the mean pose, once per joint and motion.
    """

    def __init__(self, mean: Tensor, std: Tensor, domains: int):
        super().__init__()
        self.register_buffer("mean", mean.clone())
        self.register_buffer("std", std.clone())
        self.register_buffer("poses", mean.new_zeros(domains, *mean.shape))
        self.register_buffer("amplitudes", mean.new_ones(domains, *mean.shape))

    def apply(self, x: Tensor) -> Tensor:
        """z-scores ``[..., 7, T, N]`` of motions in physical units."""
        positions, q = x.split((3, 4), -3)
        agree = (q * self.mean[3:]).sum((-3, -2), keepdim=True)
        q = q * torch.where(agree < 0, -1.0, 1.0)
        return (torch.cat((positions, q), -3) - self.mean) / self.std

    def invert(self, z: Tensor) -> Tensor:
        """Motions ``[..., 7, T, N]`` in physical units from z-scores, with unit quaternions."""
        positions, q = (z * self.std + self.mean).split((3, 4), -3)
        return torch.cat((positions, nn.functional.normalize(q, dim=-3)), -3)


@dataclass(frozen=True, eq=False)
class Motions:
    """M labelled windows of one skeleton.

    ``x [M, 7, T, N]``, physical units; ``domain``, ``content``, ``take [M]``, int: the index of the
    style in ``domains``, of the gait in ``contents``, and of the recording (a mirror image has the
    index of its original).
    """

    graph: SkeletonGraph
    x: Tensor
    domain: Tensor
    content: Tensor
    take: Tensor
    domains: tuple[str, ...]
    contents: tuple[str, ...]
    __repr__ = summary

    def __len__(self) -> int:
        return len(self.x)

    @property
    def skeleton(self) -> Skeleton:
        """Skeleton of the motions, without End Sites."""
        return self.graph.skeleton

    def statistics(self) -> Statistics:
        """Mean pose and deviation over all windows and frames, and those of each domain."""
        x = self.x.double()
        mean = x.mean((0, 2))[:, None].float()
        std = x.std((0, 2)).clamp_min(LEAST_STD)[:, None].float()
        made = Statistics(mean, std, len(self.domains))
        variance, poses = torch.var_mean(made.apply(self.x), 2, correction=0, keepdim=True)
        for d in range(len(self.domains)):
            made.poses[d] = poses[self.domain == d].mean(0)
            made.amplitudes[d] = variance[self.domain == d].mean(0).sqrt()
        return made

    def select(self, rows: Tensor) -> "Motions":
        """Some of the windows, by a mask or by indices, with the same domains and contents."""
        kept = {k: v[rows] for k, v in vars(self).items() if isinstance(v, Tensor)}
        return replace(self, **kept)


def build(clips: Sequence[Clip], mirror: bool = False) -> Motions:
    """Windows of clips (section 4): 30 Hz, 64 frames, half overlapping.

    A shorter clip repeats its first and last frame. The ``style`` of a clip is its domain, the
    ``gait`` its content. ``mirror`` adds mirror images, with left and right exchanged in the
    content, too. ValueError if there is no clip, or the clips have different skeletons.
    """
    if not clips:
        raise ValueError("motions need at least one clip, got none")
    domains = tuple(sorted({clip.style for clip in clips}))
    skeleton, parts, labels = None, [], []
    for take, clip in enumerate(clips):
        clip = prepare(clip, skeleton)
        skeleton = clip.skeleton
        for version in (clip, _mirrored(clip)) if mirror else (clip,):
            parts.append(windows(version)[0])
            labels += [(domains.index(clip.style), version.gait, take)] * len(parts[-1])
    contents = tuple(sorted({content for _, content, _ in labels}))
    domain, content, take = torch.tensor([(d, contents.index(c), t) for d, c, t in labels]).T
    return Motions(SkeletonGraph.of(skeleton), _same_sign(torch.cat(parts)), domain, content, take,
                   domains, contents)


def prepare(clip: Clip, skeleton: Skeleton | None = None) -> Clip:
    """A clip at 30 Hz on its skeleton without End Sites.

    ValueError unless it has the joints and bones of ``skeleton``, if one is given.
    """
    clip = clip.to("cpu", torch.float32).without_ends().resample(FPS)
    own = clip.skeleton
    if skeleton is None:
        return clip
    if own.names != skeleton.names or own.parents != skeleton.parents:
        odd = sorted(set(own.names) ^ set(skeleton.names))
        what = f"not in both: {', '.join(odd[:6])}" if odd else "in another order or tree"
        raise ValueError(f"{clip.name}: expected the model's skeleton of {len(skeleton)} joints, "
                         f"got {len(own)} ({what})")
    gap = (own.offsets[1:] - skeleton.offsets[1:]).norm(dim=-1)
    if len(gap) and float(gap.max()) > 0.02:
        joint = own.names[1 + int(gap.argmax())]
        raise ValueError(f"{clip.name}: expected the model's bones, "
                         f"got {joint} {100 * float(gap.max()):.1f} cm elsewhere")
    return clip


def describe(clip: Clip) -> tuple[Tensor, Tensor]:
    """``x [7, F, N]``, with continuous quaternions, and ``root_velocity [F, 3]`` of a clip.

    The velocity is from each frame to the next in its root frame: x and z in m/s, turn about the
    vertical in rad/s.
    """
    roots = root_frames(clip)
    turned = R.multiply(R.inverse(roots.rotations)[:, None], clip.global_rotations)
    x = torch.cat((roots.to_local(clip.global_positions), R.unroll(turned)), -1).permute(2, 0, 1)
    velocity = torch.zeros(len(clip), 3)
    if len(clip) > 1:
        back = R.inverse(roots.rotations[:-1])
        steps = R.rotate(back, roots.positions.diff(dim=0)) * FPS
        turn = torch.atan2(*heading(R.multiply(back, roots.rotations[1:]))) * FPS
        velocity[:-1] = torch.stack((steps[:, 0], steps[:, 2], turn), -1)
        velocity[-1] = velocity[-2]
    return x.contiguous(), velocity


def windows(clip: Clip) -> tuple[Tensor, Tensor]:
    """``[M, 7, 64, N]`` and ``[M, 64, 3]``: a window every half window of a prepared clip.

    Padding has no root velocity. Every frame is in a window: the last one ends with the clip and
    may overlap more.
    """
    x, velocity = describe(clip)
    if (lack := FRAMES - len(clip)) > 0:
        front, back = lack // 2, lack - lack // 2
        x = torch.cat((x[:, :1].expand(-1, front, -1), x, x[:, -1:].expand(-1, back, -1)), 1)
        velocity[-1] = 0
        velocity = nn.functional.pad(velocity, (0, 0, front, back))
    last = x.shape[1] - FRAMES
    starts = torch.tensor([*range(0, last, FRAMES // 2), last])
    rows = starts[:, None] + torch.arange(FRAMES)
    return x[:, rows].transpose(0, 1), velocity[rows]


def to_clip(x: Tensor, root_velocity: Tensor, source: Clip) -> Clip:
    """The clip of features: the inverse of `describe`, with the skeleton's bones.

    ``x [7, F, N]`` are features at 30 Hz; those of the root joint give its rotation and height.
    ``root_velocity [F, 3]`` is integrated from the first frame of the ``source``, a prepared clip.
    As in the paper's figures the positions of a network take precedence over its rotations: a bone
    without siblings points at its predicted end, the rotation gives its twist.
    """
    first = root_frames(source.cut(0, 1))
    dx, dz, turn = (root_velocity[:-1].double() / FPS).T
    start = torch.atan2(*heading(first.rotations)).double()
    rotations = R.yaw(torch.cat((start, turn)).cumsum(0))
    steps = R.rotate(rotations[:-1], torch.stack((dx, torch.zeros_like(dx), dz), -1))
    root = torch.cat((first.positions.double(), steps)).cumsum(0).float()
    facing = rotations.float()[:, None]
    wanted = R.rotate(facing, x[:3].permute(1, 2, 0)) + root[:, None]
    world = R.multiply(facing, R.normalize(x[3:].permute(1, 2, 0)))
    # a root joint that is not the hips keeps its place beside them
    beside = root_frames(source).to_local(source.root_positions[:, None])[: len(root)]
    root = root + R.rotate(facing, beside)[:, 0]
    root[:, 1] = x[1, :, 0]
    world = _aimed(source.skeleton, world, root, wanted)
    local = R.unroll(local_rotations(source.skeleton, world))
    return source.replace(rotations=local, root_positions=root)


def _aimed(skeleton: Skeleton, world: Tensor, root: Tensor, wanted: Tensor) -> Tensor:
    """World rotations ``[F, N, 4]`` by which bones without siblings point at ``wanted`` places."""
    positions = root[:, None].expand_as(wanted).clone()
    for j, p in enumerate(skeleton.parents[1:], 1):
        positions[:, j] = positions[:, p] + R.rotate(world[:, p], skeleton.offsets[j])
        if skeleton.parents.count(p) == 1:
            aim(skeleton, world, positions, [p], [j], wanted)
    return world


def _mirrored(clip: Clip) -> Clip:
    swap = {"left": "right", "right": "left"}
    gait = "-".join(swap.get(word, word) for word in clip.gait.split("-"))
    return clip.mirrored().replace(gait=gait)


def _same_sign(x: Tensor) -> Tensor:
    """Of q and −q, one rotation, a window has that nearer to the joint's principal direction."""
    q = x[:, 3:]  # [M, 4, T, N]
    scatter = torch.einsum("mctn,mdtn->ncd", q, q)
    principal = torch.linalg.eigh(scatter).eigenvectors[..., -1].T  # [4, N], largest eigenvalue
    sign = torch.where((q * principal[:, None]).sum((1, 2), keepdim=True) < 0, -1.0, 1.0)
    return torch.cat((x[:, :3], q * sign), 1)
