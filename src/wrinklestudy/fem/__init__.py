"""Finite elements on the part of the sheet that is solved, and its boundary conditions."""
