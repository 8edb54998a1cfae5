"""``FORMATS``: the layouts that can be read, by name. A new layout is one file, and one line here."""

from __future__ import annotations

from collections.abc import Mapping

from clubface.launch_monitor import flightscope, foresight, garmin, rapsodo, trackman
from clubface.launch_monitor.formats import Format

FORMATS: Mapping[str, Format] = {
    each.name: each
    for each in (
        trackman.FORMAT,
        foresight.PLAY,
        foresight.FSX_2020,
        garmin.FORMAT,
        rapsodo.FORMAT,
        flightscope.FORMAT,
    )
}
