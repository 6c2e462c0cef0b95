"""Loops, and when one that does not end by itself is over."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import DNUM, NUM, SIGNALS, Type, Value, is_number, single
from trajopt_cli.rapid.data.scope import Datum, Exit, Passes
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.endless import add_pass
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
