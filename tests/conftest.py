"""What tests share. The process that only hands tests out imports nothing slow from here."""

import os
from pathlib import Path

import compiled_runtime
import pytest
from hypothesis import settings

import toolkit as tk

settings.register_profile("repeatable", derandomize=True, deadline=None, max_examples=25,
                          database=None)
settings.load_profile("repeatable")
os.environ.setdefault("OMP_NUM_THREADS", "1")  # small tensors: more threads only wait


def pytest_collection_finish(session):
    """One of several processes compiles what all need, beside `make kernels`; the others wait."""
    if hasattr(session.config, "workerinput"):
        compiled_runtime.fit()
        compiled_runtime.read()


@pytest.fixture(scope="session")
def shared() -> Path:
    """Real recordings, in the sub-folders 100style, bandai and xia; never part of this
    repository.
    """
    folder = Path(os.environ.get("TOOLKIT_DATA") or Path(__file__).parents[2] / "shared" / "data")
    if not folder.is_dir():
        pytest.skip(f"no real recordings: {folder} does not exist (set TOOLKIT_DATA to the "
                    f"folder that holds 100style/ …)")
    return folder


@pytest.fixture(scope="session")
def walk_clip() -> "tk.Clip":
    """Eight seconds of procedural walking."""
    return tk.datasets.procedural.generate("Neutral", seconds=8.0)


@pytest.fixture(scope="session")
def zombie() -> "tk.Clip":
    """Three seconds of procedural walking, away from the origin and from the axes."""
    clip = tk.datasets.procedural.generate("Zombie", seconds=3.0)
    return clip.moved(turn=0.7, shift=(2.0, 0.0, -1.0))


@pytest.fixture(scope="session")
def two_styles() -> "tk.features.Features":
    """Features of ten seconds of each of two styles."""
    return tk.features.build(
        tk.datasets.load("procedural", styles=["Neutral", "Zombie"], gaits=["FW"], seconds=10.0))


@pytest.fixture(scope="session")
def small_run(two_styles) -> "tk.training.Run":
    """A model of two styles after a few steps: its weights are real, its motion is not yet."""
    sizes = tk.networks.Sizes(hidden=32, experts=4, gating=8, film_channels=8, film_kernel=5,
                              film_dense=16, dropout=0.0)
    return tk.training.fit(two_styles, tk.training.Config.quick(steps=60, sizes=sizes))


@pytest.fixture(scope="session")
def hero(tmp_path_factory) -> Path:
    """A skinned body on a rig with bones along their own y, twist bones, shorter legs."""
    from posed_rigs import rig, with_twists

    path = tmp_path_factory.mktemp("hero") / "hero.glb"
    tk.extra.engines.gltf.save(rig("along y", arms=1.1, legs=0.85, hips=1.1, joints=with_twists),
                               path)
    return path


@pytest.fixture(scope="session")
def fast() -> tuple:
    """The embedded model compiled, which walks ten times as fast, and its styles."""
    model, bank = tk.pretrained()
    return tk.runtime.compile(model), bank


@pytest.fixture
def command(capsys):
    """``command(words, *more, status=0)``: what the command line printed and what it said."""
    from toolkit.__main__ import main

    def run(words: str, *more: object, status: int = 0):
        assert main([*words.split(), *map(str, more)]) == status
        return capsys.readouterr()

    return run
