"""The compliant controller: 60 s of its law at 1 kHz, and one period of the whole loop, part by part.

python benchmarks/bench_admittance.py [--seconds S] [--periods N]
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import sys
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.loop import PARTS, run
from trajopt_cli.iiwa.controller.parameters import Settings
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.task.model import Compliance, Feed, Integration, RotationLaw, Sensor
from trajopt_cli.iiwa.task.world import Measured
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle

H = 1e-3
HOME = tuple(np.radians([0.0, 30, 0, -100, 0, 50, 0]).tolist())
COMPLIANCE = Compliance(
    np.array([1000.0] * 3 + [30] * 3), np.array([500.0] * 3 + [20] * 3), np.array([25.0] * 3 + [3] * 3)
)


class Ideal:
    """Follows every command at once; the torques are those of gravity, found beforehand."""

    name = "ideal"

    def __init__(self, tau):
        self._tau = tau

    def reset(self, q):
        self._q = q
        return Measured(q, (0.0,) * 7, (0.0,) * 7, self._tau, (0.0,) * 6, 0.0)

    def step(self, q):
        qd = tuple((b - a) / H for a, b in zip(self._q, q, strict=True))
        self._q = q
        return Measured(q, qd, (0.0,) * 7, self._tau, (0.0,) * 6, 0.0)


def law_rows(seconds: float) -> None:
    """How long the law alone takes, all six axes."""
    n = round(seconds / H)
    t = np.arange(n) * H
    x_e, force = 0.1 * np.sin(t)[:, None] * np.ones(6), 5 * np.cos(3 * t)[:, None] * np.ones(6)
    R_e = np.broadcast_to(np.eye(3), (n, 3, 3))
    rows = {
        "Euler": lambda: response(x_e, H, COMPLIANCE),
        "Euler, force, speed fed": lambda: response(x_e, H, COMPLIANCE, feed=Feed.VELOCITY, force=force),
        "exact, force": lambda: response(x_e, H, COMPLIANCE, integration=Integration.EXACT, force=force),
        "rotation without lock": lambda: response(x_e, H, COMPLIANCE, R_e=R_e, force=force),
    }
    print(f"{seconds:g} s at {1 / H:g} Hz, {n} rows{'':14}{'s':>10}{'x real time':>14}")
    for name, call in rows.items():
        call()
        times = []
        for _ in range(5):
            start = perf_counter()
            call()
            times.append(perf_counter() - start)
        print(f"{name:40}{min(times):10.3f}{seconds / min(times):14,.0f}")


def period_rows(periods: int) -> None:
    """One period of the controller with torque errors on a straight way, by parts."""
    robot = load_srs("iiwa7")
    tau = tuple(Dynamics(robot).gravity_torque(np.array(HOME)).tolist())
    start = robot.forward(np.array(HOME))
    x_e = np.tile([*start[:3, 3], 0, 0, 0], (periods, 1))
    x_e[:, 1] += 0.1 * np.sin(2 * np.pi * np.arange(periods) * H / 5)
    R_e = np.broadcast_to(start[:3, :3], (periods, 3, 3))
    for law in RotationLaw:
        settings = Settings(COMPLIANCE, H, ArmAngle.FARIA, sensor=Sensor(rigid=True), rotation=law)
        found = run(Controller(robot, settings, HOME), x_e, Ideal(tau), robot.profile(), R_e=R_e)
        assert found.stop is None, found.stop
        times = 1e6 * np.column_stack([found.step_times, found.step_times[:, 1:4].sum(axis=1)])
        print(f"\none period, {law.value}, {len(times)} periods [us]{'':6}{'min':>8}{'mean':>8}{'99.9 %':>8}{'max':>8}")
        for name, column in zip((*PARTS, "without the torque model"), times.T, strict=True):
            figures = column.min(), column.mean(), np.percentile(column, 99.9), column.max()
            print(f"{name:46}" + "".join(f"{value:8.0f}" for value in figures))
    print(f"{'thesis: C++, i3-7100T, without the torque model':46}{'':>24}{148:8}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0, help="of the law alone")
    parser.add_argument("--periods", type=int, default=10000, help="of the whole loop")
    options = parser.parse_args()
    law_rows(options.seconds)
    period_rows(options.periods)


if __name__ == "__main__":
    main()
