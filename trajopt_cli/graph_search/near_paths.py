"""Paths through a search's states that take little longer than the best one: in another branch, turn or rail position.

Of every label at every waypoint, and of every rail position that is better than those beside it, the least time of a
path through it is known from both ends; the paths are followed from there until they meet the best one again.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.graph_search.edges import Edge


def near_paths(
    places: Sequence[IndexArray],
    edges: Sequence[Edge],
    forward: Sequence[Array],
    through: Sequence[Array],
    best: Sequence[int],
    limit: float,
) -> list[tuple[float, list[int]]]:
    """What distinct paths take [s] and their states by number, those that take least first; the best one is not told.

    Args:
        places: label and rail number (2, n_k) of the states at every waypoint.
        edges: times between them.
        forward: the least time (n_k,) from the start to every state.
        through: the least time (n_k,) of a path through every state.
        best: the states of the best path.
        limit: what a path takes at most [s].
    """
    near = [np.flatnonzero(one <= limit) for one in through]
    seeds = [(through[k][i], k, i) for k, some in enumerate(near) for i in _lowest(places[k], through[k], some)]
    passed = [{(int(place[0, i]), int(place[1, i]))} for place, i in zip(places, best, strict=True)]
    out = []
    for cost, k, i in sorted(seeds):
        label, rail = places[k][:, i].tolist()
        if passed[k] & {(label, rail + step) for step in (-1, 0, 1)}:
            continue
        path = _through(edges, forward, through, best, near, k, i)
        out.append((float(cost), path))
        for seen, place, j in zip(passed, places, path, strict=True):
            seen.add((int(place[0, j]), int(place[1, j])))
    return out


def _lowest(place: IndexArray, cost: Array, some: IndexArray) -> list[int]:
    """Those of some states that no state of their label beside them on the rail betters."""
    known = {(int(place[0, i]), int(place[1, i])): float(cost[i]) for i in some}
    return [
        int(i)
        for i, ((label, rail), own) in zip(some, known.items(), strict=True)
        if own <= min(known.get((label, rail + step), np.inf) for step in (-1, 1))
    ]


def _through(
    edges: Sequence[Edge], forward: Sequence[Array], through: Sequence[Array], best: Sequence[int],
    near: Sequence[IndexArray], k: int, i: int,
) -> list[int]:  # fmt: skip
    """The states of the best path through state i of waypoint k, which is the best of all where it has met that."""
    path, at = [*best], i
    path[k] = i
    for j in range(k - 1, -1, -1):
        some = near[j]
        at = int(some[np.argmin(forward[j][some] + edges[j].at(some, at))])
        if at == best[j]:
            break
        path[j] = at
    at = i
    for j in range(k + 1, len(path)):
        some = near[j]
        at = int(some[np.argmin(edges[j - 1].at(at, some) + through[j][some] - forward[j][some])])
        if at == best[j]:
            break
        path[j] = at
    return path
