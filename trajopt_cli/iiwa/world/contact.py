"""A ball at the tool's tip against boxes and capsules: how deep it is in them, and the force they answer with."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import copysign, hypot, inf

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Contact, Obstacle
from trajopt_cli.iiwa.task.world import Six
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.shapes import Box, Capsule

FRICTION_RISE = 2000.0
"""Friction per sliding speed [N s/m] until Coulomb's bound is reached: 9 N, the bound of 30 N at 0.3, at 4.5 mm/s.

Below that speed the tip creeps instead of sticking. An assumption: what real surfaces do there nobody measured here.
"""
_TOUCHING = 1e-6  # m that the arm may be in an obstacle where it starts: rounding
Three = tuple[float, float, float]


@dataclass(frozen=True)
class Touch:
    """force [N, Nm]: on the tool, at its TCP, world axes. depth [m]: of the ball in the box it is deepest in."""

    force: Six
    depth: float


APART = Touch((0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0)


class BallOnBoxes:
    """The tip's ball, centred at the TCP, against the boxes of a contact. Plain floats, one sample at a time.

    Every shape the ball overlaps by a depth pushes along the outward normal of its nearest face, edge or corner (of a
    box's nearest face where the ball's centre is inside) with stiffness * depth + damping * speed of approach, never
    pulling, and rubs against the sliding with FRICTION_RISE * speed, at most friction * push. Both act half-way between
    the ball's deepest point and the surface. Shapes add up.
    """

    def __init__(self, contact: Contact) -> None:
        self._tip = contact.tip
        self._boxes = [(_Box if isinstance(one.shape, Box) else _Capsule)(one) for one in contact.obstacles]

    def overlap(self, p: Three) -> bool:
        """Whether a ball at p [m] is in any box."""
        return any(box.nearest(p)[0] < self._tip for box in self._boxes)

    def nearest(self, p: Three) -> Obstacle:
        """The shape nearest to a ball at p [m]."""
        return min(self._boxes, key=lambda box: box.nearest(p)[0]).obstacle

    def pressed(self, p: Three, K: Three) -> tuple[float, Three, float]:
        """How deep [m] a ball at p [m] is in the box that it is deepest in or nearest to, the outward normal there, and
        the force [N] on the surface when springs K [N/m] pull the ball to p, all at rest and free to slide."""
        box, distance, n = min(((box, *box.nearest(p)) for box in self._boxes), key=lambda one: one[1])
        depth = self._tip - distance
        soft = sum(u * u / k if k > 0 else inf for u, k in zip(n, K, strict=True) if u) + 1 / box.obstacle.stiffness
        return depth, n, max(0.0, depth) / soft

    def touch(self, p: Three, v: Three, w: Three) -> Touch:
        """What the boxes do to a TCP at p [m] that moves at v [m/s] and turns at w [rad/s], all in world axes."""
        force, deepest = APART.force, 0.0
        for box in self._boxes:
            distance, n = box.nearest(p)
            depth = self._tip - distance
            if depth <= 0.0:
                continue
            deepest = max(deepest, depth)
            one = _push(box.obstacle, self._tip, depth, n, v, w)
            force = added(force, one)
        return Touch(force, deepest) if deepest else APART


class _Box:
    def __init__(self, obstacle: Obstacle) -> None:
        self.obstacle = obstacle
        assert isinstance(obstacle.shape, Box)
        X, half = obstacle.shape.X.tolist(), (obstacle.shape.size / 2).tolist()
        self._R = X[0][:3], X[1][:3], X[2][:3]
        self._p = X[0][3], X[1][3], X[2][3]
        self._half = half

    def nearest(self, p: Three) -> tuple[float, Three]:
        """Distance [m] of a world point from the surface, negative inside, and the outward normal there."""
        (a, b, c), (d, e, f), (g, h, i) = self._R
        x, y, z = p[0] - self._p[0], p[1] - self._p[1], p[2] - self._p[2]
        local = (a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z)
        off = [abs(u) - s for u, s in zip(local, self._half, strict=True)]
        if max(off) <= 0.0:
            face = off.index(max(off))
            distance = off[face]
            n = [0.0, 0.0, 0.0]
            n[face] = copysign(1.0, local[face])
        else:
            n = [copysign(max(o, 0.0), u) for o, u in zip(off, local, strict=True)]
            distance = hypot(*n)
            n = [u / distance for u in n]
        x, y, z = n
        return distance, (a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)


class _Capsule:
    def __init__(self, obstacle: Obstacle) -> None:
        self.obstacle = obstacle
        assert isinstance(obstacle.shape, Capsule)
        shape = obstacle.shape
        self._a, self._way, self._radius = shape.a.tolist(), (shape.b - shape.a).tolist(), shape.radius
        self._square = max(sum(u * u for u in self._way), 1e-300)

    def nearest(self, p: Three) -> tuple[float, Three]:
        """As of a box."""
        off = [u - a for u, a in zip(p, self._a, strict=True)]
        share = sum(u * w for u, w in zip(off, self._way, strict=True)) / self._square
        share = min(1.0, max(0.0, share))
        x, y, z = (u - share * w for u, w in zip(off, self._way, strict=True))
        far = hypot(x, y, z) or 1e-300
        return far - self._radius, (x / far, y / far, z / far)


def _push(obstacle: Obstacle, tip: float, depth: float, n: Three, v: Three, w: Three) -> Six:
    lever = depth / 2 - tip
    x, y, z = lever * n[0], lever * n[1], lever * n[2]  # of the point of contact from the TCP
    vx, vy, vz = v[0] + w[1] * z - w[2] * y, v[1] + w[2] * x - w[0] * z, v[2] + w[0] * y - w[1] * x
    away = vx * n[0] + vy * n[1] + vz * n[2]
    push = max(0.0, obstacle.stiffness * depth - obstacle.damping * away)
    sx, sy, sz = vx - away * n[0], vy - away * n[1], vz - away * n[2]
    sliding = hypot(sx, sy, sz)
    bound = obstacle.friction * push
    rub = FRICTION_RISE if FRICTION_RISE * sliding <= bound else bound / sliding
    return about((x, y, z), (push * n[0] - rub * sx, push * n[1] - rub * sy, push * n[2] - rub * sz))


def bodies(robot: SrsRobot, contact: Contact) -> list[tuple[str, int, Capsule]]:
    """What of an arm may run into something but its tip: names, which link's frame each is in, capsules there."""
    numbered = enumerate(robot.link_names[1:], start=1)
    out = [(name, i, robot.capsules[name]) for i, name in numbered if name in robot.capsules]
    if (one := contact.body) is not None:
        a, b = (robot.chain[-1].X[:3, :3] @ end + robot.chain[-1].X[:3, 3] for end in (one.a, one.b))
        out.append((one.name, len(robot.link_names) - 1, Capsule(one.name, a, b, one.radius)))
    return out


