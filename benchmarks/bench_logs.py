"""Logs of real robots beside what is predicted: python benchmarks/bench_logs.py --logs DIR [--units s,deg] [--fit 5]

DIR holds X.mod, X.yaml and X_log.csv for each X. A line per log: the cycle from the first move's begin to the end of
the last, measured; predicted without settling at stops, and with it (what the cell's robot has); then how long its
axes settle at each stop that is waited for, and the interval of the prediction (OUTSIDE where the cycle is not in
it). The mean settling of the first logs (--fit so many, by name) is held
against the others. Nothing else is fitted: accelerations are the cell's.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.job import read_job
from trajopt_cli.measured.log_csv import read_log
from trajopt_cli.runs.uncertainty import WRITTEN, Ends, between
from trajopt_cli.study.estimate import Estimate, beside, estimate


class Row(NamedTuple):
    """Times of one log [s]; settling: at all stops together, in force, and by the log at each; ends: of the
    prediction's interval."""

    name: str
    measured: float
    predicted: float
    settling: float
    stops: int
    seen: float
    ends: Ends

    @property
    def inside(self) -> bool:
        low, high = (end or np.inf for end in self.ends)
        return bool(low <= self.measured <= high)

    def off(self, settle: float | None) -> float:
        """How much longer the cycle is than predicted, as a share; settle: at each stop, None for what is in force."""
        less = 0.0 if settle is None else self.settling - settle * self.stops
        return (self.measured - self.predicted + less) / self.measured


def row_of(program: Path, units: str) -> Row:
    log = program.with_name(f"{program.stem}_log.csv")
    job = read_job(program, program.with_suffix(".yaml"))
    answer = estimate(job)
    if not isinstance(answer, Estimate):
        raise SystemExit(f"{program}: {answer}")
    motion, _ = read_log(log, job.plant.limits, units, None)
    found = beside(answer, {str(log): motion}, [])
    if found.wrong:
        raise SystemExit(f"{found.wrong[0]}")
    (one,) = found.alignments
    told = answer.settling
    seen = {each.kind: each.seconds for each in found.settling}.get("fine", np.nan)
    stops, seconds = (0, 0.0) if told is None else (told.stops, told.seconds)
    ends = answer.unsure.cycle_time_range_s.get(WRITTEN, (one.predicted, one.predicted))
    return Row(program.stem, one.cycle, one.predicted, seconds, stops, seen, ends)


def told(rows: list[Row], settle: float | None) -> str:
    off = np.abs([row.off(settle) for row in rows])
    return f"mean |error| {100 * off.mean():.2f} %, worst {100 * off.max():.2f} %"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--logs", type=Path, required=True)
    parser.add_argument("--units", default="s,deg", help="of the logs' heads without one")
    parser.add_argument("--fit", type=int, default=5, help="how many logs the settling is fitted on")
    arguments = parser.parse_args()
    programs = [one for one in sorted(arguments.logs.glob("*.mod")) if one.with_suffix(".yaml").exists()]
    rows = [row_of(one, arguments.units) for one in programs if one.with_name(f"{one.stem}_log.csv").exists()]
    first = [row.seen for row in rows[: arguments.fit] if np.isfinite(row.seen)]
    fitted = float(np.mean(first)) if first else 0.0
    heads = ("measured [s]", "without [s]", "error", "with [s]", "error", "seen a stop [s]", "fitted [s]", "error")
    print(f"{'log':28}" + "".join(f"{head:>16}" for head in heads))
    for row in rows:
        bare = row.predicted - row.settling
        cells = [row.measured, bare, row.off(0.0), row.predicted, row.off(None), row.seen]
        cells += [bare + fitted * row.stops, row.off(fitted)]
        texts = [
            f"{100 * cell:+.2f} %" if head == "error" else f"{cell:.3f}"
            for head, cell in zip(heads, cells, strict=True)
        ]
        print(
            f"{row.name:28}" + "".join(f"{one:>16}" for one in texts), between(row.ends), "OUTSIDE" * (not row.inside)
        )
    print(f"all {len(rows)}: without settling {told(rows, 0.0)}; with it {told(rows, None)}")
    print(f"{sum(row.inside for row in rows)} of {len(rows)} cycles in their intervals")
    others = rows[arguments.fit :]
    if others:
        print(f"settling of the first {len(first)}, {fitted:.4f} s a stop: on all {told(rows, fitted)};")
        print(f"    on the other {len(others)} {told(others, fitted)}")


if __name__ == "__main__":
    main()
