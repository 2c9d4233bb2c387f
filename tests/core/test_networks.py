import dataclasses
import json

import pytest
import torch
import unchanged
from refusal import refusal
from safetensors.torch import load_file, save_file
from torch.nn import functional
from torch.testing import assert_close

from toolkit import networks
from toolkit.features import Layout, Normaliser
from toolkit.io import model_files
from toolkit.motion import Skeleton
from toolkit.networks import BlendedLinear, Film, FilmGenerator, Sizes

TINY = Sizes(hidden=16, experts=3, gating=8, film_channels=4, film_kernel=5, film_dense=8)


def tree(joints: int) -> Layout:
    """A layout of a chain of joints."""
    roles = {"hips": "joint0", "left_hand": "joint1", "right_hand": "joint2",
             "left_foot": "joint3", "right_foot": "joint0"}
    names, parents = [f"joint{j}" for j in range(joints)], [-1, *range(joints - 1)]
    return Layout(Skeleton(names, parents, torch.full((joints, 3), 0.1), roles))


def tiny_model(joints: int = 4, name: str = "lpn-film", **changes) -> networks.Model:
    torch.manual_seed(0)
    phase = {"l": "local", "p": "global", "m": "none"}[name[0]]
    layout = dataclasses.replace(tree(joints), phase=phase)
    widths = {"inputs": layout.n_inputs, "phases": layout.n_phases, "outputs": layout.n_outputs,
              "clips": layout.n_clip}
    normalisers = {kind: Normaliser(torch.randn(width), torch.rand(width) + 0.5)
                   for kind, width in widths.items()}
    return networks.build(name, layout, 2, TINY, normalisers, **changes)


def something(model: networks.Model) -> tuple[torch.Tensor, ...]:
    """Three input frames, phases and style vectors for a model."""
    widths = model.layout.n_inputs, model.layout.n_phases, model.style_size
    return tuple(torch.randn(3, width) for width in widths)


FILM = 39_214_592  # the paper prints 35,668,530


def test_parameter_counts_are_those_of_table_2():
    dense = (15_360 * 2048 + 2048) + (2048 * 2048 + 2048)
    for row in networks.table2():  # the numbers of the paper are those of its `printed`
        counted = row.synthesis, row.style, row.per_style
        film = row.name.endswith("film")
        assert counted == tuple(FILM if n == 35_668_530 else n for n in row.printed)
        assert ("without its input channels" in row.note) == film
        if film:  # the convolutions without input channels
            assert row.style == (300 * 256 * 25 + 256) + (256 * 256 * 25 + 256) + dense
            assert row.style_as_printed == row.printed[1] == 2 * (256 * 25 + 25) + dense


@pytest.mark.parametrize("layer", [0, 1])
def test_film_equation(layer):
    torch.manual_seed(2)
    f, style = torch.randn(3, 16).double(), torch.randn(3, 64).double()
    got = Film(16, None)(layer, f, style)
    for n in range(3):
        gamma, beta = style[n].view(2, 2, 16)[layer]
        a = gamma * (f[n] - f[n].mean()) / (f[n].std(correction=1) + 1e-6) + beta
        assert_close(got[n], functional.elu(a), rtol=1e-12, atol=1e-14)


def test_generator_is_two_pooled_convolutions_and_two_dense_layers():
    torch.manual_seed(3)
    psi = FilmGenerator(6, 20, 4, 3, 5, 7, 0.3).double().eval()
    clip = torch.randn(1, 20, 6).double()
    h = clip.mT
    for layer in (psi.first, psi.second):
        h = functional.conv1d(h, layer.weight, layer.bias, padding=2).relu()
        h = functional.max_pool1d(h, 2)
    h = h[0].T.flatten()  # time-major
    h = (psi.dense.weight @ h + psi.dense.bias).relu()
    expected = psi.out.weight @ h + psi.out.bias
    assert_close(psi(clip)[0], expected, rtol=1e-11, atol=1e-13)


def test_dropout_acts_on_every_layers_input_only_in_training():
    model = tiny_model()
    x, p, s = torch.randn(2, model.layout.n_inputs), torch.randn(2, 8), torch.randn(2, 64)
    assert torch.equal(model(x, p, s), model(x, p, s))
    rates = []
    for module in model.modules():
        if isinstance(module, torch.nn.Dropout):
            module.register_forward_hook(lambda m, _, out: rates.append((m.p, out.shape[-1])))
    model.train()(x, p, model.encode(torch.randn(2, 240, model.layout.n_clip)))
    widths = [8, 8, 8, 8, model.layout.n_inputs, 16, 16]  # generator, gating, experts
    assert rates == [(0.3, width) for width in widths]


