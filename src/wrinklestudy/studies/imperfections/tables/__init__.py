"""The tables of the study of imperfections, one module each."""
