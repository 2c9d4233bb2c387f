"""A style vector trained in closed loop, so that its walk shows what the clip shows. (ours)

One step ahead, a vector can have a small error and still walk with half of the clip's movement:
each frame leans a little to the mean, and the next one starts from there. So here the model walks
on its own for 1.5 seconds, and the gradient goes back through all its frames. No frame of this walk
belongs to a frame of the clip, so distributions are compared, as of the heights of hands.
"""

import torch
from torch import Tensor
from torch.nn.functional import cosine_similarity

from toolkit import runtime
from toolkit.features import Layout, split_joints, splits
from toolkit.motion import Clip, contacts
from toolkit.motion.clip import root_frames
from toolkit.motion.skeleton import FEET
from toolkit.motion.trajectory import FPS
from toolkit.networks import Predictor
from toolkit.runtime.frame import leg_joints
from toolkit.styles.comparison import Walk, turned, up_of_head

#: A round has so many steps of gradient descent. In a step, characters start from states of walks
#: and go on for so many frames; the first of them still show the vector before, and do not count.
STEPS, STARTS, FRAMES, SKIPPED = 5, 16, 90, 18
RATES = 2e-2, 5e-3  # Adam's first rates: at the higher one, each round breaks some walks
MAX_GRADIENT = 1.0  # the norm to which gradients are clipped
PRIOR = 0.05  # weight of the mean squared z-score of the vector among the bank's
QUANTILES = 64  # of a distribution
#: What a walk shows: a small difference (metres, seconds; the head's has no unit), the weight.
SHOWN = {"places": (0.05, 1.0), "hands": (0.05, 1.0), "feet": (0.04, 0.3), "legs": (0.03, 0.3),
         "head": (0.1, 0.3), "speeds": (0.5, 0.5), "feet's speeds": (0.3, 0.3),
         "root's speed": (0.1, 0.1)}
LAGS, TEMPO = range(4, 45, 4), (0.1, 0.3)  # frames; a small difference of `tempo`, the weight


