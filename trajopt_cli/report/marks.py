"""What all pictures over time share: the program's stops and waits behind the curves."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from matplotlib.axes import Axes
from matplotlib.patches import Patch

from trajopt_cli.motion import Wait
from trajopt_cli.report.course import Course
from trajopt_cli.report.style import PALE

WAIT = Patch(color=PALE, linewidth=0, label="wait")


def mark_motions(course: Course, panels: Iterable[Axes]) -> None:
    """Light vertical lines where a move ends, bands where the program waits, the time axis from 0 to the end."""
    waits = [(leg.t_0, leg.t_1 - leg.t_0) for leg in course.legs if isinstance(leg.motion, Wait)]
    mark_times(panels, float(course.t[-1]), [leg.t_1 for leg in course.moves], waits, WAIT)


def mark_times(
    panels: Iterable[Axes], end: float, stops: Sequence[float], spans: Sequence[tuple[float, float]], band: Patch
) -> None:
    """Light vertical lines at stops [s], bands of band's look over spans (start, length) [s], time from 0 to end."""
    for axes in panels:
        axes.set_xlim(0, end)
        axes.set_axisbelow(True)
        whole_height = axes.get_xaxis_transform()
        inner = [stop for stop in stops if stop < end]
        axes.vlines(inner, 0, 1, transform=whole_height, color="#c4c4c4", linewidth=0.9, zorder=0.6)
        axes.broken_barh(
            spans, (0, 1), transform=whole_height, facecolor=band.get_facecolor(), linewidth=0, zorder=0.5, gid="band"
        )
