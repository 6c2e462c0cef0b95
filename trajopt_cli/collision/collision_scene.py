"""What the robot must stay clear of, as the planner asks it: distances, gradients, and whether a motion is free.

Clear means: the distance wanted from every body that stands, none from its own links, and MARGIN more, so that a plan
that is free here is free for the judge, who measures by other means. A question about several motions at once names
the motion of each row: what stands and what is carried may differ between them.

Of a motion during which positioners turn bodies, a question also says how far they have turned: turns (m, U), the share
of each of the motion's units; without that, such bodies are left out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, reduce
from itertools import combinations, product

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, rotation_about
from trajopt_cli.motion import Program, UnitMove, motion_name
from trajopt_cli.path.turning import Turn
from trajopt_cli.problem.collision_objects import RESTS, Bodies, Turned, bodies_on
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.proximity.near import WORLD, NearPairs
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.settings import Settings
from trajopt_cli.shapes import Shape, Solid, outline
from trajopt_cli.trajectories.clearance_queries import Contacts

_TURNS = 2001  # places on the way of a positioner, where it touches something: to say how deep
_FLANGE = 7  # number of the flange behind base and six links


@dataclass(frozen=True, eq=False)
class Hit:
    """Where a way comes too close first: axes q (n,), the link or carried body, what it meets, and by how much the
    distance is less than wanted [m]; touch: the signed distance itself; margin: what plans keep beyond that."""

    q: Array
    body: str
    against: str
    missing: float
    touch: float
    own: bool
    margin: float

    @property
    def said(self) -> str:
        """For people: "link_3 is 4.1 mm inside 'post'", "gripper comes to 2.0 mm of 'wall', 10 mm wanted"."""
        other = self.against if self.own else f"'{self.against}'"
        if self.touch < 0:
            return f"{self.body} is {-self.touch * 1e3:.1f} mm inside {other}"
        near, wanted = f"{self.touch * 1e3:.1f} mm from {other}", f"{(self.touch + self.missing) * 1e3:.1f} mm"
        if self.missing > 0:
            return f"{self.body} is {near}, {wanted} wanted"
        spare = f"plans keep {self.margin * 1e3:g} mm more than the {wanted} wanted"
        return f"{self.body} is {near}, and {spare} (where they may touch, say so: ignore, may_touch)"


@dataclass(frozen=True, eq=False)
class _Pair:
    """A body of the robot and what it is held against: another one of its bodies, or one that stands. wanted [m]: the
    least distance between them, the margin included."""

    body: _Body | _Turned
    other: _Body | _Turned | Solid
    wanted: float

    @property
    def frame(self) -> int:
        """What carries the other."""
        return WORLD if isinstance(self.other, Solid) else self.other.frame

    @property
    def since(self) -> int:
        """Behind which link joints move the body against the other; WORLD for all axes."""
        return self.other.frame if isinstance(self.other, _Body) else WORLD

    @property
    def name(self) -> str:
        """Of both."""
        return f"{self.body.name}|{self.other.name}"

    @property
    def levers(self) -> Array:
        """How far (6,) each joint moves the body against the other per turn: those behind the other's link."""
        if isinstance(self.body, _Turned):
            return np.zeros(6)
        return np.where(np.arange(len(self.body.levers)) >= self.since, self.body.levers, 0.0)

    @property
    def shapes(self) -> tuple[Shape, int, Shape, int]:
        """Both with their frames."""
        other = self.other.loaded if isinstance(self.other, Solid) else self.other.shape
        return self.body.shape, self.body.frame, other, self.frame


@dataclass(frozen=True, eq=False)
class _Body:
    """A shape carried by a frame: 0 the base, 1..6 the links, 7 the flange. levers (6,): how far it reaches at most
    from the axis of each joint that moves it [m]; 0 of the others."""

    name: str
    shape: Shape
    frame: int
    levers: Array


