"""What the rail job's page shows equals the plans it is made from."""

from __future__ import annotations

import json
import re
from base64 import b64decode
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from report.drawn_plans import PAUSE, TOOL, drawn, summarized

from trajopt_cli.findings import Finding, Report
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.page import samples
from trajopt_cli.page.cell import AROUND, WHOLE, program_section, sources_data
from trajopt_cli.page.changes import changes_section
from trajopt_cli.page.compared import compared_page
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.optimized import Provenance, optimized_page
from trajopt_cli.page.samples import GAP, sample_times
from trajopt_cli.page.waterfall import Bar, by_motion, waterfall
from trajopt_cli.problem.constant_speed import Dip, Stretch, Why
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.summary import Judged
from trajopt_cli.trajectory import Trajectory, hermite

RAIL, BARE = drawn(rail=True), drawn(rail=False)
LEGAL = Report((Finding("joint speed", "joint_1", 1.25, 2.5, "rad/s", True, 0.5),))
HOSTILE = "! </script><script>alert(1)</script> <!-- & \u2028"
DRAWN_AT = RAIL.program.motions[0].source
MADE = Provenance([("made by", "a test")], {"t.mod": "abc"})


def slower(plan: Plan, factor: float = 1.5) -> Plan:
    """The same motion in more time, as the program as written."""
    rows = plan.trajectory
    assert rows.qd is not None
    motions = tuple(replace(m, t_0=m.t_0 * factor, t_1=m.t_1 * factor) for m in plan.motions)
    trajectory = Trajectory(rows.names, rows.t * factor, rows.q, rows.qd / factor)
    return replace(plan, target=Target.RAPID, trajectory=trajectory, motions=motions, lower_bound=None)


def made(case: Any = RAIL, program: Program | None = None, written: Plan | str | None = None, kept: Any = None) -> str:
    rapid = replace(case.plan, target=Target.RAPID)
    plans = {Target.STREAM: Judged(case.plan, RowsFile(), LEGAL), Target.RAPID: Judged(rapid, RowsFile(), LEGAL)}
    before = slower(case.plan) if written is None else written
    own = program or case.program
    told = summarized(own, case.plant, plans, before, ["a note"])
    return optimized_page("t.mod", own, case.plant, Target.STREAM, told, plans, before, MADE, kept).decode()


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    return json.loads(found.group(1))


def flange(q: Array) -> Array:
    """X_WF (4, 4) by pin."""
    import pinocchio as pin

    model = RAIL.plant.robot.pin_model
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    return data.oMf[model.getFrameId("tool0")].homogeneous


def array(block: dict[str, Any]) -> Array:
    return np.frombuffer(b64decode(block["f32"]), "<f4").reshape(block["shape"]).astype(np.float64)


@pytest.fixture(scope="module")
def page() -> str:
    return made()


@pytest.fixture(scope="module")
def data(page: str) -> dict[str, Any]:
    return data_of(page)


def test_the_curves_are_those_of_the_rows(data: dict[str, Any]) -> None:
    assert [one["name"] for one in data["cycles"]] == ["as written", "stream plan", "rapid plan"]
    assert data["clock"]["shown"] == [0, 1]
    limits = RAIL.plant.limits
    for cycle, plan in zip(data["cycles"], (slower(RAIL.plan), RAIL.plan, RAIL.plan), strict=True):
        t = array(cycle["t"])
        assert cycle["duration"] == plan.duration == data["clock"]["cycles"][data["cycles"].index(cycle)]["duration"]
        assert len(t) < len(plan.trajectory.t)
        assert np.diff(t).max() <= max(GAP, np.diff(plan.trajectory.t).max()) + 1e-6
        fine = np.linspace(0, plan.duration, 5000)
        shares = zip(("q", "qd"), (limits.upper - limits.lower, limits.velocity), strict=True)
        for (name, span), exact in zip(shares, hermite(plan.trajectory, fine), strict=False):
            shown = array(cycle[name])
            drawn = np.column_stack([np.interp(fine, t, column) for column in shown.T])
            assert np.abs((drawn - exact) / span).max() < 2e-3, name
        # an acceleration jumps in the page where it does in the rows, and its greatest is there to be seen
        clear = fine[np.abs(fine[:, None] - t).min(axis=1) > 1e-5]
        exact = hermite(plan.trajectory, clear)[2] / limits.acceleration
        drawn = np.column_stack([np.interp(clear, t, column) for column in array(cycle["qdd"]).T])
        assert np.abs(drawn / limits.acceleration - exact).max() < 2e-3
        exact = np.abs(hermite(plan.trajectory, plan.trajectory.t)[2]).max(axis=0)
        assert np.abs(array(cycle["qdd"])).max(axis=0) == pytest.approx(exact, rel=1e-5)


