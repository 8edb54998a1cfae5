"""The units of the core are those of the package, and every column of the core is a quantity of its table."""

from __future__ import annotations

from clubface import _core
from clubface.units import UNITS, key


def test_the_core_has_the_units_of_the_package() -> None:
    known = {
        key(spelling): (each["symbol"], each["dimension"], each["numerator"], each["denominator"], each["offset"])
        for each in _core.units()
        for spelling in (each["symbol"], *each["spellings"])
    }
    assert known == {spelling: tuple(unit) for spelling, unit in UNITS.items()}


def test_columns_are_quantities() -> None:
    quantities = {each["name"]: each for each in _core.quantities()}
    for column in (*_core.inputs(), *_core.outputs(), *_core.flight_inputs(), *_core.flight_outputs()):
        assert column["unit"] == quantities[column["name"]]["unit"]
        meaning = quantities[column["name"]]["meaning"]
        assert meaning
        assert column["meaning"].startswith(meaning)
