"""Where each relation holds, written down once more node by node."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.graph_search.search import search
from trajopt_cli.nlp.block_cache import library
from trajopt_cli.nlp.constraint import Relation
from trajopt_cli.nlp.formulation import DWELL, JOINTS, Formulation
from trajopt_cli.nlp.mesh_refinement import first_iterate
from trajopt_cli.nlp.transcription import Transcription
from trajopt_cli.path.line import LineSymbols
from trajopt_cli.problem.problem import LegKind
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.leg_trajectories import JointNodes, PathLeg
from trajopt_cli.trajectories.limits.tool_limit import ToolCap, ToolKind, ToolLimit

N_JOINT = 5


@pytest.fixture(scope="module")
def program() -> Transcription:
    """A joint move on a grid with some tool caps in force, a line, a wait."""
    plant = plant_with_rail()
    axes, moves = Axes.of(plant), "MoveJ p_in,v1000,fine,tool0;MoveL p_low,v200,fine,tool0;WaitTime 0.4;"
    problem = problem_of(rapid(moves), plant)
    route = search(axes, problem)
    assert route is not None
    cfx = tuple(label.cfx for label in route.labels)
    iterate = first_iterate(axes, problem, route.q, route.w, cfx, route.times)
    rng, n = np.random.default_rng(5), axes.n
    margins: list[Margins | None] = []
    legs = []
    for leg, motion in zip(problem.legs, iterate.legs, strict=True):
        if leg.kind is LegKind.JOINT:
            grid = np.linspace(0, 1, N_JOINT + 1)
            motion = JointNodes(1.0, grid, *(np.zeros((k, n)) for k in (N_JOINT + 1, N_JOINT + 1, N_JOINT)))
        legs.append(motion)
        m = Margins.full(axes, motion.N, isinstance(motion, PathLeg))
        for share in (m.velocity, m.acceleration, m.tool):
            share[:] = rng.uniform(0.5, 1.0, share.shape)
        margins.append(m)
    return Transcription(axes, Formulation(axes, library()), problem, replace(iterate, legs=tuple(legs)), margins)


def held(program: Transcription, relation: Relation) -> tuple[dict[tuple[int, ...], Array], int]:
    """The relation's parameters by its variables, and how many copies its block has."""
    copies = program.nlp._held[relation.block]
    return {tuple(z): p for z, p in zip(copies.all_z.tolist(), copies.all_p, strict=True)}, len(copies.all_z)


def row(*parts: int | IndexArray | Sequence[int]) -> tuple[int, ...]:
    return tuple(int(i) for i in np.hstack(parts))


def leg_of(program: Transcription, kind: LegKind) -> int:
    return next(k for k, leg in enumerate(program.problem.legs) if leg.kind is kind)


def test_every_node_of_a_path_has_the_accelerations_beside_it(program: Transcription) -> None:
    for kind in (LegKind.LINE, LegKind.DWELL):
        k = leg_of(program, kind)
        x, m, N = program.legs[k], program.margins[k], program.iterate.legs[k].N
        for i in range(N + 1):
            beside = [j for j in (i - 1, i) if 0 <= j < N]
            sides = {(N - 1,): "l", (0,): "r"}.get(tuple(beside), "lr")
            if kind is LegKind.LINE:
                relation = program.formulation.node(LineSymbols(False), sides)
                wanted = row(x.s[i], x.v[i], x.d[i], x.w[i], *(row(x.a[j], x.b[j]) for j in beside), x.T)
            else:
                relation = program.formulation.node(DWELL, sides)
                wanted = row(x.d[i], x.w[i], *(x.b[j] for j in beside), x.T)
            copies, count = held(program, relation)
            assert count == (2 if len(beside) == 1 else N - 1)
            at = list(relation.p.shapes).index("V")
            begin = sum(int(np.prod(shape)) for shape in list(relation.p.shapes.values())[:at])
            limits = copies[wanted][begin : begin + 2 * program.axes.n]
            V, A = (of(program.problem.legs[k]) for of in (program.axes.velocity_on, program.axes.acceleration_on))
            np.testing.assert_array_equal(limits, np.r_[V * m.velocity[i], A * m.acceleration[i]])


def test_every_node_of_a_joint_move_keeps_each_axis(program: Transcription) -> None:
    k, n = leg_of(program, LegKind.JOINT), program.axes.n
    x, m, leg = program.legs[k], program.margins[k], program.problem.legs[k]
    V, A = program.axes.velocity_on(leg), program.axes.acceleration_on(leg)
    for i in range(N_JOINT + 1):
        beside = [j for j in (i - 1, i) if 0 <= j < N_JOINT]
        sides = "lr" if len(beside) == 2 else "r" if i == 0 else "l"
        copies, count = held(program, program.formulation.node(JOINTS, sides))
        assert count == (N_JOINT - 1 if len(beside) == 2 else 2)
        p = copies[row(x.q[i], x.qv[i], *(x.qa[one] for one in beside), x.T)]
        np.testing.assert_array_equal(p, np.r_[V * m.velocity[i], A * m.acceleration[i]])
    route, count = held(program, program.formulation.integration())
    assert count == n * N_JOINT
    for i in range(N_JOINT):
        for j in range(n):
            z = row(x.q[i, j], x.qv[i, j], x.qa[i, j], x.q[i + 1, j], x.qv[i + 1, j])
            np.testing.assert_allclose(route[z], 1 / N_JOINT)