@dataclass(frozen=True, eq=False)
class _Turned:
    """A shape that units (by number) turn, in the world as it stands before that. levers (U,): how far a point of it
    goes at most [m] while each unit turns by all of its angle."""

    name: str
    shape: Shape
    frame: int
    units: tuple[int, ...]
    levers: Array

    @classmethod
    def of(cls, turned: Turned, frame: int, units: Sequence[UnitMove]) -> _Turned:
        """A body of a motion with these units."""
        points, radius = outline(turned.solid.loaded)
        levers, far, last = np.zeros(len(units)), 0.0, np.zeros(3)
        for j in reversed(turned.units):
            p, u, way = np.array(units[j].p), np.array(units[j].u), abs(units[j].angle)
            if j == turned.units[-1]:  # it has the body as it stands
                lever = float(np.linalg.norm(np.cross(points - p, u), axis=1).max()) + radius
                far = float(np.linalg.norm(points - p, axis=1).max()) + radius
            else:  # a ball about the axis behind it has
                lever = far = far + float(np.linalg.norm(last - p))
            levers[j], last = way * (1.0 if units[j].slides else lever), p
            far += way if units[j].slides else 0.0
        return cls(turned.solid.name, turned.solid.loaded, frame, turned.units, levers)


class _Scene:
    """The pairs to look at during some motions. units: that turn bodies then; q has a column of its share for each."""

    def __init__(self, robot: RobotModel, pairs: Sequence[_Pair], settings: Settings, units: Sequence[UnitMove] = ()):
        self.robot, self.pairs, self._settings, self.units = robot, pairs, settings, units
        self.wanted = np.array([pair.wanted for pair in pairs])
        each = [[one for one in (pair.body, pair.other) if isinstance(one, _Turned)] for pair in pairs]
        found = {one.frame: one.units for some in each for one in some}
        self._turned = [found.get(frame, ()) for frame in range(_FLANGE + 1, max(found, default=0) + 1)]
        rides = [float(pair.since == WORLD) for pair in pairs]  # the rail takes one along and not the other
        own = np.array([pair.levers for pair in pairs]).reshape(-1, 6)
        if robot.linkage:  # axis 2 shifts the upper arm against the base and turns it against the lower arm
            own[:, 1] = np.maximum(own[:, 1], own[:, 2])
        self.levers = np.column_stack([rides] * robot.layout.r + [own])
        if units:
            its = [sum((one.levers for one in some), np.zeros(len(units))) for some in each]
            self.levers = np.column_stack([self.levers, np.array(its)])
        self.near = NearPairs([pair.shapes for pair in pairs])

    def poses(self, q: Array) -> Array:
        """The frames (m, F, 4, 4) of all bodies: the robot's, then those that units turn."""
        n = self.robot.layout.n
        X = links(self.robot, q[:, :n])
        if not self._turned:
            return X
        each = [Turn.of(unit).pose(s) for unit, s in zip(self.units, q[:, n:].T, strict=True)]
        own = [np.broadcast_to(reduce(np.matmul, [each[i] for i in numbers], np.eye(4)), (len(q), 4, 4))
               for numbers in self._turned]  # fmt: skip
        return np.concatenate([X, np.stack(own, axis=1)], axis=1)

    def least(self, q: Array) -> Array:
        """The least distance over all pairs (m,), less what is wanted."""
        X = self.poses(q)
        bound = self.near.bound(X)
        rows = np.arange(len(q))
        first = np.argmin(bound - self.wanted, axis=1)
        out = self.distance(X, rows, first)
        rows, pairs = self.near.closer(X, out[:, None] + self.wanted, bound)
        np.minimum.at(out, rows, self.distance(X, rows, pairs))
        return out

    def free(self, q: Array) -> BoolArray:
        """Whether (m,) no pair is too close. What may be the nearest one is looked at first, the others where it is
        not."""
        X, out = self.poses(q), np.ones(len(q), dtype=bool)
        bound = self.near.bound(X)
        first = np.argmin(bound - self.wanted, axis=1)
        rows = np.flatnonzero(bound[np.arange(len(q)), first] < self.wanted[first])
        out[rows] = self.distance(X, rows, first[rows]) >= 0
        bound[rows, first[rows]] = np.inf
        left = np.flatnonzero(out)
        rows, pairs = self.near.closer(X[left], self.wanted, bound[left])
        out[left[rows[self.distance(X[left], rows, pairs) < 0]]] = False
        return out

    def hits(self, q: Array) -> Iterator[Hit]:
        """Each pair that is too close at any of axes q (m, n + U), where it is worst."""
        X, margin, n = self.poses(q), self._settings.clearance_margin, self.robot.layout.n
        rows, pairs = self.near.closer(X, self.wanted)
        distance = self.distance(X, rows, pairs)
        for number in np.unique(pairs[distance < 0]).tolist():
            pair, mine = self.pairs[number], np.flatnonzero(pairs == number)
            i = mine[np.argmin(distance[mine])]
            touch, own = float(distance[i] + pair.wanted), isinstance(pair.other, _Body)
            missing = pair.wanted - margin - touch
            yield Hit(q[rows[i], :n], pair.body.name, pair.other.name, missing, touch, own, margin)

    def distance(self, X: Array, rows: IndexArray, pairs: IndexArray) -> Array:
        """Distances (k,) of pairs in rows of placings of the links, less what is wanted."""
        return self.near.nearest(X, rows, pairs, points=False).distance - self.wanted[pairs]

    def ways_free(self, q: Array, first: IndexArray, last: IndexArray) -> BoolArray:
        """Whether ways (m,) are free that lead straight from each of axes q (N, n) to the next, from row first to row
        last of them: halved until what the axes move cannot bridge the distance."""
        out = self.free(q[first])
        ends = np.flatnonzero(out)
        out[ends] = self.free(q[last[ends]])
        # what the axes move each pair's bodies at most, from the beginning (N, pairs)
        steps = np.abs(np.diff(q, axis=0)) @ self.levers.T
        gone = np.concatenate([np.zeros((1, len(self.pairs))), np.cumsum(steps, axis=0)])
        owner = np.flatnonzero(out)
        low, high = first[owner].astype(float), last[owner].astype(float)
        batch = self._settings.batch // 2
        alive = gone[last[owner]] - gone[first[owner]] > 2 * self._settings.clearance_margin
        while True:
            some = alive.any(axis=1) & out[owner]
            owner, low, high, alive = owner[some], low[some], high[some], alive[some]
            if not len(owner):
                return out
            middle = (low + high) / 2
            middle = np.where(high - low > 1, np.floor(middle), middle)
            for i in range(0, len(owner), batch):
                part = slice(i, i + batch)
                here = _at(gone, middle[part])
                half = np.maximum(_at(gone, high[part]) - here, here - _at(gone, low[part]))
                self._look(_at(q, middle[part]), half, alive[part], owner[part], out)
            owner, alive = np.concatenate([owner, owner]), np.concatenate([alive, alive])
            low, high = np.concatenate([low, middle]), np.concatenate([middle, high])

    def _look(self, q: Array, half: Array, alive: BoolArray, owner: IndexArray, out: BoolArray) -> None:
        """Looks at the middles q (k, n) of ways on which bodies move by half (k, pairs) at most: alive (k, pairs) is
        left where a pair may still meet, and out[owner] (k,) where none does."""
        X = self.poses(q)
        rows, pairs = self.near.closer(X, np.where(alive, self.wanted + half, -np.inf))
        alive[:] = False
        distance = self.distance(X, rows, pairs)
        alive[rows, pairs] = (distance < half[rows, pairs]) & (half[rows, pairs] > self._settings.clearance_margin)
        out[owner[rows[distance < 0]]] = False


