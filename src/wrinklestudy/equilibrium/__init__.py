"""Equilibria of the sheet, flat and wrinkled, their stability, and branches over strain."""
