"""What each lever of a cell saves, as bars."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from trajopt_cli.report.style import BLACK, BLUE, SMALL, files, house_style, new_figure, settle

MOST = 16
"""Bars in one picture."""


def lever_bars(
    bars: Sequence[tuple[str, float, float | None]], cycle: float, title: str, name: str
) -> dict[str, bytes]:
    """sensitivity_NAME.svg and .png. title: program and plan, for people. bars: (lever and step, seconds saved, what
    first order foretold), the longest first; the first MOST of them are drawn. cycle: of the plan [s]."""
    with house_style():
        return files(f"sensitivity_{name}", levers_figure(bars, cycle, title), title)


def levers_figure(bars: Sequence[tuple[str, float, float | None]], cycle: float, title: str) -> Figure:
    """The figure of lever_bars; call it in house_style."""
    shown = bars[:MOST]
    more = f" (the first {MOST} of {len(bars)})" if len(bars) > MOST else ""
    below = f"{title} · cycle {cycle:.3f} s" if shown else f"{title} · nothing that was asked saves a millisecond"
    figure = new_figure(1.9 + 0.4 * max(1, len(shown)), f"Seconds that each change saves, one at a time{more}", below)
    axes = figure.subplots()
    for row, (_, saved, foretold) in enumerate(shown):
        axes.barh(row, saved, 0.64, color=BLUE)
        reached = max(saved, foretold or 0.0)
        if foretold is not None:
            axes.plot([foretold, foretold], [row - 0.32, row + 0.32], color=BLACK, linewidth=2.2)
        label = f"{saved:.3f} s, {100 * saved / cycle:.1f} %"
        axes.annotate(label, (reached, row), (6, 0), textcoords="offset points", va="center", size=SMALL)
    longest = max((max(saved, foretold or 0.0) for _, saved, foretold in shown), default=1.0)
    axes.set_yticks(range(len(shown)), [label for label, _, _ in shown], size=SMALL)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(max(1, len(shown)) - 0.5, -0.5)
    axes.set_xlim(0, 1.5 * longest)
    axes.set_xticks([tick for tick in axes.get_xticks() if tick <= 1.05 * longest])
    axes.set_xlabel("saved [s]")
    axes.spines["left"].set_visible(False)
    handles = [
        Patch(color=BLUE, label="solved again with the change"),
        Line2D([], [], color=BLACK, linewidth=2.2, label="linear estimate from the plan"),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    settle(figure)
    return figure
