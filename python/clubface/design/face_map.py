"""Maps of a face: launch and flight all over it, the best point, the cost of scattered impacts, differences."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from clubface import units
from clubface.design.contributions import QUANTITIES, quantities, symbol
from clubface.design.dispersion import ImpactSetup
from clubface.design.face_surface import FaceImpacts, Outline, Surface, interpolated_surface, outline_of, run_points
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.models import DEFAULT_MODEL, MODULES
from clubface.errors import InputError, RangeWarning, RunError, Wording
from clubface.results.result import Described, Result
from clubface.results.table import Table
from clubface.simulation.flight import AirLike, GroundLike, WindLike, check_conditions
from clubface.simulation.impact import Parameters, impact
from clubface.simulation.inputs import DeliveryLike, as_values
from clubface.simulation.launch import Launch
from clubface.simulation.results import attributes, flattened, outputs
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import check_choice, check_share, check_text, is_count, is_number, without_warnings

if TYPE_CHECKING:
    import xarray


class Forgiveness(NamedTuple):
    """What impacts scattered around a point cost.

    Attributes
    ----------
    toe, high, toe_deviation, high_deviation
        Mean and standard deviations of the impact point [m].
    missed
        Share of swings that miss the face; they do not enter the other values.
    mean, deviation, loss
        Mean and standard deviation of every quantity of a map, and its value at the mean impact point minus the mean
        [SI], by name.
    """

    toe: float
    high: float
    toe_deviation: float
    high_deviation: float
    missed: float
    mean: dict[str, float]
    deviation: dict[str, float]
    loss: dict[str, float]


GRID = (101, 101)
COARSE = (9, 7)
"""Default numbers of points towards the toe and upwards, for a fast model and for a slow one."""
LEAST, MOST = 3, 2001
"""Minimum and maximum number of points along a side of the grid."""
MOST_LONG = 1000
"""Maximum number of points for a slow model."""
SHARE = 0.98
"""Share of the best ball speed above which a point belongs to the effective face."""


class Best(NamedTuple):
    """Where a quantity is greatest: the point ``toe``, ``high`` [m], and its ``value`` there [SI]."""

    toe: float
    high: float
    value: float


class _Mapped(Described):
    """Common interface of a map and of the difference of two maps."""

    toe: Floats
    high: Floats
    outline: Outline

    @property
    def maps(self) -> list[FaceMap]:
        """The map, or both maps of a difference."""
        raise NotImplementedError

    def get(self, name: str, unit: str | None = None) -> Floats:
        """Return a quantity over the grid, in SI or in ``unit``."""
        raise NotImplementedError

    def box(self, name: str) -> tuple[Floats, Floats, Floats]:
        """Return grid coordinates towards the toe and upwards [m], and a quantity [SI] over the face's bounding box."""
        raise NotImplementedError

    def columns(self) -> dict[str, Floats]:
        """Return ``toe``, ``high`` and every quantity [SI] as columns, with a row for each point of the face."""
        toe, high = np.meshgrid(self.toe, self.high)
        inside = self.outline.holds(toe, high)
        return {"toe": toe[inside], "high": high[inside], **{name: self.get(name)[inside] for name in QUANTITIES}}

    def all_points(self) -> Table:
        """Return :meth:`columns` as a table."""
        from clubface.design.face_map_result import points_table

        return points_table(self)

    def to_result(self, quantities: Sequence[str] = (), scatter: Sequence[Forgiveness] = ()) -> Result:
        """Return the map as a result, with the cost of ``scatter``: :meth:`FaceMap.forgiveness` of each map.

        ``quantities`` are listed, drawn and tabulated over the grid; by default eight are listed and drawn.
        """
        from clubface.design.face_map_result import face_map_result

        return face_map_result(self, quantities, scatter)


