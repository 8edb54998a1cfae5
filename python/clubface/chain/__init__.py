"""One differentiable chain from a golfer's torques to where the ball lands, in JAX.

A golfer of driven segments swings a club on a flexible shaft; the head meets the ball with its shaft attached; the ball
flies. Every value has derivatives by the timing and size of torques and by the stiffness of the shaft.
"""

from clubface.chain.golfer import GolferBody, Segment
from clubface.chain.swing import Motion, Shot, Swing

__all__ = ["GolferBody", "Motion", "Segment", "Shot", "Swing"]
