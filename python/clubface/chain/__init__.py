"""A differentiable chain in JAX from a golfer's torques to where the ball lands.

A golfer of driven segments swings a club on a flexible shaft, the head strikes the ball with the shaft attached, and
the ball flies. Every value has derivatives with respect to the timing and size of torques and the stiffness of the
shaft.
"""

from clubface.chain.golfer import GolferBody, Segment
from clubface.chain.swing import Motion, Shot, Swing

__all__ = ["GolferBody", "Motion", "Segment", "Shot", "Swing"]
