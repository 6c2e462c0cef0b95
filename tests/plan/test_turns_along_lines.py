"""A stream turns a free tool along its lines as it likes: faster than evenly, its axis and its sector held."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from test_tool_turns_chosen import ROUND, TAUGHT, Z, program_of, slow_wrist

from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.motion import FreeTurn, PoseMove
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.trajectory import hermite

# A line that tilts the bent head by 15 degrees: in RAPID both ends have one turn.
TILTING = """MoveJ p_a,v1000,fine,tHead;
MoveL p_t,v2000,fine,tHead;
WaitTime 0.1;
MoveJ p_a,v1000,fine,tHead;
MoveAbsJ j_home\\NoEOffs,v1000,fine,tHead;"""


@cache
def planned(free: FreeTurn, turn: bool = True) -> Plan:
    found = optimize(
        program_of(TILTING, free), slow_wrist(), Target.STREAM, EVERYTHING if turn else TAUGHT, bounded=False
    )
    assert isinstance(found, Plan), found
    return found


def turns_on_the_line(plan: Plan) -> tuple[Array, Array]:
    """How far the tool's axis is off its taught way, and how far the tool is turned about it [rad], at many places on
    the line, between the rows, too. By scipy: the taught orientation is slerp at the share of the chord done."""
    program, plant = program_of(TILTING), slow_wrist()
    X_0, X_1 = (motion.X_WT for motion in program.motions[:2] if isinstance(motion, PoseMove))
    line, rows = plan.motions[1], plan.trajectory
    t = np.linspace(line.t_0, line.t_1, 1000)
    q = hermite(rows, t)[0]
    X = plant.robot.forward(q) @ program.motions[1].tool.X_FT  # type: ignore[union-attr]
    chord = X_1[:3, 3] - X_0[:3, 3]
    s = np.clip((X[:, :3, 3] - X_0[:3, 3]) @ chord / (chord @ chord), 0, 1)
    seen = Slerp([0, 1], Rotation.from_matrix([X_0[:3, :3], X_1[:3, :3]]))(s).inv() * Rotation.from_matrix(X[:, :3, :3])
    R = seen.as_matrix()
    return np.arccos(np.clip(R[:, 2, 2], -1, 1)), np.unwrap(np.arctan2(R[:, 1, 0], R[:, 0, 0]))


@pytest.mark.long
def test_a_stream_turns_unevenly_where_a_controller_must_keep_one_turn() -> None:
    plan, taught = planned(ROUND), planned(ROUND, False)
    evenly = optimize(program_of(TILTING), slow_wrist(), Target.RAPID, bounded=False)
    assert isinstance(evenly, Plan)
    assert evenly.turns.get(0, 0.0) == evenly.turns.get(1, 0.0)
    assert plan.duration < 0.97 * min(taught.duration, evenly.duration)
    off, turn = turns_on_the_line(plan)
    assert off.max() < 1e-6
    assert abs(turn[-1] - turn[0]) > 0.05
    assert np.degrees(turn[[0, -1]]) == pytest.approx(
        np.degrees([plan.turns.get(0, 0.0), plan.turns.get(1, 0.0)]), abs=1e-3
    )
    report = judge(slow_wrist(), program_of(TILTING), write_csv_text(plan.trajectory), "t.csv", None, Target.STREAM,
                   advice=False)  # fmt: skip
    assert report.legal, report.worst.message


def test_a_stream_stays_in_a_narrow_sector_between_its_rows() -> None:
    sector = FreeTurn(Z, np.radians(-3.0), np.radians(4.0))
    plan = planned(sector)
    off, turn = turns_on_the_line(plan)
    assert off.max() < 1e-6
    assert sector.low - 1e-6 <= turn.min() <= turn.max() <= sector.high + 1e-6
    assert max(turn.max() - sector.high, sector.low - turn.min()) > -1e-3  # it is used
    assert planned(ROUND).duration < plan.duration < planned(sector, False).duration
