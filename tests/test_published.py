"""The authors' parameters through our networks, features and phases: the strongest check that they mean the same."""

import math

import numpy as np
import pytest
import torch

import toolkit as tk
from experiments import closed_loop
from toolkit import runtime
from toolkit.__main__ import main
from toolkit.datasets import parameters, style100


@pytest.fixture(scope="module")
def published(shared):
    return tk.published.load(shared / "lpn_film_100style")


@pytest.fixture(scope="module")
def walk(shared):
    return tk.bvh.load(shared / "100style" / "Neutral_FW.bvh")


@pytest.fixture
def crouch_file(tmp_path):
    tk.bvh.save(tk.datasets.load("procedural", styles=["Crouch"], gaits=["FW"], seconds=6.0)[0], tmp_path / "crouch.bvh")
    return tmp_path / "crouch.bvh"


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
            gamma, beta = (read(f"Style_{index:03d}_{kind}{i + 1}", 512) for kind in ("scale", "shift"))
            f = torch.nn.functional.elu(gamma * (f - f.mean()) / (f.std() + 1e-6) + beta)
    return f * read("Ystd", -1) + read("Ymean", -1)


def test_outputs_equal_the_equations_in_float64(published, walk, shared):
    model, bank = published
    rows = tk.features.frames(walk, None, 400, 412)
    for style in ("Neutral", "Zombie", "WildArms"):
        index = bank.names.index(style)
        expected = torch.stack([direct(shared / "lpn_film_100style", x, p, index)
                                for x, p in zip(rows.inputs, rows.phases, strict=True)])
        got = model.predict(rows.inputs, rows.phases, bank[style]).double()
        assert float((got - expected).norm() / expected.norm()) < 1e-5


def test_style_names_are_in_the_published_order(shared):
    names = set(style100.styles(shared / "100style"))
    assert list(tk.published.STYLES) == sorted(names - set(style100.HELD_OUT)) + list(style100.HELD_OUT)


def test_one_step_ahead_of_real_motion(published, walk):
    model, bank = published
    assert model.layout.samples[6:] == (0, 12, 24, 36, 48, 60)
    own = tk.published.one_step(model, bank, walk, style="Neutral", frames=(327, 1200))
    assert own["frames"] == 812
    assert own["joint_mse"] <= 0.042
    assert min(own["contact_correlation"]) >= 0.91
    assert own["phase_error"] <= 0.20
    for other in ("Zombie", "Aeroplane"):
        wrong = tk.published.one_step(model, bank, walk, style=other, frames=(327, 1200))
        assert wrong["joint_mse"] >= 5 * own["joint_mse"]


def test_calibration_halves_the_error_one_step_ahead(shared, walk):
    model, bank = tk.published.load(shared / "lpn_film_100style", calibrated=True)
    own = tk.published.one_step(model, bank, walk, style="Neutral", frames=(327, 1200))
    assert own["joint_mse"] <= 0.022
    assert min(own["contact_correlation"]) >= 0.91
    assert own["phase_error"] <= 0.20


def test_styles_have_the_published_speeds(published):
    _, bank = published
    assert bank.speed("Neutral") == pytest.approx(0.62, abs=0.005)
    known = [bank.speed(name) for name in tk.published.STYLES[:95]]
    assert bank.speed("Skip") == pytest.approx(sum(known) / 95)  # not published
    mixed = 0.25 * bank.speed("Old") + 0.75 * bank.speed("Neutral")
    assert bank.speed({"Old": 0.25, "Neutral": 0.75}) == pytest.approx(mixed)
    assert bank.select(["Old", "Cat"]).speed("Old") == bank.speed("Old")


def test_feet_of_real_motion(walk):
    real = tk.metrics.feet(walk.cut(327))
    assert real["skate"] < 0.03
    assert 0.09 < real["clearance"] < 0.12
    assert 1.3 < real["steps"] < 1.6
    with pytest.raises(ValueError, match="have the shape"):
        tk.metrics.feet(walk, torch.ones(3, 2))


