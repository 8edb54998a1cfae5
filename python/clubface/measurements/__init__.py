"""Published figures to hold a model against: tables in SI, each with where it was printed and what is in doubt.

The files are ``clubface/data/measurements/*.toml``, one for each subject, with long tables as CSV files beside them. A
column is headed by its name and unit, as in ``spin [rpm]``; a column without a unit holds words.

``names()`` lists the tables, and ``table("pga-2019")["ball_speed"]`` is a column in m/s.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from clubface.errors import UnknownNameError
from clubface.measurements.file import KINDS as KINDS, read as read
from clubface.measurements.published import PublishedTable as PublishedTable
from clubface.support.frozen import Frozen
from clubface.support.shipped import DATA, builtin_names

_FOLDER = "measurements"


@cache
def subjects() -> Mapping[str, Mapping[str, PublishedTable]]:
    """Return the tables of every subject by name."""
    return Frozen({name: Frozen(read(DATA / _FOLDER / f"{name}.toml")) for name in builtin_names(_FOLDER)})


def names() -> tuple[str, ...]:
    """List the names of all tables, subject by subject."""
    return tuple(name for tables in subjects().values() for name in tables)


def table(name: str) -> PublishedTable:
    """Return the table called ``name``, as in ``names()``."""
    for tables in subjects().values():
        if name in tables:
            return tables[name]
    raise UnknownNameError("published table", name, names())
