"""Runs a syntax tree: statements, expressions, instructions and functions."""
