"""The same walk on rigs with the names, extra joints, axes and units of common exporters, all typed by hand."""

import math
from dataclasses import dataclass

import torch

import toolkit as tk
from toolkit.motion import Clip, Skeleton
from toolkit.motion import rotations as R

BODY = ("Hips", "Chest", "Chest2", "Chest3", "Chest4", "Neck", "Head")
LIMBS = ("Collar", "Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Toe")
PARTS = dict(zip(("shoulder", "elbow", "hand", "hip", "knee", "foot", "toe"), LIMBS[1:], strict=True))


@dataclass(frozen=True)
class Convention:
    """Names of a rig; ``{}`` stands for the side."""

    sides: tuple[str, str]  # left, right
    body: str  # names for `BODY`
    limbs: str  # names for `LIMBS`, in capitals where the rig has no such joint
    unit: float = 0.01
    up: str = "y"
    above: tuple[str, ...] = ()  # joints above the hips, from the root down
    within: tuple[tuple[str, str], ...] = ()  # (limb joint of `LIMBS`, name of a joint halfway to it from its parent)
    leaves: tuple[tuple[str, str], ...] = ()  # (limb joint of `LIMBS`, name of a joint below it)
    ends: bool = True  # whether it has End Sites


LR, LOWER, WORDS = ("L", "R"), ("l", "r"), ("Left", "Right")
TABLE = {
    "Mixamo": Convention(
        WORDS, "mixamorig:Hips mixamorig:Spine mixamorig:Spine1 mixamorig:Spine2 mixamorig:Spine3 mixamorig:Neck "
        "mixamorig:Head",
        "mixamorig:{}Shoulder mixamorig:{}Arm mixamorig:{}ForeArm mixamorig:{}Hand mixamorig:{}UpLeg mixamorig:{}Leg "
        "mixamorig:{}Foot mixamorig:{}ToeBase", leaves=(("Wrist", "mixamorig:{}HandThumb1"), ("Wrist",
        "mixamorig:{}HandIndex1"))),
    "Mixamo with a number": Convention(
        WORDS, "mixamorig9:Hips mixamorig9:Spine mixamorig9:Spine1 mixamorig9:Spine2 mixamorig9:Spine3 mixamorig9:Neck "
        "mixamorig9:Head", "mixamorig9:{}Shoulder mixamorig9:{}Arm mixamorig9:{}ForeArm mixamorig9:{}Hand "
        "mixamorig9:{}UpLeg "
        "mixamorig9:{}Leg mixamorig9:{}Foot mixamorig9:{}ToeBase", ends=False),
    "Mixamo in three.js": Convention(
        WORDS, "mixamorigHips mixamorigSpine mixamorigSpine1 mixamorigSpine2 mixamorigSpine3 mixamorigNeck mixamorigHead",
        "mixamorig{}Shoulder mixamorig{}Arm mixamorig{}ForeArm mixamorig{}Hand mixamorig{}UpLeg mixamorig{}Leg "
        "mixamorig{}Foot "
        "mixamorig{}ToeBase", unit=1.0),
    "CMU": Convention(
        WORDS, "Hips LowerBack Spine Spine1 Spine2 Neck1 Head", "{}Shoulder {}Arm {}ForeArm {}Hand {}UpLeg {}Leg {}Foot "
        "{}ToeBase",
        unit=0.05644, within=(("Hip", "{}HipJoint"),), leaves=(("Wrist", "{}Thumb"), ("Wrist", "{}FingerBase"))),
    "CMU as ASF": Convention(
        LOWER, "root lowerback upperback thorax lowerneck upperneck head",
        "{}clavicle {}humerus {}radius {}wrist {}femur {}tibia {}foot {}toes", unit=0.05644,
        leaves=(("Wrist", "{}hand"), ("Wrist", "{}thumb"))),
    "MotionBuilder": Convention(
        WORDS, "Hips Spine Spine1 Spine2 Spine3 Neck Head", "{}Shoulder {}Arm {}ForeArm {}Hand {}UpLeg {}Leg {}Foot "
        "{}ToeBase",
        above=("Reference",), within=(("Knee", "{}UpLegRoll"), ("Wrist", "{}ForeArmRoll"))),
    "Daz Genesis 8": Convention(
        LOWER, "hip abdomenLower abdomenUpper chestLower chestUpper neckLower head",
        "{}Collar {}ShldrBend {}ForearmBend {}Hand {}ThighBend {}Shin {}Foot {}Toe",
        within=(("Elbow", "{}ShldrTwist"), ("Wrist", "{}ForearmTwist"), ("Knee", "{}ThighTwist"), ("Toe", "{}Metatarsals")),
        leaves=(("Toe", "{}BigToe"), ("Wrist", "{}Thumb1"), ("Wrist", "{}Carpal1"))),
    "Daz Genesis 9": Convention(
        LOWER, "hip spine1 spine2 spine3 spine4 neck1 head",
        "{}_shoulder {}_upperarm {}_forearm {}_hand {}_thigh {}_shin {}_foot {}_toes",
        within=(("Toe", "{}_metatarsals"),), leaves=(("Shoulder", "{}_upperarmtwist1"), ("Hip", "{}_thightwist1"))),
    "Poser": Convention(
        LOWER, "hip abdomen waist chest upperchest neck head", "{}Collar {}Shldr {}ForeArm {}Hand {}Thigh {}Shin {}Foot "
        "{}Toe",
        within=(("Hip", "{}Buttock"),), leaves=(("Wrist", "{}Thumb1"), ("Wrist", "{}Mid1"))),
    "Reallusion": Convention(
        LR, "CC_Base_Hip CC_Base_Waist CC_Base_Spine01 CC_Base_Spine02 CC_Base_Spine03 CC_Base_NeckTwist01 CC_Base_Head",
        "CC_Base_{}_Clavicle CC_Base_{}_Upperarm CC_Base_{}_Forearm CC_Base_{}_Hand CC_Base_{}_Thigh CC_Base_{}_Calf "
        "CC_Base_{}_Foot CC_Base_{}_ToeBase", above=("CC_Base_BoneRoot",), ends=False,
        leaves=(("Knee", "CC_Base_{}_KneeShareBone"), ("Hip", "CC_Base_{}_ThighTwist01"), ("Elbow",
        "CC_Base_{}_ElbowShareBone"),
                ("Toe", "CC_Base_{}_BigToe1"), ("Wrist", "CC_Base_{}_Thumb1"), ("Wrist", "CC_Base_{}_Mid1"))),
    "3ds Max Biped": Convention(
        LR, "Bip01_Pelvis Bip01_Spine Bip01_Spine1 Bip01_Spine2 Bip01_Spine3 Bip01_Neck Bip01_Head",
        "Bip01_{}_Clavicle Bip01_{}_UpperArm Bip01_{}_Forearm Bip01_{}_Hand Bip01_{}_Thigh Bip01_{}_Calf Bip01_{}_Foot "
        "Bip01_{}_Toe0", unit=0.0254, up="z", above=("Bip01",),
        leaves=(("Wrist", "Bip01_{}_Finger0"), ("Toe", "Bip01_{}_Toe0Nub"), ("Wrist", "Bip01_{}_ForeTwist"))),
    "3ds Max Biped with spaces": Convention(
        LR, "Bip001 Pelvis,Bip001 Spine,Bip001 Spine1,Bip001 Spine2,Bip001 Spine3,Bip001 Neck,Bip001 Head",
        "Bip001 {} Clavicle,Bip001 {} UpperArm,Bip001 {} Forearm,Bip001 {} Hand,Bip001 {} Thigh,Bip001 {} Calf,Bip001 {} "
        "Foot,"
        "Bip001 {} Toe0", above=("Bip001",)),
    "Source engine": Convention(
        LR, "ValveBiped.Bip01_Pelvis ValveBiped.Bip01_Spine ValveBiped.Bip01_Spine1 ValveBiped.Bip01_Spine2 "
        "ValveBiped.Bip01_Spine4 ValveBiped.Bip01_Neck1 ValveBiped.Bip01_Head1",
        "ValveBiped.Bip01_{}_Clavicle ValveBiped.Bip01_{}_UpperArm ValveBiped.Bip01_{}_Forearm ValveBiped.Bip01_{}_Hand "
        "ValveBiped.Bip01_{}_Thigh ValveBiped.Bip01_{}_Calf ValveBiped.Bip01_{}_Foot ValveBiped.Bip01_{}_Toe0",
        unit=0.0254, up="z"),
    "Unreal": Convention(
        LOWER, "pelvis spine_01 spine_02 spine_03 spine_04 neck_01 head",
        "clavicle_{} upperarm_{} lowerarm_{} hand_{} thigh_{} calf_{} foot_{} ball_{}", up="z", above=("root",), ends=False,
        leaves=(("Shoulder", "upperarm_twist_01_{}"), ("Elbow", "lowerarm_twist_01_{}"), ("Hip", "thigh_twist_01_{}"),
                ("Knee", "calf_twist_01_{}"), ("Wrist", "thumb_01_{}"), ("Wrist", "index_01_{}"))),
    "SMPL": Convention(
        LR, "Pelvis Spine1 Spine2 Spine3 Spine4 Neck Head",
        "{}_Collar {}_Shoulder {}_Elbow {}_Wrist {}_Hip {}_Knee {}_Ankle {}_Foot", unit=1.0, leaves=(("Wrist",
        "{}_Hand"),), ends=False),
    "SMPL in FBX": Convention(
        LR, "m_avg_Pelvis m_avg_Spine1 m_avg_Spine2 m_avg_Spine3 m_avg_Spine4 m_avg_Neck m_avg_Head",
        "m_avg_{}_Collar m_avg_{}_Shoulder m_avg_{}_Elbow m_avg_{}_Wrist m_avg_{}_Hip m_avg_{}_Knee m_avg_{}_Ankle "
        "m_avg_{}_Foot",
        leaves=(("Wrist", "m_avg_{}_Hand"),)),
    "SMPL-X": Convention(
        ("left", "right"), "pelvis spine1 spine2 spine3 spine4 neck head",
        "{}_collar {}_shoulder {}_elbow {}_wrist {}_hip {}_knee {}_ankle {}_foot", unit=1.0,
        leaves=(("Wrist", "{}_index1"), ("Wrist", "{}_thumb1"))),
    "VRM": Convention(
        ("left", "right"), "hips spine chest upperChest upperUpperChest neck head",
        "{}Shoulder {}UpperArm {}LowerArm {}Hand {}UpperLeg {}LowerLeg {}Foot {}Toes", unit=1.0, ends=False,
        leaves=(("Wrist", "{}ThumbMetacarpal"), ("Wrist", "{}LittleProximal"))),
    "VRoid": Convention(
        LR, "J_Bip_C_Hips J_Bip_C_Spine J_Bip_C_Chest J_Bip_C_UpperChest J_Bip_C_UpperChest2 J_Bip_C_Neck J_Bip_C_Head",
        "J_Bip_{}_Shoulder J_Bip_{}_UpperArm J_Bip_{}_LowerArm J_Bip_{}_Hand J_Bip_{}_UpperLeg J_Bip_{}_LowerLeg "
        "J_Bip_{}_Foot "
        "J_Bip_{}_ToeBase", unit=1.0, above=("Root",), leaves=(("Collar", "J_Sec_{}_Bust1"),)),
    "Rokoko": Convention(
        WORDS, "Hips Spine1 Spine2 Spine3 Spine4 Neck Head", "{}Shoulder {}Arm {}ForeArm {}Hand {}Thigh {}Shin {}Foot "
        "{}Toe",
        above=("Root",), leaves=(("Toe", "{}ToeTip"), ("Wrist", "{}Finger1Metacarpal"))),
    "Xsens MVN": Convention(
        WORDS, "Hips Chest Chest2 Chest3 Chest4 Neck Head", "{}Collar {}Shoulder {}Elbow {}Wrist {}Hip {}Knee {}Ankle "
        "{}Toe"),
    "Xsens MVN with vertebrae": Convention(
        WORDS, "Pelvis L5 L3 T12 T8 Neck Head", "{}Shoulder {}UpperArm {}ForeArm {}Hand {}UpperLeg {}LowerLeg {}Foot "
        "{}Toe"),
    "Perception Neuron": Convention(
        WORDS, "Hips Spine Spine1 Spine2 Spine3 Neck Head", "{}Shoulder {}Arm {}ForeArm {}Hand {}UpLeg {}Leg {}Foot TOE",
        leaves=(("Wrist", "{}HandThumb1"), ("Wrist", "{}InHandIndex"))),
    "MakeHuman": Convention(
        LR, "root spine05 spine04 spine03 spine01 neck01 head",
        "clavicle.{} upperarm01.{} lowerarm01.{} wrist.{} upperleg01.{} lowerleg01.{} foot.{} toe1-1.{}", unit=0.1, up="z",
        within=(("Hip", "pelvis.{}"), ("Knee", "upperleg02.{}"), ("Ankle", "lowerleg02.{}"), ("Shoulder", "shoulder01.{}"),
                ("Elbow", "upperarm02.{}"), ("Wrist", "lowerarm02.{}"), ("Toe", "metatarsal1.{}")),
        leaves=(("Ankle", "metatarsal2.{}"), ("Wrist", "metacarpal1.{}"), ("Toe", "toe1-2.{}"))),
    "MakeHuman game engine": Convention(
        LOWER, "pelvis spine_01 spine_02 spine_03 spine_04 neck_01 head",
        "clavicle_{} upperarm_{} lowerarm_{} hand_{} thigh_{} calf_{} foot_{} ball_{}", unit=0.1, above=("Root",)),
    "LaFAN1": Convention(
        WORDS, "Hips Spine Spine1 Spine2 Spine3 Neck Head", "{}Shoulder {}Arm {}ForeArm {}Hand {}UpLeg {}Leg {}Foot {}Toe"),
    "Blender Rigify": Convention(
        LR, "DEF-spine DEF-spine.001 DEF-spine.002 DEF-spine.003 DEF-spine.004 DEF-spine.005 DEF-spine.006",
        "DEF-shoulder.{} DEF-upper_arm.{} DEF-forearm.{} DEF-hand.{} DEF-thigh.{} DEF-shin.{} DEF-foot.{} DEF-toe.{}",
        unit=1.0, up="z",
        within=(("Elbow", "DEF-upper_arm.{}.001"), ("Wrist", "DEF-forearm.{}.001"), ("Knee", "DEF-thigh.{}.001"),
                ("Ankle", "DEF-shin.{}.001")), leaves=(("Collar", "DEF-breast.{}"), ("Wrist", "DEF-thumb.01.{}"))),
    "Blender metarig": Convention(
        LR, "spine spine.001 spine.002 spine.003 spine.004 spine.005 spine.006",
        "shoulder.{} upper_arm.{} forearm.{} hand.{} thigh.{} shin.{} foot.{} toe.{}", unit=1.0, up="z",
        leaves=(("Ankle", "heel.02.{}"), ("Wrist", "palm.01.{}"))),
    "Advanced Skeleton": Convention(
        LR, "Root_M Spine1_M Spine2_M Spine3_M Chest_M Neck_M Head_M",
        "Scapula_{} Shoulder_{} Elbow_{} Wrist_{} Hip_{} Knee_{} Ankle_{} Toes_{}"),
    "Kimodo": Convention(
        WORDS, "Hips Spine1 Spine2 Spine3 Chest Neck1 Head", "{}Shoulder {}Arm {}ForeArm {}Hand {}Leg {}Shin {}Foot "
        "{}ToeBase",
        unit=1.0),
    "Second Life": Convention(
        LOWER, "mPelvis mTorso mChest mChest2 mChest3 mNeck mHead",
        "{}Collar {}Shldr {}ForeArm {}Hand {}Thigh {}Shin {}Foot TOE", unit=0.0254),
    "OptiTrack Motive": Convention(
        LR, "Hip Ab Spine2 Spine3 Chest Neck Head", "{}Shoulder {}UArm {}FArm {}Hand {}Thigh {}Shin {}Foot {}Toe"),
    "Auto-Rig Pro": Convention(
        LOWER, "root.x spine_01.x spine_02.x spine_03.x spine_04.x neck.x head.x",
        "shoulder.{} arm_stretch.{} forearm_stretch.{} hand.{} thigh_stretch.{} leg_stretch.{} foot.{} toes_01.{}", unit=1.0,
        leaves=(("Hip", "thigh_twist.{}"), ("Shoulder", "arm_twist.{}"))),
    "3ds Max CAT": Convention(
        LR, "CATRigHub001 CATRigSpine1 CATRigSpine2 CATRigSpine3 CATRigHub002 CATRigNeck CATRigHub003",
        "CATRig{}ArmCollarbone CATRig{}Arm1 CATRig{}Arm2 CATRig{}ArmPalm CATRig{}Leg1 CATRig{}Leg2 CATRig{}LegAnkle "
        "CATRig{}LegDigit11"),
    "Lft and Rgt": Convention(
        ("Lft", "Rgt"), "Pelvis Spine Spine1 Spine2 Spine3 Neck Head",
        "{}Clavicle {}UpperArm {}ForeArm {}Hand {}Thigh {}Calf {}Foot {}Toe"),
    "joint suffix": Convention(
        LOWER, "hips_jnt spine_01_jnt spine_02_jnt spine_03_jnt spine_04_jnt neck_jnt head_jnt",
        "{}_clavicle_jnt {}_shoulder_jnt {}_elbow_jnt {}_wrist_jnt {}_hip_jnt {}_knee_jnt {}_ankle_jnt {}_toe_jnt"),
}


