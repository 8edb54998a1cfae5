"""Files that describe themselves: a dataclass is the schema of its TOML file.

Its fields define how files and mappings are read, with errors that name file, line and key, how objects made in Python
are checked, how files and templates are written, and which keys pages and editors list.
"""

from __future__ import annotations

from clubface.schema.document import Document as Document, Place as Place, quoted as quoted
from clubface.schema.tables import (
    FILES as FILES,
    Entry as Entry,
    Table as Table,
    check_values as check_values,
    decode as decode,
    encode as encode,
    entries as entries,
    file_key as file_key,
    file_schema as file_schema,
    json_schema as json_schema,
    key_rows as key_rows,
    quantities as quantities,
    template as template,
    written_key as written_key,
)
from clubface.schema.values import (
    FLAG as FLAG,
    NAME as NAME,
    TEXT as TEXT,
    Choice as Choice,
    Either as Either,
    FilePath as FilePath,
    Interval as Interval,
    Items as Items,
    PhysicalValue as PhysicalValue,
    Record as Record,
    Reference as Reference,
    Simple as Simple,
    Tables as Tables,
    Unread as Unread,
    Value as Value,
    count as count,
    written as written,
)

__all__ = [
    "FILES", "FLAG", "NAME", "TEXT", "Choice", "Document", "Either", "Entry", "FilePath", "Interval", "Items",
    "PhysicalValue", "Place", "Record", "Reference", "Simple", "Table", "Tables", "Unread", "Value", "check_values",
    "count", "decode", "encode", "entries", "file_key", "file_schema", "json_schema", "key_rows", "quantities",
    "quoted", "template", "written", "written_key",
]  # fmt: skip
