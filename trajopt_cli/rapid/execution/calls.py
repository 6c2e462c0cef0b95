"""Calls of the program's routines: which one, and its parameters."""

from __future__ import annotations

import re
from collections.abc import Sequence

from trajopt_cli.rapid.data.datatypes import NUM, SIGNALS, SWITCH, Array, Type, Value, convertible
from trajopt_cli.rapid.data.scope import (
    ABSENT,
    Absent,
    CallFrame,
    Datum,
    Head,
    Jump,
    Mismatch,
    ModuleScope,
    Place,
    Return,
    Undeclared,
)
from trajopt_cli.rapid.execution.answers import ask
from trajopt_cli.rapid.execution.arguments import Effect, named, present, subject
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.waits import hold_up
from trajopt_cli.rapid.execution.loops import count_endless, leaves
from trajopt_cli.rapid.execution.operators import computed
from trajopt_cli.rapid.execution.table import FUNCTIONS, INSTRUCTIONS
from trajopt_cli.rapid.execution.types import find_type
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import Argument, Call, Node, ProcedureCall, Routine
from trajopt_cli.warnings import WarningKind

CALL_LIMIT = 250  # routines inside routines
CALL_COST = 6  # statements that take as long as a call
FUNCTION_COST = 2  # and as long as a predefined function
_INSTRUCTIONS = {name.lower(): instruction for name, instruction in INSTRUCTIONS.items()}
_IGNORED, _STOPS = Effect.IGNORED, Effect.STOPS
_FUNCTIONS = {name.lower(): function for name, function in FUNCTIONS.items()}
_NAME = re.compile(r"(?:(\w*):)?([^\W\d]\w*)")  # `module:procedure`, `:procedure`
# Names of ABB's instructions that move or set speeds, and may be of an option that is not read here.
_MOVING = re.compile(
    r"Move\w*|Ind[ACDR]Move|PathRecMove\w+|StepBwdPath|SpeedLim\w+|"
    r"(?:Arc|Cap|Contact|DaProc|Disp|FC|Glue|Nut|Paint|Search|Spot|Trigg)\w*[LJC](?:[12]|Start|End|IOs)?",
    re.IGNORECASE,
)
_OF_MOVES = frozenset({"robtarget", "jointtarget", "speeddata"})
_TARGETS = frozenset({"offs", "reltool", "mirpos", "orobt", "crobt", "cjointt", "calcrobt", "calcjointt"})


# ------------------------------------------------------------------------------------------------- calls by name


def procedure(run: Context, node: ProcedureCall) -> None:
    """An instruction, or a procedure of the program; the program's own goes first."""
    found = run.routine(node.name)
    if found is not None:
        routine, scope = found
        if routine.kind != "PROC":
            raise run.error(node, f"{node.name} is a {routine.kind}; {_remedy(node, routine)}")
        enter(run, routine, scope, node.args, node)
        return
    instruction = _INSTRUCTIONS.get(node.name.lower())
    if instruction is None:
        return _stub(run, node)
    name, _, effect, handler = instruction
    try:
        handler(run, node)
    except Mismatch as error:
        raise _about_argument(run, node, error) from None
    if effect is _IGNORED:
        run.ignored[name] += 1
    elif effect is _STOPS:
        hold_up(run, node, name)
    if len(run.motions) != len(run.links):
        run.settle()


def _remedy(node: ProcedureCall, routine: Routine) -> str:
    """What to do about a call, as a statement, of what is no procedure."""
    if routine.kind == "TRAP":
        return f"only a PROC is called as a statement; move what it does into a PROC that TRAP {node.name} calls too"
    taken = "..." if node.args else ""
    return f"only a PROC is called as a statement; write 'x:={node.name}({taken});', or make it a PROC"


def _stub(run: Context, node: ProcedureCall) -> None:
    """A procedure that no file declares: it does nothing, which is for the user to say."""
    if node.name.lower() in run.scenario.stubs:
        run.external.asked("stubs", node.name.lower())
        run.ignored[node.name] += 1
        if _moves(run, node):
            what = f"{node.name} does nothing here (stubs), but its name or arguments say that it moves the robot or "
            what += "sets its speed; check that"
            run.warn(WarningKind.ASSUMED, what, run.source(node))
        if run.external.least(node.name) != 0.0:
            hold_up(run, node, node.name)
            run.settle()
        return
    message = f"{node.name} is neither a procedure of the files read nor a known instruction"

    def close() -> str | None:
        return run.close(node.name, [*INSTRUCTIONS, *run.routines("PROC")])

    if _moves(run, node):  # nothing may stand for it
        error = run.error(node, f"{message}, and by its name or arguments it moves the robot or sets its speed")
        remedy = "write it as MoveL, MoveC, MoveJ, MoveAbsJ or VelSet, or give the file that declares it"
        raise Undeclared(error, close(), remedy)
    run.missing("stubs", node.name, node, message, "", close=close)


def _moves(run: Context, node: ProcedureCall) -> bool:
    """Whether an unknown procedure moves or sets speeds: by its name, or as it is given targets or speeds."""
    return _MOVING.fullmatch(node.name) is not None or any(_tells_a_move(run, arg.value) for arg in node.args)


