"""The path between a task's poses, built anew."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.task_order import Order, Stop
from trajopt_cli.iiwa.judge.tolerances import EXACT, ROUNDING
from trajopt_cli.motion import Source

_HALF_TURN = 1e-6  # rad: a turn this close to half a revolution may go either way


@dataclass(frozen=True, eq=False)
class StraightPiece:
    """From one pose straight to the next: by way (3,) [m] from p, turning evenly by turn (3,) [rad].

    slerp: turn is a turn vector in the frame of the rotation q (4,) at its start; else a change of the three angles
    from angles (3,), which count from the rotation zero (4,): R_WT = R(angles) zero; with slerp they mean nothing.
    caps: of this segment.
    """

    name: str
    place: Source
    p: Array
    way: Array
    q: Array
    turn: Array
    slerp: bool
    angles: Array
    zero: Array
    caps: dict[str, float]

    @property
    def L_p(self) -> float:
        """Length of the path of the position, m."""
        return float(np.linalg.norm(self.way))

    @property
    def L_q(self) -> float:
        """Length of the path of the orientation, rad."""
        return float(np.linalg.norm(self.turn))

    def as_gone(self, q: Array) -> StraightPiece:
        """The same; of half a revolution, which may go either way, the way that rotations q (n, 4) on it went."""
        if not self.slerp or self.L_q < math.pi - _HALF_TURN or self.turned(q[len(q) // 2][None])[0] @ self.turn >= 0:
            return self
        return replace(self, turn=self.turn * (1 - 2 * math.pi / self.L_q))

    def turned(self, q: Array) -> Array:
        """How far (n, 3) rotations q (n, 4), in order, have turned since the start, in the coordinates of turn."""
        if self.slerp:
            turned = turns.logarithm(turns.product(turns.conjugate(self.q), q))
            if self.L_q > math.pi - _HALF_TURN:  # beyond half a revolution a logarithm is the other way round
                angle = np.linalg.norm(turned, axis=1)
                back = (turned @ self.turn < 0) & (angle > math.pi - 2 * _HALF_TURN)
                turned[back] *= (1 - 2 * np.pi / angle[back])[:, None]
            return turned
        angles = turns.to_angles(turns.product(q, turns.conjugate(self.zero)))
        first = angles[0] - self.angles
        angles = np.unwrap(np.concatenate([angles[:1] - 2 * np.pi * np.rint(first / (2 * np.pi)), angles[1:]]), axis=0)
        return np.asarray(angles - self.angles)

    def steps(self, q: Array) -> Array:
        """What rotations q (n, 4) turn from row to row (n-1, 3) [rad], as omega_max is meant: of a slerp the turn
        itself, of three angles their change."""
        if self.slerp:
            return turns.logarithm(turns.product(turns.conjugate(q[:-1]), q[1:]))
        return np.diff(self.turned(q), axis=0)

    def rounding(self, q: Array) -> float:
        """What rounding of rotations leaves of steps, rad: angles lose digits near beta = 90 deg."""
        if self.slerp:
            return ROUNDING
        beta = turns.to_angles(turns.product(q, turns.conjugate(self.zero)))[:, 1]
        return ROUNDING / max(float(np.cos(beta).min()), 1e-3)

    def share(self, p: Array, q: Array) -> Array:
        """The share (n,) of the path whose pose is nearest, position and orientation together, 1 m as 1 rad."""
        return np.asarray(((p - self.p) @ self.way + self.turned(q) @ self.turn) / (self.L_p**2 + self.L_q**2))

    def at(self, s: Array) -> tuple[Array, Array]:
        """Positions (n, 3) and rotations (n, 4) at shares s (n,)."""
        turn = s[:, None] * self.turn
        if self.slerp:
            q = turns.product(self.q, turns.exponential(turn))
        else:
            q = turns.product(turns.from_angles(self.angles + turn), self.zero)
        return self.p + s[:, None] * self.way, q


def rotation_of(order: Order, stop: Stop) -> Array:
    """A stop's orientation in the world (4,)."""
    q = turns.from_angles(stop.pose[3:])
    return turns.product(q, zero_of(order))


def zero_of(order: Order) -> Array:
    """The rotation that the task's angles count from."""
    assert order.start is not None
    return order.start.q if order.relative else np.array([1.0, 0.0, 0.0, 0.0])


def legs(order: Order) -> list[StraightPiece]:
    """The segments of an order whose stops are known."""
    assert order.stops is not None
    out: list[StraightPiece] = []
    angles = order.stops[0].pose[3:]
    for i, (a, b) in enumerate(zip(order.stops, order.stops[1:], strict=False)):
        q_a, q_b = rotation_of(order, a), rotation_of(order, b)
        if order.slerp:
            turn = turns.logarithm(turns.product(turns.conjugate(q_a), q_b))
        else:  # every angle the shorter way round
            change = b.pose[3:] - a.pose[3:]
            turn = np.array([math.remainder(x, 2 * math.pi) for x in change])
            tie = math.pi - np.abs(turn) < EXACT
            turn = np.where(tie, np.copysign(np.pi, change), turn)
        caps = {name: values[i] for name, values in order.caps.items() if values is not None}
        way = b.pose[:3] - a.pose[:3]
        way, turn = (np.where(np.linalg.norm(x) > EXACT, x, 0.0) for x in (way, turn))
        out.append(
            StraightPiece(
                f"{a.name} -> {b.name}", b.place, a.pose[:3], way, q_a, turn, order.slerp, angles, zero_of(order), caps
            )
        )
        angles = angles + turn
    return out
