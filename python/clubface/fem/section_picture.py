"""Pictures of deformed sections and of stress over the surface of a head.

The deformed section of the ball through the face normal and up the face: as a row of moments, or moving.

The section of a head of shells through the plane of the picture.

The picture of a blow: stress over the surface of a head, and the largest of every part beside its metal's yield.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.fem.balls import node_masses
from clubface.fem.heads import ShellHead
from clubface.fem.result import Impact
from clubface.fem.stress import BlowStress, PartStress, SurfaceStress
from clubface.plots import COLOURS, WIDTH, styled
from clubface.support.files import whole_file
from clubface.units import from_si


class Outline:
    """Where the plane z = 0 cuts the shells of a head, in the axes of first touch.

    The cut is found in the shape of first touch and goes through the same material at all times.
    """

    def __init__(self, head: ShellHead, places: Any) -> None:
        quads = head.quads.astype(int)
        starts, ends = quads, np.roll(quads, -1, axis=1)
        low, high = places[starts, 2], places[ends, 2]
        # A node on the plane belongs to the side below, so that every cut has two ends.
        crossed = (low > 0.0) != (high > 0.0)
        cut = crossed.sum(axis=1) == 2
        sides = np.argsort(~crossed[cut], axis=1, kind="stable")[:, :2]
        self._ends = tuple(np.take_along_axis(each[cut], sides, axis=1) for each in (starts, ends))
        low, high = (np.take_along_axis(each[cut], sides, axis=1) for each in (low, high))
        self._share = (low / (low - high))[..., None]
        self.thickness = head.thickness[cut]

    def at(self, places: Any) -> Any:
        """Return the cuts as segments, (n, 2, 3) [m], for the places of the nodes."""
        first, second = (places[each] for each in self._ends)
        return first + self._share * (second - first)


DOTS = 100
"""Pixels an inch of an animation."""
DURATION = 5.0
"""Of an animation [s]."""
_FACES = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
_COLOURS: dict[str, Any] = {"cmap": "YlOrRd", "edgecolors": "0.35", "linewidths": 0.25}


class Section:
    """The mesh in the plane through the ball's axis of first touch and the direction up the face.

    Attributes
    ----------
    times
        Of the shapes [s].
    """

    def __init__(self, found: Impact) -> None:
        if not len(found.frames):
            raise InputError("frames", 0, "1 or more; ask for them in the settings of the run")
        mesh = found.ball.mesh
        nodes, elements = mesh["nodes"], mesh["elements"].astype(int)
        faces = np.concatenate([elements[:, corners] for corners in _FACES])
        quads = np.unique(faces[(abs(nodes[faces, 2]) < 1e-9).all(axis=1)], axis=0)
        # Each quadrangle belongs to the elements on both sides of the plane.
        _, first = np.unique(np.sort(quads, axis=1), axis=0, return_index=True)
        self._quads = quads[first]
        self._masses = node_masses(mesh)
        self._found = found
        head = found.head
        self._head = None if not isinstance(head, ShellHead) else Outline(head, self._from_touch(found.head_frames[0]))
        self.times = found.frame_times

    def at(self, frame: int) -> tuple[Any, Any]:
        """Return corners of the quadrangles [mm], (n, 4, 2), and how far each is compressed, 0 to 1.

        The face is the line of zero in the first coordinate; the second is up the face, in the frame in which the
        clubhead rests at first touch.
        """
        places, first = (self._found.frames[each] @ self._found.axes.T for each in (frame, 0))
        corners = (places[:, :2] + self._shift(frame))[self._quads]
        return units.from_si(corners, "mm"), _compression(first[:, :2][self._quads], corners)

    def head_at(self, frame: int) -> tuple[Any, Any]:
        """Return the cuts through a head of shells [mm], (n, 2, 2), and their thickness [mm]; none of a rigid head."""
        if self._head is None:
            return np.zeros((0, 2, 2)), np.zeros(0)
        cuts = self._head.at(self._from_touch(self._found.head_frames[frame]))[..., :2]
        origin = self._from_touch(np.zeros(3))[:2]
        return units.from_si(cuts - origin + self._shift(frame), "mm"), units.from_si(self._head.thickness, "mm")

    def _from_touch(self, places: Any) -> Any:
        """Return places in the axes of first touch, the plane of the picture at zero of the third."""
        found = self._found
        middle = self._masses @ (found.frames[0] @ found.axes.T)
        return places @ found.axes.T - [0.0, 0.0, middle[2]]

    def _shift(self, frame: int) -> Any:
        """Return what is added to places along normal and up to put the face at zero and the clubhead at rest [m]."""
        found, time = self._found, self.times[frame]
        centre, start = (self._masses @ (found.frames[each] @ found.axes.T) for each in (frame, 0))
        height = centre[1] - start[1] - found.frame_velocity[1] * time
        distance = np.interp(time, found.motion["time"], found.motion["radius"])
        return np.array([distance, height]) - centre[:2]


def _compression(rest: Any, now: Any) -> Any:
    """Return 1 less the least stretch of quadrangles, from their diagonals."""
    before, after = (np.stack([each[:, 2] - each[:, 0], each[:, 3] - each[:, 1]], axis=-1) for each in (rest, now))
    stretches = np.linalg.svd(after @ np.linalg.inv(before), compute_uv=False)
    return np.clip(1.0 - stretches[:, 1], 0.0, 1.0)


@styled
def section_figure(found: Impact, *, count: int = 5) -> Figure:
    """Draw the deformed section at ``count`` moments of contact, with pressure and shear over the patch below it.

    Pressure and shear belong to the nodes within an element of the plane; they are forces per area of the undeformed
    surface. Shear is positive where it makes backspin. The colour shows how far a piece of the section is compressed.
    """
    section = Section(found)
    moments = np.linspace(0.0, 1.0, count + 2)[1:-1] * found.last_touch
    frames = list(dict.fromkeys(int(np.argmin(abs(section.times - each))) for each in moments))
    figure = Figure(figsize=(WIDTH, 3.9), layout="constrained")
    panels = figure.subplots(2, len(frames), sharey=True, squeeze=False, height_ratios=[1.6, 1.0])
    radius = found.ball.diameter * 500.0
    high, most = 1.0, _scale(section, frames)
    drawn: Any = None
    for column, frame in enumerate(frames):
        panel, below = panels[0][column], panels[1][column]
        drawn, _ = _draw(panel, section, frame, radius, most)
        panel.set_title(f"{units.from_si(section.times[frame], 'us'):.0f} µs")
        high = max(high, _tractions(below, found, float(section.times[frame])))
        if column == 0:
            panel.set_ylabel("up the face (mm)")
            below.set_ylabel("up from the mass centre (mm)")
            below.legend(loc="upper left", handlelength=1.0, borderaxespad=0.0)
    for below in panels[1]:
        below.set_xlim(-0.4 * high, 1.1 * high)
    figure.colorbar(drawn, ax=list(panels[0]), label="compression (%)", fraction=0.03, pad=0.01)
    figure.supxlabel("distance from the face (mm); below: force per area (MPa)", fontsize=8)
    return figure


@styled
def animate(found: Impact, path: str | os.PathLike[str]) -> Path:
    """Write the deforming section, beside the forces up to each moment, as an animated GIF of 5 s.

    Parameters
    ----------
    found
        A run with frames; each becomes one picture.
    path
        The file, ending in .gif.

    Returns
    -------
    Path
        The file.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    target = Path(path)
    if target.suffix.lower() != ".gif":
        raise InputError("animation", os.fspath(path), "a file ending in .gif")
    section = Section(found)
    figure = Figure(figsize=(WIDTH, 3.2), layout="constrained", dpi=DOTS)
    left, right = figure.subplots(1, 2, width_ratios=[1.0, 1.35])
    radius = found.ball.diameter * 500.0
    drawn, head = _draw(left, section, 0, radius, _scale(section, range(len(section.times))))
    figure.colorbar(drawn, ax=left, label="compression (%)", fraction=0.05, pad=0.01)
    left.set(xlabel="distance from the face (mm)", ylabel="up the face (mm)")
    times = units.from_si(found.contact["time"], "us")
    curves = []
    for key, colour in (("normal", COLOURS[0]), ("tangential", COLOURS[1])):
        force = units.from_si(found.contact[key], "kN")
        right.plot(times, force, color="0.8", linewidth=0.8)
        (curve,) = right.plot([], [], color=colour, label="normal" if key == "normal" else "along the face")
        curves.append((curve, force))
    right.set(
        xlabel="time (µs)",
        ylabel="force on the ball (kN)",
        xlim=(0.0, units.from_si(float(section.times[-1]), "us") or None),
    )
    right.legend(loc="upper right")
    title = right.text(0.03, 0.97, "", transform=right.transAxes, va="top")

    # What does not move is drawn once.
    moving = [drawn, head, *(curve for curve, _ in curves), title]
    for artist in moving:
        artist.set_animated(True)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    still = canvas.copy_from_bbox(figure.bbox)
    pictures = []
    for frame, time in enumerate(section.times.tolist()):
        corners, squeezed = section.at(frame)
        drawn.set_verts(corners)
        head.set_segments(section.head_at(frame)[0])
        drawn.set_array(squeezed * 100.0)
        for curve, force in curves:
            curve.set_data(times[times <= units.from_si(time, "us")], force[times <= units.from_si(time, "us")])
        title.set_text(f"{units.from_si(time, 'us'):.0f} µs")
        canvas.restore_region(still)
        for artist in moving:
            figure.draw_artist(artist)
        pictures.append(Image.fromarray(np.array(canvas.buffer_rgba())[..., :3]).quantize(colors=96))
    pace = max(20, round(1e3 * DURATION / len(pictures)))
    with whole_file(target) as file:
        pictures[0].save(file, format="gif", save_all=True, append_images=pictures[1:], duration=pace, loop=0)
    return target


