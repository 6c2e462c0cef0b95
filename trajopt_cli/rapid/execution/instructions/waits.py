r"""Waits.

A wait always comes true, after the least time that the scenario gives it; what it waited for then holds (see World) of
signals, flags and counters. Parts of targets and other records stay as they are: a wait makes up no positions.
Where the scenario says `timeout`, a wait with \MaxTime lasts that long, and sets \TimeFlag or raises ERR_WAIT_MAXTIME.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import takewhile
from typing import Any

from trajopt_cli.motion import Hold, Move, Wait, Written
from trajopt_cli.rapid.data.datatypes import BOOL, NUM, SIGNALS, STRING, Atomic, Data, Type, Value
from trajopt_cli.rapid.data.scope import ExternalDatum, Place
from trajopt_cli.rapid.execution import external_data
from trajopt_cli.rapid.execution.answers import root
from trajopt_cli.rapid.execution.arguments import Effect, Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.loops import never
from trajopt_cli.rapid.execution.operators import COMPARE
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import Binary, Call, Expression, Name, ProcedureCall, Unary
from trajopt_cli.scenario import LONGEST_WAIT, condition_key, yaml_name
from trajopt_cli.warnings import WarningKind

_TOPIC = Topic(__doc__)


def record(
    run: Context, node: ProcedureCall | Call, duration: float, condition: str | None = None, in_position: bool = False,
    names: Iterable[str] = (),
) -> None:  # fmt: skip
    """Stand still, or wait beside the move before it (\\Conc); see motion.Wait. names: of it in the cell file."""
    if in_position:
        run.concurrent = 0
    if duration or condition is not None or in_position:  # WaitTime 0 waits for nothing
        run.settle_stop(in_position)
    span = run.places().span(node.start, node.end)
    written = Written(statement=span, target=span if isinstance(node, Call) else None, counters=run.frame.counters)
    made = Wait(
        source=run.source(node),
        written=written,
        duration=duration,
        condition=condition,
        in_position=in_position,
        hold=Hold.SYNCHRONISED if run.settings.synchronised else None,
        beside=duration if run.concurrent else None,
    )
    run.waited[len(run.motions)] = frozenset(map(condition_key, names))
    run.motions.append(made)


_HALTS = frozenset(  # the robot stands for them, whatever runs beside a move
    ("Break", "SetLeadThrough", "Stop", "StopMove", "StorePath", "SyncMoveOff", "SyncMoveOn", "SystemStopAction")
)


def hold_up(run: Context, node: ProcedureCall | Call, name: str) -> None:
    """A wait in an instruction or a function that is none by itself (Effect.STOPS); its name is the wait's. Where the
    robot stands for it already, as in a loop that reads a file, no time more is no wait more."""
    least = run.external.least(name)
    if least is None:
        what = f"{name} cannot time out here, only waits for signals and conditions can; give it a least time"
        raise run.error(node, f"{what}: 'waits: {{{name}: 0}}'")
    standing = takewhile(lambda motion: not isinstance(motion, Move), reversed(run.motions))
    if least or not any(isinstance(one, Wait) and one.condition == name for one in standing):
        record(run, node, least, name, name in _HALTS, (name,))


# ------------------------------------------------------------------------------------------------- time, standstill


@_TOPIC.instruction(Effect.WAITS, r"WaitTime Time:num \InPos")
def _wait_time(run: Context, node: ProcedureCall, seconds: float, inpos: bool = False) -> None:
    if not seconds >= 0:
        raise Refused(f"WaitTime {seconds:.6g} s must not be negative", "Time")
    if seconds > LONGEST_WAIT:
        raise Refused(f"WaitTime {seconds:.6g} s: more than {LONGEST_WAIT:,} s (11 days); check the value", "Time")
    record(run, node, seconds, in_position=inpos)


@_TOPIC.instruction(Effect.WAITS, r"WaitRob \InPos \ZeroSpeed")
def _wait_robot(run: Context, node: ProcedureCall, **standing: bool) -> None:
    if standing:
        record(run, node, 0.0, in_position=True)
    else:
        run.ignored["WaitRob"] += 1


# ---------------------------------------------------------------------------------------------------------- signals

_SWITCHES = {"lt": "<", "gt": ">", "noteq": "<>"}
TIMEOUT = r"\MaxTime:num \TimeFlag:expr"
_SHOWN = rf"{TIMEOUT} \Visualize \Header \Message"
_SIGNAL = rf"Signal Value:num {_SHOWN} \ValueAtTimeout"


@_TOPIC.instruction(
    Effect.WAITS,
    *(f"{name} {_SIGNAL}" for name in ("WaitDI", "WaitDO")),
    *(rf"{name} {_SIGNAL} \NOTEQ \LT \GT" for name in ("WaitGI", "WaitGO")),
    *(rf"{name} {_SIGNAL} \LT \GT" for name in ("WaitAI", "WaitAO")),
)
def _wait_signal(run: Context, node: ProcedureCall, argument: Expression, wanted: float, **options: Any) -> None:
    signal = run.signal(argument)
    if node.name.lower() in ("waitdi", "waitdo"):
        run.check_digital(argument, signal)
    test = next((_SWITCHES[name] for name in _SWITCHES if name in options), "=")
    text = f"{test} {wanted:.15g}"
    shown = f"{run.text(argument)} {text}"
    if _over(run, node, shown, (shown, f"{signal} {text}", signal), **options):
        _await(run, node, signal, test, wanted)


def _await(run: Context, node: ProcedureCall, signal: str, test: str, wanted: float) -> None:
    fits = COMPARE[test]
    left = run.external.awaited(signal, lambda value: fits(value, wanted), wanted if test == "=" else None)
    if left:
        values = ", ".join(f"{value:.15g}" for value in left[:7]) + (", ..." if len(left) > 7 else "")
        raise run.error(
            node,
            f"{node.name} waits for {signal} {test} {wanted:.15g}, and none of the values left in its sequence fits "
            f"({values}); add one to signals.{signal} in the cell file, or let the wait end by its time: "
            f"'waits: {{{signal} {test} {wanted:.15g}: timeout}}'",
        )


def _over(
    run: Context,
    node: ProcedureCall,
    shown: str,
    names: tuple[str, ...],
    possible: bool = True,
    *,
    maxtime: float | None = None,
    timeout: float | None = None,
    timeflag: Expression | None = None,
    inpos: bool = False,
    **_: bool,
) -> bool:
    r"""Record a wait and say whether it came true; if not, \TimeFlag is set.

    names: of the wait in the cell file. possible: whether it can come true at all.
    """
    longest = timeout if maxtime is None else maxtime
    if longest is not None and longest > LONGEST_WAIT:
        raise run.error(node, f"\\MaxTime of {longest:.6g} s: more than {LONGEST_WAIT:,} s (11 days); check the value")
    least = run.external.least(*names) if possible else None
    if not possible and longest is None:
        raise run.error(node, f"waits for {shown}: this condition can never come true, and \\MaxTime is not given")
    record(run, node, (longest or 0.0) if least is None else least, shown, inpos, names)
    if least is not None:
        if timeflag is not None:
            run.assign(timeflag, Value(BOOL, False))
        return True
    if longest is None:
        raise run.error(node, f"waits for {shown} forever: the cell file says timeout, and \\MaxTime is not given")
    if timeflag is None:
        error = "ERR_WAIT_MAXTIME" if timeout is None else "ERR_WAITSYNCTASK"
        raise run.fault(node, error, f"{shown} has not come true within \\MaxTime of {longest:.6g} s")
    run.assign(timeflag, Value(BOOL, True))
    return False


# ------------------------------------------------------------------------------------------------------- conditions


@_TOPIC.instruction(Effect.WAITS, rf"WaitUntil Cond \InPos {_SHOWN} \PollRate")
def _wait_until(run: Context, node: ProcedureCall, wanted: Expression, **options: Any) -> None:
    shown = run.text(wanted)
    names = {name.lower() for name in _names(wanted)}
    terms = _terms(run, wanted)
    possible = not (never(run, wanted) or _contradictory(run, terms or []))
    if not _over(run, node, shown, (shown, *(names if len(names) == 1 else ())), possible, **options):
        return
    if _unanswered(run, wanted, BOOL):
        return
    if _from_outside(run, node, wanted, terms, shown) or terms is None:
        return
    for term in terms:
        if term.signal is not None:
            _await(run, node, term.signal, "=", term.value.data)
        else:
            _assume(run, node, term, shown)


def _from_outside(run: Context, node: ProcedureCall, wanted: Expression, terms: list[_Term] | None, shown: str) -> bool:
    """Let what the condition reads come from outside as the cell file says, or ask for it; whether it holds then."""

    def holds() -> bool:
        return run.external.poll(lambda: run.condition(wanted))

    parts = [part for part in _parts(run, wanted) if isinstance(run.locate(part).type, Atomic)]
    given = [place for name in dict.fromkeys(root(run, part).lower() for part in parts) if (place := _given(run, name))]
    if not given:
        if terms is None and not holds():
            external_data.ask(run, node, parts, _unknown(run, wanted), _values(run, wanted, parts), shown, holds)
        return False
    if external_data.awaited(run, given, holds):
        return True
    if terms is None or any(isinstance(run.scenario.data[one.name].value, tuple) for one in given):
        names = ", ".join(one.name for one in given)
        raise run.error(
            node,
            f"{node.name} waits for {shown}, and none of the values that the cell file has left for {names} makes it "
            f"true; add one under data, or let the wait end by its time: 'waits: {{{yaml_name(shown)}: timeout}}'",
        )
    return False


def _given(run: Context, name: str) -> ExternalDatum | None:
    place = run.find(name)
    return place if isinstance(place, ExternalDatum) and run.external.gives(place.name) else None


def _parts(run: Context, node: Expression) -> Iterator[Expression]:
    """The data in a condition that the program may change, each part as written."""
    if isinstance(node, Name | syntax.Component | syntax.Element):
        if _variable(run, node) is not None:
            yield node
    else:
        for one in _operands(node):
            yield from _parts(run, one)


def _operands(node: Expression) -> list[Expression]:
    match node:
        case Binary():
            return [node.left, node.right]
        case Unary():
            return [node.operand]
        case Call():
            return [arg.value for arg in node.args if arg.value is not None]
    return []


def _unanswered(run: Context, node: Expression, type_: Type) -> bool:
    """Whether a condition calls functions that nobody knows or answers for: they lack, each in the type that its place
    has."""
    if isinstance(node, Call) and not run.knows(node.name):
        if run.external.known(node.name):
            return False
        run.call_function(node, type_)
        return True
    if isinstance(node, Binary) and node.operator not in ("AND", "OR", "XOR"):
        sides = ((node.left, node.right), (node.right, node.left))
        return any([_unanswered(run, one, _kind(run, other)) for one, other in sides])
    return any([_unanswered(run, one, NUM if isinstance(node, Call) else BOOL) for one in _operands(node)])


def _kind(run: Context, node: Expression) -> Type:
    """The type of what a function is held against; a number's where only a run tells."""
    if isinstance(node, syntax.Boolean):
        return BOOL
    return STRING if isinstance(node, syntax.String) else _variable(run, node) or NUM


