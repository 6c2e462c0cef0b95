"""Command lines out of every command's own options, with values that fit and values that do not.

Nothing is planned: the planner is a closed form, as in the tests of the commands, and what would serve a page, open a
browser or play a stream in real time is left out.
"""

from __future__ import annotations

import os
import random
from collections.abc import Iterator, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

import typer
from fuzz_mutate import NUMBERS, SIGNS, words
from fuzz_readers import Reader, Workspace

LEFT_OUT = {("view",), ("play", "egm"), ("doctor",), ("iiwa", "experiments")}
LONG = {("optimize",), ("compare", "baseline"), ("sensitivity",), ("place",), ("order",)}
LONG |= {("iiwa", "simulate"), ("iiwa", "dose")}
WRONG = ("--no-such-option", "--jobs=0", "--time-limit=-1", "--seed=x", "--cell=missing.yaml", "--output")
TEXTS = (
    *words("x main a,b joint_1=#3 deg,mm - -- é \udc80 ../x / out nan stream rapid all = , 1,2,3 irb140 iiwa7 tool0"),
    *("", " ", "a" * 5000),
)


@cache
def _commands() -> list[tuple[tuple[str, ...], Any]]:
    """Every command with its path."""
    from trajopt_cli.cli import app

    def inner(path: tuple[str, ...], one: Any) -> Iterator[tuple[tuple[str, ...], Any]]:
        for name, sub in getattr(one, "commands", {}).items():
            yield from inner((*path, name), sub)
        if not hasattr(one, "commands"):
            yield path, one

    return [*inner((), typer.main.get_command(app))]


def _value(rng: random.Random, parameter: Any, files: Sequence[str]) -> str:
    """Something for a parameter: a file where it takes one, mostly."""
    kind = parameter.type_descriptor.annotation
    if get_origin(kind) is Literal and rng.random() < 0.7:
        return str(rng.choice(get_args(kind)))
    if "Path" in str(kind) and rng.random() < 0.8:
        return rng.choice(files)
    if kind in (float, int):
        return rng.choice(("1", "2", "0.1", "100", "250", *NUMBERS)) if rng.random() < 0.9 else rng.choice(TEXTS)
    pick = rng.random()
    if pick < 0.4:
        return rng.choice(files)
    if pick < 0.8:
        return rng.choice(TEXTS)
    return rng.choice(NUMBERS) if pick < 0.9 else rng.choice(SIGNS)


def _make(files: Sequence[str], rng: random.Random, seeds: Sequence[bytes]) -> bytes:
    """A command line, NUL between its words."""
    path, one = rng.choice([each for each in _commands() if each[0] not in LEFT_OUT])
    line = list(path)
    bad = path in LONG  # what takes long is given something wrong
    if rng.random() < 0.02:
        line.insert(rng.randrange(len(line) + 1), rng.choice(TEXTS))
    for parameter in one.params:
        if parameter.param_type_name == "argument":
            count = rng.choice((1, 1, 1, 1, 0, 2))
            line += [_value(rng, parameter, files) for _ in range(count)]
        elif rng.random() < (0.6 if getattr(parameter, "required", False) else 0.25):
            if parameter.name in ("help",) and rng.random() < 0.8:
                continue
            line.append(rng.choice(parameter.opts))
            if parameter.type_descriptor.annotation is not bool:
                line.append(_value(rng, parameter, files))
    if bad or rng.random() < 0.1:
        line.append(
            rng.choice(
                ("--no-such-option", "--jobs=0", "--time-limit=-1", "--seed=x", "--cell=missing.yaml", "--output")
            )
        )
    kept = [word for word in line if "\0" not in word]
    return "\0".join(kept).encode("utf-8", "surrogateescape" if rng.random() < 0.9 else "surrogatepass")


def _line(path: Path) -> list[str]:
    words = path.read_bytes().decode("utf-8", "surrogateescape").split("\0")
    path.unlink()
    return words


def options_reader(here: Workspace) -> Reader:
    """The commands' options as a reader: its case is a command line."""
    names = (
        *words("tiny.mod tiny.yaml tiny.pgf task.yaml log.csv poses.csv cube.stl own.yaml own.urdf"),
        *("results", "task_results"),
    )

    def place(folder: Path, data: bytes) -> Path:
        for name in names:
            (folder / name).symlink_to(here.folder / name)
        (folder / "empty").write_bytes(b"")
        path = folder / "line"
        path.write_bytes(data)
        return path

    files = (*names, "empty", "missing.mod", ".", "out.csv", "results/stream.csv", "results/input/tiny.mod", os.devnull)
    return Reader("options", "line", [b"robot\0list"], (), None, _line, None, partial(_make, files), place)