class FaceMap(_Mapped):
    """Launch and flight over a face, in SI units; arrays have the shape (high, toe), with NaN outside the face.

    Attributes
    ----------
    toe, high
        Coordinates of the grid [m], from the face centre towards the toe and upwards.
    outline
        The outline of the face.
    centre
        A launch at the face centre, with model, parameters, club, ball and delivery.
    interpolated
        Whether values between the points, the best point, areas and forgiveness are interpolated, as they are for a
        slow model, rather than computed.
    """

    def __init__(
        self, toe: Floats, high: Floats, table: Floats, outline: Outline, surface: Surface,
        centre: Launch, conditions: Mapping[str, Any] | None = None,
    ) -> None:  # fmt: skip
        self.toe, self.high, self.outline, self.centre = toe, high, outline, centre
        self.surface, self.conditions = surface, dict(conditions or {})
        self._table = table
        self.interpolated = surface.interpolated

    @property
    def maps(self) -> list[FaceMap]:
        """This map, as a list."""
        return [self]

    def get(self, name: str, unit: str | None = None) -> Floats:
        """Return a quantity over the grid, in SI or in ``unit``."""
        check_choice("quantity", name, QUANTITIES)
        values = self._table[QUANTITIES.index(name)]
        return values if unit is None else units.from_si(values, symbol(name, unit))

    def at(self, toe: ValueLike, high: ValueLike) -> dict[str, Floats]:
        """Return all quantities [SI] by name at points [m] of the face."""
        toe, high = np.broadcast_arrays(
            units.parse_values(toe, "length", name="toe"), units.parse_values(high, "length", name="high")
        )
        result = self.surface.at(toe.reshape(-1), high.reshape(-1))
        return {name: row.reshape(toe.shape) for name, row in zip(QUANTITIES, result, strict=True)}

    def best(self, name: str = "ball_speed") -> Best:
        """Return the point where a quantity is greatest; for ball speed this is the sweet spot."""
        check_choice("quantity", name, QUANTITIES)
        return Best(*self.surface.greatest(QUANTITIES.index(name)))

    def area(self, share: float = SHARE) -> float:
        """Return the area [m2] of the face where the ball speed is at least a ``share`` of the best."""
        check_share(share)
        return self.surface.area(QUANTITIES.index("ball_speed"), share * self.best().value)

    def forgiveness(
        self, spread: tuple[float | str, float | str], *, toe: float | str = 0.0, high: float | str = 0.0
    ) -> Forgiveness:
        """Return the cost of impacts with independent normal scatter towards the toe and upwards.

        Expectations are integrals over the face by Gauss's rule: from heel to toe, and at each place from its lower to
        its upper edge.

        ``spread`` holds the standard deviations, and ``toe`` and ``high`` are the mean impact point, in metres or as
        text with a unit. Raises an :class:`InputError` if a standard deviation is not positive or exceeds the size of
        the face, or if the point is not on the face.
        """
        if not isinstance(spread, (tuple, list)) or len(spread) != 2:
            raise InputError("spread", spread, "two standard deviations, towards the toe and upwards")
        deviations = [units.parse(each, "length", name="spread") for each in spread]
        about = [units.parse(each, "length", name=name) for each, name in ((toe, "toe"), (high, "high"))]
        size = self.outline.greatest - self.outline.least
        for each, most in zip(deviations, size, strict=True):
            if not 0.0 < each <= most:
                raise InputError("spread", units.show(each, "mm"), f"above 0 and at most {units.show(most, 'mm', 3)}")
        if not self.outline.holds(*about):
            raise InputError("the point", ", ".join(units.show(each, "mm") for each in about), "on the face")
        missed, *costs = self.outline.in_core().scatter(about, deviations, self.surface.at)
        named = [dict(zip(QUANTITIES, each, strict=True)) for each in costs]
        return Forgiveness(about[0], about[1], deviations[0], deviations[1], missed, *named)

    def box(self, name: str) -> tuple[Floats, Floats, Floats]:
        """Return places towards the toe and upwards [m], and a quantity [SI] over the whole box around the face.

        It extends beyond the outline, so that a picture can be clipped to it, and has a fine grid for an interpolated
        map.
        """
        check_choice("quantity", name, QUANTITIES)
        return self.surface.toe, self.surface.high, self.surface.table[QUANTITIES.index(name)]

    def to_xarray(self, name: str | None = None) -> xarray.Dataset:
        """Return a dataset over ``high`` and ``toe`` [SI] with provenance, or a table of :meth:`to_result`."""
        if name is not None:
            return self.to_result().to_xarray(name)
        import xarray

        variables = {
            name: (("high", "toe"), self.get(name), attributes(each.unit, each.meaning))
            for name, each in quantities().items()
        }
        attrs = {**flattened(self.centre.provenance), "outline": self.outline.origin}
        return xarray.Dataset(variables, {"toe": self.toe, "high": self.high}, attrs=attrs)

    def __repr__(self) -> str:
        speeds = self.get("ball_speed")
        up, across = np.unravel_index(np.nanargmax(speeds), speeds.shape)
        place = ", ".join(units.fixed(float(each), "mm", 1) for each in (self.toe[across], self.high[up]))
        return (
            f"map of the face of {self.centre.club.name} by {self.centre.model}, {len(self.toe)} by {len(self.high)}:"
            f" greatest ball speed of its points {units.fixed(float(speeds[up, across]), 'mph', 1)} at {place}"
        )


