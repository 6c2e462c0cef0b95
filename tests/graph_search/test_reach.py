"""What cannot be done is named before any optimising: motion, point and limit."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from small_cells import DOWN, plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.geometry import Array, pose, rotation_about, wxyz_from_rotation
from trajopt_cli.graph_search import reach
from trajopt_cli.graph_search.ik_tables import IkTable, line_nodes, rail_grid, station_table
from trajopt_cli.graph_search.reach import check_reach
from trajopt_cli.motion import Program
from trajopt_cli.path.line import Line
from trajopt_cli.plan import check_feasible
from trajopt_cli.problem.configurations import check_configurations
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.robot.inverse import inverse, solutions
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes


def target(name: str, p: tuple[float, float, float], conf: str = "0,0,0,0", eax: str = "9E9", R: object = DOWN) -> str:
    quaternion = ",".join(f"{x:.12f}" for x in wxyz_from_rotation(R))
    place = ",".join(f"{x * 1e3:.6f}" for x in p)
    return f"CONST robtarget {name}:=[[{place}],[{quaternion}],[{conf}],[{eax},9E9,9E9,9E9,9E9,9E9]];"


def said(program: Program, plant: Plant, freedom: object = EVERYTHING) -> Infeasible:
    answer = check_feasible(program, plant, Target.STREAM, freedom)
    assert isinstance(answer, Infeasible)
    return answer


def test_a_target_too_far_from_every_rail_position_is_named() -> None:
    """y = 3 m with the rail's end at 2.2 m: 0.8 m aside of axis 1, hence too far; at the nearest rail position."""
    body = "MoveJ p_in, v500, fine, tool0;\nMoveJ p_far, v500, fine, tool0;"
    program = rapid(body, data=target("p_far", (0.5, 3, 0.4)))
    answer = said(program, plant_with_rail())
    arm = plant_with_rail().robot.arm
    r = np.hypot(np.hypot(0.5, 0.8) - arm.a1, 0.4 + arm.c4 - arm.c1)
    assert answer.index == 1
    assert str(answer) == (
        "t.mod:6:1: MoveJ p_far cannot be reached at rail 2200.0 mm: wrist centre outside the outer workspace:"
        f" {r:.6g} m from axis 2, at most {arm.c2 + arm.c3:.6g} m"
    )


def test_a_target_beyond_a_joint_limit_names_joint_value_and_limit() -> None:
    """The flange pointing up above the arm: in reach, but only with joint 5 beyond 115 degrees."""
    program = rapid("MoveJ p_up, v500, fine, tool0;", data=target("p_up", (0.45, 0.5, 0.15), R=np.eye(3)))
    answer = said(program, plant_with_rail())
    assert str(answer).startswith("t.mod:5:1: MoveJ p_up cannot be reached at rail ")
    assert "joint_5" in str(answer)
    assert "limit" in str(answer)


def test_without_a_rail_no_rail_position_is_spoken_of() -> None:
    program = rapid("MoveJ p_far, v500, fine, tool0;", data=target("p_far", (1.5, 0, 0.4)))
    message = str(said(program, plant_without_rail()))
    assert message.startswith("t.mod:5:1: MoveJ p_far cannot be reached: wrist centre outside the outer workspace: ")


def served(plant: Plant, a: tuple[float, ...], b: tuple[float, ...], s: float, d: float | None) -> bool:
    X = Line(pose(DOWN, a), pose(DOWN, b)).pose(np.array([s]))[0]
    return bool(solutions(plant.robot, X, d, plant.limits))


