"""Random legal motions, every axis at its own pace: stations in random places, with lines, waits and rides."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np
from legal_motion import (
    Case,
    Piece,
    arm_at,
    down,
    hold,
    home,
    joint_move,
    line_move,
    move_j,
    move_l,
    plant_with_rail,
    plant_without_rail,
    program,
    rail_share,
    wait,
)
from tcp_motion import forward_acceleration

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Motion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectory import Trajectory


@lru_cache(maxsize=64)
def random_case(seed: int) -> Case:
    """One to three stations: a joint move there, a line down, a wait, a line up; home at the end. Every odd seed has a
    rail. Legal at 1 kHz to the last digit."""
    rng = np.random.default_rng(seed)
    plant = plant_with_rail() if seed % 2 else plant_without_rail()
    has_rail = plant.robot.has_rail
    d = 0.0
    motions: list[Motion] = []
    pieces: list[Piece] = []
    q_now, line = plant.start, 11
    for station in range(_stations(rng)):
        x, y, z = rng.uniform([0.40, -0.25, 0.42], [0.52, 0.25, 0.50])
        y, before = y + d, d
        d = float(rng.uniform(0.0, 0.4)) if has_rail else 0.0
        y += d - before
        X_up = down(x, y, z, float(rng.uniform(-0.4, 0.4)))
        X_low = down(x + rng.uniform(-0.03, 0.03), y, z - rng.uniform(0.04, 0.1), float(rng.uniform(-0.4, 0.4)))
        d_low = d + float(rng.uniform(0.0, 0.03)) if has_rail else 0.0
        T = float(rng.choice([0.0, 0.1, 0.25, 0.4]))
        rails = (d, d_low) if has_rail else (None, None)
        q_up, q_low = (
            arm_at(plant, X[None], None if rail is None else np.array([rail]))[0]
            for X, rail in zip((X_up, X_low), rails, strict=True)
        )
        motions += [
            move_j(line, f"p_{station}_in", X_up, rails[0]),
            move_l(line + 1, f"p_{station}", X_low, rails[1]),
            *([wait(line + 2, T)] if T else []),
            move_l(line + 3, f"p_{station}_out", X_up, rails[0]),
        ]
        line += 4
        pieces += [
            joint_move(plant, q_now, q_up, float(rng.uniform(0.5, 0.97))),
            paced(plant, X_up, X_low, rails, rng),
            *([hold(q_low, T)] if T else []),
            paced(plant, X_low, X_up, rails[::-1], rng),
        ]
        q_now = q_up
    motions.append(home(line, 0.0 if has_rail else None))
    pieces.append(joint_move(plant, q_now, plant.start, float(rng.uniform(0.5, 0.97))))
    return Case(plant, program(*motions), tuple(pieces))


def stations(seed: int) -> int:
    """How many stations the random case of a seed has."""
    return _stations(np.random.default_rng(seed))


def _stations(rng: np.random.Generator) -> int:
    return int(rng.integers(1, 4))


def paced(
    plant: Plant, X_0: Array, X_1: Array, rails: tuple[float | None, float | None], rng: np.random.Generator
) -> Piece:
    """A line as fast as the limits allow, or a share of that."""
    rail: Callable[[Array, Array], tuple[Array, Array]] | None = None
    if rails[0] is not None and rails[1] is not None:
        rail = rail_share(rails[0], rails[1])
    v, a = 0.49 / float(np.linalg.norm(X_1[:3, 3] - X_0[:3, 3])), float(rng.uniform(20, 150))
    for _ in range(4):
        piece = line_move(plant, X_0, X_1, rail, v, a)
        speed, acceleration = used(plant, piece)
        slower = max(speed / 0.98, np.sqrt(acceleration / 0.97))
        if slower <= 1.0:
            return piece
        v, a = v / slower, a / slower**2
    return line_move(plant, X_0, X_1, rail, v * 0.98, a * 0.95)


def used(plant: Plant, piece: Piece) -> tuple[float, float]:
    """How much of the limits of speed and of acceleration a piece uses, axes and tool."""
    t = np.unique(np.r_[np.linspace(0, piece.T, 1500), np.array(piece.switches)])
    q, qd = piece.at(t)
    h = np.diff(t)[:, None]
    qdd = np.diff(qd, axis=0) / h
    q, qd = (q[1:] + q[:-1]) / 2, (qd[1:] + qd[:-1]) / 2
    V = (plant.robot.jacobian(q) @ qd[..., None])[..., 0]
    A = forward_acceleration(plant.robot, q, qd, qdd)
    speed = max(
        float((np.abs(qd) / plant.limits.velocity).max()),
        float(np.linalg.norm(V[:, 3:], axis=1).max() / np.radians(500)),
        float(np.linalg.norm(V[:, :3], axis=1).max() / 0.5),
    )
    fast = float((np.abs(qdd) / plant.limits.acceleration).max())
    return speed, max(fast, float(np.linalg.norm(A[:, :3], axis=1).max() / plant.tcp.acceleration))


def written(trajectory: Trajectory, spell: str, speeds: bool, times: str | None = None) -> str:
    """A file's text with every number spelled in one format, as in `"%.6g"`."""
    names = trajectory.names
    heads = ["t [s]", *(f"{n} [{'m' if n == 'rail' else 'rad'}]" for n in names)]
    columns = [trajectory.q]
    if speeds and trajectory.qd is not None:
        heads += [f"{n} speed [{'m' if n == 'rail' else 'rad'}/s]" for n in names]
        columns.append(trajectory.qd)
    lines = [",".join(heads)]
    table = np.column_stack([trajectory.t, *columns])
    row = ",".join([times or spell, *[spell] * (table.shape[1] - 1)])
    lines += [row % tuple(values) for values in table.tolist()]
    return "\n".join(lines) + "\n"


def without_speeds(trajectory: Trajectory) -> Trajectory:
    """Positions alone."""
    return replace(trajectory, qd=None)
