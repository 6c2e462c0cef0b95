"""What other routes of branches, turns and rail orders save: python benchmarks/bench_routes.py [--peers 101:141]
                              [--robust 1001:1061] [--worth 0.01] [--parts 10] [--json FILE]

RAPID plans, without their bounds, of the programs of bench_peers.py and bench_robust.py by seed: with the search's best
route alone and with others beside it; which of these, in the order of their estimates, were kept; seconds of processor.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from itertools import count
from pathlib import Path
from time import process_time

import bench_peers
import bench_robust
import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.graph_search import search
from trajopt_cli.job import read_job
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.pipeline.planning import may_change
from trajopt_cli.plan import NoCleanPlan, optimize, other_routes
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.settings import DEFAULT, Settings
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import OtherPart, Route

RANKS: list[
    tuple[int, bool]
] = []  # of every other part that was timed: its rank among its route's, whether it was kept


def programs(peers: str, robust: str) -> Iterator[tuple[str, str, str]]:
    """Name, text and cell of each."""
    for seed in range(*map(int, peers.split(":"))):
        yield (f"peers {seed}", *bench_peers.program(seed)[1:])
    for seed in range(*map(int, robust.split(":"))):
        made = bench_robust._Writer(seed).made()
        yield f"robust {seed}", made.text, made.cell


def planned(module: Path, parts: int) -> tuple[float | None, float]:
    """Cycle time of the RAPID plan [s], None where there is none; seconds of processor."""
    search._OTHER_PARTS = parts
    start = process_time()
    try:
        job = read_job(module)
        changes = may_change(job, Loops.KEEP).changes[Target.RAPID]
        found = optimize(job.program, job.plant, Target.RAPID, bounded=False, changes=changes)
    except (InputError, NoCleanPlan):
        return None, process_time() - start
    return (None if isinstance(found, Infeasible) else found.duration), process_time() - start


def watch() -> None:
    """Note which of the other parts are kept."""
    with_part, whole, ranks = other_routes._with_part, other_routes.with_better_parts, list[Iterator[int]]()

    def noted(axes: Axes, problem: Problem, best: Route, part: OtherPart, known: Times) -> Route:
        found = with_part(axes, problem, best, part, known)
        RANKS.append((next(ranks[-1]), found is not best))
        return found

    def counted(axes: Axes, problem: Problem, route: Route, refined: Route, known: Times) -> Route | None:
        ranks.append(count())
        return whole(axes, problem, route, refined, known)

    other_routes._with_part = noted
    sys.modules["trajopt_cli.plan.initial_plan"].with_better_parts = counted


def main() -> None:
    """Print a line per program and a summary."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peers", default="101:141")
    parser.add_argument("--robust", default="1001:1061")
    parser.add_argument("--worth", type=float, default=DEFAULT.worth)
    parser.add_argument("--parts", type=int, default=search._OTHER_PARTS)
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    Settings.worth = property(lambda _: options.worth)
    watch()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        module = Path(folder) / "cell.mod"
        for name, text, cell in programs(options.peers, options.robust):
            module.write_text(text)
            module.with_suffix(".yaml").write_text(cell)
            (alone, spent), (several, more) = planned(module, 0), planned(module, options.parts)
            if alone is None or several is None:
                print(f"{name:12} no plan", flush=True)
                continue
            rows.append({"name": name, "alone": alone, "several": several, "seconds": [spent, more]})
            gain = 100 * (1 - several / alone)
            print(f"{name:12} {alone:9.4f} s {several:9.4f} s {-gain:+7.3f} % {spent:6.2f} s {more:6.2f} s", flush=True)
            if options.json:
                options.json.write_text(json.dumps({"rows": rows, "ranks": RANKS}))
    gains = np.array([100 * (1 - row["several"] / row["alone"]) for row in rows])
    spent, more = np.sum([row["seconds"] for row in rows], axis=0)
    kept, timed = Counter(rank for rank, one in RANKS if one), Counter(rank for rank, _ in RANKS)
    text = f"{len(rows)} programs: faster on {sum(gains > 1e-3)}, {gains.mean():.3f} % on average, {gains.max():.3f} %"
    print(f"\n{text} at most, slower on {sum(gains < -1e-3)}")
    print(f"{spent:.1f} s of processor with the best route alone, {more:.1f} s with others")
    print("kept of those timed, by rank: " + ", ".join(f"{i + 1}: {kept[i]}/{timed[i]}" for i in sorted(timed)))


if __name__ == "__main__":
    main()
