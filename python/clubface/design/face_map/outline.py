"""The outline of a face: that of a meshed head, or one assumed from the width and the height of the club."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import Club
from clubface.equipment.face import turn_to_sole

HEEL_HEIGHT = 30.0 / 54.0
"""Height of an iron's face at the heel over that at the toe: of the blade ``7-iron`` among the meshed heads."""
CORNERS = 96
"""Of an ellipse."""
BETWEEN = 20
"""Points along each straight side of a mesh, so that it can be cut off anywhere."""


class Outline(NamedTuple):
    """The outline of a face, seen along its normal; it bulges outwards everywhere.

    Attributes
    ----------
    corners
        Towards the toe and up the face [m], shape (corners, 2), all the way round.
    told
        Where it comes from, in words.
    """

    corners: NDArray[Any]
    told: str

    @property
    def least(self) -> NDArray[Any]:
        """The lower and heel-side corner of the box around it [m]."""
        return self.corners.min(axis=0)

    @property
    def greatest(self) -> NDArray[Any]:
        """The upper and toe-side corner of the box around it [m]."""
        return self.corners.max(axis=0)

    def holds(self, toe: Any, high: Any, slack: float = 1e-9) -> NDArray[Any]:
        """Tell which points [m] are inside or on it."""
        toe, high = np.broadcast_arrays(np.asarray(toe, float), np.asarray(high, float))
        low, top = self.extent(toe)
        return (
            (toe >= self.least[0] - slack)
            & (toe <= self.greatest[0] + slack)
            & (high >= low - slack)
            & (high <= top + slack)
        )

    def extent(self, toe: Any) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the least and the greatest height of the face [m] at places towards the toe [m]."""
        turned = np.roll(self.corners, -int(self.corners[:, 0].argmin()), axis=0)
        last = int(turned[:, 0].argmax())
        one, other = turned[: last + 1], np.concatenate([turned[last:], turned[:1]])[::-1]
        sides = [np.interp(toe, each[:, 0], each[:, 1]) for each in (one, other)]
        low, top = np.minimum(*sides), np.maximum(*sides)
        for end in (self.least[0], self.greatest[0]):  # where a side may be upright
            upright = self.corners[self.corners[:, 0] == end, 1]
            low, top = np.where(toe == end, upright.min(), low), np.where(toe == end, upright.max(), top)
        return low, top

    def area(self) -> float:
        """Return its area [m2]."""
        x, y = self.corners.T
        return float(abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2.0)


def outline_of(club: Club) -> Outline:
    """Return the outline of a club's face."""
    size = f"{units.show(club.face_width, 'mm', 4)} by {units.show(club.face_height, 'mm', 4)}"
    if hasattr(club, "head"):
        return _of_mesh(club)
    width, height = club.face_width / 2.0, club.face_height / 2.0
    if club.kind == "iron":
        heel = -height + 2.0 * height * HEEL_HEIGHT
        # The top line rises from the heel and levels off at the toe, whose upper corner is cut.
        corners = [(-width, -height), (0.9 * width, -height), (width, -0.6 * height), (width, 0.5 * height),
                   (0.7 * width, height), (-width, heel)]  # fmt: skip
        return Outline(np.array(corners), f"assumed: an iron's, {size}")
    angle = np.linspace(0.0, 2.0 * np.pi, CORNERS, endpoint=False)
    corners = np.stack([width * np.cos(angle), height * np.sin(angle)], axis=1)
    return Outline(corners, f"assumed: an ellipse of {size}")


def _of_mesh(club: Any) -> Outline:
    """Return what holds all nodes of the face of a club that has a mesh."""
    from scipy.spatial import ConvexHull

    places = club.head.face_places() @ turn_to_sole(club.loft)
    flat = np.stack([places[:, 2], places[:, 1]], axis=1)
    corners = flat[ConvexHull(flat).vertices]
    # The club says how far from the centre its face can be struck, which is less where the centre is not in the middle.
    limit = np.array([club.face_width, club.face_height]) / 2.0
    share = np.linspace(0.0, 1.0, BETWEEN, endpoint=False)[None, :, None]
    between = corners[:, None] * (1.0 - share) + np.roll(corners, -1, axis=0)[:, None] * share
    return Outline(np.clip(between.reshape(-1, 2), -limit, limit), "of its mesh")
