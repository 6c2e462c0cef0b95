"""The robot behind a program against independent truth: poses, all solutions, confdata with its turns."""

from __future__ import annotations

import json
from math import radians
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.geometry import Array, pose, rotation_from_wxyz
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import NO_EXTERNAL_AXES, ConfData, ExternalAxes
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.problem.programmed import PlantKinematics

TRUTH = Path(__file__).parents[1] / "data" / "truth"
BENCH = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"
RAIL = """robot: irb140_rail
rail: {eax: b, stroke: [-0.2, 2.2], frame: {position: [0.1, 0.2, 0.3], rpy: "[0, 0, 90] deg"}}
limits: {rail: {acceleration: 1, source: "a test"}}
start: {joints: "[10, 0, 0, 0, 30, 0] deg", rail: 0.5}
"""


def robot(text: str = BENCH) -> PlantKinematics:
    return PlantKinematics(build_plant(parse_cell(text, "cell.yaml")))


def on_rail(value: float | None) -> ExternalAxes:
    return (None, value, None, None, None, None)


def target(position: tuple[float, ...], wxyz: tuple[float, ...]) -> Array:
    """A pose from a table: position in mm, quaternion as printed, rounding taken off."""
    return pose(rotation_from_wxyz(wxyz), np.array(position) / 1000)


HALF = 0.5**0.5
# Controller output for an IRB 140: joints [deg], tool0 position [mm], quaternion, confdata. The last four are one pose.
TABLE = {
    "all at zero": ((0, 0, 0, 0, 0, 0), (515, 0, 712), (HALF, 0, HALF, 0), (0, 0, 0, 0)),
    "wrist bent by 30": ((0, 0, 0, 0, 30, 0), (506.292, 0, 679.5), (0.5, 0, 0.866025, 0), (0, 0, 0, 0)),
    "wrist bent by 90": ((0, 0, 0, 0, 90, 0), (450, 0, 647), (0, 0, 1, 0), (0, 0, 0, 0)),
    "axis 1 on a quadrant": ((90, 0, 0, 0, 0, 0), (0, 515, 712), (0.5, -0.5, 0.5, 0.5), (1, 0, 0, 0)),
    "axis 1 at -90": (
        (-90, 0, 0, 0, 30, 0),
        (0, -506.292, 679.5),
        (0.353553, 0.612372, 0.612372, -0.353553),
        (-1, 0, 0, 0),
    ),
    "all axes positive": (
        (30, 20, 10, 45, 30, 60),
        (473.030, 299.640, 452.241),
        (0.022260, -0.492348, -0.791955, -0.360423),
        (0, 0, 0, 0),
    ),
    "axis 6 beyond 180": (
        (-45, -30, 20, -100, 60, 200),
        (169.069, -247.468, 745.025),
        (0.784108, 0.580900, -0.212351, 0.051352),
        (-1, -2, 2, 0),
    ),
    "axis 4 beyond 180, axis 6 at -270": (
        (120, 40, -60, 190, -45, -270),
        (-365.491, 617.086, 730.930),
        (0.494994, -0.816436, -0.199234, 0.220725),
        (1, 2, -3, 1),
    ),
    "cfx 1 at 23.9625": (
        (23.9625, 6.7721, -7.1508, 90.852, -23.9653, -90.9324),
        (515, 200, 712),
        (HALF, 0, HALF, 0),
        (0, 1, -2, 1),
    ),
    "cfx 2 at 23.9625": (
        (23.9625, 92.3536, -172.849, -24.2578, 81.3214, 3.8899),
        (515, 200, 712),
        (HALF, 0, HALF, 0),
        (0, -1, 0, 2),
    ),
    "cfx 4 at 23.9625 - 180": (
        (-156.038, -83.6501, -38.9353, 152.189, 60.5187, 14.5523),
        (515, 200, 712),
        (HALF, 0, HALF, 0),
        (-2, 1, 0, 4),
    ),
    "cfx 6 at 23.9625 - 180": (
        (-156.038, -31.1061, -141.065, 107.04, 25.1372, 71.296),
        (515, 200, 712),
        (HALF, 0, HALF, 0),
        (-2, 1, 0, 6),
    ),
}


@pytest.mark.parametrize("row", TABLE)
def test_the_twelve_rows_of_controller_output(row: str) -> None:
    joints, position, wxyz, conf = TABLE[row]
    kinematics, q, X_WF = robot(), np.radians(joints), target(position, wxyz)
    assert kinematics.confdata(q) == ConfData(*conf)
    # Joints are printed to 1e-4 or 1e-3 deg (2e-5 rad), poses to 1e-6; the singular wrist multiplies that.
    np.testing.assert_allclose(kinematics.forward(q, NO_EXTERNAL_AXES), X_WF, rtol=0, atol=2e-5)
    from_exact = kinematics.inverse(kinematics.forward(q, NO_EXTERNAL_AXES), NO_EXTERNAL_AXES, ConfData(*conf), None)
    assert from_exact is not None
    np.testing.assert_allclose(from_exact, q, rtol=0, atol=1e-7)
    if 0 not in (joints[3], joints[4]):  # at q4 = 0 and q5 = 0 the rounding of the pose decides the quadrant
        from_print = kinematics.inverse(X_WF, NO_EXTERNAL_AXES, ConfData(*conf), None)
        assert from_print is not None
        np.testing.assert_allclose(from_print, q, rtol=0, atol=radians(2e-3))