def _scale(section: Section, frames: Iterable[int]) -> float:
    """Return the end of the scale of compression [%], a multiple of ten."""
    return 10.0 * max(1.0, float(np.ceil(max(section.at(frame)[1].max() for frame in frames) * 10.0)))


def _draw(
    panel: Any, section: Section, frame: int, radius: float, most: float
) -> tuple[PolyCollection, LineCollection]:
    corners, squeezed = section.at(frame)
    drawn = PolyCollection(list(corners), array=squeezed * 100.0, **_COLOURS)
    drawn.set_clim(0.0, most)
    panel.add_collection(drawn)
    walls, thickness = section.head_at(frame)
    behind = -0.15 if not len(walls) else -0.7
    # A point is 1/72 inch; a panel is about 1.3 inches for 3 radii.
    head = LineCollection(list(walls), linewidths=thickness * 72.0 * 1.3 / (3.0 * radius), colors="0.55")
    panel.add_collection(head)
    if not len(walls):
        panel.axvspan(-0.15 * radius, 0.0, color="0.75", linewidth=0)
    panel.set(aspect="equal", xlim=(behind * radius, 2.15 * radius), ylim=(-1.3 * radius, 1.5 * radius))
    panel.grid(visible=False)
    return drawn, head


def _tractions(panel: Any, found: Impact, time: float) -> float:
    """Draw pressure and shear near the section at the record next to ``time`` [s]; return the most pressure [MPa]."""
    patch = found.patch
    near = found.ball.diameter / (4.0 * found.ball.cube)
    moments = np.unique(patch["time"])
    panel.axvline(0.0, color="0.5", linewidth=0.6, zorder=1)
    nearest = moments[np.argmin(abs(moments - time))] if len(moments) else np.inf
    if abs(nearest - time) > 2.0 * found.settings.interval:
        return 0.0
    at = np.flatnonzero((patch["time"] == nearest) & (abs(patch["toe"]) < near))
    at = at[np.argsort(patch["up"][at])]
    up, area = units.from_si(patch["up"][at], "mm"), patch["area"][at]
    pressure, shear = (units.from_si(patch[key][at] / area, "MPa") for key in ("normal", "tangential"))
    panel.plot(pressure, up, color=COLOURS[0], marker="o", markersize=2, label="pressure")
    panel.plot(shear, up, color=COLOURS[1], marker="s", markersize=2, label="shear")
    return float(np.max(pressure, initial=0.0))


