from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.plan import bounded
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.trajectory import Trajectory


@pytest.mark.parametrize(("claimed", "refuted"), [(1.0005, True), (1.0 + 1e-9, False), (0.9, False)])
def test_a_bound_above_the_plan_is_said_and_never_clamped_away(claimed: float, refuted: bool) -> None:
    rows = Trajectory(("joint_1",), np.array([0.0, 2.0]), np.zeros((2, 1)))
    plan = bounded(Plan(Target.STREAM, rows, (), None, ""), 2.0 * claimed, 0.1)
    if refuted:
        assert plan.lower_bound is None
        assert "2.001000 s, lies above the plan, 2.000000 s: an error in trajopt" in plan.notes[-1]
    else:
        assert (plan.lower_bound, plan.notes) == (min(2.0 * claimed, 2.0), ())
