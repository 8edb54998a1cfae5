"""Messages of OpenGolfSim's Developer API, from monitors to the simulator: one JSON object per line over TCP.

The fields follow help.opengolfsim.com, *Shot Data API*: ``ballSpeed`` in mph, or m/s if ``unit`` is metric, angles in
degrees and ``spinSpeed`` in rpm. ``spinAxis`` is positive to the right, according to the page's example, and
``horizontalLaunchAngle`` is assumed to be. There are no club data and no shot number. The page documents no answers;
the simulator sends ``{"status": 200}``, or 400 with an error.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from clubface.errors import InputError
from clubface.results.notes import Note
from clubface.shots.messages import Message, MessageError, in_si, numbers_of, object_of, shot_message, whole_spin
from clubface.shots.open_connect import Dialect
from clubface.support.sockets import LOOPBACK, Connection
from clubface.units import from_si

PORT = 3111
DEVICE = "OpenGolfSim"
"""Name for monitors, which the protocol does not name."""
UNITS = {"imperial": "mph", "metric": "m/s"}
FIELDS = {
    "ballSpeed": ("ball_speed", "mph"),
    "verticalLaunchAngle": ("launch", "deg"),
    "horizontalLaunchAngle": ("azimuth", "deg"),
    "spinSpeed": ("total_spin", "rpm"),
    "spinAxis": ("spin_axis", "deg"),
}
"""Quantity and unit of each field of a shot."""
LINE_END = b"\n"
NEEDED = ("ballSpeed", "verticalLaunchAngle", "horizontalLaunchAngle")


def from_json(data: Mapping[str, Any]) -> Message:
    """Return the message in a JSON object; a ``MessageError`` names the field at fault."""
    kind = data.get("type")
    if kind == "device":
        status = data.get("status")
        if status not in ("ready", "busy"):
            raise MessageError("status must be ready or busy")
        return Message(kind="status", device=DEVICE, is_ready=status == "ready")
    if kind != "shot":
        raise MessageError("type must be shot or device")
    shot = object_of(data, "shot")
    unit = data.get("unit", "imperial")
    if not isinstance(unit, str) or unit not in UNITS:
        raise MessageError("unit must be imperial or metric")
    notes: list[Note] = []
    given = numbers_of(shot, FIELDS, "shot.", notes, NEEDED)
    if not given["ballSpeed"] > 0.0:
        raise MessageError("shot.ballSpeed must be above 0")
    if given.get("spinSpeed") == 0.0 == given.get("spinAxis", 0.0):  # from a monitor that does not measure spin
        given = {name: value for name, value in given.items() if not name.startswith("spin")}
    fields = FIELDS | {"ballSpeed": ("ball_speed", UNITS[unit])}
    return shot_message(Message(kind="shot", device=DEVICE, launch=in_si(given, fields), notes=tuple(notes)))


def to_json(launch: Mapping[str, float]) -> dict[str, Any]:
    """Return the message of a shot.

    The launch is in SI, with at least ``ball_speed`` and ``launch``, and any two of the spin quantities; a warning
    reports what is assumed if these are missing. A missing ball speed or launch angle raises an ``InputError``.
    """
    for name in ("ball_speed", "launch"):
        if name not in launch:
            raise InputError(name, None, "given, since a message to a simulator needs it")
    values = {"azimuth": 0.0, **launch, **whole_spin(launch)}
    shot = {name: float(from_si(values[quantity], unit)) for name, (quantity, unit) in FIELDS.items()}
    return {"type": "shot", "unit": "imperial", "shot": shot}


OPENGOLFSIM = Dialect(
    "opengolfsim",
    PORT,
    from_json,
    lambda message: {"status": 200},
    lambda reason: {"status": 400, "error": reason},
    LINE_END,
)


class OpenGolfSimSender:
    """Sends shots to the simulator, without waiting for answers, since none are documented.

    Raises a ``LinkError`` if nobody listens there, or the connection was lost.
    """

    def __init__(self, port: int = PORT, *, host: str = LOOPBACK, timeout: float = 5.0) -> None:
        self._connection = Connection(port, host=host, timeout=timeout)
        self._connection.send({"type": "device", "status": "ready"}, LINE_END)

    def send(self, launch: Mapping[str, float], delivery: object = None) -> None:
        """Send a launch; the protocol has no club data."""
        self._connection.receive(0.0)  # the data are ignored, but a closed connection is noticed here
        self._connection.send(to_json(launch), LINE_END)

    def close(self) -> None:
        """Close the connection."""
        self._connection.close()
