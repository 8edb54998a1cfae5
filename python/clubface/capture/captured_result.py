"""Captured deliveries as a result: values with their standard deviations, how the geometry is known, and pictures."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.capture.reduction import QUANTITIES
from clubface.capture.rotations import Array
from clubface.quantities import format_value, quantity
from clubface.results.notes import free_text
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.provenance import Provenance
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.recorded import RejectedRow
from clubface.shots.recorded_result import rejected_table
from clubface.support.files import whole_file
from clubface.units import to_si

if TYPE_CHECKING:
    from clubface.capture.captured import CapturedDelivery

LAUNCHES = ("ball_speed", "launch", "azimuth")
SHOWN = ("speed", "attack", "path", "loft", "face", "toe", "high", "closure")
"""The quantities that are printed of many swings."""
BEFORE, AFTER = 0.06, 0.02
"""Seconds about impact that are drawn of path and face."""
ALONG = (-0.48, 0.24)
"""Metres along the target line that are drawn of the path: three frames of 360 Hz before impact."""


def captured_result(captured: Sequence[CapturedDelivery], rejected: Iterable[RejectedRow] = ()) -> Result:
    """Return the deliveries of one or several swings, and the files that gave none, as a result."""
    alone, refused = len(captured) == 1, list(rejected)
    title = f"{captured[0].club.name}, {captured[0].estimator}" if captured else "no swing"
    tables = [_deliveries(captured), _swings(captured), _geometry(captured), _covariances(captured)]
    return Result(
        kind="captured-swings", title=f"{captured[0].source}: {title}" if alone else title,
        tables=(*(each for each in tables if captured), *([rejected_table(refused, "file")] if refused else [])),
        notes=tuple(free_text([f"{'' if alone else f'{Path(one.source).name}: '}{each}"
                               for one in captured for each in one.notes])),
        provenance=Provenance(inputs={"club": captured[0].club.name} if captured else {}),
        draw=lambda: [swing_picture(each) for each in captured],
    )  # fmt: skip


def _deliveries(captured: Sequence[CapturedDelivery]) -> Table:
    """Return the values and their standard deviations, two rows a swing."""
    alone, launches = len(captured) == 1, any(each.launch for each in captured)

    def values(name: str) -> list[float]:
        if name in LAUNCHES:
            return [of.get(name, np.nan) for each in captured for of in (each.launch, each.launch_uncertainty)]
        return [of for each in captured for of in (getattr(each.delivery, name), each.uncertainty[name])]

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
    """Return how each swing was read."""
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
    """Return how markers, club and ball are known, a row a number; people see what several swings share once."""
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
    """Return the covariances of the deliveries [SI], a row a quantity."""
    every = np.concatenate([each.covariance for each in captured])
    return table(
        "covariances", text("swing", [each.source for each in captured for _ in QUANTITIES]),
        text("quantity", [*QUANTITIES] * len(captured)),
        *(text(name, each) for name, each in zip(QUANTITIES, every.T, strict=True)), printed=False,
    )  # fmt: skip


def swing_picture(swing: CapturedDelivery) -> Picture:
    """Return path, face and residuals of one swing, by which a reader sees whether to trust the delivery.

    Two panels show the face centre and the ball from the side and from above, frames before impact filled and later
    ones open; a line has the direction of the head at first touch. Two show dynamic loft and face angle frame by frame,
    with the delivery and twice its standard deviation. The last shows what is left between the markers and the rigid
    head in every frame.
    """
    trace = swing.trace
    time = trace.times - swing.time
    residual = Panel(
        [
            Mark("line", time, trace.residual), Mark("rule", y=swing.marker_noise, style=1, dash=1),
            Mark("rule", x=0.0, style=-1),
        ],
        axis("time", "time from first touch", unit="s"), axis("residual", "", like="m", unit="mm", limits=(0.0, None)),
        "residual of the markers in each frame; dashed: the noise that the deviations are made of",
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
    """Return the path of the face centre to the ball, from one side."""
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
    """Return dynamic loft or face angle frame by frame, with the delivery and twice its standard deviation."""
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
    """Return the frames about impact as points, those before it filled and later ones open."""
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
    """Return limits about values with some room, at least ``least``."""
    known = values[np.isfinite(values)]
    low, high = float(known.min()), float(known.max())
    room = max(0.08 * (high - low), least)
    return low - room, high + room


def save_swings(swings: Iterable[CapturedDelivery], path: str | os.PathLike[str]) -> Path:
    """Write one picture, or several swings as the pages of a PDF; return the file."""
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
