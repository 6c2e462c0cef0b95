"""Limits identified from simulated logs whose truth is hidden: how often it lies inside the stated interval, how wide
that is, and how far the estimate of another program is off with what was identified.

python benchmarks/bench_identify.py [--runs 100] [--first 1000] [--jobs N] [--cycles 100] [--keep FILE]

Every run is another robot (half of them with limited jerk), another recorder and another program. The numbers of
trajopt_cli/measured were settled on runs from 9000 on; those from 1000 on are for the table of docs/estimate.md.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import pickle
import sys
from multiprocessing import Pool
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

ROOT = Path(__file__).parents[1]
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
    print("\nestimate of another program, identified limits in its cell file, against the simulated cycle")
    print(f"{'period':>8}{'runs':>6}{'within 1 %':>12}{'median':>10}{'worst':>10}  robot")
    kinds = (
        ("trapezoids", lambda one: None if one.jerk else one.cycle),
        ("jerk, all limits of the axes driven shown", lambda one: one.cycle if one.jerk else None),
        ("jerk, that of some axes driven not shown", lambda one: one.guessed),
    )
    for law, of in kinds:
        for period in (*PERIODS, None):
            found = [of(one) for one in outcomes if period in (None, one.period)]
            off = np.abs([one for one in found if one is not None])
            if len(off):
                name = "all" if period is None else f"{1e3 * period:.0f} ms"
                sizes = f"{100 * np.median(off):>8.2f} %{100 * off.max():>8.2f} %"
                print(f"{name:>8}{len(off):>6}{np.sum(off < 0.01):>12}{sizes}  {law}")


def told(seed: int, one: Outcome) -> None:
    name = f"run {seed}, {1e3 * one.period:.0f} ms, {'jerk' if one.jerk else 'trapezoids'}"
    for limit in one.limits:
        if limit.inside is False:
            off = f"off by {100 * limit.error:+.2f} %, stated within {100 * limit.half:.2f} %"
            print(f"{name}: {limit.axis} {limit.kind} {off}", flush=True)
    if one.cycle is not None and abs(one.cycle) > 0.01:
        print(f"{name}: cycle off by {100 * one.cycle:+.2f} %", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--first", type=int, default=1000)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--cycles", type=int, default=100, help="runs, from the first, whose cycles are estimated too")
    parser.add_argument("--keep", type=Path, help="a file that holds what was run, and from which to go on")
    options = parser.parse_args()
    kept: dict[int, Outcome] = {}
    if options.keep and options.keep.exists():
        kept = pickle.loads(options.keep.read_bytes())
    seeds = [seed for seed in range(options.first, options.first + options.runs) if seed not in kept]
    with TemporaryDirectory() as folder, Pool(options.jobs) as pool:
        tasks = [(seed, Path(folder, str(seed)) if seed < options.first + options.cycles else None) for seed in seeds]
        for seed, one in pool.imap_unordered(_run, tasks):
            told(seed, one)
            kept[seed] = one
            if options.keep:
                options.keep.write_bytes(pickle.dumps(kept))
    outcomes = [one for _, one in sorted(kept.items())]
    print(f"{len(outcomes)} runs")
    table(outcomes)
    if any(one.cycle is not None for one in outcomes):
        cycles(outcomes)


def _run(task: tuple[int, Path | None]) -> tuple[int, Outcome]:
    seed, place = task
    if place is not None:
        place.mkdir()
    return seed, one_run(seed, place)


if __name__ == "__main__":
    main()
