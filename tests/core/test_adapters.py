"""The parts that the seven models are made of, against slow loops over samples."""

import math

import pytest
import torch
from torch.nn import functional
from torch.testing import assert_close

from toolkit.networks import BlendedLinear, CatmullRom, OneHot, ResidualAdapter


def spline(points, phase):
    """Cubic Catmull-Rom through sets of weights, as Holden et al. 2017 write it (equation 7)."""
    k = len(points)
    along = k * (phase % math.tau) / math.tau
    at, w = int(along), along % 1
    a, b, c, d = (points[(at + n) % k] for n in (-1, 0, 1, 2))
    return (b + w * (c / 2 - a / 2) + w * w * (a - 5 / 2 * b + 2 * c - d / 2)
            + w**3 * (3 / 2 * b - 3 / 2 * c + d / 2 - a / 2))


def test_a_layer_on_a_phase_equals_interpolating_whole_weight_sets():
    torch.manual_seed(0)
    layer, curve = BlendedLinear(4, 7, 6).double(), CatmullRom()
    torch.nn.init.normal_(layer.weight)
    torch.nn.init.normal_(layer.bias)
    x, phase = torch.randn(40, 7).double(), torch.linspace(-3.0, 10.0, 40).double()
    got = layer(x, curve(phase[:, None]))
    for n in range(40):
        at = float(phase[n])
        expected = x[n] @ spline(layer.weight, at) + spline(layer.bias, at)
        assert_close(got[n], expected, rtol=1e-10, atol=1e-10)


def test_one_hot_is_a_label_beside_the_input():
    """The shift of the first layer equals rows of every expert's weights for the label."""
    torch.manual_seed(1)
    layer, label = BlendedLinear(3, 7, 6).double(), OneHot(3, 6, 4).double()
    gates = torch.randn(5, 3).double()
    x, styles = torch.randn(5, 7).double(), torch.tensor([2, 0, 3, 3, 1])
    got = label(0, layer(x, gates), label.generator(styles), x, gates)
    rows = label.generator.vectors.view(4, 3, 6)
    for n, style in enumerate(styles.tolist()):
        one_hot = functional.one_hot(torch.tensor(style), 4).double()
        weight = sum(gates[n, k] * torch.cat((layer.weight[k], rows[:, k])) for k in range(3))
        f = torch.cat((x[n], one_hot)) @ weight + sum(gates[n, k] * layer.bias[k] for k in range(3))
        assert_close(got[n], functional.elu(f), rtol=1e-10, atol=1e-12)
    f = torch.randn(5, 6).double()
    same = label(1, f, label.generator(styles), f, gates)
    assert_close(same, functional.elu(f))


@pytest.mark.parametrize("rank", [None, 3])
def test_residual_adapter_equals_a_loop_over_samples(rank):
    """With a decomposition, its coefficients follow the phase; a full matrix does not."""
    torch.manual_seed(2)
    adapter = ResidualAdapter(6, 4, rank, 0).double()
    assert adapter.generator is None
    f, x, gates, style = (torch.randn(5, n).double() for n in (6, 6, 4, adapter.size))
    got = adapter(1, f, style, x, gates)
    for n in range(5):
        if rank is None:
            matrix, b = style[n].split((36, 6))
            matrix = matrix.view(6, 6)
        else:  # the full matrix at this sample's phase
            v, c, u, b = style[n].split((6 * rank, 4 * rank, 6 * rank, 6))
            middle = torch.diag(gates[n] @ c.view(4, rank))
            matrix = v.view(6, rank) @ middle @ u.view(rank, 6)
        expected = functional.elu(f[n] + x[n] @ matrix + b)
        assert_close(got[n], expected, rtol=1e-10, atol=1e-12)
    assert_close(adapter(0, f, style, x, gates), functional.elu(f))
