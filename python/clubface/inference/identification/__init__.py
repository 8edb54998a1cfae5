"""Model parameters from measured shots, and how well the shots determine them.

:func:`clubface.identify` does the whole identification. The documentation page "Parameters from measured shots"
describes the method.
"""

from clubface.inference.identification.result import Identification as Identification
from clubface.inference.identification.run import identify as identify
