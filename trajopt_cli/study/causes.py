"""The saving by cause: plans in a fixed order, each free to change one thing more than the one before.

A program with corners begins with none: every fly-by is made a stop, so that it shows what its zones save.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, Freedom, RailFreedom
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant


@dataclass(frozen=True)
class Cause:
    """name: what is free from this plan on, besides all before it. needs_rail: it says nothing without a rail. stops:
    of the program with every fly-by a stop."""

    name: str
    target: Target
    freedom: Freedom
    needs_rail: bool = False
    stops: bool = False


CORNERS = "corners"
_TAUGHT = Freedom(drop=False, turn=False)
_TIMED = Freedom(RailFreedom.PROGRAMMED, False, False, False, configuration=False, drop=False, ways=False, turn=False)
_STILL = {"lines": False, "dwells": False, "through_stops": False}
TOOL_TURN = "tool turn"

CAUSES: tuple[Cause, ...] = (
    Cause("as written", Target.RAPID, AS_WRITTEN),
    Cause("retimed: joint moves bend", Target.STREAM, _TIMED),
    Cause("configuration", Target.STREAM, replace(_TAUGHT, rail=RailFreedom.PROGRAMMED, **_STILL)),
    Cause("rail position per station", Target.STREAM, replace(_TAUGHT, rail=RailFreedom.STATION, **_STILL), True),
    Cause("rail in lines", Target.STREAM, replace(_TAUGHT, dwells=False, through_stops=False), True),
    Cause("rail in dwells", Target.STREAM, replace(_TAUGHT, through_stops=False), True),
    Cause("rail through stops", Target.STREAM, _TAUGHT, True),
    Cause(TOOL_TURN, Target.STREAM, Freedom(drop=False)),
    Cause("dropped detours", Target.STREAM, EVERYTHING),
)


def causes(plant: Plant, optional: bool, corners: bool = False, free: bool = False) -> tuple[Cause, ...]:
    """The causes that can make a difference. optional: the program has motions that may be dropped. corners: it passes
    fly-bys; then the first plan is that with stops, and the second the program as written. free: tools may be turned
    about their axis."""
    kept = [cause for cause in CAUSES if plant.robot.has_rail or not cause.needs_rail]
    kept = [cause for cause in kept if (optional or not cause.freedom.drop) and (free or cause.name != TOOL_TURN)]
    if corners:
        written, *others = kept
        kept = [replace(written, name=f"{written.name}, fly-bys as stops", stops=True), replace(written, name=CORNERS)]
        kept += others
    return tuple(kept)


def asked(freedom: Freedom, plant: Plant, optional: bool, free: bool = False) -> Freedom:
    """The same freedom without what it says of things that are not there: equal questions become equal."""
    freedom = freedom if free else replace(freedom, turn=EVERYTHING.turn)
    if not plant.robot.has_rail:
        freedom = replace(freedom, rail=EVERYTHING.rail, lines=True, dwells=True, through_stops=True)
    return freedom if optional else replace(freedom, drop=False)
