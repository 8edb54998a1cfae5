"""Tables in CSV, Parquet and Excel: headings, rows and cells, read and written a chunk at a time."""
