"""Files, whatever they hold: whole or absent, and tables of numbers that people bring."""
