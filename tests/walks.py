"""The same walk by the plain runtime and by a page's JavaScript, for the tests of the page."""

from torch import Tensor, tensor

from toolkit import runtime
from toolkit.motion import Clip

WAYS = (  # m/s, seconds, where to
    (0.8, 3.0, (0.0, 1.0)),
    (1.6, 3.0, (1.0, 0.0)),
    (0.8, 4.0, (1.0, 1.0)),
)
COMMANDS = [command for way in WAYS for command in runtime.straight(*way)]

#: JavaScript: poses ``[frame][root 3, rotations 4 J']`` of a character through commands in a style.
WALK = """(character, commands, style) => {
    character.restart();
    return commands.map((command) => {
        character.step(command, style);
        character.pose();
        return [...character.root, ...character.rotations];
    });
}"""


def commands(frames: int = len(COMMANDS)) -> list[dict]:
    """The first of `COMMANDS` as JavaScript takes them."""
    return [{"velocity": list(c.velocity), "facing": list(c.facing)} for c in COMMANDS[:frames]]


def apart(walked: Clip, poses: list[list[float]]) -> Tensor:
    """Distance of the farthest joint of `WALK`'s poses from a rollout's, mm ``[F]``."""
    numbers = tensor(poses)
    clip = Clip(walked.skeleton, numbers[:, 3:].unflatten(-1, (-1, 4)), numbers[:, :3], walked.fps)
    return 1e3 * (clip.global_positions - walked.global_positions).norm(dim=-1).amax(-1)
