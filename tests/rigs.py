"""The same walk on rigs with the names, joints, axes and units of common exporters."""

import math
from dataclasses import dataclass, replace

import torch

import toolkit as tk
from toolkit.motion import Clip, Skeleton, rotations as R

BODY = ("Hips", "Chest", "Chest2", "Chest3", "Chest4", "Neck", "Head")
LIMBS = ("Collar", "Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Toe")
PARTS = dict(zip(("shoulder", "elbow", "hand", "hip", "knee", "foot", "toe"), LIMBS[1:],
                 strict=True))


@dataclass(frozen=True)
class Convention:
    """Names of a rig; ``{}`` stands for the side."""

    sides: tuple[str, str]  # left, right
    body: list[str]  # names for `BODY`
    limbs: list[str]  # names for `LIMBS`, in capitals where the rig has no such joint
    unit: float = 0.01
    up: str = "y"
    above: tuple[str, ...] = ()  # joints above the hips, from the root down
    within: str = ""  # pairs: a limb joint of `LIMBS`, a joint halfway to it from its parent
    leaves: str = ""  # pairs: a limb joint of `LIMBS`, a joint below it
    ends: bool = True  # whether it has End Sites


LR, LOWER, WORDS = ("L", "R"), ("l", "r"), ("Left", "Right")


def each(pattern: str, names: str) -> list[str]:
    """The pattern with each of the names in the place of the star."""
    return [pattern.replace("*", name) for name in names.split()]


