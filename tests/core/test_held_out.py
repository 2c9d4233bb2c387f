"""Finished models on held-out motion: recordings that they follow, and fitted style vectors."""

import json
from dataclasses import asdict, replace

import pytest
import torch
from refusal import refusal
from test_training import QUICK, waves

from experiments.seven_models import models
from toolkit import training
from toolkit.features import splits
from toolkit.training.loss import BATCH, STEPS, refit


def test_the_rate_of_the_style_modulation_is_that_of_the_model():
    for model, rate in (("lpn-film", 0.1), ("pfnn-resad", 1.0), ("lpn-onehot", 10.0)):
        assert training.Config.quick(model=model).style_rate == rate
        assert models.Plan().config(model, 0).style_rate == rate
    assert training.Config.quick(model="lpn-resad", style_rate=0.5).style_rate == 0.5


def test_a_training_ends_with_fitted_vectors_of_less_error_and_the_model_stays_the_same():
    data, config = waves(), replace(QUICK, steps=20)
    plain, fitted = (training.fit(data, replace(config, refit=n)) for n in (0, 30))
    assert fitted.table()[-1]["error"] < plain.table()[-1]["error"]
    train, _ = training.split(data, config.held_out, config.seed, tuple(data.styles))
    before = {name: value.clone() for name, value in plain.model.state_dict().items()}
    bank = refit(plain.model, plain.bank, train, 30, config.seed, config.pose_mixup)
    assert torch.equal(bank.vectors, fitted.bank.vectors)
    for model in (plain.model, fitted.model):
        assert all(torch.equal(value, before[name]) for name, value in model.state_dict().items())
        assert all(p.requires_grad for p in model.parameters())
    part = refit(plain.model, plain.bank, only(train, "style1"), steps=2)
    assert torch.equal(part["style0"], plain.bank["style0"])
    assert not torch.equal(part["style1"], plain.bank["style1"])


def only(data, *names):
    """Features of some of the styles."""
    rows = {name: torch.ones(len(data.inputs[name]), dtype=torch.bool) for name in names}
    return splits.select(data, rows)


@pytest.mark.parametrize("names", [("style0",), ("style0", "style1")])
def test_a_fit_begins_with_steps_of_six_hundredths_of_the_deviation_between_styles(names, capsys):
    data, run = only(waves(), *names), training.fit(waves(), replace(QUICK, steps=2))
    bank = run.bank.select(names)
    one = refit(run.model, bank, data, steps=1)
    quick = training.Config.quick()
    same = refit(run.model, bank, data, 1, quick.seed, quick.pose_mixup)
    assert torch.equal(one.vectors, same.vectors)
    assert capsys.readouterr().err == ""  # no bar, unless it is asked for
    apart = float(bank.vectors.std(0).mean()) if len(names) > 1 else 1.0
    gone = (one.vectors - bank.vectors).abs().median()  # Adam's first step is as long as its rate
    assert float(gone) == pytest.approx(0.06 * apart, rel=1e-2)
    two = refit(run.model, bank, data, steps=2)  # the second step is half as long
    assert (two.vectors - bank.vectors).abs().max() < 1.6 * 0.06 * apart


def test_vectors_are_fitted_by_default_but_not_of_older_files_nor_of_tables():
    assert training.Config().refit == training.Config.quick().refit == STEPS == 30
    assert BATCH == 64
    stored = json.loads(json.dumps(asdict(QUICK)))
    older = {name: value for name, value in stored.items() if name != "refit"}
    assert training.Config.from_json(older).refit == 0
    data = waves()
    table = training.fit(data, replace(QUICK, model="lpn-resad", steps=5, refit=3))
    assert torch.equal(table.bank.vectors, training.make_bank(table.model, data).vectors)
    with refusal(r"refit must be a whole number from 0 to 1e\+30, got -1"):
        replace(QUICK, refit=-1)