class CollisionScene:
    """What a program's motions must stay clear of on a plant."""

    def __init__(self, plant: Plant, program: Program):
        self._robot, self._settings = plant.robot, plant.settings
        moving = [
            _Body(name, shape, i, _levers(plant.robot, shape, i))
            for i, name in enumerate(plant.robot.link_names)
            for shape in plant.robot.bodies.get(name, ())
        ]
        known: dict[Bodies, int] = {}
        self._scenes: list[_Scene] = []
        self._turning: dict[int, _Scene] = {}
        number = []
        for index in range(-1, len(program.motions)):
            bodies = bodies_on(plant, program, index)
            if bodies not in known:
                known[bodies] = len(self._scenes)
                pairs = [*_pairs(plant, moving, bodies)]
                still = [pair for pair in pairs if not isinstance(pair.other, _Turned)]
                if bodies.turned:
                    self._turning[len(self._scenes)] = _Scene(plant.robot, pairs, plant.settings, bodies.units)
                self._scenes.append(_Scene(plant.robot, still, plant.settings))
            number.append(known[bodies])
        self._number = np.array(number)

    @cached_property
    def anything(self) -> bool:
        """Whether there is anything to stay clear of."""
        return any(scene.pairs for scene in (*self._scenes, *self._turning.values()))

    def scene(self, index: int) -> int:
        """A number that is equal for motions with the same bodies."""
        return int(self._number[index + 1])

    def turning(self, index: int) -> int:
        """How many axes turn during a motion, where any of them turns bodies; else 0."""
        scene = self._turning.get(self.scene(index))
        return 0 if scene is None else len(scene.units)

    def distances(self, q: Array, index: int | IndexArray, turns: Array | None = None) -> Array:
        """The least distance (m,) at axes q (m, n) during motions index, less what is wanted and clearance_margin;
        infinite where there is nothing."""
        out = np.full(len(q), np.inf)
        for scene, rows in self._by_scene(len(q), index, turns):
            for part in _parts(rows, self._settings.batch // 2):
                out[part] = scene.least(_with(scene, q, turns)[part])
        return out

    def free(self, q: Array, index: int | IndexArray) -> BoolArray:
        """Whether (m,) the robot may be at axes q (m, n) during motions index; not where q is NaN."""
        out = ~np.isnan(q[:, -1])
        for scene, rows in self._by_scene(len(q), index):
            for part in _parts(rows[out[rows]], self._settings.batch // 2):
                out[part] = scene.free(q[part])
        return out

    def free_between(self, q_0: Array, q_1: Array, index: int | IndexArray) -> BoolArray:
        """Whether (m,) straight ways in the space of the axes, from q_0 to q_1 (m, n), are free all along; places are
        looked at so close that no body moves far between two of them."""
        first = 2 * np.arange(len(q_0))
        return self.ways_free(np.stack([q_0, q_1], axis=1).reshape(-1, q_0.shape[1]), first, first + 1, index)

    def ways_free(
        self, q: Array, first: IndexArray, last: IndexArray, index: int | IndexArray, turns: Array | None = None
    ) -> BoolArray:
        """The same of ways (m,) that lead straight from each of axes q (N, n) to the next, from row first to last."""
        out = np.ones(len(first), dtype=bool)
        for scene, rows in self._by_scene(len(first), index, turns):
            out[rows] = scene.ways_free(_with(scene, q, turns), first[rows], last[rows])
        return out

    def free_beside(self, q: Array, first: IndexArray, last: IndexArray, index: int) -> BoolArray:
        """The same of ways during a motion whose units turn from rest to rest by themselves, rows being even shares of
        the way. Which share goes with which is up to both time laws, each between even speed and even acceleration
        (s = 2 tau^2 up to the middle): so the units ahead, level and behind are looked at."""
        out = self.ways_free(q, first, last, index)
        if not (many := self.turning(index)):
            return out
        share = np.zeros(len(q))
        for a, b in zip(first.tolist(), last.tolist(), strict=True):
            share[a : b + 1] = np.linspace(0, 1, b - a + 1)
        late = np.where(share < 0.5, 2 * share**2, 1 - np.sqrt(np.maximum(1 - share, 0.0) / 2))
        soon = np.where(share < 0.5, np.sqrt(share / 2), 1 - 2 * (1 - share) ** 2)
        for one in (share, late, soon):
            some = np.flatnonzero(out)
            out[some] = self.ways_free(q, first[some], last[some], index, np.tile(one[:, None], many))
        return out

    def way_free(self, q: Array, index: int) -> bool:
        """The same of one way through axes q (N, n)."""
        return bool(self.ways_free(q, np.zeros(1, dtype=np.intp), np.array([len(q) - 1]), index)[0])

    def contacts(self, q: Array, index: int | IndexArray, within: float, turns: Array | None = None) -> Contacts:
        """All pairs nearer than what is wanted, the margin and within [m] at axes q (m, n), by rows."""
        parts: list[tuple[IndexArray, IndexArray, Array, Array, BoolArray]] = []
        names: list[str] = []
        for scene, all_mine in self._by_scene(len(q), index, turns):
            own_pairs = np.array([pair.since != WORLD for pair in scene.pairs])
            for mine in _parts(all_mine, self._settings.batch // 2):
                X = scene.poses(_with(scene, q, turns)[mine])
                rows, pairs = scene.near.closer(X, scene.wanted + within)
                found = scene.near.nearest(X, rows, pairs)
                distance = found.distance - scene.wanted[pairs]
                kept = np.flatnonzero(distance < within)
                rows, pairs = rows[kept], pairs[kept]
                gradient = _gradients(self._robot, scene, X[rows], pairs, found.on_a[kept], found.normal[kept])
                parts.append((mine[rows], len(names) + pairs, distance[kept], gradient, own_pairs[pairs]))
            names += [pair.name for pair in scene.pairs]
        if not parts:
            none = np.zeros(0, dtype=np.intp)
            return Contacts(none, none, (), np.zeros(0), np.zeros((0, q.shape[1])), np.zeros(0, dtype=bool))
        row, number, distance, gradient, own = (np.concatenate(part) for part in zip(*parts, strict=True))
        order = np.lexsort((number, row))
        return Contacts(row[order], number[order], tuple(names), distance[order], gradient[order], own[order])

    def hits(self, q: Array, index: int, turns: Array | None = None) -> list[Hit]:
        """Each pair that is too close at any of axes q (m, n) during a motion, where it is worst; the worst first."""
        found = [scene.hits(_with(scene, q, turns)) for scene, _ in self._by_scene(len(q), index, turns)]
        return sorted((hit for hits in found for hit in hits), key=lambda hit: -hit.missing)

    def _by_scene(
        self, m: int, index: int | IndexArray, turns: Array | None = None
    ) -> Iterator[tuple[_Scene, IndexArray]]:
        """The scenes in which there is something to look at, with the rows asked about them."""
        turning = {} if turns is None else self._turning
        if isinstance(index, int | np.integer):
            number = int(self._number[int(index) + 1])
            scene = turning.get(number, self._scenes[number])
            if scene.pairs and m:
                yield scene, np.arange(m)
            return
        of = self._number[index + 1]
        for number in np.unique(of).tolist():
            scene = turning.get(number, self._scenes[number])
            if scene.pairs:
                yield scene, np.flatnonzero(of == number)


@lru_cache(maxsize=8)
def _known(plant: Plant, program: Program) -> CollisionScene | None:
    around = CollisionScene(plant, program)
    return around if around.anything else None


def collision_scene_of(problem: Problem) -> CollisionScene | None:
    """What a problem's motions must stay clear of; None where that is nothing, or where nothing may change that could
    avoid it: the program as written is driven as it is, and the judge tells."""
    return _known(problem.plant, problem.program) if problem.freedom.ways else None


@lru_cache(maxsize=8)
def turned_into(plant: Plant, program: Program) -> Infeasible | None:
    """The first motion on which positioners turn or shift a body into one that does not ride along, whatever the robot
    does; their axes at equal shares of their ways. Bodies that touch where the program begins are built so."""
    built, asked = _touching(plant), set[Bodies]()
    for index, motion in enumerate(program.motions) if plant.units else ():
        bodies = bodies_on(plant, program, index)
        if not bodies.turned or bodies in asked:
            continue
        asked.add(bodies)
        frames = {units: _FLANGE + 1 + i for i, units in enumerate(sorted({one.units for one in bodies.turned}))}
        turned = [(one.solid, _Turned.of(one, frames[one.units], bodies.units)) for one in bodies.turned]
        every: list[tuple[Solid, _Turned | Solid]] = [*turned, *((one, one) for one in bodies.standing)]
        pairs = [
            _Pair(body, other, plant.settings.clearance_margin)
            for i, (solid, body) in enumerate(turned)
            for beside, other in every[i + 1 :]
            if _must_not_touch(solid, beside) and frozenset((solid.name, beside.name)) not in built
        ]
        scene = _Scene(plant.robot, pairs, plant.settings, bodies.units)
        share = np.tile(np.linspace(0.0, 1.0, _TURNS)[:, None], len(bodies.units))
        q = np.hstack([np.tile(plant.start, (_TURNS, 1)), share])
        if pairs and not scene.ways_free(q[[0, -1]], np.array([0]), np.array([1]))[0]:
            hit = max(scene.hits(q), key=lambda one: one.missing, default=None)
            said = "a body on a positioner touches another one" if hit is None else hit.said
            return Infeasible(index, motion.source, f"{motion_name(motion)} turns a positioner into something: {said}")
    return None


def _must_not_touch(a: Solid, b: Solid) -> bool:
    """Whether two bodies ride apart, or one stands, and nobody allows them to touch."""
    alike = a.rides is not None and b.rides is not None and a.rides.unit == b.rides.unit
    return not (alike or a.name in b.ignore or b.name in a.ignore)


def _touching(plant: Plant) -> set[frozenset[str]]:
    """The names of two obstacles each, one at least on a positioner, that touch where the program begins."""
    both = [(a, b) for a, b in combinations(plant.obstacles, 2) if a.rides or b.rides]
    pairs, numbers = NearPairs([(a.loaded, 0, b.loaded, WORLD) for a, b in both]), np.arange(len(both))
    distance = pairs.nearest(np.eye(4)[None, None], 0 * numbers, numbers, points=False).distance
    return {frozenset((a.name, b.name)) for (a, b), apart in zip(both, distance, strict=True) if apart <= RESTS}


def _with(scene: _Scene, q: Array, turns: Array | None) -> Array:
    """Axes q (m, n) with the shares of a scene's units behind them."""
    return q if turns is None or not scene.units else np.hstack([q, turns[:, : len(scene.units)]])


def _parts(rows: IndexArray, batch: int) -> Iterator[IndexArray]:
    """Rows in parts that are sampled at once."""
    yield from (rows[i : i + batch] for i in range(0, len(rows), batch))


def _at(rows: Array, s: Array) -> Array:
    """Values (m, ...) at fractional row numbers s (m,)."""
    i = np.minimum(s.astype(np.intp), len(rows) - 2)
    u = (s - i)[:, None]
    return np.asarray(rows[i] + u * (rows[i + 1] - rows[i]))


def links(robot: RobotModel, q: Array) -> Array:
    """Poses X_WL (m, 8, 4, 4) of the base, the six links and the flange at axes q (m, n)."""
    m, arm = len(q), robot.chain_axes(q)[:, robot.layout.arm]
    X = np.zeros((m, _FLANGE + 1, 4, 4))
    X[..., 3, 3] = 1.0
    X[:, 0] = robot.base_at(q)
    R, p = X[:, 0, :3, :3], X[:, 0, :3, 3]
    for i, joint in enumerate(robot.chain):
        p = p + R @ joint.X[:3, 3]
        R = R @ joint.X[:3, :3]
        if i < len(robot.chain) - 1:
            R = R @ rotation_about(joint.axis, arm[:, i])
        X[:, i + 1, :3, :3], X[:, i + 1, :3, 3] = R, p
    return X


def _levers(robot: RobotModel, shape: Shape, frame: int) -> Array:
    """How far (6,) a body on a frame reaches from the axis of each joint at most, whatever the joints are."""
    points, radius = outline(shape)
    offsets = [joint.X[:3, 3] for joint in robot.chain]
    if frame == _FLANGE:  # fixed to the last link
        X = robot.chain[6].X
        points = points @ X[:3, :3].T + X[:3, 3]
        frame -= 1
    out = np.zeros(6)
    for j in range(frame):
        axis = robot.chain[j].axis

        def across(p: Array, axis: Array = axis) -> Array:
            return np.asarray(np.linalg.norm(p - (p @ axis)[..., None] * axis, axis=-1))

        if j == frame - 1:
            out[j] = across(points).max() + radius
        else:
            rest = sum(float(np.linalg.norm(offsets[k])) for k in range(j + 2, frame))
            out[j] = float(across(offsets[j + 1])) + rest + float(np.linalg.norm(points, axis=1).max()) + radius
    return out


def _pairs(plant: Plant, links: Sequence[_Body], bodies: Bodies) -> Iterator[_Pair]:
    """What is held against what: bodies that an axis moves against those that stand, and the robot against itself."""
    held = [_Body(one.name, one.loaded, _FLANGE, _levers(plant.robot, one.loaded, _FLANGE)) for one in bodies.carried]
    for solid in bodies.standing:
        for body in (*links, *held):
            if body.name not in solid.ignore and (body.frame > 0 or plant.robot.has_rail):
                yield _Pair(body, solid, plant.clearance + plant.settings.clearance_margin)
    frames = {units: _FLANGE + 1 + i for i, units in enumerate(sorted({one.units for one in bodies.turned}))}
    for turned in bodies.turned:
        other = _Turned.of(turned, frames[turned.units], bodies.units)
        for body in (*links, *held):
            if body.name not in turned.solid.ignore:
                yield _Pair(body, other, plant.clearance + plant.settings.clearance_margin)
    for first, second in plant.self_pairs:
        firsts, seconds = ([one for one in (*links, *held) if one.name == name] for name in (first, second))
        for body, inner in product(seconds, firsts):  # none: it is not carried now
            yield _Pair(body, inner, plant.settings.clearance_margin)


def _gradients(
    robot: RobotModel, scene: _Scene, X_WL: Array, pairs: IndexArray, on_body: Array, normal: Array
) -> Array:
    """How distances change with each axis (k, n): along the normal, as the body's nearest point moves against what it
    is held against. X_WL (k, F, 4, 4)."""
    layout = robot.layout
    out = np.zeros((len(pairs), layout.n))
    arm = out[:, layout.arm]
    frame = np.array([pair.body.frame for pair in scene.pairs], dtype=np.intp)[pairs]
    since = np.array([pair.since for pair in scene.pairs], dtype=np.intp)[pairs]
    for j in range(6):
        X = X_WL[:, j + 1]
        axis = X[:, :3, :3] @ robot.chain[j].axis
        rate = np.einsum("ki,ki->k", np.cross(axis, on_body - X[:, :3, 3]), normal)
        arm[:, j] = np.where((since <= j) & (j < frame), rate, 0.0)
    arm[:, 1] -= robot.linkage * arm[:, 2]
    out[:, layout.rail] = np.where((since == WORLD)[:, None], normal @ robot.rail_axes_W.T, 0.0)
    return out
