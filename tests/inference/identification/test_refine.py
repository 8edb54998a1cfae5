"""When a refinement stops and how far it dares to go, on launches whose every step can be worked by hand.

One quantity of two shots: the first is simulated as a function f of the only parameter x, the second cannot be changed
and is off by 1. So the cost, of squares, is d^2 + 1 with d = f(x) - measured, a step within the region is Newton's,
-d / f'(x), and it promises a fall of d^2.
"""

from __future__ import annotations

import numpy as np
import pytest

from clubface.inference.identification import search as refinement
from clubface.inference.identification.search import Linear, refine
from clubface.inference.identification.simulator import Cost


class Function:
    """Stands in for a simulator; keeps the points it was asked for."""

    def __init__(self, value, slope):
        self.value, self.slope = value, slope
        self.tried, self.linearised = [], []

    def at(self, point):
        return np.array([[self.value(float(point[0])), 1.0]])

    def launch(self, point):
        self.tried.append(float(point[0]))
        return self.at(point)

    def derivatives(self, point):
        self.linearised.append(float(point[0]))
        return Linear(self.at(point), np.array([[[self.slope(float(point[0])), 0.0]]]))


def cost_to(measured):
    return Cost("squares", np.array([[measured, 0.0]]), np.ones((1, 2)), np.ones(1))


def square():
    return Function(lambda x: x * x, lambda x: 2.0 * x)


@pytest.mark.parametrize(
    ("fall", "steps", "linearised"),
    [
        # From 0.6 to the root of 0.25, d is 0.11, 8.4e-3, 6.8e-5 and 4.7e-9: the promises are 1.2e-2, 7.1e-5, 4.7e-9
        # and 2e-17 of a cost of about 1.
        (1e-12, 3, 4),  # the fourth promise is below 1e-12, the third above 50 times that
        (1e-9, 3, 3),  # the third is above 1e-9 but below 50 times that: its step is the last
        (1e-8, 2, 3),  # the third is below 1e-8, the second above 50 times that
        (1e-5, 2, 2),
        (1e-4, 1, 2),
        (0.1, 0, 1),
    ],
)
def test_a_refinement_stops_where_a_step_promises_too_little_or_the_next_one_would(fall, steps, linearised):
    simulator = square()
    result = refine(simulator, cost_to(0.25), np.array([0.6]), fall=fall)
    assert (result.steps, len(simulator.tried), len(simulator.linearised)) == (steps, steps, linearised)
    newton = [0.6]
    while len(newton) <= steps:
        newton.append(0.5 * (newton[-1] + 0.25 / newton[-1]))
    # Rounding of the step, about 1e-16 of its size.
    assert result.point[0] == pytest.approx(newton[-1], rel=1e-14)
    assert result.cost == pytest.approx(1.0 + (newton[-1] ** 2 - 0.25) ** 2, rel=1e-14)


@pytest.mark.parametrize(("distance", "steps"), [(5e-10, 1), (5e-11, 0)])
def test_a_refinement_stops_where_a_step_is_too_small_however_much_it_promises(distance, steps):
    simulator = Function(lambda x: 1e12 * (x - 0.5), lambda x: 1e12)
    assert refine(simulator, cost_to(0.0), np.array([0.5 + distance])).steps == steps


def test_a_refinement_stops_after_so_many_steps(monkeypatch):
    monkeypatch.setattr(refinement, "MOST_STEPS", 2)
    assert refine(square(), cost_to(0.25), np.array([0.6])).steps == 2


def test_the_region_grows_by_two_and_a_half_where_a_step_at_its_edge_keeps_its_promise():
    simulator = square()
    refine(simulator, cost_to(0.25), np.array([0.05]))
    # 0.1 and 0.25 to the edge, then 0.09 / 0.8 within 0.625.
    assert simulator.tried[:3] == pytest.approx([0.15, 0.40, 0.5125], abs=1e-12)


def test_the_region_shrinks_to_a_quarter_of_a_step_that_fails_and_the_point_stays():
    simulator = Function(lambda x: x**8, lambda x: 8.0 * x**7)
    result = refine(simulator, cost_to(0.1), np.array([0.5]))
    # From 0.6 the edge, 0.25 away, overshoots: 0.85^8 = 0.27. A quarter of it keeps its promise, so that 0.16 are
    # allowed; Newton's step of 0.14 overshoots again and its quarter does not.
    newton = (0.1 - 0.6625**8) / (8.0 * 0.6625**7)
    tried = [0.6, 0.85, 0.6625, 0.6625 + newton, 0.6625 + 0.25 * newton]
    assert simulator.tried[:5] == pytest.approx(tried, abs=1e-12)
    assert simulator.linearised[:4] == pytest.approx([0.5, 0.6, 0.6625, 0.6625 + 0.25 * newton], abs=1e-12)
    assert result.point[0] == pytest.approx(0.1 ** (1 / 8), abs=1e-9)
