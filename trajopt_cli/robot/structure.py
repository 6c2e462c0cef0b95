"""The kinds of arm trajopt knows."""

from __future__ import annotations

from enum import Enum


class Structure(Enum):
    """A robot file's structure: which closed form fits the arm."""

    SIX_AXIS = "six_axis"
    """Six axes, spherical wrist, ABB's axis directions; alone or on a rail. Runs RAPID programs."""
    SRS = "srs"
    """Seven axes: spherical shoulder, elbow, spherical wrist. Runs Cartesian segments."""
