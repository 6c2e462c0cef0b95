"""Section 6.3: how long one period of the loop computes."""

from __future__ import annotations

import platform
from dataclasses import dataclass

import numpy as np

from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.loop import PARTS, run
from trajopt_cli.iiwa.controller.parameters import Settings
from trajopt_cli.iiwa.experiments.published import LOOP_WORST
from trajopt_cli.iiwa.experiments.setup import START, Bench, H, compliance, push
from trajopt_cli.iiwa.task.model import Sensor
from trajopt_cli.iiwa.world.worlds import Engine, make_world
from trajopt_cli.robot.srs_inverse import ArmAngle

_WARM, _PERIODS = 200, 3000


@dataclass(frozen=True)
class Part:
    """Shortest, mean and longest time [s] of one part of a period."""

    name: str
    least: float
    mean: float
    most: float


@dataclass(frozen=True)
class LoopTimes:
    """parts: by their order in the loop, the last one their sum without the torque model, which the thesis' figure does
    not hold (KUKA's cabinet computes it). thesis_worst [s]: its longest sum. language: what ran here, and on what."""

    section: str
    title: str
    periods: int
    parts: tuple[Part, ...]
    thesis_worst: float
    language: str
    sentences: tuple[str, ...]


def loop_time(bench: Bench) -> LoopTimes:
    """6.3: some thousand periods under a force on every axis, measured with sensor errors, without the world's time."""
    settings = Settings(
        compliance=compliance(200.0, 40.0, 100.0, 30.0),
        h=H,
        definition=ArmAngle.FARIA,
        sensor=Sensor(),
        pushes=tuple(push(0.0, np.inf, axis) for axis in range(6)),
    )
    world = make_world(Engine.SPRING, bench.robot, settings.X_FT, None, None, H)
    controller = Controller(bench.robot, settings, START)
    x_e = np.tile(bench.start, (_WARM + _PERIODS + 1, 1))
    done = run(controller, x_e, world, bench.robot.profile())
    if done.stop is not None:
        raise RuntimeError(f"the loop stopped while it was timed: {done.stop.message}")
    times = dict(zip(PARTS, done.step_times[_WARM:].T, strict=True))
    columns = {name: row for name, row in times.items() if name != "whole"}
    columns["all but the torque model"] = times["whole"] - times["torque model"]
    return LoopTimes(
        section="6.3",
        title="time of one period",
        periods=_PERIODS,
        parts=tuple(Part(name, float(row.min()), float(row.mean()), float(row.max())) for name, row in columns.items()),
        thesis_worst=LOOP_WORST,
        language=f"Python {platform.python_version()} on this machine ({platform.machine()})",
        sentences=(
            "the thesis' loop is C++ on an Intel i3-7100T under a real-time kernel, 148 µs at worst; its figure has no"
            " other numbers; ours is Python without one: the longest times are those of whatever else the machine did",
        ),
    )
