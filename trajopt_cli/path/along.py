"""Many segments at once, as a run of thousands of short ones has them: what pose, twist and twist_rate of each say."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.corner import Corner, corners_along
from trajopt_cli.path.line import Line, lines_along
from trajopt_cli.path.segment import Segment


def along_all(segments: Sequence[Segment], shares: Sequence[Array]) -> tuple[Array, Array, Array]:
    """Pose, twist and its rate of segments at shares (n,) of each, one after the other: (m, 4, 4), (m, 6), (m, 6)."""
    s = np.concatenate(shares)
    number = np.repeat(np.arange(len(segments)), [len(one) for one in shares])
    X, twist, bend = np.empty((len(s), 4, 4)), np.empty((len(s), 6)), np.empty((len(s), 6))
    lines: dict[int, Line] = {}
    corners: dict[int, Corner] = {}
    others: dict[int, Segment] = {}
    for segment in segments:
        if isinstance(segment, Line):
            lines[id(segment)] = segment
        elif isinstance(segment, Corner) and isinstance(segment.before, Line) and isinstance(segment.after, Line):
            corners[id(segment)] = segment
        else:
            others[id(segment)] = segment
    place = {name: i for i, name in enumerate([*lines, *corners, *others])}
    of = np.array([place[id(segment)] for segment in segments], dtype=np.intp)[number]
    first, last = len(lines), len(lines) + len(corners)
    if lines:
        at = np.flatnonzero(of < first)
        X[at], twist[at], bend[at] = lines_along([*lines.values()], of[at], s[at])
    if corners:
        at = np.flatnonzero((of >= first) & (of < last))
        X[at], twist[at], bend[at] = corners_along([*corners.values()], of[at] - first, s[at])
    for i, segment in enumerate(others.values(), start=last):
        at = np.flatnonzero(of == i)
        X[at], twist[at], bend[at] = segment.pose(s[at]), segment.twist(s[at]), segment.twist_rate(s[at])
    return X, twist, bend
