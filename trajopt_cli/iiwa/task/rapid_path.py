"""The tool's way that a RAPID program's lines, arcs and zones prescribe, as a chain of poses near it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import ceil, radians, sqrt

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import FlyBy, PathMove, PoseMove
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.path.segment import Segment

_SHARE = 0.1  # of the tolerance that a chord may be away from its curve
_TURN = radians(2.0)  # from pose to pose at most, where orientations are to follow the program's
_FEWEST = 8  # pieces of a corner


def chain_of(
    moves: Sequence[PoseMove], zones: Mapping[int, FlyBy], tolerance: float
) -> tuple[Array, list[int], list[int]]:
    """Poses (n, 4, 4) of the tool from the first move's end to the last's, each within a tenth of tolerance [m] of the
    way; to which move each belongs; and which of them is the end of each move, that of a corner its middle.

    zones: the corners that are driven at ends of moves. Raises InputError for a MoveC whose points make no circle.
    """
    X, of, ends = [moves[0].X_WT[None]], [0], [0]
    ways: list[Segment] = []
    for before, move in pairwise(moves):
        assert isinstance(move, PathMove)
        ways.append(segment_of(move, before.X_WT))
    entered = 0.0
    for k, way in enumerate(ways, start=1):
        corner = None
        if k in zones and k < len(ways):
            corner = Corner.of_zone(way, ways[k], zones[k].radius, zones[k].turning)
        left = 1.0 - (corner.fraction_before if corner else 0.0)
        if left > entered:
            count = _pieces(way, left - entered, tolerance)
            shares = entered + (left - entered) * np.arange(1, count + 1) / count
            X.append(way.pose(shares))
            of += [k] * count
        if corner is None:
            ends.append(len(of) - 1)
            entered = 0.0
            continue
        half = _half(corner, tolerance)
        X.append(corner.pose(np.arange(1, 2 * half + 1) / (2 * half)))
        ends.append(len(of) - 1 + half)
        of += [k] * half + [k + 1] * half
        entered = corner.fraction_after
    return np.concatenate(X), of, ends


def _pieces(segment: Segment, fraction: float, tolerance: float) -> int:
    """Into how many chords a part of a path is cut: by their distance from it, and by what they turn."""
    return max(1, ceil(segment.angle * fraction / _TURN), ceil(fraction * _chords(segment, tolerance)))


def _chords(segment: Segment, tolerance: float) -> float:
    """How many chords keep within a part of the tolerance of a segment."""
    bend = segment.twist_rate(np.linspace(0.0, 1.0, 9))[:, :3]
    return sqrt(float(np.linalg.norm(bend, axis=1).max()) / (8 * _SHARE * tolerance))


def _half(corner: Corner, tolerance: float) -> int:
    """Chords in one half of a corner."""
    return max(_FEWEST, ceil(_chords(corner, tolerance) / 2), ceil(corner.angle / _TURN / 2))
