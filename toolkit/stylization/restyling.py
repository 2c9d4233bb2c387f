"""Restyle a clip of any length by noise or by a reference clip."""

from itertools import product

import numpy as np
import torch
from scipy.linalg import solveh_banded
from scipy.ndimage import binary_dilation, gaussian_filter1d
from torch import Tensor
from torch.nn import functional

from toolkit.features.splits import generator
from toolkit.motion import Clip, contacts, rotations as R
from toolkit.motion.clearance import arms_out, covering
from toolkit.motion.ik import LEG, plant_feet
from toolkit.stylization.data import FPS, FRAMES, describe, prepare, to_clip, windows
from toolkit.stylization.networks import SHRINK, Stylizer

PACE = 0.25  # of the root's speed: a slower toe may stand, also one of a runner
WIDTHS = range(1, 6)  # deviations of the filter of changes, frames
AROUND = 2  # frames before and after a stance in which the foot stands as well
SMOOTH, STILL, LEVEL = 500.0, 1e4, 100.0  # weights of `settled`, at 30 Hz
STRETCH, DEEPEST = 0.99, 0.1  # of a leg's length, at most; metres by which hips sink, at most


def stylize(model: Stylizer, clip: Clip, domain: str | None = None, seed: int = 0, *,
            reference: Clip | None = None, blend: str | None = None, feet: bool = True) -> Clip:
    """Restyle a clip (Park et al. 2021).

    The result has the rate, root path (section 4), bones, End Sites and foot contacts of the
    source. The change of the motion is smoothed, to hardly more jerk than the source's (`calm`).

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
        Style of the clip. With it the result is half the network's, and half the shift and scale
        from this style to the domain. It keeps more gaits (docs/embedded_model.md).
    feet
        Remove foot skate (`lock_feet`), and turn arms out of the body (`arms_out`).

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
        result = arms_out(lock_feet(result, source))
    # End Sites do not turn
    rotations = R.identity(len(result), len(clip.skeleton))
    joints = [clip.skeleton.names.index(name) for name in source.skeleton.names]
    rotations[:, joints] = result.rotations
    result = result.replace(skeleton=clip.skeleton, rotations=rotations, style=domain)
    result = result.resample(clip.fps)
    # at over 30 Hz the clip's last frames lie after the network's last one: they keep its pose and
    # go on along the path
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
    # sums of squares: torch takes seventy times as long for the norm over such an axis
    return x[:, :3].diff(n=3, dim=2).square().sum(1).sqrt().mean((1, 2)).nan_to_num()


def stances(clip: Clip) -> Tensor:
    """Contacts ``[F, 2]``; the faster the root, the faster a toe that stands (`PACE`).

    At 30 Hz a runner's toe is never as slow as a walker's.
    """
    pace = contacts.velocities(clip.root_positions[:, [0, 2]], clip.fps).norm(dim=-1, keepdim=True)
    return torch.maximum(contacts.detect(clip), contacts.detect(clip, speed=PACE * pace))


def lock_feet(clip: Clip, source: Clip) -> Clip:
    """Foot-skate removal (section 7): a foot that stands in the source stands in the result.

    Both clips have the same length, rate and skeleton. Ankles and toes move as the source's plus a
    smooth change, which stays the same in each stance (`settled`): so they land and take off as
    the source's do. A standing toe has the height of the source's, and no toe is below its lowest.
    The hips sink where a leg would be stretched farther than `STRETCH` of its length.
    """
    standing = binary_dilation(stances(source) > 0.5, np.ones((2 * AROUND + 1, 1)))
    skeleton, level = clip.skeleton, [0, 2]
    feet, toes = skeleton.both("foot"), skeleton.both("toe")
    made, own = clip.global_positions, source.global_positions
    wanted = own.clone()
    for ankle, toe, stands in zip(feet, toes, standing.T, strict=True):
        wanted[:, ankle] += settled((made - own)[:, ankle], stands)
        wanted[:, toe, level] += settled((made - own)[:, toe, level], stands)
        wanted[:, toe, 1] += settled((made - own)[:, toe, 1], stands, LEVEL)
    targets, soles = wanted[:, toes], wanted[:, toes] - wanted[:, feet]
    targets[..., 1].clamp_(min=float(own[:, toes, 1].min()))

    # how far the hips must go down, so that legs reach
    hip, knee, ankle, toe = (made[:, skeleton.both(part)] for part in LEG)
    reach = STRETCH * ((knee - hip).norm(dim=-1) + (ankle - knee).norm(dim=-1))
    soles = R.normalize(soles) * (toe - ankle).norm(dim=-1, keepdim=True)
    apart = hip - (targets - soles)
    height = (reach.square() - apart[..., level].square().sum(-1)).clamp_min(0.0).sqrt()
    root = clip.root_positions.clone()
    root[:, 1] -= covering((apart[..., 1] - height).amax(1).clamp_max(DEEPEST), clip.fps)
    rotations = plant_feet(skeleton, clip.rotations, root, targets, soles if feet != toes else None)
    return clip.replace(rotations=rotations, root_positions=root)


def settled(change: Tensor, standing: np.ndarray, level: float = 0.0) -> Tensor:
    """The smooth curve ``[F, ...]`` near a change ``[F, ...]`` that is constant in each stance.

    Its sum of squares is the least: of the distance from the change; `SMOOTH`, of third
    differences; `STILL`, of first ones in stances; ``level``, of the curve itself in stances.
    """
    frames, jolt = len(change), (-1.0, 3.0, -3.0, 1.0)
    still = STILL * (standing[1:] & standing[:-1])
    # bands[k, i]: entry (i + k, i) of I + SMOOTH D₃ᵀD₃ + STILL D₁ᵀS D₁ + level S, S the stances
    bands = np.zeros((4, frames))
    for k, m in product(range(4), repeat=2):
        if k + m < 4:
            bands[k, m : m + frames - 3] += SMOOTH * jolt[m] * jolt[m + k]
    bands[0] += 1.0 + level * standing
    bands[0, 1:] += still
    bands[0, :-1] += still
    bands[1, :-1] -= still
    return torch.from_numpy(solveh_banded(bands, change.double().numpy(), lower=True)).to(change)