def test_style_vector_is_the_mean_over_clips():
    model = tiny_model()
    clips = torch.randn(40, 240, model.layout.n_clip)
    each = torch.stack([model.style_vector(clips[i : i + 1]) for i in range(40)])
    mean = model.style_vector(clips)
    assert_close(mean, each.mean(0), rtol=1e-4, atol=1e-5)
    assert torch.equal(model.train().style_vector(clips), mean)


@pytest.mark.parametrize("name", [name for name in networks.MODELS if not name.endswith("film")])
def test_tables_are_looked_up_by_number(name):
    model = tiny_model(name=name)
    rows = model.modulation.generator.vectors
    assert rows.shape == (2, model.style_size)
    assert not torch.equal(rows[0], rows[1])
    assert torch.equal(model.encode(None, 1), rows[1:])
    several = model.encode(torch.zeros(5, 240, 48), torch.tensor([1, 0, 1]))
    assert torch.equal(several, rows[[1, 0, 1]])
    assert torch.equal(model.style_vector(torch.zeros(5, 240, 48), 0), rows[0])
    with refusal(r"has styles 0 to 1, got \[2\]"):
        model.encode(None, 2)
    with refusal("has a table of 2 styles"):
        model.encode(torch.zeros(1, 240, 48))


def test_layouts_of_other_phases():
    layout = tree(4)
    for kind, width, phases in (("local", 90, 8), ("global", 75, 1), ("none", 74, 0)):
        own = dataclasses.replace(layout, phase=kind)
        assert (own.n_outputs, own.n_phases) == (width, phases)
        assert dataclasses.replace(tree(25), phase=kind).n_outputs == width + 252
        assert Layout.from_json(own.to_json()) == own
        assert (own == layout) == (kind == "local")
    old = layout.to_json()
    del old["phase"]
    assert Layout.from_json(old) == layout
    with refusal("is one of local, global, none; got 'lokal'"):
        Layout(layout.skeleton, "lokal")


def test_velocities_of_hands_and_feet_are_what_mann_looks_at():
    layout = tree(4)
    joints = torch.zeros(4, 4, 3)
    # the roles of the tree, in the order of the phases
    joints[[1, 2, 3, 0], 3] = torch.arange(1.0, 13.0).view(4, 3)
    x = layout.pack_input(trajectory=torch.zeros(48), joints=joints.flatten())
    assert x[layout.limb_velocities].tolist() == list(range(1, 13))


def test_wrong_clips_sizes_and_normalisers():
    model = tiny_model()
    with refusal(r"\[M, 240, 48\], got \[1, 100, 48\]"):
        model.style_vector(torch.zeros(1, 100, 48))
    with refusal("hidden must be a whole number from 1, got 0"):
        Sizes(hidden=0)
    wrong = Normaliser(torch.zeros(3), torch.ones(3))
    with refusal("normaliser of phases needs 8 columns"):
        networks.build("lpn-film", tree(4), 2, TINY, {"phases": wrong})


def store(model, path, **options):
    """As a part of a run's file."""
    tensors, description = model.parts(**options)
    model_files.write(path, tensors, {"model": description})


def load(path):
    return networks.Model.from_parts(path, *model_files.read(path, "model"))


def test_the_same_content_in_another_order_gives_the_same_bytes(tmp_path):
    parts, one, two = {"model": {}, "bank": ["b"], "run": 1}, tmp_path / "one", tmp_path / "two"
    model_files.write(one, {"model.x": torch.zeros(2)}, parts)
    model_files.write(two, {"model.x": torch.zeros(2)}, dict(reversed(parts.items())))
    assert one.read_bytes() == two.read_bytes()


def test_bad_model_files_are_one_line(tmp_path):
    path = tmp_path / "m.safetensors"
    model = tiny_model()
    store(model, path)

    def fails(match: str) -> None:
        with refusal(match) as error:
            load(path)
        assert str(path) in str(error.value)

    tensors = load_file(path)
    good = {"format": json.dumps("x"), "model": json.dumps(model.parts()[1])}
    save_file(tensors, path, good)
    fails("expected the format 'toolkit 1'")
    good["format"] = "toolkit 1"
    save_file(tensors, path, good | {"model": json.dumps(model.parts()[1] | {"name": "os.system"})})
    fails("it holds a model 'os.system', which is not registered")
    path.write_bytes(b"\x80\x04cos\nsystem\n(S'touch owned'\ntR.")  # a pickle
    fails("not a whole safetensors file")


