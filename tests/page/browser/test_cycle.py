"""The rail job's page in a browser: one clock for charts, table and source, whichever cycles are chosen."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from report.drawn_plans import drawn, summarized
from window import Window

from trajopt_cli.findings import Finding, Report
from trajopt_cli.motion import TextFile
from trajopt_cli.page.optimized import Provenance, optimized_page
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.summary import Judged
from trajopt_cli.trajectory import Trajectory, hermite

TEXT = "MoveJ p_one; ! </script><script>document.title='no'</script>\nWaitTime 0.4;\nMoveJ p_two;\nMoveAbsJ j_home;\n"
DIFF = """\
--- a/t.mod
+++ b/t.mod
@@ -2,2 +2,2 @@
 WaitTime 0.4;
-MoveJ p_two;
+MoveJ p_two, v1000;
"""
SLOWER = 1.5
DRAWN = drawn(rail=True)
ENDS = [motion.t_1 for motion in DRAWN.plan.motions]


@pytest.fixture(scope="module")
def page(written: Callable[[str, bytes], Path]) -> Path:
    """A plan, and the same driven slower as the program as written."""
    rows = DRAWN.plan.trajectory
    assert rows.qd is not None
    motions = tuple(replace(m, t_0=m.t_0 * SLOWER, t_1=m.t_1 * SLOWER) for m in DRAWN.plan.motions)
    slow = Trajectory(rows.names, rows.t * SLOWER, rows.q, rows.qd / SLOWER)
    before = replace(DRAWN.plan, trajectory=slow, motions=motions, lower_bound=None)
    report = Report((Finding("joint speed", "joint_1", 1.25, 2.5, "rad/s", True, 0.5),))
    plans = {one: Judged(replace(DRAWN.plan, target=one), RowsFile(), report) for one in Target}
    program = replace(DRAWN.program, files={"t.mod": TextFile("t.mod", TEXT, "utf-8")})
    made = Provenance([("made by", "a test")], {"t.mod": "abc"})
    told = summarized(program, DRAWN.plant, plans, before)
    content = optimized_page("t.mod", program, DRAWN.plant, Target.STREAM, told, plans, before, made, changed=DIFF)
    return written("cycle.html", content)


def seek(window: Window, time: float) -> None:
    window.run("TrajoptPage.clock.seek(arguments[0])", time)
    window.settle()


def lit(window: Window, mark: str) -> tuple[str, str]:
    """The number of the line and the motion's index that a mark stands on."""
    line = window.run(f"return document.querySelector('#source .{mark} .number').textContent")
    return line, window.run(f"return document.querySelector('#motions .{mark}').dataset.motion")


def test_the_lines_of_both_cycles_follow_the_slider(window: Window, page: Path) -> None:
    window.open(page, flat=True)
    assert window.run("return document.title") == "t.mod · trajopt"
    seek(window, ENDS[1] + 0.01)  # the plan has waited, the slower one has not
    assert lit(window, "now-after") == ("3", "2")
    assert lit(window, "now-before") == ("2", "1")
    assert "WaitTime 0.4 s" in window.run("return document.querySelector('#now .before').textContent")
    seek(window, ENDS[3] + 0.5)  # after the plan's end
    assert lit(window, "now-after") == ("4", "3")
    clocks = window.run("return [...document.querySelectorAll('#clocks b')].map((e) => e.textContent)")
    assert clocks == [f"{ENDS[3] + 0.5:.3f} s", f"{ENDS[3]:.3f} s"]


def test_the_charts_say_the_numbers_of_the_rows(window: Window, page: Path) -> None:
    window.open(page, 1280, 2000, flat=True)
    time = 0.613
    seek(window, time)
    window.run("document.getElementById('axes').scrollIntoView()")
    window.chrome.execute_async_script(  # charts out of sight say nothing
        "const done = arguments[0], last = document.querySelector('#axes-charts figure:last-child output');"
        "const look = () => (last.textContent ? done() : setTimeout(look, 10)); look()"
    )
    now, before = (hermite(DRAWN.plan.trajectory, np.array([t]))[0][0] for t in (time, time / SLOWER))
    captions = window.run("return [...document.querySelectorAll('#axes-charts figcaption')].map((e) => e.textContent)")
    assert len(captions) == 7
    for k, caption in enumerate(captions):
        shown = [float(value.replace("−", "-")) for value in re.findall(r"(?:written|plan) ([−\d.]+)", caption)]
        scale = 1e3 if k == 0 else 180 / np.pi
        assert shown == pytest.approx([before[k] * scale, now[k] * scale], abs=0.51 if k == 0 else 0.06)


def test_keys_zoom_and_go_to_the_next_motion(window: Window, page: Path) -> None:
    window.open(page, flat=True)
    time, span = "return TrajoptPage.clock.time", "return [TrajoptPage.zoom.from, TrajoptPage.zoom.to]"
    window.keys("n")
    assert window.run(time) == pytest.approx(ENDS[0])
    window.keys("n", "p", "p")
    assert window.run(time) == pytest.approx(0.0)
    window.keys("+")
    assert window.run(span) == pytest.approx([0.0, ENDS[3] * SLOWER / 2])
    window.keys("0")
    assert window.run(span) == pytest.approx([0.0, ENDS[3] * SLOWER])


def test_another_cycle_can_be_chosen_and_fills_table_and_charts(window: Window, page: Path) -> None:
    window.open(page, flat=True)
    chosen = "const s = document.getElementById('cycle-0'); s.value = '2'; s.dispatchEvent(new Event('change'))"
    window.run(chosen)
    window.settle()
    head = window.run("return document.querySelector('#motions th:nth-child(4)').textContent")
    cells = window.run("return [...document.querySelectorAll('#motions tbody tr')].map((r) => r.cells[5].textContent)")
    assert (head, cells) == ("rapid plan [s]", ["0.000"] * 4)
    assert window.run("return TrajoptPage.clock.duration") == pytest.approx(ENDS[3])
    assert (
        window.run("return [...document.querySelectorAll('#source .saved')].map((e) => e.textContent).join('')") == ""
    )


def test_a_changed_line_goes_to_the_motion_it_changes(window: Window, page: Path) -> None:
    window.open(page, flat=True)
    assert window.run("return document.querySelector('#changes .add').textContent").startswith("+ 3MoveJ p_two, v1000;")
    window.run("document.querySelector('#changes .add button').click()")
    window.settle()
    assert window.run("return TrajoptPage.clock.time") == pytest.approx(ENDS[1], abs=1e-3)


@pytest.mark.parametrize(("width", "height"), [(1280, 900), (390, 844)])
def test_both_views_are_in_sight_at_first(window: Window, page: Path, width: int, height: int) -> None:
    window.open(page, width, height, flat=True)
    stage = window.run("return document.querySelector('.v3d-stage').getBoundingClientRect().bottom")
    assert stage < window.run("return document.getElementById('transport').getBoundingClientRect().top")
    seen = "return [...document.querySelectorAll('.keys')].filter((one) => one.offsetHeight).length"
    assert bool(window.run(seen)) == (width > 760)  # a telephone has no keys


def test_what_scrolls_sideways_shows_a_shadow(window: Window, page: Path) -> None:
    window.open(page, 390, 844, flat=True)
    wide = "const one = document.querySelector(arguments[0]); return one.scrollWidth - one.clientWidth"
    shown = "return getComputedStyle(document.querySelector(arguments[0])).backgroundAttachment"
    for name in (".bar nav", "#motions"):
        assert window.run(wide, name) > 0
        assert window.run(shown, name) == "local, local, scroll, scroll"