def test_a_line_whose_middle_is_out_of_reach_is_named_where_it_breaks() -> None:
    """Six axes; the wrist centre on the line passes 0.15 m in front of axis 1, inside the inner workspace."""
    a, b, plant = (0.15, 0.45, 0.25), (0.15, -0.45, 0.25), plant_without_rail()
    shares = np.linspace(0, 1, 101)
    reachable = np.array([served(plant, a, b, s, None) for s in shares])
    assert reachable[0]
    assert reachable[-1]
    first = shares[np.argmin(reachable)]
    assert 0.1 < first < 0.5
    data = target("p_a", a) + target("p_b", b)
    program = rapid("MoveJ p_a, v500, fine, tool0;\nMoveL p_b, v500, fine, tool0;", data=data)
    answer = said(program, plant)
    assert answer.index == 1
    place = 450 - 900 * first
    assert str(answer).startswith(
        f"t.mod:6:1: MoveL p_b breaks at {first * 900:.1f} mm of 900.0 mm, point [150.0, {place:.1f}, 250.0] mm: "
    )
    assert "limit" in str(answer) or "workspace" in str(answer)


def test_a_line_that_a_short_rail_cannot_carry_past_is_named_too() -> None:
    """The same with a rail that may move, but only 10 mm: both ends can be had, no way leads from one to the other."""
    a, b, plant = (0.15, 0.45, 0.25), (0.15, -0.45, 0.25), plant_with_rail((-0.005, 0.005))
    assert served(plant, a, b, 0.0, 0.0)
    assert served(plant, a, b, 1.0, 0.0)
    assert not any(served(plant, a, b, 0.5, d) for d in (-0.005, 0.0, 0.005))
    data = target("p_a", a) + target("p_b", b)
    answer = said(rapid("MoveJ p_a, v500, fine, tool0;\nMoveL p_b, v500, fine, tool0;", data=data), plant)
    assert answer.index == 1
    assert str(answer).startswith("t.mod:6:1: MoveL p_b breaks at ")


TWO_LINES = "MoveJ p_a, v500, fine, tool0;\nMoveL p_b, v500, fine, tool0;"
THREE = TWO_LINES + "\nMoveL p_c, v500, fine, tool0;"
NEAR_A, NEAR_B = target("p_a", (0.5, 0.1, 0.45)), target("p_b", (0.5, 0.1, 0.4))


@pytest.mark.parametrize("plant", [plant_without_rail(), plant_with_rail((-0.005, 0.005))], ids=["no rail", "rail"])
def test_the_end_of_a_second_line_outside_the_workspace_is_named(plant: Plant) -> None:
    assert check_feasible(rapid(TWO_LINES, data=NEAR_A + NEAR_B), plant) is None
    answer = said(rapid(THREE, data=NEAR_A + NEAR_B + target("p_c", (0.9, 0.1, 0.4))), plant)
    where = " at rail 5.0 mm" if plant.robot.has_rail else ""
    start = f"t.mod:7:1: MoveL p_c cannot be reached{where}: wrist centre outside the outer workspace: "
    assert str(answer).startswith(start)
    assert answer.index == 2


def test_a_line_that_can_be_done_is_never_blamed_for_the_next_one() -> None:
    """Random ends of a second line, most of them in reach, but not with a configuration that serves the first."""
    rng, plant = np.random.default_rng(0), plant_without_rail()
    assert check_feasible(rapid(TWO_LINES, data=NEAR_A + NEAR_B), plant) is None
    lost = 0
    for _ in range(60):
        axis = rng.normal(size=3)
        R = DOWN @ rotation_about(axis / np.linalg.norm(axis), rng.uniform(0.3, 2.5))
        p = tuple(rng.uniform([0.2, -0.5, 0.1], [0.6, 0.5, 0.7]))
        answer = check_feasible(rapid(THREE, data=NEAR_A + NEAR_B + target("p_c", p, R=R)), plant)
        if answer is None:
            continue
        assert str(answer).startswith("t.mod:7:1: MoveL p_c"), str(answer)
        assert answer.index == 2
        lost += bool(solutions(plant.robot, pose(R, p), None, plant.limits))
    assert lost > 5


LONG_A, LONG_B = (0.55, 0.2, 0.4), (0.55, 1.6, 0.4)


