"""The further tables of the study, one module each."""
