"""Moves of every form: frames, displacement, what is shared, arcs, corners, and what is warned about."""

from __future__ import annotations

from dataclasses import MISSING, fields
from math import pi, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about, rotation_from_wxyz
from trajopt_cli.motion import (
    CirPathMode,
    Happens,
    Move,
    MoveAbsJ,
    MoveC,
    MoveJ,
    MoveL,
    Program,
    Singularity,
    TextFile,
    Written,
)
from trajopt_cli.path.circle import circle_through
from trajopt_cli.path.line import Line
from trajopt_cli.rapid.data.frames import between, frame, matrix
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.rapid.zones import effective_radii
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import Source, WarningKind

N = "[9E9,9E9,9E9,9E9,9E9,9E9]"
SINGLE = 2e-6  # what the 24 bits of a num make of four metre-long frames in a row [m]
LOAD = "[1,[0,0,1],[1,0,0,0],0,0,0]"


def run_main(body: str, data: str = "", rest: str = "", scenario: Scenario | None = None) -> Program:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], scenario)


def moves(program: Program) -> list[Move]:
    return [motion for motion in program.motions if isinstance(motion, Move)]


def at(x: float, y: float, z: float, q: str = "[0,0,1,0]") -> str:
    return f"[[{x},{y},{z}],{q},[0,0,0,0],{N}]"


def error_main(body: str, data: str = "", scenario: Scenario | None = None) -> str:
    with pytest.raises(InputError) as caught:
        run_main(body, data, scenario=scenario)
    return str(caught.value)


# ------------------------------------------------------------------------------------------------------------ frames

quaternions = (
    st.tuples(*[st.floats(-1, 1)] * 4)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: tuple(float(value) for value in np.array(q) / np.linalg.norm(q)))
)
vectors = st.tuples(*[st.floats(-1000, 1000).map(lambda v: round(v, 3))] * 3)
poses = st.tuples(vectors, quaternions)


def written(value: object) -> str:
    return "[" + ",".join(map(written, value)) + "]" if isinstance(value, tuple) else f"{value:.17g}"


def array(value: tuple[tuple[float, ...], tuple[float, ...]]) -> Array:
    return pose(rotation_from_wxyz(value[1]), np.array(value[0]) * 1e-3)


@given(poses)
def test_a_frame_as_a_matrix_is_what_the_textbook_says(value: tuple[tuple[float, ...], tuple[float, ...]]) -> None:
    X = matrix(value)  # type: ignore[arg-type]
    np.testing.assert_allclose(X, array(value), rtol=0, atol=1e-14)
    assert not X.flags.writeable
    np.testing.assert_allclose(matrix(frame(X)), X, rtol=0, atol=1e-12)


@settings(max_examples=25, deadline=None)
@given(poses, poses, poses, poses, poses)
def test_user_object_displacement_target_and_tool_in_this_order(u, o, d, p, t) -> None:  # type: ignore[no-untyped-def]
    data = (
        f'PERS wobjdata w:=[FALSE,TRUE,"",{written(u)},{written(o)}];\n'
        f"PERS tooldata t:=[TRUE,{written(t)},{LOAD}];\n"
        f"CONST robtarget p:=[{written(p[0])},{written(p[1])},[0,0,0,0],{N}];\n"
    )
    body = f"PDispSet {written(d)}; MoveL p,v100,fine,t\\WObj:=w;"
    (move,) = run_main(body, data).motions
    assert isinstance(move, MoveL)
    np.testing.assert_allclose(move.X_WT, array(u) @ array(o) @ array(d) @ array(p), atol=SINGLE)
    np.testing.assert_allclose(move.tool.X_FT, array(t), atol=SINGLE)
    assert move.X_WO is not None
    np.testing.assert_allclose(move.X_WO, array(u) @ array(o) @ array(d), atol=SINGLE)
    assert move.settings.displaced


