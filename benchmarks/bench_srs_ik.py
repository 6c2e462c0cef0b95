"""Seven-axis inverse kinematics: poses per second of 1000 poses on one thread, and microseconds of one sample.

python benchmarks/bench_srs_ik.py [--poses N] [--seconds S]
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

from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle, configuration, inverse, inverse_branch
from trajopt_cli.robot.srs_step import SrsStep


def durations(call, seconds):
    """Best and median duration [s] of repeated calls."""
    call()
    times, end = [], perf_counter() + seconds
    while perf_counter() < end or len(times) < 5:
        start = perf_counter()
        call()
        times.append(perf_counter() - start)
    return min(times), float(np.median(times))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", type=int, default=1000)
    parser.add_argument("--seconds", type=float, default=1.0, help="measured per row")
    options = parser.parse_args()
    robot, n = load_srs("iiwa7"), options.poses
    limits = robot.profile()
    q = np.random.default_rng(7).uniform(limits.lower, limits.upper, (n, 7))
    X = robot.forward(q)
    print(f"{'':36}{'best':>12}{'median':>12}  poses/s, single thread, {n} poses")
    rows = {}
    for definition in ArmAngle:
        psi = arm_angle(robot, q, definition)
        rows[f"inverse, 8 configurations, {definition.value}"] = lambda psi=psi, d=definition: inverse(robot, X, psi, d)
        rows[f"inverse_branch, {definition.value}"] = lambda psi=psi, d=definition: inverse_branch(robot, X, psi, d, 2)
    rows["forward"] = lambda: robot.forward(q)
    rows["jacobian"] = lambda: robot.jacobian(q)
    for label, call in rows.items():
        best, median = durations(call, options.seconds)
        print(f"{label:36}{n / best:12,.0f}{n / median:12,.0f}")
    step = SrsStep(robot, ArmAngle.SWIVEL, int(configuration(q[0])), float(arm_angle(robot, q[0], ArmAngle.SWIVEL)))
    one = tuple(q[0].tolist())
    pose_1 = step.forward(one)
    print(f"{'':36}{'best':>12}{'median':>12}  us, one sample in plain floats")
    singles = {
        "SrsStep.joints": lambda: step.joints(*pose_1),
        "SrsStep.forward": lambda: step.forward(one),
        "SrsStep.jacobian": lambda: step.jacobian(one),
    }
    for label, call in singles.items():
        best, median = durations(call, options.seconds)
        print(f"{label:36}{1e6 * best:12.1f}{1e6 * median:12.1f}")


if __name__ == "__main__":
    main()
