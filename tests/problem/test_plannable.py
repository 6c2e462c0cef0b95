"""What planning refuses, each thing by its sentence, and what it lets pass."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from some_motions import (
    RAIL,
    move_abs_j,
    move_c,
    move_ext_j,
    move_j,
    move_l,
    plant,
    program,
    wait,
)

from trajopt_cli.errors import InputErrorGroup
from trajopt_cli.motion import (
    DEFAULT_SETTINGS,
    ExternalAxes,
    Happens,
    Load,
    Motion,
    PathEvent,
    Process,
    Settings,
    Singularity,
    Source,
    Tool,
    Zone,
)
from trajopt_cli.problem.plannable import SHOWN, check_plannable, demands_configuration, planned_otherwise, rail_doubts

STATIONARY = Tool("tGlue", np.eye(4), stationary=True)


def refused(*motions: Motion, cell: str | None = None) -> list[str]:
    with pytest.raises(InputErrorGroup) as caught:
        check_plannable(program(*motions), plant(cell) if cell else plant())
    return str(caught.value).splitlines()


def passes(*motions: Motion, cell: str | None = None) -> bool:
    check_plannable(program(*motions), plant(cell) if cell else plant())
    return True


@pytest.mark.parametrize(
    ("motion", "line"),
    [
        (
            move_c(target="p2"),
            "MoveC p2 is an arc, which is read but not planned yet; replace it by lines (MoveL) to be planned",
        ),
        (
            move_c(target="p2", process=Process("ArcC")),
            "ArcC p2 is an arc, which is read but not planned yet; replace it by lines (MoveL) to be planned",
        ),
        (
            move_l(tool=STATIONARY),
            "MoveL p carries the workpiece to the stationary tool tGlue (robhold FALSE); plans support only a "
            "tool on the flange (robhold TRUE)",
        ),
        (
            replace(move_abs_j(), tool=STATIONARY),
            "MoveAbsJ j carries the workpiece to the stationary tool tGlue (robhold FALSE); plans support only a "
            "tool on the flange (robhold TRUE)",
        ),
        (
            move_l(settings=Settings(singularity=Singularity.WRIST)),
            "MoveL p may leave its orientation (SingArea \\Wrist); plans keep the exact orientation: set SingArea "
            "\\Off before it",
        ),
        (
            move_l(settings=Settings(singularity=Singularity.LOCK_AXIS_4)),
            "MoveL p may leave its orientation (SingArea \\LockAxis4); plans keep the exact orientation: set SingArea "
            "\\Off before it",
        ),
        (
            move_j(settings=Settings(acceleration=0.5)),
            "MoveJ p asks for reduced acceleration (AccSet 50, 100); plans use the cell file's limits: set AccSet "
            "100, 100 before it and lower the accelerations there",
        ),
        (
            move_abs_j(settings=Settings(ramp=0.3)),
            "MoveAbsJ j asks for reduced acceleration (AccSet 100, 30); plans use the cell file's limits: set AccSet "
            "100, 100 before it and lower the accelerations there",
        ),
        (
            move_l(settings=Settings(path_acceleration=4.0)),
            "MoveL p limits the TCP to 4 m/s² (PathAccLim); plans use the cell's 20 m/s²: lower tcp.acceleration "
            "in the cell file to 4",
        ),
        (
            move_l(settings=Settings(path_deceleration=3.5)),
            "MoveL p limits the TCP to 3.5 m/s² (PathAccLim); plans use the cell's 20 m/s²: lower "
            "tcp.acceleration in the cell file to 3.5",
        ),
        (
            move_j(settings=Settings(world_acceleration=2.0)),
            "MoveJ p limits the TCP to 2 m/s² (WorldAccLim); plans use the cell's 20 m/s²: lower "
            "tcp.acceleration in the cell file to 2",
        ),
        (
            move_l(zone=Zone("z10", stop=True, criterion="stoptime0_5")),
            "MoveL p stops by stoptime0_5, whose time is not planned; plans support only a plain stop: use fine or "
            "\\Inpos with inpos20, inpos50, inpos100, and a WaitTime",
        ),
        (
            move_ext_j(target="j_turn"),
            "MoveExtJ j_turn moves external axes only, and the cell has none; the cell knows no external axis: add a "
            "rail section if eax_a is one, else hold it still",
        ),
    ],
)
def test_what_no_plan_keeps_is_refused_with_its_place(motion: Motion, line: str) -> None:
    assert refused(wait(), motion) == [f"m.mod:2:5: {line}"]


def test_other_external_axes_may_stand_but_not_move() -> None:
    def at(a: float | None, b: float | None) -> Motion:
        return move_j(extax=(a, b, None, None, None, None))

    assert passes(at(0, None), at(None, None), at(-0.0089, None))
    assert refused(at(0, None), at(None, 5), at(90, 5)) == [
        "m.mod:3:5: MoveJ p moves eax_a from 0 to 90; the cell knows no external axis: add a rail section if eax_a is "
        "one, else hold it still"
    ]
    assert passes(at(None, 0), at(None, 900), at(None, 1000), cell=RAIL)
    assert passes(move_ext_j(extax=(None, 900, None, None, None, None)), cell=RAIL)
    assert refused(at(30, 0), at(45, 900), cell=RAIL) == [
        "m.mod:2:5: MoveJ p moves eax_a from 30 to 45; the cell knows only its rail, eax_b: hold the other axes still"
    ]


def test_what_changes_no_plan_passes() -> None:
    settings = Settings(
        conf_j=False,
        conf_l=False,
        override=0.5,
        v_max=0.8,
        displaced=True,
        path_acceleration=20.0,
        world_acceleration=30.0,
        load=Load("part", 2.0, (0, 0, 0.1), (1, 0, 0, 0), (0, 0, 0)),
    )
    event = PathEvent(Happens.SIGNAL, "do1", 1.0)
    assert passes(
        move_j(settings=replace(settings, singularity=Singularity.WRIST)),  # joint moves have no orientation to leave
        move_l(settings=settings, events=(event,), process=Process("SearchL")),
        move_l(zone=Zone("z10", stop=True, criterion="inpos50")),
        wait(),
    )


def test_a_motion_is_named_once_for_each_thing_it_asks_for() -> None:
    motion = replace(
        move_c(tool=STATIONARY, settings=Settings(acceleration=0.5, ramp=0.5)), source=Source("m.mod", 7, 3)
    )
    found = refused_as_they_are(*[motion] * 100)
    assert [line.split()[0] for line in found] == ["m.mod:7:3:"] * 3
    assert len(set(found)) == 3


def refused_as_they_are(*motions: Motion) -> list[str]:
    with pytest.raises(InputErrorGroup) as caught:
        check_plannable(replace(program(), motions=motions), plant())
    return str(caught.value).splitlines()


def test_a_thousand_of_them_are_counted() -> None:
    found = refused(*[move_c() for _ in range(15)], *[move_l(tool=STATIONARY) for _ in range(15)])
    assert len(found) == SHOWN + 1
    assert found[-1] == "and 10 more that cannot be planned: stationary tools 10"


def test_what_is_planned_otherwise_is_said_once() -> None:
    off, event = Settings(conf_j=False, conf_l=False), PathEvent(Happens.SIGNAL, "do1", 1.0)
    load = Load("part", 2.0, (0, 0, 0.1), (1, 0, 0, 0), (0, 0, 0))
    assert planned_otherwise(program(move_j(), move_l(), wait())) == ()
    assert planned_otherwise(program(move_l(settings=off), move_l(settings=off))) == (
        "confdata is ignored on lines (ConfL \\Off), as the program asks",
    )
    many = program(
        move_j(settings=off),
        move_l(settings=replace(off, load=load), events=(event, event)),
        move_l(process=Process("ArcL")),
        move_l(process=Process("ArcL")),
        move_l(process=Process("SearchL")),
    )
    assert planned_otherwise(many) == (
        "confdata is ignored on joint moves (ConfJ \\Off) and on lines (ConfL \\Off), as the program asks",
        "path events (2) take no time and do not affect the plan",
        "process instructions are planned as the plain moves they make: ArcL 2, SearchL 1",
        "loads (part) do not affect the plan: the cell's acceleration limits apply to any load",
    )


def eax(**given: float) -> ExternalAxes:
    a, b, c, d, e, f = (given.get(letter) for letter in "abcdef")
    return (a, b, c, d, e, f)


def test_targets_that_speak_of_another_axis_than_the_rail_are_doubted() -> None:
    """The rail of the cell is axis b."""
    said = "targets give external axis a, the cell's rail is axis b, for which none gives a value"
    on_a = program(move_j(extax=eax(a=100)), move_l(extax=eax(a=200)), wait(), move_l())
    assert rail_doubts(on_a, plant(RAIL)) == (said,)
    assert rail_doubts(on_a, plant()) == ()
    both = program(move_j(extax=eax(a=100, f=1)))
    assert rail_doubts(both, plant(RAIL)) == (said.replace("axis a", "axes a and f"),)


def test_targets_without_a_place_for_the_rail_are_counted() -> None:
    some = program(move_j(extax=eax(b=100)), move_l(extax=eax(a=5)), move_l(), move_abs_j(extax=eax(b=0)))
    said = "m.mod:2:5: 2 targets give no position for the rail (9E9 on axis b): it keeps its last one"
    assert rail_doubts(some, plant(RAIL)) == (said,)
    assert rail_doubts(program(wait(), move_j(extax=eax(b=1)), wait()), plant(RAIL)) == ()
    one = "m.mod:1:5: 1 target gives no position for the rail (9E9 on axis b): it keeps its last one"
    assert rail_doubts(program(move_j()), plant(RAIL)) == (one,)


def test_the_two_switches_for_confdata_are_each_for_their_own_moves() -> None:
    for conf_j in (False, True):
        for conf_l in (False, True):
            settings = replace(DEFAULT_SETTINGS, conf_j=conf_j, conf_l=conf_l)
            assert demands_configuration(move_j(settings=settings)) is conf_j
            assert demands_configuration(move_l(settings=settings)) is conf_l
            assert demands_configuration(move_c(settings=settings)) is conf_l
    assert not demands_configuration(move_abs_j())
