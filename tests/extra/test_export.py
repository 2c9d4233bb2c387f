"""Out to other programs: every file is read back by a library that is not ours."""

import json
import re
import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from motion_files import glb_parts
from refusal import refusal

import toolkit as tk
from toolkit import registry
from toolkit.datasets.procedural import SKELETON
from toolkit.networks.bank import StyleBank
from toolkit.view.render import mannequin as body

DOCS = Path(__file__).parents[2] / "docs"


def seen_by_vtk(path: Path, second: float) -> np.ndarray:
    """Vertices [V, 3] after VTK applied animation and skin.

    A second time step in one reader loses a primitive.
    """
    import pyvista
    from vtkmodules.util.numpy_support import vtk_to_numpy

    file = pyvista.get_reader(path)
    reader = file.reader
    reader.SetApplyDeformationsToGeometry(True)
    reader.UpdateInformation()
    reader.SetFrameRate(60)
    reader.EnableAnimation(0)
    reader.UpdateInformation()
    reader.UpdateTimeStep(float(np.float32(second)))
    blocks, points = reader.GetOutput().NewIterator(), []  # pyvista's own wrapping takes seconds
    while not blocks.IsDoneWithTraversal():
        points.append(vtk_to_numpy(blocks.GetCurrentDataObject().GetPoints().GetData()))
        blocks.GoToNextItem()
    return np.concatenate(points)


def drawn(clip: tk.Clip, frame: int) -> np.ndarray:
    """Vertices of the toolkit's own skin."""
    return body.build(clip).skin.pose(clip.global_rotations[frame], clip.global_positions[frame])[0]


def test_vtk_sees_the_same_skin_move(tmp_path, zombie):
    path = tmp_path / "zombie.glb"
    tk.extra.engines.gltf.save(zombie, path)
    for frame in (60, len(zombie) - 1):
        assert abs(seen_by_vtk(path, frame / zombie.fps) - drawn(zombie, frame)).max() < 1e-4


def test_gltf_names_the_joints_and_holds_what_moves(tmp_path, zombie):
    rotations = zombie.rotations.clone()
    still = SKELETON.index("LeftToe")
    rotations[:, still] = rotations[:1, still]
    tk.extra.engines.gltf.save(zombie.replace(rotations=rotations), tmp_path / "a.glb")
    made = glb_parts(tmp_path / "a.glb")[0]
    assert [node["name"] for node in made["nodes"][:-1]] == list(SKELETON.names)
    for node in made["nodes"][:-1]:
        assert np.linalg.norm(node["rotation"]) == pytest.approx(1, abs=1e-6)
        assert max(map(abs, node["rotation"])) <= 1
    moved = [(c["target"]["path"], c["target"]["node"]) for c in made["animations"][0]["channels"]]
    turning = {joint for path, joint in moved if path == "rotation"}
    assert SKELETON.index("LeftKnee") in turning
    assert not [j for j in turning if j == still or SKELETON.is_end(j)]
    assert {*moved} - {("rotation", joint) for joint in turning} == {("translation", 0)}
    tk.extra.engines.gltf.save(zombie.cut(0, 1), tmp_path / "still.glb")
    assert "animations" not in glb_parts(tmp_path / "still.glb")[0]


