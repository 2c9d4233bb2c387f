import asyncio
import base64
import gc
import io
import threading
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from PIL import Image

import toolkit as tk
from toolkit import view
from toolkit.motion import root_frames
from toolkit.networks.bank import StyleBank
from toolkit.view.render import floor, opengl, stage

FRAMES = 90


@pytest.fixture(scope="module")
def clip(walk_clip) -> tk.Clip:
    return walk_clip.cut(100, 100 + FRAMES)


@pytest.fixture(scope="module")
def other(walk_clip) -> tk.Clip:
    return walk_clip.cut(300, 330).replace(style="Old")


@pytest.fixture(params=["pyvista", "matplotlib"])
def renderer(request, monkeypatch):
    if request.param == "matplotlib":
        monkeypatch.setattr(stage, "opengl_works", lambda: False)
    elif not stage.opengl_works():
        pytest.skip("pyvista finds no OpenGL here: " + opengl.INSTALL)


@pytest.fixture
def player():
    """Makes players that are closed at the end."""
    made = []

    def make(*arguments, size=(160, 120), **options):
        made.append(view.Player(*arguments, size=size, **options))
        return made[-1]

    yield make
    for one in made:
        one.close()


def shown(player) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(player.image.value)))


def watch(player) -> None:
    """Be a page that shows every picture at once."""
    screen = player.image

    def seen(change) -> None:
        screen._handle_custom_msg({"kind": "seen", "number": change["new"]}, [])

    screen.observe(seen, "number")


async def until(test) -> None:
    async with asyncio.timeout(60):
        while not test():
            await asyncio.sleep(0.005)


def differ(a: np.ndarray, b: np.ndarray) -> float:
    """Share of pixels that differ clearly."""
    return float((np.abs(a.astype(int) - b).max(-1) > 30).mean())


# one clip


def test_player_draws_and_frames_differ(renderer, player, clip, other):
    one = player(clip, contacts=torch.ones(FRAMES, 2))
    first, later = one.render(0), one.render(20)
    assert first.shape == (120, 160, 3)
    assert first.std() > 10
    assert differ(first, later) > 0.005
    before = shown(one)
    one.seek(20)
    assert one.frame == 20
    assert differ(shown(one), before) > 0.005
    one.show(other)
    assert "Old" in one._title.value
    assert one.frame == 20
    with pytest.raises(ValueError, match="frame 30 is not one of 30"):
        one.render(30)
    one.show([clip, other], labels=["<data>", "model"])
    assert "&lt;data&gt;, model" in one._title.value
    assert [cell.size for cell in one._cells] == [(80, 120)] * 2


def test_every_switch_shows_what_it_says_and_nothing_else(renderer, player, clip):
    contacts = tk.contacts.detect(clip)
    full, plain = player(clip, contacts=contacts), player(clip)
    assert [one._switches["contacts"].disabled for one in (full, plain)] == [False, True]
    for switch in (*full._switches.values(), *plain._switches.values()):
        switch.value = False
    bare = full.render(45)
    np.testing.assert_array_equal(bare, plain.render(45))
    for kind, switch in full._switches.items():
        switch.value = True
        changed = np.abs(full.render(45).astype(int) - bare).max(-1) > 30
        assert changed.mean() > 0.001, kind
        assert np.nonzero(changed)[0].min() > 60, kind  # on the floor
        switch.value = False
        np.testing.assert_array_equal(full.render(45), bare)


def test_a_camera_that_does_not_follow_stays(player, clip):
    one = player(clip)
    follows = differ(one.render(0), one.render(80))
    one._follow.value = False
    assert differ(one.render(0), one.render(80)) > follows


def test_pages_without_widgets_get_the_picture(player, clip):
    one = player(clip)
    bundle = one._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in bundle
    assert base64.b64decode(bundle["image/jpeg"]) == one.image.value


@pytest.mark.parametrize("frames", [1, 4])
def test_any_tree_plays(renderer, player, clip, frames):
    offsets = torch.tensor([[0.0, 0, 0], [0, 0.5, 0], [0.2, 0, 0]])
    skeleton = tk.Skeleton(("a", "b", "c"), (-1, 0, 1), offsets)
    rotations = tk.motion.rotations.identity(frames, 3)
    tree = tk.Clip(skeleton, rotations, torch.zeros(frames, 3), 30.0)
    one = player([tree, clip], contacts=[None, torch.ones(FRAMES, 2)])
    one.show(tree)
    assert one.render(frames - 1).std() > 2


def test_missing_opengl_is_explained_once(monkeypatch, clip, capsys):
    monkeypatch.setattr(stage, "opengl_works", lambda: False)
    stage.explain_missing_opengl.cache_clear()
    for _ in range(2):
        view.Player(clip, size=(80, 60)).close()
    assert capsys.readouterr().out.count(opengl.INSTALL) == 1


