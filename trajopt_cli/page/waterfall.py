"""A waterfall of seconds as a list of bars: what a cycle takes, what each step saves, what is left, and the bound."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from trajopt_cli.page.encode import text
from trajopt_cli.table import signed

_LEFT = 0.97  # of the drawing's width that the longest bar takes
_MOST = 9  # bars of motions
_SEEN = 5e-4  # s: less is printed as 0.000


@dataclass(frozen=True)
class Bar:
    """seconds: of a total its length; of a step what it saves, less than 0 where it costs. detail: in small print."""

    name: str
    seconds: float
    total: bool = False
    detail: str = ""
    cycle: str = ""


def by_motion(saved: Iterable[tuple[str, str, float]], before: float, after: float) -> list[Bar]:
    """Bars from before to after [s] by motion. saved: name, place and seconds of each; several passes of one line are
    one. Those that save or cost most have a bar of their own, the rest one together, so that the bars add up."""
    groups: dict[tuple[str, str], list[float]] = {}
    for name, place, seconds in saved:
        groups.setdefault((name, place), []).append(seconds)
    bars = [
        Bar(name, sum(passes), detail=place if len(passes) == 1 else f"{place}, {len(passes)} times")
        for (name, place), passes in groups.items()
    ]
    bars.sort(key=lambda bar: -abs(bar.seconds))
    shown = [bar for bar in bars[: _MOST - 1] if abs(bar.seconds) >= _SEEN]
    rest = bars[len(shown) :]
    if len(rest) == 1 and abs(rest[0].seconds) >= _SEEN:
        shown, rest = bars, []
    shown.sort(key=lambda bar: -bar.seconds)
    left = before - after - sum(bar.seconds for bar in shown)
    if abs(left) >= _SEEN:
        count = f"{len(rest)} other {'lines' if len(rest) > 1 else 'line'}" if rest else "not in any motion"
        shown.append(Bar(count, left))
    return shown


def waterfall(start: Bar, steps: Sequence[Bar], end: Bar, bound: float | None, label: str) -> str:
    """The bars as HTML, each a row of name, bar and figure, on one scale from 0 s. bound [s]: a line through all."""
    now, highest = start.seconds, start.seconds
    for step in steps:
        now -= step.seconds
        highest = max(highest, now)
    scale = 100 * _LEFT / max(highest, end.seconds, 1e-9)
    rows, now = [_row(start, 0.0, start.seconds, scale, bound)], start.seconds
    for step in steps:
        rows.append(_row(step, min(now, now - step.seconds), abs(step.seconds), scale, bound))
        now -= step.seconds
    rows.append(_row(end, 0.0, end.seconds, scale, bound))
    return f'<ol class="waterfall" aria-label="{text(label)}">{"".join(rows)}</ol>'


def _row(bar: Bar, left: float, length: float, scale: float, bound: float | None) -> str:
    kind = f"total {bar.cycle}".strip() if bar.total else "saves" if bar.seconds >= 0 else "costs"
    line = "" if bound is None else f'<path class="bound" d="M{bound * scale:.3f} 0V10"/>'
    figure = f"{bar.seconds:.3f} s" if bar.total else f"{signed(-bar.seconds)} s"
    detail = f'<span class="small">{text(bar.detail)}</span>' if bar.detail else ""
    return (
        f'<li class="{kind}"><span class="name"><span title="{text(bar.name)}">{text(bar.name)}</span>{detail}</span>'
        f'<svg viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true"><rect x="{left * scale:.3f}" y="1.2" '
        f'width="{max(length * scale, 0.15):.3f}" height="7.6"/>{line}</svg><span class="figure">{figure}</span></li>\n'
    )