@pytest.mark.parametrize("name", networks.MODELS)
def test_each_model_predicts_learns_and_is_stored(name, tmp_path):
    model = tiny_model(name=name)
    x, p, s = something(model)
    s, clips = s[0], torch.randn(2, 240, 48)

    # the normalisers are inside, and dropout is never on
    got = model.predict(x, p, s)
    normal = (x - model.inputs_mean) / model.inputs_std, (p - model.phases_mean) / model.phases_std
    right = model(*normal, s[None]) * model.outputs_std + model.outputs_mean
    assert_close(got, right)
    assert_close(model.predict(x[:1], p[:1], s), got[:1], rtol=1e-4, atol=1e-5)
    assert not got.requires_grad
    assert torch.equal(model.train().predict(x, p, s), got)
    assert model.training

    # every parameter can learn
    phases, z = model.observe(torch.randn(3, 8), torch.randn(3, tree(4).n_outputs))
    (model(x, phases, model.encode(clips[:1], 1)) - z).square().mean().backward()
    assert all(parameter.grad is not None for parameter in model.parameters())
    model.eval()

    # a file holds all of it, or all but generator and table
    store(model, tmp_path / "m.safetensors")
    again = load(tmp_path / "m.safetensors")
    assert torch.equal(again.predict(x, p, s), model.predict(x, p, s))
    assert torch.equal(again.style_vector(clips, 1), model.style_vector(clips, 1))
    assert (again.name, again.layout, again.sizes, again.n_styles) == (name, model.layout, TINY, 2)
    assert not again.training
    assert all(v.requires_grad for v in again.parameters())
    store(model, tmp_path / "slim.safetensors", generator=False)
    slim = load(tmp_path / "slim.safetensors")
    assert torch.equal(slim.predict(x, p, s), model.predict(x, p, s))
    missing = "FiLM generator" if name.endswith("film") else "table of styles"
    with refusal(f"stored without its {missing}"):
        slim.style_vector(clips, 0)


def test_a_calibrated_model_computes_the_mean_over_dropout():
    """Against 20,000 samples of dropout, for a model whose only dropped layer is the second."""
    torch.manual_seed(3)
    film, n = Film(6, None), 20_000
    layer, style = BlendedLinear(2, 40, 6), torch.randn(24)
    x, gates = torch.randn(1, 40), torch.tensor([[0.3, 0.7]])
    q = 0.3 / 0.7
    with torch.no_grad():
        f = layer(functional.dropout(x.expand(n, -1), 0.3), gates.expand(n, -1))
        variance = q * layer.scatter(x, gates)
        assert_close(f.var(0), variance[0], rtol=0.05, atol=0)
        mean = layer(x, gates)
        gamma, beta = style[:6], style[6:12]
        scale = (mean.var(-1) + variance.mean(-1)).sqrt() + 1e-6
        normal = mean + torch.randn(n, 6) * variance.sqrt()
        slow = functional.elu(gamma * (normal - mean.mean()) / scale + beta).mean(0)
        assert_close(film.expected(0, mean, style, variance)[0], slow, rtol=0.05, atol=0.02)
    several, other = torch.randn(3, 6), torch.rand(3, 6)  # each frame has its own variance
    rows = [film.expected(1, a[None], style, b[None]) for a, b in zip(several, other, strict=True)]
    assert_close(film.expected(1, several, style, other), torch.cat(rows))
    model = tiny_model()
    x, p, s = something(model)
    plain = model.predict(x, p, s)
    model.calibrated = True
    assert (model.predict(x, p, s) - plain).abs().max() > 1e-3
    description = model.parts()[1]
    assert description["calibrated"]
    assert networks.Model.from_parts("m", model.parts()[0], {"model": description}).calibrated


@pytest.mark.parametrize("name", networks.MODELS)
def test_models_start_and_compute_as_they_did(name):
    model = tiny_model(name=name)
    rows, clips = something(model), torch.randn(5, 240, model.layout.n_clip)
    unchanged.check(f"weights of {name}", model.state_dict(), near=1e-4)
    vectors = [model.style_vector(clips[:n], number) for n, number in ((1, 0), (5, 1))]
    found = [vectors, model.predict(*rows)]
    if name == "lpn-film":
        model.calibrated = True
        found.append(model.predict(*rows))
    unchanged.check(f"predictions of {name}", found, near=1e-4)