@settings(max_examples=25, deadline=None)
@given(poses, poses, poses, poses, poses)
def test_a_stationary_tool_stands_in_the_world_and_the_frames_on_the_flange(u, o, v, p, t) -> None:  # type: ignore[no-untyped-def]
    data = (
        f'PERS wobjdata w:=[TRUE,TRUE,"",{written(u)},{written(o)}];\n'
        f"PERS tooldata t:=[FALSE,{written(t)},{LOAD}];\n"
        f"CONST robtarget p:=[{written(p[0])},{written(p[1])},[0,0,0,0],{N}];\n"
        f"CONST robtarget v:=[{written(v[0])},{written(v[1])},[0,0,0,0],{N}];\n"
        f"VAR robtarget r;\n"
    )
    if np.linalg.norm(np.array(p[0]) - v[0]) < 0.2:
        return
    body = "MoveC v,p,v100,fine,t\\WObj:=w; r:=CRobT(\\Tool:=tool0\\WObj:=wobj0); MoveL r,v100,fine,tool0;"
    arc_move, plain = run_main(body, data).motions
    assert isinstance(arc_move, MoveC)
    assert isinstance(plain, MoveL)
    assert arc_move.tool.stationary
    assert arc_move.X_WO is None
    np.testing.assert_allclose(arc_move.X_WT, array(t), atol=SINGLE)
    X_WF = array(t) @ inverse_pose(array(u) @ array(o) @ array(p))
    np.testing.assert_allclose(arc_move.X_WT @ inverse_pose(arc_move.tool.X_FT), X_WF, atol=SINGLE)
    np.testing.assert_allclose(plain.X_WT, X_WF, atol=SINGLE)
    via = array(t) @ inverse_pose(array(u) @ array(o) @ array(v))
    np.testing.assert_allclose(arc_move.X_WV @ inverse_pose(arc_move.tool.X_FT), via, atol=SINGLE)


def test_what_does_not_change_is_shared_and_what_changes_is_not_served_stale() -> None:
    data = (
        f"PERS tooldata t:=[TRUE,[[0,0,100],[1,0,0,0]],{LOAD}];\n"
        'PERS wobjdata w:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,50],[1,0,0,0]]];\nVAR speeddata s:=[100,1,1,1];\n'
    )
    line = f"MoveL {at(500, 0, 600)},s,z10,t\\WObj:=w; "
    body = (
        line * 2
        + "t.tframe.trans.z:=120; s.v_tcp:=50; "
        + line
        + "w.oframe.trans.z:=70; ConfL\\On; "
        + line
        + "ConfL\\Off; "
        + line
    )
    a, b, c, d, e = moves(run_main(body, data))
    assert all(isinstance(move, MoveL) for move in (a, b, c, d, e))
    for name in ("speed", "zone", "tool", "X_WO", "settings"):
        assert getattr(a, name) is getattr(b, name), name
    assert isinstance(c, MoveL)
    assert isinstance(d, MoveL)
    assert isinstance(a, MoveL)
    assert (c.tool.X_FT[2, 3], c.speed.v_tcp) == (0.12, 0.05)
    assert a.tool.X_FT[2, 3] == 0.1
    assert c.zone == a.zone
    assert c.settings is a.settings  # ConfL \On changes nothing
    np.testing.assert_allclose([m.X_WT[2, 3] for m in (a, c, d)], [0.65, 0.65, 0.67], atol=1e-15)
    assert d.X_WO is not None
    assert c.X_WO is not None
    assert d.X_WO[2, 3] == pytest.approx(0.07)
    assert c.X_WO[2, 3] == pytest.approx(0.05)
    assert (d.settings.conf_l, e.settings.conf_l, e.settings.conf_j) == (True, False, True)


def test_two_local_tools_of_one_name_are_two_tools() -> None:
    rest = "".join(
        f"PROC go{i}()\nVAR tooldata t:=[TRUE,[[0,0,{i}],[1,0,0,0]],{LOAD}];\n"
        f"MoveL {at(1, 2, 3)},v100,fine,t;\nENDPROC\n"
        for i in (10, 20)
    )
    heights = [m.tool.X_FT[2, 3] for m in moves(run_main("go10; go20; go10;", rest=rest)) if isinstance(m, MoveL)]
    assert heights == [0.01, 0.02, 0.01]


