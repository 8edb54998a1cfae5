"""Strength of a head: the largest stress of each part in a hard impact, compared with the yield stress."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.fem.core import Progress
from clubface.fem.geometry import area_vectors, outer_quads, sums_at_nodes
from clubface.fem.heads import DriverHead, IronHead, MeshedHead, Metal, ShellHead, SolidHead, head as meshed
from clubface.fem.heads.read import Design, design_of
from clubface.fem.result import SurfaceRecovery, von_mises
from clubface.fem.run import AnyBall, strike
from clubface.fem.settings import Settings
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.support.renamed import renamed_names

if TYPE_CHECKING:
    import os

    from clubface.fem.result import Impact

__all__ = ["ImpactStress", "PartStress", "SurfaceStress", "impact_stress", "peak_stress", "stress_picture"]

if not TYPE_CHECKING:
    __getattr__ = renamed_names(__name__, BlowStress="ImpactStress", blow_stress="impact_stress")

IMPACT_SPEED = "125 mph"
"""Default club speed: about the highest of tour professionals with a driver."""
DURATION = 0.8e-3
"""Duration of the run [s], longer than any contact with a ball."""
INTERVAL = 5e-6
"""Time between recorded stresses [s]; the slowest vibrations of a face, which carry its stress, have periods a hundred
times as long."""
FINER = (1.0, 1.25, 1.5)
"""Refinement factors along each edge for the meshes of a convergence study."""
MOST_ELEMENTS = 400
"""Maximum number of elements along an edge of a parametric head."""


@dataclass(frozen=True)
class PartStress:
    """Largest stress of a part of a head during an impact.

    Attributes
    ----------
    part
        Name of the part; "head" for a parametric iron.
    stress
        Largest von Mises stress [Pa], with elastic metal.
    time
        Time of the largest stress after first touch [s].
    place
        Its location [m] relative to the face centre, in the axes of :class:`clubface.Club`: the centre of a shell, or a
        surface node of solid elements.
    yield_stress
        Yield stress of the metal [Pa]; None if its file gives none.
    by_mesh
        Number of elements of the head and largest stress [Pa] for each mesh, coarsest first; the first is the head's
        own.
    """

    part: str
    stress: float
    time: float
    place: tuple[float, float, float]
    yield_stress: float | None
    by_mesh: tuple[tuple[int, float], ...] = ()

    @property
    def margin(self) -> float | None:
        """Yield stress over largest stress, minus 1: the remaining margin; negative if the part yields."""
        return None if self.yield_stress is None else self.yield_stress / self.stress - 1.0

    @property
    def spread(self) -> float | None:
        """Range of the largest stress over all meshes, relative to ``stress``; None for a single mesh."""
        values = [stress for _, stress in self.by_mesh]
        return (max(values) - min(values)) / self.stress if len(values) > 1 else None


@dataclass(frozen=True, eq=False)
class SurfaceStress:
    """Stress over the surface of a head at the moment of the largest stress.

    Attributes
    ----------
    nodes, quads
        Nodes [m], shape (n, 3), and quadrilaterals between them, counterclockwise seen from outside, shape (m, 4).
    stress
        Von Mises stress at the nodes [Pa]; for shells the mean of the surrounding elements, each on its more highly
        stressed side.
    time
        Time after first touch [s].
    views
        Views that show the walls: "face" and "back", or "face", "crown" and "sole".
    bending
        Whether the mesh resolves the bending of walls; false for a single layer of hexahedra.
    """

    nodes: NDArray[Any]
    quads: NDArray[Any]
    stress: NDArray[Any]
    time: float
    views: tuple[str, ...]
    bending: bool


@dataclass(frozen=True, eq=False)
class ImpactStress:
    """Stress of a head in an impact.

    Attributes
    ----------
    parts
        Largest stress of each part.
    surface
        Stress over the surface.
    speed
        Club speed [m/s].
    """

    parts: tuple[PartStress, ...]
    surface: SurfaceStress
    speed: float

    def notes(self) -> list[Note]:
        """Return notes on the limitations of the stress."""
        notes = [] if self.surface.bending else [note("one-layer-of-hexahedra")]
        return notes if self.parts[0].spread is not None else [*notes, note("mesh-dependence-unknown")]


def peak_stress(head: str | os.PathLike[str] | MeshedHead | Design, **options: Any) -> list[PartStress]:
    """Return the largest stress of each part of a head in an impact, from :func:`impact_stress`."""
    return list(impact_stress(head, **options).parts)


def impact_stress(
    head: str | os.PathLike[str] | MeshedHead | Design,
    *,
    ball: AnyBall = None,
    speed: float | str = IMPACT_SPEED,
    friction: float | str | None = None,
    safety: float | None = None,
    threads: int = 0,
    meshes: int = 1,
    progress: Progress | None = None,
    **delivery: Any,
) -> ImpactStress:
    """Compute the stress of a head in an impact.

    The metals stay elastic here even if they have a yield stress, so the computed stress may exceed it; the margin then
    says by how much a design is too weak. For shells it is the stress on both sides (at the outermost points if the
    metal has points through the thickness), for solids the surface stress, extrapolated from element centres by patch
    recovery (:mod:`clubface.fem.result`). Notches, welds and fatigue are not included. Raises RunError if the run
    failed.

    Parameters
    ----------
    head
        The head, as for :func:`clubface.fem.head`.
    ball
        The ball, as for :func:`clubface.fem.ball`.
    speed
        Club speed [m/s].
    friction, progress
        As for :func:`clubface.fem.throw`.
    safety, threads
        As of :class:`clubface.fem.Settings`.
    meshes
        Number of meshes on which the impact is computed, 1 to 3, to show how much the stress depends on the mesh: the
        head's own, then with 1.25 and 1.5 times as many elements along each edge. A head that is not parametric has
        only one.
    **delivery
        Rest of the delivery, such as ``toe``, as for :func:`clubface.impact`.
    """
    if not 1 <= meshes <= len(FINER):
        raise InputError("meshes", meshes, f"1 to {len(FINER)}")
    made = _meshes(head, meshes)
    total = DURATION * len(made)
    runs: list[tuple[list[PartStress], SurfaceStress]] = []
    for each in made:
        before = DURATION * len(runs)

        def report(time: float, _: float, before: float = before) -> None:
            if progress is not None:
                progress(before + time, total)

        settings = Settings(
            duration=DURATION, frames=round(DURATION / INTERVAL) + 1, fields=True, threads=threads, safety=safety
        )
        impact = strike(
            _elastic(each), ball=ball, friction=friction, settings=settings, progress=report, speed=speed, **delivery
        )
        impact.check_complete()
        runs.append(_solid(each, impact) if isinstance(each, SolidHead) else _shells(each, impact))
    first, surface = runs[0]
    parts = (
        replace(part, by_mesh=tuple((each.elements, run[k].stress) for each, (run, _) in zip(made, runs, strict=True)))
        for k, part in enumerate(first)
    )
    return ImpactStress(tuple(parts), surface, units.parse(speed, "speed", name="speed"))


def _meshes(head: str | os.PathLike[str] | MeshedHead | Design, count: int) -> list[MeshedHead]:
    """Return a head and, if it is parametric, the same head on finer meshes."""
    made = [meshed(head)]
    if not isinstance(made[0], ShellHead | SolidHead):
        raise InputError("head", made[0].name, "a shell head or a solid head")
    design = None if count == 1 else design_of(head)
    if isinstance(design, DriverHead | IronHead):
        for factor in FINER[1:count]:
            elements = tuple(min(MOST_ELEMENTS, _finer(number, factor)) for number in design.elements)
            if elements != design.elements:
                made.append(replace(design, elements=elements).mesh())
    return made


def _finer(number: int, factor: float) -> int:
    """Return ``number`` times ``factor``, rounded up; even numbers stay even, so that midlines remain.

    One or two layers through a wall are excepted, being too few.
    """
    more = math.ceil(number * factor)
    return more + (more % 2 if number % 2 == 0 and number > 2 else 0)


def _peak(part: str, metal: Metal, stress: NDArray[Any], places: NDArray[Any], times: NDArray[Any]) -> PartStress:
    """Return the largest stress of a part, from stresses by time and place."""
    frame, at = np.unravel_index(int(stress.argmax()), stress.shape)
    x, y, z = (float(place) for place in places[at])
    return PartStress(part, float(stress[frame, at]), float(times[frame]), (x, y, z), metal.yield_stress)


def _solid(head: SolidHead, run: Impact) -> tuple[list[PartStress], SurfaceStress]:
    """Return the largest stress of each part of a solid head, and the stress over its outside.

    Stress jumps where parts of different metals meet, so each part is recovered separately, over its whole surface
    including interfaces.
    """
    assert run.head_fields is not None
    of_part = head.part_of_elements()
    outside = {tuple(side) for side in np.sort(outer_quads(head.hexahedra, head.tetrahedra), axis=1).tolist()}
    parts, pieces = [], []
    for number, part in enumerate(head.parts):
        own = [each for each in (part.hexahedra, part.tetrahedra) if len(each)]
        recovery = SurfaceRecovery.of_mesh(head.nodes, *own)
        fields = run.head_fields.stress[:, of_part == number]
        stress = np.stack([von_mises(recovery.at_nodes(frame)) for frame in fields])
        parts.append(_peak(part.name, part.metal, stress, head.nodes[recovery.nodes], run.frame_times))
        seen = [tuple(side) in outside for side in np.sort(recovery.quads, axis=1).tolist()]
        pieces.append((recovery, recovery.quads[seen], stress))
    frame = int(np.max([stress.max(axis=1) for *_, stress in pieces], axis=0).argmax())
    starts = np.cumsum([0, *(len(recovery.nodes) for recovery, *_ in pieces)])
    surface = SurfaceStress(
        nodes=np.concatenate([head.nodes[recovery.nodes] for recovery, *_ in pieces]),
        quads=np.concatenate([start + np.searchsorted(recovery.nodes, quads)
                              for start, (recovery, quads, _) in zip(starts, pieces, strict=False)]),
        stress=np.concatenate([stress[frame] for *_, stress in pieces]),
        time=float(run.frame_times[frame]), views=("face", "back"),
        bending=all(recovery.extrapolated.mean() > 0.5 for recovery, *_ in pieces),
    )  # fmt: skip
    return parts, surface


def _shells(head: MeshedHead, run: Impact) -> tuple[list[PartStress], SurfaceStress]:
    """Return the largest stress of each part of a shell head, and the stress over it, on each shell's worse side."""
    assert isinstance(head, ShellHead)
    assert run.head_fields is not None
    stress = run.head_fields.von_mises.max(axis=2)
    places = head.nodes[head.quads].mean(axis=1)
    parts, start = [], 0
    for part in head.parts:
        some = slice(start, start + part.elements)
        start += part.elements
        if part.elements:
            parts.append(_peak(part.name, part.metal, stress[:, some], places[some], run.frame_times))
    frame = int(stress.max(axis=1).argmax())
    sums, counts = (
        sums_at_nodes(head.quads, each, len(head.nodes)) for each in (stress[frame], np.ones(head.elements))
    )
    surface = SurfaceStress(
        nodes=head.nodes, quads=head.quads, stress=sums / np.maximum(counts, 1.0), time=float(run.frame_times[frame]),
        views=("face", "crown", "sole"), bending=True,
    )  # fmt: skip
    return parts, surface


