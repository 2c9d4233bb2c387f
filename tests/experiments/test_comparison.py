"""The comparison of the seven models: its measures, and one small run of it."""

import math

import pytest
import torch
from refusal import refusal

import toolkit as tk
from experiments.__main__ import main
from experiments.seven_models import load, models

MODELS = ("lpn-film",)
PLAN = models.Plan("tiny", 4, walk=4.0, radius=0.1, recogniser_steps=5)
SOURCE = {"data": "procedural", "root": None, "styles": "Neutral,PendulumHands,Zombie",
          "gaits": "FW", "clip_seconds": 8.0, "listed": False}


@pytest.fixture(scope="module")
def data():
    return load(**SOURCE)


@pytest.fixture(scope="module")
def folder(data, tmp_path_factory):
    """A whole comparison, of models that have hardly learnt anything."""
    out = tmp_path_factory.mktemp("comparison")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(models, "WARM_UP", 0.2)
        models.compare(data, SOURCE, PLAN, MODELS, 1, out)
    return out


def test_everything_is_measured_and_stored(data, folder):
    table = models.read_json(folder / models.TABLE)
    assert set(table["models"]) == set(MODELS)
    assert table["settings"]["source"] == SOURCE
    assert table["machine"]["torch"] == torch.__version__
    assert table["baselines"]["repeat"] < table["baselines"]["mean"] < 2
    film = table["models"]["lpn-film"]
    assert film["counts"]["per_style"] == 4 * models.SIZES["tiny"].hidden
    row = film["runs"][0]["styles"]["PendulumHands"]
    assert row["hands_data"] > models.MOVING
    assert row["swing_data"] > 0.8  # there both hands swing together
    assert all(math.isfinite(v) for v in row.values())
    shared = [style["shared"] for style in film["runs"][0]["styles"].values()]
    assert film["runs"][0]["shared"] == pytest.approx(sum(shared) / 3)


def test_what_is_there_is_not_done_again(data, folder, monkeypatch):
    for module, name in ((tk.training, "fit"), (models, "closed_loop"),
                         (tk.evaluation.recognition, "train")):
        monkeypatch.setattr(module, name, None)
    before = models.read_json(folder / models.TABLE)
    again = models.compare(data, SOURCE, PLAN, MODELS, 1, folder)
    assert again["models"] == before["models"]


def test_other_settings_and_bad_names_are_refused_in_one_line(data, folder, capsys):
    with refusal(r"other settings .*steps: expected 4, got 5"):
        models.compare(data, SOURCE, models.Plan("tiny", 5), MODELS, 1, folder)
    with refusal(r"was trained with other settings \(steps: expected 5, got 4\)"):
        models.trained(data, models.Plan("tiny", 5).config("lpn-film", 0), folder)
    for arguments, said in (
        ([], "--data is missing"),
        (["--data", "procedural", "--size", "huge"], "unknown size 'huge'; known: tiny, small"),
        (["failures", "--out", "nowhere"], "nowhere"),
    ):
        assert main(["seven-models", *arguments]) == 2
        assert said in capsys.readouterr().err
