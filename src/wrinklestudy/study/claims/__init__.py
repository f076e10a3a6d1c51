"""Claims: statements about results, and how a verdict is reached."""