def _unknown(run: Context, node: Expression) -> list[Name]:
    """The names in a condition that nothing declares."""
    if isinstance(node, Name):
        return [node] if run.find(node.name) is None else []
    return [name for one in _operands(node) for name in _unknown(run, one)]


def _values(run: Context, wanted: Expression, parts: list[Expression]) -> list[Data]:
    """Values to try for data of a condition: what it is held against, and a little more or less."""
    held = [node.value for node in syntax.walk(wanted) if isinstance(node, syntax.Number | syntax.String)]
    held += [run.locate(part).value.data for part in parts]
    numbers = [float(value) for value in held if isinstance(value, float)]
    near = [value + step for step in (0.0, 1.0, -1.0) for value in numbers]
    return [True, False, 1.0, 0.0, *near, *(value for value in (*held, "1") if isinstance(value, str))]


def _contradictory(run: Context, terms: list[_Term]) -> bool:
    """Whether a conjunction asks one signal or variable for two values."""
    values: dict[str, Data] = {}
    for term in terms:
        key = term.signal or condition_key(run.text(term.target))
        if values.setdefault(key, term.value.data) != term.value.data:
            return True
    return False


def _assume(run: Context, node: ProcedureCall, term: _Term, shown: str) -> None:
    """Let a variable have the value that was waited for, where it is a flag or a counter."""
    place = run.locate(term.target)
    if place.value.data == term.value.data:
        return
    counter = isinstance(term.target, Name) and isinstance(place.type, Atomic)
    flag = isinstance(term.target, syntax.Element) and isinstance(term.target.base, Name) and place.type is BOOL
    if counter or flag:
        run.assign(term.target, term.value)
        return
    name = root(run, term.target)
    run.warn(WarningKind.ASSUMED, f"{node.name} {shown} is taken to come true; {name} is not changed", run.source(node))


