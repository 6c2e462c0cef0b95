"""Loops, when one that does not end by itself is over, and the steady cycle of one that never does.

A cycle is so many passes that end where they begin. What runs before it, the first pass included, is driven once. The
cycle begins and ends behind one and the same stop, the last of a pass that another pass has as well; where a loop has
no stop, behind its last point. A few more passes are run only to see whether they repeat.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import fields
from itertools import pairwise

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Motion, Move, MoveExtJ, Tool, Wait
from trajopt_cli.rapid.data.datatypes import DNUM, NUM, SIGNALS, Type, Value, is_number, single
from trajopt_cli.rapid.data.scope import Cycle, Datum, Exit, Passes, State
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import Expression, Name, Statement, While, walk
from trajopt_cli.warnings import WarningKind


def run_for(run: Context, node: syntax.For) -> None:
    """FOR: bounds evaluated once, a variable of its own that hides data of the same name as long as the loop runs.

    The step is added pass by pass and rounded to a num each time. ABB leaves open whether the last pass of a loop of
    decimals runs (RAPID reference manual, FOR, limitations), which is reported.
    """
    first, type_ = _bound(run, node.first)
    last, last_type = _bound(run, node.last)
    if last_type is DNUM:
        type_ = DNUM
    step = _bound(run, node.step)[0] if node.step else (1.0 if first <= last else -1.0)
    if step == 0:
        raise run.error(node, "FOR with STEP 0 never ends")
    if first % 1 or step % 1:
        what = f"FOR {node.name} counts in decimals: rounding may decide whether its last pass runs; use whole numbers"
        run.warn(WarningKind.UNUSUAL, what, run.source(node))
    local, key = run.frame.local, node.name.lower()
    hidden, outer = local.get(key), run.frame.counters
    passes, value = 0, first
    try:
        while value <= last if step > 0 else value >= last:
            passes += 1
            count_pass(run, node, passes)
            local[key] = Datum(type_, Value(type_, value), "a loop variable", "CONST")
            run.frame.counters = (*outer, value)
            run.block(node.body)
            value = single(value + step) if type_ is NUM else value + step
    finally:
        run.frame.counters = outer
        if hidden is None:
            local.pop(key, None)
        else:
            local[key] = hidden


def _bound(run: Context, node: Expression) -> tuple[float, Type]:
    value = run.evaluate(node)
    if not is_number(value.type):
        raise run.mismatch(node, NUM, value).about(node, "a bound of FOR")
    return float(value.data), value.type


def run_while(run: Context, node: While) -> None:
    """WHILE; one whose condition is always true, or nothing can change, runs as often as the scenario says."""
    if always(run, node.condition, unchanged(run, node)):
        loop = f"WHILE {run.text(node.condition)}"
        exits, passes, counted = leaves(node.body), 0, 0
        while True:
            motions = len(run.motions)
            run.block(node.body)
            passes += 1
            counted = count_endless(run, node, loop, exits, passes, counted, motions)
    passes, counted, asks = 0, 0, asks_signals(run, node.condition)
    while run.condition(node.condition):
        passes, motions = passes + 1, len(run.motions)
        count_pass(run, node, passes)
        run.block(node.body)
        if asks:
            loop = f"WHILE {run.text(node.condition)}"
            counted = count_endless(run, node, loop, True, passes, counted, motions, ends=True)


def backwards(run: Context, node: syntax.Goto, body: Sequence[Statement]) -> None:
    """Count a GOTO to a label before it; body: from the label to the statement that holds the GOTO."""
    seen = run.frame.passes
    passes = seen[id(node)] = seen.get(id(node), 0) + 1
    ends = body[-1] is not node  # under a condition
    if ends and not (isinstance(body[-1], syntax.If) and asks_signals(run, *(test for test, _ in body[-1].branches))):
        return count_pass(run, node, passes)
    # The motions of the pass that ends here: those since the last time, or all of the run's for the first pass.
    key = -id(node)
    motions, counted = run.frame.turns.get(key, (run.frame.motions, 0))
    exits = ends or leaves(body[:-1])
    counted = count_endless(run, node, f"GOTO {node.label}", exits, passes, counted, motions, ends)
    run.frame.turns[key] = (len(run.motions), counted)


def count_pass(run: Context, node: Statement, passes: int) -> None:
    """Give up a loop that goes on and on; each pass is charged as a statement. Raises InputError."""
    run.budget -= 1
    if run.budget < 0:
        raise run.exhausted(node)
    if passes > run.scenario.pass_limit:
        raise _too_many(run, node)


def _too_many(run: Context, node: Statement) -> InputError:
    message = f"the loop has not ended after {run.scenario.pass_limit} passes (pass_limit); "
    signals, data = _reads(run, node.condition) if isinstance(node, While) else ([], {})
    values = {name: text for name, one in data.items() if (text := _plain(one.value.data))}
    if signals:
        message += f"its condition reads {', '.join(signals)}: give a sequence of values that ends it under signals"
    elif values:
        now = " and ".join(f"{name}, which is {value}" for name, value in values.items())
        message += f"its condition reads {now}: see what should change {'it' if len(values) == 1 else 'them'}"
    else:
        message += "give values that end it (signals, data, answers)"
    return run.error(node, f"{message}, or raise pass_limit in the cell file")


def _reads(run: Context, *conditions: Expression) -> tuple[list[str], dict[str, Datum]]:
    """The names that conditions read: signals, and data that may change; each once, as spelled. No value is asked for:
    what the cell file gives in turn is used up by that."""
    signals: dict[str, None] = {}
    data: dict[str, Datum] = {}
    for node in walk(conditions):
        if not isinstance(node, Name):
            continue
        place = run.find(node.name)
        if place is None or (isinstance(place, Datum) and place.type.name in SIGNALS):
            signals[node.name] = None
        elif isinstance(place, Datum) and place.constant is None:
            data[node.name] = place
    return [*signals], data


def _plain(data: object) -> str:
    """A truth value or a number as RAPID writes it; "" for anything else."""
    if isinstance(data, bool):
        return "TRUE" if data else "FALSE"
    return f"{data:.6g}" if isinstance(data, float) else ""


def count_endless(
    run: Context, node: Statement, loop: str, exits: bool, passes: int, counted: int, motions: int, ends: bool = False
) -> int:
    """Count a pass of a loop without a condition, and end the program where enough of them ran. ends: it has one, which
    only signals decide.

    A loop that has a way out (RETURN, EXIT ...) may be a search through data: only its passes that move count, and
    without a number in the scenario it runs until it takes its way out. motions: how many there were before the pass.
    Returns how many passes counted so far. Raises Exit.
    """
    if exits and len(run.motions) == motions:
        count_pass(run, node, passes)
        return counted
    if not counted:
        leaves = exits and (ends or run.scenario.endless_passes is None)
        run.endless[id(node)] = Passes(loop, run.source(node), [motions], leaves)
    known = run.endless[id(node)]
    if add_pass(run, known):
        known.leaves = False
        raise Exit
    return counted + 1


def asks_signals(run: Context, *conditions: Expression) -> bool:
    """Whether conditions read signals and nothing that the program changes."""
    signals, data = _reads(run, *conditions)
    return bool(signals) and not data


def always(run: Context, node: Expression, kept: Collection[str] = ()) -> bool:
    """Whether a condition is TRUE whatever happens: made of literals, constants, and variables that nobody changes.

    kept: these variables, in lower case.
    """
    return _constant(run, node, kept) and run.condition(node)


def never(run: Context, node: Expression) -> bool:
    """Whether a condition is FALSE whatever happens: made of literals and constants."""
    return _constant(run, node) and not run.condition(node)


def _named_in(routine: syntax.Routine) -> tuple[frozenset[str], Counter[str]]:
    """What a routine declares, and how often it names anything; in lower case."""
    declared: set[str] = set()
    used: Counter[str] = Counter()
    for node in walk((routine.body, routine.handlers)):
        name = getattr(node, "name", None)
        if isinstance(name, str):
            if isinstance(node, syntax.DataDeclaration):
                declared.add(name.lower())
            else:
                used[name.lower()] += 1
    return frozenset(declared), used


def unchanged(run: Context, loop: While) -> frozenset[str]:
    """The variables of the routine that runs, in lower case, that it names nowhere but in a loop's condition."""
    found = run.unchanged.get(id(loop))
    if found is None:
        routine = run.frame.routine
        if routine is None:
            return frozenset()
        if id(routine) not in run.named:
            run.named[id(routine)] = _named_in(routine)
        declared, used = run.named[id(routine)]
        names = (getattr(node, "name", None) for node in walk(loop.condition))
        read = Counter(name.lower() for name in names if isinstance(name, str))
        found = frozenset(name for name, times in read.items() if name in declared and used[name] == times)
        run.unchanged[id(loop)] = found
    return found


