"""The figures of the study beyond the paper, one module each, as those of the paper."""
