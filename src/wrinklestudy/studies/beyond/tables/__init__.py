"""The further tables of the study, one module each: the numbers behind its figures."""
