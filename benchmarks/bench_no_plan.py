"""Programs nobody tuned for that have a plan and get none: python benchmarks/bench_no_plan.py [--seeds 1000:1060]

The programs of bench_robust.py, both targets, no time for a faster plan than the first legal one. Where optimize has
none, a slow plan that stops at every point is looked for and judged: where that is legal, "optimize alone" had no plan
though one exists. Gap (of the first legal plan) and its time by the search's estimate say what is suspicious. Prints a
line for every program and target, and the counts.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1]), str(Path(__file__).parent)]  # run from a checkout without installing

from bench_robust import _Writer  # noqa: E402

from trajopt_cli.errors import InputError  # noqa: E402
from trajopt_cli.job import Job, read_job  # noqa: E402
from trajopt_cli.judge.verify import verify  # noqa: E402
from trajopt_cli.pipeline.planning import may_change  # noqa: E402
from trajopt_cli.plan import NoCleanPlan, optimize, slow_plan  # noqa: E402
from trajopt_cli.problem.editable import Changes, Loops  # noqa: E402
from trajopt_cli.problem.plan import Infeasible, Plan, Target  # noqa: E402
from trajopt_cli.problem.stop_condition import Patience  # noqa: E402


def answered(job: Job, target: Target, changes: Changes) -> tuple[str, str]:
    """What comes of one target, in a word, and more about it."""
    try:
        found: Plan | Infeasible | str = optimize(
            job.program, job.plant, target, changes=changes, patience=Patience(0.0)
        )
    except NoCleanPlan as no:
        found = str(no)
    if isinstance(found, Plan):
        times = found.duration / found.estimate if found.estimate else 1.0
        return "plan", f"{found.duration:.3f} s, gap {100 * (found.gap or 0.0):.1f} %, {times:.2f} times the estimate"
    slow = slow_plan(job.program, job.plant, target, changes, str(found))
    if slow is None:
        return "none found", str(found)
    dropped = tuple(motion.index for motion in slow.motions if motion.dropped)
    legal = verify(job.program, job.plant, slow.trajectory, None, dropped, target, advice=False).legal
    return ("optimize alone had none" if legal else "none found"), f"slow plan of {slow.duration:.3f} s; {found}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="1000:1060", help="first and behind the last, or a list with commas")
    options = parser.parse_args()
    first, _, last = options.seeds.partition(":")
    counts = Counter[str]()
    for seed in range(int(first), int(last)) if last else [int(one) for one in first.split(",")]:
        with tempfile.TemporaryDirectory() as place:
            made, module = _Writer(seed).made(), Path(place) / "robust.mod"
            module.write_text(made.text)
            module.with_suffix(".yaml").write_text(made.cell)
            try:
                job = read_job([module], None)
            except InputError as no:
                counts["refused"] += 1
                print(f"{seed} refused: {no}", flush=True)
                continue
            agreed = may_change(job, Loops.KEEP)
            for target in Target:
                word, more = "out of reach", str(agreed.infeasible)
                if agreed.infeasible is None:
                    word, more = answered(job, target, agreed.changes[target])
                counts[word] += 1
                print(f"{seed} {target.value:7} {word}: {more.replace(place, '')}", flush=True)
    print(", ".join(f"{count} {word}" for word, count in counts.most_common()))


if __name__ == "__main__":
    main()
