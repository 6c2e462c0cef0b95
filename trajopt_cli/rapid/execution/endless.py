"""The steady cycle of a loop that never ends: so many passes that end where they begin.

What runs before it, the first pass included, is driven once. The cycle begins and ends behind one and the same stop,
the last of a pass that another pass has as well; where a loop has no stop, behind its last point. A few more passes are
run only to see whether they repeat.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import fields
from itertools import pairwise

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Motion, Move, MoveExtJ, Tool, Wait
from trajopt_cli.rapid.data.scope import Cycle, Passes, State
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.warnings import WarningKind

_SEEN = 26  # passes that are run at most to see whether they repeat: enough for a period of twelve
_MOTIONS = 4000  # in them, beyond which no pass is run behind the cycle
_UNLEFT = 200  # passes after which a loop with a way out whose passes repeat is taken as one that never takes it


def add_pass(run: Context, passes: Passes) -> bool:
    """A pass is over. Whether it was the last one, as enough of them ran."""
    passes.count += 1
    wanted, motions = run.scenario.endless_passes or 1, len(run.motions)
    if passes.count <= max(_SEEN, wanted + 2):
        sizes = motions, len(run.warnings), len(run.external.missing), len(run.refusals)
        counts = dict(run.counts) if passes.count <= _SEEN or passes.count >= wanted else {}
        passes.ends.append(State(*sizes, counts, Counter(run.ignored)))
        passes.marks.append(motions)
    many = motions - passes.marks[0] > _MOTIONS
    if passes.leaves:
        if passes.count == _SEEN:
            run.position.place()
            passes.repeats = _period([_key(motion) for motion in run.motions], passes.marks) is not None
        return passes.repeats and passes.count >= _UNLEFT
    return passes.count > wanted and (many or passes.count >= max(_SEEN, wanted + 2))


def cycle_of(run: Context, passes: Passes, failure: InputError | None = None) -> Cycle:
    """The cycle of a loop that never ends, whose passes behind it leave no trace; what is planned is told. Where no
    number of passes ends where it began, all that ran up to the end of the passes that are wanted, not closed.
    failure: of a pass behind the cycle."""
    wanted, motions, marks = run.scenario.endless_passes, run.motions, passes.marks
    keys = [_key(motion) for motion in motions[: marks[-1]]]
    counts = [count for count in ((wanted,) if wanted else range(1, len(passes.ends))) if count < len(passes.ends)]
    stops = any(_stops(motions, k) for k in range(*marks[:2]))
    found = (_closed(motions, keys, marks, count, stops) for count in counts)
    cycle = next((one for one in found if one is not None), None)
    count = cycle.passes if cycle else min(wanted or 1, len(passes.ends))
    end, whole = passes.ends[count - (cycle is None)], passes.ends[count - 1]
    run.warnings = dict([*run.warnings.items()][: end.warnings])
    run.external.missing = dict([*run.external.missing.items()][: end.missing])
    run.refusals = dict([*run.refusals.items()][: end.refusals])
    before = passes.ends[0].counts if cycle else {}
    run.ignored = whole.ignored
    run.counts = {node: often - before.get(node, 0) or often for node, often in end.counts.items()}
    period = _period(keys, marks)
    told = "; ".join(_told(motions, cycle, count, period, len(passes.ends)))
    if not any(isinstance(motion, Move) for motion in motions[marks[0] : end.motions]):
        told = "it moves nothing"
    if failure is not None:
        told += f"; pass {passes.count + 1} cannot be run: {failure}"
    run.warn(WarningKind.ENDLESS, f"{passes.loop} never ends by itself: {told}", passes.source)
    if cycle is None:
        return Cycle(0, end.motions, count, closed=False)
    return cycle._replace(beyond=marks[period + 1] if period and count % period else cycle.last)


def _told(motions: Sequence[Motion], cycle: Cycle | None, count: int, period: int | None, seen: int) -> Iterator[str]:
    """What is planned of a loop, and what of it is not."""
    if cycle is None:
        many = "one pass is" if count == 1 else f"{count} passes are"
        yield f"{many} planned from the start pose on, without a way back, as no pass seen ends where another one does"
    elif count == 1:
        yield "one pass in steady state is planned; it ends where it begins"
    else:
        yield f"{count} passes in steady state are planned, which end where they begin"
    if cycle is not None and not _stops(motions, max(k for k in range(cycle.last) if isinstance(motions[k], Move))):
        yield "none of its points is a stop, and the plan stops at the last one"
    if period is None:
        yield f"its passes differ and do not repeat within {seen}"
    elif count % period:
        yield f"its passes differ and repeat after {period}: 'endless_passes: {period}' covers all of them"


def _closed(
    motions: Sequence[Motion], keys: Sequence[object], marks: Sequence[int], count: int, stop: bool
) -> Cycle | None:
    """So many passes behind the last point of the first pass at which they end as well; stop: it must be a stop."""
    begin, end, last = marks[1], marks[count], marks[count + 1]
    for j in range(last - 1, end - 1, -1):
        if not isinstance(motions[j], Move) or isinstance(motions[j], MoveExtJ) or (stop and not _stops(motions, j)):
            continue
        alike = [i for i in range(marks[0], begin) if keys[i] == keys[j]]
        if alike:
            first = begin - (last - j) if begin - (last - j) in alike else alike[-1]
            return Cycle(_behind(motions, first, begin), _behind(motions, j, last), count)
    return None


def _behind(motions: Sequence[Motion], at: int, end: int) -> int:
    """Where the next move behind one begins, or its pass ends."""
    return next((k for k in range(at + 1, end) if isinstance(motions[k], Move)), end)


def _stops(motions: Sequence[Motion], at: int) -> bool:
    """Whether a move ends at a stop, as it says or as a wait behind it does."""
    move = motions[at]
    if isinstance(move, Move) and move.zone.stop:
        return True
    for k in range(at + 1, len(motions)):
        motion = motions[k]
        if isinstance(motion, Move):
            return False
        if isinstance(motion, Wait) and motion.stops and motion.beside is None:
            return True
    return False


def _period(keys: Sequence[object], marks: Sequence[int]) -> int | None:
    """After how many passes they repeat, from the second one on; None where that is not seen."""
    every = [keys[a:b] for a, b in pairwise(marks[1:])]
    tried = range(1, max(len(every) // 2, 1) + 1)
    return next((n for n in tried if all(one == other for one, other in zip(every, every[n:], strict=False))), None)


def _key(motion: Motion) -> tuple[object, ...]:
    """Equal for two runs of one statement that ask for the same."""
    names = (field.name for field in fields(motion) if field.name != "written")
    return motion.written.statement, *(_digits(getattr(motion, name)) for name in names)


def _digits(value: object) -> object:
    if isinstance(value, np.ndarray):
        return (np.round(value, 9) + 0.0).tobytes()  # -0 is 0
    return (value.name, _digits(value.X_FT)) if isinstance(value, Tool) else value
