"""What the groups compute with: problems and states of their own, closed forms, sweeps."""
