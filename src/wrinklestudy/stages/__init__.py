"""The entries of the jobs: each reads its input files, calls the library and writes its output."""
