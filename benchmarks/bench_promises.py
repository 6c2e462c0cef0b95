"""Offences a hundredth beyond what the judge says it is sure to see: how many of them it finds.

    python benchmarks/bench_promises.py --offences 200

For every promise random offences, from the seed 0 on, in files with rows every 4, 10 and 20 ms, 5 to 17 digits, with
the speeds and without. Prints a line for each promise; exit code 1 if an offence was missed.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

TESTS = Path(__file__).parents[1] / "tests"
sys.path[:0] = [str(TESTS.parent), str(TESTS), str(TESTS / "judge")]  # run from a checkout without installing

import numpy as np  # noqa: E402
from offences import OFFENCES  # noqa: E402

TIMES = 1.01


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--offences", type=int, default=200)
    parser.add_argument("--promises", nargs="*", default=[*OFFENCES])
    options = parser.parse_args()
    print(f"{'promise':28}{'offences':>9}{'found':>7}  missed (seed, excess)")
    missed = 0
    for name in options.promises:
        tried, found, lost, seed = 0, 0, [], 0
        while tried < options.offences and seed < 10 * options.offences:
            outcome = OFFENCES[name](np.random.default_rng(seed), TIMES)
            if outcome is not None:
                tried, found = tried + 1, found + outcome.found
                if not outcome.found:
                    lost.append(f"{seed}: {outcome.excess:.3g} {outcome.promise.unit}")
            seed += 1
        missed += tried - found
        print(f"{name:28}{tried:9}{found:7}  {'; '.join(lost[:4])}", flush=True)
    sys.exit(missed > 0)


if __name__ == "__main__":
    main()
