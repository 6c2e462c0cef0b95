"""Sections 6.1.6 and 6.1.7: led by the hand without stiffness, freely and along one axis only."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.experiments.setup import FORCE, INERTIA, Bench, H, Series, compliance, push
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.model import COORDINATES, Push, Zeroing

_FIRST, _PUSH, _COAST = 0.5, 1.0, 2.0  # s: before the first push, each push, and until the next: 8 time constants
_D, _D_TURN = 100.0, 20.0  # N s/m, N m s/rad (6.7)
FRAME = (-np.pi / 4, -np.pi / 6, 0.0)
"""alpha*, beta*, gamma* [rad] of the frame in which the forces along x and y are zeroed (section 6.1.7)."""


@dataclass(frozen=True)
class Lead:
    """A push along axis, from start to end [s], at rest by rest [s]: way made [m] and F T / d, top speed [m/s] and
    F/d (1 - e^(-T d/m)); aside: way made across it [m]."""

    axis: str
    start: float
    end: float
    rest: float
    way: float
    expected: float
    speed: float
    speed_expected: float
    aside: float


@dataclass(frozen=True, eq=False)
class Guided:
    """Hand guiding. left: what is left of the last push's speed at the end [m/s]."""

    section: str
    title: str
    world: str
    leads: tuple[Lead, ...]
    left: float
    sentences: tuple[str, ...]
    series: Series


@dataclass(frozen=True, eq=False)
class Zeroed:
    """Motion under pushes along x, y and z that is left when two forces of a turned frame are zeroed.

    axis (3,): the frame's free axis; direction (3,): of the way that was made; angle [rad] between them; aside [m]: the
    greatest distance of the controller from the axis; length [m]: from end to end. flange_angle, flange_aside: the
    same of the flange as the world moved it, None where it is exact.
    """

    section: str
    title: str
    world: str
    axis: Array
    direction: Array
    angle: float
    aside: float
    length: float
    flange_angle: float | None
    flange_aside: float | None
    sentences: tuple[str, ...]
    series: Series

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", readonly(self.axis))
        object.__setattr__(self, "direction", readonly(self.direction))


def guiding(bench: Bench) -> Guided:
    """6.1.6: k = 0; pushed along x, then y, then z."""
    pushes, times = _pushes((FORCE, FORCE, FORCE))
    done = bench.pushed(compliance(0.0, 0.0, _D, _D_TURN), pushes, times[-1][2])
    leads = []
    for axis, (start, end, rest) in enumerate(times):
        a, b, c = (round(t / H) for t in (start, end, rest))
        way = done.x[c, :3] - done.x[a, :3]
        leads.append(
            Lead(
                axis=COORDINATES[axis],
                start=start,
                end=end,
                rest=rest,
                way=float(way[axis]),
                expected=FORCE * (end - start) / _D,
                speed=float(np.max(done.v[a : b + 1, axis])),
                speed_expected=FORCE / _D * (1 - exp(-(end - start) * _D / INERTIA[axis])),
                aside=float(np.linalg.norm(np.delete(way, axis))),
            )
        )
    return Guided(
        section="6.1.6",
        title="hand guiding, k = 0",
        world=done.world,
        leads=tuple(leads),
        left=float(np.linalg.norm(done.v[-1, :3])),
        sentences=(
            f"the hand's forces are in a figure only: ours are {FORCE:g} N along x, y and z, {_PUSH:g} s each",
            "the arm stays where it is left: nothing pulls it back",
        ),
        series=done.series("hand guiding"),
    )


def zeroing(bench: Bench) -> Zeroed:
    """6.1.7: f_x = f_y = 0 in a frame at alpha* = -45 deg, beta* = -30 deg."""
    R = rotation(np.array(FRAME))
    axis = R[:, 2]
    blind = Zeroing((True, True, False, False, False, False), np.array(FRAME))
    pushes, times = _pushes((FORCE, -FORCE, FORCE))
    done = bench.pushed(compliance(0.0, 0.0, _D, _D_TURN), pushes, times[-1][2], blind)
    direction, aside, length = _line(done.x[:, :3], axis)
    flange_line = None if done.flange is None else _line(done.flange[:, :3], axis)
    return Zeroed(
        section="6.1.7",
        title="zeroed forces in a turned frame",
        world=done.world,
        axis=axis,
        direction=direction,
        angle=_between(direction, axis),
        aside=aside,
        length=length,
        flange_angle=None if flange_line is None else _between(flange_line[0], axis),
        flange_aside=None if flange_line is None else flange_line[1],
        sentences=(
            "K, D and the forces of this section are not printed: ours are those of hand guiding, along x, -y and z",
            f"erratum: F* = R* F as printed would leave {_shown(R[2])} free, the third row of R*; the frame's z axis"
            f" {_shown(axis)}, its third column, is free with F* = R*^T F",
        ),
        series=done.series("zeroing"),
    )


def _pushes(forces: tuple[float, ...]) -> tuple[list[Push], list[tuple[float, float, float]]]:
    """A push along each of x, y, z in turn, and when it starts, ends, and the arm has come to rest [s]."""
    starts = [_FIRST + i * (_PUSH + _COAST) for i in range(len(forces))]
    times = [(t, t + _PUSH, t + _PUSH + _COAST) for t in starts]
    pushes = [push(times[i][0], times[i][1], i, force) for i, force in enumerate(forces)]
    return pushes, times


def _line(p: Array, axis: Array) -> tuple[Array, float, float]:
    """Direction (3,) of a way p (n, 3), on the side of axis; greatest distance from the axis, extent along it [m]."""
    way = p - p[0]
    direction = np.linalg.svd(way - way.mean(axis=0), full_matrices=False)[2][0]
    along = way @ axis
    aside = float(np.max(np.linalg.norm(way - along[:, None] * axis, axis=1)))
    return direction * np.sign(direction @ axis), aside, float(np.ptp(along))


def _shown(v: Array) -> str:
    return f"({', '.join(f'{x:.3f}' for x in v)})"


def _between(a: Array, b: Array) -> float:
    """Angle [rad] between two directions, exact for small ones."""
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))
