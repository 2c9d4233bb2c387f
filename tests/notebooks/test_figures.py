"""Pictures of phases say what the numbers say."""

import numpy as np
import pytest
from course import phase_figure, principal_axes

import toolkit as tk
from toolkit import phases as ph


@pytest.fixture(scope="module")
def hop() -> tk.Clip:
    return tk.datasets.procedural.generate("HopLeft", seconds=3.0)


@pytest.fixture(scope="module")
def found(hop) -> ph.Phases:
    return ph.extract(hop)


def traces(figure, name: str) -> list:
    return [trace for trace in figure.data if trace.name == name]


def points(trace) -> np.ndarray:
    return np.stack([trace[axis] for axis in "xyz"], -1)


def test_phase_figure_draws_curves_ribbon_and_truth(hop, found):
    figure = phase_figure(hop, found, truth=found.phase + 1.0, start=1.0, stop=2.0)
    source, truth, edges = (
        traces(figure, "source"), traces(figure, "truth"), traces(figure, "residual")
    )
    fits = traces(figure, "fit, left")[:1] + traces(figure, "fit, right")[:1]
    for limb in range(2):
        np.testing.assert_allclose(source[limb].y, found.source[60:120, limb], atol=1e-6)
        # A constant lag is no error.
        np.testing.assert_allclose(truth[limb].y, fits[limb].y, atol=1e-5)
        np.testing.assert_allclose(
            edges[2 * limb + 1].y - edges[2 * limb].y, 2 * found.residual[60:120, limb], atol=1e-6
        )
    quarter = found.phase.clone()
    quarter[120:] += np.pi / 2  # a truth that leaves the fit in step at first, and lags later
    off = traces(phase_figure(hop, found, truth=quarter), "truth")[0]
    fit = traces(phase_figure(hop, found), "fit, left")[0]
    assert np.abs(off.y - fit.y)[120:].max() > 0.5


def test_principal_axes_are_those_of_the_source_in_the_world(hop):
    figure = principal_axes(hop, "hybrid", second=1.5)
    assert [
        name
        for name in ("left hand", "right hand", "left foot", "right foot")
        if traces(figure, name)
    ] == ["left hand", "right hand", "right foot"]
    toe = hop.global_positions[90, hop.skeleton.index("right_toe")]
    np.testing.assert_allclose(points(traces(figure, "right foot")[0])[90], toe, atol=1e-5)
    source = ph.ContactFree().fitted([hop])
    path, arrow = (
        points(traces(figure, "right foot")[0]), points(traces(figure, "principal axis")[2])
    )
    direction = (arrow[1] - arrow[0]) / np.linalg.norm(arrow[1] - arrow[0])
    curve = source(hop, "right_foot")
    # The source is the distance from the plane.
    np.testing.assert_allclose((path - arrow[0]) @ direction, curve, atol=1e-5)
    corners = points(traces(figure, "plane")[2])
    np.testing.assert_allclose((corners - arrow[0]) @ direction, 0, atol=1e-6)
    np.testing.assert_allclose(corners.mean(0), arrow[0], atol=1e-6)