def roles(convention: Convention) -> dict[str, str]:
    """The right roles of a rig: a leg without a toe joint has the End Site of its foot."""
    limbs = dict(zip(LIMBS, _names(convention.limbs), strict=True))
    found = {"hips": _names(convention.body)[0]}
    for side, word in zip(("left", "right"), convention.sides, strict=True):
        for part, joint in PARTS.items():
            missing = limbs[joint].isupper()
            found[f"{side}_{part}"] = limbs["Ankle" if missing else joint].format(word) + ("End" if missing else "")
    return found


def walk(name: str, turned: bool = False, seconds: float = 4.0) -> Clip:
    """A walk of two metres towards +z on a rig, in metres with Y up; ``turned`` gives each joint axes of its own."""
    convention = TABLE[name]
    clip = tk.datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=seconds)[0]
    return _turned(_rig(clip, convention)) if turned else _rig(clip, convention)


def _names(text: str) -> list[str]:
    return text.split(",") if "," in text else text.split()


def _rig(clip: Clip, convention: Convention) -> Clip:
    """The clip with the joints of a convention."""
    old, body, limbs = clip.skeleton, _names(convention.body), dict(zip(LIMBS, _names(convention.limbs), strict=True))
    called = dict(zip(BODY, body, strict=True))
    side_of, part_of = {}, {}
    for word, side in zip(convention.sides, ("Left", "Right"), strict=True):
        for part, pattern in limbs.items():
            side_of[f"{side}{part}"], part_of[f"{side}{part}"] = word, part
            called[f"{side}{part}"] = pattern.format(word)
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
        if joint in old.ends:
            above = old.names[old.parents[j]]
            if not convention.ends or (part_of.get(above) == "Toe" and limbs["Toe"].isupper()):
                continue
            at[j] = add(f"{names[parent]}End", parent, offset, turn, end=True)
            continue
        if part_of.get(joint) == "Toe" and limbs["Toe"].isupper():
            at[j] = add(f"{names[parent]}End", parent, offset, still, end=True)
            continue
        if j == 0 and convention.above:
            turn = still
        for part, pattern in convention.within:
            if part_of.get(joint) == part:
                offset = offset / 2
                parent = add(pattern.format(side_of[joint]), parent, offset, still)
        at[j] = add(called[joint], parent, offset, turn)
        for part, pattern in convention.leaves:
            if part_of.get(joint) == part:
                add(pattern.format(side_of[joint]), at[j], torch.tensor([0.01 if joint[0] == "L" else -0.01, 0.02,
                0.03]), still)
    skeleton = Skeleton(names, parents, torch.stack(offsets), {}, ends)
    return Clip(skeleton, torch.stack(turns, 1), clip.root_positions, clip.fps, "Neutral", "FW")


