"""What the groups compute with: problems, states, closed forms, sweeps."""
