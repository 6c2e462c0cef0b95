"""From the first row to the last: eager as long as that is safe, and, for laws that swing, brakes tried out.

Eager steps are the optimum while the arm never runs past its equilibrium. A law that swings (d^2 < 4 k m) does: there
it pays to let the arm slow down before a corner or an end, and then to rush ahead of it again. Before every waypoint
one such brake, a run of lazy steps, is searched for on a coarse walk by when it begins and how long it lasts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

from trajopt_cli.iiwa.controller.greedy_feed import State, Walk

ROWS = 3_000_000
"""Rows a dosed sequence may have: 50 min at 1 ms."""
MOST_LOOKAHEAD = 10_000_000
"""Periods that one walk from the first row to the last may look ahead in all: about a minute of computing."""
_BLOCK, _LARGEST = 8, 256  # periods walked between two checks of safety
_HALVINGS = 12  # of the last eager step before an unsafe state
_WINDOW = 2.5  # time constants before and after a waypoint that a brake is judged by
_BEGINS = (0.1, 0.3, 0.6, 1.0, 1.5)  # tried begins before the waypoint, in time constants
_LASTS = (0.1, 0.25, 0.5)  # tried lengths of a brake, in time constants
_FINEST = 0.01  # of the same, at which the search for both ends
_WORTH = 1e-3  # periods a brake has to save to count as better
_BACK = 16  # periods to go back by until a state is safe


@dataclass(frozen=True)
class Brake:
    """Lazy steps for so many seconds, from the first row at or past s on."""

    s: float
    seconds: float


class _Advance:
    """A walk under way: states so far, how many of them had to hold back."""

    def __init__(self, walk: Walk, state: State, brakes: Sequence[Brake] = ()) -> None:
        self.walk = walk
        self.states = [state]
        self.braked = 0
        self.brakes = list(brakes)
        self._block = _BLOCK
        self._lookahead = walk.lookahead

    @property
    def arrived(self) -> bool:
        """Whether the path is at its end."""
        return self.walk.done(self.states[-1])

    @property
    def done(self) -> bool:
        """Whether the path is at its end, or there are too many rows, or it has lookahead ahead too far."""
        return self.arrived or len(self.states) > ROWS or self.walk.lookahead - self._lookahead > MOST_LOOKAHEAD

    def go(self, most: float, until: float = inf) -> None:
        """Go on for at least most periods, or until s is past until, or to the end."""
        first = len(self.states)
        while not self.done and len(self.states) - first < most and self.walk.s(self.states[-1]) < until:
            ahead = self.walk.run(self.states[-1], self._block, 1.0)
            through = bool(ahead) and (len(ahead) == self._block or self.walk.done(ahead[-1]))
            brake = self.brakes[0] if self.brakes else None
            begun = brake is not None and bool(ahead) and self.walk.s(ahead[-1]) >= brake.s
            if brake is not None and begun:
                ahead = ahead[: next(k for k, state in enumerate(ahead, 1) if self.walk.s(state) >= brake.s)]
                through = True
            if not (through and self.walk.unsafe_after(ahead[-1]) == inf):
                self._hold_back(ahead, known_bad=through)
                continue
            self.states += ahead
            self._block = min(2 * self._block, _LARGEST)
            if brake is not None and begun:
                slow = self.walk.run(self.states[-1], round(brake.seconds / self.walk.h), 0.0)
                self.states += slow
                self.braked += len(slow)
                del self.brakes[0]

    def _hold_back(self, ahead: list[State], *, known_bad: bool) -> None:
        """Keep what is safe of the states ahead, then the largest safe step, then what has to follow it.

        That is lazy steps for as long as the smallest unsafe step would have lasted: the coming corner binds so long.
        """
        self.states += ahead[: self._safe(ahead, known_bad)]
        state = self.states[-1]
        low, high, binds = 0.0, 1.0, 1.0
        best = self.walk.run(state, 1, 0.0)
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            tried = self.walk.run(state, 1, middle)
            lasts = self.walk.unsafe_after(tried[0]) if tried else 0.0
            if lasts == inf:
                low, best = middle, tried
            else:
                high, binds = middle, lasts
        slow = best + self.walk.run(best[-1], int(binds), 0.0)
        self.states += slow
        self.braked += len(slow)
        self._block = _BLOCK

    def _safe(self, ahead: list[State], known_bad: bool) -> int:
        """How many of the states ahead of a safe one may be kept, so that the last of them is safe."""
        low, high = 0, len(ahead) + (0 if known_bad else 1)
        while high - low > 1:
            middle = (low + high) // 2
            if self.walk.unsafe_after(ahead[middle - 1]) == inf:
                low = middle
            else:
                high = middle
        return low


def plan(walk: Walk, coarse: Walk | None, swings: float) -> tuple[list[State], int]:
    """States from the first row to the last, or to where it was given up, and how many periods were held back.

    It is given up after ROWS rows, or MOST_LOOKAHEAD periods of looking ahead.

    coarse: the same path with a longer period on which brakes are searched for, None where no axis swings. swings [s]:
    time constant of the axis that swings longest.
    """
    plain = _Advance(walk, walk.start())
    plain.go(inf)
    if coarse is None or not plain.arrived:
        return plain.states, plain.braked
    found = _Advance(walk, walk.start(), _brakes(coarse, swings))
    found.go(inf)
    best = found if found.arrived and len(found.states) < len(plain.states) else plain
    return best.states, best.braked


def _brakes(walk: Walk, swings: float) -> list[Brake]:
    """One brake before each waypoint where it saves time."""
    advance = _Advance(walk, walk.start())
    window = int(_WINDOW * swings / walk.h) + 1
    earlier = 0
    brakes: list[Brake] = []
    for row in sorted({leg.last for leg in walk.path.legs} - {0}):
        advance.go(inf, until=float(walk.path.s[row]))
        if walk.s(advance.states[-1]) < walk.path.s[row]:
            break  # given up
        advance.go(window)
        arrival = _arrival(advance.states, row, earlier)
        better = _best_brake(advance, earlier, arrival, row, window, swings)
        if better is not None:
            advance, brake = better
            brakes.append(brake)
        earlier = _arrival(advance.states, row, earlier)
    return brakes


def _best_brake(
    advance: _Advance, earlier: int, arrival: int, row: int, window: int, swings: float
) -> tuple[_Advance, Brake] | None:
    """The same walk with the best brake before the waypoint in path row, which it reaches in state arrival."""
    walk, states = advance.walk, advance.states
    first = max(earlier, arrival - window)
    while first > earlier and walk.unsafe_after(states[first]) < inf:
        first = max(earlier, first - _BACK)
    if walk.unsafe_after(states[first]) < inf:
        return None
    # Judged by how soon the equilibrium is as far as it is now at the window's end, or at the next waypoint.
    last = min(len(states) - 1, arrival + window)
    following = min((leg.last for leg in walk.path.legs if leg.last > row), default=row)
    goal = min(walk.s(states[last]), float(walk.path.s[following]))
    best = _reached(walk, states, first, goal)
    better: tuple[_Advance, Brake] | None = None
    found = (0.0, 0.0)

    def attempt(begin: float, lasts: float) -> bool:
        nonlocal best, better, found
        at = arrival - round(begin * swings / walk.h)
        brake = Brake(walk.s(states[max(at, 0)]), lasts * swings)
        if not first <= at <= arrival or round(brake.seconds / walk.h) < 1:
            return False
        tried = _Advance(walk, states[first], [brake])
        tried.go(best + 1, goal)
        if walk.s(tried.states[-1]) < goal:
            return False
        reached = _reached(walk, tried.states, 0, goal)
        if reached >= best - _WORTH:
            return False
        tried.states[:0] = states[:first]
        best, better, found = reached, (tried, brake), (begin, lasts)
        return True

    for begin in _BEGINS:
        for lasts in _LASTS:
            attempt(begin, lasts)
    step = 0.1
    while better is not None and step >= _FINEST:
        begin, lasts = found
        moves = ((step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step), (step, step), (-step, -step))
        if not any(attempt(begin + a, lasts + b) for a, b in moves):
            step /= 2
    return better


def _arrival(states: Sequence[State], row: int, first: int) -> int:
    return next(k for k in range(first, len(states)) if states[k].segment >= row)


def _reached(walk: Walk, states: Sequence[State], first: int, goal: float) -> float:
    """Periods from state first until s is at goal, fractions counted."""
    k = next(k for k in range(first, len(states)) if walk.s(states[k]) >= goal)
    if k == first:
        return 0.0
    before, after = walk.s(states[k - 1]), walk.s(states[k])
    return k - first - 1 + (goal - before) / (after - before)