@pytest.mark.parametrize("kind", [MoveJ, MoveL, MoveC])
def test_motions_made_in_bulk_have_every_field_without_a_default(kind: type[Move]) -> None:
    points = at(550, 50, 600) + "," + at(600, 0, 600) if kind is MoveC else at(600, 0, 600)
    (move,) = run_main(f"{kind.__name__} {points},v100,z10,tool0;").motions
    assert type(move) is kind
    assert {field.name for field in fields(kind) if field.default is MISSING} <= set(vars(move))
    assert set(vars(move)) <= {field.name for field in fields(kind)}
    assert move.written == Written(*move.written)
    for name, value in vars(move).items():
        assert not isinstance(value, np.ndarray) or not value.flags.writeable, name


# ---------------------------------------------------------------------------------------------------- ways and arcs


@given(poses, poses, st.floats(0, 1))
def test_the_share_of_a_line_is_chord_and_slerp(a, b, share: float) -> None:  # type: ignore[no-untyped-def]
    if abs(abs(np.dot(a[1], b[1]))) < 1e-3:
        return  # half a turn apart: either way is the shorter one
    p, q = between(a, b, share)
    wanted = Line(array(a), array(b)).pose(np.array([share]))[0]
    np.testing.assert_allclose(matrix((p, q)), wanted, atol=1e-9)


@given(
    poses,
    st.floats(1, 500),
    st.floats(0.05, 0.95),
    st.floats(0.1, 2 * pi - 0.1),
)
def test_an_arc_through_three_points_of_a_circle_is_that_circle(  # type: ignore[no-untyped-def]
    where, size: float, via: float, angle: float
) -> None:
    def point(turn: float) -> tuple[float, float, float]:
        local = rotation_about([0, 0, 1], turn) @ [size, 0, 0]
        x, y, z = rotation_from_wxyz(where[1]) @ local + where[0]
        return float(x), float(y), float(z)

    circle = circle_through(point(0), point(via * angle), point(angle))
    assert circle is not None
    assert circle.angle == pytest.approx(angle, abs=1e-5)
    assert np.linalg.norm(np.subtract(point(0), circle.centre)) == pytest.approx(size, rel=1e-4)


def test_three_points_on_a_line_are_no_circle_but_a_warning() -> None:
    assert circle_through((0, 0, 0), (1, 1, 1), (2, 2, 2)) is None
    program = run_main(
        f"MoveL {at(0, 0, 500)},v100,fine,tool0; MoveC {at(50, 0, 500)},{at(90, 0, 500)},v100,fine,tool0;"
    )
    (warning,) = tuple(map(str, program.warnings))
    assert "lie on one line, not on a circle" in warning


def test_a_circle_whose_start_only_the_robot_knows_is_checked_as_far_as_possible() -> None:
    home = f"MoveAbsJ [[0,0,0,0,0,0],{N}],v100,fine,tool0; "
    assert len(run_main(home + f"MoveC {at(5, 0, 5)},{at(9, 0, 5)},v100,fine,tool0;").motions) == 2
    assert "are 0.05 mm apart" in error_main(home + f"MoveC {at(5, 0, 5)},{at(5.05, 0, 5)},v100,fine,tool0;")


# ------------------------------------------------------------------------------------------------------------ zones


def corners(body: str) -> list[float | None]:
    return [None if r is None else round(r * 1e3, 9) for r in effective_radii(run_main(body))]


def line(x: float, y: float, zone: str = "z50", tool: str = "tool0") -> str:
    return f"MoveL {at(x, y, 500)},v100,{zone},{tool};"


def test_corners_end_at_the_middle_of_the_way() -> None:
    body = line(0, 0) + line(40, 0) + line(40, 300) + line(40, 310, "z5") + line(500, 310, "fine")
    assert corners(body) == [None, 20, 5, 5, 0]


def test_corners_next_to_joint_moves_are_unknown() -> None:
    home = f"MoveAbsJ [[0,0,0,0,0,0],{N}],v100,z10,tool0;"
    assert corners(home + line(0, 0) + line(100, 0) + line(200, 0) + home + line(0, 0, "fine")) == [
        *(None, None, 50, None, None, 0)
    ]


