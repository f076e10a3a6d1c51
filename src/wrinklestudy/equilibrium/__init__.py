"""Equilibria of the sheet: flat, wrinkled, their stability, branches of them."""
