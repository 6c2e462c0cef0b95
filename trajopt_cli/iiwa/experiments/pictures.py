"""The experiments as pictures: the figures of chapter 6."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from trajopt_cli.iiwa.experiments.catalogue import Experiments
from trajopt_cli.iiwa.experiments.collision import NORMAL, Collision
from trajopt_cli.iiwa.experiments.feed_scheduling import Dosing
from trajopt_cli.iiwa.experiments.following import FollowTable
from trajopt_cli.iiwa.experiments.force_error import ForceErrors
from trajopt_cli.iiwa.experiments.guiding import Guided, Zeroed
from trajopt_cli.iiwa.experiments.loop_time import LoopTimes
from trajopt_cli.iiwa.experiments.setup import FORCE, MOMENT, Series
from trajopt_cli.iiwa.experiments.stability import StabilityMap
from trajopt_cli.iiwa.experiments.steps import Steps
from trajopt_cli.workers import in_turns

if TYPE_CHECKING:
    from trajopt_cli.iiwa.report.runs import Following

# What of the stability map is named in its picture: (section, k, d).
_NAMED = (("6.1.6", 0.0, 100.0), ("6.1.2", 500.0, 50.0), ("6.2.2", 2000.0, 500.0), ("6.2.3", 1000.0, 2000.0))
_SYMBOLS = {"v": "speed v", "k": "stiffness k", "d": "damping d"}


def pictures(experiments: Experiments) -> dict[str, bytes]:
    """File name -> contents of every picture; the same numbers give the same bytes, but for loop_time's."""
    one = experiments
    drawn: dict[str, Callable[[], dict[str, bytes]]] = {
        "force_stiffness": partial(_steps, one.force_stiffness, (0, 1, 2), "force_stiffness"),
        "force_damping": partial(_steps, one.force_damping, (0, 1, 2), "force_damping"),
        "orientation": partial(_steps, one.orientation, (3, 4, 5), "orientation"),
        "all_axes": partial(_steps, one.all_axes, tuple(range(6)), "all_axes"),
        "force_error": partial(_force_error, one.force_error),
        "guiding": partial(_guiding, one.guiding),
        "zeroing": partial(_zeroing, one.zeroing),
        "stability": partial(_stability, one.stability),
        "speed": partial(_following, one.speed),
        "stiffness": partial(_following, one.stiffness),
        "damping": partial(_following, one.damping),
        "collision": partial(_collision, one.collision),
        "loop_time": partial(_loop_time, one.loop_time),
        "dosing": partial(_dosing, one.dosing),
    }
    answers = in_turns({name: partial(_told, draw) for name, draw in drawn.items()}, lambda _: None)
    return {name: content for files in answers.values() for name, content in files.items()}


def _told(draw: Callable[[], dict[str, bytes]], tell: Callable[[str], None]) -> dict[str, bytes]:
    return draw()


def _shown(series: Series, label: str | None = None) -> Following:
    from trajopt_cli.iiwa.report.pictures import Following

    return Following(label or series.label, series.t, series.x_e, series.x, series.force, series.flange)


def _steps(steps: Steps, coordinates: tuple[int, ...], name: str) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    panels = [(run.label, _shown(run.series, run.label)) for run in steps.runs]
    out = compliance.steps(panels, coordinates, name, f"{steps.section} {steps.title}")
    rotating = {"alpha", "beta", "gamma"}
    ways = (
        (False, f"distance, ours under at most {FORCE:g} N", "mm"),
        (True, f"angle, ours under at most {MOMENT:g} Nm", "deg"),
    )
    for turning, what, unit in ways:
        rows = [
            (f"{one.axis}, {run.label}" if len(steps.runs) > 1 else one.axis, one.thesis_maximum, one.maximum)
            for run in steps.runs
            for one in run.tracking
            if (one.axis in rotating) is turning
        ]
        if rows:
            title = f"{steps.section} {steps.title}: the flange behind the controller"
            out |= compliance.table_bars(rows, f"largest {what}", unit, f"{name}_flange_{what.split(',')[0]}", title)
    return out


def _following(table: FollowTable) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    path = "the edges of the cube" if table.drawn == "edges" else "one space diagonal of the cube"
    title = f"{table.section} {table.title}: {path}"
    parameter = f"{_SYMBOLS[table.varied]} [{table.unit}]"
    runs = [_shown(series, f"{case.value:g}") for case, series in zip(table.cases, table.runs, strict=True)]
    rows = [(f"{case.value:g} {table.unit}", case.thesis, getattr(case, table.drawn)) for case in table.cases]
    return compliance.family(runs, parameter, table.title, title) | compliance.table_bars(
        rows, "largest deviation", "mm", f"{table.title}_table", title
    )


def _force_error(errors: ForceErrors) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    rows = [(f"along {one.axis}", one.thesis_median, one.median) for one in errors.rows]
    title = f"{errors.section} error of the measured force"
    names = (f"thesis, median of its {len(errors.columns)} runs", f"ours, median of {errors.sensors} sensors")
    return compliance.table_bars(rows, "largest error of a run", "N", "force_error", title, names)


def _guiding(guided: Guided) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    phases = [(f"pushed along {lead.axis}", lead.start, lead.rest) for lead in guided.leads]
    return compliance.guided(_shown(guided.series), phases, "guiding", f"{guided.section} {guided.title}")


def _zeroing(zeroed: Zeroed) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    series = zeroed.series
    assert series.felt is not None
    assert series.force is not None
    title = f"{zeroed.section} {zeroed.title}"
    return compliance.zeroing(_shown(series), series.felt, series.force, zeroed.axis, title)


def _stability(found: StabilityMap) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    points = [
        (f"{one.section}: k = {one.k:g}, d = {one.d:g}", one.k, one.d)
        for one in found.settings
        if (one.section, one.k, one.d) in _NAMED
    ]
    title = f"{found.section} {found.title}"
    return compliance.stability(found.k, found.d, found.verdicts, found.m, found.h, points, title)


def _collision(collision: Collision) -> dict[str, bytes]:
    """A picture per world, named after its number where there are several."""
    from trajopt_cli.iiwa.report import pictures as compliance

    out: dict[str, bytes] = {}
    for i, run in enumerate(collision.runs):
        title = f"{collision.section} {collision.title}: {run.world}"
        drawn: Mapping[str, bytes] = compliance.contact(_shown(run.series), run.depth, NORMAL, title)
        tail = "" if i == 0 else "_physics"
        out |= {name.replace("contact", f"collision{tail}", 1): content for name, content in drawn.items()}
    return out


def _loop_time(times: LoopTimes) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    parts = [(part.name, part.least, part.mean, part.most) for part in times.parts]
    return compliance.loop_time(parts, times.thesis_worst, f"{times.section} {times.title}, {times.language}")


def _dosing(dosing: Dosing) -> dict[str, bytes]:
    from trajopt_cli.iiwa.report import pictures as compliance

    undosed, *others = (_shown(series) for series in dosing.series)
    return compliance.dosing(undosed, others, dosing.bound, f"{dosing.title[:1].upper()}{dosing.title[1:]}")
