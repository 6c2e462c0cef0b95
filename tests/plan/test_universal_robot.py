"""A UR5e on a rail, whose axes go a whole turn to either side: its plan, the search among many turns, and the files."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from small_cells import problem_of, rapid

from trajopt_cli.cli import run
from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.graph_search import search
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.model import load_robot
from trajopt_cli.trajectories.axes import Axes

pytestmark = pytest.mark.usefixtures("few_places")

HOME = np.radians([200.0, -100, 90, -80, 90, -170])  # axes 1 and 6 beyond half a turn from where branches are given


def plant() -> Plant:
    robot = load_robot("ur5e_rail")
    base = robot.profile()
    lower, upper = base.lower.copy(), base.upper.copy()
    lower[0], upper[0] = -0.1, 0.45
    limits = JointLimits(base.names, lower, upper, base.velocity, base.acceleration)
    return Plant(robot, limits, TcpCaps(2.5, 20.0), np.r_[0.0, HOME], (0,), False, False, frozenset())


def program():
    robot, turned = load_robot("ur5e_rail"), HOME + np.radians([40, 10, -10, -10, 5, -40])
    data = ""
    for name, q, rail in (("a", turned, 0.3), ("b", turned + np.radians([-15, 5, 5, 5, 5, 10]), 0.4)):
        X = robot.forward(np.r_[rail, q])
        p, o = (",".join(f"{v:.9f}" for v in part) for part in (X[:3, 3] * 1e3, wxyz_from_rotation(X[:3, :3])))
        data += f"CONST robtarget {name}:=[[{p}],[{o}],[0,0,0,0],[{rail * 1e3},9E9,9E9,9E9,9E9,9E9]];\n"
    home = ",".join(f"{v:g}" for v in np.degrees(HOME))
    data += f"CONST jointtarget h:=[[{home}],[0,9E9,9E9,9E9,9E9,9E9]];\n"
    body = r"""ConfJ \Off; ConfL \Off; MoveJ a,v1000,z10,tool0; MoveL b,v500,fine,tool0; WaitTime 0.1;
               MoveC Offs(b,0,40,40),Offs(b,0,80,0),v300,fine,tool0; MoveAbsJ h,v1000,fine,tool0;"""
    return rapid(body, data=data)


@pytest.mark.usefixtures("unrefined")
def test_the_plan_is_legal_and_goes_no_further_than_it_must() -> None:
    """Every joint stays within half a turn of where it begins, though axes 1 and 6 leave the half turn around zero."""
    at = plant()
    plan = optimize(program(), at, Target.STREAM)
    assert isinstance(plan, Plan), plan
    report = verify(program(), at, plan.trajectory, target=Target.STREAM, advice=False)
    assert [f"{f.check} {f.subject} {f.value} > {f.limit}" for f in report.findings if not f.passed] == []
    assert plan.lower_bound is not None
    assert 0 < plan.lower_bound <= plan.duration
    q = plan.trajectory.q[:, 1:]
    assert np.abs(q - HOME).max() < np.pi
    assert np.abs(q).max() > np.pi


def test_few_turns_find_what_all_of_them_find(monkeypatch: pytest.MonkeyPatch) -> None:
    problem, axes, taken = problem_of(program(), plant()), Axes.of(plant()), search._in_few_turns
    labels: list[tuple[int, int]] = []

    def counted(*args):  # type: ignore[no-untyped-def]
        tables = taken(*args)
        labels.extend((len(a.labels), len(b.labels)) for a, b in zip(args[2], tables, strict=True))
        return tables

    monkeypatch.setattr(search, "_in_few_turns", counted)
    few = search._search(axes, problem)
    every = search._search(axes, problem, every=True)
    assert few is not None
    assert every is not None
    assert few.cost == pytest.approx(every.cost, rel=1e-9)
    assert any(fewer < some for some, fewer in labels)


def test_a_new_program_is_planned_judged_and_exported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("trajopt_cli.plan.lower_bound_of", lambda *_, **__: 0.1)  # other tests ask for it
    assert run(["new", "first", "--robot", "ur10e_rail"]) == 0
    assert run(["optimize", "first.mod", "--time-limit", "0", "--json", "--quiet", "--jobs", "1"]) == 0
    answer = json.loads(capsys.readouterr().out.split("\n", 2)[2])
    assert answer["as_written"]["cycle_time_s"] >= answer["plans"]["stream"]["cycle_time_s"] > 1.0
    assert run(["verify", "results/first", "--quiet"]) == 0
    for kind in ("rapid", "ros2"):
        assert run(["export", kind, "results/first", "--output", f"out_{kind}"]) == 0
        assert (tmp_path / f"out_{kind}").exists()