def _constant(run: Context, node: Expression, kept: Collection[str] = ()) -> bool:
    def holds(name: Name) -> bool:
        place = run.find(name.name)
        return isinstance(place, Datum) and (place.declared_constant or name.name.lower() in kept)

    return syntax.steady(node, holds)


def leaves(block: Sequence[Statement]) -> bool:
    """Whether a loop's body holds a way out: RETURN, EXIT, RAISE, ExitCycle, or a GOTO to a label outside."""
    labels: set[str] = set()
    jumps: set[str] = set()
    stack = list(block)
    while stack:
        node = stack.pop()
        if isinstance(node, (syntax.Return, syntax.Raise)) or (isinstance(node, syntax.Simple) and node.word == "EXIT"):
            return True
        if isinstance(node, syntax.ProcedureCall) and node.name.lower() == "exitcycle":
            return True
        if isinstance(node, syntax.Label):
            labels.add(node.name.lower())
        elif isinstance(node, syntax.Goto):
            jumps.add(node.label.lower())
        elif isinstance(node, (syntax.For, While)):
            stack += node.body
        elif isinstance(node, syntax.If):
            stack += [inner for _, body in node.branches for inner in body] + list(node.otherwise)
        elif isinstance(node, syntax.Test):
            stack += [inner for _, body in node.cases for inner in body] + list(node.default or ())
    return not jumps <= labels


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
