"""The interpreter: runs a program's entry procedure once, statement by statement, and keeps what its motions come from.

What expressions and calls do is in evaluate.py and calls.py; what instructions and functions do is in the files of
table.py, whose handlers take a Context and know no interpreter.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

from trajopt_cli.errors import InputError
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.rapid.data.datatypes import NUM, STRING, Array, Value, convertible, is_opaque
from trajopt_cli.rapid.data.scope import (
    CallFrame,
    Exit,
    Fault,
    Jump,
    Mismatch,
    ModuleScope,
    Part,
    Place,
    Retry,
    Return,
    TryNext,
    Undeclared,
)
from trajopt_cli.rapid.execution import calls, external_data
from trajopt_cli.rapid.execution import evaluate as expressions
from trajopt_cli.rapid.execution.calls import procedure
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import count_rests
from trajopt_cli.rapid.execution.evaluate import inside_opaque
from trajopt_cli.rapid.execution.faults import Handled, handle, passed_on, raise_error
from trajopt_cli.rapid.execution.instructions.processes import set_speed
from trajopt_cli.rapid.execution.instructions.settings import publish
from trajopt_cli.rapid.execution.loading import declare
from trajopt_cli.rapid.execution.loops import backwards, cycle_of, run_for, run_while
from trajopt_cli.rapid.execution.operators import computed
from trajopt_cli.rapid.execution.recursion_limit import room
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import Expression, Routine, walk
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind

_LONG = 64  # characters that are charged as one more statement


def run_block(run: Context, block: syntax.Block) -> None:
    """Run statements in order; where one fails or jumps, go on where the program says."""
    outer, file, counts = run.link, run.file, run.counts
    count, i = len(block), 0
    while i < count:
        try:
            while i < count:
                node = block[i]
                i += 1
                key = id(node)
                counts[key] = counts.get(key, 0) + 1
                run.budget -= 1
                if run.budget < 0:
                    raise run.exhausted(node)
                run.link = (node, outer, file)
                _STATEMENTS[type(node)](run, node)
        except Jump as jump:
            landing = _labels(run, block).get(jump.node.label.lower())
            if landing is None:
                raise
            if landing < i:
                backwards(run, jump.node, block[landing:i])
            i = landing
        except Fault as fault:
            run.link = outer
            handled = handle(run, fault, block[i - 1])
            if handled is Handled.PASSED:
                raise
            if handled is Handled.AGAIN:
                i -= 1
        except RecursionError:
            raise run.error(block[i - 1], "calls and expressions are nested too deeply to be run") from None
    run.link = outer


def _labels(run: Context, block: syntax.Block) -> dict[str, int]:
    """The labels of a block, with where they stand in it."""
    found = run.labels.get(id(block))
    if found is None:
        found = {node.name.lower(): i for i, node in enumerate(block) if isinstance(node, syntax.Label)}
        run.labels[id(block)] = found
    return found


def _assign(run: Context, node: syntax.Assign) -> None:
    target = node.target
    run.budget -= (node.end - node.start) // _LONG  # a long expression takes as long as many statements
    if type(target) is not syntax.Name and inside_opaque(run, target):
        if set_speed(run, target, node.value):
            return
        what = f"{run.text(target)} is process data, which does not affect the motion"
        run.note("opaque", WarningKind.NO_EFFECT, what, node)
        return
    try:
        place = run.locate(target)
    except Undeclared:
        if type(target) is not syntax.Name:
            raise
        return _assign_undeclared(run, node, target)
    try:
        value = run.evaluate(node.value, place.type)
    except Mismatch as error:
        raise error.about(node.value, run.text(target)) from None
    run.store(place, target, value)


def _assign_undeclared(run: Context, node: syntax.Assign, target: syntax.Name) -> None:
    """What is assigned tells the type; a name that is counted up is a number."""
    if isinstance(node.value, syntax.Aggregate):
        raise run.undeclared(target)
    counted = any(isinstance(one, syntax.Name) and one.name.lower() == target.name.lower() for one in walk(node.value))
    value = None if counted else run.evaluate(node.value)
    place = external_data.assigned(run, target, NUM if value is None else value.type)
    run.store(place, target, run.evaluate(node.value, NUM) if value is None else value)


def _if(run: Context, node: syntax.If) -> None:
    for test, block in node.branches:
        if run.condition(test):
            return run_block(run, block)
    if node.otherwise:
        run_block(run, node.otherwise)


def _test(run: Context, node: syntax.Test) -> None:
    subject = run.evaluate(node.subject)
    for values, block in node.cases:
        for value in values:
            try:
                same = run.evaluate(value, subject.type).data == subject.data
            except Mismatch as error:
                raise error.about(value, f"a CASE of {run.text(node.subject)}") from None
            if same:
                return run_block(run, block)
    if node.default is not None:
        run_block(run, node.default)


def _declare(run: Context, node: syntax.DataDeclaration) -> None:
    if node.storage == "PERS":
        raise run.error(node, f"PERS {node.name} stands in a routine; PERS data belongs to a module")
    key = node.name.lower()
    before = run.frame.local.get(key)
    if before is not None and key in run.frame.given:
        raise run.error(node, f"'{node.name}' is a parameter of the routine already; rename one of them")
    datum = declare(run, node, run.frame)
    run.budget -= (node.end - node.start) // _LONG
    if node.sizes:
        run.spend(node, datum.type.size)
    _ = datum.value
    run.frame.local[key] = datum


def _return(run: Context, node: syntax.Return) -> None:
    wanted = run.frame.returns
    if (wanted is None) != (node.value is None):
        raise run.error(node, "RETURN needs a value in a FUNC" if wanted else "RETURN with a value outside a FUNC")
    if node.value is None:
        raise Return(None)
    try:
        value = run.evaluate(node.value, wanted)
    except Mismatch as error:
        name = run.frame.routine.name if run.frame.routine else ""
        raise error.about(node.value, f"RETURN of {name}") from None
    raise Return(value)


def _goto(run: Context, node: syntax.Goto) -> None:
    raise Jump(node)


def _simple(run: Context, node: syntax.Simple) -> None:
    if node.word == "EXIT":
        raise Exit
    if run.frame.handling is None:
        raise run.error(node, f"{node.word} belongs in an ERROR handler")
    raise Retry if node.word == "RETRY" else TryNext


def _raise(run: Context, node: syntax.Raise) -> None:
    """An error of the program's own; inside a handler a long jump (see faults.py)."""
    if node.value is not None:
        text = run.text(node.value)
        raise_error(run, node, f"RAISE {text}", text, run.number(node.value))
    fault = run.frame.handling
    if fault is None:
        raise run.fault(node, "ERR_ILLRAISE", "RAISE without a number belongs in an ERROR handler")
    raise passed_on(run, fault)


