"""What the compiled core computes of impacts and flights; the one place where this room names it."""

from clubface._core import (
    flight_inputs as flight_inputs,
)
from clubface._core import (
    flight_outputs as flight_outputs,
)
from clubface._core import (
    fly as fly,
)
from clubface._core import (
    fly_sensitivity as fly_sensitivity,
)
from clubface._core import (
    history as history,
)
from clubface._core import (
    impact as impact,
)
from clubface._core import (
    inputs as inputs,
)
from clubface._core import (
    outputs as outputs,
)
from clubface._core import (
    pressure_at_altitude as pressure_at_altitude,
)
from clubface._core import (
    sensitivities as sensitivities,
)
from clubface._core import (
    sensitivity as sensitivity,
)
from clubface._core import (
    trajectory as trajectory,
)
