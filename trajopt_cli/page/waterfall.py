"""A waterfall of seconds as a list of bars: what a cycle takes, what each step saves, what is left, and the bound."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from trajopt_cli.page.encode import text

_LEFT = 0.97  # of the drawing's width that the longest bar takes


@dataclass(frozen=True)
class Bar:
    """seconds: of a total its length; of a step what it saves, less than 0 where it costs. detail: in small print."""

    name: str
    seconds: float
    total: bool = False
    detail: str = ""
    cycle: str = ""


def by_motion(saved: Sequence[tuple[str, str, float]], before: float, after: float, most: int = 9) -> list[Bar]:
    """Bars from before to after [s] by motion. saved: name, place and seconds of each; those that save or cost most
    have a bar of their own, the rest one together, so that the bars add up."""
    order = sorted(saved, key=lambda one: -abs(one[2]))
    shown, rest = (order, []) if len(order) <= most else (order[: most - 1], order[most - 1 :])
    bars = [Bar(name, seconds, detail=place) for name, place, seconds in sorted(shown, key=lambda one: -one[2])]
    if rest:
        bars.append(Bar(f"{len(rest)} other motions", sum(one[2] for one in rest)))
    if abs(left := before - after - sum(bar.seconds for bar in bars)) > 1e-6:
        bars.append(Bar("not in any motion", left))
    return bars


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


def signed(seconds: float) -> str:
    """What becomes of a cycle time: "−0.851 s" for a saving."""
    figure = f"{-seconds:+.3f}".replace("-", "−")
    return f"{'0.000' if figure[1:] == '0.000' else figure} s"


def _row(bar: Bar, left: float, length: float, scale: float, bound: float | None) -> str:
    kind = f"total {bar.cycle}".strip() if bar.total else "saves" if bar.seconds >= 0 else "costs"
    line = "" if bound is None else f'<path class="bound" d="M{bound * scale:.3f} 0V10"/>'
    figure = f"{bar.seconds:.3f} s" if bar.total else signed(bar.seconds)
    detail = f' <span class="small">{text(bar.detail)}</span>' if bar.detail else ""
    return (
        f'<li class="{kind}"><span class="name">{text(bar.name)}{detail}</span>'
        f'<svg viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true"><rect x="{left * scale:.3f}" y="1.2" '
        f'width="{max(length * scale, 0.15):.3f}" height="7.6"/>{line}</svg><span class="figure">{figure}</span></li>\n'
    )
