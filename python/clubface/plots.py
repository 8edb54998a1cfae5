"""Pictures for papers: force histories, trajectories, a whole shot.

Every function returns a matplotlib ``Figure``; :func:`save` writes it as PNG, SVG or PDF by the file's ending. Other
results draw themselves: ``draw(picture)`` makes a figure of each of their ``pictures()``.
"""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from clubface.present.drawing import animate as animate, draw as draw
from clubface.present.style import save as save
from clubface.simulation.history import History
from clubface.simulation.shot_result import force_picture, shot_picture

__all__ = ["animate", "draw", "force_histories", "save", "shot_figure", "trajectories"]


def force_histories(histories: Mapping[str, History | Mapping[str, ArrayLike]]) -> Figure:
    """Draw the force on the ball over time, normal and along the face, one line per model.

    Parameters
    ----------
    histories
        A :class:`clubface.History` (or its columns by name) for each model.
    """
    return draw(force_picture(histories))


def trajectories(flights: Mapping[str, ArrayLike]) -> Figure:
    """Draw flights from the side and from above.

    Parameters
    ----------
    flights
        Positions of the ball by model or other name [m], shape [n, 3], axes x, y, z.
    """
    return draw(shot_picture(flights))


def shot_figure(
    flights: Mapping[str, ArrayLike],
    histories: Mapping[str, History | Mapping[str, ArrayLike]] | None = None,
    *,
    title: str = "",
) -> Figure:
    """Draw one shot: forces at the top, the flight from the side and from above underneath.

    Models without a history are left out of the force panels and named in a footnote.

    Parameters
    ----------
    flights
        As for :func:`trajectories`.
    histories
        As for :func:`force_histories`; may be empty.
    title
        Title: club and delivery in words.
    """
    return draw(shot_picture(flights, histories, title=title))
