"""The judge holds a move to its own AccSet, PathAccLim and WorldAccLim, and no other move to them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from legal_motion import Case, bench_case, move_l, rapid_case
from legal_motion import judged as verify
from legal_runs import P0, P1, P2, Z10, run_case

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Program, Settings
from trajopt_cli.path.line import Line
from trajopt_cli.trajectory import Trajectory

HAIR = 2e-3  # of a value taken by differences from the piece


def asking(case: Case, index: int, **settings: float) -> Program:
    """The case's program with settings at one motion."""
    motions = list(case.program.motions)
    motions[index] = replace(motions[index], settings=Settings(**settings))
    return replace(case.program, motions=tuple(motions))


def accelerations(case: Case, piece: int) -> tuple[Array, Array]:
    """Of axes (n, k) and of the tool centre point (n, 3) along a piece, by differences of its exact rates."""
    one = case.pieces[piece]
    t = np.linspace(0, one.T, 20001)
    t = t[np.abs(t[:, None] - np.r_[0, one.switches, one.T]).min(axis=1) > 2e-4]
    h = 1e-5
    before, behind = (one.at(t + x) for x in (-h, h))
    X_FT = case.program.motions[piece].tool.X_FT

    def speed(q: Array, qd: Array) -> Array:
        return np.asarray((case.plant.robot.jacobian(q, X_FT) @ qd[..., None])[:, :3, 0])

    return (behind[1] - before[1]) / (2 * h), (speed(*behind) - speed(*before)) / (2 * h)


def failures(program: Program, case: Case, rows: Trajectory | None = None) -> list[str]:
    return [f.message for f in verify(program, case.plant, rows or case.rows()).findings if not f.passed]


@pytest.mark.parametrize("piece", [0, 1])
@pytest.mark.parametrize("make", [bench_case, rapid_case], ids=["bench", "rail"])
def test_acc_set_is_a_share_of_every_acceleration(make: object, piece: int) -> None:
    """Piece 0 is a joint move, piece 1 a line; both the axes' and the tool's own uses of their limits decide."""
    case = make()
    axes, tool = accelerations(case, piece)
    used = {
        name: a / top
        for name, a, top in zip(
            case.plant.limits.names, np.abs(axes).max(axis=0), case.plant.limits.acceleration, strict=True
        )
    }
    of_tool = float(np.linalg.norm(tool, axis=1).max()) / case.plant.tcp.acceleration
    most = max(*used.values(), of_tool)
    assert most < 1.001
    assert failures(asking(case, piece, acceleration=min(1.0, most * (1 + HAIR))), case) == []
    worst = max(used, key=lambda name: used[name])
    line = case.program.motions[piece].source.line
    found = failures(asking(case, piece, acceleration=used[worst] * (1 - HAIR)), case)
    assert [m for m in found if m.startswith(f"cell.mod:{line}:5: {worst} acceleration ") and "AccSet" in m]
    found = failures(asking(case, piece, acceleration=of_tool * (1 - HAIR)), case)
    assert [m for m in found if m.startswith(f"cell.mod:{line}:5: TCP acceleration ") and "AccSet" in m]
    assert all(m.startswith(f"cell.mod:{line}:5: ") for m in found)


def test_world_acc_lim_is_a_cap_on_the_whole_acceleration() -> None:
    case = bench_case()
    for piece in (0, 1):
        most = float(np.linalg.norm(accelerations(case, piece)[1], axis=1).max())
        assert failures(asking(case, piece, world_acceleration=most * (1 + HAIR)), case) == []
        (found,) = failures(asking(case, piece, world_acceleration=most * (1 - HAIR)), case)
        assert "TCP acceleration" in found
        assert "WorldAccLim allows" in found


def test_path_acc_lim_is_one_along_the_path_only() -> None:
    """The joint move's way is bent: across it the tool is accelerated more than along it."""
    case = bench_case()
    one, X_FT = case.pieces[0], case.program.motions[0].tool.X_FT
    t = np.linspace(0, one.T, 4001)
    q, qd = one.at(t)
    speed = np.linalg.norm((case.plant.robot.jacobian(q, X_FT) @ qd[..., None])[:, :3, 0], axis=1)
    along = np.diff(speed) / np.diff(t)
    whole = float(np.linalg.norm(accelerations(case, 0)[1], axis=1).max())
    for name, value in (("path_acceleration", along.max()), ("path_deceleration", -along.min())):
        assert value > 0.1
        assert failures(asking(case, 0, **{name: float(value) * (1 + 5e-3)}), case) == []
        (found,) = failures(asking(case, 0, **{name: float(value) * (1 - 5e-3)}), case)
        assert "TCP acceleration" in found
        assert "PathAccLim allows" in found
    assert min(along.max(), -along.min()) < 0.98 * whole


def test_a_file_without_speeds_is_held_to_them_on_lines() -> None:
    case = bench_case()
    rows = case.rows()
    bare = Trajectory(rows.names, rows.t, rows.q, None)
    whole = float(np.linalg.norm(accelerations(case, 1)[1], axis=1).max())
    both = {"path_acceleration": whole * 0.9, "path_deceleration": whole * 0.9}
    assert any("PathAccLim" in message for message in failures(asking(case, 1, **both), case, bare))
    more = {"path_acceleration": whole * 1.01, "path_deceleration": whole * 0.5}
    for rows in (bare, case.rows()):
        assert any("PathAccLim" in message for message in failures(asking(case, 1, **more), case, rows))
    for name in both:  # up and down apart
        assert failures(asking(case, 1, **{name: whole * 1.01}), case, bare) == []
        assert any("PathAccLim" in message for message in failures(asking(case, 1, **{name: whole * 0.9}), case, bare))


@pytest.mark.parametrize("asked", [{"world_acceleration": 1.2}, {"acceleration": 0.07}], ids=["world", "share"])
def test_in_a_corner_the_looser_of_both_moves_holds(asked: dict[str, float]) -> None:
    """At 0.15 m/s the parabola of a z10 at a right angle takes 1.6 m/s2, the rest of the way 0.3 m/s2 at most."""
    lines = [Line(P0, P1), Line(P1, P2)]
    motions = [move_l(12, "p_1", P1, zone=Z10), move_l(13, "p_2", P2)]
    case = run_case(motions, lines, [(Z10.radius, Z10.path_ori)], v=0.15, a=0.3)
    both = asking(replace(case, program=asking(case, 1, **asked)), 2, **asked)
    for program in (asking(case, 1, **asked), asking(case, 2, **asked)):
        assert failures(program, case) == []
    found = failures(both, case)
    assert found
    assert all(message.startswith("cell.mod:12:5: ") for message in found)