COLOUR_MAP = "YlOrRd"
LEVELS = 12
"""Contours of stress."""
FACING = 0.25
"""Cosine of the angle between a quadrilateral's normal and the view above which it is seen."""


@styled
def stress_figure(blow: BlowStress, loft: float) -> Figure:
    """Draw the stress over the surface of a head when it is largest, and a bar for the largest of each part.

    A cross marks the place of the largest stress. A line across a bar is where the metal yields, if that is known.

    Parameters
    ----------
    blow
        The stress.
    loft
        Elevation of the face normal at the face centre [rad].
    """
    bars = 0.9 + 0.32 * len(blow.parts)
    views = _views(blow.surface, loft)
    figure = Figure(figsize=(WIDTH, 2.6 + bars), layout="constrained")
    grid = figure.add_gridspec(2, len(views), height_ratios=[2.6, bars])
    panels = [figure.add_subplot(grid[0, column]) for column in range(len(views))]
    values = from_si(blow.surface.stress, "MPa")
    for axes, view in zip(panels, views, strict=True):
        _draw_view(axes, view, values, blow)
    scale = ScalarMappable(Normalize(0.0, values.max()), COLOUR_MAP)
    figure.colorbar(scale, ax=panels, shrink=0.8, label="stress (MPa)", format="%.0f")
    _draw_parts(figure.add_subplot(grid[1, :]), blow.parts)
    return figure


