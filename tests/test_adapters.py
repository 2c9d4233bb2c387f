"""The parts that the seven models are made of, against slow loops over samples."""

import math

import numpy as np
import pytest
import torch

from toolkit.networks import BlendedLinear, CatmullRom, Film, OneHot, ResidualAdapter, fold, layer_norm


def spline(points, phase):
    """Cubic Catmull-Rom through whole sets of weights, as Holden et al. 2017 write it (equation 7)."""
    k = len(points)
    along = k * (phase % math.tau) / math.tau
    at, w = int(along), along % 1
    a, b, c, d = (points[(at + n) % k] for n in (-1, 0, 1, 2))
    return (b + w * (c / 2 - a / 2) + w * w * (a - 5 / 2 * b + 2 * c - d / 2)
            + w**3 * (3 / 2 * b - 3 / 2 * c + d / 2 - a / 2))


@pytest.mark.parametrize("points", [4, 5, 8])
def test_a_layer_on_a_phase_equals_interpolating_whole_weight_sets(points):
    torch.manual_seed(0)
    layer, curve = BlendedLinear(points, 7, 6).double(), CatmullRom(points)
    torch.nn.init.normal_(layer.weight)
    torch.nn.init.normal_(layer.bias)
    x, phase = torch.randn(40, 7).double(), torch.linspace(-3.0, 10.0, 40).double()
    got = layer(x, curve(phase[:, None]))
    for n in range(40):
        expected = x[n] @ spline(layer.weight, float(phase[n])) + spline(layer.bias, float(phase[n]))
        torch.testing.assert_close(got[n], expected, rtol=1e-10, atol=1e-10)


def test_the_curve_is_closed_smooth_and_goes_through_its_points():
    curve = CatmullRom()
    torch.testing.assert_close(curve(torch.arange(4)[:, None] * math.tau / 4), torch.eye(4), atol=1e-6, rtol=0)
    phase = torch.linspace(-math.tau, 2 * math.tau, 3001).double()[:, None]
    gates = curve(phase)
    torch.testing.assert_close(gates, curve(phase + math.tau), atol=1e-12, rtol=0)
    torch.testing.assert_close(gates.sum(1), torch.ones(3001).double(), atol=1e-12, rtol=0)
    assert float(gates.min()) < -0.05  # not a convex blend, unlike a gating network's
    slope = gates.diff(dim=0) / phase.diff(dim=0)
    assert float(slope.diff(dim=0).abs().max()) < 0.02  # no corners
    with pytest.raises(ValueError, match="needs 4 control points or more, got 3"):
        CatmullRom(3)


def test_one_hot_is_a_label_beside_the_input():
    """Shifting the first layer equals a layer on (x, label) whose experts have rows of weights for the label."""
    torch.manual_seed(1)
    layer, label = BlendedLinear(3, 7, 6).double(), OneHot(3, 6, 4).double()
    f_gates = torch.randn(5, 3).double()
    x, styles = torch.randn(5, 7).double(), torch.tensor([2, 0, 3, 3, 1])
    got = label(0, layer(x, f_gates), label.generator(styles), x, f_gates)
    rows = label.generator.vectors.view(4, 3, 6)
    for n, style in enumerate(styles.tolist()):
        one_hot = torch.nn.functional.one_hot(torch.tensor(style), 4).double()
        weight = sum(f_gates[n, k] * torch.cat((layer.weight[k], rows[:, k])) for k in range(3))
        f = torch.cat((x[n], one_hot)) @ weight + sum(f_gates[n, k] * layer.bias[k] for k in range(3))
        torch.testing.assert_close(got[n], torch.where(f > 0, f, f.expm1()), rtol=1e-10, atol=1e-12)
    f = torch.randn(5, 6).double()
    torch.testing.assert_close(label(1, f, label.generator(styles), f, f_gates), torch.nn.functional.elu(f))


@pytest.mark.parametrize("rank", [None, 3])
def test_residual_adapter_equals_a_loop_over_samples(rank):
    torch.manual_seed(2)
    adapter = ResidualAdapter(6, 4, rank, 0).double()
    assert adapter.generator is None
    f, x, gates, style = (torch.randn(5, n).double() for n in (6, 6, 4, adapter.size))
    got = adapter(1, f, style, x, gates)
    for n in range(5):
        numbers = style[n].numpy()
        if rank is None:
            matrix, b = numbers[:36].reshape(6, 6), numbers[36:]
        else:  # the full matrix of its decomposition at this sample's phase
            v, c, u, b = np.split(numbers, np.cumsum([6 * rank, 4 * rank, 6 * rank]))
            matrix = v.reshape(6, rank) @ np.diag(gates[n].numpy() @ c.reshape(4, rank)) @ u.reshape(rank, 6)
        a = f[n].numpy() + x[n].numpy() @ matrix + b
        np.testing.assert_allclose(got[n], np.where(a > 0, a, np.expm1(a)), rtol=1e-10, atol=1e-12)
    torch.testing.assert_close(adapter(0, f, style, x, gates), torch.nn.functional.elu(f))