def map_face(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    grid: tuple[int, int] | None = None,
    points: tuple[ValueLike, ValueLike] | None = None,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    output: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    **values: float | str | None,
) -> FaceMap:
    """Map launch and flight over a face.

    The clubhead delivery is the same at every point; dynamic loft and face angle refer to the face centre, and bulge
    and roll change them across the face. Each point is, bit for bit, the shot of :func:`clubface.impact` and
    :func:`clubface.fly`.

    Parameters
    ----------
    club, delivery, model, parameters, ball, accuracy, **values
        As for :func:`clubface.impact`, for a single shot without ``toe`` and ``high``.
    grid
        Numbers of points towards the toe and upwards, over the bounding box of the face; default 101 by 101, or 9 by 7
        for a slow model.
    points
        Instead of a grid: coordinates towards the toe and upwards [m], each increasing.
    air, wind, ground
        Conditions of the flights, as for :func:`clubface.fly`.
    output, workers
        For a slow model: the output file, and number of points computed at a time (default one per core). Finished
        points are kept in a folder next to the file until it is written; the same call then resumes.
    progress
        Called with the number of points done and the total.

    Raises
    ------
    InputError
        The delivery is not a single shot or includes an impact point, the grid is too coarse or too fine, or an option
        has no effect with this model.
    RunError
        No point of the face has a shot.
    """
    chosen = club_of(club)
    check_conditions(air, wind, ground)
    check_text("model", model)
    if workers is not None and model not in MODULES:
        raise InputError("workers", workers, f"leave it out: {model} computes all points at once")
    given = dict(as_values(delivery, values))
    for name in ("toe", "high"):
        struck = given.pop(name, None)  # a Delivery has zeros there
        if struck is not None and not (is_number(struck) and struck == 0.0):
            raise InputError(name, struck, "left out or zero: a map strikes the whole face")
    if model in MODULES:
        from clubface.simulation.impact import backend_of
        from clubface.simulation.inputs import equipped, shots

        described = backend_of(model).balls(ball, accuracy).described
        equipment, parameters_used = equipped(model, chosen, described, parameters)
        with without_warnings(RangeWarning):
            impact(chosen, given, ball=described)  # refuses a delivery that no model takes
        shot = shots(equipment, given)
        centre = Launch(np.full((len(outputs()), 1), np.nan), shot, model, parameters_used, accuracy)
    else:
        with without_warnings(RangeWarning):
            centre = impact(chosen, given, model=model, parameters=parameters, ball=ball, accuracy=accuracy)
    setup = ImpactSetup(chosen, model, centre.parameters, ball, air, wind, ground, accuracy=accuracy)
    settled = FaceImpacts(setup, given)
    if centre.shape:
        raise InputError("delivery", Wording(f"a batch of shape {centre.shape}"), "a single one")
    outline = outline_of(chosen)
    toe, high = _points(outline, grid, points, long=settled.takes_long)
    across, up = (each.reshape(-1) for each in np.meshgrid(toe, high))
    if settled.takes_long:
        inside = outline.holds(across, up)
        table = np.full((len(QUANTITIES), across.size), np.nan)
        places = across[inside], up[inside]
        table[:, inside] = run_points(settled, *places, output=output, workers=workers, progress=progress)
        surface = interpolated_surface(outline, toe, high, table)
    else:
        table = settled.at(across, up, remark=True, progress=progress)
        grid_table = table.reshape(len(QUANTITIES), len(high), len(toe))
        surface = Surface(outline, settled.at, toe, high, grid_table)
    table = np.where(outline.holds(across, up), table, np.nan).reshape(len(QUANTITIES), len(high), len(toe))
    if not np.isfinite(table).any():
        raise RunError("no impact point on the face gives a shot")
    return FaceMap(toe, high, table, outline, surface, centre, {"air": air, "wind": wind, "ground": ground})