class View(NamedTuple):
    """A side of a head: its title, the quadrilaterals that are seen, places of all nodes [mm], and what is upwards."""

    title: str
    quads: NDArray[Any]
    along: NDArray[Any]
    height: NDArray[Any]
    label: str


def _views(surface: SurfaceStress, loft: float) -> list[View]:
    """Return the sides of a head that show its walls."""
    corners = surface.nodes[surface.quads]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    out, up = np.array([np.cos(loft), np.sin(loft), 0.0]), np.array([-np.sin(loft), np.cos(loft), 0.0])
    ahead, vertical, toe = np.eye(3)
    sides = {
        "face": (out, up, "up the face (mm)"),
        "back": (-out, up, "up the face (mm)"),
        "crown": (vertical, ahead, "to the target (mm)"),
        "sole": (-vertical, ahead, "to the target (mm)"),
    }
    along = from_si(surface.nodes @ toe, "mm")
    views = []
    for name in surface.views:
        towards, height, label = sides[name]
        visible = normals @ towards > FACING
        views.append(View(name, surface.quads[visible], along, from_si(surface.nodes @ height, "mm"), label))
    return views


def _draw_view(axes: Axes, view: View, values: NDArray[Any], blow: BlowStress) -> None:
    """Draw contours of the stress at nodes [MPa], and a cross at the largest if it is seen."""
    triangles = np.vstack([view.quads[:, :3], view.quads[:, [0, 2, 3]]])
    levels = np.linspace(0.0, values.max(), LEVELS + 1)
    axes.tricontourf(Triangulation(view.along, view.height, triangles), values, levels=levels, cmap=COLOUR_MAP)
    peak = max(blow.parts, key=lambda part: part.stress)
    at = int(((blow.surface.nodes - np.array(peak.place)) ** 2).sum(axis=1).argmin())
    if at in view.quads:
        axes.plot(view.along[at], view.height[at], marker="x", color="black", markersize=7.0)
    axes.set_aspect("equal")
    axes.set_title(view.title)
    axes.set_xlabel("to the toe (mm)")
    axes.set_ylabel(view.label)
    axes.grid(visible=False)


def _draw_parts(axes: Axes, parts: Sequence[PartStress]) -> None:
    """Draw a bar a part, and a line across it where the metal yields, if that is known."""
    for row, part in enumerate(parts):
        yields = part.margin is not None and part.margin < 0.0
        axes.barh(row, from_si(part.stress, "MPa"), height=0.6, color=COLOURS[1 if yields else 0],
                  hatch="////" if yields else None, edgecolor="white", linewidth=0.0)  # fmt: skip
        if part.yield_stress is not None:
            at = from_si(part.yield_stress, "MPa")
            axes.plot([at, at], [row - 0.42, row + 0.42], color="black", linewidth=2.0)
    axes.set_yticks(range(len(parts)), [part.part for part in parts])
    axes.set_ylim(len(parts) - 0.4, -0.6)
    axes.set_xlabel("largest stress (MPa); the black line is where the metal yields, hatched bars are beyond it")