BACK = "Hips Spine Spine1 Spine2 Spine3 Neck Head"
ARM_LEG = "Shoulder Arm ForeArm Hand UpLeg Leg Foot ToeBase"
TABLE = {
    "Mixamo": Convention(
        WORDS, each("mixamorig:*", BACK), each("mixamorig:{}*", ARM_LEG),
        leaves="Wrist mixamorig:{}HandThumb1, Wrist mixamorig:{}HandIndex1"),
    "CMU": Convention(
        WORDS, each("*", "Hips LowerBack Spine Spine1 Spine2 Neck1 Head"), each("{}*", ARM_LEG),
        unit=0.05644, within="Hip {}HipJoint", leaves="Wrist {}Thumb, Wrist {}FingerBase"),
    "MotionBuilder": Convention(
        WORDS, each("*", BACK), each("{}*", ARM_LEG), above=("Reference",),
        within="Knee {}UpLegRoll, Wrist {}ForeArmRoll"),
    "Daz Genesis 8": Convention(
        LOWER,
        each("*", "hip abdomenLower abdomenUpper chestLower chestUpper neckLower head"),
        each("{}*", "Collar ShldrBend ForearmBend Hand ThighBend Shin Foot Toe"),
        within="Elbow {}ShldrTwist, Wrist {}ForearmTwist, Knee {}ThighTwist, Toe {}Metatarsals",
        leaves="Toe {}BigToe, Wrist {}Thumb1, Wrist {}Carpal1"),
    "Reallusion": Convention(
        LR, each("CC_Base_*", "Hip Waist Spine01 Spine02 Spine03 NeckTwist01 Head"),
        each("CC_Base_{}_*", "Clavicle Upperarm Forearm Hand Thigh Calf Foot ToeBase"),
        above=("CC_Base_BoneRoot",), ends=False,
        leaves="Knee CC_Base_{}_KneeShareBone, Hip CC_Base_{}_ThighTwist01, "
               "Elbow CC_Base_{}_ElbowShareBone, Toe CC_Base_{}_BigToe1, "
               "Wrist CC_Base_{}_Thumb1, Wrist CC_Base_{}_Mid1"),
    "3ds Max Biped with spaces": Convention(
        LR, each("Bip001 *", "Pelvis Spine Spine1 Spine2 Spine3 Neck Head"),
        each("Bip001 {} *", "Clavicle UpperArm Forearm Hand Thigh Calf Foot Toe0"),
        above=("Bip001",)),
    "Unreal": Convention(
        LOWER, each("*", "pelvis spine_01 spine_02 spine_03 spine_04 neck_01 head"),
        each("*_{}", "clavicle upperarm lowerarm hand thigh calf foot ball"), up="z",
        above=("root",), ends=False,
        leaves="Shoulder upperarm_twist_01_{}, Elbow lowerarm_twist_01_{}, "
               "Hip thigh_twist_01_{}, Knee calf_twist_01_{}, Wrist thumb_01_{}, "
               "Wrist index_01_{}"),
    "SMPL": Convention(
        LR, each("*", "Pelvis Spine1 Spine2 Spine3 Spine4 Neck Head"),
        each("{}_*", "Collar Shoulder Elbow Wrist Hip Knee Ankle Foot"), unit=1.0,
        leaves="Wrist {}_Hand", ends=False),
    "VRM": Convention(
        ("left", "right"), each("*", "hips spine chest upperChest upperUpperChest neck head"),
        each("{}*", "Shoulder UpperArm LowerArm Hand UpperLeg LowerLeg Foot Toes"), unit=1.0,
        ends=False, leaves="Wrist {}ThumbMetacarpal, Wrist {}LittleProximal"),
    "Perception Neuron": Convention(
        WORDS, each("*", BACK), [*each("{}*", "Shoulder Arm ForeArm Hand UpLeg Leg Foot"), "TOE"],
        leaves="Wrist {}HandThumb1, Wrist {}InHandIndex"),
    "MakeHuman": Convention(
        LR, each("*", "root spine05 spine04 spine03 spine01 neck01 head"),
        each("*.{}", "clavicle upperarm01 lowerarm01 wrist upperleg01 lowerleg01 foot toe1-1"),
        unit=0.1, up="z",
        within="Hip pelvis.{}, Knee upperleg02.{}, Ankle lowerleg02.{}, Shoulder shoulder01.{}, "
               "Elbow upperarm02.{}, Wrist lowerarm02.{}, Toe metatarsal1.{}",
        leaves="Ankle metatarsal2.{}, Wrist metacarpal1.{}, Toe toe1-2.{}"),
    "LaFAN1": Convention(
        WORDS, each("*", BACK),
        each("{}*", "Shoulder Arm ForeArm Hand UpLeg Leg Foot Toe")),
    "Blender Rigify": Convention(
        LR, each("DEF-*", "spine spine.001 spine.002 spine.003 spine.004 spine.005 spine.006"),
        each("DEF-*.{}", "shoulder upper_arm forearm hand thigh shin foot toe"),
        unit=1.0, up="z",
        within="Elbow DEF-upper_arm.{}.001, Wrist DEF-forearm.{}.001, Knee DEF-thigh.{}.001, "
               "Ankle DEF-shin.{}.001",
        leaves="Collar DEF-breast.{}, Wrist DEF-thumb.01.{}"),
    "Second Life": Convention(
        LOWER, each("m*", "Pelvis Torso Chest Chest2 Chest3 Neck Head"),
        [*each("{}*", "Collar Shldr ForeArm Hand Thigh Shin Foot"), "TOE"], unit=0.0254),
    "OptiTrack Motive": Convention(
        LR, each("*", "Hip Ab Spine2 Spine3 Chest Neck Head"),
        each("{}*", "Shoulder UArm FArm Hand Thigh Shin Foot Toe")),
    "Auto-Rig Pro": Convention(
        LOWER, each("*.x", "root spine_01 spine_02 spine_03 spine_04 neck head"),
        each("*.{}", "shoulder arm_stretch forearm_stretch hand thigh_stretch leg_stretch foot "
             "toes_01"),
        unit=1.0, leaves="Hip thigh_twist.{}, Shoulder arm_twist.{}"),
    "3ds Max CAT": Convention(
        LR, each("CATRig*", "Hub001 Spine1 Spine2 Spine3 Hub002 Neck Hub003"),
        each("CATRig{}*", "ArmCollarbone Arm1 Arm2 ArmPalm Leg1 Leg2 LegAnkle LegDigit11")),
}


def roles(convention: Convention) -> dict[str, str]:
    """The right roles of a rig: a leg without a toe joint has the End Site of its foot."""
    limbs = dict(zip(LIMBS, convention.limbs, strict=True))
    found = {"hips": convention.body[0]}
    for side, word in zip(("left", "right"), convention.sides, strict=True):
        for part, joint in PARTS.items():
            missing = limbs[joint].isupper()
            name = limbs["Ankle" if missing else joint].format(word)
            found[f"{side}_{part}"] = name + "End" if missing else name
    return found


