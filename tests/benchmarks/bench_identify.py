"""Limits identified from simulated logs whose truth is hidden: how often it lies inside the stated interval, how wide
that is, and how far the estimate of another program is off with what was identified.

python tests/benchmarks/bench_identify.py [--runs 100] [--first 0] [--no-cycles]

Every run is another robot (half of them with limited jerk), another recorder and another program. The numbers of
trajopt_cli/measured were settled on runs from 9000 on; those from 0 on are for the table.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]  # run from a checkout without installing

from measured.campaign import PERIODS, Outcome, one_run  # noqa: E402


def table(outcomes: list[Outcome]) -> None:
    print(f"\n{'limit':14}{'period':>8}{'axes':>6}{'stated':>8}{'inside':>8}{'share':>8}{'half width':>12}{'error':>9}")
    for kind in ("speed", "acceleration", "jerk"):
        for period in (*PERIODS, None):
            rows = [one for out in outcomes for one in out.limits if one.kind == kind and period in (None, out.period)]
            stated = [one for one in rows if one.inside is not None]
            inside = sum(bool(one.inside) for one in stated)
            share = f"{100 * inside / len(stated):.1f} %" if stated else ""
            width = f"{100 * np.median([one.half for one in stated]):.3g} %" if stated else ""
            known = [abs(one.error) for one in stated if np.isfinite(one.error)]
            error = f"{100 * np.median(known):.2g} %" if known else ""
            name = "all" if period is None else f"{1e3 * period:.0f} ms"
            print(f"{kind:14}{name:>8}{len(rows):>6}{len(stated):>8}{inside:>8}{share:>8}{width:>12}{error:>9}")
    for kind in ("speed", "acceleration", "jerk"):
        good = sum(all(one.inside is not False for one in out.limits if one.kind == kind) for out in outcomes)
        print(f"runs in which every stated {kind} holds the truth: {good} of {len(outcomes)}")
    hidden = [one for out in outcomes for one in out.limits if one.slow and one.kind == "speed"]
    told = sum(one.inside is None for one in hidden)
    print(f"axes without a full-speed motion: {len(hidden)}, said so: {told}")


def cycles(outcomes: list[Outcome]) -> None:
    print("\nestimate of another program, with what was identified in the cell file, against the simulated cycle")
    print(f"{'period':>8}{'runs':>6}{'within 1 %':>12}{'median |error|':>16}{'worst':>9}")
    for period in (*PERIODS, None):
        for jerk in (False, True):
            rows = [
                one for one in outcomes if one.cycle is not None and period in (None, one.period) and one.jerk is jerk
            ]
            if rows:
                off = np.abs([one.cycle for one in rows])
                name = "all" if period is None else f"{1e3 * period:.0f} ms"
                law = "ramps of jerk" if jerk else "trapezoids"
                print(
                    f"{name:>8}{len(rows):>6}{np.sum(off < 0.01):>12}{100 * np.median(off):>14.2f} %"
                    f"{100 * off.max():>7.2f} %  {law}"
                )
    print("not estimated, as the log does not show a speed or an acceleration it needs:", end=" ")
    print(sum(one.cycle is None for one in outcomes))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--no-cycles", action="store_true")
    options = parser.parse_args()
    outcomes = []
    with TemporaryDirectory() as folder:
        for seed in range(options.first, options.first + options.runs):
            one = one_run(seed, None if options.no_cycles else Path(folder))
            outcomes.append(one)
            for limit in one.limits:
                if limit.inside is False:
                    what = f"run {seed}, {1e3 * one.period:.0f} ms: {limit.axis} {limit.kind}"
                    print(
                        f"{what} off by {100 * limit.error:+.2f} %, stated within {100 * limit.half:.2f} %", flush=True
                    )
            if one.cycle is not None and abs(one.cycle) > 0.01:
                law = "jerk" if one.jerk else "trapezoids"
                print(
                    f"run {seed}, {1e3 * one.period:.0f} ms, {law}: cycle off by {100 * one.cycle:+.2f} %", flush=True
                )
    table(outcomes)
    if not options.no_cycles:
        cycles(outcomes)


if __name__ == "__main__":
    main()