def _connect(run: Context, node: syntax.Connect) -> None:
    found = run.routine(node.trap)
    if found is None or found[0].kind != "TRAP":
        raise run.error(node, f"there is no TRAP {node.trap} in the program")
    run.ignored["CONNECT"] += 1
    run.interrupts += 1
    what = f"interrupts are not simulated, so TRAP {node.trap} does not run"
    run.note("interrupts", WarningKind.NO_EFFECT, what, node)
    run.assign(node.interrupt, Value(NUM, float(run.interrupts)))


def _late_call(run: Context, node: syntax.LateCall) -> None:
    """`%expression% arguments;`."""
    run.call_procedure(node, str(run.evaluate(node.name, STRING).data), node.args)


def _placeholder(run: Context, node: syntax.Placeholder) -> None:
    raise run.error(node, f"unfinished code {node.name} cannot be run")


_STATEMENTS: dict[type, Callable[..., None]] = {
    syntax.ProcedureCall: procedure,
    syntax.Assign: _assign,
    syntax.If: _if,
    syntax.For: run_for,
    syntax.While: run_while,
    syntax.Test: _test,
    syntax.DataDeclaration: _declare,
    syntax.Return: _return,
    syntax.Goto: _goto,
    syntax.Label: lambda run, node: None,  # only a GOTO has a use for it
    syntax.Raise: _raise,
    syntax.Simple: _simple,
    syntax.Connect: _connect,
    syntax.LateCall: _late_call,
    syntax.Placeholder: _placeholder,
}


class Execution(Context):
    """One execution of a program."""

    evaluate = expressions.evaluate
    locate = expressions.locate
    block = run_block
    call_function = calls.function
    call_procedure = calls.call_by_name
    knows = calls.knows

    def __init__(self, scenario: Scenario, kinematics: Kinematics | None = None):
        super().__init__(scenario, kinematics)
        publish(self)

    def start(self, routine: Routine, scope: ModuleScope) -> None:
        """Run the entry procedure, which stands in scope, once. Raises InputError for what cannot be run."""
        if any(not parameter.optional for parameter in routine.parameters):
            message = f"PROC {routine.name} needs arguments, so the program cannot start with it"
            raise scope.places.error(routine.start, message)
        wanted, failure = self.scenario.endless_passes or 1, None
        try:
            with self.inside(CallFrame(scope)), room(), suppress(Exit):
                calls.enter(self, routine, scope, (), routine)
        except InputError as error:
            if not any(passes.count > wanted and not passes.leaves for passes in self.endless.values()):
                raise
            failure = error
        self.position.place()
        count_rests(self.motions)
        endless = (one for one in reversed(self.endless.values()) if one.count >= wanted and not one.leaves)
        if (passes := next(endless, None)) is not None:
            self.cycle = cycle_of(self, passes, failure)
        if not self.external.missing:
            for sentence in self.external.unused():
                self.warn(WarningKind.UNUSED, sentence)
        if self.cycle is not None:
            end = max(self.cycle.last, self.cycle.beyond)
            del self.motions[end:], self.links[end:]

    def store(self, place: Place, target: Expression, value: Value) -> None:
        """As assign, for data that is located already; target is where errors are placed."""
        type_ = place.type
        if place.constant:
            raise self.error(target, f"{self.text(target)} is {place.constant} and cannot be changed")
        if value.type is not type_:
            if not convertible(type_, value.type):
                raise self.error(target, f"{self.text(target)} is a {type_.name}, and the value a {value.type.name}")
            value = Value(type_, value.data, value.origin)
        if value.origin is None and type(type_) is not Array and not is_opaque(type_):  # arrays are only copied
            value = computed(self, target, type_, value.data)
        if type(place) is Part:
            whole: Place = place
            while type(whole) is Part:
                whole = whole.base
                self.spend(target, len(whole.value.data))
        place.value = value