# several clips


def test_side_by_side_each_cell_is_what_the_clip_looks_like_alone(player, clip, other):
    both = player([clip, other], labels=["", ""])
    assert both.clip is clip
    picture = both.render(70)
    left, right = player(clip, size=(80, 120)), player(other, size=(80, 120))
    np.testing.assert_array_equal(picture[:, :80], left.render(70))
    np.testing.assert_array_equal(picture[:, 80:], right.render(70 % 30))


def test_many_clips_fill_a_grid(player, clip):
    picture = player([clip] * 4, labels=[""] * 4).render(0)
    cells = [picture[y : y + 60, x : x + 80] for y in (0, 60) for x in (0, 80)]
    assert cells[0].std() > 10
    assert all((cell == cells[0]).all() for cell in cells)


@pytest.mark.parametrize(
    ("clips", "options", "message"),
    [
        (0, {}, "got 0 clips, 0 labels"),
        (1, {"labels": ["a", "b"]}, "got 1 clips, 2 labels"),
        (
            1, {"contacts": torch.zeros(3, 2)},
            r"contacts must be \[F, 2\] for each clip of \[90\] frames"
        ),
        (2, {"contacts": torch.ones(FRAMES, 2)}, r"contacts must be \[F, 2\] for each"),
    ],
)
def test_what_does_not_fit_is_refused(clip, clips, options, message):
    with pytest.raises(ValueError, match=message):
        view.Player([clip] * clips, **options)


def test_outside_of_a_notebook_playing_gives_a_strip(clip, other):
    figure = view.play([clip, other], labels=["data", "model"])
    assert type(figure).__name__ == "Picture"
    assert [axes.texts[0].get_text() for axes in figure.axes] == ["data", "model"]


# the floor


def layers(clip: tk.Clip, kind: str) -> list[floor.Layer]:
    return [
        layer
        for layer in floor.layers(clip, tk.contacts.detect(clip).numpy())
        if layer.kind == kind
    ]


def area(layer: floor.Layer, frame: int) -> np.ndarray:
    """Area of each triangle."""
    a, b, c = (layer.corners(frame)[layer.triangles[:, k]] for k in range(3))
    return np.abs(np.linalg.det(np.stack((b - a, c - a), 1))) / 2


def test_the_path_ends_where_the_root_is(clip):
    whole, done = layers(clip, "path")
    root = clip.root_positions[:, [0, 2]].numpy()
    length = np.linalg.norm(np.diff(root, axis=0), axis=1)
    for frame in (0, 40, 89):
        np.testing.assert_allclose(done.corners(frame)[-2:].mean(0), root[frame], atol=1e-5)
        assert area(done, frame).sum() == pytest.approx(0.028 * length[:frame].sum(), rel=0.02)
        assert area(whole, frame).sum() == pytest.approx(0.012 * length.sum(), rel=0.02)


