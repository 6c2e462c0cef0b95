"""Section 6.2.4: crossing in y with an obstacle in z, there and back; the task is programs/iiwa_wall.yaml."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, readonly
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.loop import LoopRun, run
from trajopt_cli.iiwa.controller.parameters import Settings
from trajopt_cli.iiwa.experiments.setup import Bench, Series, program
from trajopt_cli.iiwa.task.angle_frames import counted
from trajopt_cli.iiwa.task.model import AngleMeaning, Task
from trajopt_cli.iiwa.task.segments import interpolate
from trajopt_cli.iiwa.task.world import Seven
from trajopt_cli.iiwa.world.worlds import Engine, make_world
from trajopt_cli.robot.srs import load_srs

NORMAL = 2
"""The axis of the obstacle's surface: z."""
_APART = 0.2  # s without contact that make two crossings of one
_SETTLE = 1.0  # s after the last row


@dataclass(frozen=True, eq=False)
class Touching:
    """A collision in one world. first [s]: of contact. excursion [m]: greatest distance of the tool, as the arm stands,
    from the equilibrium in z while touching, at excursion_at [s]; controller: that of the controller's pose.
    normal, across [N]: greatest true force along z and across it, where an edge pushes too; friction [N]: across it
    on the obstacle's top, where nothing but friction does; believed [N]: greatest force along z that the controller
    reckoned with. depth (n,) [m]. crossings: contacts apart in time. stop: why the loop ended early, empty where it
    did not. All figures are 0, times None, where nothing is touched.
    """

    world: str
    first: float | None
    excursion: float
    excursion_at: float | None
    controller: float
    normal: float
    normal_at: float | None
    across: float
    friction: float
    believed: float
    deepest: float
    crossings: int
    stop: str
    depth: Array
    series: Series

    def __post_init__(self) -> None:
        object.__setattr__(self, "depth", readonly(self.depth))


@dataclass(frozen=True, eq=False)
class Collision:
    """The same task in one world or two."""

    section: str
    title: str
    task: str
    runs: tuple[Touching, ...]
    sentences: tuple[str, ...]


def collision(bench: Bench, path: Path | None = None) -> Collision:
    """6.2.4: the task of a file, iiwa_wall.yaml unless given, against springs and, on MuJoCo's bench, there too."""
    from trajopt_cli.iiwa.task.loader import load_task

    file = program("iiwa_wall.yaml") if path is None else path
    task = load_task(file)
    engines = [Engine.SPRING] + ([Engine.MUJOCO] if bench.moves else [])
    runs = tuple(_touching(Bench(load_srs(task.robot, task.X_WB), engine), task) for engine in engines)
    sentences = [
        "the path and the obstacle are ours: the thesis shows its path and forces in a figure, without numbers"
    ]
    if not bench.moves:
        sentences.append("the same in MuJoCo's physics needs the extra sim")
    return Collision("6.2.4", "collision with an obstacle", file.name, runs, tuple(sentences))


def _touching(bench: Bench, task: Task) -> Touching:
    q_0 = _seven(task.start_joints)
    X_start = bench.robot.forward(task.start_joints) @ task.X_FT
    planned = counted(interpolate(task.route), AngleMeaning.RELATIVE, X_start[:3, :3])
    controller = Controller(bench.robot, Settings.of(task), q_0)
    world = make_world(bench.engine, bench.robot, task.X_FT, task.load, task.contact, task.route.h)
    done = run(
        controller,
        planned.pose,
        world,
        bench.robot.profile(task.limits),
        R_e=planned.rotations(X_start[:3, :3]),
        settle=_SETTLE,
    )
    return _measured(bench, task, done)


def _measured(bench: Bench, task: Task, done: LoopRun) -> Touching:
    on = np.flatnonzero(done.depth > 0)
    stop = "" if done.stop is None else done.stop.message
    series = Series(
        done.world,
        done.t,
        done.x_e,
        done.x,
        done.contact_true,
        bench.flange(done.q, task.X_FT) if bench.moves else None,
    )
    if len(on) == 0:
        return Touching(done.world, None, 0.0, None, 0.0, 0.0, None, 0.0, 0.0, 0.0, 0.0, 0, stop, done.depth, series)
    tool = done.x if series.flange is None else series.flange
    away, controller = (np.abs(pose[on, NORMAL] - done.x_e[on, NORMAL]) for pose in (tool, done.x))
    along = np.abs(done.contact_true[on, NORMAL])
    across = np.linalg.norm(np.delete(done.contact_true[on, :3], NORMAL, axis=1), axis=1)
    return Touching(
        world=done.world,
        first=float(done.t[on[0]]),
        excursion=float(away.max()),
        excursion_at=float(done.t[on[np.argmax(away)]]),
        controller=float(controller.max()),
        normal=float(along.max()),
        normal_at=float(done.t[on[np.argmax(along)]]),
        across=float(across.max()),
        friction=float(across[_on_top(bench, task, done)[on]].max(initial=0.0)),
        believed=float(np.abs(done.force_believed[on, NORMAL]).max()),
        deepest=float(done.depth.max()),
        crossings=1 + int(np.sum(np.diff(done.t[on]) > _APART)),
        stop=stop,
        depth=done.depth,
        series=series,
    )


def _on_top(bench: Bench, task: Task, done: LoopRun) -> BoolArray:
    """Whether the tool centre point is over (or under) an obstacle's top (n,): the surface's normal is z there."""
    p = bench.flange(done.q, task.X_FT)[:, :3]
    over = np.zeros(len(p), dtype=np.bool_)
    for obstacle in task.contact.obstacles if task.contact is not None else ():
        X, half = obstacle.box.X, obstacle.box.size / 2
        local = (p - X[:3, 3]) @ X[:3, :3]
        over |= np.all(np.abs(local[:, :NORMAL]) <= half[:NORMAL], axis=1)
    return over


def _seven(values: Array) -> Seven:
    a, b, c, d, e, f, g = values.tolist()
    return (a, b, c, d, e, f, g)