def test_the_protocol_is_kept() -> None:
    kinematics: Kinematics = robot()
    assert kinematics.confdata(np.zeros(6)) == ConfData(0, 0, 0, 0)


def truth(name: str) -> list[dict[str, object]]:
    path = TRUTH / name
    cases: list[dict[str, object]] = json.loads(path.read_text())["cases"]
    return cases


def test_forward_and_confdata_of_250_postures() -> None:
    kinematics = robot()
    for case in truth("irb140_fk.json"):
        q = np.array(case["q"])
        X_WF = pose(rotation_from_wxyz(np.array(case["quat_wxyz"])), np.array(case["p"]))
        np.testing.assert_allclose(kinematics.forward(q, NO_EXTERNAL_AXES), X_WF, rtol=0, atol=1e-12)
        assert kinematics.confdata(q) == ConfData(**case["conf"])  # type: ignore[arg-type]


def test_every_solution_is_found_by_its_confdata_and_the_nearest_without() -> None:
    kinematics, seen = robot(), 0
    for case in truth("irb140_ik.json"):
        X_WF = np.array(case["T_rowmajor_4x4"]).reshape(4, 4)
        every = representatives(case)
        for conf in {tuple(c) for c, _ in every}:
            own = [q for c, q in every if tuple(c) == conf]
            for q in own:
                found = kinematics.inverse(X_WF, NO_EXTERNAL_AXES, ConfData(*conf), near=q + 1e-3)
                assert found is not None
                np.testing.assert_allclose(found, q, rtol=0, atol=1e-9)
                free = kinematics.inverse(X_WF, NO_EXTERNAL_AXES, None, near=q - 1e-3)
                assert free is not None
                np.testing.assert_allclose(free, q, rtol=0, atol=1e-9)
                seen += 1
        missing = next(c for c in range(8) if c not in {conf[3] for conf, _ in every}) if len(every) < 8 else None
        if missing is not None:
            assert kinematics.inverse(X_WF, NO_EXTERNAL_AXES, ConfData(0, 0, 0, missing), None) is None
    assert seen > 500


def representatives(case: dict[str, object]) -> list[tuple[list[int], Array]]:
    out = []
    for solution in case["solutions"]:  # type: ignore[attr-defined]
        for one in solution["in_limits_representatives"]:
            conf = one["conf"]
            out.append(([conf[key] for key in ("cf1", "cf4", "cf6", "cfx")], np.array(one["q"])))
    return out


def test_the_rail_is_where_its_own_letter_says_in_mm() -> None:
    kinematics = robot(RAIL)
    q, extax = kinematics.start
    assert extax == on_rail(500.0)
    np.testing.assert_allclose(q, np.radians([10, 0, 0, 0, 30, 0]), rtol=0, atol=1e-15)
    at_start = kinematics.forward(q, NO_EXTERNAL_AXES)
    np.testing.assert_array_equal(at_start, kinematics.forward(q, on_rail(500.0)))
    moved = kinematics.forward(q, on_rail(800.0))
    # the rail runs along its own y, which the frame turns to the world's -x
    np.testing.assert_allclose(moved[:3, 3] - at_start[:3, 3], [-0.3, 0, 0], rtol=0, atol=1e-12)
    np.testing.assert_array_equal(kinematics.forward(q, (9.0, None, 9.0, 9.0, 9.0, 9.0)), at_start)
    back = kinematics.inverse(moved, on_rail(800.0), kinematics.confdata(q), None)
    assert back is not None
    np.testing.assert_allclose(back, q, rtol=0, atol=1e-9)
    assert kinematics.inverse(moved, on_rail(2201.0), None, None) is None  # outside the stroke


def test_without_a_hint_the_start_decides() -> None:
    text = BENCH.replace("0, 30, 0]", "0, 30, 350]")
    kinematics = robot(text)
    q = np.radians([0, 0, 0, 0, 30, -10])
    found = kinematics.inverse(kinematics.forward(q, NO_EXTERNAL_AXES), NO_EXTERNAL_AXES, None, None)
    assert found is not None
    np.testing.assert_allclose(np.degrees(found), [0, 0, 0, 0, 30, 350], rtol=0, atol=1e-9)
