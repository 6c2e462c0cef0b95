"""The tables of chapter 6: the thesis' numbers beside ours, and what a person should know of each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np
from rich.table import Table

from trajopt_cli.cli.layout import plain_table
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.iiwa.experiments.catalogue import Experiments
    from trajopt_cli.iiwa.experiments.collision import Collision
    from trajopt_cli.iiwa.experiments.feed_scheduling import Dosing
    from trajopt_cli.iiwa.experiments.following import FollowTable
    from trajopt_cli.iiwa.experiments.force_error import ForceErrors
    from trajopt_cli.iiwa.experiments.guiding import Guided, Zeroed
    from trajopt_cli.iiwa.experiments.loop_time import LoopTimes
    from trajopt_cli.iiwa.experiments.setup import Tracking
    from trajopt_cli.iiwa.experiments.stability import StabilityMap
    from trajopt_cli.iiwa.experiments.steps import Steps

_MICRO = 1e-6
_TURNS = ("alpha", "beta", "gamma")


def tables(experiments: Experiments) -> Iterator[Table | str]:
    """Section by section: a table, then its notes."""
    from trajopt_cli.iiwa.experiments.steps import worst_sentences, worst_tracking

    one = experiments
    for steps in one.stepped:
        yield _steps(steps)
        if any(run.tracking for run in steps.runs):
            yield _flange(steps)
        yield from _notes(steps.sentences)
    worst = worst_tracking(one.stepped)
    if worst:
        yield _worst(worst)
        yield from _notes(worst_sentences(one.stepped))
    yield _force_error(one.force_error)
    yield from _notes(one.force_error.sentences)
    yield _guiding(one.guiding)
    yield from _notes(one.guiding.sentences)
    yield _zeroing(one.zeroing)
    yield from _notes(one.zeroing.sentences)
    yield _stability(one.stability)
    yield from _notes(one.stability.sentences)
    for table in (one.speed, one.stiffness, one.damping):
        yield _following(table)
        yield from _notes(table.sentences)
    yield _collision(one.collision)
    yield from _notes((*one.collision.sentences, *(run.stop for run in one.collision.runs if run.stop)))
    yield _loop_time(one.loop_time)
    yield from _notes(one.loop_time.sentences)
    yield _dosing(one.dosing)
    yield from _notes(one.dosing.sentences)


def _notes(sentences: Iterable[str]) -> Iterator[str]:
    for sentence in sentences:
        yield f"  {sentence}"
    yield ""


def _shown(axis: str, value: float) -> str:
    """A way in mm or degrees."""
    return f"{np.degrees(value):.3f}" if axis in _TURNS else f"{value / MM:.3f}"


def _steps(steps: Steps) -> Table:
    table = plain_table(
        f"{steps.section} {steps.title} ({steps.world})",
        *("setting", "axis", ">force", "unit", ">steady", ">F/k", "unit", ">overshoot [%]", ">continuous [%]"),
        ">within 2 % [s]",
    )
    for run in steps.runs:
        for one in run.answers:
            turns = one.axis in _TURNS
            table.add_row(
                run.label,
                one.axis,
                f"{one.force:g}",
                "Nm" if turns else "N",
                _shown(one.axis, one.steady),
                _shown(one.axis, one.expected),
                "°" if turns else "mm",
                f"{100 * one.overshoot:.1f}",
                f"{100 * one.overshoot_expected:.1f}",
                f"{one.settling:.2f}",
            )
    return table


def _flange(steps: Steps) -> Table:
    table = plain_table(
        f"{steps.section} the flange behind the controller",
        *("setting", "axis", ">largest", ">thesis", ">mean", ">thesis", "unit"),
    )
    for run in steps.runs:
        for one in run.tracking:
            figures = (one.maximum, one.thesis_maximum, one.mean, one.thesis_mean)
            unit = "°" if one.axis in _TURNS else "mm"
            table.add_row(run.label, one.axis, *(_shown(one.axis, value) for value in figures), unit)
    return table


def _worst(worst: Iterable[Tracking]) -> Table:
    from trajopt_cli.iiwa.experiments.published import FLANGE_EARLIER

    table = plain_table(
        "6.1.5 the flange behind the controller, worst of all; the thesis' hand-led runs among its own",
        *("axis", ">largest", ">thesis", ">earlier work", ">mean", ">thesis", ">earlier work", "unit"),
    )
    earlier = dict(zip("xyz", zip(*FLANGE_EARLIER, strict=True), strict=True))
    for one in worst:
        most, mean = earlier.get(one.axis, (None, None))
        figures = (one.maximum, one.thesis_maximum, most, one.mean, one.thesis_mean, mean)
        unit = "°" if one.axis in _TURNS else "mm"
        table.add_row(one.axis, *("-" if value is None else _shown(one.axis, value) for value in figures), unit)
    return table


def _force_error(errors: ForceErrors) -> Table:
    table = plain_table(
        f"{errors.section} {errors.title}: largest [N], thesis ±1 N",
        *("axis", *(f">{name}" for name in errors.columns), ">their median", f">ours, median of {errors.sensors}"),
        *(">greatest", ">bound"),
    )
    for one in errors.rows:
        ours = (one.thesis_median, one.median, one.greatest, one.bound)
        table.add_row(one.axis, *(f"{value:g}" for value in one.thesis), *(f"{value:.1f}" for value in ours))
    return table


def _guiding(guided: Guided) -> Table:
    table = plain_table(
        f"{guided.section} {guided.title} ({guided.world})",
        *("pushed along", ">way [mm]", ">F T/d [mm]", ">top speed [mm/s]", ">continuous [mm/s]", ">aside [mm]"),
    )
    for lead in guided.leads:
        figures = (lead.way, lead.expected, lead.speed, lead.speed_expected)
        table.add_row(lead.axis, *(f"{value / MM:.2f}" for value in figures), f"{lead.aside / MM:.4f}")
    return table


def _zeroing(zeroed: Zeroed) -> Table:
    table = plain_table(
        f"{zeroed.section} {zeroed.title} ({zeroed.world})",
        *("of", "free axis", "direction of the way", ">angle [°]", ">aside [mm]", ">length [mm]"),
    )
    axis, direction = (f"({', '.join(f'{x:.3f}' for x in v)})" for v in (zeroed.axis, zeroed.direction))
    table.add_row(
        "controller", axis, direction, _angle(zeroed.angle), f"{zeroed.aside / MM:.4f}", f"{zeroed.length / MM:.1f}"
    )
    if zeroed.flange_angle is not None and zeroed.flange_aside is not None:
        table.add_row("flange", "", "", _angle(zeroed.flange_angle), f"{zeroed.flange_aside / MM:.4f}", "")
    return table


def _angle(value: float) -> str:
    return f"{np.degrees(value):.4f}"


def _stability(found: StabilityMap) -> Table:
    table = plain_table(
        f"{found.section} {found.title}, every setting of the chapter",
        *("setting of", ">k", ">d", ">m", "verdict", ">lost from h = [ms]"),
    )
    for one in found.settings:
        verdict = one.verdict.name.lower()
        table.add_row(one.section, f"{one.k:g}", f"{one.d:g}", f"{one.m:g}", verdict, f"{1e3 * one.h_max:.0f}")
    return table


def _following(table: FollowTable) -> Table:
    at = "" if table.speed is None else f", {table.speed:g} m/s along each axis (edges: {table.edge_speed:g} m/s)"
    out = plain_table(
        f"{table.section} {table.title}: largest deviation{at}",
        *(f">{table.varied} [{table.unit}]", ">thesis [mm]", ">diagonal [mm]", ">difference", ">edges [mm]"),
    )
    for case in table.cases:
        out.add_row(
            f"{case.value:g}",
            f"{case.thesis / MM:.1f}",
            f"{case.diagonal / MM:.1f}",
            f"{100 * case.residual:+.1f} %",
            f"{case.edges / MM:.1f}",
        )
    return out


def _collision(collision: Collision) -> Table:
    table = plain_table(
        f"{collision.section} {collision.title} ({collision.task})",
        *("world", ">first touch [s]", ">crossings", ">tool off in z [mm]", ">at [s]", ">controller off [mm]"),
        *(">force in z [N]", ">at [s]", ">across z [N]", ">friction on top [N]", ">depth [mm]"),
    )
    for run in collision.runs:
        table.add_row(
            run.world,
            _time(run.first),
            f"{run.crossings}",
            f"{run.excursion / MM:.2f}",
            _time(run.excursion_at),
            f"{run.controller / MM:.2f}",
            f"{run.normal:.1f}",
            _time(run.normal_at),
            f"{run.across:.1f}",
            f"{run.friction:.1f}",
            f"{run.deepest / MM:.2f}",
        )
    return table


def _time(t: float | None) -> str:
    return "-" if t is None else f"{t:.3f}"


def _loop_time(times: LoopTimes) -> Table:
    table = plain_table(
        f"{times.section} {times.title} over {times.periods} periods, {times.language}",
        *("part", ">least [µs]", ">mean [µs]", ">longest [µs]", ">thesis' longest [µs]"),
    )
    for part in times.parts:
        last = part is times.parts[-1]
        figures = (f"{value / _MICRO:.0f}" for value in (part.least, part.mean, part.most))
        table.add_row(part.name, *figures, f"{times.thesis_worst / _MICRO:.0f}" if last else "")
    return table


def _dosing(dosing: Dosing) -> Table:
    table = plain_table(
        f"chapter {dosing.section}, the open wish: {dosing.title} ({dosing.task})",
        *("equilibrium", ">T [s]", ">arrived [s]", ">largest lag [mm]", ">at [s]", ">mean lag [mm]"),
    )
    for row in dosing.rows:
        table.add_row(
            row.feeding.value,
            f"{row.duration:.3f}",
            _time(row.arrived),
            f"{row.lag.maximum / MM:.2f}",
            f"{row.lag.time:.3f}",
            f"{row.lag.mean / MM:.2f}",
        )
    table.add_section()
    table.add_row("lower bound at that lag", f"{dosing.least:.3f}", "", "", "", "")
    return table
