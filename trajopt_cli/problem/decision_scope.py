"""What a plan may change, from nothing but timing to everything: the optimum and every baseline are one of these."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class RailFreedom(StrEnum):
    """Where the rail may stand at the program's points."""

    PROGRAMMED = "programmed"  # as the robtargets' external axes say; where they say nothing, as at the motion before
    STATION = "station"  # one free position for all points joined by lines and waits
    STOP = "stop"  # a free position at every stop


@dataclass(frozen=True)
class Freedom:
    """rail: its position at the points. lines, dwells: the rail may move while the TCP follows a line, or rests; on a
    line between two programmed rail positions that differ it always does.

    through_stops: the rail may move while the TCP stops (stream only). configuration: the IK branch may differ
    from the program's confdata. drop: motions marked optional may be left out. ways: what would touch something is
    avoided, if need be by additional points before joint moves; without it the plan is made as if nothing stood there.
    turn: tools that may be turned about their axis are.
    """

    rail: RailFreedom = RailFreedom.STOP
    lines: bool = True
    dwells: bool = True
    through_stops: bool = True
    configuration: bool = True
    drop: bool = True
    ways: bool = True
    turn: bool = True

    def and_not_more_than(self, other: Freedom) -> Freedom:
        """What both of them allow."""
        rails = list(RailFreedom)
        return Freedom(
            rails[min(rails.index(self.rail), rails.index(other.rail))],
            self.lines and other.lines,
            self.dwells and other.dwells,
            self.through_stops and other.through_stops,
            self.configuration and other.configuration,
            self.drop and other.drop,
            self.ways and other.ways,
            self.turn and other.turn,
        )


EVERYTHING = Freedom()
AS_WRITTEN = Freedom(
    rail=RailFreedom.PROGRAMMED,
    lines=True,
    dwells=False,
    through_stops=False,
    configuration=False,
    drop=False,
    ways=False,
    turn=False,
)
FIXED_RAIL = Freedom(rail=RailFreedom.STATION, lines=False, dwells=False, through_stops=False, turn=False)
