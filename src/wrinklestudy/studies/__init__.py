"""Studies: each a folder with its theory, figures and claims."""
