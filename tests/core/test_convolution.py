import pytest
import torch
from torch import nn

from toolkit.networks import FilmGenerator, film
from toolkit.networks.film import MANY, TILE, WIDE, Convolution


@pytest.mark.parametrize("kernel", [WIDE + 1, 25, TILE + 5])
@pytest.mark.parametrize("frames", [TILE, 3 * TILE, 3 * TILE + 7, 13])
def test_tiles_give_what_torch_gives(kernel, frames):
    torch.manual_seed(0)
    layer, x = Convolution(7, 5, kernel), torch.randn(MANY, 7, frames)
    upstream = torch.randn(MANY, 5, frames)
    results = []
    for way in (Convolution.forward, nn.Conv1d.forward):
        given = x.clone().requires_grad_()
        y = way(layer, given)
        results.append((y, *torch.autograd.grad(y, (given, *layer.parameters()), upstream)))
    for ours, theirs in zip(*results, strict=True):
        torch.testing.assert_close(
            ours, theirs, rtol=1e-4, atol=1e-5 * float(theirs.detach().abs().max())
        )


def test_a_layer_that_inference_mode_used_first_can_be_trained():
    film._waves.cache_clear()
    layer, x = Convolution(7, 5, 25), torch.randn(MANY, 7, TILE)
    with torch.inference_mode():
        layer(x)
    layer(x).sum().backward()
    assert layer.weight.grad.any()


def test_tiles_are_for_many_clips_and_wide_kernels(monkeypatch):
    monkeypatch.setattr(film, "_waves", lambda n: pytest.fail("tiles"))
    torch.manual_seed(0)
    Convolution(2, 3, 25)(torch.randn(MANY - 1, 2, 50))
    Convolution(2, 3, WIDE - 1)(torch.randn(MANY, 2, 50))
    with pytest.raises(pytest.fail.Exception, match="tiles"):
        FilmGenerator(6, 240, 8, 4, 25, 8, 0.0)(torch.randn(MANY, 240, 6))
