"""The constants of a step and of a pose, for the runtimes in numba and in JavaScript."""

from collections import namedtuple
from typing import NamedTuple

import numpy as np

from toolkit.motion import ik, trajectory
from toolkit.networks import phase
from toolkit.runtime import frame, steering

#: Constants that are rules without a change, by module; a rule's name is in small letters.
CONSTANTS = {
    steering: "GAIN PROPORTIONAL INTEGRAL MAX_DRIVE SLOW LOW SIDEWAYS SIDEWAYS_SUM FORGET ASKED "
              "MOVES",
    frame: "CORRECTION JUMP STANDS LIFTED HIGH",
    ik: "SLACK NEAR SOFT SWING ROOM DEEPEST FALL BOTH UNEVEN SUNK HEEL SWIVEL ASIDE PASSED "
        "CROSSING",
    phase: "PULL",
}
Rules = namedtuple("Rules", " ".join(CONSTANTS.values()).lower() + """
    trajectory_in joints_in trajectory_out joints_out phases updates contacts legs
    samples position_shares direction_shares half_second seconds fps lift ground
    fastest spin stand_still standing starting may_stand aligned let_go settle level push
    landing""")
Rules.__doc__ = "Columns of x and z, joints of the legs, constants of the runtime and of foot IK."


def rules_of(model) -> Rules:
    """The rules of a model."""
    layout, fps = model.layout, trajectory.FPS
    constants = {name.lower(): getattr(module, name)
                 for module, names in CONSTANTS.items() for name in names.split()}
    x, z = ({name: columns.start for name, columns in part.items()}
            for part in (layout.inputs, layout.outputs))
    t = np.array(layout.ahead) / layout.ahead[-1]
    return Rules(**constants | {
        "trajectory_in": x["trajectory"], "joints_in": x["joints"],
        "trajectory_out": z["trajectory"], "joints_out": z["joints"], "phases": z["phases"],
        "updates": z["phase_updates"], "contacts": z["contacts"],
        "legs": np.array(frame.leg_joints(layout)).reshape(2, 3),
        "samples": np.array(layout.samples) + trajectory.PAST,
        "position_shares": 1 - (1 - t) ** steering.POSITION_BIAS,
        "direction_shares": 1 - (1 - t) ** steering.DIRECTION_BIAS,
        "half_second": fps // 2,
        "seconds": np.diff(layout.ahead, prepend=0) / fps,
        "fps": float(fps),
        "lift": model.lift - 1.0,  # by which a toe's height grows, not the factor
        "ground": model.ground,
        # per frame
        "fastest": steering.FASTEST / fps,
        "spin": steering.SPIN / fps,
        "standing": 1 / (steering.STANDING * fps),
        "starting": 1 / (steering.STARTING * fps),
        "settle": ik.SETTLE / fps,
        "level": 1 / (ik.LEVEL * fps),
        "push": ik.PUSH / fps,
        "landing": 1 / (frame.LANDING * fps),
        # under other names
        "stand_still": steering.RETURN,
        "let_go": ik.RETURN,
        "may_stand": steering.ALIGNED[0],
        "aligned": steering.ALIGNED[1],
    })


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
    soft: float  # `toolkit.motion.ik.SOFT` and `STRAIGHT`
    straight: float

    @classmethod
    def of(cls, skeleton) -> "Body":
        """The arrays of a skeleton."""
        joints, points = list(skeleton.feature_joints), range(len(skeleton))
        legs = [skeleton.both(part) for part in ik.LEG]
        arms = [pair for bones in ik.arm_bones(skeleton) for pair in zip(*bones, strict=True)]
        return cls(
            parents=np.array(skeleton.parents),
            offsets=skeleton.offsets.double().numpy(),
            features=np.array(skeleton.feature_of),
            own=np.array([joints.index(j) if j in joints else -1 for j in points]),
            ends=np.array([j for j in points if skeleton.is_end(j)], dtype=np.int64),
            legs=np.array(legs).T.copy(),
            chains=np.array(ik.leg_chain(skeleton)),
            arms=np.array(arms),
            soft=ik.SOFT,
            straight=ik.STRAIGHT,
        )
