"""Results to play with: one HTML file in which a reader chooses sheet and strain, and a film."""