def test_the_tool_speed_is_that_of_pins_poses(data: dict[str, Any]) -> None:
    cycle = data["cycles"][1]
    step, rows = 1e-5, RAIL.plan.trajectory
    for time in (0.1, 0.35, 0.8 * rows.duration):
        q = hermite(rows, np.array([time - step, time + step]))[0]
        places = [(flange(row) @ TOOL.X_FT)[:3, 3] for row in q]
        speed = float(np.linalg.norm(places[1] - places[0])) / (2 * step)
        assert np.interp(time, array(cycle["t"]), array(cycle["speed"])) == pytest.approx(speed, rel=2e-3)


def test_motions_and_waits_stand_where_the_plan_has_them(data: dict[str, Any]) -> None:
    legs, motions = data["cycles"][1]["legs"], RAIL.plan.motions
    assert legs["index"] == [0, 1, 2, 3]
    assert legs["kind"] == ["joint", "wait", "joint", "joint"]
    assert legs["from"] == [motion.t_0 for motion in motions]
    assert legs["to"] == [motion.t_1 for motion in motions]
    assert legs["to"][1] - legs["from"][1] == pytest.approx(PAUSE)
    assert data["cycles"][1]["bound"] == RAIL.plan.lower_bound
    assert data["programs"][0]["place"] == ["t.mod:1", "t.mod:2", "t.mod:3", "t.mod:4"]
    assert [v for _, _, v in data["cycles"][1]["programmed"]] == [0.8] * 3


def test_the_table_has_each_motions_times_and_their_difference(page: str) -> None:
    rows = re.findall(r'<tr data-motion="(\d+)">(.*?)</tr>', page)
    for (index, row), motion, before in zip(rows, RAIL.plan.motions, slower(RAIL.plan).motions, strict=True):
        cells = [re.sub("<[^>]*>", "", cell) for cell in re.findall("<td.*?</td>", row)]
        was, now = before.t_1 - before.t_0, motion.t_1 - motion.t_0
        assert int(index) == motion.index
        assert cells[3:] == [f"{was:.3f}", f"{now:.3f}", f"{was - now:.3f}", "joint_1 acceleration"]
        assert cells[0] == f"t.mod:{motion.source.line}"


def test_the_reach_of_each_point_holds_where_the_rail_is(data: dict[str, Any]) -> None:
    reach = data["reach"]
    assert sorted(reach["ranges"]) == ["0", "2"]  # of poses; the way home is to joints
    for index, ranges in reach["ranges"].items():
        rail = RAIL.plan.motions[int(index)].q_1[0]
        assert any(low - 1e-6 <= rail <= high + 1e-6 for low, high in ranges)
    assert data_of(made(BARE))["reach"] == {"ranges": {}, "asked": {}, "left_out": 0}


def test_hostile_comments_stay_text_and_keep_their_lines(page: str) -> None:
    program = replace(RAIL.program, files={"t.mod": TextFile("t.mod", f"{HOSTILE}\r\nMoveJ;\n", "utf-8")})
    hostile = made(program=program)
    assert hostile.count("<script") == page.count("<script")
    assert hostile.count("</script") == page.count("</script")
    assert data_of(hostile)["sources"] == [{"name": "t.mod", "parts": [[1, [HOSTILE, "MoveJ;", ""]]], "cut": False}]


def test_plans_of_a_program_that_cannot_be_driven_as_written_stand_beside_each_other() -> None:
    page = made(written="t.mod:1:1: MoveJ p_one is out of <reach>")
    assert "cannot be driven: t.mod:1:1: MoveJ p_one is out of &lt;reach&gt;" in page
    data = data_of(page)
    assert [one["name"] for one in data["cycles"]] == ["stream plan", "rapid plan"]
    assert data["clock"]["shown"] == [1, 0]  # the plan that is shown behind the other one
    assert 'id="saving"' not in page