def test_corners_before_waits_are_stops_unless_the_wait_is_nothing() -> None:
    body = line(0, 0, "fine") + line(100, 0, "z10") + "{}" + line(200, 0, "fine")
    assert corners(body.format("WaitTime 0.1;"))[1] == 0
    assert corners(body.format("WaitDI di1,1;"))[1] == 0
    assert corners(body.format("WaitTime 0;"))[1] == 10
    assert corners(body.format("WaitTime\\InPos, 0;"))[1] == 0
    assert corners(body.format("WaitRob\\ZeroSpeed;"))[1] == 0
    assert corners(body.format("WaitRob;"))[1] == 10
    assert corners(body.format("SetDO do1,1;"))[1] == 10


def test_the_way_along_an_arc_counts_for_its_corner() -> None:
    # A quarter circle of 100 mm radius is 157.08 mm long, its chord 141.42: half of it lets z80 go to 78.54 mm.
    through = f"[[{100 * np.cos(pi / 4):.9f},{100 * np.sin(pi / 4):.9f},500],[0,0,1,0],[0,0,0,0],{N}]"
    body = line(100, 0, "fine") + f"MoveC {through},{at(0, 100, 500)},v100,z80,tool0;" + line(-900, 100, "fine")
    assert corners(body)[1] == pytest.approx(25 * pi, abs=1e-6)


def test_another_tool_has_another_way() -> None:
    data = f"PERS tooldata t:=[TRUE,[[0,0,100],[1,0,0,0]],{LOAD}];\n"
    body = line(0, 0, "fine") + line(0, 60, "z80", "t") + line(0, 400, "fine", "t")
    # The tip of t begins 100 mm below tool0 (which points down): 100 and 60 mm away.
    (_, corner, _) = effective_radii(run_main(body, data))
    assert corner == pytest.approx(np.hypot(0.1, 0.06) / 2)


# ---------------------------------------------------------------------------------------------------------- settings


def test_settings_are_as_the_manual_says() -> None:
    body = (
        "AccSet 60,40\\FinePointRamp:=50; SingArea\\LockAxis4; PathAccLim TRUE\\AccMax:=4,TRUE\\DecelMax:=3;"
        "WorldAccLim\\On:=2; VelSet 50,400; ConfJ\\Off; PathResol 50; ActUnit STN1; CirPathMode\\ObjectFrame;"
        f"MoveJ {at(1, 2, 3)},v1000,fine,tool0;"
    )
    program = run_main(body)
    (move,) = moves(program)
    now = move.settings
    assert (now.acceleration, now.ramp, now.singularity) == (0.6, 0.4, Singularity.LOCK_AXIS_4)
    assert (now.path_acceleration, now.path_deceleration, now.world_acceleration) == (4, 3, 2)
    assert (now.override, now.v_max, now.conf_j, now.conf_l) == (0.5, 0.4, False, True)
    assert move.speed.v_tcp == pytest.approx(0.4)
    assert move.speed.v_ori == pytest.approx(radians(250))
    assert now.circle is CirPathMode.OBJECT_FRAME
    assert {name.lower() for name in program.ignored} == {"pathresol", "actunit"}


@pytest.mark.parametrize(
    ("body", "places"),
    [
        ("AccSet 50,50\\FinePointRamp:=50;\nAccSet 60,60 \\FinePointRamp:=20;", [4]),  # once
        ("AccSet 50,50;\nFOR i FROM 1 TO 3 DO AccSet 100,100,\\FinePointRamp:=i; ENDFOR", [5]),
        ("AccSet 50,50\\FinePointRamp:=100;", []),
        ("AccSet 50,50;", []),
    ],
)
def test_what_a_ramp_to_stop_points_does_not_do_is_told_once_by_its_line(body: str, places: list[int]) -> None:
    told = [one for one in run_main(body).warnings if one.kind is WarningKind.NO_EFFECT]
    assert [one.place.line for one in told if isinstance(one.place, Source)] == places


