"""Distances between bodies, by coal."""
