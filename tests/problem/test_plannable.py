"""What planning refuses, and what it lets pass."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from some_motions import RAIL, move_abs_j, move_c, move_ext_j, move_j, move_l, plant, program, wait

from trajopt_cli.errors import InputErrorGroup
from trajopt_cli.geometry import Array, pose, rotation_about
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
    Speed,
    Tool,
    Zone,
)
from trajopt_cli.problem.plannable import (
    SHOWN,
    check_plannable,
    demands_configuration,
    planned_otherwise,
    refusals,
    target_doubts,
)

LOCKED = Settings(singularity=Singularity.LOCK_AXIS_4)
STATIONARY = Tool("tGlue", np.eye(4), stationary=True)


def refused(*motions: Motion, cell: str | None = None) -> list[str]:
    with pytest.raises(InputErrorGroup) as caught:
        check_plannable(program(*motions), plant(cell) if cell else plant())
    return str(caught.value).splitlines()


def passes(*motions: Motion, cell: str | None = None) -> bool:
    check_plannable(program(*motions), plant(cell) if cell else plant())
    return True


@pytest.mark.parametrize(
    ("motion", "kind"),
    [
        (move_l(tool=STATIONARY), "stationary tools"),
        (replace(move_abs_j(), tool=STATIONARY), "stationary tools"),
        (move_l(settings=LOCKED), "SingArea"),
        (move_l(zone=Zone("z10", stop=True, criterion="stoptime0_5")), "stop times"),
        (move_ext_j(target="j_turn"), "external axes"),
    ],
)
def test_what_no_plan_keeps_is_refused_with_its_place(motion: Motion, kind: str) -> None:
    found = refusals(program(wait(), motion), plant())
    assert [(one.kind, str(one.source)) for one in found] == [(kind, "m.mod:2:5")]
    assert refused(wait(), motion) == [f"m.mod:2:5: {found[0].message}"]


def test_other_external_axes_may_stand_but_not_move() -> None:
    def at(a: float | None, b: float | None) -> Motion:
        return move_j(extax=(a, b, None, None, None, None))

    assert passes(at(0, None), at(None, None), at(-0.0089, None))
    assert refused(at(0, None), at(None, 5), at(90, 5)) == [
        "m.mod:3:5: MoveJ p moves eax_a from 0 to 90; describe eax_a in the cell file under rail, axes or positioners, "
        "else hold it still"
    ]
    (both,) = refused(at(0, 0), at(90, 5))
    assert "eax_a from 0 to 90" in both
    assert "eax_b from 0 to 5" in both
    assert passes(at(None, 0), at(None, 900), at(None, 1000), cell=RAIL)
    assert passes(move_ext_j(extax=(None, 900, None, None, None, None)), cell=RAIL)
    assert refused(at(30, 0), at(45, 900), cell=RAIL) == [
        "m.mod:2:5: MoveJ p moves eax_a from 30 to 45; describe eax_a in the cell file under axes (a linear one under "
        "the base) or positioners, else hold it still; of those the cell knows eax_b"
    ]


def test_what_changes_no_plan_passes() -> None:
    settings = Settings(
        conf_j=False,
        conf_l=False,
        override=0.5,
        v_max=0.8,
        displaced=True,
        acceleration=0.5,
        ramp=0.3,
        path_acceleration=2.0,
        path_deceleration=3.5,
        world_acceleration=3.0,
        load=Load("part", 2.0, (0, 0, 0.1), (1, 0, 0, 0), (0, 0, 0)),
    )
    event = PathEvent(Happens.SIGNAL, "do1", 1.0)
    assert passes(
        move_j(settings=replace(settings, singularity=Singularity.WRIST)),  # joint moves have no orientation to leave
        move_j(settings=Settings(singularity=Singularity.LOCK_AXIS_4)),
        move_l(settings=Settings(singularity=Singularity.WRIST)),
        move_abs_j(settings=settings),
        move_l(settings=settings, events=(event,), process=Process("SearchL")),
        move_l(zone=Zone("z10", stop=True, criterion="inpos50")),
        wait(),
    )


def test_a_motion_is_named_once_for_each_thing_it_asks_for() -> None:
    motion = replace(
        move_l(tool=STATIONARY, settings=Settings(singularity=Singularity.LOCK_AXIS_4)), source=Source("m.mod", 7, 3)
    )
    found = refused_as_they_are(*[motion] * 100)
    assert [line.split()[0] for line in found] == ["m.mod:7:3:"] * 2
    assert len(set(found)) == 2


def refused_as_they_are(*motions: Motion) -> list[str]:
    with pytest.raises(InputErrorGroup) as caught:
        check_plannable(replace(program(), motions=motions), plant())
    return str(caught.value).splitlines()


def test_a_thousand_of_them_are_counted() -> None:
    found = refused(*[move_l(settings=LOCKED) for _ in range(15)], *[move_l(tool=STATIONARY) for _ in range(15)])
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


def test_settings_that_a_plan_keeps_its_own_way_are_said() -> None:
    wrist, capped = Settings(singularity=Singularity.WRIST), Settings(path_acceleration=2.0, acceleration=0.5)
    many = program(
        move_l(settings=wrist),
        move_c(settings=wrist),
        move_j(settings=wrist),
        move_j(settings=Settings(ramp=0.5, acceleration=0.5)),
        move_l(settings=capped),
        move_abs_j(settings=capped),
        move_j(settings=Settings(path_deceleration=3.0)),
    )
    assert planned_otherwise(many) == (
        "lines that may leave their orientation (SingArea \\Wrist, 2) are planned with the exact one",
        "AccSet's ramp (1) does not affect the plan: it shapes jerk, which the cell file alone limits",
    )
    assert planned_otherwise(program(move_l(settings=Settings(acceleration=0.5, world_acceleration=2.0)))) == ()


def test_times_beside_a_fly_by_are_counted() -> None:
    """Also that of the move behind it; not where a wait makes it a stop."""
    at = [pose(np.eye(3), [0.1 * k, 0, 0]) for k in range(5)]
    z, timed = Zone("z10", False, 0.01, 0.015, 0.015, 0.03, 0.015, 0.03), {"duration": 1.0}
    passed = move_l(at[1]), move_l(at[2], zone=z, **timed), move_l(at[3], **timed), move_l(at[4], **timed)
    assert any("(\\T, 2)" in line for line in planned_otherwise(program(*passed)))
    assert planned_otherwise(program(*passed[:2], wait(), *passed[2:])) == ()


def eax(**given: float) -> ExternalAxes:
    a, b, c, d, e, f = (given.get(letter) for letter in "abcdef")
    return (a, b, c, d, e, f)


def test_targets_that_speak_of_another_axis_than_the_rail_are_doubted() -> None:
    """The rail of the cell is axis b."""
    said = "targets give external axis a, the cell's rail is axis b, for which none gives a value"
    on_a = program(move_j(extax=eax(a=100)), move_l(extax=eax(a=200)), wait(), move_l())
    assert target_doubts(on_a, plant(RAIL)) == (said,)
    assert target_doubts(on_a, plant()) == ()
    both = program(move_j(extax=eax(a=100, f=1)))
    assert target_doubts(both, plant(RAIL)) == (said.replace("axis a", "axes a and f"),)


def test_targets_without_a_place_for_the_rail_are_counted() -> None:
    some = program(move_j(extax=eax(b=100)), move_l(extax=eax(a=5)), move_l(), move_abs_j(extax=eax(b=0)))
    said = "m.mod:2:5: 2 targets give no position for the rail (9E9 on axis b): a controller stops, a plan stays"
    assert target_doubts(some, plant(RAIL)) == (said,)
    assert target_doubts(program(wait(), move_j(extax=eax(b=1)), wait()), plant(RAIL)) == ()
    one = "m.mod:1:5: 1 target gives no position for the rail (9E9 on axis b): a controller stops, a plan stays"
    assert target_doubts(program(move_j()), plant(RAIL)) == (one,)


def test_the_two_switches_for_confdata_are_each_for_their_own_moves() -> None:
    robot = plant(RAIL).robot
    for conf_j in (False, True):
        for conf_l in (False, True):
            settings = replace(DEFAULT_SETTINGS, conf_j=conf_j, conf_l=conf_l)
            assert demands_configuration(move_j(settings=settings), robot) is conf_j
            assert demands_configuration(move_l(settings=settings), robot) is conf_l
            assert demands_configuration(move_c(settings=settings), robot) is conf_l
    assert not demands_configuration(move_abs_j(), robot)
    unruled = replace(robot, confdata_rule="none")  # an arm that confdata does not describe
    assert not demands_configuration(move_j(), unruled)
    assert not demands_configuration(move_l(), unruled)


BARE = Speed("bare", 0.1, 0.0, 0.0, 0.0)
NO_RAIL = Speed("no_rail", 0.1, 1.0, 0.0, 1.0)


def turned(angle: float, x: float = 0.5) -> Array:
    return pose(rotation_about([0, 0, 1], np.radians(angle)) @ np.diag([-1.0, 1, -1]), [x, 0, 0.4])


@pytest.mark.parametrize(
    ("motions", "lines"),
    [
        ((move_j(turned(0)), move_l(turned(10), speed=BARE)), [2]),
        ((move_j(turned(0)), move_j(turned(-10), speed=BARE), move_l(turned(-10, 0.6), speed=BARE)), [2]),
        ((move_abs_j(), move_abs_j(np.array([0, 0, 0, 0, 0.5, 0.2]), speed=BARE)), [2]),
        ((move_j(turned(0)), move_l(turned(0, 0.6), speed=BARE), move_l(turned(90), speed=BARE, duration=2.0)), []),
        ((move_j(turned(0), extax=eax(b=0)), move_l(turned(5), extax=eax(b=100), speed=BARE)), [2, 2]),
        ((move_j(turned(0), extax=eax(b=0)), move_l(turned(5), extax=eax(b=100), speed=NO_RAIL)), [2]),
        ((move_j(turned(0), extax=eax(b=0)), move_j(turned(0), extax=eax(b=0), speed=NO_RAIL)), []),
        ((move_ext_j(extax=eax(b=300), speed=NO_RAIL), move_ext_j(extax=eax(b=300), speed=BARE)), [1]),
        ((move_abs_j(extax=eax(b=300)), move_abs_j(extax=eax(b=-100), speed=NO_RAIL)), [2]),
    ],
)
def test_a_speed_of_0_is_refused_where_something_moves_by_it(motions: tuple[Motion, ...], lines: list[int]) -> None:
    found = [one for one in refusals(program(*motions), plant(RAIL)) if one.kind.endswith("of 0")]
    assert [one.source.line for one in found] == lines


def test_joint_moves_whose_speed_the_cell_frees_need_none() -> None:
    motions = (move_j(turned(0)), move_j(turned(10), speed=BARE), move_l(turned(0), speed=BARE))
    found = refusals(program(*motions), replace(plant(RAIL), free_speed=True))
    assert [one.source.line for one in found] == [3]


@pytest.mark.parametrize(("scale", "doubts"), [(1e-3, 1), (1.0, 0)])
def test_targets_in_metres_are_doubted(scale: float, doubts: int) -> None:
    """600.5 mm written as 0.6005: in the work object's frame, wherever that stands."""
    X_WO = pose(np.eye(3), [1.0, 0.3, 0.2])
    places = [np.array(p) * scale for p in ([0.6005, 0.1, 0.5], [0.6, 0.25, 0.4])]
    moves = [replace(move_j(extax=eax(b=0)), X_WO=X_WO, X_WT=X_WO @ pose(np.eye(3), p)) for p in places]
    assert len(target_doubts(program(*moves), plant(RAIL))) == doubts
