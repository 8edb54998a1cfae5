"""The kinds of file that clubface reads as TOML, by name; their modules are imported when one is asked for."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from clubface.schema.tables import Table
from clubface.schema.values import Value
from clubface.support.checks import check_choice

__all__ = ["FILES", "file_schema"]

FILES = {
    "club": "equipment.clubs.Club",
    "ball": "equipment.balls.Ball",
    "shaft": "equipment.shafts.Shaft",
    "parameters": "equipment.parameters.ParameterFile",
    "ball-of-pieces": "fem.balls.PIECES_FILE",
    "driver-head": "fem.heads.read.DRIVER_FILE",
    "iron-head": "fem.heads.read.IRON_FILE",
    "mesh-head": "fem.heads.read.MESH_FILE",
    "fem-case": "fem.case.CaseFile",
    "golfer": "design.golfer.GolferFile",
    "prior": "inference.prior.PriorFile",
    "optimisation": "design.optimisation.study.StudyFile",
    "fitting": "design.optimisation.study.FittingFile",
    "shells": "design.shells.study.ShellFile",
    "study": "studies.study.STUDY_FILE",
    "markers": "capture.markers.MarkerFile",
    "monitor-columns": "shots.formats.MappingFile",
    "published-tables": "published_data.PublishedFile",
}
"""Module and name of the dataclass, or of the kind of table, that each kind of file is read with."""


def file_schema(name: str) -> Value:
    """Return the kind of table that a file of the given kind is."""
    check_choice("kind of file", name, FILES)
    module, _, attribute = FILES[name].rpartition(".")
    schema: Any = getattr(import_module(f"clubface.{module}"), attribute)
    return schema if isinstance(schema, Value) else Table(schema)
