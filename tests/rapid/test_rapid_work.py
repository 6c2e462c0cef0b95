"""Work that a program costs, counted: what a loop lacks is looked up once, not on every pass."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from contextlib import suppress

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.execution import context, loops
from trajopt_cli.rapid.language.syntax import walk
from trajopt_cli.rapid.reader import try_program
from trajopt_cli.scenario import Scenario


def program(body: str, declared: str = "") -> list[TextFile]:
    return [TextFile("m.mod", f"MODULE m\n{declared}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n", "utf-8")]


@pytest.mark.parametrize(
    "body",
    [
        "no_such 1;",
        "x:=no_such(1);",
        "IF no_such(1) > 2 x:=1;",
        "no_such:=x;",
        "p:=no_such;",
        "x:=no_such.trans.x;",
        "WaitUntil no_such(1) = 1 OR di1 = 1;",
        "x:=x + 1; x:=x + no_such{x};",
    ],
)
def test_what_a_loop_lacks_is_looked_up_once(body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[str] = []

    def counted(word: str, *rest: object, **more: object) -> list[str]:
        looked.append(word)
        return difflib.get_close_matches(word, *rest, **more)  # type: ignore[call-overload,no-any-return]

    monkeypatch.setattr(context, "get_close_matches", counted)
    declared = "VAR num x:=0;\nVAR robtarget p;"
    with suppress(InputError):  # where something moves or waits the loop is one that never ends, and is over
        try_program(program(f"WHILE di_go = 0 DO\n{body}\nENDWHILE", declared), Scenario(pass_limit=300))
    assert looked
    assert looked.count("no_such") <= 2, "once as what the loop reads, at most once more as another type"


def test_loops_of_a_routine_share_the_count_of_its_names(monkeypatch: pytest.MonkeyPatch) -> None:
    walked = 0

    def counted(node: object) -> Iterator[object]:
        nonlocal walked
        for one in walk(node):
            walked += 1
            yield one

    monkeypatch.setattr(loops, "walk", counted)
    count = 200
    found, lacks = try_program(program("WHILE x = 1 DO\ny:=1;\nENDWHILE\n" * count, "VAR num x;\nVAR num y;"))
    assert not lacks
    assert not found.motions
    assert walked < 20 * count  # the routine has 8 nodes a loop