class ClosedLoop:
    """Gradient descent on a style vector ``[D]`` by the walk that it makes beside a clip.

    ``prior`` is the mean and deviation of the bank's vectors; ``rate`` decays over ``rounds``.
    """

    def __init__(self, model: Predictor, clip: Clip, vector: Tensor, prior: tuple[Tensor, Tensor],
                 rate: float, rounds: int, seed: int):
        self.model, self.prior, self.draw = model, prior, splits.generator(seed)
        clip, joints = clip.to(vector.device), list(model.layout.skeleton.feature_joints)
        roots = root_frames(clip)
        way = roots.turn_to_local(contacts.velocities(roots.positions, clip.fps))[:, None, [0, 2]]
        places = roots.to_local(clip.global_positions[:, joints])[:, None]
        head = up_of_head(clip)[:, None, 1:]
        self.head = max(joints.index(j) for j in clip.skeleton.neck if j in joints)
        self.wanted = distributions(model.layout, places, way, head), tempo(model.layout, places)
        self.vector = vector.clone().requires_grad_()
        self.adam = torch.optim.Adam([self.vector], lr=rate)
        self.decay = torch.optim.lr_scheduler.CosineAnnealingLR(self.adam, rounds * STEPS)

    def round(self, walks: list[Walk]) -> Tensor:
        """The vector after `STEPS` steps, each from other states of these walks' first character.
        """
        mean, deviation = self.prior
        for _ in range(STEPS):
            unlike = ((self.vector - mean) / deviation).square().mean()
            loss = self.distance(*self.walk_on(walks)) + PRIOR * unlike
            (self.vector.grad,) = torch.autograd.grad(loss, [self.vector])
            torch.nn.utils.clip_grad_norm_([self.vector], MAX_GRADIENT)
            self.adam.step()
            self.decay.step()
        return self.vector.detach().clone()

    def walk_on(self, walks: list[Walk]) -> tuple[Tensor, Tensor, Tensor]:
        """B characters walk on from drawn states: places ``[F, B, J, 3]`` of their joints in the
        root's frame, velocities ``[F - 1, B, 2]`` of the root, and heights ``[F, B, 2]`` of the
        head's axes up and forward, as in `up_of_head`.
        """
        begins, orders = [], []
        for i in range(STARTS):
            walk = walks[i % len(walks)]
            # not from the start; FRAMES must follow
            last = len(walk.states) - FRAMES - 1
            at = int(torch.randint(min(FRAMES, last - 1), last, (1,), generator=self.draw))
            begins.append(walk.states[at])
            orders.append(walk.commands[at + 1 : at + 1 + FRAMES])
        # one state, of the model's class (`Remembering`)
        state = type(begins[0])(**{name: torch.cat([getattr(begin, name)[:1] for begin in begins])
                                   for name in vars(begins[0])})
        state, walked = state.with_style(self.vector), []
        for now in zip(*orders, strict=True):
            velocity, facing = (self.vector.new_tensor([getattr(one, name) for one in now])
                                for name in ("velocity", "facing"))
            state = runtime.step(self.model, state, runtime.Command(velocity, facing))
            parts = split_joints(state.joints)
            head = torch.stack([parts[axis][:, self.head, 1] for axis in ("up", "forward")], -1)
            walked.append((parts["position"], state.root, head))
        places, roots, head = (torch.stack(part[SKIPPED:]) for part in zip(*walked, strict=True))
        steps = (roots[1:, :, :2] - roots[:-1, :, :2]) * FPS
        angle = torch.atan2(roots[:-1, :, 2], roots[:-1, :, 3])
        return places, turned(steps.flatten(0, 1), -angle.flatten()).view_as(steps), head

    def distance(self, places: Tensor, way: Tensor, head: Tensor) -> Tensor:
        """The weighted sum of squared Wasserstein distances, and of the difference in `tempo`.

        In one dimension, the 2-Wasserstein distance of two distributions is that of their
        quantiles (Villani 2003, section 2.2).
        """
        wanted, wanted_tempo = self.wanted
        made = distributions(self.model.layout, places, way, head)
        terms = [weight * ((made[what] - wanted[what]) / small).square().mean()
                 for what, (small, weight) in SHOWN.items()]
        small, weight = TEMPO
        unlike = (tempo(self.model.layout, places) - wanted_tempo) / small
        return sum(terms) + weight * unlike.square().mean()


def distributions(layout: Layout, places: Tensor, way: Tensor, head: Tensor) -> dict[str, Tensor]:
    """Quantiles ``[Q, D]`` of D coordinates, speeds or lengths of each kind of `SHOWN`."""
    legs = leg_joints(layout)
    feet = [j for j in legs if j not in legs[::3]]
    hands, hips = ([layout.names.index(layout.skeleton.roles[f"{side}_{part}"]) for side in FEET]
                   for part in ("hand", "hip"))
    speeds = (places[1:] - places[:-1]) * FPS
    kinds = {
        "places": places.flatten(-2),
        "hands": places[..., hands, :].flatten(-2),
        "feet": places[..., feet, :].flatten(-2),
        "legs": (places[..., legs[1::3], :] - places[..., hips, :]).norm(dim=-1),
        "speeds": speeds.flatten(-2),
        "feet's speeds": speeds[..., feet, :].flatten(-2),
        "root's speed": way,
        "head": head,
    }
    levels = torch.linspace(0, 1, QUANTILES).to(places)
    return {what: values.flatten(0, 1).quantile(levels, 0) for what, values in kinds.items()}


def tempo(layout: Layout, places: Tensor) -> Tensor:
    """Cosine similarity of the toes' distance ahead, means not removed, after each of `LAGS`."""
    right, left = (places[..., joint, 2] for joint in leg_joints(layout)[2::3])
    apart = right - left
    return torch.stack([cosine_similarity(apart[lag:].flatten(), apart[:-lag].flatten(), dim=0)
                        for lag in LAGS])