def test_a_footprint_appears_when_the_foot_comes_down_and_stays(clip):
    contacts = tk.contacts.detect(clip).numpy() > 0.5
    for i, (side, layer) in enumerate(zip(tk.contacts.FEET, layers(clip, "contacts"), strict=True)):
        starts = [f for f in range(FRAMES) if contacts[f, i] and (f == 0 or not contacts[f - 1, i])]
        toe = clip.global_positions[:, clip.skeleton.index(f"{side}_toe")][:, [0, 2]].numpy()
        assert len(starts) >= 1
        for frame in range(0, FRAMES, 7):
            prints = layer.corners(frame).reshape(len(starts), -1, 2)
            for start, ring in zip(starts, prints, strict=True):
                assert (np.ptp(ring, axis=0).max() > 0.05) == (start <= frame)
        ends = [next((f for f in range(s, FRAMES) if not contacts[f, i]), FRAMES) for s in starts]
        for ring, start, end in zip(prints, starts, ends, strict=True):
            assert np.linalg.norm(ring.mean(0) - toe[(start + end) // 2]) < 0.12


def test_arrows_are_the_trajectory_window(clip):
    roots, samples = root_frames(clip), np.array(tk.motion.trajectory.SAMPLES)
    for frame in (0, 30, 75):
        arrows = np.concatenate(
            [layer.corners(frame).reshape(-1, 4, 2) for layer in layers(clip, "trajectory")]
        )
        areas = np.concatenate(
            [area(layer, frame).reshape(-1, 2).sum(1) for layer in layers(clip, "trajectory")]
        )
        inside = (frame + samples >= 0) & (frame + samples < FRAMES)
        assert (areas > 1e-4).tolist() == inside.tolist()
        forward = tk.motion.rotations.rotate(roots.rotations, torch.tensor([0.0, 0.0, 1.0]))[
            :, [0, 2]
        ].numpy()
        for arrow, at in zip(arrows[inside], (frame + samples)[inside], strict=True):
            place = roots.positions[at, [0, 2]].numpy()
            np.testing.assert_allclose(arrow[0] - place, 0.09 * forward[at], atol=1e-5)
            np.testing.assert_allclose(
                arrow[[1, 3]].mean(0) - place, -0.05 * forward[at], atol=1e-5
            )


# time and threads


def test_player_draws_on_the_main_thread_only(player, clip):
    async def scenario():
        one = player(clip, size=(80, 60))
        drawn, errors = one.image.number, []

        def from_elsewhere():
            one._slider.value = 30
            try:
                one.render(0)
            except RuntimeError as error:
                errors.append(str(error))

        thread = threading.Thread(target=from_elsewhere)
        thread.start()
        thread.join()
        assert one.image.number == drawn
        assert "main thread" in errors[0]
        await until(lambda: one.image.number > drawn)
        assert (one.image.number, one.frame) == (drawn + 1, 30)

    asyncio.run(scenario())


def test_one_player_plays_while_its_page_answers(player, clip, monkeypatch):
    monkeypatch.setattr("toolkit.view.widgets.player.PATIENCE", 1e6)

    async def scenario():
        one, two = (player(clip, size=(80, 60)) for _ in range(2))
        one.playing = True
        await until(lambda: one.image.number > 3)
        for _ in range(20):
            await asyncio.sleep(0)
        assert one.image.number == 4  # as many as may be unanswered
        watch(one)
        one.image._handle_custom_msg({"kind": "seen", "number": 4}, [])
        await until(lambda: one.image.number > 8)
        assert one.frame > 0
        two.playing = True
        assert not one.playing
        one.close()
        assert one._task is None
        assert view.Player._current is two

    asyncio.run(scenario())


def test_time_goes_with_the_clock_and_the_chosen_speed(player, clip, monkeypatch):
    now = [0.0]
    clock = SimpleNamespace(monotonic=lambda: now[0])
    monkeypatch.setattr("toolkit.view.widgets.player.time", clock)

    async def scenario():
        one = player(clip, size=(80, 60))
        watch(one)
        one._speeds.value, one.playing = 0.5, True
        await until(lambda: one.image.number > 2)
        start, drawn = one._frame, one.image.number
        now[0] += 1.0
        await until(lambda: one.image.number > drawn + 2)
        assert one._frame - start == pytest.approx(30.0)  # half of 60 frames
        now[0] += 1000.0  # nobody touched anything
        await until(lambda: not one.playing)

    asyncio.run(scenario())


# style blending


def bank(*names: str) -> StyleBank:
    return StyleBank(names, torch.zeros(len(names), 2))


def test_blender_makes_the_motion_of_its_weights(clip):
    asked = []

    def make(weights: dict[str, float]) -> tk.Clip:
        asked.append(weights)
        return clip.cut(0, 10).replace(style="+".join(n for n, w in weights.items() if w))

    blender = view.StyleBlender(bank("A", "B", "C", "D"), make, size=(80, 60))
    assert blender.weights == pytest.approx({"A": 1 / 3, "B": 1 / 3, "C": 1 / 3})
    blender.weights = {"D": 3, "B": 1}
    assert asked[-1] == pytest.approx({"D": 0.75, "B": 0.25, "A": 0})
    assert blender.triangle.names == ["D", "B", "A"]
    assert blender.player.clip.style == "D+B"
    shown = blender._repr_mimebundle_()
    assert base64.b64decode(shown["image/jpeg"]) == blender.player.image.value
    assert "application/vnd.jupyter.widget-view+json" in shown
    for wrong, message in (
        ({"X": 1}, "unknown style 'X'; known: A, B, C, D"), ({"A": -1}, "weights >= 0"),
        ({}, "one to")
    ):
        with pytest.raises(ValueError, match=message):
            blender.weights = wrong
        with pytest.raises(ValueError, match=message):
            view.StyleBlender(bank("A", "B", "C", "D"), make, weights=wrong)
    gc.collect()  # a refused blender is closed without an error
    blender.close()


def test_blender_waits_and_shows_the_newest_only(clip):
    asked = []

    def make(weights):
        asked.append(weights)
        return clip.cut(0, 10).replace(style=f"{weights['A']:.1f}")

    async def scenario():
        blender = view.StyleBlender(bank("A", "B", "C"), make, size=(80, 60))
        for a in (0.1, 0.3, 0.5, 0.9):
            blender.triangle.weights = [a, 1 - a, 0.0]
        await until(lambda: blender.player.clip.style == "0.9")
        assert len(asked) == 2
        blender.close()

    asyncio.run(scenario())
