"""Plants and programs that the optimiser's tests share."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom
from trajopt_cli.problem.editable import Changes, everything
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.robot.model import load_robot
from trajopt_cli.scenario import Scenario
from trajopt_cli.trajectories.axes import Axes

HOME = np.array([0, 0, 0, 0, np.pi / 6, 0])
DOWN = rotation_about([0, 1, 0], np.pi)
STROKE = (-0.2, 2.2)


def plant_with_rail(stroke: tuple[float, float] = STROKE, X_WR: Array | None = None, **more: object) -> Plant:
    """The hinge cell's plant; more: fields of Plant to replace."""
    robot = load_robot("irb140_rail", X_WR)
    base = robot.profile()
    limits = JointLimits(
        base.names,
        np.r_[stroke[0], base.lower[1:]],
        np.r_[stroke[1], base.upper[1:]],
        np.r_[1.0, base.velocity[1:]],
        np.array([3.0, 15, 12.5, 20, 40, 40, 60]),
    )
    plant = Plant(robot, limits, TcpCaps(2.5, 20.0), np.r_[0.0, HOME], (0,), False, False, frozenset())
    return replace(plant, **more)


def plant_without_rail(**more: object) -> Plant:
    robot = load_robot("irb140")
    plant = Plant(robot, robot.profile(), TcpCaps(2.5, 20.0), HOME, (), False, False, frozenset())
    return replace(plant, **more)


def rapid(body: str, scenario: Scenario | None = None, data: str = "") -> Program:
    """A program from the text of its main; data: declarations before it. Line 1 of the body is line 5 of t.mod."""
    lines = ["MODULE T", data.replace("\n", " "), DATA.replace("\n", " "), "PROC main()", body, "ENDPROC", "ENDMODULE"]
    return run_program([TextFile("t.mod", "\n".join(lines), "utf-8")], scenario)


DATA = """CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_in:=[[500,600,450],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_low:=[[500,600,390],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];"""


def down(x: float, y: float, z: float, turn: float = 0.0) -> Array:
    return pose(rotation_about([0, 0, 1], turn) @ DOWN, [x, y, z])


def problem_of(
    program: Program,
    plant: Plant,
    target: Target = Target.STREAM,
    freedom: Freedom = EVERYTHING,
    changes: Changes | None = None,
    **more: object,
) -> Problem:
    problem = build_problem(program, plant, freedom, target, changes or everything(program, plant), **more)
    assert isinstance(problem, Problem), problem
    return problem


MOUNTS = ("as it is", "turned", "slanted")


def mounted(name: str, stroke: tuple[float, float] = STROKE) -> Axes:
    """Three rails: as it ships; with the whole cell turned in the world; climbing past the arm's base at a slant.

    Only the last one moves the base along another direction than its own y axis, whatever the mounting in the world.
    """
    X_WR = np.eye(4)
    if name != "as it is":
        X_WR = pose(rotation_about([1, 0, 0], 0.6) @ rotation_about([0, 0, 1], -0.8), [-0.1, 0.2, 0.3])
    plant = plant_with_rail(stroke, X_WR)
    if name == "slanted":
        slant = np.array([0.3, 0.8, 0.5])
        plant = replace(plant, robot=replace(plant.robot, rail_axes=slant[None] / np.linalg.norm(slant)))
    return Axes.of(plant)


def safe_arm(rng: np.random.Generator, axes: Axes, n: int, margin: float = 0.15) -> Array:
    """Random arm joints (n, 6) inside the limits and away from the three singularities."""
    arm = axes.robot.arm
    found = np.empty((0, 6))
    while len(found) < n:
        q = rng.uniform(axes.lower[axes.layout.arm], axes.upper[axes.layout.arm], (4 * n, 6))
        radius = arm.a1 + arm.c2 * np.sin(q[:, 1]) + arm.c3 * np.cos(q[:, 1] + q[:, 2])
        ok = (np.abs(np.sin(q[:, 4])) > margin) & (np.abs(np.cos(q[:, 2])) > margin) & (np.abs(radius) > margin)
        found = np.concatenate([found, q[ok]])
    return found[:n]
