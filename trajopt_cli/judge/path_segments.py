"""One motion from stop to stop: which of its places are on which path, and which in the zone of a point that is passed.

The points are passed where the polyline through the places comes nearest to them, in order; what lies between two of
them is on the way between. A place beside such a moment may be before it or after it: the polyline does not tell on
which side of a small zone its corners lie, and several points may lie between two rows.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import Path, angle_between, lengths, turned_back, wanted_path
from trajopt_cli.judge.positioners import TurnedFrame
from trajopt_cli.judge.samples import Rows
from trajopt_cli.judge.timeline import Timeline, Visit, rows_of_run
from trajopt_cli.judge.tolerances import LINE_POSITION, LINE_ROTATION
from trajopt_cli.judge.tool_kinematics import Places, ToolKinematics
from trajopt_cli.judge.waypoint_matching import off_chords
from trajopt_cli.motion import FlyBy, FreeTurn, PathMove, UnitMove, turned_under

Indices = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class StopInterval:
    """Visits 0..n from one stop, or corner in which the tool changes, to the next, with places (m) between them; path l
    leads from visit l to visit l + 1. within: first and last row, None where the stops tell."""

    rows: Rows
    frame: ToolKinematics
    visits: tuple[Visit, ...]
    within: tuple[int, int] | None = None

    @cached_property
    def part(self) -> tuple[int, int]:
        """First and last row."""
        if self.within is not None:
            return self.within
        if isinstance(self.frame, TurnedFrame) and self.visits[-1].arrive <= self.visits[0].depart:
            return self.frame.span(self.visits[0], self.visits[-1])
        return rows_of_run(self.rows, self.visits)

    @cached_property
    def places(self) -> Places:
        """All there is to see."""
        return self.frame.places(*self.part)

    @cached_property
    def step(self) -> int:
        """How many places on is the next row."""
        return max((len(self.places.t) - 1) // max(self.part[1] - self.part[0], 1), 1)

    @cached_property
    def X_WT(self) -> Array:
        """The tool at the visits (n + 1, 4, 4)."""
        X_WT = np.stack([visit.X_WF for visit in self.visits]) @ self.frame.X_FT
        if self._units:
            X_WT[-1] = turned_back(self._units, X_WT[-1])
        return np.asarray(X_WT)

    @property
    def _units(self) -> tuple[UnitMove, ...]:
        """What turns the work object meanwhile; both ends are stops then."""
        move = self.visits[-1].point.move
        return () if move is None else turned_under(move)

    @cached_property
    def paths(self) -> tuple[Path | None, ...]:
        """What the moves prescribe; None for joint moves."""
        return tuple(self._wanted_path(leg) for leg in range(len(self.visits) - 1))

    def _wanted_path(self, leg: int) -> Path | None:
        before, visit = self.visits[leg : leg + 2]
        R = self.frame.R[before.depart : max(visit.arrive, before.depart) + 1]
        move = visit.point.move
        return wanted_path(move, self.X_WT[leg], self.X_WT[leg + 1], R) if isinstance(move, PathMove) else None

    def free(self, leg: int) -> FreeTurn | None:
        """How the tool may be turned on a line or an arc; None where it may not, and on one that only turns it."""
        path = self.paths[leg]
        return None if path is None or path.only_turns else self.visits[leg + 1].point.free

    def zones(self, kind: str) -> Array:
        """Sizes (n + 1,) of the visits' zones [m]: radius, turning or external; negative for stops."""
        return self._sizes[kind]

    @cached_property
    def _sizes(self) -> dict[str, Array]:
        zones = [visit.point.fly_by or FlyBy(-1.0, -1.0, -1.0) for visit in self.visits]
        return {kind: np.array([getattr(zone, kind) for zone in zones]) for kind in ("radius", "turning", "external")}

    @cached_property
    def _turned(self) -> NDArray[np.bool_]:
        """Which visits (n + 1,) have a zone that is an angle."""
        return np.array([visit.point.fly_by is not None and visit.point.fly_by.in_place for visit in self.visits])

    @cached_property
    def _passing_places(self) -> Array:
        """Where the points 1..n-1 are passed (n - 1,), in places and shares of the chord to the next; ascending."""
        out: list[float] = []
        first, last = self.part
        for k, visit in enumerate(self.visits[1:-1], start=1):
            event = visit.event
            assert event is not None
            since = int(out[-1]) if out else 0
            a = max((min(max(event.first, first), last) - first) * self.step, since)
            b = max((min(max(event.last, first), last) - first) * self.step, a + 1)
            chords = np.arange(a, min(b, len(self.places.t) - 1))
            if not len(chords):
                out.append(float(a))
                continue
            distance, fraction = off_chords(self.places.p, self.X_WT[k, :3, 3], chords)
            if self._turned[k]:
                distance, fraction = angle_between(self.places.R[chords], self.X_WT[k, :3, :3]), np.zeros(len(chords))
            i = int(np.argmin(distance))
            out.append(max(float(chords[i] + fraction[i]), out[-1] if out else 0.0))
        return np.array(out)

    def between(self, leg: int) -> tuple[int, int]:
        """The places before and behind a leg."""
        ends = [0.0, *self._passing_places, len(self.places.t) - 1.0]
        return int(np.floor(ends[leg])), int(np.ceil(ends[leg + 1]))

    @cached_property
    def _found(self) -> tuple[Indices, Indices, NDArray[np.bool_]]:
        """The path (m,) every place is on, the visit (m,) in whose zone it lies, -1 for none, and whether both are
        sure."""
        m, order = len(self.places.t), np.arange(len(self.places.t))
        path = np.searchsorted(self._passing_places, order, side="right")
        least = np.searchsorted(self._passing_places, order - 1, side="right")
        most = np.searchsorted(self._passing_places, order + 1, side="left")
        zone = self._zone_of(order, path)
        open_ones = (least < most) & (zone < 0)
        for i in np.flatnonzero(open_ones):
            path[i], zone[i] = self._settled(int(i), int(max(least[i], path[i - 1] if i else 0)), int(most[i]))
        assert len(path) == m
        return np.maximum.accumulate(path), zone, ~open_ones

    def _zone_of(self, order: Indices, path: Indices) -> Indices:
        """The visit in whose zone places (m,) on paths (m,) lie: of the one behind in the first half of a path, of the
        one ahead in the second; -1 for none."""
        radius, P, p = self.zones("radius"), self.X_WT[:, :3, 3], self.places.p[order]
        s = self._shares(order, path)
        margin = LINE_POSITION + self.places.doubt_p[order]
        behind, ahead = (lengths(p - P[k]) for k in (path, path + 1))
        if self._turned.any():
            R, doubt = self.places.R[order], LINE_ROTATION + self.places.doubt_angle[order]
            for off, k in ((behind, path), (ahead, path + 1)):
                at = np.flatnonzero(self._turned[k])
                off[at] = angle_between(R[at], self.X_WT[k[at], :3, :3]) + margin[at] - doubt[at]
        in_first = (behind <= radius[path] + margin) & ~(s >= 0.5) & (radius[path] > 0)
        in_second = (ahead <= radius[path + 1] + margin) & ~(s < 0.5) & (radius[path + 1] > 0)
        first = in_first & (~in_second | (behind < ahead))
        return np.where(first, path, np.where(in_second, path + 1, -1))

    def _shares(self, order: Indices, path: Indices) -> Array:
        """Shares (m,) of places on their ways, not clipped; nan on joint moves."""
        s = np.full(len(order), np.nan)
        edges = np.searchsorted(path, np.arange(len(self.paths) + 1))
        for one, a, b in zip(self.paths, edges[:-1], edges[1:], strict=True):
            if one is not None and b > a:
                s[a:b] = one.progress(self.places.p[order[a:b]], self.places.R[order[a:b]])
        return s

    def _settled(self, i: int, least: int, most: int) -> tuple[int, int]:
        """Way and zone of a place that is in no zone of the path it seems to be on: the first path that explains it,
        else the one it is nearest to."""
        p, R = self.places.p[i : i + 1], self.places.R[i : i + 1]
        margin = LINE_POSITION + self.places.doubt_p[i]
        radius = self.zones("radius")
        for k in range(least + 1, most + 1):
            X = self.X_WT[k]
            away = angle_between(R[0], X[:3, :3]) if self._turned[k] else np.linalg.norm(p[0] - X[:3, 3])
            if radius[k] > 0 and away <= radius[k] + margin:
                return k, k
        off = []
        for leg in range(least, most + 1):
            path = self.paths[leg]
            off.append(np.inf if path is None else float(off_path(path, p, path.progress(p, R))[0]))
        explained = [leg for leg, distance in zip(range(least, most + 1), off, strict=True) if distance <= margin]
        joint = [leg for leg in range(least, most + 1) if self.paths[leg] is None]
        return next(iter([*explained, *joint, least + int(np.argmin(off))])), -1

    @property
    def zone(self) -> Indices:
        """The visit (m,) in whose zone every place lies, -1 for none."""
        return self._found[1]

    @property
    def sure(self) -> NDArray[np.bool_]:
        """Places (m,) that are on one path or in one zone beyond doubt."""
        return self._found[2]

    @cached_property
    def fractions(self) -> Array:
        """Shares (m,) of all places on their ways, not clipped; nan on joint moves."""
        return self._shares(np.arange(len(self.places.t)), self._found[0])

    @cached_property
    def _edges(self) -> Indices:
        return np.searchsorted(self._found[0], np.arange(len(self.paths) + 1))

    def on(self, leg: int) -> slice:
        """The places on a path."""
        return slice(int(self._edges[leg]), int(self._edges[leg + 1]))

    def beyond(self, leg: int, kind: str) -> NDArray[np.bool_]:
        """Which places on a line or an arc are outside the zones at its ends, measured along the path; at a stop there
        is none."""
        return np.asarray(self._zone_along(leg, kind) < 0)

    @cached_property
    def turning_zone(self) -> Indices:
        """The visit (m,) in whose zone of orientation every place lies, -1 for none and on joint moves."""
        out = np.array(self.zone)
        for leg, path in enumerate(self.paths):
            if path is not None:
                out[self.on(leg)] = self._zone_along(leg, "turning")
        return out

    def _zone_along(self, leg: int, kind: str) -> Indices:
        """The visit in whose zone the places on a line or an arc lie, measured along it; -1 for none."""
        path = self.paths[leg]
        assert path is not None
        part, sizes = self.on(leg), self.zones(kind)
        done = self.fractions[part] * path.extent
        further = np.where(path.extent - done <= sizes[leg + 1], leg + 1, -1)
        further = np.where(done <= sizes[leg], leg, further)
        if not path.straight:  # a narrow one stays within the sphere of a zone that it has left
            return further
        return np.where(self.zone[part] >= 0, self.zone[part], further)

    def edge(self, leg: int, visit: int, kind: str) -> tuple[Array, Array]:
        """Position (3,) and rotation (3, 3) where a line or an arc enters or leaves the zone of a visit at its end."""
        path = self.paths[leg]
        assert path is not None
        fraction = self.zones(kind)[visit] / path.extent
        p, R = path.at(np.array([fraction if visit == leg else 1.0 - fraction]))
        return p[0], R[0]


