"""Cycle times as bars: where a saving comes from, and how baselines compare."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from trajopt_cli.report.style import BLACK, BLUE, GREY, SMALL, TEXT, VERMILLION, files, house_style, new_figure, settle

_LIGHT = "#c9dcea"  # of an illegal row, under its hatching


def savings(steps: Sequence[tuple[str, float]], title: str) -> dict[str, bytes]:
    """Waterfall of the cycle time by cause, as savings.svg and savings.png.

    steps: (label, cycle time [s]) in order; the first is the start, each later one the cycle once its cause is added.
    Raises ValueError for fewer than two steps.
    """
    with house_style():
        return files("savings", savings_figure(steps, title), title)


def comparison(rows: Sequence[tuple[str, float, bool]], title: str) -> dict[str, bytes]:
    """Bars of cycle times, as comparison.svg and comparison.png. rows: (name, seconds, legal), drawn in this order.

    A row that breaks a limit is hatched and says so. Raises ValueError without rows.
    """
    with house_style():
        return files("comparison", comparison_figure(rows, title), title)


def savings_figure(steps: Sequence[tuple[str, float]], title: str) -> Figure:
    """The figure of savings; call it in house_style."""
    if len(steps) < 2:
        raise ValueError(f"savings needs a start and at least one step, not {len(steps)} steps")
    first, last = steps[0][1], steps[-1][1]
    figure = new_figure(1.9 + 0.52 * (len(steps) + 1), title, _outcome(first, last))
    axes = figure.subplots()
    longest = max(seconds for _, seconds in steps)
    _bar(axes, 0, 0.0, first, GREY, f"{first:.3f} s")
    for row, ((_, before), (_, after)) in enumerate(pairwise(steps), start=1):
        change = after - before
        color = BLUE if change <= 0 else VERMILLION
        _bar(axes, row, min(before, after), abs(change), color, f"{_signed(change)} s", max(before, after))
        axes.plot([before, before], [row - 1 + 0.32, row + 0.32], color=GREY, linewidth=0.9)
    rows = len(steps)
    axes.plot([last, last], [rows - 1 + 0.32, rows + 0.32], color=GREY, linewidth=0.9)
    _bar(axes, rows, 0.0, last, BLACK, f"{last:.3f} s")
    labels = [steps[0][0], *(label for label, _ in steps[1:]), "all together"]
    _finish(axes, labels, longest)
    handles = [Patch(color=BLUE, label="saves time")]
    if any(b[1] > a[1] for a, b in pairwise(steps)):
        handles.append(Patch(color=VERMILLION, label="costs time"))
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    settle(figure)
    return figure


def comparison_figure(rows: Sequence[tuple[str, float, bool]], title: str) -> Figure:
    """The figure of comparison; call it in house_style."""
    if not rows:
        raise ValueError("comparison needs at least one row")
    figure = new_figure(1.7 + 0.52 * len(rows), title)
    axes = figure.subplots()
    quickest = min((seconds for _, seconds, legal in rows if legal), default=None)
    for row, (_, seconds, legal) in enumerate(rows):
        label = f"{seconds:.3f} s" if legal else f"{seconds:.3f} s, breaks a limit"
        color = GREY if not legal else BLUE if seconds == quickest else "#8fb3cc"
        _bar(axes, row, 0.0, seconds, color, label, legal=legal)
    _finish(axes, [name for name, _, _ in rows], max(seconds for _, seconds, _ in rows))
    handles = [Patch(color=BLUE, label="legal, quickest"), Patch(color="#8fb3cc", label="legal")]
    if not all(legal for _, _, legal in rows):
        handles.append(Patch(facecolor="white", edgecolor=GREY, hatch="///", label="breaks a limit"))
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
    settle(figure)
    return figure


def _bar(
    axes: Axes, row: int, start: float, length: float, color: str, label: str, end: float | None = None,
    legal: bool = True,
) -> None:  # fmt: skip
    if legal:
        axes.barh(row, length, 0.64, left=start, color=color)
    else:
        axes.barh(row, length, 0.64, left=start, facecolor="white", edgecolor=color, hatch="///")
    axes.annotate(
        label, (start + length if end is None else end, row), (5, 0), textcoords="offset points", va="center", size=TEXT
    )


def _finish(axes: Axes, labels: Sequence[str], longest: float) -> None:
    axes.set_yticks(range(len(labels)), labels, size=TEXT)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(labels) - 0.5, -0.5)
    axes.set_xlim(0, 1.3 * longest)
    axes.set_xticks([tick for tick in axes.get_xticks() if tick <= 1.05 * longest])
    axes.set_xlabel("cycle time [s]")
    axes.spines["left"].set_visible(False)
    axes.tick_params(axis="x", labelsize=SMALL)


def _signed(seconds: float) -> str:
    return f"{seconds:+.3f}".replace("-", "−")


def _outcome(first: float, last: float) -> str:
    saved = first - last
    word = "saved" if saved >= 0 else "lost"
    return f"{first:.3f} s → {last:.3f} s: {abs(saved):.3f} s {word}, {100 * abs(saved) / first:.1f} % of the start"
