"""What push buys: the least time of every feed by the lead that is allowed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from trajopt_cli.iiwa.report.runs import number_of
from trajopt_cli.report.over_time import legend
from trajopt_cli.report.style import AXIS_STYLES, BLACK, GREY, new_figure, settle

_PLAIN = FuncFormatter(lambda value, _: f"{value:g}")


def front_figure(
    leads: Sequence[float],
    curves: Mapping[str, Sequence[float | None]],
    chosen: tuple[float, float],
    unit: tuple[float, str],
    programmed: float,
    title: str,
) -> Figure:
    """Least times [s] by leads (n,), a curve per feed, None where there is none. chosen: lead and time that were taken.

    unit: SI per shown unit of the leads and its sign. programmed [s]: as long as the path takes at its own speed.
    """
    if not leads or any(len(times) != len(leads) for times in curves.values()):
        raise ValueError(f"front: {len(leads)} leads and curves of {sorted(len(times) for times in curves.values())}")
    pushes = unit[1] == "N"
    below = (
        "how hard the tool may begin to push if it is held" if pushes else "how far the equilibrium may lead the arm"
    )
    figure = new_figure(6.4, title, f"least time by {below}")
    axes = figure.subplots()
    x = np.asarray(leads) / unit[0]
    for (label, times), (color, line) in zip(curves.items(), AXIS_STYLES, strict=False):
        y = np.array([np.nan if s is None else s for s in times])
        axes.plot(x, y, color=color, linestyle=line, linewidth=2.0, marker="o", markersize=5, label=label)
    axes.axhline(programmed, color=GREY, linewidth=1.4, linestyle=(0, (1, 1.5)), label="programmed time")
    place: dict[str, Any] = {"markersize": 13, "markerfacecolor": "none", "markeredgewidth": 1.6}
    axes.plot(chosen[0] / unit[0], chosen[1], "o", color=BLACK, label=f"taken: {number_of(chosen[1])} s", **place)
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(_PLAIN)
        axis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(f"{'push' if pushes else 'lead'} at most [{unit[1]}]")
    axes.set_ylabel("least time [s]")
    legend(figure, [entry for entry in axes.get_legend_handles_labels()[0] if isinstance(entry, Line2D)])
    settle(figure)
    return figure
