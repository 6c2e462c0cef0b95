"""The saving by cause: plans in a fixed order, each free to change one thing more than the one before."""

from __future__ import annotations

from dataclasses import dataclass, replace

from trajopt_cli.problem.freedom import AS_WRITTEN, EVERYTHING, Freedom, RailFreedom
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant


@dataclass(frozen=True)
class Cause:
    """name: what is free from this plan on, besides all before it. needs_rail: it says nothing without a rail."""

    name: str
    target: Target
    freedom: Freedom
    needs_rail: bool = False


_TIMED = Freedom(RailFreedom.PROGRAMMED, False, False, False, configuration=False, drop=False)

CAUSES: tuple[Cause, ...] = (
    Cause("as written", Target.RAPID, AS_WRITTEN),
    Cause("retimed: joint moves bend", Target.STREAM, _TIMED),
    Cause("configuration", Target.STREAM, Freedom(RailFreedom.PROGRAMMED, False, False, False, drop=False)),
    Cause(
        "rail position per station", Target.STREAM, Freedom(RailFreedom.STATION, False, False, False, drop=False), True
    ),
    Cause("rail in lines", Target.STREAM, Freedom(dwells=False, through_stops=False, drop=False), True),
    Cause("rail in dwells", Target.STREAM, Freedom(through_stops=False, drop=False), True),
    Cause("rail through stops", Target.STREAM, Freedom(drop=False), True),
    Cause("dropped detours", Target.STREAM, EVERYTHING),
)


def causes(plant: Plant, optional: bool) -> tuple[Cause, ...]:
    """The causes that can make a difference. optional: the program has motions that may be dropped."""
    kept = [cause for cause in CAUSES if plant.robot.has_rail or not cause.needs_rail]
    return tuple(cause for cause in kept if optional or not cause.freedom.drop)


def asked(freedom: Freedom, plant: Plant, optional: bool) -> Freedom:
    """The same freedom without what it says of things that are not there: equal questions become equal."""
    if not plant.robot.has_rail:
        freedom = replace(freedom, rail=EVERYTHING.rail, lines=True, dwells=True, through_stops=True)
    return freedom if optional else replace(freedom, drop=False)
