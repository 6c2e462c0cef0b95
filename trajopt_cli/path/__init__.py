"""Segments of a path: where a line, arc, dwell, joint move or corner leads, as numbers and as expressions."""
