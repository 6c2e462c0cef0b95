"""Factors from the units of RAPID, cell files and reports to SI: value_in_si = value * FACTOR."""

from __future__ import annotations

from math import pi

MM = 1e-3
DEG = pi / 180.0
