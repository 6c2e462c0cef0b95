"""The robot against obstacles and against itself: how near it comes, and where it first touches.

Every obstacle is one finding, the robot against itself another. value is the least distance of the whole motion
(negative: the depth), limit the distance wanted. Where that is missed, time and source are those of the first miss.
What the flange carries and what stands where may change on the way: see scene. Pairs that no axis moves against each
other are not looked at: nothing a program does changes them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations, product

import numpy as np

from trajopt_cli.findings import CLEARANCE, SELF_CLEARANCE, TABLE_CLEARANCE, Finding
from trajopt_cli.judge.continuous_collision import LOOKS, OVERLOOKED, Body, Closest, Near, Sweep
from trajopt_cli.judge.findings import SourceAt
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import FLANGE, Mechanism, mechanism_of
from trajopt_cli.judge.scene import RESTS, BodyInterval, shape_of, standing_still, tables_of
from trajopt_cli.motion import Move, Program, Source, motion_name
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import TOOL, Capsule, Shape, Solid
from trajopt_cli.trajectory import Trajectory


def least_clearance(findings: Iterable[Finding]) -> Finding | None:
    """The finding of the obstacle that the robot comes nearest to; None where no obstacle was looked at."""
    return min((one for one in findings if one.check == CLEARANCE), key=lambda one: one.value, default=None)


def check_start(program: Program, plant: Machine, start: str) -> list[Finding]:
    """What check_clearance says of the robot standing at its start; start names that for people."""
    q = np.tile(plant.start, (2, 1))
    still = Trajectory(plant.limits.names, np.array([0.0, 1e-3]), q, np.zeros_like(q))
    return check_clearance(program, plant, still, lambda _: None, start=start)


def check_clearance(
    program: Program,
    plant: Machine,
    trajectory: Trajectory,
    source_at: SourceAt,
    legs: Sequence[BodyInterval] | None = None,
    start: str = "",
    open_: float = 0.0,
) -> list[Finding]:
    """One finding per obstacle, one for the robot against itself, and one for what positioners turn against all that
    does not ride with it; none where the plant has no shapes for it.

    legs: which bodies are where during which rows; None: as at the start, all the time. open_: how much nearer than it
    is the robot may be seen, as its rows and their digits show it [m].
    """
    mechanism = mechanism_of(plant)
    tables = tables_of(program, plant, trajectory)
    sweep = Sweep(mechanism, trajectory, tables)
    last = len(trajectory.t) - 1
    legs = [leg for leg in legs or () if leg.first < leg.last] or standing_still(program, plant, last)
    links = [Body(n, shape, i) for i, n in enumerate(mechanism.link_names) for shape in plant.robot.bodies.get(n, ())]
    carried = {shape: Body(shape.name, shape, FLANGE) for leg in legs for shape in map(shape_of, leg.carried)}
    facing: dict[str, _Spans] = {solid.name: _Spans(last) for solid in plant.obstacles}
    own, beside, turned = _Spans(last), _Spans(last), dict[Shape, Body]()
    built = _touching_at_start(plant) if tables.turning else set[frozenset[str]]()
    for leg in legs:
        held = [carried[shape_of(solid)] for solid in leg.carried]
        placed: list[tuple[Solid, Shape | Body]] = []
        for solid in leg.standing:
            other: Shape | Body = shape_of(solid)
            if solid.rides is not None:
                number = FLANGE + 1 + tables.number[solid.rides]
                other = turned.setdefault(shape_of(solid), Body(solid.name, shape_of(solid), number))
            for one, before in placed:
                if {one.rides, solid.rides} & tables.turning and _apart(one, solid, built):
                    pair = (other, before) if isinstance(other, Body) else (before, other)
                    assert isinstance(pair[0], Body)
                    beside.add(leg, pair[0], pair[1])
            placed.append((solid, other))
            for body in (*links, *held):
                if _meet(mechanism, body, solid) or (solid.rides in tables.turning and body.name not in solid.ignore):
                    facing[solid.name].add(leg, body, other)
        named: dict[str, list[Body]] = {}
        for body in (*links, *held):
            named.setdefault(body.name, []).append(body)
        for first, second in plant.self_pairs:
            for body, other in product(named.get(second, ()), named.get(first, ())):
                own.add(leg, body, other)
    out = [
        _finding(CLEARANCE, program, sweep, group, plant.clearance, source_at, start, open_)
        for group in (spans.group() for spans in facing.values())
        if group
    ]
    groups = {SELF_CLEARANCE: own.group(), TABLE_CLEARANCE: beside.group()}
    return out + [_finding(check, program, sweep, pairs, 0.0, source_at, start, open_)
                  for check, pairs in groups.items() if pairs]  # fmt: skip


def _touching_at_start(plant: Machine) -> set[frozenset[str]]:
    """The obstacles that are nearer to each other than REST where the program begins: they are built so."""
    here = np.eye(4)
    return {
        frozenset((a.name, b.name))
        for a, b in combinations(plant.obstacles, 2)
        if (a.rides or b.rides) and Pair(shape_of(a), shape_of(b)).distance(here, here) <= RESTS
    }


def _apart(a: Solid, b: Solid, built: set[frozenset[str]]) -> bool:
    """Whether two bodies, of which a positioner turns one, must not touch."""
    alike = a.rides is not None and b.rides is not None and a.rides.unit == b.rides.unit
    return not (alike or a.name in b.ignore or b.name in a.ignore or frozenset((a.name, b.name)) in built)


class _Spans:
    """Pairs of bodies with the rows in which they are held against each other. last: of all rows."""

    def __init__(self, last: int):
        self._last = last
        self._rows: dict[tuple[Body, Shape | Body], list[tuple[int, int]]] = {}

    def add(self, leg: BodyInterval, body: Body, other: Shape | Body) -> None:
        """The pair counts during the leg, too; legs come in order."""
        spans = self._rows.setdefault((body, other), [])
        if spans and spans[-1][1] == leg.first:
            spans[-1] = (spans[-1][0], leg.last)
        else:
            spans.append((leg.first, leg.last))

    def group(self) -> list[Near]:
        """All pairs."""
        return [
            Near(body, None, other, tuple(spans)) if isinstance(other, Body) else Near(body, other, None, tuple(spans))
            for (body, other), spans in self._rows.items()
        ]


def _meet(mechanism: Mechanism, body: Body, solid: Solid) -> bool:
    """Whether an axis moves the body, and nobody allowed it to touch the solid."""
    return body.name not in solid.ignore and (body.joints > 0 or mechanism.has_rail)


def _finding(
    check: str,
    program: Program,
    sweep: Sweep,
    group: list[Near],
    wanted: float,
    source_at: SourceAt,
    start: str = "",
    open_: float = 0.0,
) -> Finding:
    least = sweep.least(group, wanted)
    passed = least.proven and least.distance >= wanted - open_
    first = least
    if least.distance < wanted - open_:
        first = sweep.first_below(group, (0.0 if least.distance < -open_ else wanted) - open_) or least
    # Before the first row nothing is under way: the program's first motion leaves from there.
    source = source_at(first.time) or next((motion.source for motion in program.motions), None)
    if passed:
        said = f"{_names(least)} come nearest at {least.time:.3f} s, {least.distance * 1e3:.1f} mm"
        message = f"{said}; no touch deeper than {OVERLOOKED * 1e3:g} mm was overlooked"
    elif least.distance >= wanted - open_:
        said = f"{least.distance * 1e3:.1f} mm at {least.time:.3f} s"
        message = f"{_names(least)} are not judged to the end: after {LOOKS} looks the nearest is {said}, and nobody"
        message += " knows what is between; see the rows: axes go to and fro, or speeds do not fit the positions"
    else:
        later = source_at(least.time)
        motion = next((one for one in program.motions if one.source == later), None)
        where = f" in {motion_name(motion)}" if isinstance(motion, Move) and later != source and not start else ""
        message = f"{_what(program, source, start)} {_touch(first, least, wanted, where)}"
    return Finding(check, _names(first), least.distance, wanted, "m", passed, first.time, source, message)


def _names(closest: Closest) -> str:
    return f"{closest.near.body.name} and {_against(closest)}"


def _against(closest: Closest) -> str:
    """An obstacle's name is the user's, a link's the robot's."""
    robots = closest.near.other is not None and closest.near.other.frame <= FLANGE
    return closest.near.against if robots else f"'{closest.near.against}'"


def _what(program: Program, source: Source | None, start: str) -> str:
    """Place and name of the motion, as in "cell.mod:41:9: MoveJ p_in"; start where nothing moves yet."""
    if start:
        return start
    for motion in program.motions:
        if motion.source == source:
            return f"{source}: {type(motion).__name__} {getattr(motion, 'target', '')}".rstrip()
    return "the motion"


def _touch(first: Closest, least: Closest, wanted: float, where: str) -> str:
    """where: of the least distance, in words; empty where it is in the motion of the first touch."""
    other = "" if least.near is first.near else f" with {least.near.body.name}"
    when = "" if f"{least.time:.3f}" == f"{first.time:.3f}" and not other else f"{other} at {least.time:.3f} s{where}"
    if least.distance < 0:
        verb, depth = "hits", f"{'deepest ' if when else ''}{-least.distance * 1e3:.1f} mm{'' if when else ' deep'}"
    else:
        verb, depth = "comes too close to", f"wanted {wanted * 1e3:g} mm, {'least' if when else 'has'} "
        depth += f"{least.distance * 1e3:.1f} mm"
    said = f"{verb} {_against(first)} with {first.near.body.name} at {first.time:.3f} s, {depth}{when}"
    if TOOL in (first.near.body.name, first.near.against) and isinstance(first.near.body.shape, Capsule):
        assumed = f"a capsule of {first.near.body.shape.radius * 1e3:g} mm from flange to TCP stands for the tool"
        return f"{said} ({assumed}: give its bodies under attached, or another tool_radius)"
    # A link's polytope is up to half as large again as its hull, a capsule up to three times as large.
    remedy = " (by bodies around them; where the links themselves are clear, name the pair under may_touch)"
    return said + remedy if first.near.other is not None and first.near.other.frame <= FLANGE else said
