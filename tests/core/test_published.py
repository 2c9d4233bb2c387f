"""The authors' parameters through our networks, features and phases."""

import copy
import dataclasses
import math

import numpy as np
import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit import runtime
from toolkit.datasets import fetch, published_files as parameters, style100


@pytest.fixture(scope="module")
def published(shared):
    return tk.published.load(shared / "lpn_film_100style")


@pytest.fixture(scope="module")
def walk(shared):
    return tk.bvh.load(shared / "100style" / "Neutral_FW.bvh")


def direct(folder, x, phases, index):
    """The equations of section 4, written out sample by sample in float64 from the raw files."""
    def read(name, *shape):
        return torch.from_numpy(np.fromfile(folder / f"{name}.bin", "<f4").reshape(shape)).double()

    h = (phases.double() - read("GT_Xmean", -1)) / read("GT_Xstd", -1)
    for i, (n, m) in enumerate([(8, 32), (32, 32), (32, 8)]):
        h = read(f"wc{i}_w", m, n) @ h + read(f"wc{i}_b", m)
        h = torch.nn.functional.elu(h) if i < 2 else torch.softmax(h, 0)
    f = (x.double() - read("Xmean", -1)) / read("Xstd", -1)
    for i, (n, m) in enumerate([(348, 512), (512, 512), (512, 342)]):
        weight = sum(h[k] * read(f"cp{i}_a{k}", m, n) for k in range(8))
        f = weight @ f + sum(h[k] * read(f"cp{i}_b{k}", m) for k in range(8))
        if i < 2:
            style = f"Style_{index:03d}"
            gamma, beta = (read(f"{style}_{kind}{i + 1}", 512) for kind in ("scale", "shift"))
            f = torch.nn.functional.elu(gamma * (f - f.mean()) / (f.std() + 1e-6) + beta)
    return f * read("Ystd", -1) + read("Ymean", -1)


def test_outputs_equal_the_equations_in_float64(published, walk, shared):
    model, bank = published
    rows = tk.features.frames(walk.cut(340, 456))  # of five frames
    for style in ("Neutral", "Zombie", "WildArms"):
        index = bank.names.index(style)
        expected = torch.stack([direct(shared / "lpn_film_100style", x, p, index)
                                for x, p in zip(rows.inputs, rows.phases, strict=True)])
        got = model.predict(rows.inputs, rows.phases, bank[style]).double()
        assert float((got - expected).norm() / expected.norm()) < 1e-5


def test_style_names_are_in_the_published_order(shared):
    names = set(style100.styles(shared / "100style"))
    held_out = list(style100.HELD_OUT)
    assert list(tk.published.STYLES) == sorted(names - set(held_out)) + held_out


def test_one_step_ahead_of_real_motion(published, walk):
    model, bank = published
    assert model.layout.samples[6:] == (0, 12, 24, 36, 48, 60)
    own = tk.published.one_step(model, bank, walk, style="Neutral", frames=(327, 1200))
    assert own["frames"] == 812
    assert own["joint_mse"] <= 0.042
    again = dataclasses.replace(published, model=copy.copy(model))
    again.model.calibrated = True  # halves the error
    calibrated = tk.published.one_step(*again, walk, style="Neutral", frames=(327, 1200))
    assert calibrated["joint_mse"] <= 0.022
    for found in (own, calibrated):
        assert min(found["contact_correlation"]) >= 0.91
        assert found["phase_error"] <= 0.20
    wrong = tk.published.one_step(model, bank, walk, style="Zombie", frames=(327, 1200))
    assert wrong["joint_mse"] >= 5 * own["joint_mse"]


def test_styles_have_the_published_speeds(published):
    assert published.table() == []  # nor are their errors
    _, bank = published
    assert bank.speed("Neutral") == pytest.approx(0.62, abs=0.005)
    known = [bank.speed(name) for name in tk.published.STYLES[:95]]
    assert bank.speed("Skip") == pytest.approx(sum(known) / 95)  # not published
    mixed = 0.25 * bank.speed("Old") + 0.75 * bank.speed("Neutral")
    assert bank.speed({"Old": 0.25, "Neutral": 0.75}) == pytest.approx(mixed)
    assert bank.select(["Old", "Cat"]).speed("Old") == bank.speed("Old")


def test_all_styles_but_drunk_walk_upright_with_toes_that_stand(published):
    """At one metre a second; toes in contact of ten styles move by 0.5 cm/s (the median)."""
    model, bank = published
    model = runtime.compile(model)
    others = range(0, 100, 10)
    hips = model.layout.names.index("Hips")
    run = list(runtime.states(model, runtime.straight(1.0, 6.0), bank.vectors[others]))
    for state in run:
        height = tk.features.split_joints(state.joints)["position"][:, hips, 1]
        assert torch.isfinite(state.joints).all()
        assert height.min() > 0.5
        assert height.max() < 1.25
    walked = (run[-1].root[:, :2] - run[0].root[:, :2]).norm(dim=-1)
    assert walked.min() > 6 * 0.35
    skates = []
    for i in range(10):
        clip = runtime.record(model, run[240:], character=i)
        contacts = torch.stack([state.contacts[i] for state in run[240:]])
        skates.append(tk.metrics.feet(clip, contacts)["skate"])
    assert sorted(skates)[5] < 0.005
    assert max(skates) < 0.05
    clip = runtime.record(model, run, character=others.index(50))
    assert bank.names[50] == "Neutral"
    low, high = tk.metrics.hips_height(clip)
    assert low >= 0.90
    assert high <= 1.02
    assert 0.7 <= tk.metrics.speed(clip) <= 1.3
    assert tk.metrics.upright(clip)


@pytest.mark.filterwarnings("always:the character hardly walks")
@pytest.mark.parametrize(("style", "doubted"), [("Drunk", True), ("Depressed", False)])
def test_a_style_that_hardly_walks_is_doubted(shared, tmp_path, command, style, doubted):
    words = f"rollout --style {style} --seconds 4 --out {tmp_path}/walk.bvh --published"
    said = command(words, shared / "lpn_film_100style").err
    assert ("the character hardly walks" in said) == doubted


def test_missing_and_damaged_files_are_named(tmp_path):
    for name, shape in parameters.SHAPES.items():
        with (tmp_path / f"{name}.bin").open("wb") as file:
            file.truncate(4 * math.prod(shape))
    assert fetch.find("lpn-film-100style").check(tmp_path) == "parameters of 100 styles"
    torch.full((348,), math.nan).numpy().tofile(tmp_path / "Xmean.bin")
    with refusal(r"Xmean\.bin: expected 348 float32 numbers that"):
        tk.published.load(tmp_path)
