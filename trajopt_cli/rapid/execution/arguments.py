"""Arguments of instructions and functions matched to what the instruction or function takes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from trajopt_cli.rapid.data.scope import Absent
from trajopt_cli.rapid.execution.construction import maker
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Argument, Call, Expression, Name, ProcedureCall


class Arguments(NamedTuple):
    """required: in order. optional: by name in lower case; None for a bare switch."""

    required: tuple[Expression, ...]
    optional: dict[str, Expression | None]

    def value(self, name: str) -> Expression | None:
        """The value of an optional argument, None where it is absent."""
        return self.optional.get(name)


def present(run: Context, args: Sequence[Argument]) -> list[Argument]:
    r"""The arguments that are really there: `\name?parameter` is only if the parameter is."""
    kept = []
    for arg in args:
        if arg.forward:
            assert isinstance(arg.value, Name)
            _parameter(run, arg, arg.value)
            if isinstance(run.find(arg.value.name), Absent):
                continue
        kept.append(arg)
    return kept


def _parameter(run: Context, arg: Argument, node: Name) -> None:
    routine = run.frame.routine
    if routine is None or node.name.lower() not in {parameter.name.lower() for parameter in routine.parameters}:
        where = f"{routine.kind} {routine.name}" if routine else "a routine"
        raise run.error(arg, f"\\{arg.name}?{node.name} passes on a parameter, and {node.name} is not one of {where}")


def named(
    run: Context, call: str, arg: Argument, place: int, required: Sequence[str], optional: Sequence[str] = ()
) -> None:
    """Hold the name before a required argument against the parameter's at its place: a name changes no order.

    place: how many required arguments stand before it. Raises InputError.
    """
    name = arg.parameter or ""
    wanted = required[place] if place < len(required) else None
    if wanted is not None and name.lower() == wanted.lower():
        return
    at = f"argument {place + 1} of {call}"
    if name.lower() in {option.lower() for option in optional}:
        message = f"{name} is an optional argument of {call}; write \\{name}:={run.text(arg)}"
    elif wanted is None:
        message = f"{call} takes {len(required)} argument(s), so it has none called {name} in place {place + 1}"
    elif name.lower() in {one.lower() for one in required}:
        message = f"{at} is {wanted}, found {name}; names do not change the order, so put the arguments in theirs"
    else:
        message = f"{at} is {wanted}, found {name}; write {wanted}:= or no name"
    places = run.places()
    raise places.error(places.text.rfind(name, 0, arg.start), message)


def bind(
    run: Context, call: ProcedureCall | Call, required: tuple[str, ...], optional: tuple[str, ...] = (), more: int = 0
) -> Arguments:
    """Arguments by place and name. required, optional: as in the manual, for messages. more: that many may follow.

    Raises InputError for a missing or surplus argument and for an optional one that is not supported.
    """
    run.takes[call.name] = required
    places: list[Expression] = []
    options: dict[str, Expression | None] = {}
    for arg in call.args:
        name = arg.name
        if name is None:  # nearly always
            assert arg.value is not None
            if arg.parameter is not None:
                named(run, call.name, arg, len(places), required, optional)
            places.append(arg.value)
            continue
        if arg.forward:
            assert isinstance(arg.value, Name)
            _parameter(run, arg, arg.value)
            if isinstance(run.find(arg.value.name), Absent):
                continue
        known = _KNOWN.get(optional)
        if known is None:
            known = _KNOWN[optional] = frozenset(name.lower() for name in optional)
        if (key := name.lower()) in known:
            options[key] = arg.value
        else:
            supported = ", ".join(f"\\{name}" for name in optional) or "none"
            raise run.error(arg, f"{call.name} \\{arg.name} is not supported; supported here: {supported}")
    if not len(required) <= len(places) <= len(required) + more:
        names = ", ".join(required) or "none"
        raise run.error(call, f"{call.name} takes {len(required)} argument(s) ({names}), found {len(places)}")
    if len(options) > 1:
        for group in _EXCLUSIVE:
            both = [arg for arg in call.args if arg.name is not None and arg.name.lower() in group & options.keys()]
            if len(both) > 1:
                raise run.error(call, f"{call.name} takes only one of \\{both[0].name} and \\{both[1].name}")
    return _arguments((tuple(places), options))


_arguments = maker(Arguments)


def subject(run: Context, call: ProcedureCall | Call, node: Expression) -> str | None:
    """What an argument is called in messages: "Speed of MoveL". None where node is no argument of the call."""
    count = 0
    for arg in call.args:
        if arg.value is node:
            names = run.takes.get(call.name, ())
            if arg.name is not None:
                return f"\\{arg.name} of {call.name}"
            return f"{names[count]} of {call.name}" if count < len(names) else f"argument {count + 1} of {call.name}"
        count += arg.name is None
    return None


# `[\V] | [\T]` of the manual: optional arguments that exclude each other wherever they are known.
_EXCLUSIVE = (
    frozenset({"v", "t"}),
    frozenset({"stop", "pstop", "sstop", "sup"}),
    frozenset({"start", "time"}),
    frozenset({"on", "off"}),
    frozenset({"noteq", "lt", "gt"}),
    frozenset({"flanks", "posflank", "negflank", "highlevel", "lowlevel"}),
)
_KNOWN: dict[tuple[str, ...], frozenset[str]] = {}  # names of optional arguments in lower case
