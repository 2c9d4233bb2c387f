"""The comparison of the seven models: its measures, and one small run of it."""

import math

import pytest
import torch
from course import comparison

import toolkit as tk
from experiments.__main__ import main
from experiments.seven_models import failures, load, models, results

STYLES = "Neutral,PendulumHands,Zombie"
MODELS = ("mann-film", "lpn-film")
PLAN = models.Plan("tiny", 4, walk=4.0, radius=0.1, recogniser_steps=5)
SOURCE = {
    "data": "procedural",
    "root": None,
    "styles": STYLES,
    "gaits": "FW",
    "clip_seconds": 8.0,
    "listed": False,
}


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


def test_the_shared_error_of_a_model_that_predicts_the_mean(data):
    train, test = tk.training.split(data, 0.1, 0, tuple(data.styles))
    scale = train.normalisers()["outputs"]
    model = tk.networks.build("pfnn-resad", data.layout, 3, models.SIZES["tiny"])
    model.normalise(tk.networks.normalisers(model.layout, train))
    bank = tk.training.make_bank(model, train)
    torch.nn.init.zeros_(model.experts.layers[-1].weight)
    error = models.average(list(comparison.shared_error(model, bank, test, scale).values()))
    assert error == pytest.approx(comparison.shared_baselines(data, 0.1, 0)["mean"], rel=1e-4)


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
    assert film["runs"][0]["shared"] == pytest.approx(
        sum(s["shared"] for s in film["runs"][0]["styles"].values()) / 3
    )


def test_what_is_there_is_not_done_again(data, folder, monkeypatch):
    for module, name in (
        (tk.training, "fit"),
        (models, "closed_loop"),
        (tk.evaluation.recognition, "train"),
    ):
        monkeypatch.setattr(module, name, None)
    before = models.read_json(folder / models.TABLE)
    again = models.compare(data, SOURCE, PLAN, MODELS, 1, folder)
    assert again["models"]["mann-film"] == before["models"]["mann-film"]


def test_other_settings_and_bad_names_are_refused_in_one_line(data, folder, capsys):
    with pytest.raises(ValueError, match=r"other settings .*steps: expected 4, got 5"):
        models.settle(folder, models.Plan("tiny", 5), data, SOURCE)
    with pytest.raises(
        ValueError, match=r"was trained with other settings \(steps: expected 5, got 4\)"
    ):
        models.trained(data, models.Plan("tiny", 5).config("lpn-film", 0), folder)
    for arguments, said in (
        ([], "--data is missing"),
        (["--data", "procedural", "--size", "huge"], "unknown size 'huge'; known: tiny, small"),
        (["failures", "--out", "nowhere"], "nowhere"),
    ):
        assert main(["seven-models", *arguments]) == 2
        assert said in capsys.readouterr().err


def test_stuck_hands_are_told_from_moving_ones():
    def runs(hands):
        style = {"hands": hands, "hands_data": 0.2, "together": 1 - hands}
        still = {
            "hands": 0.1,
            "hands_data": 0.01,
            "together": 0.0,
        }  # moves in neither, and does not count
        return {"runs": [{"styles": {"Swimming": style, "Monk": still}, "recognised": 1.0}] * 2}

    table = {"models": {"pfnn-film": runs(0.3), "lpn-film": runs(0.9)}}
    rows = failures.stuck_hands(table, "pfnn-film", "lpn-film")
    row = rows["pfnn-film"]
    assert row["range / data"] == pytest.approx([0.3, 0.3])
    assert (row["styles below 0.5"], row["of styles"]) == ([1, 1], 1)
    found = failures.result("x", "5.1.1 No global phase: claim", rows, "command", 2)
    assert found.name == "x-no-global-phase"
    assert "| lpn-film | 0.900 ± 0.000 | 0.100 ± 0.000 | 0 ± 0 | 1 | 1.000 ± 0.000 |" in (
        found.markdown())


def test_the_stored_result_of_a_comparison_has_floors_ceiling_and_every_model(folder):
    table = models.read_json(folder / models.TABLE)
    table["ceiling"] = table["models"]["lpn-film"]["runs"][0]
    found = results.comparison("x", "about", "command", table)
    assert [row["model"] for row in found.rows] == [
        "floor: predicting the mean",
        "floor: repeating the frame",
        *MODELS,
        "the published network",
    ]
    film = next(row for row in found.rows if row["model"] == "lpn-film")
    assert film["shared"] == [found.rows[-1]["shared"]]
    assert film["step_ms"][0] == pytest.approx(1000 * 60 * film["minutes"][0] / PLAN.steps)
    assert found.settings["styles"] == 3
    assert "nan" not in found.markdown()
