"""Motion files of programs that know nothing of the toolkit: what is understood, compared with a
key made by hand.

The key says for each file what a person who looks at its hierarchy and its poses would answer. The
files are not part of the repository; those that a folder lacks are left out.
"""

import math
import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import pandas as pd
import torch
import typer

import toolkit as tk
from experiments.tables import Result, Store
from toolkit.extra.characters.retargeting import report, retarget
from toolkit.extra.formats import recorded_body
from toolkit.motion import root_frames, rotations as R
from toolkit.motion.roles import SIDES, Tree

PEOPLE = (1.3, 2.1)  # metres
WALKS = 0.4  # m/s: faster frames of a walk must face where they go
HIPS, PARTS = "hips", ("shoulder", "elbow", "hand", "hip", "knee", "foot", "toe")


@dataclass(frozen=True)
class Answer:
    """What is right for a file. ``parts`` are the left joints in the order of `PARTS`, with {} for
    the side.
    """

    hips: str = ""
    parts: str = ""
    sides: tuple[str, str] = ("Left", "Right")
    unit: float = math.nan
    up: str = "y"
    verdict: str = "right"  # or "warned", "refused"
    forwards: bool = False  # whether it is a walk or a run forwards

    @property
    def roles(self) -> dict[str, str]:
        """Joint by role."""
        found = {HIPS: self.hips} if self.hips else {}
        for side, word in zip(SIDES, self.sides, strict=True):
            found |= {f"{side}_{part}": name.format(word)
                      for part, name in zip(PARTS, self.parts.split(), strict=False)}
        return found


MIXAMO = "{}Arm {}ForeArm {}Hand {}UpLeg {}Leg {}Foot {}ToeBase"
ELBOWS = "{}Shoulder {}Elbow {}Wrist {}Hip {}Knee {}Ankle "
CM, INCH, CMU = 0.01, 0.0254, 0.05644
KEY = {
    "aitviewer__sample.bvh": Answer("Hips", ELBOWS + "{}Toe", unit=CM),
    "animateddrawings__jesse_dance.bvh": Answer("Hips", MIXAMO, unit=CM),
    "animateddrawings__jumping_jacks.bvh": Answer("Hips", ELBOWS + "{}Toe", unit=CMU),
    "animateddrawings__zombie.bvh": Answer("Hips", MIXAMO, up="z", verdict="warned", forwards=True),
    "anytop__Chicken_Walk.bvh": Answer(verdict="warned"),
    "assimp__01_01.bvh": Answer("Hips", MIXAMO, unit=CMU),
    "assimp__Boxing_Toes.bvh": Answer(verdict="refused"),
    "bvh-python__test_freebvh.bvh": Answer(
        "mixamorig:Hips", MIXAMO.replace("{}", "mixamorig:{}"), unit=CM, forwards=True),
    "bvh-python__test_mocapbank.bvh": Answer("Hips", ELBOWS + "{}AnkleEnd", unit=CM),
    "bvh-toolbox__walk01.bvh": Answer("Hips", MIXAMO.replace("ToeBase", "FootEnd"), unit=CM,
                                      forwards=True),
    "bvhio__example.bvh": Answer("Hips",
                                 "{}UpArm {}LowArm {}Hand {}UpLeg {}LowLeg {}Foot {}FootEnd",
                                 unit=INCH),
    "fairmotion__sinusoidal.bvh": Answer(verdict="warned"),
    "genoview__Geno_stance.bvh": Answer("Hips", MIXAMO, unit=CM),
    "makehuman__tpose.bvh": Answer(
        "root",
        "upperarm01.{} lowerarm01.{} wrist.{} upperleg01.{} lowerleg01.{} foot.{} toe1-1.{}",
        ("L", "R"), 0.1, "z", "warned"),
    "makehuman__walk1.bvh": Answer(
        "Hips", "UpArm_{} LoArm_{} Hand_{} UpLeg_{} LoLeg_{} Foot_{} Toe_{}",
        ("L", "R"), 0.1, "z", "warned"),
    "momask-codes__template.bvh": Answer("Hips", MIXAMO.replace("ToeBase", "Toe"), unit=1.0,
                                         verdict="warned"),
    "most__rest_cmu.bvh": Answer("Hips", MIXAMO, unit=CMU, verdict="warned"),
    "npybvh__example.bvh": Answer("Hips", MIXAMO, unit=CMU, forwards=True),
    "pybvh__bvh_test1.bvh": Answer("Hips", MIXAMO, unit=INCH, up="z"),
    "pybvh__bvh_test2.bvh": Answer("Hips", ELBOWS + "{}Toe", unit=CM),
    "pybvh__bvh_test3.bvh": Answer("Hips", MIXAMO.replace("ToeBase", "ForeFoot"), unit=INCH,
                                   up="z"),
    "pybvh__cmu_12_01_walk.bvh": Answer("Hips", MIXAMO, unit=CMU, forwards=True),
    "pybvh__full_precision_frame_time.bvh": Answer(verdict="warned"),
    "pybvh__rotation_first_root.bvh": Answer(verdict="warned"),
    "pybvh__standard_skeleton.bvh": Answer("Hips", MIXAMO, unit=INCH, up="z", verdict="warned"),
    "pymo__AV_8Walk_Meredith_HVHA_Rep1.bvh": Answer("Hips", MIXAMO, unit=INCH, forwards=True),
    "rpm.glb": Answer("Hips", MIXAMO, unit=1.0),
    "skel.fbx": Answer(verdict="warned"),
    "soma.npz": Answer(verdict="refused"),  # Kimodo's joints and matrices
    "test.vrma": Answer("hips", "{}UpperArm {}LowerArm {}Hand {}UpperLeg {}LowerLeg {}Foot {}Toes",
                        ("left", "right"), 1.0),
    "unihumanoid_headeronly__bvh_cgspeed.bvh": Answer("Hips", MIXAMO, unit=CMU, verdict="warned"),
    "unihumanoid_headeronly__daz_friendry_herarchy.bvh": Answer(
        "hip", "{}Shldr {}ForeArm {}Hand {}Thigh {}Shin {}Foot {}FootEnd", ("l", "r"), CM,
        verdict="warned"),
    "unihumanoid_headeronly__mocapdatacom_hierarchy_2.bvh": Answer("Hips", ELBOWS + "{}AnkleEnd",
                                                                   unit=INCH),
    "video2bvh__cxk.bvh": Answer("Hips", MIXAMO.replace("ToeBase", "Foot"), unit=0.001, up="z"),
}