@pytest.fixture(scope="module")
def long_line() -> Program:
    """1.4 m along the rail: longer than the arm is wide."""
    data = target("p_a", LONG_A, eax="200") + target("p_b", LONG_B, eax="1600")
    return rapid("MoveJ p_a, v500, fine, tool0;\nMoveL p_b, v500, fine, tool0;", data=data)


def test_a_line_that_only_a_moving_rail_serves_passes(long_line: Program) -> None:
    assert check_feasible(long_line, plant_with_rail()) is None


@pytest.mark.parametrize("rail_fixed", [True, False], ids=["fixed by the cell", "as written"])
def test_it_passes_too_where_the_rail_goes_from_one_programmed_value_to_the_other(
    long_line: Program, rail_fixed: bool
) -> None:
    """The rail in proportion to the line stays opposite the tool: every point is in reach."""
    plant = plant_with_rail(rail_fixed=rail_fixed)
    assert all(served(plant, LONG_A, LONG_B, s, 0.2 + 1.4 * s) for s in np.linspace(0, 1, 15))
    assert check_feasible(long_line, plant, Target.STREAM, EVERYTHING if rail_fixed else AS_WRITTEN) is None


def test_the_same_line_with_the_rail_held_still_is_named(long_line: Program) -> None:
    plant = plant_with_rail()
    d = np.linspace(0.3, 1.5, 25)
    shares = np.linspace(0, 1, 36)
    alive = [any(all(served(plant, LONG_A, LONG_B, s, x) for s in (0.0, share)) for x in d) for share in shares]
    longest = shares[np.argmin(alive)] * 1400  # mm that some rail position serves both ends of
    answer = said(long_line, plant, FIXED_RAIL)
    assert answer.index == 1
    assert str(answer).startswith("t.mod:6:1: MoveL p_b breaks at ")
    at = float(str(answer).split("breaks at ")[1].split(" mm")[0])
    assert longest - 90 <= at <= longest + 30
    assert "of 1400.0 mm, point [550.0, " in str(answer)


@pytest.mark.parametrize("rail_fixed", [True, False])
def test_confdata_that_cannot_be_had_lists_the_nearest_that_could(rail_fixed: bool) -> None:
    """Held to the program's confdata (a freedom that keeps it); the list is that of the inverse kinematics."""
    plant = plant_with_rail(rail_fixed=rail_fixed)
    data = target("p_c", (0.5, 0.5, 0.4), conf="1,1,1,0", eax="500")
    program = rapid("MoveJ p_c, v500, fine, tool0;", data=data)
    answer = said(program, plant, AS_WRITTEN)
    confs = set()
    for cfx, q in solutions(plant.robot, pose(DOWN, (0.5, 0.5, 0.4)), 0.5, plant.limits):
        cf = [int(np.floor(q[i] / (np.pi / 2) + 1e-9)) for i in (0, 3, 5)]
        confs.add((*cf, cfx))
    away = {conf: [abs(a - b) for a, b in zip(conf, (1, 1, 1, 0), strict=True)] for conf in confs}
    near = sorted(confs, key=lambda conf: (4 - away[conf].count(0), sum(away[conf]), conf))
    listed = ", ".join(f"[{','.join(map(str, conf))}]" for conf in near[:6])
    assert len(confs) > 6
    (found,) = check_configurations(program, plant)
    assert str(answer).startswith(f"t.mod:5:1: {found.message}; ")
    assert str(answer) == (
        "t.mod:5:1: MoveJ p_c cannot be reached in confdata [1,1,1,0] with the rail at 500 mm; "
        f"reachable with {listed} and {len(confs) - 6} more; correct the confdata, or set ConfJ \\Off before it"
    )
    assert check_feasible(program, plant) is None


