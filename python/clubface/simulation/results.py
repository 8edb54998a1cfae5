"""The common parts of launches, flights and histories: named arrays in SI with units and provenance."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from clubface import _core as core, units
from clubface.errors import ShotError
from clubface.quantities import display_unit
from clubface.results.notes import Note, note
from clubface.results.result import Presentable, Result
from clubface.results.table import Table, column
from clubface.support.arrays import Floats, NumberOrArray
from clubface.support.checks import Frozen, check_choice

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import NDArray


class Variable(NamedTuple):
    """One input or output of the core, in the order of its columns."""

    name: str  # as in keyword arguments and tables
    unit: str  # the SI unit it is held in
    meaning: str  # one line; states the positive direction of signed quantities
    group: str = ""  # group of an input: "delivery", "club", "ball", "parameters", "launch", "air" or "ground"
    differentiable: bool = False  # whether a launch can be differentiated with respect to it
    default: float = math.nan  # default of a flight input; NaN if it is required
    lower: float = -math.inf
    upper: float = math.inf

    @property
    def dimension(self) -> str:
        """The dimension, as named in ``units``."""
        return units.unit(self.unit).dimension


@cache
def inputs() -> Mapping[str, Variable]:
    """Return the inputs of an impact by name, in the order of the columns."""
    return _read(core.inputs())


@cache
def outputs() -> Mapping[str, Variable]:
    """Return the outputs of an impact by name, in order."""
    return _read(core.outputs())


@cache
def flight_inputs() -> Mapping[str, Variable]:
    """Return the inputs of a flight by name, in the order of the columns."""
    return _read(core.flight_inputs())


@cache
def flight_outputs() -> Mapping[str, Variable]:
    """Return the outputs of a flight by name, in order."""
    return _read(core.flight_outputs())


@cache
def input_columns() -> Mapping[str, int]:
    """Return the column of each input of an impact."""
    return Frozen({name: column for column, name in enumerate(inputs())})


@cache
def input_dimensions() -> Mapping[str, str]:
    """Return the dimension of each input of an impact."""
    return Frozen({name: each.dimension for name, each in inputs().items()})


def in_unit(value: Any, quantity: Variable, unit: str) -> Any:
    """Convert the SI ``value`` of ``quantity`` to ``unit``, which must have the same dimension."""
    units.unit(unit, name=quantity.name, dimension=quantity.dimension)
    return units.from_si(value, unit)


def _read(entries: list[dict[str, Any]]) -> Mapping[str, Variable]:
    known = Variable._fields
    return Frozen({entry["name"]: Variable(**{key: entry[key] for key in known if key in entry}) for entry in entries})


class ShotProblem(NamedTuple):
    """Why one shot of a batch has no result."""

    row: tuple[int, ...]  # its index in the batch
    parameter: str  # the input at fault
    reason: str  # its value and what is allowed


class Varied(NamedTuple):
    """An input that was given as an array."""

    values: NDArray[Any]  # as given, SI, not broadcast
    unit: str  # its SI unit
    meaning: str  # one line


class Batch(Presentable):
    """Named quantities of a batch of shots in SI and radians: arrays, or numbers for a single shot.

    Every quantity is an attribute. :meth:`get` converts it to another unit; :meth:`to_pandas` and :meth:`to_xarray`
    return tables of all quantities.
    """

    _kind: ClassVar[str] = "result"
    shape: tuple[int, ...]  # to which the inputs broadcast; () for a single shot
    _values: Floats
    _failures: Sequence[tuple[int, str, str]]

    @classmethod
    def quantities(cls) -> Mapping[str, Variable]:
        """Return the quantities by name, with unit and meaning."""
        raise NotImplementedError

    @classmethod
    @cache
    def _rows(cls) -> dict[str, int]:
        return {name: row for row, name in enumerate(cls.quantities())}

    def _headline(self) -> str:
        raise NotImplementedError

    def _assumptions(self) -> tuple[Note, ...]:
        """Return notes on the assumptions made for inputs that were not given."""
        return ()

    @property
    def provenance(self) -> dict[str, Any]:
        """The inputs, models and version that the result was computed with."""
        raise NotImplementedError

    @property
    def varied(self) -> Mapping[str, Varied]:
        """The inputs and parameters given as arrays, by name."""
        raise NotImplementedError

    @property
    def problems(self) -> tuple[ShotProblem, ...]:
        """The shots without a result, whose values are NaN, with the reasons."""
        return tuple(ShotProblem(index_of(row, self.shape), name, reason) for row, name, reason in self._failures)

    @property
    def units(self) -> dict[str, str]:
        """The SI unit of each quantity."""
        return {name: each.unit for name, each in self.quantities().items()}

    def __getattr__(self, name: str) -> NumberOrArray:
        row = None if name[0] == "_" else self._rows().get(name)
        if row is None:
            raise AttributeError(f"a {self._kind} has no {name!r}")
        return self._values[row].reshape(self.shape) if self.shape else self._values[row, 0]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.quantities()})

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError(f"a single {self._kind} has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        return True

    def get(self, name: str, unit: str | None = None) -> NumberOrArray:
        """Return a quantity by name in SI, or in ``unit``: ``get("backspin", "rpm")``."""
        check_choice("quantity", name, self.quantities())
        value = getattr(self, name)
        return value if unit is None else in_unit(value, self.quantities()[name], unit)

    def _varied_columns(self) -> dict[str, NDArray[Any]]:
        """Return the inputs given as arrays, one value per shot, except quantities of the result."""
        return {
            name: np.broadcast_to(each.values, self.shape).reshape(-1)
            for name, each in self.varied.items()
            if name not in self.quantities()
        }

    def to_pandas(self) -> pandas.DataFrame:
        """Return a frame with one row per shot: the inputs given as arrays, then every quantity, SI.

        ``attrs`` of the frame holds ``units`` and ``provenance``.
        """
        import pandas

        frame = pandas.DataFrame(self._varied_columns() | dict(zip(self.quantities(), self._values, strict=True)))
        frame.attrs = {
            "units": {name: each.unit for name, each in self.varied.items()} | self.units,
            "provenance": self.provenance,
        }
        return frame

    def to_xarray(self, dims: tuple[str, ...] | None = None) -> xarray.Dataset:
        """Return a dataset with one variable per quantity and the inputs given as arrays as coordinates, SI.

        Each variable carries ``units`` and ``long_name``, the dataset the provenance, as text that netCDF can hold. A
        dimension along which only one input varies is named after it; ``dims`` replaces these names.
        """
        import xarray

        dims = tuple(dims) if dims is not None else dimension_names(self.shape, self.varied)
        if len(dims) != len(self.shape):
            raise ValueError(f"{len(self.shape)} dimensions, but {len(dims)} names: {dims}")
        variables = {
            name: (dims, self._values[row].reshape(self.shape), attributes(each.unit, each.meaning))
            for row, (name, each) in enumerate(self.quantities().items())
        }
        coordinates = {}
        for name, each in self.varied.items():
            if name in variables or (name in dims and dims_of(each.values, dims) != (name,)):
                continue
            own = dims_of(each.values, dims)
            values = each.values.reshape([self.shape[dims.index(dim)] for dim in own])
            coordinates[name] = (own, values, attributes(each.unit, each.meaning))
        return xarray.Dataset(variables, coordinates, attrs=flattened(self.provenance))

    def to_result(self) -> Result:
        """Return a table with one row per shot: the inputs given as arrays, then every quantity."""
        from clubface.simulation.shot_result import batch_provenance

        varied = self.varied
        columns = [column(name, values, varied[name].unit) for name, values in self._varied_columns().items()]
        columns += [column(name, values) for name, values in zip(self.quantities(), self._values, strict=True)]
        problems = tuple(note("shot-without-result", row=list(each.row), reason=each.reason) for each in self.problems)
        table = Table(f"{self._kind}es" if self._kind == "launch" else f"{self._kind}s", tuple(columns))
        return Result(
            self._kind, self._headline(), (table,), notes=problems, assumptions=self._assumptions(),
            provenance=batch_provenance(self),
        )  # fmt: skip

    def __repr__(self) -> str:
        lines = [*(each.sentence for each in self._assumptions()), self._headline()]
        if self.shape:
            lines[-1] += f", shape {self.shape}"
            lines.append(f"  {'':<17} {'least':>11} {'mean':>11} {'greatest':>11}")
        if self._failures:
            lines.append(f"  {len(self._failures)} without a result; the first: {self._failures[0][2]}")
        for name, each in self.quantities().items():
            unit = display_unit(name, each.unit)
            values = units.from_si(self._values[self._rows()[name]], unit)
            values = values[values == values]
            if values.size:
                numbers = (values.min(), values.mean(), values.max()) if self.shape else (values[0],)
                text = " ".join(f"{number:>11.5g}" for number in numbers)
                lines.append(f"  {name:<17} {text} {'' if unit == '1' else unit}".rstrip())
        return "\n".join(lines)


class Series(Presentable):
    """Arrays over common times, SI: scalars, vectors and the like."""

    quantities: Mapping[str, Variable]  # by name; ``time`` is the first
    provenance: Mapping[str, Any]  # the inputs, models and version that it was computed with
    _arrays: Mapping[str, Floats]
    _coordinates: ClassVar[Mapping[str, list[str]]] = {"axis": list("xyz")}

    def __len__(self) -> int:
        return len(self._arrays["time"])

    @property
    def units(self) -> dict[str, str]:
        """The SI unit of each quantity."""
        return {name: each.unit for name, each in self.quantities.items()}

    def _second(self, name: str) -> str:
        """Return the name of the second dimension of an array, after time."""
        return "axis"

    def components(self) -> dict[str, tuple[Floats, str]]:
        """Return values over time and SI unit of each quantity; vectors by component, such as ``ball_spin_x``."""
        components = {}
        for name, each in self.quantities.items():
            values, second = self._arrays[name], self._second(name)
            if values.ndim == 1:
                components[name] = values, each.unit
                continue
            labels = self._coordinates.get(second) or [str(index) for index in range(values.shape[1])]
            for index, label in enumerate(labels):
                components[f"{name}_{label}"] = values[:, index], each.unit
        return components

    def to_pandas(self) -> pandas.DataFrame:
        """Return one row per time, SI; vectors become columns such as ``ball_spin_x``, rings ``ring_slip_0``."""
        import pandas

        components = self.components()
        frame = pandas.DataFrame({name: values for name, (values, _) in components.items()})
        frame.attrs = {
            "units": {name: unit for name, (_, unit) in components.items()}, "provenance": self.provenance,
        }  # fmt: skip
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Return a dataset over ``time``, with ``axis`` (x, y, z) for vectors."""
        import xarray

        variables = {}
        for name, each in self.quantities.items():
            values = self._arrays[name]
            dims = ("time",) if values.ndim == 1 else ("time", self._second(name))
            variables[name] = (dims, values, attributes(each.unit, each.meaning))
        coordinates = {"time": variables.pop("time"), **self._coordinates}
        return xarray.Dataset(variables, coordinates, attrs=flattened(self.provenance))


