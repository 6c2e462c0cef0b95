"""How long axes settle at stops, by logs: what they stand there besides waits of a programmed time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from trajopt_cli.measured.align import Alignment, settles, timed
from trajopt_cli.motion import Motion, Move


@dataclass(frozen=True)
class SeenSettling:
    """kind: "fine" or "inpos", see scenario.Settling; seconds: the mean of so many stops; predicted: in force [s]."""

    kind: str
    seconds: float
    predicted: float
    stops: int


def settling_seen(motions: Sequence[Motion], logs: Sequence[Alignment]) -> list[SeenSettling]:
    """By kind; stops before a wait for a signal, whose length is not known, tell nothing. motions: of the program."""
    found: dict[str, list[tuple[float, float]]] = {"fine": [], "inpos": []}
    for one in (measured for log in logs for measured in log.motions):
        if settles(motions, one.index) and timed(motions, one.index):
            before = next(move for move in motions[one.index :: -1] if isinstance(move, Move))
            ordinary = before.zone.stop and before.zone.criterion is None
            found["fine" if ordinary else "inpos"].append((one.measured, one.predicted))
    return [
        SeenSettling(kind, max(sum(a for a, _ in some) / len(some), 0.0), some[0][1], len(some))
        for kind, some in found.items()
        if some
    ]
