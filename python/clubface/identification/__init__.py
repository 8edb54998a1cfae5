"""Model parameters from measured shots, and how well they are known."""

from clubface.identification.result import Identification as Identification
from clubface.identification.run import identify as identify

__all__ = ["Identification", "identify"]
