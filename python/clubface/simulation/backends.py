"""What computes a model: the compiled core for the reduced ones, or the module that is registered for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol

from clubface.equipment.backends import MODULES, OWN
from clubface.simulation import core

if TYPE_CHECKING:
    from numpy.typing import NDArray

Problems = list[tuple[int, str, str]]
"""Row, name of the input at fault, and reason of each shot without a launch."""


class Balls(NamedTuple):
    """A ball as a backend computes it, and as the inputs of a shot describe it.

    Attributes
    ----------
    own
        What the backend takes; None where the inputs say everything.
    described
        As of :func:`clubface.ball`.
    """

    own: Any
    described: Any


class Request(NamedTuple):
    """Shots to compute: a column an input and parameter, each a number or an array of ``size`` numbers.

    Attributes
    ----------
    own
        The ball as :meth:`Backend.balls` gave it.
    club
        As of :func:`clubface.club`; the inputs hold its values, some of which a shot may have changed.
    on_error
        As of :func:`clubface.impact`: with "nan", what goes wrong with one shot does not stop the others.
    """

    own: Any
    club: Any
    model: str
    inputs: Sequence[Any]
    parameters: Sequence[Any]
    size: int
    accuracy: float | None
    threads: int
    progress: Callable[[int], object] | None
    on_error: Literal["raise", "nan"] = "raise"


class Backend(Protocol):
    """What computes the launches of a model."""

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the ball that ``given`` means; refuse an accuracy that the backend does not take."""
        ...

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Return outputs by shots, NaN for those without a launch, and what kept them from having one."""
        ...

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> Mapping[str, Any] | None:
        """Return the forces of one shot over time as :class:`clubface.History` names them, None without a contact."""
        ...

    def history(self, model: str, inputs: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Return what :class:`clubface.History` holds, and the "launch"; asked of contact models alone."""
        ...


class ReducedCore:
    """The reduced models."""

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the ball as it is."""
        return Balls(None, given)

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Compute all shots at once."""
        return core.impact(
            shots.model, shots.inputs, shots.parameters, shots.size, shots.accuracy, shots.threads, shots.progress
        )

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> Mapping[str, Any] | None:
        """Return None: :func:`clubface.history` tells more."""
        return None

    def history(self, model: str, inputs: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Compute one contact and keep every step."""
        return core.history(model, inputs, parameters, accuracy)


REDUCED = ReducedCore()


def backend_of(model: str) -> Backend:
    """Return what computes a model; of an unknown one, its parameters say that there is none."""
    if not isinstance(model, str):
        return REDUCED
    if model in OWN:
        return OWN[model].BACKEND
    return import_module(MODULES[model]).BACKEND if model in MODULES else REDUCED