def test_tool_caps_hold_at_every_node(program: Transcription) -> None:
    k = leg_of(program, LegKind.JOINT)
    x, m, leg = program.legs[k], program.margins[k], program.problem.legs[k]
    assert x is not None
    assert m is not None
    caps = np.array([leg.v_tcp, leg.a_tcp, leg.v_ori])
    for i in range(N_JOINT + 1):
        beside = [j for j in (i - 1, i) if 0 <= j < N_JOINT]
        sides = "lr" if len(beside) == 2 else "r" if i == 0 else "l"
        kind = ToolKind((*ToolCap,), along=False)
        copies, count = held(program, program.formulation.limit_node(ToolLimit(program.axes), kind, JOINTS, sides))
        assert count == (N_JOINT - 1 if len(beside) == 2 else 2)
        p = copies[row(x.q[i], x.qv[i], *(x.qa[one] for one in beside), x.T)]
        np.testing.assert_array_equal(p, [*(caps * m.tool[i]), *leg.X_FT[:3, 3]])


def test_the_tools_way_from_node_to_node_takes_its_time(program: Transcription) -> None:
    k = leg_of(program, LegKind.JOINT)
    x, m, leg = program.legs[k], program.margins[k], program.problem.legs[k]
    assert x is not None
    assert m is not None
    copies, count = held(program, program.formulation.tool_chord())
    assert count == N_JOINT
    for i in range(N_JOINT):
        p = copies[row(x.q[i], x.q[i + 1], x.T)]
        share = m.tool[[i, i + 1], ToolCap.SPEED].min()
        np.testing.assert_allclose(p, [*leg.X_FT[:3, 3], leg.v_tcp * share / N_JOINT])
    rng = np.random.default_rng(2)
    q, T = rng.uniform(-1, 1, (2, program.axes.n)), 0.7
    g, _ = program.formulation.tool_chord().block.values(np.r_[q[0], q[1], T][None], np.array([[0.1, 0.0, 0.2, 0.5]]))
    tcp = program.axes.forward(q) @ [0.1, 0.0, 0.2, 1.0]
    assert g[0, 0] == pytest.approx(np.sum((tcp[1] - tcp[0]) ** 2) / (0.5 * T) ** 2)


def test_a_joint_move_takes_no_less_than_the_tool_straight_from_stop_to_stop(program: Transcription) -> None:
    k = leg_of(program, LegKind.JOINT)
    way = np.linalg.norm([0.5, 0.6, 0.45] - program.axes.forward(program.problem.waypoints[k].q)[:3, 3])
    x = program.legs[k]
    assert x is not None
    low = program.nlp.bounds().lower[x.T]
    assert low == program.least(program.problem.legs[k]) == pytest.approx(way / 1.0 + 1.0 / 20.0)


def test_a_slow_joint_move_is_damped_as_much_more_as_it_is_slower(program: Transcription) -> None:
    k = leg_of(program, LegKind.JOINT)

    def weights(T: float) -> list[float]:
        legs = [replace(m, T=T) if i == k else m for i, m in enumerate(program.iterate.legs)]
        iterate = replace(program.iterate, legs=tuple(legs))
        slow = Transcription(program.axes, program.formulation, program.problem, iterate, program.margins)
        of = {int(i) for i in slow.legs[k].qa.ravel()}
        return [weight for indices, weight in slow.nlp._damped if of >= set(indices.tolist())]

    assert len(weights(0.5)) == N_JOINT
    np.testing.assert_allclose(weights(0.5), DEFAULT.damping)  # an even grid: each interval as much
    np.testing.assert_allclose(weights(50.0), 50.0 / 1.25 * DEFAULT.damping)


def test_a_programmed_time_is_no_variable() -> None:
    plant = plant_with_rail()
    axes = Axes.of(plant)
    problem = problem_of(rapid("MoveJ p_in,v1000,fine,tool0;MoveL p_low,v200\\T:=2,fine,tool0;"), plant)
    route = search(axes, problem)
    assert route is not None
    iterate = first_iterate(axes, problem, route.q, route.w, tuple(label.cfx for label in route.labels), route.times)
    margins = [Margins.full(axes, m.N, on_path=True) if isinstance(m, PathLeg) else None for m in iterate.legs]
    nlp = Transcription(axes, Formulation(axes, library()), problem, iterate, margins)
    timed = nlp.legs[1]
    assert timed is not None
    bounds = nlp.nlp.bounds()
    assert bounds.lower[timed.T] == bounds.upper[timed.T] == 2.0
