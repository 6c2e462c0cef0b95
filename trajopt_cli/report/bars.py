"""Bars: where a saving comes from, how baselines compare, and what each lever of a cell saves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from trajopt_cli.report import style
from trajopt_cli.report.over_time import legend

_LEGAL = "#8fb3cc"
MOST = 16
"""Levers in one picture."""


@dataclass(frozen=True)
class Bar:
    """A row of a comparison: its name, what it is, its cycle [s], whether it is legal, and the time no legal motion on
    its target beats [s], None where none was asked for."""

    name: str
    what: str
    seconds: float
    legal: bool
    bound: float | None = None


def savings(steps: Sequence[tuple[str, float]], title: str) -> dict[str, bytes]:
    """Waterfall of the cycle time by cause, as savings.svg and savings.png.

    steps: (label, cycle time [s]) in order; the first is the start, each later one the cycle once its cause is added.
    Raises ValueError for fewer than two steps.
    """
    with style.house_style():
        return style.files("savings", savings_figure(steps, title), title)


def comparison(rows: Sequence[Bar], title: str) -> dict[str, bytes]:
    """Bars of cycle times, as comparison.svg and comparison.png, in the order of rows.

    Savings count for legal rows, against the first of them. A row that breaks a limit is hatched and says so. Raises
    ValueError without rows.
    """
    with style.house_style():
        return style.files("comparison", comparison_figure(rows, title), title)


def savings_figure(steps: Sequence[tuple[str, float]], title: str) -> Figure:
    """The figure of savings; call it in house_style."""
    if len(steps) < 2:
        raise ValueError(f"savings needs a start and at least one step, not {len(steps)} steps")
    first, last = steps[0][1], steps[-1][1]
    told = f"{abs(first - last):.3f} s {'saved' if first >= last else 'lost'}, {100 * abs(first - last) / first:.1f} %"
    outcome = f"{first:.3f} s → {last:.3f} s: {told}"
    heading = "Saving by cause, for a machine that follows joint positions"
    figure = style.new_figure(1.9 + 0.52 * (len(steps) + 1), heading, f"{title} · {outcome}")
    axes = figure.subplots()
    longest = max(seconds for _, seconds in steps)
    _bar(axes, 0, 0.0, first, style.GREY, f"{first:.3f} s")
    for row, ((_, before), (_, after)) in enumerate(pairwise(steps), start=1):
        change = after - before
        color = style.BLUE if change <= 0 else style.VERMILLION
        told = f"{_signed(change)} s" if f"{change:.3f}" not in ("0.000", "-0.000") else "nothing"
        _bar(axes, row, min(before, after), abs(change), color, told, max(before, after))
        axes.plot([before, before], [row - 1 + 0.32, row + 0.32], color=style.GREY, linewidth=0.9)
    rows = len(steps)
    axes.plot([last, last], [rows - 1 + 0.32, rows + 0.32], color=style.GREY, linewidth=0.9)
    _bar(axes, rows, 0.0, last, style.BLACK, f"{last:.3f} s")
    labels = [steps[0][0], *(label for label, _ in steps[1:]), "all together"]
    _finish(axes, labels, longest)
    handles = [Patch(color=style.BLUE, label="saves time")]
    if any(b[1] > a[1] for a, b in pairwise(steps)):
        handles.append(Patch(color=style.VERMILLION, label="costs time"))
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    style.settle(figure)
    return figure


def comparison_figure(rows: Sequence[Bar], title: str) -> Figure:
    """The figure of comparison; call it in house_style."""
    if not rows:
        raise ValueError("comparison needs at least one row")
    legal = [row for row in rows if row.legal]
    reference = legal[0] if legal else None
    below = "no row is legal: nothing to count savings against"
    if reference is not None:
        below = f"{title} · savings count against {reference.name}, the first legal row"
    figure = style.new_figure(1.9 + 0.72 * len(rows), "Cycle times", below)
    axes = figure.subplots()
    quickest = min((row.seconds for row in legal), default=None)
    if reference is not None:
        axes.axvline(reference.seconds, **style.LIMIT, zorder=0.5, gid="reference")  # type: ignore[arg-type]
    for place, row in enumerate(rows):
        color = style.GREY if not row.legal else style.BLUE if row.seconds == quickest else _LEGAL
        at = place + 0.18
        end = row.seconds if row.bound is None else max(row.seconds, row.bound)
        _bar(axes, at, 0.0, row.seconds, color, _saving(row, reference), end, legal=row.legal, height=0.42)
        if row.bound is not None:
            axes.plot([row.bound] * 2, [at - 0.26, at + 0.26], color=style.BLACK, linewidth=2.6, gid="bound")
        axes.annotate(
            row.what, (0, place - 0.2), (2, 0), textcoords="offset points", va="center", size=style.LEAST,
            color=style.GREY, bbox={"facecolor": "white", "edgecolor": "none", "pad": 1},
        )  # fmt: skip
    _finish(axes, [row.name for row in rows], max(row.seconds for row in rows), below=0.18)
    handles: list[Line2D | Patch] = [
        Patch(color=style.BLUE, label="legal, fastest"),
        Patch(color=_LEGAL, label="legal"),
    ]
    if len(legal) < len(rows):
        handles.append(Patch(facecolor="white", edgecolor=style.GREY, hatch="///", label="breaks a limit"))
    if any(row.bound is not None for row in rows):
        told = "lower bound (no legal motion is faster)"
        handles.append(Line2D([], [], color=style.BLACK, linewidth=2.6, label=told))
    if reference is not None:
        handles.append(Line2D([], [], **style.LIMIT, label="reference"))  # type: ignore[arg-type]
    legend(figure, handles)
    style.settle(figure)
    return figure


def _saving(row: Bar, reference: Bar | None) -> str:
    """What stands beside a bar: its seconds, what that saves, how far the bound is below."""
    text = f"{row.seconds:.3f} s"
    if not row.legal or reference is None:
        return f"{text}, breaks a limit"
    if row is reference:
        return f"{text}, reference"
    text += f", {_signed(100 * (row.seconds / reference.seconds - 1), 1)} %"
    return text if row.bound is None else f"{text}, bound {row.bound:.3f} s"


def _bar(
    axes: Axes, row: float, start: float, length: float, color: str, label: str, end: float | None = None,
    legal: bool = True, height: float = 0.64,
) -> None:  # fmt: skip
    if legal:
        axes.barh(row, length, height, left=start, color=color)
    else:
        axes.barh(row, length, height, left=start, facecolor="white", edgecolor=color, hatch="///")
    axes.annotate(
        label, (start + length if end is None else end, row), (6, 0), textcoords="offset points", va="center",
        size=style.TEXT, bbox={"facecolor": "white", "edgecolor": "none", "pad": 1}, zorder=3,
    )  # fmt: skip


def _finish(axes: Axes, labels: Sequence[str], longest: float, below: float = 0.0) -> None:
    axes.set_yticks([row + below for row in range(len(labels))], labels, size=style.TEXT)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(labels) - 0.5, -0.5)
    axes.set_xlim(0, 1.5 * longest)
    axes.set_xticks([tick for tick in axes.get_xticks() if tick <= 1.05 * longest])
    axes.set_xlabel("cycle time [s]")
    axes.spines["left"].set_visible(False)
    axes.tick_params(axis="x", labelsize=style.SMALL)


def _signed(value: float, decimals: int = 3) -> str:
    return f"{value:+.{decimals}f}".replace("-", "−")


def lever_bars(
    bars: Sequence[tuple[str, float, float | None]], cycle: float, title: str, name: str
) -> dict[str, bytes]:
    """sensitivity_NAME.svg and .png. title: program and plan, for people. bars: (lever and step, seconds saved, what
    first order foretold), the longest first; the first MOST of them are drawn. cycle: of the plan [s]."""
    with style.house_style():
        return style.files(f"sensitivity_{name}", levers_figure(bars, cycle, title), title)


def levers_figure(bars: Sequence[tuple[str, float, float | None]], cycle: float, title: str) -> Figure:
    """The figure of lever_bars; call it in house_style."""
    shown = bars[:MOST]
    more = f" (the first {MOST} of {len(bars)})" if len(bars) > MOST else ""
    below = f"{title} · cycle {cycle:.3f} s" if shown else f"{title} · nothing that was asked saves a millisecond"
    figure = style.new_figure(
        1.9 + 0.4 * max(1, len(shown)), f"Seconds that each change saves, one at a time{more}", below
    )
    axes = figure.subplots()
    for row, (_, saved, foretold) in enumerate(shown):
        axes.barh(row, saved, 0.64, color=style.BLUE)
        reached = max(saved, foretold or 0.0)
        if foretold is not None:
            axes.plot([foretold, foretold], [row - 0.32, row + 0.32], color=style.BLACK, linewidth=2.2)
        label = f"{saved:.3f} s, {100 * saved / cycle:.1f} %"
        axes.annotate(label, (reached, row), (6, 0), textcoords="offset points", va="center", size=style.SMALL)
    longest = max((max(saved, foretold or 0.0) for _, saved, foretold in shown), default=1.0)
    axes.set_yticks(range(len(shown)), [label for label, _, _ in shown], size=style.SMALL)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(max(1, len(shown)) - 0.5, -0.5)
    axes.set_xlim(0, 1.5 * longest)
    axes.set_xticks([tick for tick in axes.get_xticks() if tick <= 1.05 * longest])
    axes.set_xlabel("saved [s]")
    axes.spines["left"].set_visible(False)
    handles = [
        Patch(color=style.BLUE, label="solved again with the change"),
        Line2D([], [], color=style.BLACK, linewidth=2.2, label="linear estimate from the plan"),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    style.settle(figure)
    return figure