def off_path(path: Path, p: Array, s: Array) -> Array:
    """Distances (m,) of positions p (m, 3) from their places s (m,) on a path, its ends beyond them."""
    return lengths(p - path.positions(np.clip(s, 0.0, 1.0)))


def runs_of(timeline: Timeline, frames: dict[bytes, ToolKinematics]) -> Iterator[StopInterval]:
    """Every run with the tool in force on it, cut where that changes in a corner; what is known of one goes before the
    next one comes."""
    for visits in timeline.runs():
        tools = [frames[np.asarray(visit.point.X_FT).tobytes()] for visit in visits]
        cuts = [k for k in range(1, len(visits) - 1) if tools[k] is not tools[k + 1]]
        corners = [visits[k].corner or (visits[k].arrive, visits[k].depart) for k in cuts]
        if not cuts:
            turned = timeline.turned.get(visits[-1].point.index)
            yield StopInterval(timeline.rows, turned or tools[-1], visits)
            continue
        first, last = rows_of_run(timeline.rows, visits)
        begins, ends = [first, *(b for _, b in corners)], [*(a for a, _ in corners), last]
        for i, k, begin, end in zip([0, *cuts], [*cuts, len(visits) - 1], begins, ends, strict=True):
            yield StopInterval(timeline.rows, tools[k], visits[i : k + 1], (begin, max(end, begin)))
