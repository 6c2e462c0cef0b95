"""An estimate as a table: a line per motion."""

from __future__ import annotations

from collections.abc import Iterator

from rich.table import Table

from trajopt_cli.cli.layout import place, plain_table
from trajopt_cli.measured.align import Alignment
from trajopt_cli.runs.results import motion_label
from trajopt_cli.study.estimate import Estimate


def estimate_table(answer: Estimate, log: Alignment | None) -> Table:
    """Motions in program order; waits in a column of their own."""
    more = (">measured [s]", ">measured - predicted [s]") if log else ()
    table = plain_table(
        f"{answer.job.title}: as written, driven by its controller under the limits of {answer.job.cell_path}",
        *("place", "instruction", "target", ">length/speed [s]", ">predicted [s]", ">wait [s]", *more, "held back by"),
    )
    measured = {} if log is None else {one.index: one.measured for one in log.motions}
    for one in answer.motions:
        cells = [place(one.source), *motion_label(answer.job.program, one.index)]
        cells += ["", "", f"{one.driven:.3f}"] if one.wait else [f"{one.naive:.3f}", f"{one.driven:.3f}", ""]
        if log:
            known = measured.get(one.index)
            cells += ["", ""] if known is None else [f"{known:.3f}", f"{known - one.driven:+.3f}"]
        table.add_row(*cells, "" if one.wait else one.binding)
    return table


def sums(answer: Estimate, log: Alignment | None) -> Iterator[str]:
    """The cycle, a line each."""
    slower = answer.driven - answer.naive
    yield (
        f"cycle {answer.plan.duration:.3f} s: motions {answer.driven:.3f} s, "
        f"waits {answer.waits:.3f} s (their least time)"
    )
    share = f" ({100 * slower / answer.naive:+.1f} %)" if answer.naive > 0 else ""
    yield f"length over speed {answer.naive:.3f} s; ramps, corners and limits make that {slower:+.3f} s{share}"
    if log:
        off = log.cycle - log.predicted
        yield (
            f"measured {log.cycle:.3f} s from the first move to the end of the last, predicted {log.predicted:.3f} s: "
            f"measured - predicted {off:+.3f} s ({100 * off / log.cycle:+.1f} %); motions {log.motion:.3f} s, "
            f"standing {log.waits:.3f} s"
        )