@dataclass(frozen=True)
class _Term:
    """`target = value` of a conjunction; signal: the target's name in lower case where it is one."""

    target: Expression
    value: Value
    signal: str | None = None


def _terms(run: Context, node: Expression) -> list[_Term] | None:
    """The parts of a plain conjunction of `signal = value`, TestDI(signal), `variable = constant` and `flag`."""
    match node:
        case Binary(operator="AND"):
            left, right = _terms(run, node.left), _terms(run, node.right)
            return None if left is None or right is None else left + right
        case Binary(operator="="):
            return _equal(run, node.left, node.right)
        case Unary(operator="NOT"):
            return _true(run, node.operand, False)
    return _true(run, node, True)


_READERS = frozenset({"dinput", "doutput", "ginput", "goutput", "ainput", "aoutput"})


def _true(run: Context, node: Expression, wanted: bool) -> list[_Term] | None:
    if isinstance(node, Call):
        signal = _argument(node, frozenset({"testdi"}))
        return [_Term(signal, Value(NUM, float(wanted)), run.signal(signal))] if signal else None
    return [_Term(node, Value(BOOL, wanted))] if _variable(run, node) == BOOL else None


def _equal(run: Context, left: Expression, right: Expression) -> list[_Term] | None:
    variable = _variable(run, left)
    if variable is not None:
        return [_Term(left, run.evaluate(right, variable))] if _steady(run, right, constant=True) else None
    signal = _argument(left, _READERS) if isinstance(left, Call) else left
    if not isinstance(signal, Name) or not _is_signal(run, signal) or not _steady(run, right, constant=False):
        return None
    return [_Term(signal, Value(NUM, run.number(right)), run.signal(signal))]


