"""Plots of the deformed ball and head in the section through the normal and up the face: moments, or an animation."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError
from clubface.fem.balls import node_masses
from clubface.fem.geometry import HEXAHEDRON_SIDES
from clubface.fem.heads import ShellHead
from clubface.fem.pictures import FORCE, LEVEL
from clubface.fem.result import Impact
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.units import from_si

__all__ = ["Section", "moving_section", "section_picture"]


class Section:
    """Section of the deformed mesh in the plane of the normal and the direction up the face, at ``times`` [s]."""

    def __init__(self, impact: Impact) -> None:
        if not len(impact.frames):
            raise InputError("frames", 0, "1 or more; set frames in the settings of the run")
        mesh = impact.ball.mesh
        faces = mesh["elements"].astype(int)[:, HEXAHEDRON_SIDES].reshape(-1, 4)
        quads = faces[(abs(mesh["nodes"][faces, 2]) < 1e-9).all(axis=1)]
        # Each quadrilateral occurs twice, in the elements on either side of the plane.
        _, first = np.unique(np.sort(quads, axis=1), axis=0, return_index=True)
        self._quads = quads[first]
        self._masses = node_masses(mesh)
        self._impact = impact
        self._cuts = self._cut(impact.head) if isinstance(impact.head, ShellHead) else None
        self.times = impact.frame_times

    def at(self, frame: int) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the corners of the quadrilaterals [m], (n, 4, 2), and the compression of each, 0 to 1.

        The first coordinate is the distance from the face, the second points up the face, in the frame in which the
        clubhead is at rest at first touch.
        """
        places, first = (self._impact.frames[each] @ self._impact.axes.T for each in (frame, 0))
        corners = (places[:, :2] + self._shift(frame))[self._quads]
        return corners, _compression(first[:, :2][self._quads], corners)

    def head_at(self, frame: int) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the cuts through a shell head [m], (n, 2, 2), and their thickness [m]; empty for a rigid head."""
        if self._cuts is None:
            return np.zeros((0, 2, 2)), np.zeros(0)
        starts, ends, share, thickness = self._cuts
        places = self._from_touch(self._impact.head_frames[frame])[:, :2]
        cuts = places[starts] + share * (places[ends] - places[starts])
        return cuts - self._from_touch(np.zeros(3))[:2] + self._shift(frame), thickness

    def walls_at(self, frame: int) -> NDArray[Any]:
        """Return the cuts through a shell head as quadrilaterals of the wall thickness [m], (n, 4, 2)."""
        cuts, thickness = self.head_at(frame)
        along = cuts[:, 1] - cuts[:, 0]
        across = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.linalg.norm(along, axis=1, keepdims=True)
        half = 0.5 * thickness[:, None] * across
        return np.stack([cuts[:, 0] + half, cuts[:, 1] + half, cuts[:, 1] - half, cuts[:, 0] - half], axis=1)

    def panel(self, frame: int, colours: Axis) -> Panel:
        """Return the section at one moment, coloured by compression, as a panel."""
        corners, compression = self.at(frame)
        walls, radius = self.walls_at(frame), 0.5 * self._impact.ball.diameter
        marks = [Mark("cells", corners[..., 0], corners[..., 1], values=compression, label="ball")]
        if len(walls):
            marks.append(Mark("cells", walls[..., 0], walls[..., 1], style=-1, label="head"))
        else:
            marks.append(Mark("shade", x0=-0.15 * radius, x1=0.0))
        x = axis("distance_from_the_face", like="m", unit="mm",
                 limits=((-0.7 if len(walls) else -0.15) * radius, 2.15 * radius))  # fmt: skip
        y = axis("up_the_face", like="m", unit="mm", limits=(-1.3 * radius, 1.5 * radius))
        title = f"{from_si(self.times[frame], 'us'):.0f} µs"
        return Panel(marks, x, y, title, equal=True, values=colours, grid=False)

    def colours(self, frames: Iterable[int]) -> Axis:
        """Return a colour scale for the compression in these frames, rounded up to a multiple of 10%."""
        most = 0.1 * max(1.0, float(np.ceil(max(self.at(frame)[1].max() for frame in frames) * 10.0)))
        return axis("compression", like="1", unit="%", limits=(0.0, most))

    def _cut(self, head: ShellHead) -> tuple[NDArray[Any], ...]:
        """Return the cuts of shells with the plane z = 0 at first touch, which follow the same material points.

        Returns the nodes at which the sides that a cut crosses start and end, shape (n, 2), the fraction of the way
        between them at which it does, and the thickness of the shell [m], shape (n,).
        """
        places = self._from_touch(self._impact.head_frames[0])
        starts = head.quads.astype(int)
        ends = np.roll(starts, -1, axis=1)
        low, high = places[starts, 2], places[ends, 2]
        # Nodes on the plane count as below it, so that every cut has two ends.
        crossed = (low > 0.0) != (high > 0.0)
        cut = crossed.sum(axis=1) == 2
        sides = np.argsort(~crossed[cut], axis=1, kind="stable")[:, :2]
        starts, ends, low, high = (np.take_along_axis(each[cut], sides, axis=1) for each in (starts, ends, low, high))
        return starts, ends, (low / (low - high))[..., None], head.thickness[cut]

    def _from_touch(self, places: NDArray[Any]) -> NDArray[Any]:
        """Return positions in the axes of first touch, with the plotted plane at z = 0."""
        impact = self._impact
        middle = self._masses @ (impact.frames[0] @ impact.axes.T)
        return places @ impact.axes.T - [0.0, 0.0, middle[2]]

    def _shift(self, frame: int) -> NDArray[Any]:
        """Return the shift along normal and up [m] that puts the face at zero and the clubhead at rest."""
        impact, time = self._impact, self.times[frame]
        centre, start = (self._masses @ (impact.frames[each] @ impact.axes.T) for each in (frame, 0))
        height = centre[1] - start[1] - impact.frame_velocity[1] * time
        distance = np.interp(time, impact.motion["time"], impact.motion["radius"])
        return np.array([distance, height]) - centre[:2]


def _compression(rest: NDArray[Any], now: NDArray[Any]) -> NDArray[Any]:
    """Return the compression of quadrilaterals, 1 minus their smallest stretch, from their diagonals."""
    before, after = (np.stack([each[:, 2] - each[:, 0], each[:, 3] - each[:, 1]], axis=-1) for each in (rest, now))
    stretches = np.linalg.svd(after @ np.linalg.inv(before), compute_uv=False)
    return np.clip(1.0 - stretches[:, 1], 0.0, 1.0)


def section_picture(impact: Impact, *, count: int = 5) -> Picture:
    """Plot the deformed section at ``count`` moments of contact, with pressure and shear over the patch below.

    Pressure and shear are forces per undeformed area at the nodes within an element of the plane. Shear is positive
    where it creates backspin. The colour shows the local compression.
    """
    section = Section(impact)
    moments = np.linspace(0.0, 1.0, count + 2)[1:-1] * impact.last_touch
    frames = list(dict.fromkeys(int(np.argmin(abs(section.times - each))) for each in moments))
    colours = section.colours(frames)
    above = [section.panel(frame, colours) for frame in frames]
    tractions = [_tractions(impact, float(section.times[frame])) for frame in frames]
    high = max((float(np.max(marks[0].x, initial=0.0)) for marks in tractions if marks), default=0.0) or 1e6
    stress = axis("stress", "force per area", unit="MPa", limits=(-0.4 * high, 1.1 * high))
    height = axis("up_from_the_mass_centre", like="m", unit="mm")
    below = [Panel([*marks, Mark("rule", x=0.0, style=-1)], stress, height, legend=place == 0)
             for place, marks in enumerate(tractions)]  # fmt: skip
    caption = "The deformed section at moments of the contact; below, pressure and shear over the patch"
    return Picture("section", caption, [above, below], share_y=True, heights=[1.6, 1.0], height=4.1)


def _tractions(impact: Impact, time: float) -> list[Mark]:
    """Return marks for pressure and shear near the section at ``time`` [s]; empty without contact."""
    patch = impact.patch
    moments = np.unique(patch["time"])
    nearest = moments[np.argmin(abs(moments - time))] if len(moments) else np.inf
    if abs(nearest - time) > 2.0 * impact.settings.interval:
        return []
    near = impact.ball.diameter / (4.0 * impact.ball.cube)
    at = np.flatnonzero((patch["time"] == nearest) & (abs(patch["toe"]) < near))
    at = at[np.argsort(patch["up"][at])]
    marks = []
    for style, (key, label) in enumerate((("normal", "pressure"), ("tangential", "shear"))):
        traction, up = patch[key][at] / patch["area"][at], patch["up"][at]
        marks += [
            Mark("line", traction, up, style=style),
            Mark("points", traction, up, style=style, size=2.0, label=label),
        ]
    return marks


def moving_section(impact: Impact) -> list[Picture]:
    """Return frames of an animation: the deforming section, and the forces up to that moment."""
    section, contact = Section(impact), impact.contact
    colours = section.colours(range(len(section.times)))
    time = axis("time", unit="us", limits=(0.0, float(section.times[-1]) or None))
    whole = [Mark("line", contact["time"], contact[key], style=-1, size=0.4) for key in ("normal", "tangential")]
    pictures = []
    for frame, moment in enumerate(section.times):
        done = contact["time"] <= moment
        marks = [
            Mark("line", contact["time"][done], contact[key][done], style=style, label=label)
            for style, (key, label) in enumerate((("normal", "normal"), ("tangential", "along the face")))
        ]
        forces = Panel([*whole, *marks, LEVEL], time, FORCE, legend=True)
        row = [section.panel(frame, colours), forces]
        pictures.append(Picture("moving-section", "The deforming section", [row], widths=[1.0, 1.35], height=3.2))
    return pictures
