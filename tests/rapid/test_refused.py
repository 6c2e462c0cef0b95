"""Programs that are refused, and with what words: refused.txt, which a person reads when a sentence changes.

An entry of the file is a program, each line behind a bar, and what is said of it, the file's name left out. To write
the sentences anew after a change: python tests/rapid/test_refused.py
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.reader import run_program

FILE = Path(__file__).parent / "refused.txt"


def entries() -> Iterator[tuple[str, str]]:
    """Each program with its sentences."""
    for entry in FILE.read_text(encoding="utf-8").split("\n\n"):
        lines = entry.rstrip("\n").split("\n")
        program = [line[2:] for line in lines if line.startswith("|")]
        yield "\n".join(program), "\n".join(lines[len(program) :])


def sentences(program: str) -> str:
    """What is said of a program that is refused, and nothing of one that is not."""
    try:
        run_program([TextFile("m.mod", program, "utf-8")])
    except InputError as error:
        return str(error).replace("m.mod:", "")
    return "not refused"


@pytest.mark.parametrize(("program", "expected"), list(entries()))
def test_a_program_is_refused_with_its_sentence_and_place(program: str, expected: str) -> None:
    assert sentences(program) == expected


if __name__ == "__main__":
    anew = ["".join(f"| {line}".rstrip() + "\n" for line in one.split("\n")) + sentences(one) for one, _ in entries()]
    FILE.write_text("\n\n".join(anew) + "\n", encoding="utf-8")
