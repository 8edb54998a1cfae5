"""The strength of a head: the largest stress of each part under a hard blow, beside the stress at which it yields."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from clubface.errors import InputError, RunError
from clubface.fem.core import Progress
from clubface.fem.heads import MeshedHead, Metal, ShellHead, SolidHead, head as meshed
from clubface.fem.heads.read import Design
from clubface.fem.run import AnyBall, strike
from clubface.fem.settings import Settings

if TYPE_CHECKING:
    import os

    from numpy.typing import NDArray

BLOW = "125 mph"
"""Speed of the club where none is given: about the most that professionals on tour reach with a driver."""
DURATION = 0.8e-3
"""Of the run [s]: longer than any contact with a ball."""
INTERVAL = 5e-6
"""Between the shapes whose stress is looked at [s]; the slowest vibrations of a face, which carry its stress, take a
hundred times as long."""


@dataclass(frozen=True)
class PartStress:
    """The largest stress of a part of a head during an impact.

    Attributes
    ----------
    part
        Name of the part; "head" for a head of hexahedra.
    stress
        Largest equivalent stress of von Mises [Pa] in a metal that stays elastic.
    time
        When it is reached [s] after first touch.
    place
        Centre of the element that has it [m], in the axes of :class:`clubface.Club`, from the face centre.
    yield_stress
        Stress at which the metal yields [Pa]; None if its file does not say.
    """

    part: str
    stress: float
    time: float
    place: tuple[float, float, float]
    yield_stress: float | None

    @property
    def margin(self) -> float | None:
        """How much more stress the part bears before it yields, as a share of the stress; negative if it yields."""
        return None if self.yield_stress is None else self.yield_stress / self.stress - 1.0


def peak_stress(
    head: str | os.PathLike[str] | MeshedHead | Design,
    *,
    which: AnyBall = None,
    speed: Any = BLOW,
    friction: Any = None,
    safety: float | None = None,
    threads: int = 0,
    progress: Progress | None = None,
    **delivery: Any,
) -> list[PartStress]:
    """Return the largest stress of each part of a head under a blow.

    The metals stay elastic for it, whether they yield or not, so that the stress may exceed the one at which they
    yield: the margin then says by how much a design is too weak. It is the stress on the two sides of a shell (at its
    outermost points, if its metal has points through the thickness), and that at the centre of a hexahedron, which
    does not see how a thin wall bends. Neither knows of notches, welds or fatigue.

    Parameters
    ----------
    head
        The head, as for :func:`clubface.fem.head`.
    which
        The ball, as for :func:`clubface.fem.ball`.
    speed
        Speed of the club [m/s].
    friction
        Coefficient of Coulomb friction; that of the ball unless given.
    safety
        As of :class:`clubface.fem.Settings`.
    threads
        Number of threads; 0 for all cores.
    progress
        Called with simulated time and duration [s].
    **delivery
        The rest of the delivery, such as ``toe``, as for :func:`clubface.impact`.

    Raises
    ------
    RunError
        The run failed.
    """
    import numpy as np

    made = meshed(head)
    settings = Settings(
        duration=DURATION, frames=round(DURATION / INTERVAL) + 1, fields=True, threads=threads, safety=safety
    )
    found = strike(
        _elastic(made), which=which, friction=friction, settings=settings, progress=progress, speed=speed, **delivery
    )
    if found.interrupted:
        raise KeyboardInterrupt
    if found.stopped or found.head_fields is None:
        raise RunError(found.stopped or "the run kept no stress")
    stress = found.head_fields.von_mises
    # The larger of the two sides of a shell.
    stress = stress if stress.ndim == 2 else stress.max(axis=2)
    parts = []
    for name, metal, elements, places in _parts(made):
        of_part = stress[:, elements]
        frame, element = np.unravel_index(int(of_part.argmax()), of_part.shape)
        x, y, z = (float(place) for place in places[element])
        time, most = float(found.frame_times[frame]), float(of_part[frame, element])
        parts.append(PartStress(name, most, time, (x, y, z), metal.yield_stress))
    return parts


def _parts(head: MeshedHead) -> list[tuple[str, Metal, slice, NDArray[Any]]]:
    """Return name, metal, elements and the places of their centres [m] of each part that has elements."""
    if isinstance(head, SolidHead):
        return [("head", head.metal, slice(None), head.nodes[head.hexahedra].mean(axis=1))]
    if not isinstance(head, ShellHead):
        raise InputError("head", head.name, "a head of shells or of hexahedra")
    parts, start = [], 0
    for part in head.parts:
        of_part = slice(start, start + part.elements)
        start += part.elements
        if part.elements:
            parts.append((part.name, part.metal, of_part, head.nodes[head.quads[of_part]].mean(axis=1)))
    return parts


def _elastic(head: MeshedHead) -> MeshedHead:
    """Return the same head of metals that do not yield."""

    def elastic(metal: Metal) -> Metal:
        return replace(metal, yield_stress=None, hardening=None)

    if isinstance(head, SolidHead):
        return replace(head, metal=elastic(head.metal))
    if isinstance(head, ShellHead):
        return replace(head, parts=tuple(replace(part, metal=elastic(part.metal)) for part in head.parts))
    return head
