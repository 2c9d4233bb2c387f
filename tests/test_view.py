import gc
import re
import subprocess
import sys
import weakref
from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from PIL import Image

from toolkit import view
from toolkit.motion import Clip, Skeleton
from toolkit.motion import rotations as R
from toolkit.view import body, page, skin
from toolkit.view.raycast import Canvas

SPINE = [("Hips", -1, (0, 0.95, 0)), ("Chest", 0, (0, 0.2, 0)), ("Neck", 1, (0, 0.25, 0)), ("Head", 2, (0, 0.1, 0)),
         ("HeadEnd", 3, (0, 0.17, 0))]
ARM = [("Collar", 1, (0.03, 0.2, 0)), ("Shoulder", 0, (0.15, 0, 0)), ("Elbow", 1, (0.3, 0, 0)), ("Wrist", 2, (0.25, 0, 0))]
LEG = [("Hip", 0, (0.1, 0, 0)), ("Knee", 0, (0, -0.43, 0)), ("Ankle", 1, (0, -0.43, 0)), ("Toe", 2, (0, -0.07, 0.15))]


def humanoid() -> Skeleton:
    names, parents, offsets = (list(x) for x in zip(*SPINE, strict=True))
    for side, sign in (("Left", 1), ("Right", -1)):
        for limb in (ARM, LEG):
            first = len(names)
            for i, (name, parent, (x, y, z)) in enumerate(limb):
                names.append(side + name)
                parents.append(parent if i == 0 else first + parent)
                offsets.append((sign * x, y, z))
    return Skeleton(tuple(names), tuple(parents), torch.tensor(offsets))


def walk(frames: int = 60, fps: float = 60.0, style: str = "Neutral", turned: torch.Tensor | None = None) -> Clip:
    """Swinging limbs over a straight path; ``turned`` gives every joint other local axes without changing the motion."""
    skeleton = humanoid()
    t = torch.arange(frames) / fps
    q = R.identity(frames, len(skeleton))
    for name, sign in (("LeftHip", 1), ("RightHip", -1), ("LeftShoulder", -1), ("RightShoulder", 1)):
        q[:, skeleton.index(name)] = R.from_axis_angle(torch.tensor([1.0, 0, 0]), sign * 0.5 * torch.sin(2 * np.pi * t))
    positions = torch.stack((0 * t, 0.94 + 0.02 * torch.cos(4 * np.pi * t), 1.2 * t), -1)
    if turned is not None:
        above = q.clone()
        above[:, 1:] = R.multiply(R.inverse(turned), above[:, 1:])
        q = R.multiply(above, turned)
        offsets = R.rotate(R.inverse(turned), skeleton.offsets)
        skeleton = Skeleton(skeleton.names, skeleton.parents, offsets)
    return Clip(skeleton, q, positions, fps, style, "FW")


@pytest.fixture(scope="module")
def clip() -> Clip:
    return walk()


