"""Where the experiments are done: the arm and its pose, the inertia all of them share, the period, the world."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import radians
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.controller.forces import zero
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.report.follow import Draw, Following, picture
from trajopt_cli.iiwa.task.angles import angles_of, continuous, rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.joint_checks import Arm, stops_loop
from trajopt_cli.iiwa.task.joints import Unfollowable, follow
from trajopt_cli.iiwa.task.model import AngleMeaning, Compliance, Push, RotationLaw, Zeroing
from trajopt_cli.iiwa.task.world import Seven, seven
from trajopt_cli.iiwa.world.worlds import Engine, make_world
from trajopt_cli.robot.srs import SrsRobot

START: Seven = (0.0, radians(30), 0.0, radians(-100), 0.0, radians(50), 0.0)
"""Joints [rad] that every experiment begins at (section 6.1)."""
H = 1e-3
"""The controller's period [s]."""
INERTIA = (25.0, 25.0, 25.0, 3.0, 3.0, 3.0)
"""M [kg, kg m2] of every experiment."""
FORCE, MOMENT = 10.0, 2.0
"""Our steps [N, Nm]: the thesis shows its own in figures only."""


@dataclass(frozen=True, eq=False)
class Experiment:
    """What one experiment gave.

    numbers: SI values beside the thesis', under names that end in their unit, as experiments.json has them; lists of
    rows become tables. notes: what is ours and what differs. figures: by file name, called with a heading. measured:
    times of a clock, which differ from run to run.
    """

    section: str
    title: str
    notes: Sequence[str]
    numbers: Mapping[str, Any]
    figures: Mapping[str, Draw] = field(default_factory=dict)
    measured: Mapping[str, Any] = field(default_factory=dict)

    @property
    def record(self) -> dict[str, Any]:
        """Its part of experiments.json."""
        return {"section": self.section, "title": self.title, "notes": list(self.notes), **self.numbers}

    def draw(self) -> dict[str, bytes]:
        """File name -> contents of its pictures."""
        heading = f"{self.section} {self.title}"
        drawn = [picture(name, heading, make) for name, make in self.figures.items()]
        return {name: content for files in drawn for name, content in files.items()}


def compliance(k: float, k_turn: float, d: float, d_turn: float) -> Compliance:
    """The same stiffness k [N/m] and damping d [N s/m] along x, y, z; k_turn and d_turn about them."""
    return Compliance(np.repeat([k, k_turn], 3), np.repeat([d, d_turn], 3), np.array(INERTIA))


@dataclass(frozen=True, eq=False)
class Pushed:
    """What simulated forces do, rows every H [s]: run; the controller's rates v, and forces before zeroing (n, 6)."""

    run: Following
    v: Array
    unzeroed: Array


@dataclass(frozen=True)
class Bench:
    """The arm at START, in the world of an engine. Raises InputError where the engine is not installed."""

    robot: SrsRobot
    engine: Engine
    start: Array = field(init=False, compare=False)

    def __post_init__(self) -> None:
        X = self.robot.forward(np.array(START))
        object.__setattr__(self, "start", readonly(np.r_[X[:3, 3], np.zeros(3)]))
        make_world(self.engine, self.robot, np.eye(4), None, None, H)

    @property
    def moves(self) -> bool:
        """Whether the flange follows the command with a lag and a give of its own; the ideal arm does not."""
        return self.engine is Engine.MUJOCO

    def pushed(
        self, law: Compliance, pushes: Sequence[Push], duration: float, zeroing: Zeroing | None = None
    ) -> Pushed:
        """The controller standing at START for duration [s], moved by simulated forces alone.

        Measured forces are zeroed there (section 6.1), so that nothing the world does comes back: the law is computed
        first, then inverse kinematics with every limit, then the world follows. The loop, period by period, gives the
        same. Raises RuntimeError where a joint limit would stop the loop.
        """
        t = np.arange(round(duration / H) + 1, dtype=np.float64) * H
        unzeroed = np.zeros((len(t), 6))
        for one in pushes:
            unzeroed[round(one.start / H) : round(one.end / H)] += one.force
        force = unzeroed if zeroing is None else zero(unzeroed, zeroing)
        x_e = np.tile(self.start, (len(t), 1))
        done = response(x_e, H, law, force=force)
        whole = (Piece(0, len(t) - 1, "start", "end"),)
        turn = rotation(done.x[:, 3:])
        sequence = Equilibrium(H, done.x, turn, RotationLaw.TAIT_BRYAN, AngleMeaning.RELATIVE, whole)
        X_FT = np.eye(4)
        joints = follow(sequence, Arm(self.robot, X_FT, np.array(START), self.robot.profile()))
        broken = [joints] if isinstance(joints, Unfollowable) else stops_loop(joints.findings)
        if broken or isinstance(joints, Unfollowable):
            raise RuntimeError(f"an experiment of chapter 6 would be stopped: {broken[0].message}")
        world, flange = make_world(self.engine, self.robot, X_FT, None, None, H), None
        if self.moves:
            rows = [world.reset(START).q, *(world.step(seven(row)).q for row in joints.trajectory.q[1:])]
            flange = self.tool(np.array(rows), X_FT)
        return Pushed(Following(world.name, t, x_e, done.x, force, flange), done.v, unzeroed)

    def tool(self, q: Array, X_FT: Array) -> Array:
        """Positions [m] and angles from the first row's orientation [rad] (n, 6) of the TCP at joints q (n, 7)."""
        X = self.robot.forward(q) @ X_FT
        angles = continuous(angles_of(X[:, :3, :3] @ X[0, :3, :3].T))
        return np.column_stack([X[:, :3, 3], angles])


def push(start: float, end: float, axis: int, size: float | None = None) -> Push:
    """A force or moment along one axis 0..5 from start to end [s], of FORCE or MOMENT unless given [N, Nm]."""
    force = np.zeros(6)
    force[axis] = (FORCE if axis < 3 else MOMENT) if size is None else size
    return Push(start, end, force)
