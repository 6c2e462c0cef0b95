"""The edges of the 20 cm cube dosed: python benchmarks/bench_dose.py.

Once at once at full speed, and once as programs/iiwa_cube.yaml has it, with its ramps as caps. Prints durations with
their lower bound, push, the largest lag, and the seconds of computing.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import sys
from itertools import pairwise
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.iiwa.controller.feed_path import Allowed, CannotDose, DosePath, Lead, dose_path
from trajopt_cli.iiwa.controller.feed_schedule import FeedTask, dose
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.loader import load_task
from trajopt_cli.iiwa.task.model import AngleMeaning, Compliance, RotationLaw
from trajopt_cli.iiwa.task.segments import interpolate

SIDE, H = 0.2, 1e-3  # m, s
CORNERS = "000 100 110 010 000 001 101 100 101 111 110 111 011 010 011 001"  # every edge, three of them twice


def cube(speed: float) -> Equilibrium:
    """The edges, a row every H at this speed [m/s]."""
    points = SIDE * np.array([[int(c) for c in corner] for corner in CORNERS.split()], dtype=float)
    rows, pieces = [points[:1]], []
    count = round(SIDE / speed / H)
    for i, (a, b) in enumerate(pairwise(points)):
        rows.append(a + (b - a) * np.arange(1, count + 1)[:, None] / count)
        pieces.append(Piece(i * count, (i + 1) * count, f"corner {i + 1}", f"corner {i + 2}"))
    p = np.concatenate(rows)
    pose = np.hstack([p, np.zeros_like(p)])
    R = np.tile(np.eye(3), (len(p), 1, 1))
    return Equilibrium(H, pose, R, RotationLaw.TAIT_BRYAN, AngleMeaning.RELATIVE, tuple(pieces))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--speed", type=float, default=0.4, help="m/s")
    parser.add_argument("--bound", type=float, default=0.005, help="m")
    options = parser.parse_args()
    equilibrium = cube(options.speed)
    path = dose_path(equilibrium)
    measure("at once at full speed", path, options.bound)
    ramped = interpolate(load_task(Path(__file__).parents[1] / "programs" / "iiwa_cube.yaml").route)
    measure("programs/iiwa_cube.yaml", dose_path(ramped), options.bound)


def measure(name: str, path: DosePath, bound: float) -> None:
    """Dose one path for three laws, and print what comes out."""
    print(f"{name}: {len(path.s) - 1} straight stretches")
    for k, d in ((1000.0, 500.0), (1000.0, 100.0), (500.0, 50.0)):
        law = Compliance(np.r_[[k] * 3, [30.0] * 3], np.r_[[d] * 3, [20.0] * 3], np.r_[[25.0] * 3, [3.0] * 3])
        start = perf_counter()
        print(f"K = {k:g} N/m, D = {d:g} N s/m, M = 25 kg, lag at most {1000 * bound:g} mm")
        try:
            made = dose(FeedTask(path, law, H), Allowed(bound, lead=Lead(bound, stretch=True)))
        except CannotDose as error:
            print(f"  {error}")
            continue
        seconds = perf_counter() - start
        print(f"  T = {made.duration:8.3f} s, push {made.push:.1f} N, lag {1000 * made.lag.maximum:8.3f} mm")
        least = "none" if made.least is None else f"{made.least:.3f} s, gap {made.gap:.1%}"
        print(f"  lower bound {least}; {len(made.pose)} rows in {seconds:.1f} s")


if __name__ == "__main__":
    main()
