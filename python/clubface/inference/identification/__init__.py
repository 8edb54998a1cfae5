"""Model parameters from measured shots, and how well the shots determine them.

:func:`clubface.identify` does the whole identification. The documentation page "Parameters from measured shots"
describes the method.
"""

from clubface.inference.identification.intervals import (
    Direction as Direction,
    Identifiability as Identifiability,
    Profile as Profile,
)
from clubface.inference.identification.result import Deviation as Deviation, Identification as Identification
from clubface.inference.identification.run import identify as identify
from clubface.inference.identification.simulator import cost_of as cost_of

__all__ = ["Deviation", "Direction", "Identifiability", "Identification", "Profile", "cost_of", "identify"]