def test_a_speed_that_was_used_before_obeys_the_next_override() -> None:
    go = f"MoveL {at(1, 2, 3)},v1000,fine,tool0; "
    program = run_main(go + "VelSet 50,5000; " + go + "VelSet 100,300; " + go)
    assert [move.speed.v_tcp for move in moves(program)] == [1.0, 0.5, 0.3]


def test_speed_refresh_is_a_share_of_what_velset_leaves() -> None:
    go = f"MoveL {at(1, 2, 3)},v1000,fine,tool0; "
    program = run_main(f"SpeedRefresh 50; {go} VelSet 50,300; {go} SpeedRefresh 100; {go} VelSet 100,5000; {go}")
    assert [move.speed.v_tcp for move in moves(program)] == pytest.approx([0.5, 0.15, 0.3, 1.0])
    assert moves(program)[1].speed.v_ori == pytest.approx(radians(125))
    timed = go.replace("v1000", "v1000\\T:=2")
    assert [move.duration for move in moves(run_main(f"{timed} SpeedRefresh Override:=25; {timed}"))] == [2, 8]
    assert program.warnings == ()
    beside = go.replace("MoveL", "MoveL\\Conc,") + "WaitTime 1;"
    for first in (go.replace("fine", "z10"), beside, f"{go.replace('fine', 'z10')} SetDO d,1;"):
        flying = run_main(f"{first}\nSpeedRefresh 50;\n{go}").warnings
        assert [str(warning.place) for warning in flying] == ["m.mod:5:1"]  # the move that runs is slowed somewhere
    assert run_main(f"{beside} WaitRob\\InPos;\nSpeedRefresh 50;\n{go}").warnings == ()


@pytest.mark.parametrize("percent", ["-1", "101", "0"])
def test_a_refresh_that_no_controller_takes(percent: str) -> None:
    assert error_main(f"SpeedRefresh {percent};").startswith("m.mod:4:14: ")
    handled = (
        run_main(f"SpeedRefresh {percent or 1};" + "ERROR (ERR_SPEED_REFRESH_LIM) TRYNEXT;") if percent != "0" else None
    )
    assert handled is None or handled.motions == ()


# -------------------------------------------------------------------------------------------------------- system data


def target(x: float, y: float, z: float, eax: float) -> str:
    return f"[[{x},{y},{z}],[0,0,1,0],[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]]"


def placed(body: str, data: str = "", rest: str = "") -> list[tuple[float, ...]]:
    """Where moves end: x, y, z [mm] and eax_a."""
    found = moves(run_main(body, data, rest))
    return [tuple((*np.round(move.X_WT[:3, 3] * 1e3, 3).tolist(), move.extax[0])) for move in found]


@pytest.mark.parametrize(
    ("set_", "moved"),
    [
        ("PDispSet [[0,0,60],[1,0,0,0]];", (500, 0, 460, 0)),
        (f"PDispOn\\ExeP:={target(510, 20, 400, 0)},{target(500, 0, 400, 0)},tool0;", (510, 20, 400, 0)),
        ("EOffsSet [200,0,0,0,0,0];", (500, 0, 400, 200)),
        (f"EOffsOn\\ExeP:={target(1, 1, 1, 350)},{target(2, 2, 2, 50)};", (500, 0, 400, 300)),
        ("PDispSet [[0,0,60],[1,0,0,0]]; EOffsSet [7,0,0,0,0,0]; PDispOff;", (500, 0, 400, 7)),
        ("PDispSet [[0,0,60],[0,0,0,1]]; PDispAdd [[10,0,0],[1,0,0,0]];", (-510, 0, 460, 0)),
    ],
)
def test_the_displacements_in_force_can_be_kept_and_set_again(set_: str, moved: tuple[float, ...]) -> None:
    """RAPID overview, system data: C_PROGDISP. Kept by a routine, by a function, and as parts."""
    p = target(500, 0, 400, 0)
    go = f"MoveL {p},v100,fine,tool0; "
    rest = (
        f"PROC clean()\nVAR progdisp kept;\nkept:=C_PROGDISP;\nPDispOff; EOffsOff;\n{go}\n"
        "PDispSet kept.pdisp;\nEOffsSet kept.eoffs;\nENDPROC\n"
        "FUNC pose now()\nRETURN C_ProgDisp.pdisp;\nENDFUNC\n"
        f"PROC again()\nVAR pose d;\nVAR num e;\nd:=now();\ne:=C_PROGDISP.eoffs.eax_a;\nPDispOff; EOffsOff;\n"
        f"PDispSet d;\nEOffsSet [e,0,0,0,0,0];\n{go}\nENDPROC"
    )
    plain = (500, 0, 400, 0)
    assert placed(f"clean; {set_} {go} clean; {go} again;", rest=rest) == [plain, moved, plain, moved, moved]


