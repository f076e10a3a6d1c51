"""Finite elements on the quarter sheet."""