def _turned(clip: Clip) -> Clip:
    """The same positions with other axes of the joints: the x axis along the bone, and half a turn on the right side."""
    skeleton, axes = clip.skeleton, []
    for j in range(len(skeleton)):
        children = [k for k, p in enumerate(skeleton.parents) if p == j and float(skeleton.offsets[k].norm()) > 0]
        bone = skeleton.offsets[children[0]] if children and j else torch.tensor([0.0, 1.0, 0.0])
        axes.append(R.between(torch.tensor([1.0, 0.0, 0.0]), R.normalize(bone)))
    axes = torch.stack(axes)
    for j, name in enumerate(skeleton.names):
        if tk.motion.joint_names.read(name).side == "right":
            axes[j] = R.multiply(axes[j], R.from_euler(torch.tensor([math.pi, 0.0, 0.0]), "XYZ"))
    turned = R.multiply(clip.global_rotations, axes)
    above = axes[list(skeleton.parents[1:])]
    offsets = torch.cat((skeleton.offsets[:1], R.rotate(R.inverse(above), skeleton.offsets[1:])))
    for j in range(len(skeleton)):
        if skeleton.is_end(j):
            turned[:, j] = turned[:, skeleton.parents[j]]
    made = Skeleton(skeleton.names, skeleton.parents, offsets, {}, skeleton.ends)
    return clip.replace(skeleton=made, rotations=R.unroll(tk.motion.local_rotations(made, turned)))
