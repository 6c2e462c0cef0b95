"""The nonlinear program as CasADi expressions: the manual's example, IPOPT's optimum beside ours."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.nlp import as_casadi
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import IkBranch, Route

ROOT = Path(__file__).parents[2]


@pytest.mark.long
def test_ipopt_and_ours_find_the_same_optimum_of_the_manuals_example(monkeypatch: pytest.MonkeyPatch) -> None:
    text = (ROOT / "docs" / "mathematics.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"```python\n(.*?)```", text, flags=re.S)
    monkeypatch.chdir(ROOT)
    quiet = 'program.nlp, {"print_time": 0, "ipopt": {"print_level": 0, "sb": "yes"}})'
    # from our optimum on, in a quarter of the time: IPOPT leaves a point that is none
    near = '"warm_start_init_point": "yes", "mu_init": 1e-6, "bound_push": 1e-9, "bound_frac": 1e-9, "sb": "yes"'
    asked = "ipopt(**program.start), program.solve()"
    assert asked in code
    code = code.replace(asked, 'ipopt(**program.start | {"x0": program.solve()["x"]}), program.solve()')
    found: dict[str, object] = {}
    exec(code.replace("program.nlp)", quiet.replace('"sb": "yes"', near)), found)
    theirs, ours, program = found["theirs"], found["ours"], found["program"]
    assert ours["status"] == "solved"  # type: ignore[index]
    assert ours["f"] == pytest.approx(float(theirs["f"]), rel=1e-5)  # type: ignore[index]
    assert ours["f"] == pytest.approx(float(re.search(r"# ([\d.]+)", code)[1]), rel=1e-4)  # type: ignore[index]
    bounds = program.start  # type: ignore[attr-defined]
    for found_by in (theirs, ours):
        x, g = (np.asarray(found_by[name]).ravel() for name in ("x", "g"))  # type: ignore[index]
        assert np.all((x > bounds["lbx"] - 1e-7) & (x < bounds["ubx"] + 1e-7))
        assert np.all((g > bounds["lbg"] - 1e-7) & (g < bounds["ubg"] + 1e-7))


def test_every_variable_and_row_has_a_name_and_wrong_grids_are_refused() -> None:
    plant = plant_with_rail()
    problem = problem_of(rapid("MoveJ p_in, v500, fine, tool0; MoveL p_low, v50, fine, tool0;"), plant)
    axes, n = Axes.of(plant), len(problem.waypoints)
    q = np.array([[0.6, 0, 0, 0, 0, np.pi / 6, 0]] * n)
    route = Route(q, np.zeros_like(q), (IkBranch(0, np.zeros(6)),) * n, np.ones(n - 1), 1.0)
    program = as_casadi(problem, route, intervals=6)
    assert len({*program.x_names}) == len(program.x0) == program.nlp["x"].numel()
    assert len({*program.g_names}) == len(program.lbg) == program.nlp["g"].numel()
    assert {"leg 0.T", "leg 1.s[6]", "waypoint 1.q[0]"} <= {*program.x_names}
    assert axes.n == 7
    for intervals in (0, 7):
        with pytest.raises(ValueError, match="multiple of 6"):
            as_casadi(problem, route, intervals)
