"""The state of characters under control: everything that the next frame depends on."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import torch
from torch import Tensor

from toolkit.motion.tensors import as_tensor, shown, summary


@dataclass(frozen=True, eq=False)
class CharacterState:
    """State of B characters; J feature joints, metres and seconds; right before left."""

    # [B, 61, 4] world (x, z, direction x, direction z) of the root, one second ago to now
    history: Tensor
    # [B, S, 4] the same for the present frame and the future offsets of the model's layout
    future: Tensor
    # [B, 12 J] pose in the current root frame after foot IK; the hips are as the network has them
    joints: Tensor
    # [B, n_phases] in the model's form: 8 numbers of local phases, one angle, or no column
    phase: Tensor
    # [B, S] style vector
    style: Tensor

    # [B, 2] the smoothed command
    velocity: Tensor
    # [B, 2] the smoothed command
    facing: Tensor
    # [B, 1] factor on the commanded velocity in the target trajectory, see `speed_controller`
    drive: Tensor
    # [B, 2] the command as slow as a character follows it, see `direction_controller`
    asked: Tensor
    # [B, 1] m/s to the left that the direction controller has learnt to oppose
    aside: Tensor
    # [B, 1] grows to 1 while the command is to stand, see `standing`
    rest: Tensor

    # [B, 2] predicted foot contacts in [0, 1]
    contacts: Tensor
    # [B, 2, 3] where foot IK puts the toes, world
    toes: Tensor
    # [B, 2, 3] velocity of their offset from the prediction, see `toolkit.motion.ik.foot_lock`
    drift: Tensor
    # [B, 2] how far foot IK lowers the drawn hips, and its velocity, see `toolkit.motion.ik.sink`
    drop: Tensor
    # [B, 2] radians by which the drawn feet are turned, see `toolkit.motion.ik.hold_feet`
    swivel: Tensor

    __repr__ = summary

    @property
    def root(self) -> Tensor:
        """World (x, z, direction x, direction z) of the root now, ``[B, 4]``."""
        return self.history[:, -1]

    def with_style(self, style: Tensor) -> "CharacterState":
        """The same moment with another style vector ``[S]`` or ``[B, S]``."""
        return replace(self, style=vectors_of(style, self.style, len(self.phase)))


@dataclass(frozen=True, eq=False)
class Remembering(CharacterState):
    """The state under a model with a memory, see `toolkit.networks.Predictor`."""

    # [B, K, Dx] the last input frames, the oldest first
    memory: Tensor

    __repr__ = summary


def vectors_of(style, like: Tensor, characters: int | None = None) -> Tensor:
    """A style argument as vectors ``[B, S]``, one for each of ``characters`` if given.

    A ValueError if it is not a vector.
    """
    if isinstance(style, str | Mapping):
        raise ValueError("a style is a vector, bank[name] or bank.blend({name: weight}); "
                         f"got {shown(style)}")
    vectors = torch.atleast_2d(as_tensor(style, "a style", like))
    if vectors.dim() != 2 or len(vectors) not in (1, characters or len(vectors)):
        wanted = f"[{characters or 'B'}, S] of all characters"
        raise ValueError(f"a style is one vector [S], or {wanted}; got shape {list(vectors.shape)}")
    return vectors.expand(characters or len(vectors), -1)


def pairs_of(values, what: str, like: Tensor) -> Tensor:
    """World (x, z) ``[B, 2]``, from one pair for all B characters of ``like`` or one for each."""
    pairs = as_tensor(values, what, like)
    if pairs.shape not in ((2,), (1, 2), (len(like), 2)):
        raise ValueError(f"{what} must be one pair (x, z), or [{len(like)}, 2] of all characters; "
                         f"got {list(pairs.shape)}")
    return pairs.expand(len(like), 2)
