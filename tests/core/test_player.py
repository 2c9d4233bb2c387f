import base64

import pytest
import torch

import toolkit as tk
from toolkit import view

FRAMES = 90


@pytest.fixture(scope="module")
def clip(walk_clip) -> tk.Clip:
    return walk_clip.cut(100, 100 + FRAMES)


@pytest.fixture(scope="module")
def other(walk_clip) -> tk.Clip:
    return walk_clip.cut(300, 330).replace(style="Old")


def test_the_page_gets_a_body_once_and_every_motion(clip, other):
    player = view.Player([clip, other], contacts=[torch.ones(FRAMES, 2), None])
    assert [shown["label"] for shown in player.clips] == ["Neutral FW", "Old FW"]
    assert [shown["skeleton"] for shown in player.clips] == [0, 0]
    assert [shown["contacts"] is None for shown in player.clips] == [False, True]
    changes = []
    player.observe(lambda change: changes.append(change["name"]), ["skeletons", "clips"])
    player.show(other)
    assert (player.clips[0]["label"], player.clips[0]["frames"]) == ("Old FW", 30)
    assert changes == ["clips"]  # the body is there
    player.close()
    assert (player.clips, player.skeletons, player.shown) == ([], [], [])


def test_outside_of_a_notebook_playing_gives_a_strip(clip, other):
    figure = view.play([clip, other], labels=["data", "model"])
    assert type(figure).__name__ == "Picture"
    assert [axes.texts[0].get_text() for axes in figure.axes] == ["data", "model"]


def test_a_page_without_a_kernel_gets_a_picture_and_a_line(clip, fast, monkeypatch):
    shown = []
    monkeypatch.setattr("toolkit.view.frontend.display", shown.append)
    widgets = (view.Player(clip), view.Controller(*fast), view.Director(*tk.pretrained()))
    for widget in widgets:
        assert "application/vnd.jupyter.widget-view+json" in str(widget._repr_mimebundle_())
        text = shown.pop().data
        assert f"Run the notebook for the {type(widget).__name__}" in text
        assert base64.b64decode(text.split("base64,")[1].split('"')[0])[:4] == b"\x89PNG"
        widget.close()
