"""The figure of the study of imperfections."""
