"""The comparison of the seven models: its measures, and one small run of it."""

import math

import pytest
import torch
from course import comparison

import toolkit as tk
from experiments.__main__ import main
from experiments.seven_models import failures, interpolation, load, models, results
from experiments.seven_models.posture import posture_error
from toolkit.features import pack_joints

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


def joints_of(hands, layout):
    """Positions ``[F, J, 3]`` of a standing body with hands moved fore and aft ``[F, 2]``."""
    rest = layout.skeleton.rest_positions[list(layout.skeleton.feature_joints)].repeat(
        len(hands), 1, 1
    )
    for i, side in enumerate(("left", "right")):
        rest[:, layout.names.index(layout.skeleton.roles[f"{side}_hand"]), 2] += hands[:, i]
    return rest


def test_hands_that_swing_together_or_in_turn_or_not_at_all(data):
    t = torch.arange(240) * (2 * math.pi / 60)
    swings = torch.stack(
        (
            torch.stack((t.sin(), t.sin()), 1),
            torch.stack((t.sin(), -t.sin()), 1),
            torch.zeros(240, 2),
        ),
        1,
    )
    seen = comparison.hand_swing(
        data.layout, torch.stack([joints_of(0.2 * swings[:, i], data.layout) for i in range(3)], 1)
    )
    assert seen["together"][:2].tolist() == pytest.approx([1.0, -1.0], abs=1e-5)
    assert math.isnan(seen["together"][2])
    assert seen["range"][:, 0].tolist() == pytest.approx(
        [0.2 / math.sqrt(2), 0.2 / math.sqrt(2), 0.0], abs=1e-5
    )


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


def test_numbers_of_an_even_blend_and_of_a_jump():
    even = torch.linspace(0, 1, 11)[None]
    jump, reluctant = (even > 0.95).float(), 0.45 * even
    smooth = interpolation.Curves(even, even).numbers()
    assert (smooth["widest step"], smooth["crosses at"]) == (pytest.approx(0.1), pytest.approx(0.6))
    assert smooth["rank corr."] == pytest.approx(1.0)
    sudden = interpolation.Curves(jump, even).numbers()
    assert (sudden["widest step"], sudden["crosses at"]) == (1.0, pytest.approx(1.0))
    never = interpolation.Curves(
        reluctant, even
    ).numbers()  # the second style is never recognised: nothing to say
    assert never["of 1 pairs"] == 0
    assert math.isnan(never["widest step"])


def test_the_mean_pose_of_arms_and_its_floor(data):
    """A raised shoulder and a moved hand, known to the millimetre."""
    layout, still = data.layout, torch.zeros(240, 2)
    rest = joints_of(still, layout)
    other, lifted = rest.clone(), rest.clone()
    side = layout.names.index(layout.skeleton.roles["left_hand"])
    arm = [
        layout.names.index(layout.skeleton.roles[f"left_{part}"])
        for part in ("shoulder", "elbow", "hand")
    ]
    other[:, side, 2] += 0.1
    lifted[:, arm, 1] += 0.04  # the whole arm, so the clavicle alone is wrong

    def packed(positions):
        nothing = torch.zeros_like(positions)
        return pack_joints(positions, nothing, nothing, nothing)

    clips = torch.stack([packed(rest), packed(other)])
    found = posture_error(layout, packed(lifted), clips[:1], 0.0)
    assert found == pytest.approx(
        {"clavicle": 0.02, "hand": 0.0, "clavicle_data": 0.0, "hand_data": 0.0}, abs=1e-6
    )
    found = posture_error(layout, packed(rest), clips, 0.0)
    assert found == pytest.approx(
        {"clavicle": 0.0, "hand": 0.025, "clavicle_data": 0.0, "hand_data": 0.05}, abs=1e-6
    )


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
