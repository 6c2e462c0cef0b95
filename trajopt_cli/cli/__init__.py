"""The commands: each parses its options, makes one library call and renders the answer. typer and rich live here.

Exit codes: 0 done, 1 the answer is no (infeasible, illegal), 2 the request is wrong, 130 interrupted.
"""

from __future__ import annotations

import os
import signal
from contextlib import suppress


def _leave(*_: object) -> None:
    """Answer Ctrl-C while modules are imported: raised in the middle of that, an interruption may get another name."""
    os.write(2, b"interrupted: nothing written, earlier results stand\n")
    os._exit(130)


with suppress(ValueError):  # in a thread nothing is set, and nothing interrupts it
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:  # in the background of a shell it is ignored
        signal.signal(signal.SIGINT, _leave)

import atexit
import gc
import re
import sys
from collections.abc import Iterator
from difflib import get_close_matches
from functools import cache, partial
from io import TextIOWrapper
from itertools import pairwise
from typing import Annotated, Any, get_args

import typer
from typer.core import TyperGroup
from typer.main import get_command

from trajopt_cli import __version__
from trajopt_cli.cli import (
    analyse,
    batch,
    cell,
    check,
    compare,
    doctor,
    estimate,
    export,
    identify,
    iiwa,
    new,
    optimize,
    order,
    parse,
    place,
    play,
    robot,
    schema,
    sensitivity,
    study,
    verify,
    view,
)
from trajopt_cli.cli.process import begin, interrupted, out_of_memory, own_process
from trajopt_cli.errors import InputError, terminal_text
from trajopt_cli.workers import ProcessEnded

_LONGEST = 600  # characters of a line on stderr: eight lines of a terminal
_MEANT = {"csv": "joint", "stream": "joint", "ros": "ros2", "bag": "mcap", "mod": "rapid", "optimise": "optimize"}
_SELDOM = 20_000, 20, 50  # new objects between looks for garbage. Python's 700 take 5 % of the time of a command
_FIRST, _REST = "What most need", "And the rest"
_COMMANDS: dict[str, dict[str, tuple[Any, str]]] = {
    _FIRST: {
        "new": (new.new, "Write a commented program and cell file to begin with."),
        "check": (check.check, "Does a program read, reach, keep its limits, touch nothing?"),
        "estimate": (estimate.estimate, "Estimate a program's cycle time as written."),
        "optimize": (optimize.optimize, "Optimise a program and check the result."),
        "verify": (verify.verify, "Check results or any joint CSV file."),
        "view": (view.view, "Open a results page, or a cell, in the browser."),
        "export": (export.app, ""),
    },
    _REST: {
        "compare": (compare.app, ""),
        "sensitivity": (sensitivity.sensitivity, "What to change first: seconds per limit, speed, wait, place."),
        "place": (place.place, "Where base, rail or a work object should stand."),
        "study": (study.app, ""),
        "order": (order.order, "The fastest order of parts that allow any order."),
        "batch": (batch.batch, "Optimise every program of a folder of backups."),
        "parse": (parse.parse, "List a program's motions with file:line."),
        "analyse": (analyse.analyse, "Add up a program's times as written, without ramps."),
        "identify": (identify.identify, "Speed, acceleration and jerk limits from controllers' logs."),
        "play": (play.app, ""),
        "iiwa": (iiwa.app, ""),
        "cell": (cell.app, ""),
        "robot": (robot.app, ""),
        "schema": (schema.schema, "What cell, task and robot files may hold."),
        "doctor": (doctor.doctor, "What is installed, what is missing, and whether it works."),
    },
}


class _Grouped(TyperGroup):
    """The commands in their groups, in this order."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Their names."""
        return [name for group in _COMMANDS.values() for name in group]

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """A heading for each group."""
        for heading, group in _COMMANDS.items():
            width = formatter.width - 6 - max(map(len, group))
            rows = [(name, self.commands[name].get_short_help_str(width)) for name in group]
            with formatter.section(heading):
                formatter.write_dl(rows)


app = typer.Typer(
    name="trajopt",
    cls=_Grouped,
    help="The fastest legal motion for the robot program a cell already runs.",
    rich_markup_mode=None,  # plain help: rich would double the time to the first line
    pretty_exceptions_enable=False,
)
for _name, (_does, _short) in (one for group in _COMMANDS.values() for one in group.items()):
    if isinstance(_does, typer.Typer):
        app.add_typer(_does, name=_name)
    else:
        app.command(_name, short_help=_short)(_does)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"trajopt {__version__}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None:
    """The fastest legal motion for the robot program a cell already runs."""