def walk(name: str, turned: bool = False, seconds: float = 4.0, **changes) -> Clip:
    """A walk towards +z on a rig, in metres with Y up; ``turned``: each joint has its own axes.

    ``changes`` are of fields of its convention.
    """
    convention = replace(TABLE[name], **changes)
    clip = tk.datasets.procedural.generate("Neutral", seconds=seconds)
    return _turned(_rig(clip, convention)) if turned else _rig(clip, convention)


def _pairs(text: str) -> list[list[str]]:
    return [pair.split() for pair in text.split(", ") if pair]


def _rig(clip: Clip, convention: Convention) -> Clip:
    """The clip with the joints of a convention."""
    old, limbs = clip.skeleton, dict(zip(LIMBS, convention.limbs, strict=True))
    called = dict(zip(BODY, convention.body, strict=True))
    where = {f"{side}{part}": (word, part) for part in limbs
             for word, side in zip(convention.sides, ("Left", "Right"), strict=True)}
    called |= {joint: limbs[part].format(word) for joint, (word, part) in where.items()}
    toeless = [joint for joint, (_, part) in where.items() if limbs[part].isupper()]
    names, parents, offsets, turns, ends = [], [], [], [], []

    def add(name, parent, offset, turn, end=False):
        names.append(name)
        parents.append(parent)
        offsets.append(offset)
        turns.append(turn)
        if end:
            ends.append(name)
        return len(names) - 1

    still, at = R.identity(len(clip)), {-1: -1}
    for joint in convention.above:
        at[-1] = add(joint, at[-1], torch.zeros(3), still if at[-1] >= 0 else clip.rotations[:, 0])
    for j, joint in enumerate(old.names):
        parent, offset, turn = at[old.parents[j]], old.offsets[j], clip.rotations[:, j]
        if joint in old.ends and (not convention.ends or old.names[old.parents[j]] in toeless):
            continue
        if joint in old.ends or joint in toeless:
            at[j] = add(f"{names[parent]}End", parent, offset, still, end=True)
            continue
        if j == 0 and convention.above:
            turn = still
        word, part = where.get(joint, ("", ""))
        for limb, pattern in _pairs(convention.within):
            if limb == part:
                offset = offset / 2
                parent = add(pattern.format(word), parent, offset, still)
        at[j] = add(called[joint], parent, offset, turn)
        for limb, pattern in _pairs(convention.leaves):
            if limb == part:
                aside = torch.tensor([0.01 if joint[0] == "L" else -0.01, 0.02, 0.03])
                add(pattern.format(word), at[j], aside, still)
    skeleton = Skeleton(names, parents, torch.stack(offsets), {}, ends)
    return Clip(skeleton, torch.stack(turns, 1), clip.root_positions, clip.fps, "Neutral", "FW")


def _turned(clip: Clip) -> Clip:
    """The same positions with x axes along the bones, and half a turn on the right side."""
    skeleton, axes = clip.skeleton, []
    for j in range(len(skeleton)):
        children = [k for k, p in enumerate(skeleton.parents) if p == j
                    and float(skeleton.offsets[k].norm()) > 0]
        bone = skeleton.offsets[children[0]] if children and j else torch.tensor([0.0, 1.0, 0.0])
        axes.append(R.between(torch.tensor([1.0, 0.0, 0.0]), R.normalize(bone)))
    axes = torch.stack(axes)
    for j, name in enumerate(skeleton.names):
        if tk.motion.role_words.read(name).side == "right":
            axes[j] = R.multiply(axes[j], R.from_euler(torch.tensor([math.pi, 0.0, 0.0]), "XYZ"))
    turned = R.multiply(clip.global_rotations, axes)
    above = axes[list(skeleton.parents[1:])]
    offsets = torch.cat((skeleton.offsets[:1], R.rotate(R.inverse(above), skeleton.offsets[1:])))
    for j in range(len(skeleton)):
        if skeleton.is_end(j):
            turned[:, j] = turned[:, skeleton.parents[j]]
    made = Skeleton(skeleton.names, skeleton.parents, offsets, {}, skeleton.ends)
    return clip.replace(skeleton=made, rotations=R.unroll(tk.motion.local_rotations(made, turned)))
