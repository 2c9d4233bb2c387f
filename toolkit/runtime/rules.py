"""The constants of a step and of a pose as plain numbers and arrays.

The runtimes beside torch, numba and JavaScript, need them.
"""

from collections import namedtuple
from typing import NamedTuple

import numpy as np

from toolkit.motion import ik, trajectory
from toolkit.motion.skeleton import FEET
from toolkit.networks import phase
from toolkit.runtime import frame, steering

Rules = namedtuple("Rules", """
    trajectory_in joints_in trajectory_out joints_out phases updates contacts legs
    samples position_shares direction_shares half_second seconds
    fps gain fastest spin correction jump lift ground
    proportional integral max_drive stand_still slow low sideways sideways_sum forget asked
    moves standing starting may_stand aligned stands
    slack near let_go pull soft swing room deepest fall both settle uneven sunk heel level
    swivel aside passed crossing push landing lifted""")
Rules.__doc__ = "Columns of x and z, joints of the legs, constants of the runtime and of foot IK."


def rules_of(model) -> Rules:
    """The rules of a model."""
    layout = model.layout
    t = np.array(layout.ahead) / layout.ahead[-1]
    return Rules(
        trajectory_in=layout.inputs["trajectory"].start,
        joints_in=layout.inputs["joints"].start,
        trajectory_out=layout.outputs["trajectory"].start,
        joints_out=layout.outputs["joints"].start,
        phases=layout.outputs["phases"].start,
        updates=layout.outputs["phase_updates"].start,
        contacts=layout.outputs["contacts"].start,
        legs=np.array(frame.leg_joints(layout)).reshape(2, 3),
        samples=np.array(layout.samples) + trajectory.PAST,
        position_shares=1 - (1 - t) ** steering.POSITION_BIAS,
        direction_shares=1 - (1 - t) ** steering.DIRECTION_BIAS,
        half_second=trajectory.FPS // 2,
        seconds=np.diff(layout.ahead, prepend=0) / trajectory.FPS,
        fps=float(trajectory.FPS),
        gain=steering.GAIN,
        fastest=steering.FASTEST / trajectory.FPS,
        spin=steering.SPIN / trajectory.FPS,
        correction=frame.CORRECTION,
        jump=frame.JUMP,
        lift=getattr(model, "lift", 1.0) - 1.0,
        ground=getattr(model, "ground", frame.GROUND),
        proportional=steering.PROPORTIONAL,
        integral=steering.INTEGRAL,
        max_drive=steering.MAX_DRIVE,
        stand_still=steering.RETURN,
        slow=steering.SLOW,
        low=steering.LOW,
        sideways=steering.SIDEWAYS,
        sideways_sum=steering.SIDEWAYS_SUM,
        forget=steering.FORGET,
        asked=steering.ASKED,
        moves=steering.MOVES,
        standing=1 / (steering.STANDING * trajectory.FPS),
        starting=1 / (steering.STARTING * trajectory.FPS),
        may_stand=steering.ALIGNED[0],
        aligned=steering.ALIGNED[1],
        stands=frame.STANDS,
        slack=ik.SLACK,
        near=ik.NEAR,
        let_go=ik.RETURN,
        pull=phase.PULL,
        soft=ik.SOFT,
        swing=ik.SWING,
        room=ik.ROOM,
        deepest=ik.DEEPEST,
        fall=ik.FALL,
        both=ik.BOTH,
        settle=ik.SETTLE / trajectory.FPS,
        uneven=ik.UNEVEN,
        sunk=ik.SUNK,
        heel=ik.HEEL,
        level=1 / (ik.LEVEL * trajectory.FPS),
        swivel=ik.SWIVEL,
        aside=ik.ASIDE,
        passed=ik.PASSED,
        crossing=ik.CROSSING,
        push=ik.PUSH / trajectory.FPS,
        landing=1 / (frame.LANDING * trajectory.FPS),
        lifted=frame.LIFTED,
    )


class Body(NamedTuple):
    """The skeleton of J' points as arrays."""

    parents: np.ndarray  # [J']
    offsets: np.ndarray  # [J', 3]
    # [J'] index of the feature joint that gives a point its rotation, its own or its parent's
    features: np.ndarray
    own: np.ndarray  # [J'] index of a point's own feature joint, -1 if it has none
    ends: np.ndarray  # [E] points that follow their parents
    legs: np.ndarray  # [2, 4] hip, knee, foot and toe, right and left
    # [C] all points from the hips to the toes, without the hips; parents come before children
    chains: np.ndarray
    # [A, 2] arm joints and the points at their bones' other ends, from the body outwards
    arms: np.ndarray

    @classmethod
    def of(cls, skeleton) -> "Body":
        """The arrays of a skeleton."""
        joints = list(skeleton.feature_joints)
        return cls(
            parents=np.array(skeleton.parents),
            offsets=skeleton.offsets.double().numpy(),
            features=np.array(skeleton.feature_of),
            own=np.array([joints.index(j) if j in joints else -1 for j in range(len(skeleton))]),
            ends=np.array([j for j in range(len(skeleton)) if skeleton.is_end(j)], dtype=np.int64),
            legs=np.array(
                [
                    [skeleton.role(f"{side}_{part}") for part in ("hip", "knee", "foot", "toe")]
                    for side in FEET
                ]
            ),
            chains=np.array(ik.leg_chain(skeleton)),
            arms=np.array(
                [pair for bones in ik.arm_bones(skeleton) for pair in zip(*bones, strict=True)]
            ),
        )
