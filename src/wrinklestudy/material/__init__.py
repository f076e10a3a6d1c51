"""Measured stress-strain data, homogeneous deformations, and the fit of a law to them."""