def test_only_the_coefficients_of_a_decomposition_follow_the_phase():
    torch.manual_seed(3)
    f, x = torch.randn(2, 5, 6).unbind(0)
    here, there = CatmullRom()(torch.tensor([[0.3], [2.0]])).unsqueeze(1).expand(2, 5, 4)
    for rank, follows in ((None, False), (3, True)):
        adapter = ResidualAdapter(6, 4, rank, 0)
        style = torch.randn(adapter.size)
        assert torch.equal(adapter(1, f, style, x, here), adapter(1, f, style, x, there)) != follows


@pytest.mark.parametrize("modulation", [Film(6, None), OneHot(4, 6, 0), ResidualAdapter(6, 4, None, 0),
                                        ResidualAdapter(6, 4, 3, 0)])
@pytest.mark.parametrize("layer", [0, 1])
def test_one_style_for_the_whole_batch_equals_a_row_for_each_sample(modulation, layer):
    torch.manual_seed(4)
    f, x, gates, style = torch.randn(5, 6), torch.randn(5, 6), torch.randn(5, 4), torch.randn(modulation.size)
    each = modulation(layer, f, style.expand(5, -1), x, gates)
    torch.testing.assert_close(modulation(layer, f, style, x, gates), each)
    torch.testing.assert_close(modulation(layer, f, style[None], x, gates), each)


@pytest.mark.parametrize(("modulation", "layer"), [(OneHot(4, 6, 0), 0), (ResidualAdapter(6, 4, None, 0), 1)])
def test_a_blend_of_vectors_blends_shifts(modulation, layer):
    torch.manual_seed(5)
    f, x, gates, styles = torch.full((5, 6), 9e2), torch.randn(5, 6), torch.randn(5, 4), torch.randn(2, modulation.size)
    one, other, both = (modulation(layer, f, style, x, gates) - f for style in (*styles, 0.3 * styles[0] + 0.7 * styles[1]))
    torch.testing.assert_close(both, 0.3 * one + 0.7 * other, atol=1e-3, rtol=0)  # all positive: ELU changes nothing


@pytest.mark.parametrize(("parts", "shift"), [((OneHot, 4, 6), 0), ((ResidualAdapter, 6, 4, 3), 1),
                                              ((ResidualAdapter, 6, 4, None), 1)])
def test_a_new_style_is_a_shift_by_a_random_code(parts, shift):
    torch.manual_seed(6)
    kind, *sizes = parts
    modulation = kind(*sizes, 300)
    f, gates = torch.full((300, 6), 50.0), torch.softmax(torch.randn(300, 4), 1)
    shifts = [modulation(shift, f, modulation.generator(torch.arange(300)), x, gates) - f for x in torch.randn(2, 300, 6)]
    torch.testing.assert_close(*shifts)
    assert float(shifts[0].detach().std()) == pytest.approx(1.0, abs=0.05)


def test_film_folds_into_a_layers_weights():
    """Equation 6, without layer normalisation: exact for all inputs."""
    torch.manual_seed(7)
    x, weight, bias = torch.randn(5, 7).double(), torch.randn(7, 6).double(), torch.randn(6).double()
    gamma, beta = torch.randn(2, 6).double()
    folded, shift = fold(weight, bias, gamma, beta)
    torch.testing.assert_close(folded, weight @ torch.diag(gamma))
    torch.testing.assert_close(x @ folded + shift, gamma * (x @ weight + bias) + beta, rtol=1e-12, atol=1e-12)


def test_with_layer_normalisation_film_folds_up_to_each_samples_deviation():
    torch.manual_seed(8)
    layer, film = BlendedLinear(4, 7, 6).double(), Film(6, None)
    x, gates, style = torch.randn(5, 7).double(), torch.randn(5, 4).double(), torch.randn(24).double()
    gamma, beta = style[:12].chunk(2)
    weight, bias = torch.einsum("bk,kio->bio", gates, layer.weight.detach()), gates @ layer.bias.detach()
    f = torch.einsum("bi,bio->bo", x, weight) + bias
    folded, shift = fold(weight, bias, gamma, beta, f.std(-1))
    got = torch.einsum("bi,bio->bo", x, folded) + shift
    torch.testing.assert_close(got, gamma * layer_norm(f) + beta, rtol=1e-10, atol=1e-12)
    torch.testing.assert_close(torch.nn.functional.elu(got), film(0, f, style), rtol=1e-10, atol=1e-12)
    one, off = x[:1] @ folded[0] + shift[0], x[:1] * 2 @ folded[0] + shift[0]  # made for that sample, and no other
    torch.testing.assert_close(one, gamma * layer_norm(f[:1]) + beta, rtol=1e-10, atol=1e-12)
    doubled = x[:1] * 2 @ weight[0] + bias[0]
    assert float((off - gamma * layer_norm(doubled) - beta).abs().max()) > 0.1
    ratio = (off - beta) / (gamma * layer_norm(doubled))  # but what is off is one number, the deviation's ratio
    torch.testing.assert_close(ratio, (doubled.std() / f[0].std()).expand_as(ratio), rtol=1e-5, atol=0)
