"""Thin faces of the timing libraries: one path or one point-to-point move in, the shortest time out."""
