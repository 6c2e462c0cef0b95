"""Time-optimal timing of fixed joint paths."""
