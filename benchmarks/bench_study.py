"""What a study costs besides its points: overhead a point, memory, and where one scheduler ends.

python benchmarks/bench_study.py [--points 10000] [--minutes 5] [--slots 64]

1. Points that give a stored row at once, on two processes: processor time of all processes a point, memory of this one.
2. Points of hinge_cell at first-legal effort, two processes, for some minutes: what a point takes, and the overhead.
3. Threads that sleep as long as a point takes, in place of as many workers: share of the time that they sleep, and
   what the scheduler and this process take a task.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import tempfile
import time
from dataclasses import replace
from functools import partial
from pathlib import Path
from time import perf_counter, process_time

import dask
import psutil
from distributed import Client, LocalCluster

from trajopt_cli.parameter_study import cluster
from trajopt_cli.parameter_study.cluster import Pool, local_client
from trajopt_cli.parameter_study.point import PointInputs, Row, blank
from trajopt_cli.parameter_study.run import run_study
from trajopt_cli.parameter_study.sampling import Point
from trajopt_cli.parameter_study.study_file import Study, read_study

ROOT = Path(__file__).parents[1]
STUDY = """programs: [{root}/programs/hinge_cell.mod]
cell: {root}/programs/hinge_cell.yaml
vary:
  limits.rail.velocity: {{uniform: [0.8, 2.0]}}
  limits.rail.acceleration: {{uniform: [2, 6]}}
  limits.joint_1.acceleration: {{scale: 20 %}}
  place.rail.height: {{uniform: [-100 mm, 100 mm]}}
sampling: {{latin_hypercube: {count}, seed: 1}}
answers: [as_written, rapid]
"""


def stored(inputs: PointInputs, point: Point) -> Row:
    """A row at once."""
    return {**blank(inputs, point, "ok", ""), "as_written_s": 8.8, "rapid_s": 7.0 + 1e-4 * point.index, "saved_s": 1.8}


def asleep(seconds: float, inputs: PointInputs, point: Point) -> Row:
    """The same after a sleep: a worker of another computer."""
    time.sleep(seconds)
    return stored(inputs, point)


def study_of(count: int, folder: Path) -> Study:
    path = folder / "bench.yaml"
    path.write_text(STUDY.format(root=ROOT, count=count))
    return read_study(path)


def processor() -> float:
    """Processor time of this process and its children [s]."""
    every = [psutil.Process(), *psutil.Process().children(recursive=True)]
    return sum(sum(one.cpu_times()[:2]) for one in every)


def overhead(count: int, folder: Path) -> None:
    study, seen = study_of(count, folder), []
    with local_client(2) as client:
        small = replace(study, design=replace(study.design, count=20))
        run_study(small, folder / "warm", client, work=stored)
        start, own, wall = processor(), process_time(), perf_counter()

        def look(*_: object) -> None:
            seen.append(psutil.Process().memory_info().rss / 1e6)

        run_study(study, folder / "stored", client, look, stored)
        spent, own, wall = processor() - start, process_time() - own, perf_counter() - wall
    size = (folder / "stored" / "points.parquet").stat().st_size
    print(
        f"1. {count} stored rows: {1e3 * spent / count:.2f} ms a point of processor in all processes, "
        f"{1e3 * own / count:.2f} ms of them here with the scheduler; {1e3 * wall / count:.2f} ms by the clock"
    )
    third = len(seen) // 3
    print(
        f"   memory here: {seen[third]:.0f} MB after a third, {seen[-1]:.0f} MB at the end; {size / count:.0f} B a row"
    )


def true_points(minutes: float, folder: Path) -> float:
    study = study_of(100_000, folder)
    with local_client(2) as client:
        for _ in Pool(client, study.inputs).done(map(study.design.point, range(6))):
            pass  # the first points load libraries
        idle = processor()
        time.sleep(10)
        idle = (processor() - idle) / 10
        until, start, own = perf_counter() + 60 * minutes, processor(), process_time()
        left = (study.design.point(i) for i in range(6, 100_000) if perf_counter() < until)
        seconds: list[float] = []
        memory = []
        for done in Pool(client, study.inputs).done(left):
            seconds += [took for _, took, _ in done.timings]
            memory.append(sum(p.memory_info().rss for p in psutil.Process().children(recursive=True)) / 1e6)
        spent, own = processor() - start, process_time() - own
    rows, each = len(seconds), sum(seconds) / len(seconds)
    print(
        f"2. {rows} points of hinge_cell in {minutes:g} min: {each:.4f} s of processor a point in the planner, "
        f"{1e3 * (spent / rows - each):.1f} ms beside it in all processes, {1e3 * own / rows:.1f} of them here;\n"
        f"   an idle cluster takes {100 * idle:.1f} % of a core: {1e3 * idle * 60 * minutes / rows:.1f} ms a point"
    )
    third = len(memory) // 3
    print(f"   memory of the workers: {memory[third]:.0f} MB after a third, {memory[-1]:.0f} MB at the end; ", end="")
    print(f"load average {os.getloadavg()[0]:.1f}")
    return each


def simulated(slots: int, each: float, folder: Path) -> None:
    print(f"3. {slots} simulated workers")
    with (
        dask.config.set({"distributed.worker.memory.target": False}),
        LocalCluster(n_workers=slots // 8, threads_per_worker=8, processes=False, dashboard_address=":0") as local,
        Client(local, set_as_default=False) as client,
    ):
        for seconds, most in ((each, None), (each / 10, None), (each / 100, None), (each / 10, 1), (each / 100, 1)):
            count = max(slots * 4, min(20_000, int(slots * 12 / seconds)))
            study = study_of(count, folder)
            cluster.MOST_POINTS = most or 500
            own, wall, tasks = process_time(), perf_counter(), 0
            for _ in Pool(client, study.inputs, partial(asleep, seconds)).done(map(study.design.point, range(count))):
                tasks += 1
            own, wall = process_time() - own, perf_counter() - wall
            print(
                f"   points of {1e3 * seconds:7.1f} ms, {count / tasks:5.1f} a task: {count / wall:7.0f} points/s, "
                f"{count * seconds / wall / slots:5.1%} of the time; {1e3 * own / tasks:5.2f} ms a task here"
            )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=10_000)
    parser.add_argument("--minutes", type=float, default=5.0)
    parser.add_argument("--slots", type=int, default=64)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        overhead(options.points, folder)
        each = true_points(options.minutes, folder)
        simulated(options.slots, each, folder)


if __name__ == "__main__":
    main()
