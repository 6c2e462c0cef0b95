"""`trajopt new NAME`: a program and its cell file, or an iiwa task, that run at once and say what each line is for."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import tidied
from trajopt_cli.errors import InputError

if TYPE_CHECKING:
    from trajopt_cli.warnings import ProgramWarning

_TAKEN = frozenset({"main", "j_home", "p_take", "p_put", "tool0", "wobj0", "offs", "movej", "movel", "moveabsj"})


def new(
    name: Annotated[
        Path,
        typer.Argument(metavar="NAME", help="What to call it: NAME.mod and NAME.yaml are written, where a path leads."),
    ],
    rail: Annotated[bool, typer.Option("--rail", help="The robot stands on a rail.")] = False,
    robot: Annotated[
        str | None,
        opt.given(
            "--robot",
            "R",
            "A name of 'trajopt robot list', or a robot's YAML file; irb140, or what the backup says.",
            autocompletion=opt.robots,
        ),
    ] = None,
    backup: Annotated[
        Path | None, opt.given("--from", "BACKUP", "Of a controller: NAME.yaml alone, by its SYSPAR/MOC.cfg.")
    ] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Write a commented RAPID program and its cell file, to begin with; of an iiwa a task file. Nothing is overwritten.

    \b
    Example:
      trajopt new glue --rail
      trajopt optimize glue.mod
    """
    from trajopt_cli.cli.console import print_json, stdout, tell, warn
    from trajopt_cli.runs.transaction import replace_files

    place = name.with_suffix("") if name.suffix.lower() in (".mod", ".yaml") else name
    told: tuple[ProgramWarning, ...] = ()
    if backup is not None:
        from trajopt_cli.adopt.backup import cell_from_backup

        if rail:
            raise InputError("--rail: the backup says what the robot stands on; leave --rail out")
        text, robot, told = cell_from_backup(backup, place, robot)
        texts, then = {".yaml": text}, f"trajopt parse {backup} --cell {place}.yaml"
    else:
        texts, robot, then = _made(place, robot or "irb140", rail)
    files = {place.with_name(f"{place.name}{ending}"): text.encode("utf-8") for ending, text in texts.items()}
    tidied(files)
    for path in files:
        if path.exists() or path.is_symlink():
            raise InputError("exists and is not overwritten; choose another name", file=str(path))
        if not path.parent.is_dir():
            raise InputError("is not a folder to write to; make it first", file=str(path.parent))
    replace_files({}, files)
    for line in told:
        warn(f"warning: {line}")
    if as_json:
        print_json({"files": [str(path) for path in files], "robot": robot, "next": then})
        return
    console = stdout()
    tell(console, [f"written: {', '.join(map(str, files))}"])
    if not quiet:
        tell(console, [f"next: {then}"])


def _made(place: Path, robot: str, rail: bool) -> tuple[dict[str, str], str, str]:
    """The files to begin with, by their endings, their robot, and the command that comes next."""
    from trajopt_cli.cli.new_files import program_and_cell, task
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot, robot_names

    _check_name(place.name)
    if rail and f"{robot}_rail" in robot_names():
        robot = f"{robot}_rail"
    if read(robot)[0].structure is Structure.SRS:
        if rail:
            raise InputError(f"--rail: {robot} has none; leave --rail out")
        return {".yaml": task(place.name, robot)}, robot, f"trajopt iiwa segments {place}.yaml"
    model = load_robot(robot)
    if rail and not model.has_rail:
        raise InputError(f"--rail: there is no {robot}_rail; 'trajopt robot list' shows which robots have a rail")
    own = robot.endswith((".yaml", ".yml"))
    said = os.path.relpath(os.path.realpath(robot), os.path.realpath(place.parent)) if own else None
    module, cell = program_and_cell(place.name, model, said)
    return {".mod": module, ".yaml": cell}, robot, f"trajopt optimize {place}.mod"


def _check_name(name: str) -> None:
    """Raise InputError unless a RAPID module may be called so."""
    from trajopt_cli.rapid.language.fast_path import NAME_LIMIT
    from trajopt_cli.rapid.language.lexer import KEYWORDS

    if not name.isidentifier() or not name.isascii() or name.startswith("_"):
        message = f"'{name}' is no RAPID name: a letter first, then letters, digits and underscores"
    elif len(name) > NAME_LIMIT:
        message = f"'{name}' has {len(name)} characters; a RAPID name has at most {NAME_LIMIT}"
    elif name.upper() in KEYWORDS:
        message = f"'{name}' is a word of RAPID's own; choose another name"
    elif name.lower() in _TAKEN:
        message = f"'{name}' is the name of something in the module; choose another name"
    else:
        return
    raise InputError(message)
