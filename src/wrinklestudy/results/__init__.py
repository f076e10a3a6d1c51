"""Cases, paths, files and tables: what a study keeps, and how it is read back."""
