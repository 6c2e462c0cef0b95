"""Motions of minutes and hours: rows that a disk holds, close enough for the judge."""

from __future__ import annotations

import numpy as np
import pytest
from small_cells import plant_with_rail, rapid

from trajopt_cli.errors import InputError
from trajopt_cli.plan import optimize
from trajopt_cli.plan.output_rows import output_rows
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Target
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import JointNodes


@pytest.mark.parametrize(
    ("T", "apart", "count"),
    [(6.0, 1e-3, 1), (600.0, 1e-2, 1), (3600.0, 2e-2, 1), (6.0, 1e-3, 99), (6.0, 2e-3, 101), (6.0, 5e-3, 450)],
)
def test_rows_of_long_motions_and_cycles_stand_farther_apart(T: float, apart: float, count: int) -> None:
    """A cycle of 10 minutes and less has the grid of its motions, of 10.1 twice as far, of 45 five times."""
    grid = np.array([0.0, 0.25, 0.75, 1.0])
    q, v, a = ([0.0, 0.05, 0.25, 0.3], [0.0, 0.4, 0.4, 0.0], [1.6, 0.0, -1.6])
    way = JointNodes(T, grid, *(np.repeat(np.array(x)[:, None], 7, axis=1) for x in (q, v, a)))
    rows, _ = output_rows(Axes.of(plant_with_rail()), [way] * count, np.full(7, 0.3))
    gaps = np.diff(rows.t)
    assert gaps.max() <= apart * (1 + 1e-6)
    assert len(rows.t) <= count * (T / apart + 4)
    assert {0.0, 0.25 * T, 0.75 * T, T} <= set(rows.t.tolist())


def test_times_that_differ_by_rounding_alone_are_one_row() -> None:
    """Two units that switch in the middle of one move, each by a sum of its own."""
    grid = np.array([0.0, 0.25, 0.75, 1.0])
    q, v, a = ([0.0, 0.05, 0.25, 0.3], [0.0, 0.4, 0.4, 0.0], [1.6, 0.0, -1.6])
    way = JointNodes(1.0, grid, *(np.repeat(np.array(x)[:, None], 7, axis=1) for x in (q, v, a)))
    more = [0.50037, float(np.nextafter(0.50037, 1.0)), 0.50137]
    rows, _ = output_rows(Axes.of(plant_with_rail()), [way], np.full(7, 0.3), more)
    assert np.diff(rows.t).min() > 1e-6
    assert {0.50037, 0.50137} <= set(rows.t.tolist())


def test_a_motion_of_more_than_an_hour_is_refused_with_its_line() -> None:
    program = rapid(
        "MoveAbsJ j_home,v1000,fine,tool0;\nMoveJ p_in,v1000,fine,tool0;\nMoveL p_low,v5\\T:=4000,fine,tool0;"
    )
    said = r"t\.mod:7:1: MoveL p_low takes 4000 s; plans hold motions of up to 3600 s: give it another speed"
    with pytest.raises(InputError, match=said):
        optimize(program, plant_with_rail(), Target.RAPID, AS_WRITTEN, bounded=False)