@dataclass(frozen=True)
class Row:
    """One file: the verdict, what is wrong although nothing was said, and what was found."""

    name: str
    verdict: str  # right, warned, refused
    wrong: list[str]
    found: "tk.extra.formats.inspection.Inspection | None"
    said: str  # the doubts or the error


def judge(path: Path, answer: Answer) -> Row:
    """What `toolkit.inspect` and `toolkit.load` make of a file, compared with the key."""
    try:
        found = tk.inspect(path)
    except ValueError as error:
        return Row(path.name, "refused",
                   [] if "\n" not in str(error) else ["an error of several lines"], None,
                   str(error))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        clip = tk.load(path)
    wrong = [] if bool(caught) == bool(found.doubts) else ["doubts and warnings differ"]
    if answer.roles:
        wrong += [f"{role}: {found.roles.get(role)} instead of {joint}"
                  for role, joint in answer.roles.items()
                  if found.roles.get(role) != joint]
        wrong += _of_people(clip, found, answer)
    return Row(path.name, "warned" if found.doubts else "right", wrong, found,
               "; ".join(found.doubts))


def _of_people(clip: tk.Clip, found, answer: Answer) -> list[str]:
    """What is wrong about a person's clip."""
    points, skeleton = clip.global_positions, clip.skeleton
    tree = Tree(skeleton.parents, skeleton.offsets.norm(dim=-1).tolist())
    head = points[:, recorded_body.head(skeleton.names, tree, skeleton.roles)[-1], 1]
    feet = points[:, [skeleton.role(f"{side}_foot") for side in SIDES], 1].amax(1)
    mirrored = clip.mirrored()
    wrong = {
        f"{found.height:.2f} m tall": not PEOPLE[0] <= found.height <= PEOPLE[1],
        f"unit {found.unit:g}": not math.isnan(answer.unit)
        and abs(found.unit / answer.unit - 1) > 0.01,
        f"up {found.up}": found.up != answer.up,
        "head below feet": float((head > feet).float().mean()) < 0.9,
        "mirrored twice is another motion":
            float((mirrored.mirrored().global_positions - points).norm(dim=-1).max())
            > 1e-3 * found.height,
        "its mirror image faces backwards": answer.forwards and facing(mirrored) < 0.5,
        "walks backwards": answer.forwards and facing(clip) < 0.5,
    }
    return [what for what, so in wrong.items() if so]


