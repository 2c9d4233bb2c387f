import pytest
import torch
from course.style_map import StyleExplorer, StyleMap, embed, explore
from refusal import refusal

from toolkit.styles import StyleBank

BANK = StyleBank(("Neutral", "Zombie", "Old", "Crouch"), torch.eye(4))
POINTS = torch.tensor([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.5]])


@pytest.fixture
def explorer(walk_clip):
    played = []

    def make_clip(blend):
        played.append({name: share for name, share in blend.items() if share > 0})
        return walk_clip.cut(0, 2)

    shown = StyleExplorer(None, BANK, POINTS, make_clip=make_clip, size=(96, 96))
    shown.played = played
    yield shown
    shown.close()


def test_the_map_of_vectors_keeps_neighbours_and_repeats():
    noise = torch.randn(24, 4, generator=torch.Generator().manual_seed(3))
    vectors = 4 * torch.eye(3, 4).repeat_interleave(8, 0) + 0.2 * noise
    points = embed(vectors)
    assert points.shape == (24, 2)
    assert torch.equal(points, embed(vectors))
    nearest = torch.cdist(points, points).fill_diagonal_(torch.inf).argmin(1)
    assert torch.equal(nearest // 8, torch.arange(24) // 8)
    with refusal("three or more"):
        embed(vectors[:2])


def test_the_blend_at_a_place_reproduces_the_place(explorer):
    for x, y in ((0.0, 0.0), (1.0, 1.0), (3.0, 3.5), (2.0, 0.0)):
        blend = explorer.blend_at(x, y)
        assert sum(blend.values()) == pytest.approx(1.0)
        back = sum(w * POINTS[BANK.names.index(name)] for name, w in blend.items())
        torch.testing.assert_close(back, torch.tensor([x, y]), atol=1e-5, rtol=0)
    assert explorer.blend_at(0.0, 0.0) == {"Neutral": 1.0}
    # outside, it is the nearest place inside
    assert explorer.blend_at(-5.0, -5.0) == {"Neutral": 1.0}
    assert explorer.blend_at(2.0, -3.0) == pytest.approx({"Neutral": 0.5, "Zombie": 0.5})


def test_a_click_plays_the_style_and_a_drag_the_blend_once(explorer):
    explorer.map._handle_custom_msg({"style": "Old"}, [])  # as the page sends it
    assert explorer.played[-1] == {"Old": 1.0}
    assert explorer.map.place == pytest.approx([0.0, 4.0])
    before = len(explorer.played)
    explorer.map.place = [2.0, 0.0]  # as the page sets it
    assert len(explorer.played) == before + 1
    assert explorer.played[-1] == pytest.approx({"Neutral": 0.5, "Zombie": 0.5})
    explorer.map.place = [2.0, -3.0]
    assert explorer.map.place == pytest.approx([2.0, 0.0], abs=1e-6)  # the ring comes back
    played = len(explorer.played)
    explorer.map.place = [float("nan"), 1.0]
    assert explorer.map.place == pytest.approx([2.0, 0.0], abs=1e-6)
    assert len(explorer.played) == played
    assert explorer.still()[:4] == b"\x89PNG"


def test_the_model_plays_and_outside_of_notebooks_it_is_the_map_alone(fast):
    model, bank = fast[0], fast[1].select(["Neutral", "Zombie", "Old"])
    figure = explore(model, bank)
    assert type(figure).__name__ == "Figure"
    assert list(figure.data[0].text) == ["Neutral", "Zombie", "Old"]
    assert "plotly.js" in StyleMap().plotly[:200]
    corners = torch.tensor([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    shown = StyleExplorer(model, bank, corners, size=(96, 96))
    assert shown.player.shown[0].seconds == pytest.approx(2.0)
    shown.close()
