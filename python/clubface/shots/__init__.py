"""Shots: files and live messages of launch monitors, recorded, measured and predicted shots.

:func:`read` reads a file, and ``clubface.shots.open_connect`` exchanges shots over a socket.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from clubface.shots import open_connect as open_connect
    from clubface.shots.conditions import Match as Match, match_shots as match_shots
    from clubface.shots.formats import Field as Field, Format as Format
    from clubface.shots.loft_origin import LoftOrigin as LoftOrigin, loft_origins as loft_origins
    from clubface.shots.measured import (
        MeasuredShots as MeasuredShots,
        ReadyShots as ReadyShots,
        measured_shots as measured_shots,
        ready_shots as ready_shots,
    )
    from clubface.shots.mishits import Mishit as Mishit, Statistic as Statistic, find_mishits as find_mishits
    from clubface.shots.monitors import (
        FORMATS as FORMATS,
        format_result as format_result,
        formats_result as formats_result,
    )
    from clubface.shots.reading import read as read
    from clubface.shots.recorded import (
        RejectedRow as RejectedRow,
        assume_values as assume_values,
        join_sessions as join_sessions,
    )
    from clubface.shots.recorded_result import shots_result as shots_result
    from clubface.shots.reference_points import refer as refer
    from clubface.shots.session_summary import (
        ClubSummary as ClubSummary,
        session_result as session_result,
        summarize_clubs as summarize_clubs,
    )

_NAMES = {
    "conditions": "Match match_shots",
    "formats": "Field Format",
    "loft_origin": "LoftOrigin loft_origins",
    "measured": "MeasuredShots ReadyShots measured_shots ready_shots",
    "mishits": "Mishit Statistic find_mishits",
    "monitors": "FORMATS format_result formats_result",
    "reading": "read",
    "recorded": "RejectedRow assume_values join_sessions",
    "recorded_result": "shots_result",
    "reference_points": "refer",
    "session_summary": "ClubSummary session_result summarize_clubs",
}
_HOME = {name: module for module, names in _NAMES.items() for name in names.split()}

_MODULES = ("open_connect",)

__all__ = [*_HOME, *_MODULES]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return import_module(f"clubface.shots.{name}")
    if name not in _HOME:
        raise AttributeError(f"module 'clubface.shots' has no attribute {name!r}")
    return getattr(import_module(f"clubface.shots.{_HOME[name]}"), name)
