"""What the jobs do: each reads its input files, calls the library and writes its output."""
