"""A problem cut where nothing is left to choose: between fixed waypoints the pieces can be solved one by one.

A cell without a rail falls into single legs this way, and equal pieces are solved once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.optimize.draft import Draft
from trajopt_cli.optimize.legs import LegMotion
from trajopt_cli.optimize.search import Chain
from trajopt_cli.path.arc import Arc
from trajopt_cli.problem.freedom import RailFreedom
from trajopt_cli.problem.problem import Problem

Memory = dict[bytes, Draft]  # pieces of one plant that are solved, by key


def _pinned(problem: Problem, k: int) -> bool:
    stop = problem.waypoints[k]
    if problem.passes(k):
        return False
    return stop.q is not None or (stop.rail[0] == stop.rail[1] and problem.rests(k))


def cut(problem: Problem, chain: Chain) -> Iterator[tuple[Problem, Chain]]:
    """The pieces of a problem with their part of the chain, in order."""
    marks = [k for k in range(len(problem.waypoints)) if _pinned(problem, k)]
    marks = [k for k in marks if not any(group[0] < k < group[-1] for group in problem.ties)]
    ends = sorted({0, *marks, len(problem.waypoints) - 1})
    for first, last in pairwise(ends):
        legs = tuple(replace(leg, start=leg.start - first) for leg in problem.legs[first:last])
        stops = problem.waypoints[first : last + 1]
        inside = [group for group in problem.ties if first <= group[0] and group[-1] <= last]
        ties = tuple(tuple(k - first for k in group) for group in inside)
        part = Chain(
            chain.q[first : last + 1], chain.w[first : last + 1], chain.labels[first : last + 1],
            chain.times[first:last], float(np.sum(chain.times[first:last])),
        )  # fmt: skip
        yield replace(problem, waypoints=stops, legs=legs, stations=(), ties=ties), part


def key(problem: Problem, chain: Chain) -> bytes:
    """Equal for pieces that ask for the same motion."""
    parts = [_digits(chain.q), _digits(chain.w)]
    for k, stop in enumerate(problem.waypoints):
        parts += [_digits(stop.X_WF), repr((stop.rail, problem.rests(k), stop.q is None, stop.fly_by)).encode()]
    for leg in problem.legs:
        numbers = (leg.v_tcp, leg.a_tcp, leg.v_ori, leg.v_rail, leg.duration, leg.rail_moves, leg.acceleration)
        parts += [leg.kind.value.encode(), _digits(leg.X_FT), repr(numbers).encode()]
        if isinstance(leg.segment, Arc):  # a line is what lies between its ends
            arc = leg.segment
            parts += [_digits(arc.centre), _digits(arc.normal), repr(arc.sweep).encode()]
    held = problem.freedom.rail is RailFreedom.STATION
    parts.append(repr((problem.ties, problem.coupling.value, held)).encode())
    parts.append(repr([label.cfx for label in chain.labels]).encode())
    return b"|".join(parts)


def _digits(values: Array) -> bytes:
    return (np.round(values, 12) + 0.0).tobytes()  # -0 is 0


def solve_pieces(
    problem: Problem, chain: Chain, memory: Memory, solve: Callable[[Problem, Chain], Draft],
    report: Callable[[list[LegMotion | None]], None],
) -> Draft:  # fmt: skip
    """Solve every piece that is not in memory, and join the drafts; report: the legs found so far."""
    drafts: list[Draft] = []
    for piece, part in cut(problem, chain):
        name = key(piece, part)
        if name not in memory:
            memory[name] = solve(piece, part)
        drafts.append(memory[name])
        report([leg for draft in drafts for leg in draft.legs])
    q = np.concatenate([d.q[:-1] for d in drafts] + [drafts[-1].q[-1:]])
    qd = np.concatenate([d.qd[:-1] for d in drafts] + [drafts[-1].qd[-1:]])
    cfx = tuple(c for d in drafts for c in d.cfx[:-1]) + drafts[-1].cfx[-1:]
    return Draft(q, qd, cfx, tuple(leg for d in drafts for leg in d.legs))