def test_importing_the_package_loads_no_drawing_library():
    code = ("import sys, toolkit, toolkit.view; "
            "print({'pyvista', 'vtkmodules', 'plotly', 'ipywidgets', 'matplotlib'} & set(sys.modules))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


def test_names_of_the_view_are_listed():
    assert {"html", "animate"} <= set(dir(view)) == set(view.__all__)
    for name in view.__all__:
        assert getattr(view, name).__name__ in (name, f"toolkit.view.{name}")
    with pytest.raises(AttributeError, match="nothing"):
        view.nothing  # noqa: B018


# the body


def test_the_body_does_not_depend_on_the_rigs_local_axes(clip):
    q = R.from_axis_angle(R.normalize(torch.tensor([1.0, 1.0, 1.0])), torch.tensor(2 * np.pi / 3))  # x -> y -> z -> x
    other = walk(turned=q)
    torch.testing.assert_close(other.global_positions, clip.global_positions, atol=1e-5, rtol=0)
    mine, theirs = (body.placements(body.build(c), c.global_rotations, c.global_positions) for c in (clip, other))
    centres = mine[..., 3] - theirs[..., 3]
    assert np.abs(centres).max() < 0.02


def test_the_body_is_symmetric_and_stands_on_the_floor(clip):
    shapes = body.build(clip)
    assert len({s.tone for s in shapes}) == 5
    assert {s.foot for s in shapes} == {"", "left", "right"}
    places = body.placements(shapes, clip.global_rotations, clip.global_positions)
    lows = [(place[:, :, :3] @ skin.surface(s)[0].T + place[:, :, 3:])[:, 1].min()
            for s, place in zip(shapes, places.transpose(1, 0, 2, 3), strict=True)]
    assert -0.06 < min(lows) < 0.06
    sides = [sum(s.radii[0] for s in shapes if s.tone == side) for side in ("left", "right")]
    assert sides[0] == pytest.approx(sides[1])


def bent(clip: Clip, **degrees: float) -> Clip:
    """One frame at rest, but for joints that turn about the sideways axis."""
    q = R.identity(1, len(clip.skeleton))
    for name, angle in degrees.items():
        q[:, clip.skeleton.index(name)] = R.from_axis_angle(torch.tensor([1.0, 0.0, 0.0]), torch.tensor(np.radians(angle)))
    return clip.cut(0, 1).replace(rotations=q.float())


def posed(clip: Clip, shapes=None) -> tuple[skin.Skin, np.ndarray, np.ndarray]:
    shapes = body.build(clip) if shapes is None else shapes
    surface = skin.Skin(shapes, 12, 3)
    return surface, *surface.pose(skin.placements(shapes, clip.global_rotations[0], clip.global_positions[0]))


def test_skin_is_the_sum_of_what_each_joint_does(clip):
    """Against a loop over vertices and their joints."""
    pose = bent(clip, LeftKnee=70, RightElbow=-80, Chest=30, Neck=-20)
    shapes = body.build(clip)
    _, points, normals = posed(pose, shapes)
    turn, where = R.to_matrix(pose.global_rotations[0]).double().numpy(), pose.global_positions[0].double().numpy()
    expected = []
    for shape in shapes:
        for v in skin.surface(shape, 12, 3)[0]:
            shares = skin.weights(shape, v[None, 1])[0]
            assert (shares >= 0).all()
            assert shares.sum() == pytest.approx(1)
            hosts = [(shape.joint, shape.place), *((b.joint, b.place) for b in shape.bends)]
            expected.append(sum(w * (turn[j] @ (place[:, :3] @ v + place[:, 3]) + where[j])
                                for w, (j, place) in zip(shares, hosts, strict=False)))
    np.testing.assert_allclose(points, expected, atol=1e-5)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
    assert sum(len(shape.bends) for shape in shapes) >= 12


def test_straight_limbs_are_the_exact_cones(clip):
    """At rest all joints of a vertex agree, so that skinning changes nothing, and normals look outwards."""
    rest = bent(clip)
    shapes = body.build(clip)
    surface, points, normals = posed(rest, shapes)
    places = body.placements(shapes, rest.global_rotations, rest.global_positions)[0]
    rigid = np.concatenate([skin.surface(s, 12, 3)[0] @ p[:, :3].T + p[:, 3] for s, p in zip(shapes, places, strict=True)])
    limbs = np.isin(surface.owners, [i for i, s in enumerate(shapes) if s.tone in ("left", "right")])
    np.testing.assert_allclose(points[limbs], rigid[limbs], atol=2e-4)
    a, b, c = points[surface.triangles].transpose(1, 0, 2)
    area = np.cross(b - a, c - a)
    facing = np.einsum("ti,ti->t", area, normals[surface.triangles].mean(1))
    assert (facing >= -0.05 * np.linalg.norm(area, axis=1)).all()


def test_a_bent_knee_stays_one_surface(clip):
    """Thigh and shin meet in the knee however it bends: their ends keep to each other, and a shin that is rigid does not."""
    shapes = body.build(clip)
    thigh, shin = (next(i for i, s in enumerate(shapes) if s.joint == clip.skeleton.index(name) and s.bends)
                   for name in ("LeftHip", "LeftKnee"))
    pose = bent(clip, LeftKnee=90)
    knee = pose.global_positions[0, clip.skeleton.index("LeftKnee")].numpy()
    surface, points, _ = posed(pose, shapes)
    near = [points[surface.owners == i] for i in (thigh, shin)]
    near = [p[np.linalg.norm(p - knee, axis=1) < 0.12] for p in near]
    gap = np.linalg.norm(near[0][:, None] - near[1], axis=-1).min(1)
    assert min(len(p) for p in near) > 24
    assert gap.max() < 0.06
    stiff = [replace(s, bends=()) for s in shapes]
    _, rigid, _ = posed(pose, stiff)
    moved = np.linalg.norm(points - rigid, axis=1)
    assert moved[surface.owners == thigh].max() > 0.02  # the end of the thigh goes along
    assert moved[np.isin(surface.owners, [i for i, s in enumerate(shapes) if not s.bends])].max() == 0


def test_a_body_is_built_once_and_keeps_no_clip_alive(clip):
    drawn = clip.cut(0, 30)
    assert body.build(drawn) is body.build(drawn)
    seen = weakref.ref(drawn)
    del drawn
    gc.collect()
    assert seen() is None


def test_any_tree_gets_a_body():
    skeleton = Skeleton(("a", "b", "c"), (-1, 0, 1), torch.tensor([[0.0, 0, 0], [0, 0.5, 0], [0.2, 0, 0]]))
    tree = Clip(skeleton, R.identity(4, 3), torch.zeros(4, 3), 30.0)
    assert len(body.build(tree)) == 2
    assert view.strip(tree, frames=2, dpi=40) is not None


def test_surface_is_closed_and_faces_outwards():
    shape = body.cone(0, torch.zeros(3), torch.tensor([0.0, 0.3, 0.0]), (0.1, 0.05), "left")
    vertices, normals, triangles = skin.surface(shape, around=24, along=8)
    a, b, c = vertices[triangles].transpose(1, 0, 2)
    volume = np.einsum("ti,ti->t", a, np.cross(b, c)).sum() / 6
    assert 0.0055 < volume < 0.0080  # a frustum with two half balls holds 0.0078 m3
    assert (np.einsum("ti,ti->t", np.cross(b - a, c - a), normals[triangles].mean(1)) > -1e-9).all()


def test_the_body_follows_a_bent_spine(clip):
    """What is fixed to a trunk joint does not change when the trunk bends, however far."""
    q = clip.rotations.clone()
    q[:, clip.skeleton.index("Chest")] = R.from_axis_angle(torch.tensor([1.0, 0.0, 0.0]), torch.tensor(1.3))
    upright, bent = (body.build(c) for c in (clip, clip.replace(rotations=q)))
    trunk = {clip.skeleton.index(name) for name in ("Hips", "Chest", "Neck", "Head")}
    pairs = [(a, b) for a, b in zip(upright, bent, strict=True) if a.joint in trunk]
    assert len(pairs) > 5
    for a, b in pairs:
        np.testing.assert_allclose(a.place, b.place, atol=1e-4)


@pytest.mark.parametrize("seed", range(6))
def test_software_renderer_agrees_with_a_row_of_balls(seed):
    """A rounded cone is the union of the balls between its ends; the thinned one is that, pressed flat."""
    rng = np.random.default_rng(seed)
    start, end, thin = torch.from_numpy(rng.uniform(-0.25, 0.25, (3, 3))).float()
    radii, by = tuple(rng.uniform(0.02, 0.12, 2)), 1.0 if seed % 2 else 0.5
    shape = body.cone(0, start, end, radii, "left", thin=thin, by=by)
    canvas = Canvas((-0.5, 0.5, -0.5, 0.5), 60)
    canvas.draw([shape], shape.place[None], np.ones((1, 3)))
    h = np.linspace(0, 1, 3000)[:, None]
    r = radii[0] + h * (radii[1] - radii[0])
    back = np.linalg.inv(shape.place[:, :3])
    expected = np.full_like(canvas.depth, -1e9)
    for i, y in enumerate(canvas.y):
        for k, x in enumerate(canvas.x):  # the line of sight a + z·d in the cone's frame, against each ball
            a, d = back @ (np.array([x, y, 0.0]) - shape.place[:, 3]), back[:, 2]
            away = a - np.array([0.0, shape.length, 0.0]) * h
            half, rest = away @ d, (away**2).sum(1) - r[:, 0] ** 2
            root = half**2 - (d @ d) * rest
            if (root >= 0).any():
                expected[i, k] = ((np.sqrt(root[root >= 0]) - half[root >= 0]) / (d @ d)).max()
    seen, wanted = canvas.depth > -1e8, expected > -1e8
    assert wanted.sum() > 50
    assert (seen != wanted).sum() <= 2
    both = seen & wanted
    error = np.abs(canvas.depth - expected)[both]
    assert np.quantile(error, 0.98) < 1e-4
    assert error.max() < 0.01


# the web page


def test_page_is_one_file_that_loads_nothing(clip, tmp_path):
    weights = {"Zombie": np.linspace(1, 0, 60), "Old": np.linspace(0, 1, 60), "Neutral": np.zeros(60)}
    path = view.html(
        clip, tmp_path / "walk.html", title="A <walk>", caption="& more", contacts=torch.ones(60, 2), styles=weights
    )
    text = path.read_text(encoding="utf-8")
    assert [p.name for p in tmp_path.iterdir()] == ["walk.html"]
    assert "A &lt;walk&gt;" in text
    assert "&amp; more" in text
    assert "MIT License" in text
    assert "default-src 'none'" in text
    assert not re.search(r"""(?:src|href)\s*=\s*["']?\s*(?:https?:)?//|url\(\s*["']?https?:|@import|fetch\(["']http""", text)
    assert set(re.findall(r"https?://[\w./-]+", text)) <= {"http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"}
    assert text.count("<script") == text.count("</script>") == 4


def test_page_keeps_the_motion_within_half_a_millimetre(clip):
    packed = page.pack(clip, "walk")
    error = (page.unpack(packed, clip).global_positions - clip.global_positions).norm(dim=-1).max()
    assert float(error) < 0.0005
    assert [packed["frames"], packed["fps"], packed["label"]] == [60, 60.0, "walk"]


def test_a_minute_stays_small(clip, tmp_path):
    minute = clip.replace(rotations=clip.rotations.repeat(60, 1, 1), root_positions=clip.root_positions.repeat(60, 1))
    size = view.html(minute, tmp_path / "minute.html", title="A minute").stat().st_size
    assert size - view.html(clip.cut(0, 1), tmp_path / "frame.html", title="A frame").stat().st_size < 2_000_000


def test_page_refuses_what_does_not_fit(clip, tmp_path):
    with pytest.raises(ValueError, match=r"contacts must be \[F, 2\] for each clip of \[60\] frames"):
        view.html(clip, tmp_path / "x.html", title="x", contacts=torch.ones(59, 2))
    with pytest.raises(ValueError, match="style weights must be"):
        view.html(clip, tmp_path / "x.html", title="x", styles={"Old": np.ones(3)})
    with pytest.raises(ValueError, match="got 0 clips, 0 labels"):
        view.html([], tmp_path / "x.html", title="x")
    with pytest.raises(ValueError, match="1 to 9 clips with a style mapping each; got 10 clips"):
        view.html([clip] * 10, tmp_path / "x.html", title="x")
    assert not list(tmp_path.iterdir())


# the strip


def test_strip_draws_every_clip(clip, tmp_path):
    path = tmp_path / "strip.png"
    figure = view.strip(
        [clip, walk(style="Zombie")], path, frames=3, width=5, dpi=60, title="Two", contacts=[None, torch.ones(60, 2)]
    )
    assert [axes.texts[0].get_text() for axes in figure.axes] == ["Neutral FW", "Zombie FW"]
    picture = np.asarray(Image.open(path).convert("RGB")).astype(int)
    assert picture.shape[1] == 300
    for tone in ("left", "right"):
        r, g, b = (int(body.COLORS[tone][i : i + 2], 16) for i in (1, 3, 5))
        hue = picture[..., 0] - picture[..., 2] > 40 if r > b else picture[..., 2] - picture[..., 0] > 40
        assert hue.mean() > 0.005, (tone, r, g, b)


def test_contacts_light_up_the_standing_foot(clip):
    shapes = body.build(clip)
    lit = (body.colors(shapes, np.array([True, False])) != body.colors(shapes)).any(1)
    assert lit.tolist() == [s.foot == "right" for s in shapes]


def test_strip_refuses_an_empty_stretch(clip):
    with pytest.raises(ValueError, match=r"no frame between 5\.0 s"):
        view.strip(clip, start=5.0)
    with pytest.raises(ValueError, match="needs frames, got 0"):
        view.strip(clip, frames=0)


def test_a_camera_level_with_the_floor_draws(clip, tmp_path):
    assert view.strip(clip, elevation=0.0, frames=2, dpi=40) is not None
    with Image.open(view.animate(clip, tmp_path / "walk.png", elevation=0.0, fps=2, height=60)) as picture:
        assert np.asarray(picture.convert("L")).std() > 10


def test_strip_outside_of_a_notebook(clip):
    assert type(view.play(clip)).__name__ == "Picture"


# moving pictures


def test_a_loop_is_whole_strides():
    long = walk(400)
    start, stop = view.loop(long)
    assert stop - start == pytest.approx(120, abs=2)
    assert view.loop(long, strides=3)[1] - view.loop(long, strides=3)[0] == pytest.approx(180, abs=3)
    assert view.loop(walk(20)) == (0, 20)


@pytest.mark.parametrize("suffix", [".gif", ".png", ".webp"])
def test_an_animation_plays_at_the_clips_speed(clip, tmp_path, suffix):
    path = view.animate([clip, walk(30, style="Old")], tmp_path / f"walk{suffix}", height=60, fps=10, caption="Two")
    with Image.open(path) as picture:
        assert picture.n_frames == 10
        frames = []
        for k in range(10):
            picture.seek(k)
            frames.append(np.asarray(picture.convert("RGB")).astype(int))
            assert picture.info["duration"] == 100
    assert all((np.abs(a - b).max(-1) > 40).mean() > 0.002 for a, b in pairwise(frames))
    again = np.abs(frames[0] - frames[5]).max(-1) > 40  # the shorter clip starts again, the other does not
    half = again.shape[1] // 2
    assert again[:, half:].mean() < 0.2 * again[:, :half].mean()


def test_a_film_is_one_that_browsers_play(clip, tmp_path):
    av = pytest.importorskip("av", reason="films need PyAV: pip install av")
    path = view.animate(clip, tmp_path / "walk.mp4", height=141, fps=30, labels=[""])
    view.animate(clip, tmp_path / "walk.png", height=141, fps=30, labels=[""])
    with av.open(str(path)) as film, Image.open(tmp_path / "walk.png") as picture:
        stream = film.streams.video[0]
        assert (stream.codec_context.name, stream.codec_context.pix_fmt, stream.average_rate) == ("h264", "yuv420p", 30)
        assert (stream.width, stream.height) == (picture.width // 2 * 2, 140)
        frames = [frame.to_ndarray(format="rgb24").astype(int) for frame in film.decode(stream)]
        assert len(frames) == picture.n_frames == 30
        for k in (0, 29):
            picture.seek(k)
            wanted = np.asarray(picture.convert("RGB")).astype(int)[:140, : stream.width]
            errors = [np.abs(frame - wanted).mean() for frame in frames]
            assert errors[k] == min(errors) < 5


def test_a_film_without_its_library_says_what_to_install(clip, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(ImportError, match=r"^writing walk\.mp4 needs PyAV: pip install av$"):
        view.animate(clip, tmp_path / "walk.mp4")
    assert not list(tmp_path.iterdir())


def test_lines_on_the_floor_show_the_travel(clip, tmp_path):
    changes = []
    for forward in (1.0, 0.0):
        moving = clip.replace(root_positions=clip.root_positions * torch.tensor([1.0, 1.0, forward]))
        with Image.open(view.animate(moving, tmp_path / "walk.png", height=100, fps=10)) as picture:
            floors = []
            for k in (0, 1):
                picture.seek(k)
                floors.append(np.asarray(picture.convert("RGB")).astype(int)[-8:])
        changes.append(np.abs(floors[0] - floors[1]).mean())
    assert changes[0] > 1 > 5 * changes[1]


def test_a_contact_sheet_has_a_row_per_clip(clip, tmp_path):
    sheet = view.contact_sheet([clip, walk(style="Old")], tmp_path / "sheet.png", columns=3, height=50)
    assert sheet.height == 100
    rows = np.split(np.asarray(Image.open(tmp_path / "sheet.png")).astype(int), 2)
    assert all((row[..., 0] - row[..., 2] > 40).mean() > 0.005 for row in rows)


def test_moving_pictures_refuse_what_does_not_fit(clip, tmp_path):
    with pytest.raises(ValueError, match=r"an animation is a \.gif, \.png, \.apng, \.webp or \.mp4 file; got walk\.avi"):
        view.animate(clip, tmp_path / "walk.avi")
    with pytest.raises(ValueError, match="got 1 clips, 2 labels"):
        view.animate(clip, tmp_path / "walk.gif", labels=["a", "b"])
    with pytest.raises(ValueError, match="needs columns, got 0"):
        view.contact_sheet(clip, columns=0)
    assert not list(tmp_path.iterdir())


# the charts


def phases(frames: int):
    t = torch.arange(frames)[:, None] / 60 + torch.arange(4) / 4
    angle = (2 * np.pi * t) % (2 * np.pi)
    return SimpleNamespace(vector=torch.stack((angle.sin(), angle.cos()), -1), phase=angle, frequency=torch.ones(frames, 4),
                           amplitude=torch.ones(frames, 4), residual=torch.zeros(frames, 4), source=angle.sin(),
                           fit=angle.sin())


def test_phase_figure_shows_four_limbs(clip):
    figure = view.phase_figure(clip, phases(60), torch.ones(60, 2), start=0.25)
    assert [t.name for t in figure.data].count("source") == 4
    assert [t.name for t in figure.data].count("contact") == 2
    assert [t.type for t in figure.data].count("bar") == 4
    assert figure.data[0].x[0] == 0.25
    with pytest.raises(ValueError, match=r"phases must be \[60, 4\]"):
        view.phase_figure(clip, phases(59))


def test_style_space_shows_names_and_groups():
    figure = view.style_space(torch.rand(4, 2), ["A", "B", "C", "D"], ["x", "y", "x", "y"], marked={"blend": torch.zeros(2)})
    assert [t.name for t in figure.data] == ["x", "y", "blend"]
    assert list(figure.data[0].text) == ["A", "C"]
    with pytest.raises(ValueError, match="4 names need positions"):
        view.style_space(torch.rand(4, 3), ["A", "B", "C", "D"])


def test_training_curves_of_rows_and_columns():
    rows = [
        {"step": 10, "elapsed": 1.0, "train": 0.5, "test": None},
        {"step": 20, "elapsed": 2.0, "train": 0.2, "test": 0.3},
    ]
    figure = view.training_curves(rows)
    assert {t.name: list(t.y) for t in figure.data} == {"train": [0.5, 0.2], "test": [0.3]}
    columns = {k: [r[k] for r in rows] for k in rows[0]}
    assert [t.name for t in view.training_curves(columns).data] == ["train", "test"]
    with pytest.raises(ValueError, match="rows with 'step'"):
        view.training_curves([])


def test_trajectory_figure_shows_the_path_and_what_was_asked(clip):
    figure = view.trajectory_figure(clip, torch.zeros(5, 2))
    assert [t.name for t in figure.data] == ["asked for", "Neutral", "Neutral, each second"]
    np.testing.assert_allclose(figure.data[1].y, clip.root_positions[:, 2], atol=1e-6)
