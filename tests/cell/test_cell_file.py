"""Cell files: what a good one means, and where a bad one is wrong."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.cell.model import minimal_cell
from trajopt_cli.errors import InputError
from trajopt_cli.limits import JointLimits
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.scenario import ESTIMATED_SETTLING, Scenario, Settling

REPOSITORY = Path(__file__).parents[2]
HOME = math.radians(30.0)
ARM = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\n"
RAIL = "robot: irb140_rail\nstart: {joints: [0, 0, 0, 0, 0.5, 0], rail: 0}\nrail: {eax: a, stroke: [-0.2, 2.2]}\n"


def message(text: str, plant: bool = False) -> str:
    read = (lambda: build_plant(parse_cell(text, "cell.yaml"))) if plant else (lambda: parse_cell(text, "cell.yaml"))
    with pytest.raises(InputError) as caught:
        read()
    return str(caught.value)


def test_hinge_cell_is_the_case() -> None:
    case_file = REPOSITORY / "tests" / "data" / "cases" / "hinge_cell.json"
    case = json.loads(case_file.read_text())
    plant = build_plant(load_cell(REPOSITORY / "programs" / "hinge_cell.yaml"))
    assert list(plant.limits.names) == case["limits"]["order"]
    # The case rounds the data sheet's deg/s in the fourth decimal.
    np.testing.assert_allclose(plant.limits.velocity, case["limits"]["v"], atol=5.1e-5, rtol=0)
    np.testing.assert_array_equal(plant.limits.acceleration, case["limits"]["a"])
    assert (plant.tcp.speed, plant.tcp.acceleration) == (case["limits"]["tcp_v"], case["limits"]["tcp_a"])
    np.testing.assert_array_equal(plant.start, case["home_q"])
    assert (plant.limits.lower[0], plant.limits.upper[0]) == (-0.2, 2.2)


def test_hinge_cell_stands_with_its_base_on_the_rail_and_x_forward() -> None:
    robot = build_plant(load_cell(REPOSITORY / "programs" / "hinge_cell.yaml")).robot
    expected = np.eye(4)
    expected[1, 3] = 1.35
    np.testing.assert_array_equal(robot.base(1.35), expected)


def test_bench_cell_loads() -> None:
    cell = load_cell(REPOSITORY / "programs" / "bench_irb140.yaml")
    plant = build_plant(cell)
    assert plant.rail_eaxes == ()
    assert cell.scenario.signals == {"di_part_ready": 1.0}
    assert cell.scenario.waits == {"di_part_ready": pytest.approx(0.2)}


def test_minimal_cell_is_about_five_lines_and_valid() -> None:
    text = minimal_cell("weld.mod")
    assert len(text.splitlines()) <= 6
    plant = build_plant(parse_cell(text, "weld.yaml"))
    assert plant.start[5] == HOME


@pytest.mark.parametrize(
    ("written", "metres"),
    [("[-0.2, 2.2]", (-0.2, 2.2)), ('"[-200, 2200] mm"', (-0.2, 2.2)), ("[-20 cm, 2.2]", (-0.2, 2.2))],
)
def test_lengths_with_and_without_unit(written: str, metres: tuple[float, float]) -> None:
    cell = parse_cell(RAIL.replace("[-0.2, 2.2]", written), "cell.yaml")
    assert cell.rail is not None
    assert cell.rail.stroke == pytest.approx(metres, abs=1e-15)


def test_units_of_limits_and_times() -> None:
    text = (
        RAIL + "limits:\n"
        "  rail: {velocity: 1500 mm/s, acceleration: 2 m/s², source: s}\n"
        "  joint_1: {lower: -90 deg, upper: 90 °, velocity: 180 deg/s, acceleration: 720 deg/s^2, source: s}\n"
        "waits: {di_ready: 250 ms}\n"
    )
    plant = build_plant(parse_cell(text, "cell.yaml"))
    limits = plant.limits
    assert (limits.velocity[0], limits.acceleration[0]) == (1.5, 2.0)
    assert (limits.lower[1], limits.upper[1]) == (-math.pi / 2, math.pi / 2)
    assert (limits.velocity[1], limits.acceleration[1]) == (pytest.approx(math.pi), pytest.approx(4 * math.pi))
    assert limits.sources["joint_1.position"] == limits.sources["joint_1.velocity"] == "s"
    assert limits.sources["rail.position"] == "rail.stroke of cell.yaml"
    assert parse_cell(text, "cell.yaml").scenario.waits == {"di_ready": 0.25}


def test_frames_follow_urdf_rpy_and_wxyz() -> None:
    turned = "base: {position: [1, 2, 3], rpy: [90 deg, 0, 90 deg]}\n"
    # Rz(90) Rx(90): x to y, y to z, z to x.
    expected = np.array([[0, 0, 1, 1], [1, 0, 0, 2], [0, 1, 0, 3], [0, 0, 0, 1]])
    np.testing.assert_allclose(parse_cell(ARM + turned, "c").X_WB, expected, atol=1e-15)
    same = "base: {position: [1, 2, 3], wxyz: [0.5, 0.5, 0.5, 0.5]}\n"
    np.testing.assert_allclose(parse_cell(ARM + same, "c").X_WB, expected, atol=1e-15)


def test_names_of_signals_and_dropped_targets_ignore_case() -> None:
    cell = parse_cell(ARM + "signals: {DI_Ready: true, di2: 3}\noptional: [p_Home2]\nfree_speed: true\n", "c")
    assert cell.scenario.signals == {"di_ready": 1.0, "di2": 3.0}
    assert cell.droppable == {"p_home2"}
    assert cell.free_speed


def test_the_robots_documented_caps_hold_where_the_cell_gives_none() -> None:
    plant = build_plant(parse_cell(ARM, "cell.yaml"))
    assert plant.tcp == plant.robot.tcp
    assert plant.notes[-1].startswith("TCP caps 2.5 m/s and 20 m/s²: ABB's data sheet")
    assert plant.notes[-1].endswith("as the robot's file has it")


def test_estimated_accelerations_are_said_and_measured_ones_are_not() -> None:
    measured = "limits: {joint_1: {acceleration: 14, source: measured}}\n"
    note = build_plant(parse_cell(ARM + measured, "cell.yaml")).notes[0]
    assert note == (
        "accelerations of joint_2, joint_3, joint_4, joint_5, joint_6 are estimates of grade D (profile default: "
        "conservative; full speed in about 0.2 s); a measured value belongs in cell.yaml"
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (ARM + "robt: x\n", "cell.yaml:3: robt:"),
        (RAIL.replace("eax: a", "eax: a, fixt: true"), "cell.yaml:3: rail.fixt:"),
        (RAIL.replace("stroke: [-0.2, 2.2]", "fixed: true"), "cell.yaml:3: rail.stroke:"),
        (RAIL.replace("stroke: [-0.2, 2.2]", "stroke: [2.2, -0.2]"), "cell.yaml:3: rail.stroke:"),
        (RAIL.replace("stroke: [-0.2, 2.2]", "stroke: [-200, 2200]"), "cell.yaml:3: rail.stroke:"),
        (RAIL.replace("stroke: [-0.2, 2.2]", "stroke: [0, 2 deg]"), "cell.yaml:3: rail.stroke:"),
        (RAIL.replace("stroke: [-0.2, 2.2]", "stroke: [0]"), "cell.yaml:3:"),
        (RAIL.replace("eax: a", "eax: g"), "cell.yaml:3: rail.eax:"),
        (RAIL.replace(", rail: 0", ""), "cell.yaml:2: start.rail:"),
        (RAIL + "base: {position: [0, 0, 0]}\n", "cell.yaml:4: base:"),
        (ARM + "limits:\n  joint_1: {acceleration: 12.5}\n", "cell.yaml:4: limits.joint_1.source:"),
        (ARM + "limits:\n  joint_1: {acceleration: 12.5, source: ''}\n", "cell.yaml:4: limits.joint_1.source:"),
        (ARM + "limits:\n  joint_1: {acceleration: .nan, source: s}\n", "cell.yaml:4: limits.joint_1.acceleration:"),
        (ARM + "limits:\n  joint_1: {velocity: -1, source: s}\n", "cell.yaml:4: limits.joint_1.velocity:"),
        (ARM + "limits:\n  joint_1: {velocity: 3 m/s, source: s}\n", "cell.yaml:4: limits.joint_1.velocity:"),
        (ARM + "limits:\n  joint_1: {velocity: fast, source: s}\n", "cell.yaml:4: limits.joint_1.velocity:"),
        (ARM + 'limits:\n  joint_1: {velocity: "3", source: s}\n', "cell.yaml:4: limits.joint_1.velocity:"),
        (ARM + "limits:\n  joint_1: {velocity: true, source: s}\n", "cell.yaml:4:"),
        (ARM + "limits:\n  joint_1: {lower: 1, upper: -1, source: s}\n", "cell.yaml:4: limits.joint_1:"),
        (ARM + "limits:\n  joint_1: {source: s}\n", "cell.yaml:4: limits.joint_1:"),
        (RAIL + "limits:\n  rail: {lower: 0, source: s}\n", "cell.yaml:5: limits.rail.lower:"),
        (ARM + "free_speed: 1\n", "cell.yaml:3: free_speed:"),
        (ARM + "optional: p_a\n", "cell.yaml:3:"),
        (ARM + "pass_limit: 0\n", "cell.yaml:3: pass_limit:"),
        (ARM + "tcp: 2.5\n", "cell.yaml:3: tcp:"),
        (ARM + "waits: {di1: -1}\n", "cell.yaml:3:"),
        (ARM + "base: {wxyz: [1, 1, 0, 0]}\n", "cell.yaml:3: base:"),
        (ARM + "base: {wxyz: [1, 0, 0, 0], rpy: [0, 0, 0]}\n", "cell.yaml:3: base:"),
        (ARM.replace("[0, 0, 0, 0, 0.5, 0]", '"[0, x] deg"'), "cell.yaml:2: start.joints:"),
        ("robot: a\nrobot: b\n", "cell.yaml:2:"),
        ("start: [0, 30] deg\n", "cell.yaml:1:"),
        ("", "cell.yaml:1:"),
        ("1: 2\n", "cell.yaml:1:"),
        ("robot: 2020-01-02\n", "cell.yaml:1: robot:"),
        ("start: {joints: [0]}\n", "cell.yaml:1: robot:"),
    ],
)
def test_messages_of_the_file(text: str, expected: str) -> None:
    assert message(text).startswith(expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (ARM.replace("irb140", "irb14"), "cell.yaml:1: robot:"),
        (ARM + "profile: optimistc\n", "cell.yaml:3: profile:"),
        (ARM + "limits: {joint_7: {velocity: 3, source: s}}\n", "cell.yaml:3: limits.joint_7:"),
        (ARM + "limits: {rail: {velocity: 3, source: s}}\n", "cell.yaml:3: limits.rail:"),
        (ARM + "limits: {joint_5: {lower: 3, source: s}}\n", "cell.yaml:3: limits.joint_5:"),
        ("robot: irb140_rail\nstart: {joints: [0, 0, 0, 0, 0, 0]}\n", "cell.yaml:1: rail:"),
        (RAIL.replace("irb140_rail", "irb140"), "cell.yaml:3: rail:"),
        (ARM.replace("[0, 0, 0, 0, 0.5, 0]", "[0]"), "cell.yaml:2: start.joints:"),
        (ARM.replace("0.5", "120 deg"), "cell.yaml:2: start.joints:"),
        (RAIL.replace("rail: 0", "rail: 3000"), "cell.yaml:2: start.rail:"),
        (RAIL.replace("rail: 0", "rail: 1500"), "cell.yaml:2: start.rail:"),
    ],
)
def test_messages_of_the_plant(text: str, expected: str) -> None:
    assert message(text, plant=True).startswith(expected)


def test_a_limit_nobody_gave_is_named() -> None:
    cell = parse_cell(RAIL, "cell.yaml")
    bare = JointLimits(("rail", "joint_1"), *(np.array(v) for v in ([0, 0], [1, 1], [np.inf, 1], [1, 1])))
    with pytest.raises(InputError) as caught:
        cell.apply_limits(bare, bare.names)
    assert str(caught.value) == (
        "cell.yaml:1: limits.rail: robot irb140_rail gives no velocity; add it with its source"
    )


def test_every_mistake_is_said_in_file_order() -> None:
    lines = message("robt: a\n" + RAIL + "free_speed: 2\n").splitlines()
    assert lines == [
        "cell.yaml:1: robt: unknown key; did you mean 'robot'?",
        "cell.yaml:5: free_speed: needs true or false, not 2",
    ]


def test_a_key_that_a_small_section_does_not_have_names_all_it_has() -> None:
    told = message(RAIL + "obstacles:\n  post: {box: {size: [1, 1, 1], xyz: [2, 0, 0]}}\n")
    assert told.startswith("cell.yaml:5: obstacles.post.box.xyz:")
    assert "position" in told
    assert "size" in told


def test_unreadable_files(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none\.yaml: cannot read the cell file: No such file or directory"):
        load_cell(tmp_path / "none.yaml")
    latin = tmp_path / "latin.yaml"
    latin.write_bytes(b"robot: \xe9\n")
    with pytest.raises(InputError, match=r"latin\.yaml: byte 7 is not UTF-8; save the cell file as UTF-8"):
        load_cell(latin)


def test_a_jerk_may_be_given_and_has_a_unit() -> None:
    cell = parse_cell(RAIL + "limits:\n  joint_1: {jerk: 9000 deg/s3, source: measured}\n", "cell.yaml")
    limits = build_plant(cell).limits
    assert limits.jerk is not None
    assert limits.jerk[1] == pytest.approx(9000 * np.pi / 180, rel=1e-15)
    assert limits.jerk[0] == 20.0  # the robot's own
    assert limits.sources["joint_1.jerk"] == "measured"


def test_a_robot_without_jerks_needs_all_of_them_or_none() -> None:
    bare = JointLimits(("rail", "joint_1"), *(np.array(v) for v in ([0, 0], [1, 1], [1, 1], [1, 1])))
    assert parse_cell(RAIL, "cell.yaml").apply_limits(bare, bare.names).jerk is None
    cell = parse_cell(RAIL + "limits:\n  joint_1: {jerk: 9000 deg/s3, source: measured}\n", "cell.yaml")
    with pytest.raises(InputError, match="robot irb140_rail gives no jerk"):
        cell.apply_limits(bare, bare.names)


# --------------------------------------------------------------------------------------------------------- scenario


def test_the_scenario_has_values_sequences_answers_waits_searches_and_limits() -> None:
    text = (
        "signals: {DI1: [0, true, 2], gi_1: 5}\n"
        "answers: {nPart: [1, 2.5], Name: 'box', code: \"12\", bOk: true, UINumEntry: 3}\n"
        "waits: {'DI1 = 1': Timeout, di2: 200 ms}\n"
        "searches: {pFound: 0.4, pLost: never}\n"
        "endless_passes: 2\npass_limit: 7\nstatement_limit: 900\nassume_identity: [tGrip, wTable]\n"
    )
    assert parse_cell(ARM + text, "c").scenario == Scenario(
        signals={"di1": (0.0, 1.0, 2.0), "gi_1": 5.0},
        answers={"npart": (1.0, 2.5), "name": "box", "code": "12", "bok": True, "uinumentry": 3.0},
        waits={"di1=1": None, "di2": pytest.approx(0.2)},  # type: ignore[dict-item]
        searches={"pfound": 0.4, "plost": None},
        endless_passes=2,
        pass_limit=7,
        statement_limit=900,
        assume_identity=frozenset({"tgrip", "wtable"}),
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("signals:\n  a: 1\n  A: 2\n", "5: signals.A: is the same to RAPID as signals.a; keep one"),
        ("answers:\n  n: 1\n  N: 2\n", "5: answers.N: is the same to RAPID as answers.n; keep one"),
        ("waits:\n  di1=1: 1\n  DI1 = 1: 2\n", "5: waits.DI1 = 1: is the same to RAPID as waits.di1=1; keep one"),
        ("searches: {p: 1, P: 1}\n", "3: searches.P: is the same to RAPID as searches.p; keep one"),
        ("assume_identity: [t, T]\n", "3: assume_identity.T: is the same to RAPID as assume_identity.t; keep one"),
        ("signals: {a: []}\n", "3: signals.a: needs 1 to 10000 values in its list, not 0"),
        (f"signals: {{a: {[1] * 10001}}}\n", "3: signals.a: needs 1 to 10000 values in its list, not 10001"),
        ("signals: {a: [1, x]}\n", '3: signals.a: needs a number, not "x"'),
        ("signals: {a: {b: 1}}\n", "3: signals.a: needs a number, not a section"),
        ("answers: {a: }\n", "3: answers.a: needs a number, true or false, or a text, not nothing"),
        ("answers: {a: [1, [2]]}\n", "3: answers.a: needs a number, true or false, or a text, not a list"),
        ("answers: {a: .inf}\n", "3: answers.a: needs a finite number, not inf"),
        (
            "obstacles: {a: {fence: {points: [[0, 0], [-7e307, 2]], height: 1}}}\n",
            "3: obstacles.a.fence.points.1: needs a length within 1e+12 m, not -7e+307 m; check its digits and unit",
        ),
        ("waits: {a: later}\n", '3: waits.a: needs seconds, timeout or, of the rail, free, not "later"'),
        ("searches: {a: 1.5}\n", "3: searches.a: needs a share of the way from 0 to 1, or never, not 1.5"),
        ("searches: {a: no}\n", '3: searches.a: needs a share of the way from 0 to 1, or never, not "no"'),
        ("endless_passes: 0\n", "3: endless_passes: needs a whole number above zero, not 0"),
        (
            "limits: {joint_1: {acceleration_factor: 0, source: log}}\n",
            "3: limits.joint_1.acceleration_factor: needs a number above zero, not 0",
        ),
        ("endless_passes: 10001\n", "3: endless_passes: needs a whole number, 10000 or less, not 10001"),
        ("statement_limit: 1.5\n", "3: statement_limit: needs a whole number, not 1.5"),
        ("assume_identity: tGrip\n", "3: assume_identity: needs a list, not tGrip"),
    ],
)
def test_messages_of_the_scenario(text: str, expected: str) -> None:
    assert message(ARM + text) == f"cell.yaml:{expected}"


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("", (0.2, 0.3)),
        ("settle: 50 ms\n", (0.05, 0.05)),
        ("settle: 0\n", (0.0, 0.0)),
        ("settle: {fine: 0.05}\n", (0.05, 0.05)),  # inpos is as fine, unless somebody says more
        ("settle: {inpos: 0.05}\n", (0.2, 0.05)),
        ("settle: {fine: 0, inpos: 0.05}\n", (0.0, 0.05)),
    ],
)
def test_settling_is_the_cells_else_the_robots_else_an_estimate(said: str, expected: tuple[float, float]) -> None:
    cell = parse_cell(f"robot: irb140\nstart: {{joints: [0, 0, 0, 0, 0, 0]}}\n{said}", "cell.yaml")
    assert cell.settling(Settling(0.2, 0.3, "measured"))[:2] == expected
    nobody = cell.settling(None)
    if said and "{inpos" not in said:
        assert nobody[2:] == ("settle of cell.yaml", (1.0, 1.0))
    else:  # how long fine takes is as unsure as it was
        assert nobody.source.endswith(ESTIMATED_SETTLING.source)
        assert nobody.spread == ESTIMATED_SETTLING.spread


@pytest.mark.parametrize("value", ["-1 ms", "100", "", "{fine: 6}", "{stop: 0.1}", "[0.1]", "true"])
def test_a_settling_that_is_none_is_placed_at_its_line(value: str) -> None:
    with pytest.raises(InputError) as refused:
        parse_cell(f"robot: irb140\nstart: {{joints: [0, 0, 0, 0, 0, 0]}}\nsettle: {value}\n", "cell.yaml")
    assert (refused.value.file, refused.value.line) == ("cell.yaml", 3)
