"""What logs are said to show that axes reached, against motions in closed form, by kind of recorder: how much of the
truth, how often more than it, and what of a steady speed is taken for an acceleration.

python benchmarks/bench_reached.py [--runs 25]
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]  # run from a checkout without installing

from measured.test_reached import LIMITS, Motion, recorded, trapezoids, waves  # noqa: E402

from trajopt_cli.measured.identify import Kind  # noqa: E402
from trajopt_cli.measured.reached import reached_in  # noqa: E402

RECORDERS = [  # rounded to [deg], off by [s], lost, stale
    (0.001, 0.0, 0.0, 0.0),
    (0.01, 0.0, 0.0, 0.0),
    (0.1, 0.0, 0.0, 0.0),
    (0.01, 1e-3, 0.02, 0.0),
    (0.01, 2e-3, 0.1, 0.1),
    (0.1, 2e-3, 0.05, 0.0),
]


def ramped(rng: np.random.Generator) -> tuple[Motion, np.ndarray, np.ndarray]:
    a, v = rng.uniform(2, 15, 6), rng.uniform(0.5, 2, 6)
    return lambda t: np.column_stack([trapezoids(t, *one) for one in zip(a, v, strict=True)]), v, a


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--runs", type=int, default=25)
    runs = parser.parse_args().runs
    print("rows every  rounded to  off by  lost  stale   speed  acceleration, least  beyond  most    steady 1 rad/s")
    for period in (0.004, 0.008, 0.024):
        for degrees, jitter, lost, stale in RECORDERS:
            shares: dict[Kind, list[float]] = {Kind.SPEED: [], Kind.ACCELERATION: []}
            steady = [0.0]
            t = np.arange(0, 12, period)
            for seed in range(runs):
                rng = np.random.default_rng(seed)
                how = np.radians(degrees), jitter, lost, stale
                for motion, v, a in (waves(seed), ramped(rng)):
                    for one in reached_in([recorded(t, motion, rng, *how)], ["log"], LIMITS):
                        truth = (v if one.kind is Kind.SPEED else a)[LIMITS.names.index(one.axis)]
                        shares[one.kind].append(one.value / truth)
                still = recorded(t, lambda x: np.repeat(x[:, None], 6, 1), rng, *how)
                steady += [one.value for one in reached_in([still], ["log"], LIMITS) if one.kind is Kind.ACCELERATION]
            a = np.array(shares[Kind.ACCELERATION])
            print(
                f"{1e3 * period:7.0f} ms {degrees:7g} deg {1e3 * jitter:4g} ms {100 * lost:3g} % {100 * stale:4g} % "
                f"{100 * np.median(shares[Kind.SPEED]):6.1f} % {100 * np.median(a):10.1f} % {100 * a.min():7.1f} % "
                f"{np.sum(a > 1):3d} of {len(a)} {a.max():6.3f} {max(steady):10.2f} rad/s2"
            )


if __name__ == "__main__":
    main()
