"""Springs follow their differential equation; inertialisation leaves no jump."""

import pytest
import torch
from course.springs import inertialise

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


def test_inertialise_continues_value_and_velocity_and_ends_in_the_new_motion():
    t = torch.arange(120, dtype=torch.float64) / 60
    old, new = torch.sin(3 * t), 2 + torch.cos(5 * t)
    made = torch.cat((old, inertialise(old, new, 60.0, 12.0)))
    assert made.diff().abs().max() < 0.3 < 1.0 < torch.cat((old, new)).diff().abs().max()
    assert made.diff().diff()[118:120].abs().max() < 0.05  # nor does the velocity
    assert (made[-1] - new[-1]).abs() < 1e-3