def test_motion_settings_in_force_can_be_read_and_set_again() -> None:
    """RAPID reference manual, motsetdata: C_MOTSET."""
    set_ = (
        "VelSet 40,700; AccSet 60,50; ConfJ\\Off; SingArea\\Wrist; PathAccLim TRUE\\AccMax:=4,FALSE; SpeedRefresh 50;"
    )
    again = (
        "VelSet kept.vel.oride,kept.vel.max; AccSet kept.acc.acc,kept.acc.ramp; IF kept.conf.jsup THEN ConfJ\\On; ELSE "
        "ConfJ\\Off; ENDIF IF kept.sing.wrist SingArea\\Wrist; IF kept.sing.base SingArea\\Off; "
        "IF kept.acclim PathAccLim TRUE\\AccMax:=kept.accmax,kept.decellim; IF NOT kept.acclim PathAccLim FALSE,FALSE; "
    )
    other = "VelSet 100,5000; AccSet 100,100; ConfJ\\On; SingArea\\Off; PathAccLim FALSE,FALSE; "
    go = f"MoveL {at(1, 2, 3)},v1000,fine,tool0; "
    data = "VAR motsetdata kept;"
    first, second = moves(run_main(f"{set_} {go} kept:=C_MOTSET; {other} {again} {go}", data))
    assert first.settings == second.settings
    assert first.settings.override == pytest.approx(0.2)
    (default,) = moves(run_main(f"kept:=C_MOTSET; {set_} SpeedRefresh 100; {again} {go}", data))
    now = default.settings
    assert (now.override, now.acceleration, now.ramp, now.conf_j, now.singularity) == (1, 1, 1, True, Singularity.OFF)
    assert now.path_acceleration is None


def test_orientations_off_unit_are_told_up_to_a_point() -> None:
    body = "".join(f"MoveL {at(i, 0, 500, f'[0,0.71,0.70{i + 10},0]')},v100,fine,tool0;\n" for i in range(30))
    program = run_main(body)
    assert len(program.warnings) == 21
    assert (
        tuple(map(str, program.warnings))[-1]
        == "more than 20 orientations are not unit quaternions; the others are normalised without a message"
    )


# ------------------------------------------------------------------------------------------------- events and others


def test_trigger_arrays_and_equipment() -> None:
    data = "VAR triggdata t{2};\nVAR triggdata s;\nVAR triggdata r;\n"
    body = (
        "TriggIO t{1},10\\DOp:=do1,1; TriggIO t{2},5\\DOp:=do1,0;"
        "TriggSpeed s,0,0.02,ao1,0.5; TriggRampAO r,15\\Start,0.1,ao2,7,30;"
        f"TriggL {at(1, 2, 3)},v100,t\\T2:=s\\T3:=r,fine,tool0;"
    )
    (move,) = moves(run_main(body, data))
    told = [(e.kind, e.name, e.value, e.distance, e.time, e.from_start) for e in move.events]
    assert told == [
        (Happens.SIGNAL, "do1", 1.0, 0.01, 0.0, False),
        (Happens.SIGNAL, "do1", 0.0, 0.005, 0.0, False),
        (Happens.SIGNAL, "ao1", None, 0.0, 0.02, False),
        (Happens.SIGNAL, "ao2", 7.0, 0.015, 0.1, True),
    ]


