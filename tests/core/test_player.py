import asyncio
import base64
import gc

import numpy as np
import pytest
import torch

import toolkit as tk
from toolkit import view
from toolkit.networks.bank import StyleBank

FRAMES = 90


@pytest.fixture(scope="module")
def clip(walk_clip) -> tk.Clip:
    return walk_clip.cut(100, 100 + FRAMES)


@pytest.fixture(scope="module")
def other(walk_clip) -> tk.Clip:
    return walk_clip.cut(300, 330).replace(style="Old")


async def until(test) -> None:
    async with asyncio.timeout(60):
        while not test():
            await asyncio.sleep(0.005)


def test_the_page_gets_a_body_once_and_every_motion(clip, other):
    player = view.Player([clip, other], contacts=[torch.ones(FRAMES, 2), None])
    assert [shown["label"] for shown in player.clips] == ["Neutral FW", "Old FW"]
    assert [shown["skeleton"] for shown in player.clips] == [0, 0]
    assert [shown["contacts"] is None for shown in player.clips] == [False, True]
    changes = []
    player.observe(lambda change: changes.append(change["name"]), ["skeletons", "clips"])
    player.show(other, labels=["<data>"])
    assert (player.clips[0]["label"], player.clips[0]["frames"]) == ("<data>", 30)
    assert changes == ["clips"]  # the body is there
    root = np.frombuffer(base64.b64decode(player.clips[0]["root"]), np.float32).reshape(-1, 3)
    np.testing.assert_allclose(root, other.root_positions, atol=1e-6)
    player.close()
    assert (player.clips, player.skeletons, len(player.shown)) == ([], [], 1)


@pytest.mark.parametrize("frames", [1, 4])
def test_any_tree_plays(clip, frames):
    offsets = torch.tensor([[0.0, 0, 0], [0, 0.5, 0], [0.2, 0, 0]])
    skeleton = tk.Skeleton(("a", "b", "c"), (-1, 0, 1), offsets)
    rotations = tk.motion.rotations.identity(frames, 3)
    tree = tk.Clip(skeleton, rotations, torch.zeros(frames, 3), 30.0)
    player = view.Player([tree, clip], contacts=[None, torch.ones(FRAMES, 2)])
    assert [shown["skeleton"] for shown in player.clips] == [0, 1]
    player.close()


def test_outside_of_a_notebook_playing_gives_a_strip(clip, other):
    figure = view.play([clip, other], labels=["data", "model"])
    assert type(figure).__name__ == "Picture"
    assert [axes.texts[0].get_text() for axes in figure.axes] == ["data", "model"]


def test_a_page_without_a_kernel_gets_a_picture_and_a_line(clip, monkeypatch):
    shown = []
    monkeypatch.setattr("toolkit.view.frontend.display", shown.append)
    model, bank = tk.pretrained()
    widgets = (view.Player(clip), view.Controller(model, bank), view.Director(model, bank),
               view.StyleBlender(bank, lambda _: clip))
    for widget in widgets:
        assert "application/vnd.jupyter.widget-view+json" in str(widget._repr_mimebundle_())
        text = shown.pop().data
        assert f"Run the notebook for the {type(widget).__name__}" in text
        assert base64.b64decode(text.split("base64,")[1].split('"')[0])[:4] == b"\x89PNG"
        widget.close()


# style blending


def bank(*names: str) -> StyleBank:
    return StyleBank(names, torch.zeros(len(names), 2))


def style(blender) -> str:
    return blender.player.clip.style


def test_blender_makes_the_motion_of_its_weights(clip):
    asked = []

    def make(weights: dict[str, float]) -> tk.Clip:
        asked.append(weights)
        return clip.cut(0, 10).replace(style="+".join(n for n, w in weights.items() if w))

    blender = view.StyleBlender(bank("A", "B", "C", "Neutral"), make)
    assert blender.weights == pytest.approx({"Neutral": 1 / 3, "A": 1 / 3, "B": 1 / 3})
    blender.weights = {"C": 3, "B": 1}
    assert asked[-1] == pytest.approx({"C": 0.75, "B": 0.25, "Neutral": 0})
    assert blender.triangle.names == ["C", "B", "Neutral"]
    assert style(blender) == "C+B"
    for wrong, message in (
        ({"X": 1}, "unknown style 'X'; known: A, B, C, Neutral"), ({"A": -1}, "weights >= 0"),
        ({}, "one to")
    ):
        with pytest.raises(ValueError, match=message):
            blender.weights = wrong
        with pytest.raises(ValueError, match=message):
            view.StyleBlender(bank("A", "B", "C", "Neutral"), make, weights=wrong)
    gc.collect()  # a refused blender is closed without an error
    blender.close()


def test_blender_waits_and_shows_the_newest_only(clip):
    asked = []

    def make(weights):
        asked.append(weights)
        return clip.cut(0, 10).replace(style=f"{weights['A']:.1f}")

    async def scenario():
        blender = view.StyleBlender(bank("A", "B", "C"), make)
        for a in (0.1, 0.3, 0.5, 0.9):
            blender.triangle.weights = [a, 1 - a, 0.0]
        await until(lambda: style(blender) == "0.9")
        assert len(asked) == 2
        blender.close()

    asyncio.run(scenario())
