"""The one contract of all results: tables of quantities, notes, pictures and provenance, at full precision."""

from clubface.results.notes import Note as Note, note as note
from clubface.results.result import Provenance as Provenance, Result as Result
from clubface.results.table import Column as Column, Table as Table, column as column, text as text

__all__ = ["Column", "Note", "Provenance", "Result", "Table", "column", "note", "text"]
