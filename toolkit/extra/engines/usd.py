"""OpenUSD: a clip as a skinned mannequin with its animation (.usdc), by Pixar's own library."""

import tempfile
from pathlib import Path

import numpy as np
from pxr import Gf, Tf, Usd, UsdGeom, UsdSkel, Vt

from toolkit.extra.formats.nodes import unique
from toolkit.io.files import write_whole
from toolkit.motion import Clip, rotations as R


def write(clip: Clip, path: Path, *, character, **_) -> None:
    """Write a UsdSkel root with skeleton, animation and mesh; metres, y up, a time code a frame.

    A ``character`` lends the clip its rig; the mesh is the mannequin's.
    """
    from toolkit.view.render import mannequin  # imported on demand: it needs the drawing libraries

    clip = (clip if character is None else character.fitted(clip)).to("cpu")
    skeleton, figure = clip.skeleton, mannequin.build(clip)
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetTimeCodesPerSecond(clip.fps)
    stage.SetFramesPerSecond(clip.fps)
    stage.SetEndTimeCode(len(clip) - 1)
    root = UsdSkel.Root.Define(stage, "/Character")
    stage.SetDefaultPrim(root.GetPrim())

    # A joint's name is its path
    joints: list[str] = []
    names = unique([Tf.MakeValidIdentifier(name) for name in skeleton.names])
    for name, parent in zip(names, skeleton.parents, strict=True):
        joints.append(name if parent < 0 else f"{joints[parent]}/{name}")
    bind, rest = np.tile(np.eye(4), (2, len(skeleton), 1, 1))
    bind[:, :3], rest[:, :3, 3] = figure.skin.inverse, skeleton.offsets
    rig = UsdSkel.Skeleton.Define(stage, "/Character/Skeleton")
    rig.CreateJointsAttr(joints)
    rig.CreateBindTransformsAttr(_matrices(np.linalg.inv(bind)))
    rig.CreateRestTransformsAttr(_matrices(rest))

    motion = UsdSkel.Animation.Define(stage, "/Character/Animation")
    motion.CreateJointsAttr(joints)
    motion.CreateScalesAttr(Vt.Vec3hArray(len(skeleton), Gf.Vec3h(1)))
    turns, places = motion.CreateRotationsAttr(), motion.CreateTranslationsAttr()
    offsets = skeleton.offsets.numpy().copy()
    rotations = R.normalize(R.unroll(clip.rotations).double()).tolist()
    for frame, (turned, place) in enumerate(zip(rotations, clip.root_positions, strict=True)):
        offsets[0] = place
        turns.Set(Vt.QuatfArray([Gf.Quatf(*quaternion) for quaternion in turned]), frame)
        places.Set(Vt.Vec3fArray.FromNumpy(offsets), frame)
    UsdSkel.BindingAPI.Apply(rig.GetPrim()).CreateAnimationSourceRel().SetTargets(
        [motion.GetPath()])

    skin, mesh = figure.skin, UsdGeom.Mesh.Define(stage, "/Character/Mannequin")
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(skin.points))
    mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(skin.normals))
    mesh.CreateFaceVertexCountsAttr([3] * len(skin.triangles))
    mesh.CreateFaceVertexIndicesAttr(skin.triangles.ravel().tolist())
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    colors = mesh.CreateDisplayColorPrimvar(UsdGeom.Tokens.vertex)
    colors.Set(Vt.Vec3fArray.FromNumpy((figure.colors() ** 2.2).astype(np.float32)))
    bound = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    bound.CreateSkeletonRel().SetTargets([rig.GetPath()])
    bound.CreateGeomBindTransformAttr(Gf.Matrix4d(1))
    slots = skin.joints.shape[1]
    bound.CreateJointIndicesPrimvar(False, slots).Set(skin.joints.ravel().tolist())
    bound.CreateJointWeightsPrimvar(False, slots).Set(skin.weights.ravel().tolist())

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "made.usdc"
        stage.GetRootLayer().Export(str(file))
        write_whole(path, file.read_bytes())


def _matrices(columns: np.ndarray) -> Vt.Matrix4dArray:
    """Matrices ``[J, 4, 4]`` as USD multiplies them: a row on their left."""
    return Vt.Matrix4dArray.FromNumpy(np.ascontiguousarray(columns.swapaxes(1, 2)))
