"""Exports for other programs: inputs for the C interface, functions for CasADi, functional mock-up units for FMI.

The package computes nothing here; it writes the inputs for compiled libraries.
"""

from clubface.export.casadi import casadi_source
from clubface.export.fmu import write_fmu
from clubface.export.inputs import inputs_csv

__all__ = ["casadi_source", "inputs_csv", "write_fmu"]
