"""Restyle a clip of any length by noise or by a reference clip."""

import torch
from scipy.interpolate import PchipInterpolator
from scipy.ndimage import gaussian_filter1d
from torch import Tensor
from torch.nn import functional

from toolkit.features.splits import generator
from toolkit.motion import Clip, contacts, rotations as R
from toolkit.motion.ik import plant_feet
from toolkit.stylization.data import FPS, FRAMES, describe, prepare, to_clip, windows
from toolkit.stylization.networks import SHRINK, Stylizer

PACE = 0.25  # of the root's speed: a slower toe may stand, also one of a runner
WIDTHS = range(1, 6)  # deviations of the filter of changes, frames
RELEASE = 0.25  # seconds over which the height of the body follows that of its standing toes


def stylize(model: Stylizer, clip: Clip, domain: str | None = None, seed: int = 0, *,
            reference: Clip | None = None, blend: str | None = None, feet: bool = True) -> Clip:
    """Restyle a clip (Park et al. 2021).

    The result has the rate, root path (section 4), bones, End Sites and foot contacts of the
    source. The change of the motion is smoothed until it has no more jerk than the source (`calm`).

    Parameters
    ----------
    model, clip
        The ``stylizer`` of `fit`, and a source of any rate and length on the model's skeleton.
    domain, seed
        Style, and seed of its noise (equation 6); the same seed gives the same result.
    reference
        A clip with the target style (equation 5). Its domain is ``domain``, by default its own
        ``style``.
    blend
        Style of the clip. With it the result is not the network's, but a blend: half of it, and
        half the shift and scale from this style to the domain. It keeps more gaits than the network
        (docs/embedded_model.md).
    feet
        Whether to remove foot skate (`lock_feet`).

    Raises
    ------
    ValueError
        If the clip has another skeleton or fewer frames than the pooling needs, the domain is
        unknown, or neither domain nor reference is given.
    """
    clip = clip.to("cpu")  # as the network
    source = prepare(clip, model.skeleton)
    if len(source) < SHRINK:
        raise ValueError(f"{clip.name}: pooling needs {SHRINK} frames at {FPS:g} Hz, "
                         f"the clip has {len(source)}")
    if reference is not None:
        domain = domain or reference.style
        other = prepare(reference, model.skeleton)
        shown = windows(other)[0] if len(other) < FRAMES else describe(other)[0][None]
        code = model.code_of(shown, domain)
    elif domain is not None:
        noise = torch.randn(1, model.sizes.latent, generator=generator(seed))
        code = model.code_from(noise, domain)
    else:
        raise ValueError(f"say which style: domain= (one of {', '.join(model.domains)}) or "
                         "reference=")
    x, root_velocity = describe(source)
    padded = torch.cat((x, x[:, -1:].expand(-1, -len(source) % SHRINK, -1)), 1)
    made = calm(model.translate(padded[None], code)[:, :, : len(source)], x[None])[0]
    if blend is not None:
        made = (made + model.shift(x[None], blend, domain)[0]) / 2
    result = to_clip(made, root_velocity, source)
    if feet:
        result = lock_feet(result, source)
    # End Sites do not turn
    rotations = R.identity(len(result), len(clip.skeleton))
    joints = [clip.skeleton.names.index(name) for name in source.skeleton.names]
    rotations[:, joints] = result.rotations
    result = result.replace(skeleton=clip.skeleton, rotations=rotations, style=domain)
    result = result.resample(clip.fps)
    # at a higher rate than 30 Hz the clip's last frames lie after the network's last one: they keep
    # its pose and go on along the path
    at = torch.arange(len(clip)).clamp_max(len(result) - 1)
    on = clip.root_positions - clip.root_positions[at]
    return result.replace(rotations=result.rotations[at],
                          root_positions=result.root_positions[at] + on)


