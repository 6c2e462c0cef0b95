"""report.html of commands, as people use it: playing, keys, clicks, screen readers, both widths, light and dark."""

from __future__ import annotations

import json
import time
from pathlib import Path

import numpy as np
import pytest
from cli.fake_planner import ACCELERATION, CELL, TEXT, Planner
from window import Window

from trajopt_cli.cli import run
from trajopt_cli.problem.plan import Target

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses:
  - {name: start, at: start}
  - {name: side, by: [0, 0.08, 0, 0, 0, 20 deg]}
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
tool: {position: [0, 0, 0.1]}
contact:
  tip: 0.02
  obstacles:
    wall: {box: {size: [0.4, 0.2, 0.4], position: [0.6, 0.17, 0.05]}, stiffness: 10 N/mm, damping: 50, friction: 0.2}
"""
PAGES = ("plan", "iiwa")
LEVELS = ("light", "dark")
ROLES = {
    "button",
    "checkbox",
    "combobox",
    "link",
    "radio",
    "slider",
    "textbox",
    "application",
    "tab",
    "listbox",
    "switch",
}
# Contrast of every text that is seen against what lies behind it (WCAG 2.2, 1.4.3); the least, and whose it is.
CONTRAST = """
const luminance = (c) => { const [r, g, b] = c.map((v) => { v /= 255; return v <= 0.04045 ? v / 12.92
  : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
const parts = (text) => { const n = text.match(/[\\d.]+/g).map(Number); return n.length > 3 ? n : [...n, 1]; };
const ground = (e) => { for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor);
  if (c[3] === 1) return c; } return [255, 255, 255, 1]; };
let least = [99, ""];
for (const e of document.querySelectorAll("body *")) {
  const own = [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
  const box = e.getBoundingClientRect();
  if (!own || box.width < 2 || box.height < 2 || e.closest("script, noscript, .skip")) continue;
  const style = getComputedStyle(e);
  const [a, b] = [luminance(parts(style.color)), luminance(ground(e))].sort((p, q) => q - p);
  const large = parseFloat(style.fontSize) >= 24;
  const ratio = ((a + 0.05) / (b + 0.05)) * (large ? 1.5 : 1);
  if (ratio < least[0]) least = [ratio, `${e.tagName} ${e.className}: ${e.textContent.slice(0, 40)}`];
}
return least;
"""


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Results folders of optimize (its planner a stand-in) and of iiwa simulate."""
    place = tmp_path_factory.mktemp("report")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("trajopt_cli.plan.optimize", Planner())
        patch.setattr("trajopt_cli.plan.lower_bound_of", lambda program, plant, plan, **more: 0.9 * plan.duration)
        patch.chdir(place)
        Path("tiny.mod").write_text(TEXT)
        Path("tiny.yaml").write_text(CELL)
        Path("small.yaml").write_text(TASK)
        assert run(["optimize", "tiny.mod", "--output", "plan"]) == 0
        assert run(["iiwa", "segments", "small.yaml", "--output", "iiwa"]) == 0
        assert run(["iiwa", "simulate", "iiwa", "--engine", "spring"]) == 0
    return {name: place / name for name in PAGES}


def report(folders: dict[str, Path], name: str) -> Path:
    return folders[name] / "report.html"


def clock(window: Window) -> float:
    return float(window.run("return TrajoptPage.clock.time"))


@pytest.mark.parametrize("name", PAGES)
def test_everything_that_can_be_used_has_a_name(window: Window, folders: dict[str, Path], name: str) -> None:
    window.open(report(folders, name), flat=True)
    nodes = window.tree()
    used = [node for node in nodes if node["role"]["value"] in ROLES]
    assert len(used) > 12
    focusable = [
        node
        for node in nodes
        if any(p["name"] == "focusable" and p["value"].get("value") for p in node.get("properties", []))
        and node["role"]["value"] != "RootWebArea"
    ]
    nameless = [node["role"]["value"] for node in (*used, *focusable) if not node["name"].get("value", "").strip()]
    assert nameless == []
    images = [node for node in nodes if node["role"]["value"] in ("image", "img")]
    assert all(node["name"].get("value", "").strip() for node in images)
    headings = [node["name"]["value"] for node in nodes if node["role"]["value"] == "heading"]
    assert "Motion" in headings


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("width", [1280, 390])
def test_nothing_is_wider_than_the_window(window: Window, folders: dict[str, Path], name: str, width: int) -> None:
    window.open(report(folders, name), width, 844, flat=True)
    assert window.run("return document.documentElement.scrollWidth") <= width
    hidden = """return [...document.querySelectorAll("main button, main select, main input")].filter((e) => {
        const box = e.getBoundingClientRect();
        return box.width && !e.closest(".scroll") && (box.left < -0.5 || box.right > innerWidth + 0.5);
    }).length"""
    assert window.run(hidden) == 0


@pytest.mark.parametrize(("name", "first"), [*zip(PAGES, LEVELS, strict=True)])
def test_light_and_dark_can_both_be_read(window: Window, folders: dict[str, Path], name: str, first: str) -> None:
    grounds = {}
    window.open(report(folders, name), theme=first)
    window.run("document.querySelector('.v3d-stage').scrollIntoView({block: 'center'})")  # not under the time's bar
    for level in sorted(LEVELS, key=first.__ne__):
        window.theme(level)
        grounds[level] = window.run("return getComputedStyle(document.body).backgroundColor")
        least, where = window.run(CONTRAST)
        assert least >= 4.5, f"{level}: {where}"
        stage = window.picture(".v3d-stage canvas")[4, 4].mean()
        assert (stage > 128) == (level == "light")
    assert grounds["light"] != grounds["dark"]
    # the page's own switch wins over the system's
    window.theme("dark")
    window.run("document.getElementById('theme').click()")
    assert window.run("return getComputedStyle(document.body).backgroundColor") == grounds["light"]


def test_play_goes_on_and_pause_stops(window: Window, folders: dict[str, Path]) -> None:
    window.open(report(folders, "plan"), flat=True)
    window.run("const s = document.getElementById('rate'); s.value = '0.1'; s.dispatchEvent(new Event('change'))")
    button = "document.getElementById('play')"
    assert window.run(f"return {button}.textContent") == "Play"
    window.run(f"{button}.click()")
    until = time.monotonic() + 10
    while clock(window) < 0.02 and time.monotonic() < until:
        window.settle()
    assert clock(window) >= 0.02
    assert window.run(f"return {button}.textContent") == "Pause"
    window.run(f"{button}.click()")
    now = clock(window)
    window.settle()
    time.sleep(0.1)
    assert clock(window) == now
    slider = float(window.run("return Number(document.getElementById('time').value)"))
    assert slider == pytest.approx(now, abs=1e-3)


def test_space_and_arrow_keys(window: Window, folders: dict[str, Path]) -> None:
    from selenium.webdriver.common.keys import Keys

    window.open(report(folders, "plan"), flat=True)
    window.run("document.activeElement.blur()")
    window.keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_LEFT)
    assert clock(window) == pytest.approx(0.02)
    window.keys(" ")
    assert window.run("return TrajoptPage.clock.playing")
    window.keys(" ")
    assert not window.run("return TrajoptPage.clock.playing")


def test_a_click_on_a_block_or_a_row_goes_to_its_beginning(window: Window, folders: dict[str, Path]) -> None:
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.by import By

    window.open(report(folders, "plan"), flat=True)
    summary = json.loads((folders["plan"] / "summary.json").read_text())
    wait, back = summary["plans"]["rapid"]["motions"][1:]
    assert back["start_s"] == pytest.approx(2 * np.sqrt(np.radians(20) / ACCELERATION[Target.RAPID]) + 0.5)
    canvas = window.chrome.find_element(By.CSS_SELECTOR, "#gantt canvas")
    window.run("arguments[0].scrollIntoView({block: 'center'})", canvas)
    width, height, end = canvas.size["width"], canvas.size["height"], window.run("return TrajoptPage.zoom.to")
    share = (wait["start_s"] + 0.6 * wait["time_s"]) / end
    across = 96 + share * (width - 96 - 12)
    ActionChains(window.chrome).move_to_element_with_offset(
        canvas, across - width / 2, 65 - height / 2
    ).click().perform()
    assert clock(window) == pytest.approx(wait["start_s"], abs=2e-3)
    window.run("document.querySelectorAll('#motions tbody button')[2].click()")
    assert clock(window) == pytest.approx(back["start_s"], abs=2e-3)


def test_the_iiwas_arms_are_where_the_files_have_them(window: Window, folders: dict[str, Path]) -> None:
    from trajopt_cli.robot.srs import load_srs

    window.open(report(folders, "iiwa"), flat=True)
    heads, *rows = (folders["iiwa"] / "simulation.csv").read_text().splitlines()
    table = {name: i for i, name in enumerate(heads.split(","))}
    values = np.array([[float(one) for one in row.split(",")] for row in rows])
    robot, tool = load_srs("iiwa7"), np.eye(4)
    tool[2, 3] = 0.1
    pose = "return TrajoptPage.view3d.poseOf(arguments[0])"
    for row in (0, 300, 640, len(values) - 1):
        window.run("TrajoptPage.clock.seek(arguments[0])", float(values[row, 0]))
        commanded, predicted = (np.reshape(window.run(pose, i), (4, 4)) for i in (0, 1))
        x_e = values[row, [table[f"{axis}_e [m]"] for axis in "xyz"]]
        np.testing.assert_allclose(commanded[:3, 3], x_e, atol=1e-4)
        q = values[row, [table[f"joint_{j} [rad]"] for j in range(1, 8)]]
        np.testing.assert_allclose(predicted, robot.forward(q) @ tool, atol=1e-4)
    assert window.run("return TrajoptPage.data.scene.static.map((one) => one.name)") == ["wall"]
    titles = window.run("return [...document.querySelectorAll('figure.chart b:first-child')].map((e) => e.textContent)")
    for title in ("Lag", "Turn lag", "Force, of what touches the tool", "Depth of the tip", "joint 7"):
        assert title in titles
    window.run("document.querySelector('#legs tbody tr:last-child button').click()")
    last = float(window.run("return Number(document.querySelector('#legs tbody tr:last-child').dataset.from)"))
    assert clock(window) == pytest.approx(last)
    assert window.run("return document.querySelector('#legs [aria-current]').rowIndex") == window.run(
        "return document.querySelectorAll('#legs tr').length - 1"
    )