def test_usd_sees_the_same_skin_move(tmp_path, zombie):
    """Pixar's library computes joints and vertices from the file."""
    pytest.importorskip("pxr", reason="needs usd-core")
    from pxr import Usd, UsdGeom, UsdSkel

    path = tmp_path / "a.usdc"
    tk.save(zombie, path)
    stage = Usd.Stage.Open(str(path))
    assert stage.GetTimeCodesPerSecond() == zombie.fps
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1
    root = UsdSkel.Root(stage.GetDefaultPrim())
    rig = UsdSkel.Skeleton.Get(stage, "/Character/Skeleton")
    cache = UsdSkel.Cache()
    cache.Populate(root, Usd.PrimDefaultPredicate)
    query = cache.GetSkelQuery(rig)
    names = [str(joint).split("/")[-1] for joint in query.GetJointOrder()]
    assert names == list(zombie.skeleton.names)
    mesh = UsdGeom.Mesh.Get(stage, "/Character/Mannequin")
    skinning = cache.GetSkinningQuery(mesh.GetPrim())
    for frame in (0, len(zombie) // 3, len(zombie) - 1):
        joints = np.array(query.ComputeJointSkelTransforms(frame))
        assert abs(joints[:, 3, :3] - zombie.global_positions[frame].numpy()).max() < 1e-4
        points = mesh.GetPointsAttr().Get()
        assert skinning.ComputeSkinnedPoints(query.ComputeSkinningTransforms(frame), points, frame)
        assert abs(np.array(points) - drawn(zombie, frame)).max() < 1e-4


def test_amass_poses_are_those_of_the_clip(tmp_path, zombie):
    """Read by numpy and by our own reader, which `test_readers` tries on poses that it packs."""
    path = tmp_path / "a.npz"
    tk.save(zombie, path)
    with np.load(path) as file:
        made = dict(file)
    assert made["poses"].shape == (len(zombie), 156)
    # as AMASS names the body in its SMPL-X files, which tools of robots read
    body = np.concatenate((made["root_orient"], made["pose_body"]), 1)
    assert np.array_equal(body, made["poses"][:, :66])
    assert made["mocap_frame_rate"].item() == 60.0
    assert made["trans"][:, 2].min() > 0.5  # z is up
    assert not made["betas"].any()
    assert (str(made["gender"]), float(made["mocap_framerate"])) == ("neutral", 60.0)
    with pytest.warns(UserWarning, match="bone lengths are those of an average person"):
        again = tk.load(path)
    assert again.fps == 60
    assert tk.metrics.upright(again)
    wanted = tk.motion.retargeting.retarget(zombie, again.skeleton)
    assert abs(again.global_positions - wanted.global_positions).max() < 1e-3
    # the legs of SMPL's mean body, so that its feet stand where these do
    legs = [again.skeleton.role(f"left_{part}") for part in ("knee", "foot")]
    assert float(again.skeleton.offsets[legs].norm(dim=-1).sum()) == pytest.approx(0.77, abs=0.01)


def test_bvh_is_read_the_same_by_pybvh(tmp_path, zombie):
    pybvh = pytest.importorskip("pybvh")
    tk.bvh.save(zombie, tmp_path / "a.bvh")
    theirs = pybvh.read_bvh_file(tmp_path / "a.bvh").node_positions() / 100
    assert abs(theirs - zombie.global_positions.numpy()).max() < 1e-4


@pytest.fixture(scope="module")
def onnxruntime():
    pytest.importorskip("onnxscript")
    return pytest.importorskip("onnxruntime")


def session_of(onnxruntime, path: Path):
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    return onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])


def run(session, x, phases, style) -> torch.Tensor:
    given = {"x": x.numpy(), "phases": phases.numpy(), "style": style.numpy()}
    return torch.from_numpy(session.run(["z"],
                                        {i.name: given[i.name] for i in session.get_inputs()})[0])


@pytest.fixture(scope="module")
def step(onnxruntime, tmp_path_factory) -> Path:
    """The embedded model; exporting takes seconds."""
    path = tmp_path_factory.mktemp("onnx") / "step.onnx"
    model, bank = tk.pretrained()
    tk.extra.engines.onnx.save(model, path, bank)
    return path


def test_onnx_runtime_computes_a_model_with_a_global_phase(onnxruntime, tmp_path):
    torch.manual_seed(3)
    sizes = tk.networks.Sizes(hidden=24, experts=3, gating=8, film_channels=4, film_kernel=3,
                              film_dense=8, rank=5)
    model = tk.networks.build("pfnn-resad", tk.features.Layout(SKELETON), 4, sizes)
    for parameter in model.parameters():
        torch.nn.init.normal_(parameter, std=0.2)
    for kind in ("inputs", "outputs"):
        getattr(model, f"{kind}_mean").normal_()
        getattr(model, f"{kind}_std").uniform_(0.5, 2.0)
    (file,) = tk.extra.engines.onnx.save(model.train(), tmp_path / "a.onnx")
    assert model.training
    model.eval()
    session = session_of(onnxruntime, file)
    assert [(i.name, i.shape) for i in session.get_inputs()] == [
        ("x", ["batch", model.layout.n_inputs]), ("phases", ["batch", 1]),
        ("style", ["styles", model.style_size])]
    x, phases, style = (torch.randn(7, n) for n in (model.layout.n_inputs, model.layout.n_phases,
                                                    model.style_size))
    phases *= 4  # round the circle, of a global one
    right = model.predict(x, phases, style)
    shared = model.predict(x, phases, style[:1].expand(7, -1))
    for styles, wanted in ((style, right), (style[:1], shared)):
        assert (run(session, x, phases, styles) - wanted).abs().max() < 2e-6 * wanted.abs().max()
    # neither one style nor a style for each
    with pytest.raises(Exception, match=r"broadcast|dimension"):
        run(session, x, phases, style[:3])
    data = file.read_bytes()
    assert b"generator" not in data  # style vectors are an input
    assert b".py" not in data  # no path of a source file
    assert json.loads(session.get_modelmeta().custom_metadata_map["model"]) == "pfnn-resad"