def test_weld_speed_that_nobody_tells_is_said() -> None:
    body = f"ArcL {at(1, 2, 3)},v100,seam1,weld1,fine,tool0;"
    program = run_main(body)
    (move,) = moves(program)
    assert move.speed.v_tcp == 0.1
    assert [(str(w.place), w.kind) for w in program.warnings] == [("m.mod:4:1", WarningKind.ASSUMED)]
    record = "RECORD welddata\nnum sched;\nnum weld_speed;\nENDRECORD\nPERS welddata weld1:=[3,12.5];\n"
    (move,) = moves(run_main(body, record))
    assert move.speed.v_tcp == pytest.approx(0.0125)


CAP = 'PERS capdata c:=["start",FALSE,FALSE,0,[0,0,{},{},15,0],[0,0],[0,0,0,0,0,0],[0,0,0],[0,0,0,0,0,0]];\n'
WELD = "PERS welddata w:=[8,8,[5,0,22,120,0,0,0,0,0],[0,0,0,0,0,0,0,0,0]];\nPERS welddata old{2}:=[[1,20],[2,30]];\n"
BLANK = "VAR welddata new{2}; VAR capdata none;\n"


@pytest.mark.parametrize(
    ("call", "speeds"),
    [
        ("CapL {p},v200,c,weave,fine,tool0;", [15]),
        ("CapL ToPoint:={p},v200,Cdata:=c,Weavestart:=start,Weave:=weave,Zone:=fine,tool0;", [15]),
        ("CapC {q},{p},v200,c,weave,fine,tool0;", [15]),
        ("c.speed_data.main:=25; CapL {p},v200,c,weave,fine,tool0;", [25]),
        ("w.weld_speed:=12; ArcL {p},v200,s,w,fine,tool0; ArcLStart {p},v200,s,w,fine,tool0;", [12, 200]),
        ("ArcL {p},v200,s,old{{2}},fine,tool0; old{{2}}.weld_speed:=5; ArcL {p},v200,s,old{{2}},fine,tool0;", [30, 5]),
        ("new{{2}}.weld_speed:=7; ArcL {p},v200,s,new{{2}},fine,tool0;", [7]),
        ("none.speed_data.main:=9; CapL {p},v200,none,weave,fine,tool0;", [9]),
        ("w:=old{{1}}; ArcC {q},{p},v200,s,w,fine,tool0;", [20]),
        ("DispL {p},v200,b,fine,tool0; PaintL {p},v300,fine,tool0; SpotL {p},v400,g,s,tool0;", [200, 300, 400]),
    ],
)
def test_the_process_data_says_the_speed_of_the_process(call: str, speeds: list[float]) -> None:
    """As the data stands when the move is made; capspeeddata: fly_start, start, startspeed_time, ..., main, fly_end."""
    body = f"MoveL {at(0, 0, 500)},v100,fine,tool0; " + call.format(p=at(100, 0, 500), q=at(50, 50, 500))
    _, *found = moves(run_main(body, WELD + BLANK + CAP.format(0, 0)))
    assert [move.speed.v_tcp * 1e3 for move in found] == pytest.approx(speeds)


def test_process_speeds_that_are_not_known_are_told_by_line() -> None:
    body = f"CapL {at(1, 2, 3)},v100,{{}},weave,fine,tool0;"
    for name, data in (("nowhere", ""), ("c", "PERS capdata c:=[1,2,3];"), ("w", "VAR capdata w;")):
        program = run_main(body.format(name), data)
        assert moves(program)[0].speed.v_tcp == 0.1
        assert [str(warning.place) for warning in program.warnings] == ["m.mod:4:1"]
    (warning,) = run_main(body.format("c"), CAP.format(2, 0)).warnings  # two seconds at another speed
    assert str(warning.place) == "m.mod:5:1"
    for setting in ("VelSet 50,5000;", "SpeedRefresh 50;"):
        program = run_main(f"{setting}\n{body.format('c')}", CAP.format(0, 0))
        assert moves(program)[0].speed.v_tcp == pytest.approx(0.015)
        assert [str(warning.place) for warning in program.warnings] == ["m.mod:6:1"]