def run(arguments: list[str]) -> int:
    """Run one command line and give its exit code; every expected mistake is a line on stderr, never a traceback."""
    begin()
    try:
        code = _answered(arguments)
    except InputError as error:
        typer.echo("\n".join(map(_cut, error.shown().rstrip("\n").split("\n"))), err=True)
        return 2
    except typer.TyperException as error:
        if known := getattr(error, "possibilities", None):  # click takes --loops for --tool
            close = get_close_matches(getattr(error, "option_name", ""), known, cutoff=0.75)
            setattr(error, "possibilities", close)  # noqa: B010  # typer exports no class that has it
        message = " ".join(error.format_message().replace("Value error, ", "").split()).rstrip(".?")
        command = re.match(r"No such command '(\w+)'", message)
        if command and command[1].lower() in _MEANT:
            message = f"No such command '{command[1]}'. Did you mean '{_MEANT[command[1].lower()]}'"
        asked = getattr(getattr(error, "ctx", None), "command_path", None) or "trajopt"
        typer.echo(terminal_text(f"trajopt: {_cut(message)}; see '{asked} --help'"), err=True)
        return 2
    except ProcessEnded as error:
        typer.echo(f"{error}; where memory is short, --jobs 1 takes less. {interrupted().split(': ', 1)[1]}", err=True)
        return 2
    except (MemoryError, ImportError, RuntimeError, OSError, SystemError) as error:
        line = out_of_memory(error)
        if line is not None:
            gc.collect()
            typer.echo(line, err=True)
            _give_up_stdout()
        elif not isinstance(error, OSError) or (error.filename is None and error.errno is None):
            raise
        elif error.filename is None:
            typer.echo(f"cannot write the output: {error.strerror}", err=True)
            _give_up_stdout()
        else:
            typer.echo(terminal_text(f"{os.fsdecode(error.filename)}: {error.strerror}"), err=True)
        return 2
    if code == 130:
        typer.echo(interrupted(), err=True)
    return int(code or 0)


def _answered(arguments: list[str]) -> int | None:
    """The exit code of a command, 130 also where libraries called an interruption by another name."""
    try:
        own_process()
        _check_arguments(arguments)
        code: int | None = _commands()(arguments or ["--help"], prog_name="trajopt", standalone_mode=False)
        sys.stdout.flush()
    except BaseException as error:
        chain: BaseException | None = error
        seen: list[BaseException] = []  # an error may be its own cause
        while chain is not None and chain not in seen and not isinstance(chain, KeyboardInterrupt):
            seen.append(chain)
            chain = chain.__cause__ or chain.__context__
        if not isinstance(chain, KeyboardInterrupt):
            raise
        return 130
    return code


_commands = cache(partial(get_command, app))  # with all their options: made once in a process


def _cut(line: str) -> str:
    """A line of a message, of one that a name or a cell of thousands of characters made long its two ends."""
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST // 2]}…{line[-_LONGEST // 2 + 1 :]}"


def _check_arguments(arguments: list[str]) -> None:
    """Nothing that trajopt takes is empty; an empty path would be the current folder, an empty entry the default. And
    options that are numbers have no '_' in them: 1_0 is 10 for Python alone."""
    numbers: set[str] | None = None
    for before, argument in pairwise(["", *arguments]):
        option = before if before.startswith("--") else ""
        if argument.startswith("--") and argument.endswith("="):
            option, argument = argument[:-1], ""
        if not argument.strip():
            advice = f"give {option} a value or leave it out" if option else "give one or leave it out"
            raise InputError(f"an empty name{f' for {option}' if option else ''}; {advice}")
        if argument.startswith("--") and "=" in argument:
            option, _, argument = argument.partition("=")
        if option and "_" in argument and option in (numbers := numbers or {*_number_options(_commands())}):
            raise InputError(f"{option}: '{_cut(argument)}' has '_' in a number; leave it out")


def _number_options(command: Any) -> Iterator[str]:
    """The options of a command and of those under it that take a plain number."""
    for parameter in command.params:
        kind = parameter.type_descriptor.annotation
        if {int, float} & {kind, *get_args(kind)}:
            yield from parameter.opts
    for inner in getattr(command, "commands", {}).values():
        yield from _number_options(inner)


def _give_up_stdout() -> None:
    """What stdout still holds goes nowhere: Python would try again at its end, and report that by a traceback."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    with suppress(ValueError, OSError):  # a stdout without a file behind it holds nothing back
        os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def main() -> None:
    """The entry point of the console script."""
    if sys.stdout is None:  # `trajopt ... >&-`
        typer.echo("cannot write the output: it is closed", err=True)
        sys.exit(2)
    if isinstance(sys.stdout, TextIOWrapper):  # bytes of a file's name that are no text: as JSON spells them, \udc80
        sys.stdout.reconfigure(errors="backslashreplace")
    gc.set_threshold(*_SELDOM)
    code = run(sys.argv[1:])
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # all is said and written
    if code == 130:  # where the interruption came from Python code in a library, sys.exit would end by the signal
        atexit._run_exitfuncs()
        os._exit(code)
    sys.exit(code)


if signal.getsignal(signal.SIGINT) is _leave:
    signal.signal(signal.SIGINT, signal.default_int_handler)
