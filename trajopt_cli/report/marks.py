"""What all pictures over time share: the program's points and waits behind the curves."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from trajopt_cli.motion import Wait
from trajopt_cli.report.style import GREY, PALE
from trajopt_cli.trajectories.plan_series import PlanSeries

WAIT = Patch(color=PALE, linewidth=0, label="wait")
_LINE: dict[str, Any] = {"color": "#c4c4c4", "linewidth": 0.9}
_PASSED: dict[str, Any] = {**_LINE, "linestyle": (0, (1.5, 3))}
PASSED = Line2D([], [], **_PASSED | {"color": GREY}, label="point passed")


def mark_motions(course: PlanSeries, panels: Iterable[Axes]) -> None:
    """Light vertical lines where a move ends, dotted where it does not stop there; bands where the program waits, the
    time axis from 0 to the end."""
    waits = [(leg.t_0, leg.t_1 - leg.t_0) for leg in course.legs if isinstance(leg.motion, Wait)]
    stops, passed = ([leg.t_1 for leg in course.moves if leg.passed == moving] for moving in (False, True))
    mark_times(panels, float(course.t[-1]), stops, waits, WAIT, passed)


def mark_times(
    panels: Iterable[Axes], end: float, stops: Sequence[float], spans: Sequence[tuple[float, float]], band: Patch,
    passed: Sequence[float] = (),
) -> None:  # fmt: skip
    """Light vertical lines at stops [s], dotted ones where points are passed, bands of band's look over spans
    (start, length) [s], time from 0 to end."""
    for axes in panels:
        axes.set_xlim(0, end)
        axes.set_axisbelow(True)
        whole_height = axes.get_xaxis_transform()
        inner = [stop for stop in stops if stop < end]
        axes.vlines(inner, 0, 1, transform=whole_height, **_LINE, zorder=0.6)
        if passed:
            axes.vlines(passed, 0, 1, transform=whole_height, **_PASSED, zorder=0.6, gid="passed")
        axes.broken_barh(
            spans, (0, 1), transform=whole_height, facecolor=band.get_facecolor(), linewidth=0, zorder=0.5, gid="band"
        )
