"""What a call of a stepped contact and a whole impact of a struck ball cost."""

import time
from typing import NamedTuple

import numpy as np

import clubface
from clubface.simulation.multibody import BallMotion


class Cost(NamedTuple):
    """Processor time [s] of a call of ``evaluate``, of ``jacobian``, and of a whole impact by a struck ball."""

    evaluate: float
    jacobian: float
    impact: float

    def within(self, *stated):
        """Whether each is what was stated to a factor of three: machines differ, and so does what else they do."""
        return all(each / 3.0 < measured < 3.0 * each for measured, each in zip(self, stated, strict=True))


def _time(work, count):
    best = np.inf
    for _ in range(3):
        start = time.process_time()
        for _ in range(count):
            work()
        best = min(best, (time.process_time() - start) / count)
    return best


def cost(model):
    """Return what a model costs."""
    club = clubface.club("driver")
    head = clubface.Delivery(speed="105 mph", attack="3 deg", loft="13 deg").pose(club)
    contact = clubface.SteppedContact(head, BallMotion(np.zeros(3)), club=club, model=model)
    deeper = BallMotion(np.array([-1e-3, 0.0, 0.0]), np.zeros(3), np.zeros(3))
    rotation, position, velocity, spin = head
    before = rotation, position - 1e-5 * velocity, velocity, spin

    def impact():
        clubface.StruckBall(club=club, model=model).advance(before, 1e-3)

    return Cost(
        _time(lambda: contact.evaluate(head, deeper, contact.initial), 500),
        _time(lambda: contact.jacobian(head, deeper, contact.initial), 100),
        _time(impact, 3),
    )