def attributes(unit: str, meaning: str) -> dict[str, str]:
    """Return the attributes of a dataset variable."""
    return {"units": unit, "long_name": meaning}


def dims_of(values: NDArray[Any], dims: tuple[str, ...]) -> tuple[str, ...]:
    """Return those of ``dims`` along which an array that broadcasts over them varies."""
    own = dims[len(dims) - values.ndim :]
    return tuple(dim for dim, size in zip(own, values.shape, strict=True) if size != 1)


def dimension_names(shape: tuple[int, ...], varied: Mapping[str, Varied]) -> tuple[str, ...]:
    """Name each dimension after the only input that varies along it; otherwise "shot" or "dim_0", "dim_1"."""
    plain = ("shot",) if len(shape) == 1 else tuple(f"dim_{axis}" for axis in range(len(shape)))
    names = list(plain)
    for axis, dim in enumerate(plain):
        along = {name: dims_of(each.values, plain) for name, each in varied.items()}
        varying = [name for name, own in along.items() if dim in own]
        if len(varying) == 1 and along[varying[0]] == (dim,):
            names[axis] = varying[0]
    return tuple(names)


def flattened(provenance: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """Flatten nested provenance to text by name, which every file format can hold."""
    flat: dict[str, str] = {}
    for key, value in provenance.items():
        if isinstance(value, Mapping) and key != "values":
            flat |= flattened(value, f"{prefix}{key}_")
        else:
            flat[prefix + key] = value if isinstance(value, str) else json.dumps(value, default=str)
    return flat


def index_of(row: int, shape: tuple[int, ...]) -> tuple[int, ...]:
    """Return the index in ``shape`` of a flat index ``row``."""
    return tuple(map(int, np.unravel_index(row, shape)))


def first_error(problems: list[tuple[int, str, str]], value: Any, shape: tuple[int, ...]) -> ShotError:
    """Return the error for the first shot without a result; ``value`` is the value of its input at fault."""
    row, name, reason = problems[0]
    return ShotError(name, value, reason, index_of(row, shape), len(problems) - 1)


def translate_core_error(error: ValueError, value_of: Callable[[str], Any]) -> ShotError:
    """Convert the core's ``ValueError(name, message)`` about one shot to an error of the package.

    ``value_of`` returns the value of an input by name [SI], or None if there is none.
    """
    name, message = error.args if len(error.args) == 2 else ("the request", str(error))
    return ShotError(name, value_of(name), message)
