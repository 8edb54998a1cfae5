"""``FORMATS``: the layouts that can be read, by name. A new layout is one file, and one line here."""

from __future__ import annotations

from collections.abc import Mapping

from clubface.launch_monitor import flightscope, foresight, garmin, gspro, rapsodo, square, trackman
from clubface.launch_monitor.formats import Format
from clubface.support.frozen import Frozen

_LAYOUTS = (
    trackman.FORMAT, foresight.PLAY, foresight.FSX_2020, garmin.FORMAT, rapsodo.FORMAT, flightscope.FORMAT,
    gspro.FORMAT, square.FORMAT,
)  # fmt: skip
FORMATS: Mapping[str, Format] = Frozen({each.name: each for each in _LAYOUTS})
