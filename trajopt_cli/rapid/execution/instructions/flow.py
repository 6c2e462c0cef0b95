"""What steers the program, changes its variables, or reaches data and modules by name at run time."""

from __future__ import annotations

from pathlib import PurePosixPath

from trajopt_cli.rapid.data.datatypes import DNUM, NUM, Type, Value, convertible, is_number
from trajopt_cli.rapid.data.predefined import BOOKED
from trajopt_cli.rapid.data.scope import Exit, Place, Retry
from trajopt_cli.rapid.execution.arguments import Effect, Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.faults import raise_error
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall
from trajopt_cli.warnings import WarningKind

_FLOW = Topic("Instructions that steer the program")


@_FLOW.instruction(Effect.RUN, "ExitCycle")
def _exit_cycle(run: Context, node: ProcedureCall) -> None:
    raise Exit


@_FLOW.instruction(Effect.STOPS, r"Stop \NoRegain \AllMoveTasks")
def _stop(run: Context, node: ProcedureCall, **_: bool) -> None:
    run.note("stop", WarningKind.ASSUMED, f"{node.name} waits for the operator; the program goes on here", node)


@_FLOW.instruction(Effect.STOPS, "Break")
def _break(run: Context, node: ProcedureCall) -> None:
    what = "Break stops the robot at once, somewhere on its way; the plan stops at the point before it"
    run.warn(WarningKind.ASSUMED, what, run.source(node))


_FLOW.instruction(Effect.RUN, "CallByVar Name:string Number:int")(
    lambda run, node, name, number: run.call_procedure(node, f"{name}{number}")
)


@_FLOW.instruction(Effect.RUN, "BookErrNo ErrorName")
def _book_error(run: Context, node: ProcedureCall, target: Expression) -> None:
    run.booked += 1
    run.assign(target, Value(NUM, BOOKED + run.booked))


@_FLOW.instruction(Effect.RUN, "ErrRaise ErrorName:string ErrorId Argument1 Argument2 Argument3 Argument4 Argument5")
def _err_raise(run: Context, node: ProcedureCall, name: str, *_: Expression) -> None:
    """RAISE of the booked number in the variable that a string names, with a text for the log."""
    place = run.find(name)
    if not (isinstance(place, Place) and place.type == NUM):
        message = f"{node.name} names '{name}', which is no errnum of the program; declare it there"
        raise Refused(message, "ErrorName")
    raise_error(run, node, f'{node.name} "{name}"', name, float(place.value.data))


@_FLOW.instruction(Effect.RUN, "ResetRetryCount")
def _reset_retry(run: Context, node: ProcedureCall) -> None:
    run.frame.retried = (0, 0, 0)


@_FLOW.instruction(Effect.RUN, "StartMoveRetry")
def _start_move_retry(run: Context, node: ProcedureCall) -> None:
    """StartMove and RETRY in one."""
    if run.frame.handling is None:
        raise Refused(f"{node.name} belongs in an ERROR handler")
    raise Retry


@_FLOW.enter(Effect.REFUSED, "ProcerrRecovery", "RaiseToUser")
def _refused(run: Context, node: ProcedureCall) -> None:
    """ProcerrRecovery stops the robot wherever it is; RaiseToUser asks which modules a user may step into."""
    what = f"{node.name} raises an error whose place or handler is not modelled"
    raise run.error(node, f"{what}; leave it out, or write RAISE with the number of the error")


_VARIABLES = Topic("Instructions that change variables")


@_VARIABLES.instruction(Effect.RUN, "Incr Name", "Decr Name", "Add Name AddValue", "Clear Name")
def _change(run: Context, node: ProcedureCall, target: Expression, added: Expression | None = None) -> None:
    place, name = run.locate(target), node.name.lower()
    if not is_number(place.type):
        raise Refused(f"needs a num or a dnum, found {place.type.name}", "Name")
    step = {"incr": 1.0, "decr": -1.0, "clear": -place.value.data}.get(name, 0.0)
    if added is not None:
        step = run.evaluate(added, DNUM if place.type is DNUM else NUM).data
    run.store(place, target, Value(place.type, place.value.data + step))


@_VARIABLES.instruction(Effect.RUN, "BitSet BitData BitPos:int", "BitClear BitData BitPos:int")
def _bit(run: Context, node: ProcedureCall, target: Expression, position: int) -> None:
    """Set or clear a bit of a byte (of a dnum: of its 52 bits); the lowest is 1."""
    place = run.locate(target)
    if not is_number(place.type):
        raise Refused(f"needs a num or a dnum, found {place.type.name}", "BitData")
    bits, value = 52 if place.type is DNUM else 8, run.integer(target, "BitData")
    if not 0 <= value < 2**bits:
        raise Refused(f"BitData is {value}, and must lie in 0..{2**bits - 1}", "BitData", "ERR_ARGVALERR")
    if not 1 <= position <= bits:
        raise Refused(f"BitPos {position} lies outside 1..{bits}", "BitPos", "ERR_ARGVALERR")
    mask = 1 << (position - 1)
    run.store(place, target, Value(place.type, float(value | mask if node.name.lower() == "bitset" else value & ~mask)))


_SYMBOLS = Topic("Data and modules by name at run time")


@_SYMBOLS.instruction(Effect.RUN, r"GetDataVal Object:string Value \Block \TaskRef \TaskName")
def _get(run: Context, node: ProcedureCall, name: str, target: Expression, **_: bool) -> None:
    """Read the data that a text names."""
    run.assign(target, run.evaluate(_data(run, node, name, run.locate(target).type)))


@_SYMBOLS.instruction(Effect.RUN, r"SetDataVal Object:string Value \Block \TaskRef \TaskName")
def _set(run: Context, node: ProcedureCall, name: str, value: Expression, **_: bool) -> None:
    """Change the data that a text names."""
    given = run.evaluate(value)
    target = _data(run, node, name, given.type)
    if constant := run.locate(target).constant:
        raise _inaccessible(f"'{target.name}' is {constant} and cannot be changed")
    run.assign(target, given)


def _data(run: Context, node: ProcedureCall, name: str, type_: Type) -> Name:
    name = name.strip()
    place = run.find(name)
    if not isinstance(place, Place):
        raise _inaccessible(f"there is no data named '{name}' in the program")
    if not convertible(type_, place.type):
        raise _inaccessible(f"'{name}' is a {place.type.name}, and the value a {type_.name}")
    return Name(node.start, node.end, name)


def _inaccessible(message: str) -> Refused:
    return Refused(message, "Object", "ERR_SYM_ACCESS")


@_SYMBOLS.instruction(Effect.STOPS, r"Load FilePath:string \Dynamic \File:string \CheckRef")
@_SYMBOLS.instruction(Effect.IGNORED, r"StartLoad FilePath:string LoadNo \Dynamic \File:string \CheckRef")
def _load(run: Context, node: ProcedureCall, path: str, *_: Expression, file: str | None = None, **__: bool) -> None:
    """Every module is in memory from the start, so it only has to be among the program's files."""
    if _stem(path if file is None else file) not in {_stem(name) for name in run.files}:
        message = f"{node.name} wants the module file '{file or path}'; put it among the program's files"
        raise Refused(message, "FilePath" if file is None else "File", "ERR_FILNOTFND")


def _stem(path: str) -> str:
    """The file's own name without its ending, in lower case; a controller's path begins with HOME: or the like."""
    return PurePosixPath(path.replace("\\", "/").replace(":", "/")).stem.lower()
