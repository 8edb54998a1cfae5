"""The compiled core: arrays in, arrays out, all values SI and radians."""

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

from numpy import float64, uint64
from numpy.typing import NDArray

Column: TypeAlias = float | NDArray[float64]
Problems: TypeAlias = list[tuple[int, str, str]]

def quantities() -> list[dict[str, Any]]: ...
def units() -> list[dict[str, Any]]: ...
def dimensions() -> list[dict[str, Any]]: ...
def models() -> list[dict[str, Any]]: ...
def inputs() -> list[dict[str, Any]]: ...
def outputs() -> list[dict[str, Any]]: ...
def flight_inputs() -> list[dict[str, Any]]: ...
def flight_outputs() -> list[dict[str, Any]]: ...
def pressure_at_altitude(altitude: float) -> float: ...
def impact(
    model: str,
    inputs: Sequence[Column],
    parameters: Sequence[Column],
    n: int,
    accuracy: float | None = None,
    threads: int = 0,
    progress: Callable[[int], object] | None = None,
) -> tuple[NDArray[float64], Problems]: ...
def check(group: str, inputs: Sequence[float]) -> tuple[str, str] | None: ...
def sensitivity(
    model: str, inputs: Sequence[float], parameters: Sequence[float], accuracy: float | None = None
) -> tuple[NDArray[float64], NDArray[float64]]: ...
def sensitivities(
    model: str,
    inputs: Sequence[Column],
    parameters: Sequence[Column],
    n: int,
    outputs: Sequence[int],
    variables: Sequence[int],
    accuracy: float | None = None,
    threads: int = 0,
    progress: Callable[[int], object] | None = None,
) -> tuple[NDArray[float64], Problems]: ...
def history(
    model: str, inputs: Sequence[float], parameters: Sequence[float], accuracy: float | None = None
) -> dict[str, NDArray[float64]]: ...
def quasi_random(dimensions: int, count: int, seed: int = 0, first: int = 0, threads: int = 0) -> NDArray[float64]: ...
def golfer_deliveries(
    mean: Sequence[float],
    root: Sequence[float],
    mirrored: Sequence[bool],
    mishit_share: float,
    mishit_scale: float,
    uniform: Sequence[NDArray[float64]],
    threads: int = 0,
) -> NDArray[float64]: ...

class ShotTally:
    def __init__(
        self, quantities: Sequence[tuple[float, float, int, float]], landing: Sequence[int] | None = None
    ) -> None: ...
    @property
    def shots(self) -> int: ...
    @property
    def lost(self) -> int: ...
    def add(self, columns: Sequence[NDArray[float64]], threads: int = 0) -> None: ...
    def mean(self, quantity: int) -> float: ...
    def spread(self, quantity: int) -> float: ...
    def quantile(self, quantity: int, share: float) -> float: ...
    def histogram(self, quantity: int, width: float) -> tuple[NDArray[float64], NDArray[uint64]]: ...
    def landing(self) -> tuple[list[float], list[float]]: ...
    def ellipse(self, share: float) -> tuple[list[float], list[float], float]: ...

def fly(
    inputs: Sequence[Column], n: int, threads: int = 0, progress: Callable[[int], object] | None = None
) -> tuple[NDArray[float64], Problems]: ...
def trajectory(inputs: Sequence[float]) -> dict[str, NDArray[float64]]: ...
def fly_sensitivity(inputs: Sequence[float]) -> tuple[NDArray[float64], NDArray[float64]]: ...
def fly_sensitivities(
    inputs: Sequence[Column],
    n: int,
    outputs: Sequence[int],
    variables: Sequence[int],
    threads: int = 0,
    progress: Callable[[int], object] | None = None,
) -> tuple[NDArray[float64], Problems]: ...

class FemImpact:
    """An impact by finite elements after its run, in SI units; every array is a copy."""

    peak_force: float
    peak_force_time: float
    contact_time: float
    tangential_max: float
    tangential_min: float
    reversal_time: float
    spin_max: float
    contraction: float
    contraction_time: float
    f_prime: float
    f: float
    energy_error: float
    steps: int
    step: float
    safety: float
    wall: float
    over_edge: bool
    ball_nodes: int
    stopped: str | None
    failed: bool
    interrupted: bool
    unfinished: bool
    launch: NDArray[float64] | None
    ball_velocity: NDArray[float64]
    ball_spin: NDArray[float64]
    axes: NDArray[float64]
    attitude: NDArray[float64]
    frame_velocity: NDArray[float64]
    contact: dict[str, NDArray[float64]]
    motion: dict[str, NDArray[float64]]
    energy: dict[str, NDArray[float64]]
    patch: dict[str, NDArray[float64]]
    frame_times: NDArray[float64]
    frames: NDArray[float64]
    fields: list[list[NDArray[Any]]]

def fem_laws() -> list[dict[str, Any]]: ...
def fem_check_law(law: str, constants: list[float]) -> None: ...
def fem_shear(law: str, constants: list[float]) -> tuple[float, list[float]]: ...
def fem_ball(ball: dict[str, Any]) -> dict[str, Any]: ...
def fem_mesh(ball: dict[str, Any]) -> dict[str, Any]: ...
def fem_variables(case: dict[str, Any]) -> list[str]: ...
def fem_sensitivity(
    case: dict[str, Any],
    directions: Sequence[Sequence[tuple[str, float]]],
    progress: Callable[[int, float, float], object] | None = None,
) -> tuple[NDArray[float64], NDArray[float64]]: ...
def fem_impact(case: dict[str, Any], progress: Callable[[float, float], object] | None = None) -> FemImpact: ...
def fem_driver(driver: dict[str, Any]) -> dict[str, Any]: ...
def fem_iron(shape: dict[str, float], elements: Sequence[int]) -> dict[str, Any]: ...
def fem_head_properties(head: dict[str, Any]) -> dict[str, Any]: ...
def fem_yield_stress(metal: dict[str, Any], strains: Sequence[float]) -> list[float]: ...
def fem_thickness_points(count: int, rule: str) -> list[tuple[float, float]]: ...