def test_toes_in_contact_stand(published):
    """Ten styles, at one metre a second: the median toe in contact moves by less than 2 cm/s, and the worst by 5."""
    model, bank = published
    styles = ["Neutral", "Old", "LeftHop", "RightHop", "TwoFootJump", "FairySteps", "Zombie", "Lunge", "HighKnees", "March"]
    run = list(runtime.states(model, runtime.straight(1.0, 9.0), bank.select(styles).vectors))[240:]
    skates = []
    for i in range(len(styles)):
        clip = runtime.record(model, run, character=i)
        skates.append(tk.metrics.feet(clip, torch.stack([state.contacts[i] for state in run]))["skate"])
    assert sorted(skates)[len(skates) // 2] < 0.005
    assert max(skates) < 0.05


@pytest.mark.parametrize("calibrated", [False, True])
def test_predicted_toes_in_contact_move_from_real_input_already(shared, walk, calibrated):
    """Four times as fast as the real ones: no runtime can bring the prediction before foot IK to 1.5 cm/s."""
    model, bank = tk.published.load(shared / "lpn_film_100style", calibrated=calibrated)
    found = closed_loop.ahead(model, bank["Neutral"], walk, 327)
    assert found["skate"] < 0.02
    assert 0.06 < found["before"] < 0.09


def test_a_minute_of_walking_stays_on_its_feet(published):
    model, bank = published
    clip = tk.runtime.rollout(model, tk.runtime.straight(speed=1.2, seconds=60), style=bank["Neutral"])
    low, high = tk.metrics.hips_height(clip)
    assert len(clip) == 3600
    assert low >= 0.90
    assert high <= 1.02
    assert 0.9 <= tk.metrics.speed(clip) <= 1.6
    assert tk.metrics.upright(clip)


def test_all_styles_but_drunk_walk_upright(published):
    model, bank = published
    others = [i for i, name in enumerate(bank.names) if name != "Drunk"]
    state = tk.runtime.start(model, bank.vectors[others])
    hips = model.layout.names.index("Hips")
    first = state.root[:, :2]
    with torch.inference_mode():
        for command in tk.runtime.straight(speed=1.0, seconds=20)[::1]:
            state = tk.runtime.step(model, state, command)
            height = tk.features.split_joints(state.joints)["position"][:, hips, 1]
            assert bool(torch.isfinite(state.joints).all())
            assert float(height.min()) > 0.5
            assert float(height.max()) < 1.25
    assert float((state.root[:, :2] - first).norm(dim=-1).min()) > 20 * 0.4


def test_a_style_is_added_to_the_published_network(published, shared, tmp_path, crouch_file):
    model, bank = published
    out = tmp_path / "more.safetensors"
    folder = str(shared / "lpn_film_100style")
    said = ["style", "add", "--published", folder, "--clips", str(crouch_file), "--name", "Mine", "--steps", "2"]
    with pytest.raises(SystemExit, match=r"^0$"):
        main([*said, "--out", str(out)])
    added = tk.training.load(out)
    assert added.bank.names == (*bank.names, "Mine")
    assert torch.equal(added.bank.vectors[:-1], bank.vectors)
    assert all(torch.equal(new, old) for new, old in zip(added.model.parameters(), model.parameters(), strict=True))


@pytest.mark.filterwarnings("always:the character hardly walks")
@pytest.mark.parametrize(("style", "doubted"), [("Drunk", True), ("Depressed", False)])
def test_a_style_that_hardly_walks_is_doubted(shared, tmp_path, capsys, style, doubted):
    folder, out = str(shared / "lpn_film_100style"), str(tmp_path / "walk.bvh")
    with pytest.raises(SystemExit, match=r"^0$"):
        main(["rollout", "--published", folder, "--style", style, "--seconds", "4", "--out", out])
    assert ("the character hardly walks" in capsys.readouterr().err) == doubted


def test_missing_and_damaged_files_are_named(tmp_path):
    with pytest.raises(ValueError, match="no such folder"):
        tk.published.load(tmp_path / "nowhere")
    with pytest.raises(ValueError, match=r"Xmean\.bin: missing; expected 348 float32"):
        tk.published.load(tmp_path)
    for name, shape in parameters.SHAPES.items():
        with (tmp_path / f"{name}.bin").open("wb") as file:
            file.truncate(4 * math.prod(shape))
    assert parameters.check(tmp_path) == "parameters of 100 styles"
    torch.full((348,), math.nan).numpy().tofile(tmp_path / "Xmean.bin")
    with pytest.raises(ValueError, match=r"Xmean\.bin: expected 348 float32 numbers that are finite"):
        tk.published.load(tmp_path)


def test_sizes_are_checked_before_anything_is_read(tmp_path, monkeypatch):
    for name, shape in parameters.SHAPES.items():
        with (tmp_path / f"{name}.bin").open("wb") as file:
            file.truncate(4 * math.prod(shape))
    monkeypatch.setattr(np, "fromfile", lambda *_: pytest.fail("a file was read"))
    for name in ("Xmean", "Walk_Velocities"):
        with (tmp_path / f"{name}.bin").open("r+b") as file:
            file.truncate(2_500_000_000)
        with pytest.raises(ValueError, match=rf"{name}\.bin: expected .* float32 numbers, got 2,500,000,000 bytes"):
            tk.published.load(tmp_path)
        with (tmp_path / f"{name}.bin").open("r+b") as file:
            file.truncate(4 * math.prod(parameters.SHAPES[name]))
