"""Motion features of Park et al. 2021 (section 4): windows of joint positions and rotations in the root frame.

A motion is ``x [7, T, N]`` at 30 Hz: the position (metres) and the unit quaternion of every joint in the root frame, whose
origin is the root on the ground. The velocity of the root is stored beside it and never changed. End Sites have no features.
"""

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import torch
from torch import Tensor, nn

from toolkit.features.splits import generator
from toolkit.motion import Clip, Skeleton, local_rotations, on_cpu, root_frames
from toolkit.motion import rotations as R
from toolkit.motion.tensors import summary
from toolkit.motion.trajectory import heading
from toolkit.stylization.graph import SkeletonGraph

FPS = 30.0
FRAMES = 64  # T of a training window
CHANNELS = 7  # position 3, quaternion 4
LEAST_STD = 0.01  # metres or quaternion components, so that nearly constant features are not amplified


class Statistics(nn.Module):
    """Mean pose and standard deviation ``[7, 1, N]``, to convert between physical units and z-scores.

    ``poses [D, 7, 1, N]`` are the mean poses of the D domains, z-scores. q and −q are the same rotation: `apply` chooses the
    sign nearest to the mean pose, once per joint and motion.
    """

    def __init__(self, mean: Tensor, std: Tensor, poses: Tensor):
        super().__init__()
        for name, value in {"mean": mean, "std": std, "poses": poses}.items():
            self.register_buffer(name, value.clone())

    def apply(self, x: Tensor) -> Tensor:
        """z-scores ``[..., 7, T, N]`` of motions in physical units."""
        agree = (x[..., 3:, :, :] * self.mean[3:]).sum((-3, -2), keepdim=True)
        sign = torch.where(agree < 0, -1.0, 1.0).expand_as(x[..., 3:, :1, :])
        return (x * torch.cat((torch.ones_like(x[..., :3, :1, :]), sign), -3) - self.mean) / self.std

    def invert(self, z: Tensor) -> Tensor:
        """Motions ``[..., 7, T, N]`` in physical units from z-scores, with unit quaternions."""
        x = z * self.std + self.mean
        return torch.cat((x[..., :3, :, :], nn.functional.normalize(x[..., 3:, :, :], dim=-3)), -3)


@dataclass(frozen=True, eq=False)
class Motions:
    """M labelled windows of one skeleton.

    ``x [M, 7, T, N]``, physical units; ``root_velocity [M, T, 3]`` from each frame to the next in its root frame (x and z in
    m/s, turn about the vertical in rad/s); ``domain``, ``content``, ``take [M]``, int: the index of the style in
    ``domains``, of the gait in ``contents``, and of the recording (a mirror image has the index of its original).
    """

    graph: SkeletonGraph
    x: Tensor
    root_velocity: Tensor
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
        """Mean pose and standard deviation over all windows and frames, and the mean pose of each domain."""
        x = self.x.double()
        mean, std = (value[:, None].float() for value in (x.mean((0, 2)), x.std((0, 2)).clamp_min(LEAST_STD)))
        made = Statistics(mean, std, mean.new_zeros(len(self.domains), *mean.shape))
        z = made.apply(self.x).mean(2, keepdim=True)
        for d, pose in enumerate(made.poses):
            pose.copy_(z[self.domain == d].mean(0))
        return made

    def select(self, rows: Tensor) -> "Motions":
        """Some of the windows, by a mask or by indices, with the same domains and contents."""
        return dataclasses.replace(self, **{k: v[rows] for k, v in vars(self).items() if isinstance(v, Tensor)})


