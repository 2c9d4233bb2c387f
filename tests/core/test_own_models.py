"""Models of one's own (`toolkit.networks.Predictor`): those of examples/models.

tests/docs trains the low-rank one.
"""

import runpy
import sys
from pathlib import Path

import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit import registry
from toolkit.training import Config

EXAMPLES = Path(__file__).parents[2] / "examples" / "models"
NAMES = {"flow-transformer": "local", "vq-codebook": "local", "gru": "none"}


@pytest.fixture(scope="module", params=NAMES)
def run(request, two_styles, small_run):
    """A model of `NAMES` after 70 steps or more; later tests of the same process do not know it."""
    runpy.run_path(str(EXAMPLES / f"{request.param.replace('-', '_')}.py"), run_name="own")
    steps = 90 if request.param == "gru" else 70
    config = Config.quick(model=request.param, steps=steps, refit=5, sizes=small_run.model.sizes)
    yield tk.training.fit(two_styles, config)
    del registry._found[f"model.{request.param}"]


def test_it_learns_walks_and_blends(run):
    model, bank = run
    assert model.layout.phase == NAMES[model.name]
    for row in run.table():
        assert row["error"] < 0.8 * row["mean"]
    half = bank.blend({"Neutral": 0.5, "Zombie": 0.5})
    clip = tk.runtime.rollout(model, tk.runtime.straight(1.0, 0.2), half)
    assert clip.global_positions.isfinite().all()
    together, alone = ([*tk.runtime.states(model, tk.runtime.straight(1.0, 0.05), style)][-1]
                       for style in (bank.vectors, bank["Zombie"]))
    torch.testing.assert_close(together.joints[1:], alone.joints, atol=1e-3, rtol=1e-3)


def test_its_file_names_the_module_and_runs_no_code(run, tmp_path, monkeypatch):
    path = tmp_path / "run.safetensors"
    run.save(path, slim=True)
    again = tk.training.load(path)
    assert type(again.model) is type(run.model)
    x, p, style = (torch.randn(3, n) for n in (
        run.model.layout.n_inputs, run.model.layout.n_phases, run.model.style_size))
    torch.testing.assert_close(again.model.predict(x, p, style), run.model.predict(x, p, style),
                               atol=1e-2, rtol=1e-2)  # the experts are stored in 16 bits
    clips = torch.randn(2, 240, run.model.layout.n_clip)
    assert torch.equal(again.model.style_vector(clips, 1), run.model.style_vector(clips, 1))
    monkeypatch.delitem(registry._found, f"model.{run.model.name}")
    with refusal("import the module that registers it, 'own', before"):
        tk.training.load(path)


@pytest.fixture(scope="module")
def penguin():
    return tk.features.build(tk.datasets.procedural.generate("Penguin"))


def test_a_style_is_added_to_it(run, penguin, monkeypatch):
    monkeypatch.setattr("toolkit.styles.fine_tuning.WALK", (1.0, 0.5))
    new = tk.styles.fine_tune(run.model, penguin, bank=run.bank, steps=8)
    assert new.method == "vector"
    assert new.bank.names == ("Neutral", "Zombie", "Penguin")
    assert new.losses[-1] < new.losses[0]


def test_the_command_line_trains_a_model_of_ones_own_and_walks_with_it(
        tmp_path, monkeypatch, command):
    folder = tmp_path / "my files"
    folder.mkdir()
    (folder / "my_gru.py").write_bytes((EXAMPLES / "gru.py").read_bytes())
    monkeypatch.setattr(sys, "path", sys.path.copy())
    monkeypatch.chdir(tmp_path)
    train = ("train --data procedural --styles Neutral --gaits FW --clip-seconds 12 --small "
             "--epochs 0.5 --refit 0 --out g.st --model")
    said = command(train, "my files/none.py:gru", status=2).err
    assert "there is no file my files/none.py" in said
    command(train, "my files/my_gru.py:gru")
    monkeypatch.delitem(registry._found, "model.gru")
    walk = "rollout --style Neutral --seconds 0.1 --out walk.bvh --model"
    assert "name it before the file: my_gru:g.st" in command(walk, "g.st", status=2).err
    (tmp_path / "no:model.st").touch()  # a file whose name has a colon is no module
    assert "no:model.st" in command(walk, "no:model.st", status=2).err
    monkeypatch.delitem(sys.modules, "my_gru")
    command(walk, "my_gru:g.st")  # the folder is known by now
    monkeypatch.delitem(registry._found, "model.gru")
    monkeypatch.delitem(sys.modules, "my_gru")