def _tells_a_move(run: Context, value: syntax.Expression | None) -> bool:
    while isinstance(value, syntax.Element):
        value = value.base
    if isinstance(value, Call):
        found = run.routine(value.name)
        return (found[0].type or "").lower() in _OF_MOVES if found else value.name.lower() in _TARGETS
    place = run.find(value.name) if isinstance(value, syntax.Name) else None
    if place is None or isinstance(place, Absent):
        return False
    type_ = place.type.element if isinstance(place.type, Array) else place.type
    return type_.name in _OF_MOVES


def function(run: Context, node: Call, wanted: Type | None) -> Value:
    """The value of a function of the program, of a predefined one, or of one that the scenario answers for.

    wanted: the type that the place asks for.
    """
    found = run.routine(node.name)
    if found is not None:
        routine, scope = found
        if routine.kind != "FUNC":
            raise run.error(node, f"{node.name} is a {routine.kind}; only a FUNC has a value")
        value = enter(run, routine, scope, node.args, node)
        assert value is not None
        return value
    run.budget -= FUNCTION_COST
    if run.budget < 0:
        raise run.exhausted(node)
    known = _FUNCTIONS.get(node.name.lower())
    if known is None:
        message = f"{node.name} is neither a function of the files read nor a known function"

        def close() -> str | None:
            return run.close(node.name, [*FUNCTIONS, *run.routines("FUNC")])

        return ask(run, node, node.name, wanted or NUM, message, close=close)
    try:
        value = known.handler(run, node)
    except Mismatch as error:
        raise _about_argument(run, node, error) from None
    if known.stops:
        hold_up(run, node, known.name)
        run.settle()
    return computed(run, node, value.type, value.data) if value.origin is None else value


def knows(run: Context, name: str) -> bool:
    """Whether a function is one of the program's or of RAPID's."""
    return name.lower() in _FUNCTIONS or run.routine(name) is not None


def _about_argument(run: Context, call: ProcedureCall | Call, error: Mismatch) -> Mismatch:
    """The error, with the argument that it is about."""
    name = subject(run, call, error.node)
    return error.about(error.node, name) if name else error


def call_by_name(run: Context, node: Node, text: str, args: Sequence[Argument] = ()) -> None:
    """See Context.call_procedure."""
    match = _NAME.fullmatch(text)
    module, name = (match[1], match[2]) if match else (None, text)
    if module:
        scope = run.modules.get(module.lower())
        found = None if scope is None else scope.routines.get(name.lower())
    else:
        found = run.routine(name)
    if found is None:
        if name.lower() not in run.scenario.stubs and (module or name.lower() not in _INSTRUCTIONS):
            where = "the program" if not module else f"module {module}" if scope else f"the program: no module {module}"
            message = f"there is no procedure '{name}' in {where}; give the file that declares it"
            raise run.fault(node, "ERR_REFUNKPRC", message)
        return procedure(run, ProcedureCall(node.start, node.end, name, tuple(args)))
    routine, scope = found
    if routine.kind != "PROC":
        raise run.fault(node, "ERR_CALLPROC", f"{text} is a {routine.kind}; only a PROC is called by its name")
    required = sum(not parameter.optional for parameter in routine.parameters)
    given = sum(arg.name is None for arg in args)
    if required != given:
        raise run.fault(node, "ERR_CALLPROC", f"{text} takes {required} argument(s), found {given}")
    enter(run, routine, scope, args, node)


# --------------------------------------------------------------------------------------------------- one routine


def enter(run: Context, routine: Routine, scope: ModuleScope, args: Sequence[Argument], node: Node) -> Value | None:
    """Run a routine with arguments that stand in the routine that runs now; the value that a FUNC returns."""
    if run.depth >= CALL_LIMIT:
        raise run.error(node, f"calls are nested deeper than {CALL_LIMIT} routines at {routine.name}")
    run.budget -= CALL_COST
    if run.budget < 0:
        raise run.exhausted(node)
    head = _head(run, routine, scope)
    frame = CallFrame(scope, returns=head.returns, routine=routine, caller=run.frame, motions=len(run.motions))
    if routine is run.frame.routine and node is routine.body[-1] and not args and len(run.motions) > run.frame.motions:
        loop = f"{routine.kind} {routine.name}, whose last statement calls it again,"
        counted = run.frame.turns.get(id(node), (0, 0))[1]
        counted = count_endless(run, node, loop, leaves(routine.body), run.depth, counted, run.frame.motions)
        frame.turns[id(node)] = (frame.motions, counted)
    if args or routine.parameters:
        _pass(run, routine, head, present(run, args), frame, node)
    before, link = run.frame, run.link
    run.frame, run.depth = frame, run.depth + 1
    try:
        run.block(routine.body)
    except Return as result:
        return result.value
    except Jump as jump:
        raise _lost(run, routine, jump.node) from None
    finally:
        run.frame, run.link, run.depth = before, link, run.depth - 1
    if routine.kind == "FUNC":
        raise run.fault(node, "ERR_FNCNORET", f"FUNC {routine.name} ended without RETURN")
    return None


