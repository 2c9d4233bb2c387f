"""Restyle a clip of any length: from a domain and noise, from a reference clip, or from a style code (Park et al. 2021)."""

import torch
from torch import Tensor
from torch.nn import functional

from toolkit.features.splits import generator
from toolkit.motion import Clip, contacts
from toolkit.motion import rotations as R
from toolkit.motion.ik import plant_feet
from toolkit.stylization.data import FPS, FRAMES, check_skeleton, describe, prepare, to_clip, windows
from toolkit.stylization.networks import SHRINK, Stylizer

RELEASE = 0.25  # seconds in which a toe comes back from where it was held to where the network has it


def stylize(
    model: Stylizer,
    clip: Clip,
    domain: str | None = None,
    seed: int = 0,
    *,
    reference: Clip | None = None,
    code: Tensor | None = None,
    feet: bool = True,
) -> Clip:
    """Restyle a clip.

    The root's path is the source's (section 4), bones are the source's, and toes stand still while the source's do.

    Parameters
    ----------
    model
        What `toolkit.stylization.fit` made (its ``stylizer``) or `Stylizer.load` read.
    clip
        The source, any rate and length, on the model's skeleton.
    domain, seed
        Style and noise (equation 6); the same seed gives the same result.
    reference
        A clip whose style is taken (equation 5), of the domain given, or of the clip's own ``style`` where none is.
    code : Tensor [S]
        A style code, of `style_code` or between such (section 7.1, style interpolation).
    feet
        Whether to take away foot skate.

    Returns
    -------
    Clip
        At the source's rate, on its skeleton, End Sites included.

    Raises
    ------
    ValueError
        If the clip has another skeleton or fewer frames than the pooling needs, the domain is unknown, or not exactly one
        of domain, reference and code says which style.
    """
    source = prepare(clip)
    check_skeleton(source, model.skeleton)
    if len(source) < SHRINK:
        raise ValueError(f"{clip.name}: pooling needs {SHRINK} frames at {FPS:g} Hz, the clip has {len(source)}")
    if code is None:
        code = style_code(model, domain, seed, reference=reference)
    elif domain is not None or reference is not None or code.shape != (model.sizes.code,):
        raise ValueError(f"a style code is [{model.sizes.code}] and needs no domain or reference; got {list(code.shape)}")
    x, root_velocity = describe(source)
    padded = functional.pad(x.transpose(1, 2), (0, -len(source) % SHRINK), mode="replicate").transpose(1, 2)
    made = model.translate(padded[None], code[None])[0, :, : len(source)]
    result = to_clip(made, root_velocity, source)
    if feet:
        result = hold_feet(result, source)
    rotations = R.identity(len(result), len(clip.skeleton))
    rotations[:, [clip.skeleton.names.index(name) for name in source.skeleton.names]] = result.rotations
    style = domain or (reference.style if reference else "")
    return result.replace(skeleton=clip.skeleton, rotations=rotations, style=style).resample(clip.fps)


def style_code(model: Stylizer, domain: str | None = None, seed: int = 0, *, reference: Clip | None = None) -> Tensor:
    """The style code ``[S]`` that `stylize` uses for a domain and a seed, or for a reference clip.

    Raises
    ------
    ValueError
        If neither is given, the domain is unknown, or the reference has another skeleton.
    """
    if reference is None:
        if domain is None:
            raise ValueError(f"say which style: domain= (one of {', '.join(model.domains)}), reference= or code=")
        noise = torch.randn(1, model.sizes.latent, generator=generator(seed))
        return model.code_from(noise, domain)[0]
    source = prepare(reference)
    check_skeleton(source, model.skeleton)
    x = describe(source)[0][None] if len(source) >= FRAMES else windows(source)[0]
    return model.code_of(x, domain or reference.style)[0]


def hold_feet(clip: Clip, source: Clip) -> Clip:
    """Foot-skate removal (section 7): while a toe of the source stands, the clip's stands where it was on average meanwhile.

    A standing toe has the source's height, and none sinks below the source's lowest. Where standing toes are too high or too
    low on the mean of `RELEASE` around a frame, the whole body is shifted, so that legs need not stretch. Before and after a
    stance the shift of a toe fades over `RELEASE`. Legs are bent by `ik.plant_feet`, which keeps the bones' lengths
    and the feet's orientation.

    Parameters
    ----------
    clip, source
        Frame by frame the same motion, on one skeleton with toes.
    """
    standing = contacts.detect(source) > 0.5
    toes = [clip.skeleton.role(f"{side}_toe") for side in contacts.FEET]
    made, height = clip.global_positions[:, toes], source.global_positions[:, toes, 1]
    release = round(RELEASE * clip.fps)
    gap = torch.stack((((height - made[..., 1]) * standing).sum(1), standing.sum(1).float()))
    around, weight = functional.avg_pool1d(gap[:, None], 2 * release + 1, stride=1, padding=release)[:, 0]
    rise = torch.zeros(len(clip), 3)
    rise[:, 1] = around / weight.clamp_min(1e-6)
    made = made + rise[:, None]
    shift = [_shift(made[:, side], height[:, side], standing[:, side], release) for side in range(len(toes))]
    targets = made + torch.stack(shift, 1)
    targets[..., 1].clamp_(min=float(height.min()))
    root = clip.root_positions + rise
    rotations = plant_feet(clip.skeleton, clip.rotations, root, targets)
    return clip.replace(rotations=rotations, root_positions=root)


def _shift(toe: Tensor, height: Tensor, standing: Tensor, release: int) -> Tensor:
    """How far ``[F, 3]`` to move one toe: in each stance to one place, fading between stances as a raised cosine."""
    if not standing.any():
        return torch.zeros_like(toe)
    frames = torch.arange(len(toe))
    begins = standing & ~torch.cat((standing[:1] & False, standing[:-1]))
    stance = begins.cumsum(0) - 1  # of every frame, the last stance that began
    count = torch.zeros(int(begins.sum())).index_add(0, stance[standing], torch.ones(int(standing.sum())))
    place = torch.zeros(len(count), 3).index_add(0, stance[standing], toe[standing]) / count[:, None]
    place[:, 1] = torch.zeros(len(count)).index_add(0, stance[standing], height[standing]) / count
    stood = frames[standing]
    last = stood[(torch.searchsorted(stood, frames, right=True) - 1).clamp(min=0)]
    following = stood[torch.searchsorted(stood, frames).clamp(max=len(stood) - 1)]
    between = (last < frames) & (frames < following)
    reach = torch.where(between, (following - last).clamp(max=release), release).float()

    def fading(near: Tensor, reached: Tensor) -> Tensor:
        share = ((frames - near).abs() / reach).clamp(max=1.0)
        return (reached * (1 + torch.cos(torch.pi * share)) / 2)[:, None] * (place[stance[near]] - toe[near])

    return fading(last, last <= frames) + fading(following, following > frames)
