"""A line over a table that turns, in closed form: every axis and the tool are known at every time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest
from legal_motion import (
    FINE,
    V2500,
    Case,
    Piece,
    arm_at,
    down,
    eax,
    hold,
    home,
    joint_move,
    move_j,
    move_l,
    plant_without_rail,
    program,
    trapezoid,
)
from scipy.spatial.transform import Rotation

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, pose
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveExtJ, Program, Source, Span, UnitMove, Written
from trajopt_cli.trajectory import Trajectory

PLANT = plant_without_rail()
PLANT = replace(PLANT, robot=replace(PLANT.robot, self_pairs=()))  # see judged of legal_motion
P_1, ON_TABLE = down(0.48, 0.05, 0.40), down(0.50, 0.10, 0.38, 0.2)
AT = Source("cell.mod", 14, 5)
WRITTEN = Written(Span("t.mod", 0, 1))


def about(unit: UnitMove, theta: float) -> pin.SE3:
    R, p = pin.exp3(np.array(unit.u) * theta), np.array(unit.p)
    return pin.SE3(R, p - R @ p)


def brought(units: Sequence[UnitMove], theta: Sequence[float]) -> pin.SE3:
    """Where units bring a work object, from the floor on."""
    X = pin.SE3.Identity()
    for unit, angle in zip(units, theta, strict=True):
        X = X * about(unit, float(angle))
    return X


def unit(eax: int, start: float, end: float, p: Sequence[float], u: Sequence[float], **more: object) -> UnitMove:
    u = np.array(u) / np.linalg.norm(u)
    given = {"least": 0.0, "carries": True, "velocity": 3.0, "acceleration": 10.0, **more}
    return UnitMove("stn", eax, start, end, p=tuple(p), u=tuple(float(x) for x in u), **given)  # type: ignore[arg-type]


class Cell:
    """A joint move while one axis turns, a line over both as they turn, both turned back while the tool waits, home.

    late [s]: how much later than the line the second axis turns under it, in its own rows alone."""

    def __init__(self, carries: bool = True, **limits: float):
        first = unit(1, 0.0, 0.4, [0.5, 0.1, 0.2], [0, 0, 1], carries=False, least=0.4, **limits)
        tilt = unit(2, 0.1, 0.25, [0.45, 0.0, 0.2], [1, 0, 0], carries=carries, **limits)
        turn = unit(1, 0.4, 0.1, [0.5, 0.1, 0.3], [0, 0, 1], carries=carries, **limits)
        self.units = (tilt, turn)
        back = tuple(
            unit(one.eax, one.end, one.start, one.p, one.u, carries=False, least=0.5, **limits) for one in self.units
        )
        share, T = trapezoid(2.0, 8.0), 0.75
        assert share[0] == pytest.approx(T)
        end = brought(self.units, [one.angle for one in self.units]).homogeneous @ ON_TABLE
        X = [P_1, end]
        q = [arm_at(PLANT, x[None], None)[0] for x in X]
        joint = joint_move(PLANT, PLANT.start, q[0], 0.5)
        chord, turned = ON_TABLE[:3, 3] - P_1[:3, 3], Rotation.from_matrix(P_1[:3, :3].T @ ON_TABLE[:3, :3])

        def on_line(t: Array) -> Array:
            s = share[1](np.clip(t, 0, T))[0][:, None]
            R = P_1[:3, :3] @ Rotation.from_rotvec(s * turned.as_rotvec()).as_matrix()
            angles = s * [one.angle for one in self.units]
            moved = np.array([brought(self.units, both).homogeneous for both in angles])
            return arm_at(PLANT, moved @ pose(R, P_1[:3, 3] + s * chord), None)

        def at(t: Array) -> tuple[Array, Array]:
            h = 1e-6
            inside = np.clip(t, h, T - h)
            qd = (on_line(inside + h) - on_line(inside - h)) / (2 * h)
            s = share[1](t)[1]
            qd[s == 0] = 0.0
            return on_line(t), qd

        self.pieces = (
            joint,
            Piece(T, at, share[2]),
            hold(q[1], 0.6),
            joint_move(PLANT, q[1], PLANT.start, 0.5),
        )
        waits = MoveExtJ(
            source=AT, written=WRITTEN, target="j_turn", speed=V2500, zone=FINE, extax=eax(None), units=back
        )
        self.program = program(
            move_j(11, "p_1", P_1, units=(first,)), move_l(12, "p_2", end, units=self.units), waits, home(15, None)
        )
        self.case = Case(PLANT, self.program, self.pieces)
        self.turns = {
            "eax_b": [(0.0, joint.T, 0.0, 0.4, None), (1.0, T, 0.4, 0.1, share), (2.0, 0.6, 0.1, 0.4, None)],
            "eax_c": [(1.0, T, 0.1, 0.25, share), (2.0, 0.6, 0.25, 0.1, None)],
        }

    def tables(self, t: Array) -> Trajectory:
        """Where both axes are: each turn a triangle of speed but that under the line."""
        columns = []
        for name in ("eax_b", "eax_c"):
            q, v = np.full(len(t), self.turns[name][0][2]), np.zeros(len(t))
            for piece, T, start, end, given in self.turns[name]:
                share = given or trapezoid(1e9, 4 / T**2)
                u = t - self.case.starts[int(piece)]
                s, rate = share[1](np.clip(u, 0, T))
                q = np.where(u > 0, start + s * (end - start), q)
                v = np.where((u > 0) & (u < T), rate * (end - start), v)
            columns.append((q, v))
        return Trajectory(("eax_b", "eax_c"), t, *(np.column_stack(x) for x in zip(*columns, strict=True)))

    def rows(self, speeds: bool = True, **more: object) -> Trajectory:
        rows = self.case.rows(**more)
        t = np.unique(np.r_[rows.t, self.case.starts[0] + self.pieces[0].T / 2, self.case.starts[2] + 0.3])
        t = t[np.r_[True, np.diff(t) > 1e-9]]
        if more.get("grid_only"):
            t = rows.t
        which = np.clip(np.searchsorted(self.case.starts, t, side="right") - 1, 0, 3)
        q, qd = np.empty((len(t), 6)), np.empty((len(t), 6))
        for i, piece in enumerate(self.pieces):
            q[which == i], qd[which == i] = piece.at(np.clip(t[which == i] - self.case.starts[i], 0, piece.T))
        tables = self.tables(t)
        if not speeds:
            tables = replace(tables, qd=None)
        return Trajectory(rows.names, t, q, qd if speeds else None, tables)

    def judged(self, rows: Trajectory, asked: Program | None = None, steps: Resolution | None = None) -> list[Finding]:
        return list(verify(asked or self.program, PLANT, rows, steps, advice=False).findings)


CELL = Cell()


def asked(**changes: float) -> Program:
    """The program with other limits of all units."""
    motions = [replace(one, units=tuple(u._replace(**changes) for u in one.units)) for one in CELL.program.motions]
    return replace(CELL.program, motions=tuple(motions))
