"""Captured deliveries with uncertainty; as a result: values, how they are known, and plots."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.capture.geometry import Known
from clubface.capture.reduction import QUANTITIES
from clubface.capture.rotations import Array
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.quantities import format_value, quantity
from clubface.results.notes import Note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Described, Provenance, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.recorded import RejectedRow
from clubface.shots.recorded_result import rejected_table
from clubface.simulation.inputs import OF_CLUB, Delivery
from clubface.support.checks import MOST_SEED, check_choice, check_count
from clubface.support.files import whole_file
from clubface.support.processes import check_request
from clubface.units import to_si


class Trace(NamedTuple):
    """Motion of a head through a recording, in world axes."""

    times: Array  # of the frames [s]
    face_centre: Array  # [m], shape (frames, 3); NaN without a pose
    loft: Array  # dynamic loft [rad], shape (frames,)
    face: Array  # face angle [rad], shape (frames,)
    residual: Array  # root mean square residual between markers and head along an axis [m], shape (frames,)
    ball: Array  # centre of the ball at rest [m], shape (3,)
    radius: float  # of the ball [m]


@dataclass(frozen=True, kw_only=True, eq=False)
class CapturedDelivery(Described):
    """A delivery from motion capture with its uncertainty, in SI units.

    Attributes
    ----------
    delivery
        Delivery at first touch, with the signs of :class:`Delivery`.
    uncertainty
        Standard deviation of each value [SI], by name.
    covariance
        Covariance of the values in the order of the delivery, shape (11, 11). It includes marker noise, possible
        deviations of the path between last frame and impact, and the uncertainties of the ball's position and of the
        club relative to its markers.
    launch
        ``ball_speed``, ``launch`` and ``azimuth`` [SI] of the ball; empty if its flight is not seen.
    launch_uncertainty
        Their standard deviations [SI].
    club
        The club.
    estimator
        Name of the estimator that extrapolated the path to impact.
    time
        Time of first touch from the first frame [s].
    frames
        Numbers in the file of the frames before and after first touch.
    used
        Number of frames before impact used by the estimator.
    marker_noise
        Standard deviation of a marker along an axis [m].
    marker_noise_freedom
        Degrees of freedom of this estimate; 0 if the noise was given.
    misfit
        Residuals of the path relative to their expected size. Above 1.5 the uncertainty is too small. NaN for
        ``linear``.
    notes
        Caveats about the result, warnings first.
    geometry
        How markers, club and ball are known: measured, given, or assumed with a standard deviation.
    trace
        Motion of the head through the recording, for plots.
    source
        The file.
    """

    delivery: Delivery
    uncertainty: dict[str, float]
    covariance: Array
    launch: dict[str, float]
    launch_uncertainty: dict[str, float]
    club: Club
    estimator: str
    time: float
    frames: tuple[int, int]
    used: int
    marker_noise: float
    marker_noise_freedom: int
    misfit: float
    notes: tuple[Note, ...]
    geometry: tuple[Known, ...]
    trace: Trace
    source: str

    @property
    def plausible(self) -> bool:
        """Whether the delivery is physically plausible; if not, the first note says what is wrong."""
        return "capture-not-plausible" not in {each.code for each in self.notes}

    def interval(self, name: str, level: float = 0.95) -> tuple[float, float]:
        """Return the interval [SI] that contains a value with probability ``level``."""
        check_choice("delivery value", name, QUANTITIES)
        if not 0.0 < level < 1.0:
            raise InputError("level", level, "between 0 and 1")
        half = NormalDist().inv_cdf(0.5 + 0.5 * level) * self.uncertainty[name]
        value = getattr(self.delivery, name)
        return value - half, value + half

    def get(self, name: str, unit: str) -> tuple[float, float]:
        """Return a delivery value and its standard deviation in the given unit."""
        check_choice("delivery value", name, QUANTITIES)
        units.unit(unit, name=name, dimension=OF_CLUB[name])
        return units.from_si(getattr(self.delivery, name), unit), units.from_si(self.uncertainty[name], unit)

    def sample(self, count: int, seed: int = 0) -> dict[str, Array]:
        """Draw ``count`` random deliveries from the covariance; return arrays by name, for :func:`impact`."""
        count, seed = check_count("count", count, 1, 2**32), check_count("seed", seed, 0, MOST_SEED)
        check_request(count, 4 * 8 * len(QUANTITIES))
        values = np.array([getattr(self.delivery, name) for name in QUANTITIES])
        drawn = np.random.default_rng(seed).multivariate_normal(values, self.covariance, size=count, method="eigh")
        return dict(zip(QUANTITIES, drawn.T, strict=True))

    def to_result(self) -> Result:
        """Return the delivery as a result."""
        return captured_result([self])

    def __repr__(self) -> str:
        return str(self.to_result())


LAUNCHES = ("ball_speed", "launch", "azimuth")
SHOWN = ("speed", "attack", "path", "loft", "face", "toe", "high", "closure")
"""Quantities printed for several swings."""
BEFORE, AFTER = 0.06, 0.02
"""Time before and after impact plotted of path and face [s]."""
ALONG = (-0.48, 0.24)
"""Range of the path plotted along the target line [m]: three frames at 360 Hz before impact."""


def captured_result(captured: Sequence[CapturedDelivery], rejected: Iterable[RejectedRow] = ()) -> Result:
    """Return the deliveries of one or several swings, and the files without one, as a result."""
    alone, refused = len(captured) == 1, list(rejected)
    title = f"{captured[0].club.name}, {captured[0].estimator}" if captured else "no swing"
    tables = [_deliveries(captured), _swings(captured), _geometry(captured), _covariances(captured)]
    return Result(
        kind="captured-swings", title=f"{captured[0].source}: {title}" if alone else title,
        tables=(*(each for each in tables if captured), *([rejected_table(refused, "file")] if refused else [])),
        notes=captured[0].notes if alone else notes_by_file(captured),
        provenance=Provenance(inputs={"club": captured[0].club.name} if captured else {}),
        draw=lambda: [swing_picture(each) for each in captured],
    )  # fmt: skip


def notes_by_file(captured: Iterable[CapturedDelivery]) -> tuple[Note, ...]:
    """Return the notes of several swings, each with its file name."""
    return tuple(each.of(in_files=[Path(one.source).name]) for one in captured for each in one.notes)


def _deliveries(captured: Sequence[CapturedDelivery]) -> Table:
    """Return the values and their standard deviations, two rows per swing."""
    alone, launches = len(captured) == 1, any(each.launch for each in captured)

    def values(name: str) -> list[float]:
        if name in LAUNCHES:
            return [row.get(name, np.nan) for each in captured for row in (each.launch, each.launch_uncertainty)]
        return [value for each in captured for value in (getattr(each.delivery, name), each.uncertainty[name])]

    return table(
        "deliveries", text("swing", [each.source for each in captured for _ in (0, 1)], printed=not alone),
        text("figure", ["delivery", "standard deviation"] * len(captured)),
        *(
            column(name, values(name), digits=0 if quantity(name).golf.unit == "deg/s" else 2,
                   printed=alone or name in SHOWN)
            for name in (*QUANTITIES, *(LAUNCHES if launches else ()))
        ),
        layout="transposed" if alone else "rows",
    )  # fmt: skip


def _swings(captured: Sequence[CapturedDelivery]) -> Table:
    """Return a table of how each swing was read."""
    alone = len(captured) == 1

    def texts(name: str, get: Callable[[CapturedDelivery], Any], **options: Any) -> Column:
        return text(name, [get(each) for each in captured], **options)

    return table(
        "swings", texts("swing", lambda each: each.source, printed=not alone),
        texts("club", lambda each: each.club.name, printed=False),
        texts("hand", lambda each: "left" if each.club.hand < 0 else "right", printed=False),
        texts("estimator", lambda each: each.estimator, printed=False),
        column("first_touch_time", [each.time for each in captured], "time", label="first touch", digits=6),
        texts("frame_before", lambda each: each.frames[0], label="after frame"),
        texts("frame_after", lambda each: each.frames[1], printed=False),
        texts("frames_used", lambda each: each.used),
        column("marker_noise", [each.marker_noise for each in captured], "radius", label="marker noise", digits=3),
        texts("marker_noise_freedom", lambda each: each.marker_noise_freedom, printed=False),
        column("misfit", [each.misfit for each in captured], "1", printed=False),
        texts("plausible", lambda each: each.plausible, printed=False),
        title="How it was read", layout="list" if alone else "rows", printed=alone,
    )  # fmt: skip


def _geometry(captured: Sequence[CapturedDelivery]) -> Table:
    """Return how markers, club and ball are known, one number per row; rows that swings share are printed once."""
    rows = [
        (each.source, part.name, part.how, part.quantity, value, deviation)
        for each in captured
        for part in each.geometry
        for value, deviation in part.pairs()
    ]
    swings, names, ways, quantities, values, deviations = zip(*rows, strict=True)
    known: dict[Any, int] = {}
    for place, row in enumerate(rows):
        known.setdefault(row[1:], place)
    own = [quantity(each) if each else None for each in quantities]
    return table(
        "geometry", text("swing", swings, printed=False), text("quantity", names), text("known", ways),
        Column("value", values, own, digits=-3), Column("deviation", deviations, own, digits=-3, label="±"),
        title="How the geometry is known", shown_rows=list(known.values()),
    )  # fmt: skip


def _covariances(captured: Sequence[CapturedDelivery]) -> Table:
    """Return the covariances of the deliveries [SI], one quantity per row."""
    every = np.concatenate([each.covariance for each in captured])
    return table(
        "covariances", text("swing", [each.source for each in captured for _ in QUANTITIES]),
        text("quantity", [*QUANTITIES] * len(captured)),
        *(text(name, each) for name, each in zip(QUANTITIES, every.T, strict=True)), printed=False,
    )  # fmt: skip


def swing_picture(swing: CapturedDelivery) -> Picture:
    """Plot path, face angles and residuals of a swing, to judge whether its delivery can be trusted.

    Two panels show the face centre and the ball from the side and from above, with filled markers before impact, open
    ones after, and a line in the head's direction at first touch. Two show dynamic loft and face angle in each frame,
    with the delivery and twice its standard deviation. The last shows the residual between the markers and the rigid
    head in each frame.
    """
    trace = swing.trace
    time = trace.times - swing.time
    residual = Panel(
        [
            Mark("line", time, trace.residual), Mark("rule", y=swing.marker_noise, style=1, dash=1),
            Mark("rule", x=0.0, style=-1),
        ],
        axis("time", "time from first touch", unit="s"), axis("residual", "", like="m", unit="mm", limits=(0.0, None)),
        "marker residual in each frame; dashed: the noise used for the standard deviations",
    )  # fmt: skip
    return Picture(
        "swing", "Path of the face centre, dynamic loft, face angle, and residuals of the markers",
        [
            [_view(swing, time, 1, "up", "attack", "from the side")],
            [_view(swing, time, 2, "to the right", "path", "from above")],
            [_angle(swing, time, "loft", trace.loft), _angle(swing, time, "face", trace.face)], [residual],
        ],
        f"{Path(swing.source).name}: {swing.club.name}, {swing.estimator}", heights=(1.0, 1.0, 1.2, 0.8), height=7.2,
    )  # fmt: skip


def _view(swing: CapturedDelivery, time: Array, row: int, up: str, angle: str, title: str) -> Panel:
    """Plot the path of the face centre to the ball, seen from one side."""
    trace = swing.trace
    centre = trace.face_centre - trace.ball
    near = (time > -BEFORE) & (time < AFTER)
    inside = near & (centre[:, 0] > ALONG[0]) & (centre[:, 0] < ALONG[1])
    limits = _limits(np.array([*centre[inside, row], -2.0 * trace.radius, 2.0 * trace.radius]), 1e-3)
    turn = np.linspace(0.0, 2.0 * np.pi, 60)
    marks = [
        *_frames(centre[:, 0], centre[:, row], time),
        Mark("outline", trace.radius * np.cos(turn), trace.radius * np.sin(turn), style=1, dash=0, label="ball"),
        Mark("slope", 0.0, 0.0, values=float(np.tan(getattr(swing.delivery, angle))), style=1, dash=1),
    ]
    return Panel(
        marks, axis("along", "to the target", like="m", unit="mm", limits=ALONG),
        axis("across", up, like="m", unit="mm", limits=limits),
        f"{title}; dashed: {quantity(angle).label} of {_with_deviation(swing, angle)}", equal=True, legend=row == 1,
    )  # fmt: skip


def _angle(swing: CapturedDelivery, time: Array, name: str, values: Array) -> Panel:
    """Plot dynamic loft or face angle in each frame, with the delivery and twice its standard deviation."""
    value, deviation = getattr(swing.delivery, name), swing.uncertainty[name]
    low, high = value - 2.0 * deviation, value + 2.0 * deviation
    recent = values[(time > -0.5 * BEFORE) & (time <= 0.0)]
    marks = [
        *_frames(time, values, time),
        Mark("intervals", np.zeros(1), np.array([value]), y0=np.array([low]), y1=np.array([high]), style=1, symbol="s"),
    ]
    limits = _limits(np.array([*recent, low, high]), to_si(1.0, "deg"))
    title = f"{quantity(name).label}: {_with_deviation(swing, name)}"
    return Panel(marks, axis("time", "time from first touch", unit="ms"), axis(name, limits=limits), title)


def _frames(x: Array, y: Array, time: Array) -> list[Mark]:
    """Return frames near impact as points, filled before it and open after."""
    before, after = (time > -BEFORE) & (time <= 0.0), (time > 0.0) & (time < AFTER)
    return [
        Mark("points", x[before], y[before], label="face centre before impact"),
        Mark("points", x[after], y[after], label="after", hollow=True),
    ]


def _with_deviation(swing: CapturedDelivery, name: str) -> str:
    values = getattr(swing.delivery, name), swing.uncertainty[name]
    value, deviation = (format_value(each, quantity(name)) for each in values)
    return f"{value.split(' ')[0]} ± {deviation}"


def _limits(values: Array, least: float) -> tuple[float, float]:
    """Return axis limits around the values with a margin of at least ``least``."""
    known = values[np.isfinite(values)]
    low, high = float(known.min()), float(known.max())
    room = max(0.08 * (high - low), least)
    return low - room, high + room


def save_swings(swings: Iterable[CapturedDelivery], path: str | os.PathLike[str]) -> Path:
    """Save the plot of one swing as a picture, or of several as pages of a PDF; return the file."""
    from matplotlib.backends.backend_pdf import PdfPages

    from clubface.present.drawing import draw
    from clubface.present.style import save

    target, pictures = Path(path), [swing_picture(each) for each in swings]
    if len(pictures) == 1:
        return save(draw(pictures[0]), target)
    with whole_file(target) as file, PdfPages(file, metadata={"CreationDate": None}) as pages:
        for each in pictures:
            pages.savefig(draw(each))
    return target
