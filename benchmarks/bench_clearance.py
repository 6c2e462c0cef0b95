"""Clearance of a whole motion: seconds for one file of joint positions, one thread.

python benchmarks/bench_clearance.py [CSV --cell CELL] [--repeat N]

Without a file: the hinge cell's points by rest-to-rest joint moves, and five obstacles around them.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.geometry import pose
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.motion import Program
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.shapes import Box, Capsule, Solid
from trajopt_cli.trajectory import Trajectory

REPOSITORY = Path(__file__).parents[1]


def box(name, size, position):
    return Box(name, np.array(size), pose(np.eye(3), position))


OBSTACLES = (
    Solid(box("table", [0.4, 3.0, 0.04], [0.6, 1.0, 0.22])),
    Solid(box("fence", [0.02, 4.0, 2.0], [-0.6, 1.0, 1.0]), frozenset({"base_link"})),
    Solid(box("cabinet", [0.5, 0.5, 1.0], [1.1, 0.7, 0.5])),
    Solid(Capsule("post", np.array([0.75, 1.6, 0.0]), np.array([0.75, 1.6, 1.2]), 0.05)),
    Solid(box("beam", [0.1, 3.0, 0.1], [0.3, 1.0, 1.2])),
)


def moves(plant):
    """Home, the three stations and home again, 1 s each, quintic in the joints, rows of 1 kHz."""
    R = np.diag([-1.0, 1.0, -1.0])
    stops = [plant.start]
    for y, z, rail in ((0.2, 0.45, 0.1), (0.2, 0.33, 0.2), (1.35, 0.45, 1.3), (1.35, 0.33, 1.3), (1.9, 0.52, 1.8)):
        stops.append(np.r_[rail, inverse(plant.robot, pose(R, [0.5, y, z])[None], np.array([rail]))[0, 0]])
    stops.append(plant.start)
    u = np.linspace(0, 1, 1001)[:-1, None]
    share, rate = u**3 * (10 + u * (6 * u - 15)), 30 * u**2 * (1 - u) ** 2
    q = [a + share * (b - a) for a, b in pairwise(stops)]
    qd = [rate * (b - a) for a, b in pairwise(stops)]
    rows = np.concatenate(q)
    return Trajectory(plant.limits.names, np.arange(len(rows)) * 1e-3, rows, np.concatenate(qd))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("csv", nargs="?", type=Path)
    parser.add_argument("--cell", type=Path, default=REPOSITORY / "programs" / "hinge_cell.yaml")
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    plant = build_plant(load_cell(options.cell))
    plant = plant if plant.obstacles else replace(plant, obstacles=OBSTACLES)
    trajectory = read_csv_text(options.csv.read_text(), str(options.csv))[0] if options.csv else moves(plant)
    seconds = []
    for _ in range(options.repeat):
        start = perf_counter()
        findings = check_clearance(Program("main", (), {}), plant, trajectory, lambda _: None)
        seconds.append(perf_counter() - start)
    for one in findings:
        print(f"{one.value * 1e3:9.2f} mm  {one.message}")
    print(f"{trajectory.duration:.3f} s of motion, {len(trajectory.t)} rows, {len(plant.obstacles)} obstacles:")
    print(f"best {min(seconds):.3f} s, median {np.median(seconds):.3f} s, first {seconds[0]:.3f} s (imports included)")


if __name__ == "__main__":
    main()