def test_the_places_of_confdata_that_cannot_be_had_are_told_together() -> None:
    """Five by name; neither a wait nor a second pass is a place of its own."""
    data = target("p_c", (0.5, 0.1, 0.4), conf="1,1,1,0") + target("p_d", (0.5, 0.1, 0.4))
    moves = ["MoveJ p_c, v500, fine, tool0;", "WaitTime 1;", "MoveJ p_d, v500, fine, tool0;"]
    program = rapid("\n".join([*moves, *["MoveJ p_c, v500, fine, tool0;"] * 6]), data=data)
    message = str(said(program, plant_without_rail(), AS_WRITTEN))
    assert message.startswith("t.mod:5:1: MoveJ p_c cannot be reached in confdata [1,1,1,0]; reachable with [")
    assert message.endswith("; likewise t.mod:8:1, t.mod:9:1, t.mod:10:1, t.mod:11:1 and 2 more")
    again = rapid("FOR i FROM 1 TO 3 DO\nMoveJ p_c, v500, fine, tool0;\nENDFOR", data=data)
    assert "likewise" not in str(said(again, plant_without_rail(), AS_WRITTEN))
    off = rapid("ConfJ \\Off;\nMoveJ p_c, v500, fine, tool0;", data=data)
    assert check_feasible(off, plant_without_rail(), Target.STREAM, AS_WRITTEN) is None


def test_a_program_can_be_done_where_the_user_lets_the_bad_motion_go() -> None:
    lines = ["MoveJ p_far, v500, fine, tool0; ! trajopt: optional", "MoveAbsJ j_home, v500, fine, tool0;"]
    program = rapid("\n".join(lines), data=target("p_far", (1.5, 0, 0.4)))
    assert check_feasible(program, plant_without_rail(), Target.STREAM, AS_WRITTEN) is not None
    assert check_feasible(program, plant_without_rail()) is None


def test_one_of_the_listed_confdata_passes() -> None:
    plant = plant_with_rail()
    wrong = rapid("MoveJ p_c, v500, fine, tool0;", data=target("p_c", (0.5, 0.55, 0.4), conf="1,1,1,0", eax="500"))
    first = str(said(wrong, plant, AS_WRITTEN)).split("reachable with [")[1].split("]")[0]
    right = rapid("MoveJ p_c, v500, fine, tool0;", data=target("p_c", (0.5, 0.55, 0.4), conf=first, eax="500"))
    assert check_feasible(right, plant, Target.STREAM, AS_WRITTEN) is None


def test_two_points_whose_confdata_differ_share_no_configuration() -> None:
    """Each alone can be had; a line between them cannot change the branch."""
    plant, points = plant_without_rail(), ((0.5, 0.1, 0.45), (0.5, 0.1, 0.4))
    confs = []
    for p in points:
        cf = {}
        for cfx, q in solutions(plant.robot, pose(DOWN, p), None, plant.limits):
            cf.setdefault(cfx, ",".join(str(int(np.floor(q[i] / (np.pi / 2) + 1e-9))) for i in (0, 3, 5)) + f",{cfx}")
        confs.append(cf)
    data = target("p_a", points[0], confs[0][0]) + target("p_b", points[1], confs[1][1])
    program = rapid("MoveJ p_a, v500, fine, tool0;\nMoveL p_b, v500, fine, tool0;", data=data)
    answer = said(program, plant, AS_WRITTEN)
    assert answer.index == 1
    (found,) = check_configurations(program, plant)
    assert str(answer) == f"t.mod:6:1: {found.message}"
    assert check_feasible(program, plant) is None