def calm(made: Tensor, x: Tensor) -> Tensor:
    """Motions ``[B, 7, F, N]`` whose change from their sources has no high frequencies.

    Ours: the network is too small to rebuild a motion exactly, and trembles. The change of each
    motion gets the narrowest Gaussian filter of `WIDTHS` with which it has no more jerk than its
    source ``x [B, 7, F, N]``, or the widest.
    """
    # q and −q are one rotation
    opposite = (made[:, 3:] * x[:, 3:]).sum((1, 2), keepdim=True) < 0
    x = torch.cat((x[:, :3], torch.where(opposite, -x[:, 3:], x[:, 3:])), 1)
    change = made - x
    most, smooth = jerk(x), change
    for width in WIDTHS:
        rough = jerk(x + smooth) > most
        filtered = gaussian_filter1d(change[rough].numpy(), width, axis=2, mode="nearest")
        smooth = smooth.index_put((rough,), torch.from_numpy(filtered))
    positions, q = (x + smooth).split((3, 4), 1)
    return torch.cat((positions, functional.normalize(q, dim=1)), 1)


def jerk(x: Tensor) -> Tensor:
    """Mean over joints and time ``[B]`` of the third differences of positions, metres."""
    return x[:, :3].diff(n=3, dim=2).norm(dim=1).mean((1, 2)).nan_to_num()


def stances(clip: Clip) -> Tensor:
    """Contacts ``[F, 2]``; the faster the root, the faster a toe that stands (`PACE`).

    At 30 Hz a runner's toe never is as slow as the toe of one who walks.
    """
    pace = contacts.velocities(clip.root_positions[:, [0, 2]], clip.fps).norm(dim=-1, keepdim=True)
    return torch.maximum(contacts.detect(clip), contacts.detect(clip, speed=PACE * pace))


def lock_feet(clip: Clip, source: Clip) -> Clip:
    """Foot-skate removal (section 7): in a stance of the source the toe stays at its mean place.

    Both clips have the same length, rate and skeleton. A standing toe has the height of the
    source's, and no toe is below the source's lowest. The whole body moves up or down by the mean
    height error of standing toes within `RELEASE` of a frame, so that legs need not stretch.
    """
    standing = stances(source) > 0.5
    toes = clip.skeleton.both("toe")
    made, height = clip.global_positions[:, toes], source.global_positions[:, toes, 1]
    release = round(RELEASE * clip.fps)
    # by how much the body is too low, the mean over standing toes of the frames around
    error = ((height - made[..., 1]) * standing).sum(1)
    around, weight = functional.avg_pool1d(torch.stack((error, standing.sum(1).float()))[:, None],
                                           2 * release + 1, stride=1, padding=release)[:, 0]
    rise = torch.zeros(len(clip), 3)
    rise[:, 1] = around / weight.clamp_min(1e-6)
    made = made + rise[:, None]
    shifts = map(_shift, made.unbind(1), height.unbind(1), standing.unbind(1))
    targets = made + torch.stack([*shifts], 1)
    targets[..., 1].clamp_(min=float(height.min()))
    root = clip.root_positions + rise
    rotations = plant_feet(clip.skeleton, clip.rotations, root, targets)
    return clip.replace(rotations=rotations, root_positions=root)


def _shift(toe: Tensor, height: Tensor, standing: Tensor) -> Tensor:
    """Shift ``[F, 3]`` of one toe: to one place in each stance, interpolated between stances."""
    frames = standing.nonzero()[:, 0]
    if len(frames) < 2:
        return torch.zeros_like(toe)
    wanted = torch.stack((toe[:, 0], height, toe[:, 2]), 1)[frames]
    lengths = functional.pad(standing.int(), (1, 1)).diff().nonzero().view(-1, 2).diff()[:, 0]
    places = torch.cat([part.mean(0).expand_as(part) for part in wanted.split(lengths.tolist())])
    curve = PchipInterpolator(frames, places - toe[frames])
    times = torch.arange(len(toe)).clamp(int(frames[0]), int(frames[-1]))
    return torch.from_numpy(curve(times)).float()
