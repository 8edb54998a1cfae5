"""Opening a file of shots, by the ending of its name."""

from __future__ import annotations

from pathlib import Path

from clubface.tables.csv_reader import CsvReader
from clubface.tables.parquet import ENDINGS, ParquetReader
from clubface.tables.rows import Reader


def open_table(path: Path) -> Reader:
    """Open a file of deliveries, Parquet by its ending, else CSV."""
    if path.suffix.lower() in ENDINGS:
        return ParquetReader(path)
    return CsvReader(path)
