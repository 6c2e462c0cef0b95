"""The 3-D view in a browser: the arm stands where pin has it, at the time of the page's clock."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from link_poses import link_poses
from report.drawn_plans import TOOL, drawn
from scipy.interpolate import CubicHermiteSpline
from window import Window

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.scene import HOLDER, SCRIPTS, plant_scene, robot_scene
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.scene import Cycle, ScenePoint, plan_cycle, program_points
from trajopt_cli.shapes import Box, Solid

CLOSE = 1e-4  # m, and of a rotation's entries
PLACE = pose(rotation_about([1, 0, 0], 0.3) @ rotation_about([0, 0, 1], -0.8), [-0.1, 0.2, 0.3])
TIP, LONG_TIP = (pose(rotation_about([0, 1, 0], 0.4), [0.05, -0.02, z]) for z in (0.1, 0.2))
AMPLITUDE, PULSE = np.array([1.1, 0.7, 0.5, 0.9, 0.8, 0.6, 1.0]), 1.7
DRAWN = drawn(rail=True)
SLOWER = 1.5
SMALL = 720, 620  # px: enough to see, and quick to draw without a graphics card


def page_of(scene: dict[str, Any], cycles: list[Cycle]) -> bytes:
    told = [{"name": one.name, "duration": float(one.t[-1])} for one in cycles]
    data = {"clock": {"duration": max(one["duration"] for one in told), "cycles": told}, "scene": scene}
    return document("A cell", "<h1>A cell</h1>", [Section("space", "In space", HOLDER)], data, SCRIPTS)


def swing(t: Array) -> Array:
    return AMPLITUDE * np.sin(PULSE * np.asarray(t)[..., None] + np.arange(7))


@pytest.fixture(scope="module")
def rail_page(written: Callable[[str, bytes], Path]) -> Path:
    """A plan on a rail, after the same one driven slower, with an obstacle in the way."""
    after = plan_cycle("Optimised", DRAWN.program, DRAWN.plan)
    before = Cycle("As written", SLOWER * after.t, after.q, after.tools)
    table = Box("table", np.array([0.3, 1.0, 0.05]), pose(np.eye(3), [0.5, 0.4, 0.2]))
    plant = replace(DRAWN.plant, obstacles=(Solid(table),))
    points = program_points(DRAWN.program, DRAWN.plan, plant)
    return written("rail.html", page_of(plant_scene(plant, points, [before, after]), [before, after]))


@pytest.fixture(scope="module")
def arm_page(written: Callable[[str, bytes], Path]) -> Path:
    """Seven joints that swing, rows 4 ms apart, with another tool after a second."""
    t = np.arange(0.0, 2.0001, 0.004)
    cycle = Cycle("Swing", t, swing(t), ((0.0, TIP), (1.0, LONG_TIP)))
    points = [ScenePoint("p_far", (0.4, 0.2, 0.9), "a.mod:7")]
    return written("arm.html", page_of(robot_scene(load_srs("iiwa7", PLACE), points, [cycle]), [cycle]))


def tool_by_pin(robot: Any, q: Array, X_FT: Array) -> Array:
    X_LF = robot.pin_model.frames[robot.pin_model.getFrameId("tool0")].placement.homogeneous
    return link_poses(robot, q[None])[0, -1] @ X_LF @ X_FT


def slide(window: Window, time: float) -> None:
    """As a hand does: the slider moves and says so."""
    script = "const s = document.getElementById('time'); s.value = arguments[0]; s.dispatchEvent(new Event('input'))"
    window.run(script, time)
    window.settle()


def shown_pose(window: Window, cycle: int) -> Array:
    return np.reshape(window.run("return TrajoptPage.view3d.poseOf(arguments[0])", cycle), (4, 4))


def test_the_slider_moves_both_arms_where_pin_has_them_each_at_its_own_time(window: Window, rail_page: Path) -> None:
    window.open(rail_page, flat=True)
    rows = DRAWN.plan.trajectory
    spline, end = CubicHermiteSpline(rows.t, rows.q, rows.qd), float(rows.t[-1])
    for time in (0.0, 0.313, 0.7771, 0.9 * end, 1.2 * end, SLOWER * end):
        slide(window, time)
        for cycle, own in ((0, time / SLOWER), (1, time)):
            X = tool_by_pin(DRAWN.plant.robot, spline(min(own, end)), TOOL.X_FT)
            np.testing.assert_allclose(shown_pose(window, cycle), X, atol=CLOSE)
    words = window.run("return TrajoptPage.view3d.describe()")
    found = [[float(v.replace("−", "-")) for v in xyz] for xyz in re.findall(r"x (\S+), y (\S+), z (\S+) mm", words)]
    np.testing.assert_allclose(found, [1000 * X[:3, 3], 1000 * X[:3, 3]], atol=0.6)
    assert f"Optimised at {end:.2f} s" in words
    assert f"As written at {SLOWER * end:.2f} s" in words


def test_seven_joints_and_a_tool_that_changes(window: Window, arm_page: Path) -> None:
    window.open(arm_page)
    robot = load_srs("iiwa7", PLACE)
    for time, tool in ((0.0, TIP), (0.998, TIP), (1.003, LONG_TIP), (1.777, LONG_TIP)):
        slide(window, time)
        np.testing.assert_allclose(shown_pose(window, 0), tool_by_pin(robot, swing(time), tool), atol=CLOSE)


def test_the_picture_shows_arm_rail_and_obstacle_and_follows_the_slider(window: Window, rail_page: Path) -> None:
    window.open(rail_page, *SMALL)
    ground = window.picture(".v3d-stage canvas")
    assert len(np.unique(ground.reshape(-1, 3), axis=0)) > 200
    red, _, blue = ground.astype(int).transpose(2, 0, 1)
    half = ground.shape[1] // 2
    for side in (slice(0, half), slice(half, None)):  # an orange arm in either
        assert (red > blue + 60)[:, side].mean() > 0.02
    slide(window, 0.8)
    moved = window.picture(".v3d-stage canvas")
    assert (np.abs(moved.astype(int) - ground).max(axis=2) > 40).mean() > 0.01
    slide(window, 0.0)
    assert (np.abs(window.picture(".v3d-stage canvas").astype(int) - ground).max(axis=2) > 40).mean() < 1e-4


def test_keys_turn_the_view_and_leave_the_time_alone(window: Window, rail_page: Path) -> None:
    from selenium.webdriver.common.keys import Keys

    window.open(rail_page, *SMALL)
    slide(window, 0.5)
    window.run("document.querySelector('.v3d-stage canvas').focus()")
    window.keys("0")  # the view as it is; from the first key on a ring shows what has the focus
    pictures = [window.picture(".v3d-stage canvas")]
    for key in (Keys.ARROW_LEFT, "+", "4", "0"):
        window.keys(key)
        pictures.append(window.picture(".v3d-stage canvas"))
        assert (np.abs(pictures[-1].astype(int) - pictures[-2]).max(axis=2) > 25).mean() > 0.01
    assert np.array_equal(pictures[0], pictures[-1])
    assert window.run("return TrajoptPage.clock.time") == 0.5


def test_cycles_stand_below_each_other_where_the_page_is_narrow(window: Window, rail_page: Path) -> None:
    tags = "return [...document.querySelectorAll('.v3d-tag')].map((e) => [e.getBoundingClientRect().left, e.offsetTop])"
    window.open(rail_page, flat=True)
    (x, y), (x_2, y_2) = window.run(tags)
    assert x_2 > x + 300
    assert y_2 == y
    window.open(rail_page, 390, 844, flat=True)
    (x, y), (x_2, y_2) = window.run(tags)
    assert x_2 == x
    assert y_2 > y + 200
    assert window.run("return document.documentElement.scrollWidth <= innerWidth")


def test_a_point_is_named_with_its_place(window: Window, arm_page: Path) -> None:
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.select import Select

    window.open(arm_page, flat=True)
    tip = window.chrome.find_element(By.CSS_SELECTOR, ".v3d-tip")
    assert not tip.is_displayed()
    Select(window.chrome.find_element(By.CSS_SELECTOR, ".v3d-tools select")).select_by_visible_text("p_far")
    window.settle()
    assert tip.text == "p_far (400.0, 200.0, 900.0) mm · a.mod:7"


def test_a_click_on_a_point_goes_to_when_the_tool_is_there(window: Window, rail_page: Path) -> None:
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.select import Select

    window.open(rail_page, *SMALL)
    first, _, second, _ = DRAWN.plan.motions
    script = "return TrajoptPage.view3d.timeAt(arguments[0], TrajoptPage.data.scene.points[arguments[1]].position)"
    choice = window.chrome.find_element(By.CSS_SELECTOR, ".v3d-tools select")
    Select(choice).select_by_index(1)  # behind "none"
    window.settle()
    tip, stage = (window.chrome.find_element(By.CSS_SELECTOR, name).rect for name in (".v3d-tip", ".v3d-stage"))
    spot = tip["x"] + tip["width"] / 2 - stage["x"], tip["y"] + tip["height"] + 12 - stage["y"]
    middle = stage["width"] / 2, stage["height"] / 2
    canvas = window.chrome.find_element(By.CSS_SELECTOR, ".v3d-stage canvas")
    aside = [int(one - half) for one, half in zip(spot, middle, strict=True)]
    ActionChains(window.chrome, duration=0).move_to_element_with_offset(canvas, *aside).click().perform()
    assert window.run("return TrajoptPage.clock.time") == pytest.approx(SLOWER * first.t_1, abs=0.03)
    for point, planned in ((0, first), (1, second)):
        assert window.run(script, 1, point) == pytest.approx(planned.t_1, abs=0.03)
        assert window.run(script, 0, point) == pytest.approx(SLOWER * planned.t_1, abs=0.03)


def test_what_a_screen_reader_is_told(window: Window, arm_page: Path) -> None:
    window.open(arm_page, flat=True)
    slide(window, 1.0)
    script = (
        "const d = arguments[0]; setTimeout(() => d(document.querySelector('[aria-live=polite]').textContent), 900)"
    )
    told = window.chrome.execute_async_script(script)
    assert told.startswith("Swing at 1.00 s: tool at x ")
    (view,) = [node for node in window.tree() if node["role"]["value"] == "application"]
    assert view["name"]["value"] == f"Arm in space. {told}"


def test_without_webgl_the_arm_is_drawn_as_lines(window: Window, rail_page: Path) -> None:
    window.open(rail_page, *SMALL, flat=True)
    assert "no WebGL" in window.run("return document.querySelector('.v3d-help').textContent")
    red, _, blue = window.picture(".v3d-stage canvas").astype(int).transpose(2, 0, 1)
    assert (red > blue + 60).mean() > 0.002


def test_what_positioners_carry_stands_where_a_product_of_turns_has_it(window: Window, arm_page: Path) -> None:
    """Two axes, one on the other, 0.3 and 0.4 of the way from one row to the next."""
    window.open(arm_page, flat=True)
    first, second = PLACE, PLACE @ pose(rotation_about([0, 1, 0], 0.5), [0.2, 0, 0.1])
    axes = [
        {"parent": parent, "X": X.ravel().tolist(), "back": np.linalg.inv(X).ravel().tolist(), "kind": "revolute"}
        for parent, X in ((-2, first), (3, second))
    ]
    script = (
        "const plain = (values) => ({data: values});"
        "const scene = {chain: [0, 0, 0], axes: [], tables: arguments[0], base: []};"
        "const cycle = {t: [0, 1], q: [], path: [], path_t: [], tools: [], driven: [], turned: [0, 0, 1, 2]};"
        "return new TrajoptView3DMotion.Motion(scene, cycle, plain).tables(arguments[1]);"
    )
    for time in (0.3, 1.0):
        found = [np.reshape(X, (4, 4)) for X in window.run(script, axes, time)]
        turns = [
            X @ pose(rotation_about([0, 0, 1], angle), [0, 0, 0]) @ np.linalg.inv(X)
            for X, angle in ((first, time), (second, 2 * time))
        ]
        np.testing.assert_allclose(found, [turns[0], turns[0] @ turns[1]], atol=1e-9)