def test_rows_that_bend_are_kept_and_rows_on_a_line_are_not(monkeypatch: pytest.MonkeyPatch) -> None:
    limits = RAIL.plant.limits
    t = np.arange(0.0, 1.0, 1e-3)
    turn = 2 * np.pi * np.linspace(5, 60, 7)
    size = 0.9 * np.minimum(limits.velocity / turn, limits.acceleration / turn**2)
    rows = Trajectory(limits.names, t, size * np.sin(t[:, None] * turn), size * turn * np.cos(t[:, None] * turn))
    kept = sample_times(rows, limits, np.array([]))
    spans = (limits.upper - limits.lower, limits.velocity, limits.acceleration)
    for shown, exact, span in zip(hermite(rows, kept), hermite(rows, t), spans, strict=True):
        lines = np.column_stack([np.interp(t, kept, column) for column in shown.T])
        assert np.abs((lines - exact) / span).max() < 1.5e-3
    calm = Trajectory(limits.names, t, np.outer(t, limits.velocity / 3), np.tile(limits.velocity / 3, (len(t), 1)))
    assert len(sample_times(calm, limits, np.array([]))) == pytest.approx(250, abs=2)
    marked = sample_times(calm, limits, np.array([0.457]))
    assert 0.457 in np.round(marked, 9)
    monkeypatch.setattr(samples, "MOST_ROWS", len(kept) // 3)  # of a long cycle curves show at last
    fewer = sample_times(rows, limits, np.array([0.457]))
    assert len(kept) / 30 < len(fewer) <= len(kept) // 3
    assert {0.0, 0.457, float(t[-1])} <= {*np.round(fewer, 9).tolist()}


def test_where_the_speed_should_be_kept_and_is_not_is_marked_and_told() -> None:
    where = (0, DRAWN_AT, "MoveL <p>", 0.0123, 0.5, 0.25, 0.4, 0.5, 0.25, 0.0625)
    dip = Dip(*where, Why.STOP, "stop & fine", "joint_1 acceleration", 1.0, "")
    stretches = {
        Target.STREAM: (Stretch(0, 2, 0.0, 1.0, 0.8, (dip,)),),
        Target.RAPID: (Stretch(0, 2, 0.0, 1.0, 0.8, ()),),
    }
    page = made(kept=stretches)
    assert [cycle["dips"] for cycle in data_of(page)["cycles"]] == [[], [[0.5, 0.75]], []]
    assert "stream plan: 800.0 mm should keep the programmed speed within 1 %; where they do not" in page
    assert "<td>MoveL &lt;p&gt;</td>" in page
    assert "<td>stop &amp; fine, limited by joint_1 acceleration</td>" in page
    assert "rapid plan: 800.0 mm should keep the programmed speed, and do within 1 %." in page


def test_a_long_wait_is_two_rows() -> None:
    plan, rows = RAIL.plan, RAIL.plan.trajectory
    assert rows.qd is not None
    stop = plan.motions[1].t_1
    late = rows.t >= stop - 1e-9
    t = np.r_[rows.t[~late & (rows.t <= plan.motions[1].t_0 + 1e-9)], rows.t[late] + 60.0]
    kept = np.isin(rows.t, np.r_[rows.t[~late & (rows.t <= plan.motions[1].t_0 + 1e-9)], rows.t[late]])
    longer = Trajectory(rows.names, t, rows.q[kept], rows.qd[kept])
    times = sample_times(longer, RAIL.plant.limits, np.array([]))
    assert np.count_nonzero((times > plan.motions[1].t_0) & (times < stop + 60 - 1e-9)) <= 1
    assert np.diff(times).max() == pytest.approx(60 + PAUSE)


def test_a_bar_per_line_and_the_bars_add_up() -> None:
    saved = [("MoveL a", "t.mod:1", 0.5), ("MoveL a", "t.mod:1", 0.25), ("MoveJ b", "t.mod:2", -0.125)]
    saved += [(f"MoveL p{i}", f"t.mod:{i}", 0.001) for i in range(3, 20)]
    bars = by_motion(saved, 10.0, 10.0 - sum(seconds for _, _, seconds in saved))
    assert bars[0] == Bar("MoveL a", 0.75, detail="t.mod:1, 2 times")
    assert sum(bar.seconds for bar in bars) == pytest.approx(0.625 + 0.017)
    assert len(bars) == 9
    html = waterfall(Bar("before", 10.0, total=True), bars[:1], Bar("after", 9.25, total=True), 5.0, "by motion")
    (start, step, end), bound = (
        re.findall(r'x="([\d.]+)".*?width="([\d.]+)"', html),
        re.findall(r"M([\d.]+) 0V10", html),
    )
    scale = float(start[1]) / 10.0
    assert [float(value) / scale for value in step] == pytest.approx([9.25, 0.75], abs=1e-2)
    assert float(end[1]) / scale == pytest.approx(9.25, abs=1e-2)
    assert [float(value) / scale for value in bound] == pytest.approx([5.0] * 3, abs=1e-2)
    assert "−0.750 s" in html


def test_of_a_long_module_the_lines_around_motions_are_kept() -> None:
    text = "\n".join(f"line {i}" for i in range(1, WHOLE + 100))
    program = replace(RAIL.program, files={"t.mod": TextFile("t.mod", text, "utf-8")})
    (source,) = sources_data([program], ["t.mod"])
    ((first, lines),) = source["parts"]
    assert (first, lines[0], len(lines)) == (1, "line 1", 4 + AROUND)


def row(name: str, **other: object) -> dict[str, object]:
    known = {"name": name, "target": "stream", "title": "", "moves": "", "cycle_time_s": 9.0, "lower_bound_s": None}
    return known | {"legal": True, "breaks": None} | other


def cause(name: str, cycle: float, saved: float) -> dict[str, object]:
    return {"name": name, "cycle_time_s": cycle, "saved_s": saved, "why_not": None}


def test_rows_that_are_no_plan_and_other_programs_have_no_motions_of_the_users() -> None:
    other = replace(RAIL.program, name="another")
    bare = Plan(Target.STREAM, RAIL.plan.trajectory, (), None, "")
    motions = [
        Shown("as-written", RAIL.program, slower(RAIL.plan), LEGAL),
        Shown("ruckig", RAIL.program, bare, LEGAL),
        Shown("thesis", other, RAIL.plan, None),
        None,
    ]
    rows = [
        row("as-written", saving=0.0),
        row("ruckig", saving=-1e-17),
        row("thesis", legal=False, breaks="joint speed", saving=None),
        {"name": "toppra", "target": "stream", "title": "TOPP-RA", "moves": "", "legal": None, "why": "n/a: <nothing>"},
    ]
    record = {"rows": rows, "saving_by_cause": {"steps": [cause("as written", 9.0, 0.0), cause("rail", 8.0, 1.0)]}}
    page = compared_page("t.mod", RAIL.program, RAIL.plant, record, motions, ["a notice"], MADE).decode()
    assert compared_page("t.mod", RAIL.program, RAIL.plant, record, motions, ["a notice"], MADE).decode() == page
    data = data_of(page)
    assert [one["program"] for one in data["cycles"]] == [0, 0, 1]
    assert data["cycles"][1]["legs"]["kind"] == ["joint", "wait", "joint"]
    assert data["cycles"][1]["legs"]["index"] == [-1] * 3
    assert data["cycles"][1]["legs"]["to"][1] - data["cycles"][1]["legs"]["from"][1] == pytest.approx(PAUSE)
    assert data["clock"]["shown"] == [0, 1]
    assert "n/a: &lt;nothing&gt;" in page
    assert "−0.0" not in page
    both = program_section(RAIL.program, [motions[0], motions[2]], [0, 1]).html
    assert re.findall(r'<td class="n">([^<]*)</td>', both)[1:3] == ["–", ""]  # another program's motions are not these
    assert "−1.000 s" in page
    assert data["scene"]["cycles"][1]["q"] == {"same": [1, "q"]}


def test_a_comparison_without_any_motion_still_has_its_rows() -> None:
    rows = [{"name": "as-written", "target": "rapid", "title": "", "moves": "", "legal": False, "why": "out of reach"}]
    record = {"rows": rows, "saving_by_cause": {"why_not": "as written: out of reach"}}
    page = compared_page("t.mod", RAIL.program, RAIL.plant, record, [None], [], MADE).decode()
    assert data_of(page) == {}
    assert "there is no plan to start from: as written: out of reach" in page


def test_a_page_of_a_cycle_is_small(page: str) -> None:
    seconds = sum(one["duration"] for one in data_of(page)["cycles"])
    empty = len(made(BARE, written="no")) / 2
    assert len(page) < empty + seconds * 8e6 / 45  # 8 MB for three cycles of 15 s


def test_the_diff_names_the_motions_of_each_new_line() -> None:
    """By the target's name where it is declared, by the line where something else or a move to it stands."""
    case = RAIL
    plans = {one: Judged(replace(case.plan, target=one), RowsFile(), LEGAL) for one in Target}
    told = summarized(case.program, case.plant, plans, slower(case.plan))
    first, wait = told.plans.rapid.motions[:2]
    file, line = first.source.rsplit(":", 2)[0], int(wait.source.rsplit(":", 2)[1])
    diff = (
        f"--- a/{file}\n+++ b/{file}\n@@ -90,1 +90,1 @@\n"
        f"-CONST {first.target}:=[1,</b>];\n+CONST {first.target}:=[2,</b>];\n"
        f"@@ -{line},1 +{line},1 @@\n-WaitTime 0.4;\n+MoveL {first.target};\n--- not a file's head\n"
    )
    html = changes_section(diff, told).html
    chips = re.findall(r'<b>?(\d?)[^\n]*?data-motion="(\d+)">([^<]*)<', html)
    assert [(index, said) for _, index, said in chips] == [
        (str(one.index), f"{one.name} {1.5 * one.time_s:.3f} → {one.time_s:.3f} s") for one in (first, wait)
    ]
    assert ":=[<b>2</b>,&lt;/b&gt;];" in html
    assert html.count('class="src add"') == 2
    assert html.count('class="src del"') == 3


def test_a_text_that_cannot_carry_the_plan_says_so() -> None:
    plans = {one: Judged(replace(RAIL.plan, target=one), RowsFile(), LEGAL) for one in Target}
    told = summarized(RAIL.program, RAIL.plant, plans, "cannot")
    assert "No RAPID text: it has &lt;none&gt;." in changes_section("it has <none>", told).html
    assert "needs no change" in changes_section("", told).html