def checked_grid(grid: Any) -> tuple[int, int]:
    """Return the numbers of points towards the toe and upwards, checked."""
    asked = tuple(grid) if isinstance(grid, Iterable) else ()
    if len(asked) != 2 or not all(is_count(each, LEAST, MOST) for each in asked):
        raise InputError("grid", grid, f"two whole numbers from {LEAST} to {MOST}, as in 101 by 101")
    return int(asked[0]), int(asked[1])


def _points(outline: Outline, grid: Any, points: Any, *, long: bool) -> tuple[Floats, Floats]:
    """Return the grid coordinates towards the toe and upwards [m]."""
    if points is not None:
        if grid is not None:
            raise InputError("grid", grid, "leave out either points or grid")
        if not isinstance(points, (tuple, list)) or len(points) != 2:
            raise InputError("points", points, "coordinates towards the toe and upwards")
        toe, high = (np.atleast_1d(units.parse_values(each, "length", name="points")) for each in points)
        for each in (toe, high):
            rising = each.ndim == 1 and np.isfinite(each).all() and (np.diff(each) > 0.0).all()
            if not rising or not 1 <= each.size <= MOST:
                raise InputError("points", each, f"1 to {MOST} increasing numbers")
        counts = (len(toe), len(high))
    else:
        counts = checked_grid((COARSE if long else GRID) if grid is None else grid)
        ends = zip(outline.least.tolist(), outline.greatest.tolist(), counts, strict=True)
        toe, high = (np.linspace(least, greatest, count) for least, greatest, count in ends)
    if long and counts[0] * counts[1] > MOST_LONG:
        raise InputError("grid", f"{counts[0]} by {counts[1]}", f"at most {MOST_LONG} points for a slow model")
    return toe, high


class FaceMapDifference(_Mapped):
    """The map of one face minus the map of another on the same points.

    Attributes
    ----------
    first, second
        The maps; the second is subtracted from the first.
    toe, high, outline
        Coordinates of the grid [m], and outline of the first face.
    """

    def __init__(self, first: FaceMap, second: FaceMap) -> None:
        for name, each in (("first", first), ("second", second)):
            if not isinstance(each, FaceMap):
                raise InputError(name, each, "a map from clubface.map_face")
        if not (np.array_equal(first.toe, second.toe) and np.array_equal(first.high, second.high)):
            allowed = "a map of the points of the first: points=(first.toe, first.high)"
            raise InputError("second", Wording("a map of other points"), allowed)
        self.first, self.second = first, second
        self.toe, self.high, self.outline = first.toe, first.high, first.outline

    @property
    def maps(self) -> list[FaceMap]:
        """Both maps."""
        return [self.first, self.second]

    def get(self, name: str, unit: str | None = None) -> Floats:
        """Return the difference of a quantity over the grid, in SI or in ``unit``; NaN where either map has no shot."""
        result = self.first.get(name) - self.second.get(name)
        return result if unit is None else result / units.size(symbol(name, unit))

    def box(self, name: str) -> tuple[Floats, Floats, Floats]:
        """Return the difference as :meth:`FaceMap.box` does; NaN outside the second face if its outline differs."""
        check_choice("quantity", name, QUANTITIES)
        toe, high, values = self.first.box(name)
        across, up = np.meshgrid(toe, high)
        if self.second.interpolated:
            other = self.second.surface.at(across.reshape(-1), up.reshape(-1))[QUANTITIES.index(name)]
            other = other.reshape(values.shape)
        else:
            other = self.second.box(name)[2]
        result = values - other
        if not np.array_equal(self.outline.corners, self.second.outline.corners):
            result = np.where(self.second.outline.holds(across, up), result, np.nan)
        return toe, high, result