def facing(clip: tk.Clip) -> float:
    """Mean cosine between where the hips face and where they go, over the frames that go; NaN if
    none does.
    """
    span = max(1, round(clip.fps / 3))
    hips = clip.global_positions[:, clip.skeleton.role("hips")][:, ::2]
    travel = (hips[span:] - hips[:-span]) * clip.fps / span
    forward = R.rotate(root_frames(clip).rotations, torch.tensor([0.0, 0.0, 1.0]))[:-span, ::2]
    goes = travel.norm(dim=-1) > WALKS
    return float(torch.nn.functional.cosine_similarity(forward, travel, dim=1)[goes].mean())


def line(row: Row) -> dict:
    """What is printed of a file."""
    found, sizes = row.found, ("height", "unit", "up", "fps")
    numbers = {} if found is None else {
        **{name: getattr(found, name) for name in sizes},
        "contact": sum(found.contact.values()) / 2 if found.contact else math.nan}
    return {"file": row.name, "verdict": row.verdict, **numbers,
            "WRONG": "; ".join(row.wrong), "said": row.said}


def run(
    folder: Annotated[Path | None, typer.Option(
        help="Folder of the files; default: foreign/ of the shared data.")] = None,
    store: Store = False,
) -> None:
    """Motion files of other programs: right, refused in a line or warned in a line, compared with a
    key made by hand.
    """
    folder = folder or Path(os.environ.get("TOOLKIT_DATA", "../shared/data")) / "foreign"
    rows = [judge(folder / name, answer) for name, answer in KEY.items()
            if (folder / name).exists()]
    if not rows:
        raise ValueError(f"{folder}: none of the files of the key is there")
    print(pd.DataFrame(map(line, rows)).to_string(index=False, float_format="{:.4g}".format))
    other = [row.name for row in rows if row.verdict != KEY[row.name].verdict]
    counts = {verdict: sum(row.verdict == verdict for row in rows)
              for verdict in ("right", "warned", "refused")}
    silent = [row.name for row in rows if row.wrong and row.verdict == "right"]
    print(f"silently wrong: {', '.join(silent) or 'none'}; other verdict than the key: "
          f"{', '.join(other) or 'none'}")
    people = [row.name for row in rows if row.found is not None and KEY[row.name].roles]
    off = torch.tensor([carried(folder / name) for name in people])
    means, worst = off.T
    columns = {"files": ["files", 0], **{verdict: [verdict, 0] for verdict in counts},
               "wrong": ["silently wrong", 0], "rigs": ["rigs", 0],
               "mean": ["limbs off, °: largest mean", 1], "median": ["median", 1],
               "worst": ["worst frame", 0]}
    found = Result(
        "foreign", "Motion files of other programs, compared with a key made by hand, and a "
        "procedural walk of four seconds on the rigs of those that hold people",
        "python -m experiments foreign --store", columns, [
            {"files": len(rows), **counts, "wrong": len(silent), "rigs": len(people),
             "mean": float(means.max()), "median": float(means.median()),
             "worst": float(worst.max())}])
    found.show(store)


def carried(path: Path) -> tuple[float, float]:
    """Mean and largest angle, degrees, between the limbs of a procedural walk and of the walk on
    the rig of a file.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rig = tk.load(path)
    walk = tk.datasets.load("procedural", styles="Neutral", gaits="FW", seconds=4.0)[0]
    found = report(walk, retarget(walk, rig))
    return found.direction, found.worst