def _lost(run: Context, routine: Routine, node: syntax.Goto) -> Exception:
    stack: list[object] = list(routine.body)
    while stack:
        inner = stack.pop()
        if isinstance(inner, syntax.Label) and inner.name.lower() == node.label.lower():
            return run.error(node, f"GOTO {node.label} leads into a block; a label is reached from its own block only")
        if isinstance(inner, tuple):
            stack += inner
        for part in ("body", "branches", "otherwise", "cases", "default"):
            stack += getattr(inner, part, None) or ()
    return run.error(node, f"there is no label {node.label} in {routine.kind} {routine.name}")


def _head(run: Context, routine: Routine, scope: ModuleScope) -> Head:
    head = run.heads.get(id(routine))
    if head is not None:
        return head
    with run.inside(CallFrame(scope)):
        types = []
        for parameter in routine.parameters:
            element = find_type(run, parameter.type, parameter)
            types.append(Array(element, None, parameter.dimensions) if parameter.dimensions else element)
        returns = find_type(run, routine.type, routine) if routine.type else None
        for handler in routine.handlers:
            if handler.kind == "UNDO":
                what = "UNDO runs where a long jump or a moved program pointer leaves the routine; it is left out here"
                run.warn(WarningKind.NO_EFFECT, what, run.source(handler))
    groups: list[list[str]] = []
    for parameter in routine.parameters:
        if parameter.alternative and groups:
            groups[-1].append(parameter.name)
        else:
            groups.append([parameter.name])
    required = tuple(parameter.name for parameter in routine.parameters if not parameter.optional)
    head = Head(tuple(types), returns, required, tuple(tuple(group) for group in groups if len(group) > 1))
    run.heads[id(routine)] = head
    return head


def _pass(run: Context, routine: Routine, head: Head, args: list[Argument], frame: CallFrame, node: Node) -> None:
    """Fill a frame's parameters. args are evaluated where the call stands."""
    required = [arg for arg in args if arg.name is None]
    optional = {arg.name.lower(): arg for arg in args if arg.name is not None}
    if len(required) != len(head.required):
        names = ", ".join(head.required) or "none"
        count = len(head.required)
        raise run.error(node, f"{routine.name} takes {count} argument(s) ({names}), found {len(required)}")
    for group in head.groups:
        given = [name for name in group if name.lower() in optional]
        if len(given) > 1:
            both = " and ".join(f"\\{name}" for name in given[:2])
            raise run.error(node, f"{routine.name} takes only one of {both}")
    for place, one in enumerate(required):
        if one.parameter is not None:
            others = [parameter.name for parameter in routine.parameters if parameter.optional]
            named(run, routine.name, one, place, head.required, others)
    following = iter(required)
    for parameter, type_ in zip(routine.parameters, head.types, strict=True):
        key = parameter.name.lower()
        arg = optional.pop(key, None) if parameter.optional else next(following)
        if arg is None:
            frame.local[key] = ABSENT
        else:
            frame.local[key] = _argument(run, routine, parameter, type_, arg)
            frame.given[key] = (arg, run.frame)
    for arg in optional.values():
        raise run.error(arg, f"{routine.name} has no optional parameter \\{arg.name}")


def _argument(
    run: Context, routine: Routine, parameter: syntax.Parameter, type_: Type, arg: Argument
) -> Place | Absent:
    if arg.value is None:
        if type_ is not SWITCH:
            raise run.error(arg, f"\\{parameter.name} needs a value of type {type_.name}")
        return Datum(SWITCH, Value(SWITCH, True), "a switch", "CONST")
    if type_.name in SIGNALS:
        return Datum(type_, Value(type_, run.signal(arg.value)), "a signal", "CONST")
    if type_.name == "mecunit":
        return Datum(type_, Value(type_, run.unit(arg.value)), "a mechanical unit", "CONST")
    if parameter.mode is None:
        try:
            value = run.evaluate(arg.value, type_)
        except Mismatch as error:
            raise error.about(arg.value, f"parameter {parameter.name} of {routine.name}") from None
        return Datum(value.type if isinstance(type_, Array) else type_, value)
    place = run.locate(arg.value)
    if not convertible(type_, place.type):
        name = f"parameter {parameter.name} of {routine.name}"
        raise run.error(arg, f"{name} is a {type_.name}, and {run.text(arg)} a {place.type.name}")
    if parameter.mode == "PERS" and place.storage != "PERS":
        raise run.error(arg, f"{run.text(arg)} is not a PERS and cannot be given to PERS {parameter.name}")
    if parameter.mode == "VAR" and place.storage == "PERS":
        raise run.error(arg, f"{run.text(arg)} is a PERS and cannot be given to VAR {parameter.name}")
    if place.constant and parameter.mode != "PERS":
        text = f"{run.text(arg)} is {place.constant} and cannot be given to {parameter.mode} {parameter.name}"
        raise run.error(arg, text)
    return place