@pytest.mark.parametrize("turning", [False, True])
def test_station_tables_hold_every_configuration_and_none_else(turning: bool) -> None:
    """Each label is one branch and turn continued along the line; against the inverse at each node by itself."""
    plant = plant_with_rail()
    turned = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1.0]]) if turning else DOWN
    a, b = (0.5, 0.5, 0.45), (0.45, 0.6, 0.35)
    data = target("p_a", a) + target("p_b", b, R=turned)
    problem = problem_of(rapid("MoveJ p_a, v500, fine, tool0;\nMoveL p_b, v500, fine, tool0;", data=data), plant)
    axes = Axes.of(plant)
    d = rail_grid(problem, 1, 2, 31)
    table = station_table(axes, problem, 1, 2, d)
    X = Line(problem.waypoints[1].X_WF, problem.waypoints[2].X_WF).pose(np.linspace(0, 1, DEFAULT.line_samples))
    line = table.line(0)
    assert line is not None
    held = 0
    for label, arm in zip(table.labels, line, strict=True):
        for k in range(DEFAULT.line_samples):
            have = ~np.isnan(arm[k, :, 0])
            if not have.any():
                continue
            q = np.column_stack([d, arm[k]])[have]
            held += len(q)
            np.testing.assert_allclose(axes.forward(q), np.broadcast_to(X[k], (len(q), 4, 4)), rtol=0, atol=1e-9)
            assert np.all(q >= axes.lower - 1e-8)
            assert np.all(q <= axes.upper + 1e-8)
            raw = inverse(plant.robot, np.broadcast_to(X[k], (len(q), 4, 4)), q[:, 0])[:, label.cfx]
            turns = (q[:, 1:] - raw) / (2 * np.pi)
            np.testing.assert_allclose(turns, np.round(turns), atol=1e-9)
        both = ~np.isnan(arm[:-1, :, 0]) & ~np.isnan(arm[1:, :, 0])
        assert np.all(np.abs(np.diff(arm, axis=0))[both] < 1.0)
    # at the start: as many configurations as the inverse has within limits, but those beside a singularity
    for i, rail in enumerate(d):
        wanted = {
            tuple(np.round(q, 6))
            for _, q in solutions(plant.robot, problem.waypoints[1].X_WF, float(rail), plant.limits)
            if abs(np.sin(q[2])) <= 0.9999 and abs(np.sin(q[4])) >= 1e-3
        }
        have = {tuple(np.round(q, 6)) for q in table.waypoints[0][:, i] if not np.isnan(q[0])}
        assert have <= wanted
        if not turning:
            assert have == wanted
    assert held > 1000


def test_a_line_in_many_short_ones_ends_in_the_same_configurations() -> None:
    """Short lines have fewer nodes, and are asked for in bulk; the way is one and the same."""
    plant = plant_with_rail()
    axes, d = Axes.of(plant), np.linspace(0.2, 0.9, 15)
    ends = [(0.5 - 0.05 * u, 0.5 + 0.1 * u, 0.45 - 0.1 * u) for u in np.linspace(0, 1, 41)]
    data = "".join(target(f"p_{i}", p) for i, p in enumerate(ends))
    moves = [f"MoveL p_{i}, v500, fine, tool0;" for i in range(1, 41)]
    whole, parts = (
        problem_of(rapid("\n".join(["MoveJ p_0, v500, fine, tool0;", *some]), data=data), plant)
        for some in (moves[-1:], moves)
    )
    assert [line_nodes(leg, DEFAULT) for leg in (whole.legs[1], parts.legs[1])] == [DEFAULT.line_samples, 3]
    one, many = station_table(axes, whole, 1, 2, d), station_table(axes, parts, 1, 41, d)
    assert [(a.cfx, *a.turns) for a in one.labels] == [(a.cfx, *a.turns) for a in many.labels]
    np.testing.assert_allclose(many.waypoints[-1], one.waypoints[-1], rtol=0, atol=1e-9)
    assert np.isfinite(one.waypoints[-1]).sum() > 100


def test_grids_hold_fixed_rail_values_exactly() -> None:
    body = "MoveJ p_in, v500, fine, tool0;\nMoveL p_low, v500, fine, tool0;\nMoveAbsJ j_home, v500, fine, tool0;"
    problem = problem_of(rapid(body), plant_with_rail(rail_fixed=True))
    assert rail_grid(problem, 1, 2, 33).tolist() == [0.6]
    free = problem_of(rapid(body), plant_with_rail())
    grid = rail_grid(free, 1, 2, 33)
    assert (len(grid), grid[0], grid[-1]) == (33, -0.2, 2.2)
    near = rail_grid(free, 1, 2, 25, (0.4, 3.0))
    assert (near[0], near[-1]) == (0.4, 2.2)


