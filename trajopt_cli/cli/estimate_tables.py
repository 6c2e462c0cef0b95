"""An estimate as a table: a line per motion."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import PurePath

from trajopt_cli.measured.align import Alignment, settles
from trajopt_cli.runs.summary import SETTLING, motion_label
from trajopt_cli.runs.uncertainty import WRITTEN
from trajopt_cli.study.estimate import Estimate, EstimatedMotion
from trajopt_cli.table import TextTable, place, seconds, signed, tabulate


def estimate_table(answer: Estimate, log: Alignment | None) -> TextTable:
    """Motions in program order; waits in a column of their own."""
    program = answer.job.program
    measured = {} if log is None else {one.index: one.measured for one in log.motions}
    columns: dict[str, Callable[[EstimatedMotion], str]] = {
        "place": lambda one: place(one.source),
        "instruction": lambda one: motion_label(program, one.index)[0],
        "target": lambda one: motion_label(program, one.index)[1],
        ">length/speed [s]": lambda one: "" if one.wait else seconds(one.naive),
        ">predicted [s]": lambda one: "" if one.wait else seconds(one.driven),
        ">wait [s]": lambda one: seconds(one.driven) if one.wait else "",
    }
    if log:
        columns[">measured [s]"] = lambda one: seconds(measured.get(one.index))
        columns[">measured - predicted [s]"] = lambda one: (
            signed(measured[one.index] - one.driven) if one.index in measured else ""
        )
    columns["held back by"] = lambda one: "" if one.wait else one.binding
    title = f"{answer.job.title}: as written, driven by its controller under the limits of {answer.job.cell_path}"
    made = tabulate(title, answer.motions, columns)
    if answer.settling is None:
        return made
    cells = {"place": SETTLING, "target": answer.settling.how, ">wait [s]": seconds(answer.settling.seconds)}
    if log and (seen := [one for one in log.motions if settles(program.motions, one.index)]):
        stood, off = sum(one.measured for one in seen), sum(one.measured - one.predicted for one in seen)
        cells |= {">measured [s]": seconds(stood), ">measured - predicted [s]": signed(off)}
    return replace(made, rows=(*made.rows, tuple(cells.get(head, "") for head in made.heads)), total=True)


def logs_table(answer: Estimate, logs: Sequence[Alignment]) -> TextTable:
    """A line per log."""
    return tabulate(
        f"{answer.job.title}: logs beside the program as written under the limits of {answer.job.cell_path}",
        logs,
        {
            "~log": lambda one: PurePath(one.file).name,
            ">passes": lambda one: str(len(one.counted)) if one.whole else "in part",
            ">measured [s]": lambda one: seconds(one.cycle),
            ">predicted [s]": lambda one: seconds(one.predicted),
            ">measured - predicted [s]": lambda one: signed(one.cycle - one.predicted),
            ">[%]": lambda one: signed(100 * (one.cycle - one.predicted) / one.cycle, 1),
            ">motions [s]": lambda one: seconds(one.motion),
            ">predicted motions [s]": lambda one: seconds(one.predicted_motion),
            ">standing [s]": lambda one: seconds(one.waits),
        },
    )


def sums(answer: Estimate, log: Alignment | None) -> Iterator[str]:
    """The cycle, a line each."""
    slower = answer.driven - answer.naive
    yield (
        f"cycle {answer.plan.duration:.3f} s{answer.unsure.around(WRITTEN)}: motions {answer.driven:.3f} s, "
        f"waits {answer.waits:.3f} s (their least time)"
        f"{'' if answer.settling is None else f', {answer.settling.line}'}"
    )
    share = f" ({100 * slower / answer.naive:+.1f} %)" if answer.naive > 0 else ""
    yield f"length over speed {answer.naive:.3f} s; ramps, corners and limits make that {slower:+.3f} s{share}"
    if log:
        off = log.cycle - log.predicted
        what = "from the first move to the end of the last" if log.whole else "of the motions that the log holds"
        told = f"measured - predicted {off:+.3f} s ({100 * off / log.cycle:+.1f} %)"
        yield f"measured {log.cycle:.3f} s {what}, predicted {log.predicted:.3f} s: {told}"
