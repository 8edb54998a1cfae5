"""The time history of one contact: forces, sliding, motion of both bodies, energy."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import model as model_named, models
from clubface.errors import InputError
from clubface.results.result import Result
from clubface.simulation.impact import Parameters, backend_of, warn_if_outside
from clubface.simulation.inputs import DeliveryLike, HandLike, as_values, prepare, tolerance
from clubface.simulation.launch import Launch
from clubface.simulation.results import Series, Variable, in_unit
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import check_choice

_STEPS = {
    "normal_force": ("N", "normal force on the ball"),
    "force_y": ("N", "friction on the ball along y' (up the face)"),
    "force_z": ("N", "friction on the ball along z' (towards the toe)"),
    "penetration": ("m", "penetration of ball and face"),
    "sliding_y": ("m/s", "sliding velocity of the ball's surface on the face along y'"),
    "sliding_z": ("m/s", "sliding velocity of the ball's surface on the face along z'"),
    "contact_area": ("m2", "area of the contact"),
    "face_depth": ("m", "inward displacement of the face, beyond that included in the parameters"),
    "kinetic_energy": ("J", "kinetic energy of both bodies"),
    "face_energy": ("J", "elastic energy of the face in that displacement"),
    "layer_energy": ("J", "energy stored between cover and core of the ball"),
    "normal_work": ("J", "work absorbed so far by the normal force, stored and dissipated"),
    "friction_work": ("J", "work absorbed so far by friction"),
    "layer_work": ("J", "work absorbed so far by the damper between cover and core"),
}
_VECTORS = {
    "ball_position": ("m", "centre of the ball from the clubhead's CG at first touch"),
    "ball_velocity": ("m/s", "velocity of the ball"),
    "ball_spin": ("rad/s", "angular velocity of the ball: its total angular momentum over its inertia"),
    "cover_spin": ("rad/s", "angular velocity of the cover of a ball with two layers, else of the ball"),
    "core_spin": ("rad/s", "angular velocity of the core of a ball with two layers, else of the ball"),
    "club_position": ("m", "clubhead's CG from where it was at first touch"),
    "club_velocity": ("m/s", "velocity of the clubhead's CG"),
    "club_spin": ("rad/s", "angular velocity of the clubhead"),
}
_ATTITUDE = {
    "club_attitude": ("1", "attitude of the clubhead from first touch, in face axes: quaternion w, x, y, z"),
}
_RINGS = {
    "ring_traction_y": ("Pa", "traction of each ring on the ball along y'"),
    "ring_traction_z": ("Pa", "traction of each ring on the ball along z'"),
    "ring_slip": ("1", "1 where the ring slips, 0 where it sticks or is outside the contact"),
    "ring_inside": ("1", "1 where the ring is inside the contact"),
}
_RADIUS = {"ring_radius": ("m", "mid-radius of each ring")}
_TIME = Variable("time", "s", "time since first touch")


class History(Series):
    """Time history of one contact from first touch to separation; every quantity is an attribute [SI].

    Forces are those on the ball; y' points up the face and z' towards the toe at the contact point. Vectors of the
    bodies are in world axes: x to the target, y up, z to the right. For a left-handed club, y', z' and the club's
    attitude are those of its mirror image.

    Attributes
    ----------
    time
        Time since first touch [s], shape (n,).
    normal_force, force_y, force_z
        Normal force and friction on the ball [N], shape (n,).
    penetration, face_depth
        Penetration of ball and face, and inward displacement of the face [m], shape (n,).
    sliding_y, sliding_z
        Sliding velocity of the ball's surface on the face [m/s], shape (n,).
    contact_area
        Area of contact [m2], shape (n,).
    kinetic_energy, face_energy, layer_energy, normal_work, friction_work, layer_work
        The energy balance [J], shape (n,).
    ball_position, ball_velocity, ball_spin, cover_spin, core_spin, club_position, club_velocity, club_spin
        Motion of both bodies [m, m/s, rad/s], shape (n, 3).
    club_attitude
        Attitude of the clubhead as a quaternion w, x, y, z, shape (n, 4).
    ring_radius, ring_traction_y, ring_traction_z, ring_slip, ring_inside
        State of the contact rings of models that have them [m, Pa, 1], shape (n, rings).
    launch
        The launch at the end of the contact.
    """

    time: Floats
    normal_force: Floats
    force_y: Floats
    force_z: Floats
    penetration: Floats
    sliding_y: Floats
    sliding_z: Floats
    contact_area: Floats
    face_depth: Floats
    kinetic_energy: Floats
    face_energy: Floats
    layer_energy: Floats
    normal_work: Floats
    friction_work: Floats
    layer_work: Floats
    ball_position: Floats
    ball_velocity: Floats
    ball_spin: Floats
    cover_spin: Floats
    core_spin: Floats
    club_position: Floats
    club_velocity: Floats
    club_spin: Floats
    club_attitude: Floats

    _coordinates = {"axis": list("xyz"), "component": list("wxyz")}  # noqa: RUF012

    def __init__(self, arrays: Mapping[str, Floats], launch: Launch) -> None:
        self._arrays = arrays
        self.launch = launch

    def __getattr__(self, name: str) -> Floats:
        if name.startswith("_") or name not in self._arrays:
            raise AttributeError(f"a history by {self.launch.model} has no {name!r}" if name[0] != "_" else name)
        return self._arrays[name]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._arrays})

    def _second(self, name: str) -> str:
        return "axis" if name in _VECTORS else "component" if name in _ATTITUDE else "ring"

    @property
    def quantities(self) -> dict[str, Variable]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """Quantities of the history by name, with unit and meaning."""
        table = _STEPS | _VECTORS | _ATTITUDE | _RINGS | _RADIUS
        known = {name: Variable(name, *each) for name, each in table.items() if name in self._arrays}
        return {"time": _TIME, **known}

    @property
    def provenance(self) -> dict[str, Any]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """The model, its parameters, club, ball, delivery and version."""
        return self.launch.provenance

    def get(self, name: str, unit: str | None = None) -> Floats:
        """Return a quantity by name in SI, or in ``unit``: ``get("time", "us")``."""
        check_choice("quantity", name, self.quantities)
        value = self._arrays[name]
        return value if unit is None else in_unit(value, self.quantities[name], unit)

    def to_result(self) -> Result:
        """Return contact time and peak force, and a table of all steps."""
        from clubface.simulation.shot_result import history_result

        return history_result(self)

    def __repr__(self) -> str:
        return (
            f"history of a contact by {self.launch.model}: {len(self)} steps, {units.show(self.time[-1], 'us', 4)},"
            f" peak {units.show(self.launch.peak_force, 'kN', 4)}"
        )


def history(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: str = "volumetric",
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    **values: ValueLike | None,
) -> History:
    """Compute the time history of one contact; arguments as for :func:`impact`, for a single shot.

    Raises
    ------
    InputError
        As for :func:`impact`, or the model is an impulse model, which does not follow the contact in time.
    """
    if model_named(model).kind != "contact":
        contact = [name for name, each in models().items() if each.kind == "contact"]
        raise InputError("model", model, f"a contact model, which has a time scale: {', '.join(contact)}")
    accuracy = tolerance(accuracy)
    prepared = prepare(model, club, as_values(delivery, values), ball, parameters, hand, single="a history")
    try:
        arrays = backend_of(model).history(model, prepared.shots.columns, prepared.parameters, accuracy)
    except ValueError as error:
        raise prepared.error(error) from None
    launch = Launch(arrays.pop("launch").reshape(-1, 1), prepared.shots, model, prepared.chosen, accuracy)
    warn_if_outside((launch,))
    return History(arrays, launch)
