"""Parameters of a procedural style (legs, arms, trunk), and the table of the built-in styles.

Lengths are in metres and times in seconds. Angles are in degrees, unlike in the rest of the
package, because people write these numbers by hand. A style describes a walk;
`toolkit.datasets.procedural` derives the other gaits from it.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Leg:
    """How one leg steps; the sole is highest in the middle of the swing."""

    stance: float = 0.575  # share of the stride from heel strike to toe-off (duty factor)
    lift: float = 0.035  # highest rise of the sole in the swing
    kick: float = 0.0  # angle of a forward kick of the straight leg in the swing; 90: horizontal
    circle: float = 0.0  # outward distance of the swing (circumduction)
    ahead: float = 0.0  # distance by which the foot lands ahead of its usual place
    heel_strike: float = 27.0  # pitch of the foot at heel strike, toes up
    toe_off: float = 62.0  # pitch of the foot just after toe-off, heel up
    tiptoe: float = 0.0  # pitch of the foot during the whole stance, heel up
    turned_out: float = 7.0  # yaw of the toes, outwards
    raised: bool = False  # the leg stays in the air and the other leg hops


@dataclass(frozen=True)
class Arm:
    """How one arm hangs and swings.

    Positive flexion is forward: with a raised upper arm the elbow bends upwards.
    """

    out: float = 9.0  # abduction of the upper arm; 0: hanging, 90: T-pose
    forward: float = 2.0  # forward flexion of the upper arm
    twist: float = 20.0  # inward rotation of the upper arm: a bent forearm crosses the belly
    elbow: float = 20.0  # flexion
    run_elbow: float = 75.0  # flexion when running
    wrist: float = 5.0  # flexion
    swing: float = 17.0  # amplitude of the upper arm, forward and back
    elbow_swing: float = 9.0  # amplitude of the elbow; it bends most when the hand is in front
    out_swing: float = 0.0  # amplitude sideways
    phase: float = 0.0  # lag behind the opposite leg
    ratio: float = 1.0  # swings per stride
    # fixed place of the wrist relative to the hips: outwards, up, forward
    hand_at: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class Style:
    """How a character walks."""

    cadence: float = 0.9  # strides (two steps) per second at the usual speed
    step: float = 0.665  # length of a step at the usual speed; speed = 2 · step · cadence
    width: float = 0.17  # lateral distance between the feet
    run: float = 2.2  # running speed divided by walking speed
    # the left step takes (1 + asymmetry), the right one (1 - asymmetry) times half a stride
    asymmetry: float = 0.0
    legs: Leg = Leg()
    left_leg: Leg | None = None  # instead of `legs`
    right_leg: Leg | None = None
    # pelvis
    height: float = 0.975  # of the hips, where the legs reach the floor
    bob: float = 0.019  # vertical amplitude, on top of what the reach of the legs causes
    sway: float = 0.03  # lateral amplitude, towards the standing foot
    forward: float = 0.0  # offset ahead of the middle between the feet
    tilt: float = -2.0  # forward pitch of the pelvis
    yaw: float = 4.5  # amplitude of the turn with the swinging leg
    drop: float = 2.5  # amplitude of the roll: the pelvis drops on the side of the swinging leg
    # trunk and head
    lean: float = 6.0  # forward pitch of the spine
    bend: float = 0.0  # to the left
    lean_swing: float = 0.0  # amplitude, twice per stride
    bend_swing: float = 0.0  # amplitude, towards the standing foot
    twist_swing: float = 5.0  # amplitude of the chest relative to the pelvis
    neck: float = 14.0  # forward pitch of the neck
    head: float = 0.0  # forward pitch of the head relative to the neck
    head_roll: float = 0.0
    head_swing: float = 0.0  # amplitude of the roll of the head
    steady: float = 0.85  # share of the trunk's rotation that neck and head cancel, 0 to 1
    shrug: float = -6.0  # how far the shoulders are raised
    arms: Arm = Arm()
    left_arm: Arm | None = None  # instead of `arms`
    right_arm: Arm | None = None
    noise: float = 0.1  # random motion of trunk, arms and paths
    # random motion of everything, also of times and places of the steps; at 1 it nearly falls
    stagger: float = 0.0

    @property
    def speed(self) -> float:
        """Usual walking speed, m/s."""
        return 2 * self.step * self.cadence

    @property
    def symmetric(self) -> bool:
        """Whether left and right limbs move alike, half a stride apart."""
        if any((self.asymmetry, self.bend, self.head_roll)):
            return False
        return self.leg("left") == self.leg("right") and self.arm("left") == self.arm("right")

    def leg(self, side: str) -> Leg:
        """The "left" or "right" leg."""
        return getattr(self, f"{side}_leg") or self.legs

    def arm(self, side: str) -> Arm:
        """The "left" or "right" arm."""
        return getattr(self, f"{side}_arm") or self.arms


_HOPPING = {"cadence": 1.75, "step": 0.30, "height": 0.95, "bob": 0.055, "lean": 9,
            "arms": Arm(out=42, elbow=45, run_elbow=45, swing=0, out_swing=12)}
_HOP = Leg(stance=0.52, lift=0.09, heel_strike=2, toe_off=40)

STYLES: dict[str, Style] = {
    "Neutral": Style(),
    "Aeroplane": Style(bend_swing=11, twist_swing=1,
        arms=Arm(out=92, forward=0, elbow=3, run_elbow=3, twist=0, wrist=0, swing=2,
                 elbow_swing=0)),
    "Akimbo": Style(yaw=7, drop=4, twist_swing=7, lean=2,
        arms=Arm(hand_at=(0.19, 0.13, -0.01), wrist=-20)),
    "ArmsAboveHead": Style(lean=2, neck=8, shrug=10,
        arms=Arm(out=172, forward=0, elbow=8, run_elbow=8, twist=0, wrist=0, swing=4,
                 elbow_swing=0)),
    "ArmsAtOtherFrequency": Style(arms=Arm(swing=32, elbow=30, ratio=1.5)),
    "BentForward": Style(lean=48, tilt=14, forward=-0.09, height=0.93, step=0.52, neck=2, head=-14,
        steady=0.6,
        arms=Arm(forward=38, out=12, swing=13, elbow=12)),
    "BigSteps": Style(cadence=0.72, run=1.7, step=0.98, height=0.95, yaw=9, lean=12, twist_swing=9,
        legs=Leg(heel_strike=26, toe_off=55, lift=0.06), arms=Arm(swing=30, elbow=25)),
    "Crouch": Style(cadence=0.85, step=0.5, width=0.24, height=0.7, forward=-0.06, tilt=14, lean=26,
        neck=0, head=-12,
        legs=Leg(heel_strike=0, toe_off=40, lift=0.08, tiptoe=16),
        arms=Arm(forward=22, elbow=50, swing=12, out=24)),
    "DragRightLeg": Style(cadence=0.68, step=0.37, asymmetry=-0.1, height=0.955, lean=14, bend=9,
        bend_swing=5, neck=18,
        right_leg=Leg(stance=0.5, lift=0.0, heel_strike=-6, toe_off=12, turned_out=38, circle=0.06,
                      ahead=-0.24),
        arms=Arm(out=18), right_arm=Arm(out=18, swing=0, elbow=32, twist=35)),
    "Drunk": Style(cadence=0.75, step=0.46, width=0.26, sway=0.05, bend_swing=11, noise=0.4,
        stagger=1.0, steady=0.2, neck=20, head_swing=12, lean_swing=4,
        arms=Arm(out=24, swing=12, elbow=24)),
    "HandsBehindBack": Style(cadence=0.8, step=0.52, lean=3, neck=18,
        arms=Arm(hand_at=(0.05, 0.04, -0.17), wrist=25)),
    "HandsInPockets": Style(lean=9, neck=18, shrug=6, arms=Arm(hand_at=(0.19, 0.0, 0.07), wrist=0)),
    "HighKnees": Style(cadence=0.85, step=0.55, height=0.945, lean=2,
        legs=Leg(stance=0.56, lift=0.46, heel_strike=2, toe_off=38),
        arms=Arm(swing=22, elbow=60, elbow_swing=15)),
    "HopLeft": Style(**_HOPPING, bend=4, left_leg=_HOP, right_leg=Leg(raised=True)),
    "HopRight": Style(**_HOPPING, bend=-4, right_leg=_HOP, left_leg=Leg(raised=True)),
    "LeanBack": Style(lean=-27, tilt=-8, forward=0.09, step=0.55, arms=Arm(forward=-16, swing=14)),
    "LimpLeft": Style(cadence=0.8, step=0.45, asymmetry=-0.35, bend_swing=9, bend=4, drop=9,
        head_swing=7, arms=Arm(out=20),
        left_leg=Leg(stance=0.5, heel_strike=4, toe_off=25, lift=0.03, ahead=0.02)),
    "MarchKick": Style(cadence=0.72, step=0.6, lean=0, neck=8, tilt=-3, height=0.95,
        legs=Leg(stance=0.54, lift=0.09, kick=62, heel_strike=6, toe_off=34),
        arms=Arm(swing=42, elbow=6, run_elbow=40, elbow_swing=2)),
    "Old": Style(cadence=0.85, step=0.34, width=0.2, height=0.92, forward=-0.05, tilt=8, lean=36,
        neck=6, head=-16, noise=0.2, shrug=4,
        legs=Leg(stance=0.68, lift=0.02, heel_strike=8, toe_off=22),
        arms=Arm(forward=22, elbow=48, swing=6, elbow_swing=3)),
    "PendulumHands": Style(lean_swing=7,
        arms=Arm(swing=46, elbow=10, elbow_swing=6),
        right_arm=Arm(swing=46, elbow=10, elbow_swing=6, phase=180)),
    "Penguin": Style(cadence=1.15, step=0.19, width=0.2, sway=0.06, bend_swing=15, lean=-3,
        twist_swing=0, yaw=9, shrug=4,
        legs=Leg(turned_out=42, heel_strike=4, toe_off=16, lift=0.05),
        arms=Arm(out=38, elbow=4, run_elbow=4, twist=-30, wrist=-35, swing=0, elbow_swing=0)),
    "Strut": Style(cadence=0.82, step=0.68, lean=-11, neck=8, head=-6, shrug=2, yaw=8, drop=8,
        sway=0.028, twist_swing=11, bend_swing=8,
        arms=Arm(out=24, forward=-10, swing=36, elbow=28, twist=30)),
    "Tiptoe": Style(cadence=1.05, step=0.36, width=0.12, height=1.06, lean=3,
        legs=Leg(tiptoe=48, heel_strike=0, toe_off=56, lift=0.07),
        arms=Arm(out=32, elbow=38, swing=6)),
    "WideLegs": Style(cadence=0.85, step=0.5, width=0.6, sway=0.09, bend_swing=7,
        legs=Leg(turned_out=22, circle=0.08), arms=Arm(out=22, swing=10)),
    "Zombie": Style(cadence=0.68, step=0.34, height=0.955, width=0.22, sway=0.045, bend_swing=8,
        lean=8, head_roll=14, head=6, steady=0.3, noise=0.3, yaw=7,
        legs=Leg(stance=0.68, lift=0.02, heel_strike=2, toe_off=20),
        arms=Arm(forward=82, out=8, elbow=5, run_elbow=5, twist=0, wrist=-30, swing=3,
                 elbow_swing=3)),
}