def _argument(call: Call, functions: frozenset[str]) -> Expression | None:
    """`signal` of DInput(signal) ..."""
    return call.args[0].value if call.name.lower() in functions and len(call.args) == 1 else None


def _variable(run: Context, node: Expression) -> Type | None:
    """The type of data that the program may change; None for anything else."""
    base = syntax.base_of(node)
    if not isinstance(base, Name) or not isinstance(run.find(base.name), Place) or _is_signal(run, base):
        return None
    place = run.locate(node)
    return None if place.constant else place.type


def _is_signal(run: Context, node: Name) -> bool:
    place = run.find(node.name)
    return place is None or (isinstance(place, Place) and place.type.name in SIGNALS)


def _steady(run: Context, node: Expression, constant: bool) -> bool:
    """Whether an expression has one value during the wait: no signal in it, no call, only constants if wanted."""

    def holds(name: Name) -> bool:
        place = run.find(name.name)
        return isinstance(place, Place) and not _is_signal(run, name) and bool(place.constant or not constant)

    return syntax.steady(node, holds)


def _names(node: Expression) -> list[str]:
    return [node.name] if isinstance(node, Name) else [name for one in _operands(node) for name in _names(one)]


# -------------------------------------------------------------------------------------------------- the other waits


@_TOPIC.instruction(Effect.WAITS, "WaitTestAndSet Object")
def _test_and_set(run: Context, node: ProcedureCall, flag: Expression) -> None:
    """Waits until a flag that tasks share is FALSE, and sets it."""
    shown = f"{run.text(flag)} = FALSE"
    _over(run, node, shown, (shown, run.text(flag)))
    run.assign(flag, Value(BOOL, True))


def wait_for(run: Context, node: ProcedureCall, shown: str, name: str, **options: Any) -> None:
    """Record a wait for something that only the cell knows; name: of it in the cell file, as shown is."""
    _over(run, node, shown, (shown, name), **options)


@_TOPIC.instruction(Effect.WAITS, rf"WaitSyncTask SyncID TaskList \InPos \TimeOut:num {TIMEOUT}")
def _sync_task(run: Context, node: ProcedureCall, sync: Expression, _: Expression, **options: Any) -> None:
    """Until the other tasks have come to the same point."""
    wait_for(run, node, f"WaitSyncTask {run.text(sync)}", run.text(sync), **options)
