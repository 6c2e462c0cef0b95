"""Parts that may be done in any order: what they are in the text, what is written back, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import first_difference
from trajopt_cli.job import read_job
from trajopt_cli.motion import MoveJ, MoveL, SignalEvent
from trajopt_cli.problem.editable import Changes
from trajopt_cli.study.order_text import Group, group_of

CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 90, 0] deg'}\n"
TARGETS = "".join(
    f"  CONST robtarget p{i}:=[[{450 + 20 * i},{50 * i},600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    for i in range(4)
)
TARGETS += "  VAR num nCount:=0;\n"
CALLS = "  A; ! first\n  ! a comment between\n  B;\n  C;\n"


def group(folder: Path, main: str, order: str) -> Group:
    routines = "".join(
        f" PROC {name}()\n  MoveJ p{i}, v500, fine, tool0;\n  MoveL p0, v500, fine, tool0;\n ENDPROC\n"
        for i, name in enumerate("ABC", 1)
    )
    routines += " PROC Reg()\n  IF nCount>5 WaitTime 0.1;\n ENDPROC\n"
    (folder / "m.mod").write_bytes(
        f"MODULE m\n{TARGETS} PROC main()\n{main}  MoveJ p0, v500, fine, tool0;\n ENDPROC\n{routines}ENDMODULE\n"
        .replace("\n", "\r\n").encode()
    )  # fmt: skip
    (folder / "m.yaml").write_text(f"{CELL}order: {{g: {order}}}\nsettle: 0\n")
    return group_of(read_job(folder / "m.mod"))


def targets(found: Group, order: tuple[int, ...]) -> list[str]:
    return [motion.target for motion in found.program(order).motions if isinstance(motion, MoveJ | MoveL)]


def test_what_is_written_back_reads_as_the_program_in_that_order(tmp_path: Path) -> None:
    found = group(tmp_path, CALLS, "[B, A, C]")
    assert [part.name for part in found.parts] == ["A", "B", "C"]
    order = (2, 0, 1)
    assert targets(found, order) == ["p3", "p0", "p1", "p0", "p2", "p0", "p0"]
    assert found.why_not(order) is None
    text = found.text(order)
    assert "  C;\r\n  ! a comment between\r\n  A; ! first\r\n  B;\r\n" in text
    (tmp_path / "m.mod").write_bytes(text.encode())
    again = read_job(tmp_path / "m.mod").program
    assert first_difference(found.program(order), again) is None
    assert first_difference(found.job.program, again) == 0
    assert found.text((0, 1, 2)).encode() == group(tmp_path, CALLS, "[A, B, C]").text((0, 1, 2)).encode()


def test_parts_that_run_twice_are_refused_and_parts_like_what_follows_are_told_apart(tmp_path: Path) -> None:
    loop = "".join(f" PROC {name}()\n  MoveJ p{i}, v500, fine, tool0;\n ENDPROC\n" for i, name in enumerate("AB"))
    main = " PROC main()\n  Both;\n{more}  MoveJ p0, v500, fine, tool0;\n ENDPROC\n PROC Both()\n  A;\n  B;\n ENDPROC\n"
    (tmp_path / "m.yaml").write_text(f"{CELL}order: {{g: [A, B]}}\nsettle: 0\n")
    for more, motions in (("  MoveJ p0, v500, fine, tool0;\n", [(0, 1), (1, 2)]), ("  Both;\n", None)):
        (tmp_path / "m.mod").write_text(f"MODULE m\n{TARGETS}{main.format(more=more)}{loop}ENDMODULE\n")
        job = read_job(tmp_path / "m.mod")
        if motions is not None:
            assert [part.motions for part in group_of(job).parts] == motions
            continue
        with pytest.raises(
            InputError, match=r"order.g: its parts run 2 times; they have to stand in a routine that runs"
        ):
            group_of(job)


def test_parts_are_lines_with_outputs_and_waits_in_them_too(tmp_path: Path) -> None:
    main = "".join(
        f"  MoveJ p{i}, v500, fine, tool0;\n  SetDO do1, 1;\n  WaitTime 0.{i};\n  SetDO do1, 0;\n" for i in (1, 2, 3)
    )
    found = group(tmp_path, main, '["8-11", "12-15", "m.mod:16-19"]')
    assert found.why_not((2, 1, 0)) is None
    assert [part.motions for part in found.parts] == [(0, 4), (4, 8), (8, 12)]
    moved = found.program((1, 2, 0))
    assert isinstance(moved.motions[1], SignalEvent)
    assert moved.motions[0].source.line == 12
    changes = Changes(frozenset({0, 4, 12}), ties=((0, 8),))
    now = found.changes((1, 2, 0), changes)
    assert now.values == {8, 0, 12}
    assert now.ties == ((4, 8),)
    assert np.array_equal(sorted(found.indices((1, 2, 0))), range(13))


@pytest.mark.parametrize(
    ("main", "order", "said"),
    [
        ("  A;\n  nCount:=nCount+1;\n  B;\n", '[8, "9-10"]', None),
        (
            "  A;\n  nCount:=1;\n  B;\n  Reg;\n",
            '["8-9", "10-11"]',
            "ncount is changed in lines 8-9 and used in lines 10-11",
        ),
        ("  A;\n  Incr nCount;\n  B;\n  Reg;\n", '["8-9", "10-11"]', "ncount is changed in lines 8-9 and used in"),
        (
            "  A;\n  SetDO do1, 1;\n  B;\n  SetDO do1, 0;\n",
            '["8-9", "10-11"]',
            "do1 is left at 1 by lines 8-9 and at 0 by",
        ),
        ("  A;\n  ConfL\\Off;\n  B;\n  ConfL\\On;\n", '["8-9", "10-11"]', "asks for something else in that order"),
        ("  A;\n  GOTO on;\n  on:\n  B;\n", '["8-10", 11]', "lines 8-10 jumps or ends the routine (GOTO)"),
    ],
)
def test_what_parts_leave_to_each_other_is_not_written(tmp_path: Path, main: str, order: str, said: str | None) -> None:
    found = group(tmp_path, main, order)
    why = found.why_not((1, 0))
    if said is None:
        assert why is None
    else:
        assert why is not None
        assert said in why


@pytest.mark.parametrize(
    ("main", "order", "said"),
    [
        (CALLS, "[A, B, D]", "order.g: D: no statement calls it; known: main, A, B, C, Reg"),
        (CALLS + "  A;\n", "[A, B]", "order.g: A: 2 statements call it; a part is one call without arguments"),
        (CALLS, "[A, C]", "order.g: line 10 of"),
        (CALLS, "[A, A]", "order.g: two of its parts have a statement in common"),
        ("  A; B;\n", "[A, B]", "order.g: A: shares a line with other statements; give it lines of its own"),
        (CALLS, '["8-10", B]', "order.g: two of its parts have a statement in common"),
        (CALLS, '[A, "200"]', "order.g: 200: no statement of a routine begins there"),
        ("  A;\n  WaitTime 0;\n", "[A, 9]", None),
        ("  A;\n  nCount:=1;\n", "[A, 9]", "order.g: line 9: moves nothing"),
        ("  A;\n  EXIT;\n  B;\n", '["8-9", B]', "order.g: its parts run in part only; they have to stand in a routine"),
    ],
)
def test_a_group_that_is_none_is_one_line(tmp_path: Path, main: str, order: str, said: str | None) -> None:
    if said is None:
        assert group(tmp_path, main, order).parts[1].motions == (2, 3)
        return
    with pytest.raises(InputError) as refused:
        group(tmp_path, main, order)
    shown = refused.value.shown()
    assert shown.startswith(f"{tmp_path}/m.yaml:3: ")
    assert said in shown
    assert shown.strip().count("\n") == 0
