"""Where the experiments are done: the arm and its pose, the inertia all of them share, the period, the world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import radians
from pathlib import Path

import numpy as np

from trajopt_cli.admittance.controller import Controller
from trajopt_cli.admittance.loop import LoopRun, run
from trajopt_cli.admittance.parameters import Settings
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.angles import angles_of, continuous
from trajopt_cli.iiwa.task import Clamps, Compliance, Push, Zeroing
from trajopt_cli.iiwa.world import Seven
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import ArmAngle
from trajopt_cli.simulate.worlds import Engine, make_world

START: Seven = (0.0, radians(30), 0.0, radians(-100), 0.0, radians(50), 0.0)
"""Joints [rad] that every experiment begins at (section 6.1)."""
H = 1e-3
"""The controller's period [s]."""
INERTIA = (25.0, 25.0, 25.0, 3.0, 3.0, 3.0)
"""M [kg, kg m2] of every experiment."""
FORCE, MOMENT = 10.0, 2.0
"""Our steps [N, Nm]: the thesis shows its own in figures only."""

_PACKAGE = Path(__file__).parents[1]
# In a checkout the programs stand beside the package, a wheel carries them inside it.
_PROGRAMS = _PACKAGE.parent / "programs" if (_PACKAGE.parent / "pyproject.toml").is_file() else _PACKAGE / "programs"
_NOTHING = np.full(6, 1e-300)  # a clamp has to be above zero


def program(name: str) -> Path:
    """A shipped task file."""
    return _PROGRAMS / name


def compliance(k: float, k_turn: float, d: float, d_turn: float) -> Compliance:
    """The same stiffness k [N/m] and damping d [N s/m] along x, y, z; k_turn and d_turn about them."""
    return Compliance(np.repeat([k, k_turn], 3), np.repeat([d, d_turn], 3), np.array(INERTIA))


@dataclass(frozen=True, eq=False)
class Series:
    """One run over t (n,) [s]: equilibrium x_e, controller x, force (n, 6) [m, rad; N, Nm].

    flange (n, 6): as the world moved it, None where nothing but the controller was computed. felt (n, 6): forces before
    zeroing, None where nothing was zeroed.
    """

    label: str
    t: Array
    x_e: Array
    x: Array
    force: Array | None = None
    flange: Array | None = None
    felt: Array | None = None

    def __post_init__(self) -> None:
        for name in ("t", "x_e", "x", "force", "flange", "felt"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, readonly(getattr(self, name)))


@dataclass(frozen=True)
class Tracking:
    """How far the flange was from the controller's pose along axis [m or rad]: largest and mean, the thesis' beside."""

    axis: str
    maximum: float
    mean: float
    thesis_maximum: float
    thesis_mean: float


@dataclass(frozen=True)
class Bench:
    """The arm at START, in the world of an engine. moves: whether that world's flange has a motion of its own."""

    robot: SrsRobot
    engine: Engine
    start: Array = field(init=False, compare=False)

    def __post_init__(self) -> None:
        X = self.robot.forward(np.array(START))
        object.__setattr__(self, "start", readonly(np.r_[X[:3, 3], np.zeros(3)]))

    @property
    def moves(self) -> bool:
        """Whether the flange follows the command with a lag and a give of its own; the ideal arm does not."""
        return self.engine is Engine.MUJOCO

    def check(self) -> None:
        """Raise InputError where the engine is not installed."""
        make_world(self.engine, self.robot, np.eye(4), None, None, H)

    def pushed(
        self, law: Compliance, pushes: Sequence[Push], duration: float, zeroing: Zeroing | None = None
    ) -> LoopRun:
        """The whole loop for duration [s] under simulated forces, standing at START otherwise.

        Measured forces are zeroed before the simulated ones are added, as in section 6.1. Raises RuntimeError where
        the loop stops.
        """
        settings = Settings(
            compliance=law,
            h=H,
            definition=ArmAngle.FARIA,
            zeroing=Zeroing() if zeroing is None else zeroing,
            clamps=Clamps(force=_NOTHING),
            pushes=tuple(pushes),
        )
        controller = Controller(self.robot, settings, START)
        world = make_world(self.engine, self.robot, settings.X_FT, None, None, H)
        x_e = np.tile(self.start, (round(duration / H) + 1, 1))
        out = run(controller, x_e, world, self.robot.profile())
        if out.stop is not None:
            raise RuntimeError(f"an experiment of chapter 6 was stopped: {out.stop.message}")
        return out

    def flange(self, done: LoopRun, X_FT: Array | None = None) -> Array:
        """Positions [m] and angles from R_start [rad] (n, 6) of the TCP as the world moved it."""
        X = self.robot.forward(done.q) @ (np.eye(4) if X_FT is None else X_FT)
        angles = continuous(angles_of(X[:, :3, :3] @ done.R[0].T))
        return np.column_stack([X[:, :3, 3], angles])

    def series(self, label: str, done: LoopRun, felt: Array | None = None) -> Series:
        """A run as it is kept for pictures."""
        flange = self.flange(done) if self.moves else None
        return Series(label, done.t, done.x_e, done.x, done.force_believed, flange, felt)


def push(start: float, end: float, axis: int, size: float | None = None) -> Push:
    """A force or moment along one axis 0..5 from start to end [s], of FORCE or MOMENT unless given [N, Nm]."""
    force = np.zeros(6)
    force[axis] = (FORCE if axis < 3 else MOMENT) if size is None else size
    return Push(start, end, force)
