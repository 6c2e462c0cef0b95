from __future__ import annotations

import pytest

from trajopt_cli.optimize import NoCleanPlan, solve


@pytest.mark.parametrize(("claimed", "refuted"), [(1.0005, True), (1.0 + 1e-9, False), (0.9, False)])
def test_a_bound_above_the_plan_is_said_and_never_clamped_away(claimed: float, refuted: bool) -> None:
    if refuted:
        with pytest.raises(NoCleanPlan, match=r"lower bound 2\.001000 s lies above the plan, 2\.000000 s"):
            solve._checked(2.0 * claimed, 2.0)
    else:
        assert solve._checked(2.0 * claimed, 2.0) == min(2.0 * claimed, 2.0)
