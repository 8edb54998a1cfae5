"""Reports: one file with text, tables, pictures, their data, and what it all was computed from."""