def build(clips: Sequence[Clip], domains: Sequence[str] | None = None, mirror: bool = False) -> Motions:
    """Windows of clips (section 4): 30 Hz, 64 frames, half overlapping; a shorter clip repeats its first and last frame.

    The ``style`` of a clip is its domain, the ``gait`` its content. ``domains`` are the styles to keep, in the order of
    their indices; by default all, sorted. ``mirror`` adds mirror images, with left and right exchanged in the content, too.

    Raises
    ------
    ValueError
        If there is no clip, a domain has none, or the clips have different skeletons.
    """
    names = tuple(sorted({clip.style for clip in clips}) if domains is None else domains)
    if missing := [name for name in names if all(clip.style != name for clip in clips)]:
        raise ValueError(f"no clip of {', '.join(missing)}; the clips have {', '.join(sorted({c.style for c in clips}))}")
    kept = [prepare(clip) for clip in clips if clip.style in names]
    if not kept:
        raise ValueError("motions need at least one clip, got none")
    graph, parts, labels = SkeletonGraph.of(kept[0].skeleton), [], []
    for take, clip in enumerate(kept):
        check_skeleton(clip, graph.skeleton)
        for version in (clip, _mirrored(clip)) if mirror else (clip,):
            parts.append(windows(version))
            labels += [(names.index(clip.style), version.gait, take)] * len(parts[-1][0])
    contents = tuple(sorted({content for _, content, _ in labels}))
    x, velocity = (torch.cat(column) for column in zip(*parts, strict=True))
    domain, content, take = torch.tensor([(d, contents.index(c), t) for d, c, t in labels]).T
    return Motions(graph, _same_sign(x), velocity, domain, content, take, names, contents)


def prepare(clip: Clip) -> Clip:
    """A clip at 30 Hz on its skeleton without End Sites."""
    return on_cpu(clip)[0].without_ends().resample(FPS)


def check_skeleton(clip: Clip, skeleton: Skeleton) -> None:
    """Check that a clip (without End Sites) has the expected joints and bone lengths; ValueError with the difference."""
    own = clip.skeleton
    if own.names != skeleton.names or own.parents != skeleton.parents:
        odd = sorted(set(own.names) ^ set(skeleton.names))
        what = f"not in both: {', '.join(odd[:6])}" if odd else "in another order"
        raise ValueError(f"{clip.name}: expected the model's skeleton of {len(skeleton)} joints, got {len(own)} ({what})")
    gap = (own.offsets[1:] - skeleton.offsets[1:]).norm(dim=-1)
    if len(gap) and float(gap.max()) > 0.02:
        joint = own.names[1 + int(gap.argmax())]
        raise ValueError(f"{clip.name}: expected the model's bones, got {joint} {100 * float(gap.max()):.1f} cm elsewhere")


def describe(clip: Clip) -> tuple[Tensor, Tensor]:
    """``x [7, F, N]`` and ``root_velocity [F, 3]`` of a prepared clip; the quaternions of a joint are continuous."""
    roots = root_frames(clip)
    turned = R.multiply(R.inverse(roots.rotations)[:, None], clip.global_rotations)
    x = torch.cat((roots.to_local(clip.global_positions), R.unroll(turned)), -1).permute(2, 0, 1)
    velocity = torch.zeros(len(clip), 3)
    if len(clip) > 1:
        steps = R.rotate(R.inverse(roots.rotations[:-1]), roots.positions.diff(dim=0)) * FPS
        turn = torch.atan2(*heading(R.multiply(R.inverse(roots.rotations[:-1]), roots.rotations[1:]))) * FPS
        velocity[:-1] = torch.stack((steps[:, 0], steps[:, 2], turn), -1)
        velocity[-1] = velocity[-2]
    return x.contiguous(), velocity


