import base64
import re
from itertools import pairwise

import numpy as np
import pytest
import torch
from PIL import Image
from refusal import refusal
from scipy.spatial import cKDTree

from toolkit import view
from toolkit.motion import Clip, Skeleton, rotations as R
from toolkit.view.pages import page
from toolkit.view.render import mannequin as body, picture, stage


@pytest.fixture(scope="module")
def clip(walk_clip) -> Clip:
    return walk_clip.cut(0, 60)


# the body


def drawn(
    clip: Clip, frame: int = 0, mannequin: body.Mannequin | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and normals [V, 3] of a frame."""
    skin = (mannequin or body.build(clip)).skin
    return skin.pose(clip.global_rotations[frame], clip.global_positions[frame])


def bent(clip: Clip, **degrees: float) -> Clip:
    """One frame at rest, but for joints that turn about the sideways axis."""
    q = R.identity(1, len(clip.skeleton))
    for name, angle in degrees.items():
        q[:, clip.skeleton.index(name)] = R.from_axis_angle(
            torch.tensor([1.0, 0.0, 0.0]), torch.tensor(np.radians(angle))
        )
    return clip.cut(0, 1).replace(rotations=q.float())


def test_the_body_does_not_depend_on_the_rigs_local_axes(clip):
    # X -> y -> z -> x.
    q = R.from_axis_angle(R.normalize(torch.tensor([1.0, 1.0, 1.0])), torch.tensor(2 * np.pi / 3))
    old, above = clip.skeleton, clip.rotations.clone()
    above[:, 1:] = R.multiply(R.inverse(q), above[:, 1:])
    skeleton = Skeleton(old.names, old.parents, R.rotate(R.inverse(q), old.offsets))
    other = clip.replace(skeleton=skeleton, rotations=R.multiply(above, q))
    torch.testing.assert_close(other.global_positions, clip.global_positions, atol=1e-5, rtol=0)
    mine, theirs = (drawn(c, 7)[0] for c in (clip, other))
    assert body._Places(clip).rest
    assert not body._Places(other).rest
    far = cKDTree(mine).query(theirs)[0]
    assert np.quantile(far, 0.99) < 0.03  # the axes of one are measured, those of the other known
    assert np.median(far) < 0.008


def test_the_body_is_symmetric_and_stands_on_the_floor(clip):
    mannequin = body.build(clip)
    np.testing.assert_allclose(mannequin.tones.sum(1), 1, atol=1e-6)
    assert (mannequin.feet > 0.5).sum(0).min() > 50
    rest = bent(clip).replace(root_positions=torch.tensor([[0.0, 0.98, 0.0]]))  # toes at 0
    points, _ = drawn(rest, 0, mannequin)
    assert -0.03 < points[:, 1].min() < 0.03
    tree = cKDTree(points)
    assert np.quantile(tree.query(points * [-1, 1, 1])[0], 0.99) < 0.02
    assert 0.6 < mannequin.light.min() < 0.9 < np.median(mannequin.light) <= 1


def test_skin_is_the_sum_of_what_each_joint_does(clip):
    """Against a loop over vertices and their joints."""
    pose, skin = bent(clip, LeftKnee=70, RightElbow=-80, Chest=30, Neck=-20), body.build(clip).skin
    points, normals = drawn(pose, 0, body.build(clip))
    turn, where = (
        R.to_matrix(pose.global_rotations[0]).double().numpy(),
        pose.global_positions[0].double().numpy()
    )
    assert (skin.weights >= 0).all()
    np.testing.assert_allclose(skin.weights.sum(1), 1, atol=1e-6)
    for v in range(0, len(points), 37):
        expected = sum(
            w
            * (
                turn[j] @ (skin.inverse[j, :, :3] @ skin.points[v] + skin.inverse[j, :, 3])
                + where[j]
            )
            for w, j in zip(skin.weights[v], skin.joints[v], strict=True)
        )
        np.testing.assert_allclose(points[v], expected, atol=1e-5)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)


def test_any_tree_gets_a_body():
    skeleton = Skeleton(
        ("a", "b", "c"), (-1, 0, 1), torch.tensor([[0.0, 0, 0], [0, 0.5, 0], [0.2, 0, 0]])
    )
    tree = Clip(skeleton, R.identity(4, 3), torch.zeros(4, 3), 30.0)
    assert len(np.unique(body.build(tree).skin.joints[:, 0])) == 2
    assert view.strip(tree, frames=2, dpi=40) is not None
    point = Skeleton(("a",), (-1,), torch.zeros(1, 3))
    with refusal("no bone is long enough"):
        body.build(Clip(point, R.identity(2, 1), torch.zeros(2, 3), 30.0))


# the web page


def test_page_is_one_file_that_loads_nothing(clip, tmp_path):
    weights = {
        "Zombie": np.linspace(1, 0, 60), "Old": np.linspace(0, 1, 60), "Neutral": np.zeros(60)
    }
    path = view.html(clip, tmp_path / "walk.html", title="A walk", contacts=torch.ones(60, 2),
                     styles=weights)
    text = path.read_text(encoding="utf-8")
    assert [p.name for p in tmp_path.iterdir()] == ["walk.html"]
    assert "MIT License" in text
    assert "default-src 'none'" in text
    assert set(re.findall(r"https?://[\w./-]+", text)) <= {
        "http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"
    }


def test_page_keeps_the_motion_within_half_a_millimetre(clip):
    _, _, (packed,) = page.pack(clip, ["walk"], None, None, None)
    rotations = R.identity(60, len(clip.skeleton))
    values = np.frombuffer(base64.b64decode(packed["rotations"]), np.int16).reshape(60, -1, 4)
    rotations[:, packed["joints"]] = R.normalize(torch.from_numpy(values / page.UNIT).float())
    root = torch.from_numpy(
        np.frombuffer(base64.b64decode(packed["root"]), np.float32).reshape(-1, 3).copy()
    )
    unpacked = clip.replace(rotations=rotations, root_positions=root)
    error = (unpacked.global_positions - clip.global_positions).norm(dim=-1).max()
    assert float(error) < 0.0005
    assert [packed["frames"], packed["fps"], packed["label"]] == [60, 60.0, "walk"]


def test_what_does_not_fit_a_page_or_a_film_is_refused(clip, tmp_path):
    for clips, given, said in (
        (clip, {"contacts": torch.ones(59, 2)}, r"must be \[F, 2\] for each clip of \[60\] frames"),
        (clip, {"styles": {"Old": np.ones(3)}}, "style weights must be"),
        ([], {}, "got 0 clips, 0 labels"),
        ([clip] * 10, {}, "1 to 9 clips with a style mapping each; got 10 clips"),
    ):
        with refusal(said):
            view.html(clips, tmp_path / "x.html", title="x", **given)
    with refusal(r"is a \.gif, .* or \.mp4 file; got walk\.avi"):
        view.animate(clip, tmp_path / "walk.avi")
    assert not list(tmp_path.iterdir())


# the strip


@pytest.fixture(params=["pyvista", "pillow"])
def drawer(request, monkeypatch):
    if request.param == "pillow":
        monkeypatch.setattr(stage, "opengl_works", lambda: False)
    elif not stage.opengl_works():
        pytest.skip("pyvista finds no OpenGL here")


def tone(picture: np.ndarray, name: str) -> np.ndarray:
    """Where a picture has clearly the hue of a side, or of a foot that stands."""
    r, g, b = np.moveaxis(picture.astype(int), -1, 0)
    return {"right": r - b > 40, "left": b - r > 40, "stands": (g - r > 60) & (g - b > 40)}[name]


def test_strip_draws_every_clip(drawer, clip, tmp_path):
    path = tmp_path / "strip.png"
    figure = view.strip([clip, clip.replace(style="Zombie")], path, frames=3, width=5, dpi=60,
                        contacts=[None, torch.ones(60, 2)])
    assert [axes.texts[0].get_text() for axes in figure.axes] == ["Neutral FW", "Zombie FW"]
    drawn = np.asarray(Image.open(path).convert("RGB"))
    assert drawn.shape[1] == 300
    half = len(drawn) // 2
    for row in (drawn[:half], drawn[half:]):
        for column in range(3):
            cell = row[:, 100 * column : 100 * (column + 1)]
            assert all(tone(cell, side).mean() > 0.004 for side in ("left", "right"))
        # From the right, the right side hides the left one.
        assert tone(row, "right").sum() > 0.9 * tone(row, "left").sum()
    assert tone(drawn[half:], "stands").sum() > 20
    assert tone(drawn[:half], "stands").sum() == 0


def test_a_stage_shows_points_where_its_camera_sees_them(drawer, clip):
    """The middle of all coloured pixels is near the middle of the joints, for any camera."""
    for azimuth, tilt, x in ((1.0, 0.5, 0.4), (-2.0, 0.9, -0.4)):
        body = stage.Body(clip)
        shown = stage.open_stage([body], (200, 160), np.array([0.0, 1.0, 0.0]))
        target = np.array([x, 0.8, 0.3])
        camera = stage.Camera(target, azimuth, tilt, 4.0)
        picture = shown.draw([stage.Pose(body, 10)], camera)
        shown.close()
        rows, columns = np.nonzero(tone(picture, "left") | tone(picture, "right"))
        seen = np.array([(columns.min() + columns.max()) / 2, (rows.min() + rows.max()) / 2])
        turn = stage.axes(azimuth, tilt)
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-9)
        towards = [np.sin(azimuth) * np.cos(tilt), np.sin(tilt), np.cos(azimuth) * np.cos(tilt)]
        np.testing.assert_allclose(turn[2], towards, atol=1e-9)
        sides = [j for j, name in enumerate(clip.skeleton.names) if name.startswith(("L", "R"))]
        joints = (clip.global_positions[10, sides].double().numpy() - target) @ turn.T * 40
        middle = (joints.min(0) + joints.max(0))[:2] / 2
        np.testing.assert_allclose(seen, [100 + middle[0], 80 - middle[1]], atol=7)


def test_poses_of_a_strip_show_different_parts_of_a_stride(walk_clip, clip):
    """A stride is 60 frames; at equal times, all poses of six seconds would be alike."""
    again = 100 + torch.arange(361) % 60
    rotations, roots = walk_clip.rotations[again], walk_clip.root_positions[again]
    at = picture.instants(clip.replace(rotations=rotations, root_positions=roots), 7)
    phases = np.sort(at % 60)
    assert (np.diff(at) > 30).all()
    np.testing.assert_allclose(np.diff(phases), 60 / 7, atol=2)
    still = clip.replace(rotations=clip.rotations[:1].expand(60, -1, -1))
    assert picture.instants(still, 3).tolist() == [0, 30, 59]
    with refusal("needs frames, got 0"):
        view.strip(clip, frames=0)


# moving pictures


def test_an_animation_plays_at_the_clips_speed(clip, tmp_path):
    path = view.animate([clip, clip.cut(0, 30)], tmp_path / "walk.webp", height=60, fps=10)
    with Image.open(path) as picture:
        assert picture.n_frames == 10
        frames = []
        for k in range(10):
            picture.seek(k)
            frames.append(np.asarray(picture.convert("RGB")).astype(int))
            assert picture.info["duration"] == 100
    assert all((np.abs(a - b).max(-1) > 40).mean() > 0.002 for a, b in pairwise(frames))
    # The shorter clip starts again, the other does not.
    again = np.abs(frames[0] - frames[5]).max(-1) > 40
    half = again.shape[1] // 2
    assert again[:, half:].mean() < 0.2 * again[:, :half].mean()


def test_a_film_is_one_that_browsers_play(clip, tmp_path):
    av = pytest.importorskip("av", reason="films need PyAV: pip install av")
    clip = clip.cut(0, 30)
    path = view.animate(clip, tmp_path / "walk.mp4", height=141, fps=30, labels=[""])
    view.animate(clip, tmp_path / "walk.png", height=141, fps=30, labels=[""])
    with av.open(str(path)) as film, Image.open(tmp_path / "walk.png") as picture:
        stream = film.streams.video[0]
        assert (stream.codec_context.name, stream.codec_context.pix_fmt, stream.average_rate) == (
            "h264", "yuv420p", 30
        )
        assert (stream.width, stream.height) == (picture.width // 2 * 2, 140)
        frames = [frame.to_ndarray(format="rgb24").astype(int) for frame in film.decode(stream)]
        assert len(frames) == picture.n_frames == 15
        for k in (0, 14):
            picture.seek(k)
            wanted = np.asarray(picture.convert("RGB")).astype(int)[:140, : stream.width]
            errors = [np.abs(frame - wanted).mean() for frame in frames]
            assert errors[k] == min(errors) < 5
