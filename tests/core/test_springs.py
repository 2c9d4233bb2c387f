"""Springs follow their differential equation."""

import pytest
import torch

from toolkit.motion.springs import spring


@pytest.mark.parametrize("rate", [0.5, 4.0, 30.0])
def test_spring_solves_its_equation_and_is_free_of_the_time_step(rate):
    x, v = torch.tensor([[1.0, -2.0], [3.0, 0.5]], dtype=torch.float64)
    once = spring(x, v, rate, 0.3)
    twice = spring(*spring(x, v, rate, 0.1), rate, 0.2)
    for a, b in zip(once, twice, strict=True):
        torch.testing.assert_close(a, b)
    h = 1e-5
    (_, before), (x1, v1), (_, after) = (spring(x, v, rate, 0.3 + k * h) for k in (-1, 0, 1))
    expected = -2 * rate * v1 - rate**2 * x1
    torch.testing.assert_close((after - before) / (2 * h), expected, rtol=1e-4, atol=1e-4)
