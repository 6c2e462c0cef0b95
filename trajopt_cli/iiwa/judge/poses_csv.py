"""A path as CSV: one pose per row, x, y, z and three angles or a quaternion, the unit in every column's head."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.written import METRE, PLAIN, RADIAN
from trajopt_cli.runs.folder import read_bytes

MOST = 100_000
"""Poses that the judge holds a sequence against."""
_KINDS = {
    **dict.fromkeys("xyz", METRE),
    **dict.fromkeys(("alpha", "beta", "gamma"), RADIAN),
    **dict.fromkeys(("qw", "qx", "qy", "qz"), PLAIN | {"1": 1.0}),
}


def lines_of(path: str) -> list[str]:
    """The lines of a file, its header the first. Raises InputError where it cannot be read."""
    text = read_bytes(Path(path)).decode("utf-8-sig", "replace")
    return [line for line in text.splitlines() if line.strip()]


def read_poses(lines: list[str], path: str, zero: Array) -> Array:
    """Positions and angles (n, 6) in SI, as the task counts them; zero (4,): the rotation that angles count from. path
    is for messages.

    Raises InputError with the file for what it cannot use.
    """
    if len(lines) < 3:
        raise InputError("a path needs a header and at least two poses", file=path)
    mark = next((sign for sign in ";\t" if sign in lines[0]), ",")
    columns: dict[str, tuple[int, float]] = {}
    for i, head in enumerate(lines[0].split(mark)):
        name, _, unit = head.strip().strip('"').partition("[")
        name, unit = name.strip().lower(), unit.strip().rstrip("]").strip()
        if name not in _KINDS or unit not in _KINDS[name]:
            raise InputError(f"the judge does not know the column '{head.strip()}'", file=path, line=1)
        columns[name] = i, _KINDS[name][unit]
    try:
        table = np.array([[float(field) for field in line.split(mark)] for line in lines[1:]])
    except ValueError as error:
        raise InputError(f"a row is no row of numbers: {error}", file=path) from error
    found = {name: table[:, i] * factor for name, (i, factor) in columns.items()}
    if missing := {"x", "y", "z"} - found.keys():
        raise InputError(f"has no column {', '.join(sorted(missing))}", file=path, line=1)
    if "qw" in found:
        q = np.column_stack([found[name] for name in ("qw", "qx", "qy", "qz")])
        q = turns.product(q / np.linalg.norm(q, axis=1, keepdims=True), np.broadcast_to(turns.conjugate(zero), q.shape))
        angles = turns.to_angles(q)
    else:
        angles = np.column_stack([found[name] for name in ("alpha", "beta", "gamma")])
    return np.column_stack([found["x"], found["y"], found["z"], angles])
