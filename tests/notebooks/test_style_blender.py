import asyncio
import dataclasses
import gc

import pytest
import torch
from course.style_blender import StyleBlender
from refusal import refusal

import toolkit as tk
from toolkit.networks.bank import StyleBank


@pytest.fixture(scope="module")
def clip(walk_clip) -> tk.Clip:
    return walk_clip.cut(100, 190)


async def until(test) -> None:
    async with asyncio.timeout(60):
        while not test():
            await asyncio.sleep(0.005)


def bank(*names: str) -> StyleBank:
    return StyleBank(names, torch.zeros(len(names), 2))


def style(blender) -> str:
    return blender.player.clip.style


def test_blender_makes_the_motion_of_its_weights(clip):
    asked = []

    def make(weights: dict[str, float]) -> tk.Clip:
        asked.append(weights)
        return clip.cut(0, 10).replace(style="+".join(n for n, w in weights.items() if w))

    blender = StyleBlender(bank("A", "B", "C", "Neutral"), make)
    assert blender.weights == pytest.approx({"Neutral": 1 / 3, "A": 1 / 3, "B": 1 / 3})
    blender.weights = {"C": 3, "B": 1}
    assert asked[-1] == pytest.approx({"C": 0.75, "B": 0.25, "Neutral": 0})
    assert blender.triangle.names == ["C", "B", "Neutral"]
    assert style(blender) == "C+B"
    for wrong, message in (
        ({"X": 1}, "unknown style 'X'; known: A, B, C, Neutral"), ({"A": -1}, "weights >= 0"),
        ({}, "one to")
    ):
        with refusal(message):
            blender.weights = wrong
        with refusal(message):
            StyleBlender(bank("A", "B", "C", "Neutral"), make, weights=wrong)
    marked = dataclasses.replace(bank("A", "B", "C"), broken=torch.tensor([False, True, False]))
    assert StyleBlender(marked, make)._menus[0].options[1] == ("B (broken)", "B")
    gc.collect()  # a refused blender is closed without an error
    blender.close()


def test_blender_waits_and_shows_the_newest_only(clip):
    asked = []

    def make(weights):
        asked.append(weights)
        return clip.cut(0, 10).replace(style=f"{weights['A']:.1f}")

    async def scenario():
        blender = StyleBlender(bank("A", "B", "C"), make)
        for a in (0.1, 0.3, 0.5, 0.9):
            blender.triangle.weights = [a, 1 - a, 0.0]
        await until(lambda: style(blender) == "0.9")
        assert len(asked) == 2
        blender.close()

    asyncio.run(scenario())