def depths(robot: SrsRobot, q: Array, contact: Contact) -> Iterator[tuple[str, str, Array]]:
    """Of every body and obstacle the depth (n,) [m] of one in the other at joints q (n, 7), negative where apart."""
    X = robot.links(q)
    for name, link, capsule in bodies(robot, contact):
        for obstacle in contact.obstacles:
            yield name, obstacle.shape.name, -Pair(capsule, obstacle.shape).distances(X[:, link])


def check_start(robot: SrsRobot, q: Array, X_FT: Array, contact: Contact) -> None:
    """Raise ValueError where the arm or its tool is in an obstacle at joints q (7,); X_FT (4, 4): its TCP."""
    tip = Capsule("the tip", X_FT[:3, 3], X_FT[:3, 3], contact.tip)
    parts = [*depths(robot, q[None], contact)]
    parts += [
        (tip.name, one.shape.name, -Pair(tip, one.shape).distances(robot.forward(q)[None])) for one in contact.obstacles
    ]
    name, obstacle, depth = max(parts, key=lambda part: float(part[2][0]), default=("", "", np.zeros(1)))
    if depth[0] > _TOUCHING:
        raise ValueError(
            f"{name} is {1e3 * depth[0]:.3g} mm deep in obstacle '{obstacle}' at the start joints: begin outside of it,"
            " or move it"
        )


def about(lever: Three, force: Three) -> Six:
    """The force [N] and its moment [Nm] about a point that lies lever [m] before where it acts."""
    (x, y, z), (a, b, c) = lever, force
    return (a, b, c, y * c - z * b, z * a - x * c, x * b - y * a)


def added(one: Six, other: Six) -> Six:
    """Both forces together."""
    (a, b, c, d, e, f), (g, h, i, j, k, m) = one, other
    return (a + g, b + h, c + i, d + j, e + k, f + m)
