"""Inverse kinematics, all eight branches of 1000 poses: poses per second on one thread.

python benchmarks/bench_ik.py [--poses N] [--seconds S]
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

from trajopt_cli.robot.inverse import inverse
from trajopt_cli.robot.model import load_robot


def rate(call, poses, seconds):
    """Best and median poses/s of repeated calls."""
    call()
    times, end = [], perf_counter() + seconds
    while perf_counter() < end or len(times) < 5:
        start = perf_counter()
        call()
        times.append(perf_counter() - start)
    return poses / min(times), poses / float(np.median(times))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", type=int, default=1000)
    parser.add_argument("--seconds", type=float, default=1.0, help="measured per row")
    options = parser.parse_args()
    rng = np.random.default_rng(140)
    print(f"{'':34}{'best':>12}{'median':>12}  poses/s, single thread")
    for name in ("irb140", "irb140_rail"):
        robot = load_robot(name)
        n = options.poses
        limits = robot.profile()
        q = rng.uniform(limits.lower, limits.upper, (n, len(robot.axis_names)))
        qd = rng.normal(size=q.shape)
        X = robot.forward(q)
        rail = q[:, 0] if robot.has_rail else None
        rows = {
            f"{name} inverse, 8 branches": lambda robot=robot, X=X, rail=rail: inverse(robot, X, rail),
            f"{name} forward": lambda robot=robot, q=q: robot.forward(q),
            f"{name} jacobian": lambda robot=robot, q=q: robot.jacobian(q),
            f"{name} bias": lambda robot=robot, q=q, qd=qd: robot.differential(q).bias(qd),
        }
        for label, call in rows.items():
            best, median = rate(call, n, options.seconds)
            print(f"{label:34}{best:12,.0f}{median:12,.0f}  ({n} poses)")


if __name__ == "__main__":
    main()
