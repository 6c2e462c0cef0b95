"""What every kind of segment offers, as numbers. One file per kind; the same as CasADi expressions stands beside it.

The parameter is the share s of a segment, 0 at its start and 1 at its end, and every rate is per unit of s. Lengths in
m and angles in rad belong to the whole segment, so a way of sigma metres is the share sigma / length.
"""

from __future__ import annotations

from typing import Protocol

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array

POINT = 1e-9  # m, rad: no way at all


class Segment(Protocol):
    """A way of the tool. Poses X_AT are seen from one frame A, the world unless the maker chose another.

    The tool's position and orientation are continuous over [0, 1], and their first derivatives, too. Their second ones
    may jump at the breaks; there they are the ones of what follows.
    """

    @property
    def length(self) -> float:
        """The tool centre point's way [m]."""

    @property
    def angle(self) -> float:
        """Reorientation on the way [rad]; turns back count, too."""

    @property
    def breaks(self) -> Array:
        """Shares (m,) inside (0, 1), ascending, where a second derivative may jump."""

    def pose(self, s: Array) -> Array:
        """X_AT (n, 4, 4) at shares s (n,)."""

    def twist(self, s: Array) -> Array:
        """First derivative (n, 6) by s: dp/ds [m] and the rate of turning [rad], both in the axes of A."""

    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6) by s: that of the twist."""


class JointSegment(Protocol):
    """A way of k axes [m, rad] in their own space; where the tool is on it only the robot knows."""

    @property
    def breaks(self) -> Array:
        """As of a Segment."""

    def axes(self, s: Array) -> Array:
        """Axis positions (n, k) at shares s (n,)."""

    def rate(self, s: Array) -> Array:
        """First derivative (n, k) by s."""

    def rate_change(self, s: Array) -> Array:
        """Second derivative (n, k) by s."""


def way(segment: Segment) -> tuple[float, str]:
    """How a segment's way is measured: length and "m", or for a turn in place angle and "rad"; 0 m for none."""
    if segment.length > POINT or segment.angle <= POINT:
        return segment.length, "m"
    return segment.angle, "rad"


def share_of(segment: Segment, sigma: float) -> float:
    """The share s that a part sigma of a segment's way is; sigma in the unit of way().

    Raises:
        InputError: the segment is no way, or sigma is not on it.
    """
    whole, unit = way(segment)
    if whole <= POINT:
        raise InputError("a segment that neither moves nor turns has no shares of its way")
    if not -POINT <= sigma <= whole + POINT:
        raise InputError(f"{sigma:g} {unit} is not on a segment of {whole:g} {unit}")
    return min(max(sigma / whole, 0.0), 1.0)


def check_shares(*shares: float) -> None:
    """Refuse what is no part of a segment.

    Raises:
        ValueError: a share is not in (0, 1].
    """
    for share in shares:
        if not 0 < share <= 1:
            raise ValueError(f"{share:g} is no share of a segment; give one above 0 and up to 1")