def _elastic(head: MeshedHead) -> MeshedHead:
    """Return a copy of the head whose metals do not yield."""
    assert isinstance(head, ShellHead | SolidHead)
    elastic: Any = {"yield_stress": None, "hardening": None}
    parts: Any = tuple(replace(part, metal=replace(part.metal, **elastic)) for part in head.parts)
    return replace(head, parts=parts)


FACING = 0.25
"""Quadrilaterals are drawn if the cosine of the angle between their normal and the view exceeds this."""


def stress_picture(stress: ImpactStress, loft: float) -> Picture:
    """Plot the stress over a head's surface at the moment of the largest stress, with a bar for each part.

    A cross marks the largest stress; a line across a bar marks the yield stress, if known. ``loft`` is the elevation
    of the face normal at the face centre [rad].
    """
    surface, parts = stress.surface, stress.parts
    normals = area_vectors(surface.nodes, surface.quads)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    out, up = np.array([np.cos(loft), np.sin(loft), 0.0]), np.array([-np.sin(loft), np.cos(loft), 0.0])
    ahead, vertical, _ = np.eye(3)
    sides = {"face": (out, up), "back": (-out, up), "crown": (vertical, ahead), "sole": (-vertical, ahead)}
    peak = max(parts, key=lambda part: part.stress)
    place = np.array(peak.place)
    at = int(((surface.nodes[surface.quads].mean(axis=1) - place) ** 2).sum(axis=1).argmin())
    colours = axis("stress", unit="MPa", limits=(0.0, float(surface.stress.max())))
    toe = axis("to_the_toe", like="m", unit="mm")
    views: list[Panel | None] = []
    for name in surface.views:
        towards, height = sides[name]
        seen = normals @ towards > FACING
        quads = surface.quads[seen]
        marks = [Mark("cells", surface.nodes[quads, 2], surface.nodes[quads] @ height,
                      values=surface.stress[quads].mean(axis=1))]  # fmt: skip
        if seen[at]:
            marks.append(Mark("points", [place[2]], [place @ height], symbol="x", size=7.0, style=-2))
        label = axis("up_the_face" if height is up else "to_the_target", like="m", unit="mm")
        views.append(Panel(marks, toe, label, name, equal=True, values=colours, grid=False))
    bars = [
        Mark("bars", [part.stress], [row], style=int(part.margin is not None and part.margin < 0.0), size=0.6)
        for row, part in enumerate(parts)
    ] + [
        Mark("line", [part.yield_stress] * 2, [row - 0.42, row + 0.42], style=-2, size=2.0)
        for row, part in enumerate(parts)
        if part.yield_stress is not None
    ]
    names = Axis(names=[part.part for part in parts], limits=(len(parts) - 0.4, -0.6))
    largest = axis("stress", "largest stress", unit="MPa")
    below = 0.9 + 0.32 * len(parts)
    return Picture(
        "stress",
        f"The stress of the surface {units.fixed(surface.time, 'us', 0)} after first touch, a cross where it is "
        "largest; and the largest stress of every part. A black line is where its metal yields, orange bars go beyond",
        [views, [Panel(bars, largest, names)]], heights=[2.6, below], height=2.6 + below,
    )  # fmt: skip
