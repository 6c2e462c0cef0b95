"""Distances between placed bodies: the only room that knows the library that measures them."""
