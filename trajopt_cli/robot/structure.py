"""The kinds of arm trajopt knows."""

from __future__ import annotations

from enum import Enum

NO_CONFDATA = "none"
"""The rule of a robot whose joints RAPID's confdata does not describe."""


class Structure(Enum):
    """A robot file's structure: which closed form fits the arm."""

    SIX_AXIS = "six_axis"
    """Six axes, spherical wrist; alone or on a rail. Runs RAPID programs."""
    SRS = "srs"
    """Seven axes: spherical shoulder, elbow, spherical wrist. Runs Cartesian segments."""