def windows(clip: Clip, frames: int = FRAMES) -> tuple[Tensor, Tensor]:
    """``[M, 7, T, N]`` and ``[M, T, 3]``: a window every half window of a prepared clip; padding has no root velocity.

    Every frame is in a window: the last one ends with the clip and may overlap more.
    """
    x, velocity = describe(clip)
    if (lack := frames - len(clip)) > 0:
        front, back = lack // 2, lack - lack // 2
        x = torch.cat((x[:, :1].expand(-1, front, -1), x, x[:, -1:].expand(-1, back, -1)), 1)
        velocity = nn.functional.pad(torch.cat((velocity[:-1], velocity[:1] * 0)), (0, 0, front, back))
    last = x.shape[1] - frames
    starts = [*range(0, last, frames // 2), last]
    return (torch.stack([x[:, s : s + frames] for s in starts]), torch.stack([velocity[s : s + frames] for s in starts]))


def to_clip(x: Tensor, root_velocity: Tensor, source: Clip) -> Clip:
    """The clip of features: the inverse of `describe`, with the skeleton's bones.

    ``x [7, F, N]`` are features at 30 Hz; those of the root joint give its rotation and height. ``root_velocity [F, 3]`` is
    integrated from the first frame of the ``source``, a prepared clip. As in the paper's figures the positions of a network
    take precedence over its rotations: a bone without siblings points at its predicted end, the rotation gives its twist.
    """
    first = root_frames(source.cut(0, 1))
    dx, dz, turn = (root_velocity[:-1].double() / FPS).T
    rotations = R.yaw(torch.cat((torch.atan2(*heading(first.rotations)).double(), turn)).cumsum(0))
    steps = R.rotate(rotations[:-1], torch.stack((dx, torch.zeros_like(dx), dz), -1))
    root = torch.cat((first.positions.double(), steps)).cumsum(0).float()
    facing = rotations.float()[:, None]
    wanted = R.rotate(facing, x[:3].permute(1, 2, 0)) + root[:, None]
    world = R.multiply(facing, R.normalize(x[3:].permute(1, 2, 0)))
    root[:, 1] = x[1, :, 0]
    world = _aimed(source.skeleton, world, root, wanted)
    return source.replace(rotations=R.unroll(local_rotations(source.skeleton, world)), root_positions=root)


def _aimed(skeleton: Skeleton, world: Tensor, root: Tensor, wanted: Tensor) -> Tensor:
    """World rotations ``[F, N, 4]``, corrected so that bones without siblings point at the ``wanted`` positions."""
    positions = root[:, None].expand_as(wanted).clone()
    for joints, parents, _ in skeleton.levels(world.device):
        alone = torch.tensor([skeleton.parents.count(p) == 1 for p in parents.tolist()])
        bones = R.rotate(world[:, parents], skeleton.offsets[joints])
        turn = R.between(bones, wanted[:, joints] - positions[:, parents])
        turn = torch.where(alone[:, None], turn, R.identity(1))
        world[:, parents[alone]] = R.multiply(turn, world[:, parents])[:, alone]
        positions[:, joints] = positions[:, parents] + R.rotate(turn, bones)
    return world


def split(motions: Motions, share: float, seed: int) -> tuple[Motions, Motions]:
    """Two sets of windows with different takes; the second has about ``share`` of the takes of every domain and content.

    A take and its mirror image are in the same set. What a seed chooses of a domain and content depends on no other one.

    Raises
    ------
    ValueError
        If ``share`` is not between 0 and 1.
    """
    if not 0 < share < 1:
        raise ValueError(f"the share of the second part must lie between 0 and 1, got {share}")
    second = torch.zeros(int(motions.take.max()) + 1, dtype=torch.bool)
    labels = torch.stack((motions.take, motions.domain, motions.content), 1).flip(0).tolist()
    originals = {t: (d, c) for t, d, c in labels}  # the original's labels, which come before its mirror image's
    for d, c in sorted(set(originals.values())):
        takes = torch.tensor(sorted(t for t, kind in originals.items() if kind == (d, c)))
        order = torch.randperm(len(takes), generator=generator(seed, motions.domains[d], motions.contents[c]))
        second[takes[order[: round(share * len(takes))]]] = True
    mask = second[motions.take]
    return motions.select(~mask), motions.select(mask)


def _mirrored(clip: Clip) -> Clip:
    swap = {"left": "right", "right": "left"}
    gait = "-".join(swap.get(word, word) for word in clip.gait.split("-"))
    return clip.mirrored().replace(gait=gait)


def _same_sign(x: Tensor) -> Tensor:
    """The quaternions of every joint with the sign of their principal direction, one sign per window."""
    q = x[:, 3:]
    principal = torch.linalg.eigh(torch.einsum("mctn,mdtn->ncd", q, q))[1][..., -1].T
    sign = torch.where((q * principal[:, None]).sum((1, 2), keepdim=True) < 0, -1.0, 1.0)
    return torch.cat((x[:, :3], q * sign), 1)
