"""Tables in CSV and Parquet: headings, rows and cells, read and written a chunk at a time."""
