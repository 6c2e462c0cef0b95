"""The register of spoiled motions: each 1.1 times the smallest offence the judge promises to see."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from legal_motion import Case

from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectory import Trajectory

Judged = tuple[Case, Trajectory, Target | None]
SPOILED: dict[str, tuple[Callable[[], Judged], str, str | None, int | None]] = {}
OVER = 1.1  # times what is promised


def spoiled(check: str, subject: str | None = "TCP", line: int | None = None) -> Callable[..., Callable[[], Judged]]:
    """Register a spoiled motion with the check that must name it, its subject (None: any) and its motion's line."""

    def add(make: Callable[[], Judged]) -> Callable[[], Judged]:
        SPOILED[make.__name__] = make, check, subject, line
        return make

    return add


def limited(plant: Plant, **changes: dict[int, float]) -> Plant:
    values = {k: np.array(getattr(plant.limits, k)) for k in ("lower", "upper", "velocity", "acceleration")}
    for kind, axes in changes.items():
        for axis, value in axes.items():
            values[kind][axis] = value
    return replace(plant, limits=JointLimits(plant.limits.names, **values))


def edited(case: Case, edit: Callable[[Array, Array, Array], None]) -> Trajectory:
    """A row every millisecond, some of them changed in place."""
    rows = case.rows(step=1e-3)
    t, q, qd = np.array(rows.t), np.array(rows.q), np.array(rows.qd)
    edit(t, q, qd)
    return Trajectory(rows.names, t, q, qd)


def row_in(case: Case, trajectory: Trajectory, piece: int, share: float) -> int:
    return int(np.searchsorted(trajectory.t, case.starts[piece] + share * case.pieces[piece].T))