def test_a_search_stops_within_its_arc_and_faults_only_at_its_end() -> None:
    data = "VAR robtarget r;\n"
    start = f"MoveL {at(100, 0, 500)},v100,fine,tool0; "
    search = f"SearchC\\Stop,di1,r,{at(0, 100, 500)},{at(-100, 0, 500)},v50,tool0;"
    scenario = Scenario(searches={"di1": 1 / 3})
    _, move = moves(run_main(start + search, data, scenario=scenario))
    assert isinstance(move, MoveC)
    # 60 of 180 degrees; the via point at 30, so that the arc ends where it was found.
    np.testing.assert_allclose(move.X_WT[:2, 3], [0.05, 0.1 * np.sin(pi / 3)], atol=1e-12)
    np.testing.assert_allclose(move.X_WV[:2, 3], [0.1 * np.cos(pi / 6), 0.05], atol=1e-12)
    assert move.zone.stop


@pytest.mark.parametrize(("mode", "turned"), [("\\PathFrame", 60.0), ("\\ObjectFrame", -60.0)])
def test_a_search_on_an_arc_is_turned_there_as_its_mode_says(mode: str, turned: float) -> None:
    """By 180 deg with the path, or in the object frame by -180 deg and a bit the other way."""

    def facing(x: float, y: float, degrees: float) -> str:
        half = radians(degrees) / 2
        return at(x, y, 500, f"[{np.cos(half):.12f},0,0,{np.sin(half):.12f}]")

    end = 180.0 if turned > 0 else -179.0
    search = f"SearchC\\Stop,di1,r,{facing(0, 100, end / 2)},{facing(-100, 0, end)},v50,tool0;"
    body = f"CirPathMode{mode}; MoveL {facing(100, 0, 0)},v100,fine,tool0; {search}"
    _, move = moves(run_main(body, "VAR robtarget r;\n", scenario=Scenario(searches={"di1": 1 / 3})))
    assert isinstance(move, MoveC)
    wanted = rotation_about([0, 0, 1], radians(end) / 3)
    np.testing.assert_allclose(move.X_WT[:3, :3], wanted, atol=1e-6)
    np.testing.assert_allclose(move.X_WV[:3, :3], rotation_about([0, 0, 1], radians(end) / 6), atol=1e-6)


def test_each_undeclared_name_is_told_once_and_stands_in_for_the_rest() -> None:
    body = f"MoveL {at(1, 2, 3)},v100,fine,tGrip\\WObj:=wA; MoveL {at(1, 2, 3)},v100,fine,TGRIP; GripLoad lPart;"
    lines = error_main(body).splitlines()
    names = [line.split("'")[1] for line in lines if "is not declared" in line]
    assert names == ["tGrip", "wA", "lPart"]
    scenario = Scenario(assume_identity=frozenset({"tgrip", "WA", "lpart"}))
    program = run_main(body, scenario=scenario)
    assert len(program.motions) == 2
    assert len([w for w in tuple(map(str, program.warnings)) if "taken as the identity" in w]) == 4  # once per spelling


def test_joint_moves_with_a_stationary_tool_keep_it() -> None:
    data = (
        f'PERS wobjdata w:=[TRUE,TRUE,"",[[0,0,7],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n'
        f"PERS tooldata t:=[FALSE,[[800,0,500],[1,0,0,0]],{LOAD}];\n"
    )
    (move,) = moves(run_main(f"MoveAbsJ [[0,0,0,0,0,0],{N}],v100,fine,t\\WObj:=w;", data))
    assert isinstance(move, MoveAbsJ)
    assert move.tool.stationary


def test_what_no_plan_looks_at_is_told_once() -> None:
    body = r"MoveL p,v100,fine,tool0\Corr; MoveL p,v100,fine,tool0\Corr\TLoad:=load0;"
    text = (
        "MODULE m\nCONST robtarget p:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        f"PROC main()\n{body}\nENDPROC\nENDMODULE\n"
    )
    assert tuple(map(str, run_program([TextFile("m.mod", text, "utf-8")]).warnings)) == (
        r"m.mod:4:9: \Corr adds what a sensor finds to the path, which is not known here: the path stays as written",
        r"m.mod:4:67: \TLoad changes nothing here; the cell's limits hold for any load",
    )