def test_onnx_runtime_computes_a_model_of_ones_own(onnxruntime, tmp_path, monkeypatch):
    """One that looks at past frames and knows no phase."""
    monkeypatch.setattr(registry, "_found", {**registry._found})  # other tests list the models
    own = runpy.run_path(str(DOCS.parent / "examples" / "models" / "gru.py"))["Recurrent"]
    monkeypatch.setattr(own, "memory", 1)  # exporting takes a second for each frame
    sizes = tk.networks.Sizes(hidden=16, experts=3, gating=8, dropout=0.0)
    model = tk.networks.build("gru", tk.features.Layout(SKELETON), 2, sizes)
    (file,) = tk.extra.engines.onnx.save(model, tmp_path / "a.onnx")
    x, style = torch.randn(5, 2, model.layout.n_inputs), torch.randn(5, model.style_size)
    given = x, torch.empty(5, 0), style
    assert (run(session_of(onnxruntime, file), *given) - model.predict(*given)).abs().max() < 1e-4


def test_the_example_of_the_docs_runs(step, monkeypatch, capsys):
    (example,) = re.findall(r"```python\n(.*?)```",
                            (DOCS / "export.md").read_text(encoding="utf-8"), re.DOTALL)
    monkeypatch.chdir(step.parent)
    model, bank = tk.pretrained()
    names: dict = {}
    exec(compile(example, "export.md", "exec"), names)
    assert "right foot, left foot stand: [" in capsys.readouterr().out
    state = tk.runtime.start(model, bank.blend({"Zombie": 0.5, "Neutral": 0.5}))
    x, phases, style = (torch.from_numpy(np.asarray(names[n])) for n in ("x", "z", "style"))
    z = model.predict(x[None], state.phase, style)
    assert ((z - phases) / model.outputs_std).square().mean().sqrt() < 1e-5
    assert torch.equal(x[48:], torch.tensor(names["about"]["start"]["joints"]))
    assert names["about"]["joints"] == list(model.layout.names)


def test_the_command_line_writes_a_clip(tmp_path, zombie, command):
    source = tmp_path / "zombie.bvh"
    tk.bvh.save(zombie, source)
    out = tmp_path / "new" / "walk.glb"
    said = command(f"export clip {source} --out {out} --skeleton 100style").out
    assert f"wrote {out}" in said
    tk.save(tk.bvh.load(source), tmp_path / "walk.glb")
    assert out.read_bytes() == (tmp_path / "walk.glb").read_bytes()


def test_skeletons_that_no_body_fits_are_refused(tmp_path):
    dot = tk.Skeleton(("Root", "RootEnd"), (-1, 0), torch.zeros(2, 3))
    clip = tk.Clip(dot, tk.motion.rotations.identity(3, 2), torch.zeros(3, 3), 60.0, name="dot.bvh")
    with refusal(r"dot\.bvh: no bone is long enough"):
        tk.extra.engines.gltf.save(clip, tmp_path / "dot.glb")
    flat = replace(SKELETON, offsets=0.01 * SKELETON.offsets)
    with refusal("legs have no length"):
        tk.motion.retargeting.retarget(tk.Clip(flat, tk.motion.rotations.identity(3, 28),
                                               torch.zeros(3, 3), 60.0), SKELETON)
    assert not list(tmp_path.iterdir())


def test_a_bank_of_another_model_is_refused(tmp_path):
    bank = StyleBank(("a",), torch.zeros(1, 3))
    with refusal(r"takes style vectors \[1024\], the bank has \[3\]"):
        tk.extra.engines.onnx.save(tk.pretrained().model, tmp_path / "a.onnx", bank)
    assert not list(tmp_path.iterdir())
