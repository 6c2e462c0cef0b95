"""What each statement does."""

from __future__ import annotations

from collections.abc import Callable

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.data.errors import Exit, Fault, Jump, Mismatch, Retry, Return, TryNext, Undeclared
from trajopt_cli.rapid.execution import external_data
from trajopt_cli.rapid.execution.calls import late_call, procedure
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.evaluate import inside_opaque
from trajopt_cli.rapid.execution.faults import Handled, handle, passed_on, raise_error
from trajopt_cli.rapid.execution.instructions.processes import set_speed
from trajopt_cli.rapid.execution.loading import declare
from trajopt_cli.rapid.execution.loops import backwards, run_for, run_while
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    Assign,
    Block,
    Connect,
    DataDeclaration,
    For,
    Goto,
    If,
    Label,
    LateCall,
    Name,
    Placeholder,
    ProcedureCall,
    Raise,
    Simple,
    Test,
    While,
)
from trajopt_cli.rapid.language.syntax import Return as ReturnStatement
from trajopt_cli.rapid.language.walk import walk
from trajopt_cli.warnings import WarningKind

_LONG = 64  # characters that are charged as one more statement


def run_block(run: Context, block: Block) -> None:
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


def _labels(run: Context, block: Block) -> dict[str, int]:
    """The labels of a block, with where they stand in it."""
    found = run.labels.get(id(block))
    if found is None:
        found = {node.name.lower(): i for i, node in enumerate(block) if isinstance(node, Label)}
        run.labels[id(block)] = found
    return found


def _assign(run: Context, node: Assign) -> None:
    target = node.target
    run.budget -= (node.end - node.start) // _LONG  # a long expression takes as long as many statements
    if type(target) is not Name and inside_opaque(run, target):
        if set_speed(run, target, node.value):
            return
        run.note(
            "opaque",
            WarningKind.NO_EFFECT,
            f"{run.text(target)} is process data, which does not affect the motion",
            node,
        )
        return
    try:
        place = run.locate(target)
    except Undeclared:
        if type(target) is not Name:
            raise
        return _assign_undeclared(run, node, target)
    try:
        value = run.evaluate(node.value, place.type)
    except Mismatch as error:
        raise error.about(node.value, run.text(target)) from None
    run.store(place, target, value)


def _assign_undeclared(run: Context, node: Assign, target: Name) -> None:
    """What is assigned tells the type; a name that is counted up is a number."""
    if isinstance(node.value, Aggregate):
        raise run.undeclared(target)
    counted = any(isinstance(one, Name) and one.name.lower() == target.name.lower() for one in walk(node.value))
    value = None if counted else run.evaluate(node.value)
    place = external_data.assigned(run, target, NUM if value is None else value.type)
    run.store(place, target, run.evaluate(node.value, NUM) if value is None else value)


def _if(run: Context, node: If) -> None:
    for test, block in node.branches:
        if run.condition(test):
            return run_block(run, block)
    if node.otherwise:
        run_block(run, node.otherwise)


def _test(run: Context, node: Test) -> None:
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


def _declare(run: Context, node: DataDeclaration) -> None:
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


def _return(run: Context, node: ReturnStatement) -> None:
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


def _goto(run: Context, node: Goto) -> None:
    raise Jump(node)


def _simple(run: Context, node: Simple) -> None:
    if node.word == "EXIT":
        raise Exit
    if run.frame.handling is None:
        raise run.error(node, f"{node.word} belongs in an ERROR handler")
    raise Retry if node.word == "RETRY" else TryNext


def _raise(run: Context, node: Raise) -> None:
    """An error of the program's own; inside a handler a long jump (see faults.py)."""
    if node.value is not None:
        text = run.text(node.value)
        raise_error(run, node, f"RAISE {text}", text, run.number(node.value))
    fault = run.frame.handling
    if fault is None:
        raise run.fault(node, "ERR_ILLRAISE", "RAISE without a number belongs in an ERROR handler")
    raise passed_on(run, fault)


def _connect(run: Context, node: Connect) -> None:
    found = run.routine(node.trap)
    if found is None or found[0].kind != "TRAP":
        raise run.error(node, f"there is no TRAP {node.trap} in the program")
    run.ignored["CONNECT"] += 1
    run.interrupts += 1
    run.note(
        "interrupts", WarningKind.NO_EFFECT, f"interrupts are not simulated, so TRAP {node.trap} does not run", node
    )
    run.assign(node.interrupt, Value(NUM, float(run.interrupts)))


def _label(run: Context, node: Label) -> None:
    """Only a GOTO has a use for it."""


def _placeholder(run: Context, node: Placeholder) -> None:
    raise run.error(node, f"unfinished code {node.name} cannot be run")


_STATEMENTS: dict[type, Callable[..., None]] = {
    ProcedureCall: procedure,
    Assign: _assign,
    If: _if,
    For: run_for,
    While: run_while,
    Test: _test,
    DataDeclaration: _declare,
    ReturnStatement: _return,
    Goto: _goto,
    Label: _label,
    Raise: _raise,
    Simple: _simple,
    Connect: _connect,
    LateCall: late_call,
    Placeholder: _placeholder,
}
