"""Tables in CSV and Parquet: headings, rows and cells, read and written a piece at a time."""