def test_programs_that_can_be_done_are_not_refused() -> None:
    """Random targets on both sides of the rail: refused exactly when the inverse has no answer on a fine rail grid."""
    plant = plant_with_rail()
    rng = np.random.default_rng(9)
    d = np.linspace(-0.2, 2.2, 193)
    seen = set()
    for x, y in product((-0.75, -0.4, 0.35, 0.6, 0.72, 0.9), (0.5, 2.4)):
        p = (x, y, rng.uniform(0.0, 0.8))
        problem = problem_of(rapid("MoveJ p_x, v500, fine, tool0;", data=target("p_x", p)), plant)
        found = any(solutions(plant.robot, pose(DOWN, p), float(rail), plant.limits) for rail in d)
        answer = check_reach(Axes.of(plant), problem)
        assert (answer is None) == found, (p, answer)
        seen.add(found)
    assert seen == {True, False}


def test_a_station_that_was_served_is_looked_at_once_for_all_questions(monkeypatch: pytest.MonkeyPatch) -> None:
    """The inverse is asked for each station of a plant once; with narrower ranges of the axes it is asked again."""
    plant = plant_with_rail()
    axes = Axes.of(plant)
    body = "MoveJ p_in, v500, fine, tool0;\nMoveL p_low, v500, fine, tool0;\nMoveL p_in, v100, fine, tool0;"
    asked: list[int] = []

    def inverse_of(self: object, X_WF: Array, rail: Array) -> Array:
        asked.append(len(X_WF))
        return inverse(plant.robot, X_WF, rail)

    monkeypatch.setattr(Axes, "inverse", inverse_of)
    stream, rapid_one = (problem_of(rapid(body), plant, target) for target in (Target.STREAM, Target.RAPID))
    assert check_reach(axes, stream) is None
    assert asked
    asked.clear()
    for problem in (stream, rapid_one):
        assert check_reach(axes, problem) is None
        assert not asked
    assert check_reach(axes.narrowed(0.9), stream) is None
    assert asked


def test_a_way_longer_than_the_reach_is_served_from_few_places(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each of its lines from some place, none of them from all; a fine grid is for what that leaves open."""
    looked = []

    def counted(axes: Axes, problem: Problem, first: int, last: int, d: Array) -> IkTable:
        looked.append(len(d))
        return station_table(axes, problem, first, last, d)

    monkeypatch.setattr(reach, "station_table", counted)
    ways = "\n".join(
        f"MoveL [[450,{y},350],[0,0,1,0],[0,0,0,0],[{y},9E9,9E9,9E9,9E9,9E9]],v200,z5,tool0;"
        for y in range(0, 1900, 100)
    )
    problem = problem_of(rapid(ways.replace("MoveL", "MoveJ", 1).replace("z5", "fine", 1)), plant_with_rail())
    axes = Axes.of(problem.plant)
    assert max(last - first for first, last in problem.stations) > 10
    assert check_reach(axes, problem) is None
    assert max(looked) < 193  # positions of a fine grid


@pytest.mark.parametrize("wrist", [True, False])
@pytest.mark.parametrize("way", ["MoveL p_b", "MoveC p_v, p_b"])
def test_a_wrist_that_flips_on_the_way_is_answered_with_singarea(way: str, wrist: bool) -> None:
    data = target("p_a", (0.5, -0.1, 0.4), "-1,0,-1,0") + target("p_b", (0.5, 0.1, 0.4), "0,-2,2,1")
    data += target("p_v", (0.55, 0, 0.4))
    mode = r"SingArea \Wrist;" if wrist else ""
    program = rapid(f"MoveJ p_a, v500, fine, tool0;\n{mode} {way}, v500, fine, tool0;", data=data)
    answer = said(program, plant_without_rail(), AS_WRITTEN)
    assert answer.index == 1
    assert ("SingArea" in str(answer)) == wrist
