"""A study from its points to its results folder: goes on where it was stopped, and tells how far it is."""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.parameter_study.cluster import Evaluate, Pool
from trajopt_cli.parameter_study.point import ANSWERS, Row, evaluate
from trajopt_cli.parameter_study.results import POINTS, StudyFolder, new_or_same
from trajopt_cli.parameter_study.study_file import Study
from trajopt_cli.pipeline.planning import Listener
from trajopt_cli.problem.progress import Progress
from trajopt_cli.runs.files import holding

if TYPE_CHECKING:
    from distributed import Client

MOST_ROWS = 20_000
"""Rows of a part at most."""
_PAUSE, _SHARE = 2.0, 0.01  # s, and share of the time so far, between two parts: a kill loses little, and few parts


@dataclass(eq=False)
class Tally:
    """How far a study is. counts: rows by status. best: the least cycle time [s], and of which point."""

    points: int
    before: int = 0
    counts: Counter[str] = field(default_factory=Counter)
    best: tuple[float, int] | None = None
    start: float = field(default_factory=time.monotonic)

    def add(self, row: Row) -> None:
        """Count a row."""
        self.counts[row["status"]] += 1
        times = (row[f"{name}_s"] for name in ("rapid", "stream", *ANSWERS))
        seconds = next((one for one in times if one is not None), None)
        if seconds is not None and (self.best is None or seconds < self.best[0]):
            self.best = seconds, row["point"]

    @property
    def done(self) -> int:
        """Rows that there are."""
        return self.counts.total()

    @property
    def progress(self) -> Progress:
        """In words: done, rate, time left, failures."""
        rate = (self.done - self.before) / max(time.monotonic() - self.start, 1e-3)
        parts = [f"{self.done} of {self.points} points"]
        if rate > 0:
            parts += [f"{rate:.3g} a second", f"{span((self.points - self.done) / rate)} left"]
        parts += [f"{count} {status}" for status, count in sorted(self.counts.items()) if status != "ok"]
        return Progress(", ".join(parts), None if self.best is None else self.best[0])


def span(seconds: float) -> str:
    """A time in the unit that suits it."""
    for unit, size in (("days", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.0f} s"


def run_study(
    study: Study, folder: Path, client: Client, listen: Listener = lambda *_: None, work: Evaluate = evaluate
) -> tuple[StudyFolder, Tally]:
    """Work out all points of a study that have no row yet, on a Dask client's cluster.

    Args:
        study: what to do.
        folder: of the results; made, or gone on with where it is this study's.
        client: of the cluster; stays open.
        listen: hears how far it is.
        work: makes the row of a point.

    Returns:
        The folder, and what is in it by status.

    Raises InputError where the folder is of something else or of other inputs. Whatever ends it, interruption included,
    what had come back is written before.
    """
    results = new_or_same(folder, study)
    with holding(folder):
        known = results.known()
        tally = Tally(len(study.design), int(known.sum()))
        for row in results.rows().select(["point", "status", *(f"{name}_s" for name in ANSWERS)]).to_pylist():
            tally.add(row)
        pool = Pool(client, study.inputs, work, lambda text: listen("study", Progress(text)))
        if tally.done < tally.points:
            rows, timings, written = list[Row](), list[tuple[int, float, str]](), tally.start
            try:
                for done in pool.done(study.design.point(int(index)) for index in np.flatnonzero(~known)):
                    rows += done.rows
                    timings += done.timings
                    for row in done.rows:
                        tally.add(row)
                    now = time.monotonic()
                    if len(rows) >= MOST_ROWS or now - written >= max(_PAUSE, _SHARE * (now - tally.start)):
                        results.write_part(rows, timings)
                        rows, timings, written = [], [], now
                    listen("study", tally.progress)
            finally:
                if rows:
                    results.write_part(rows, timings)
        if not (folder / POINTS).is_file():
            results.finish()
    return results, tally


def dry_run(study: Study, client: Client, listen: Listener = lambda *_: None) -> str:
    """How many points a study has and, from three of them, how long it takes on a client's cluster, in words."""
    count = len(study.design)
    some = sorted({0, count // 2, count - 1})
    seconds: list[float] = []
    for done in Pool(client, study.inputs).done(map(study.design.point, some)):
        seconds += [took for _, took, _ in done.timings]
        listen("study", Progress(f"{len(seconds)} of {len(some)} points tried"))
    threads = sum(client.nthreads().values())
    each = sum(seconds) / len(seconds)
    whole = span(each * count / max(threads, 1))
    return f"{count} points, {each:.2g} s each (mean of {len(some)}): about {whole} on {threads} workers"
