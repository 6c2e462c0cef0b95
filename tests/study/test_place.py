"""Where something should stand: against closed forms, and against the same cell seen from another frame."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline import planning
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.robot.model import load_robot
from trajopt_cli.study.place import RESOLUTION, Placed, Tried, place, spread, tried
from trajopt_cli.study.places import Range, Site, parse_ranges, site_of
from trajopt_cli.units import DEG, MM

HOME = "[0,0,0,0,90,0]"
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 90, 0] deg'}\n"
OFF = (120.0, 50.0)  # mm by which the target is off home along x, z


def text(x: float, y: float, z: float) -> str:
    return f"""MODULE Tiny
    CONST jointtarget j_home:=[{HOME},[9E9,9E9,9E9,9E9,9E9,9E9]];
    TASK PERS wobjdata table:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
    CONST robtarget p_in:=[[{x:.4f},{y:.4f},{z:.4f}],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveL p_in, v100, fine, tool0 \\WObj:=table;
        WaitTime 0.2;
        MoveAbsJ j_home, vmax, fine, tool0;
    ENDPROC
ENDMODULE
"""


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Job:
    """A line at 100 mm/s to a target near home and back."""
    folder = tmp_path_factory.mktemp("place")
    home = load_robot("irb140").forward(np.radians([0.0, 0, 0, 0, 90, 0]))[:3, 3] / MM
    (folder / "tiny.mod").write_text(text(home[0] + OFF[0], home[1], home[2] + OFF[1]))
    (folder / "tiny.yaml").write_text(CELL)
    return read_job(folder / "tiny.mod")


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the places that are tried one is planned whole before its neighbours are."""
    monkeypatch.setattr("trajopt_cli.study.place.FEW", 1)


def answer(site: Site, target: Target = Target.RAPID, points: int = 8, jobs: int = 1) -> Placed:
    return place(site, target, lambda *_: None, Patience(), jobs, points)


@pytest.mark.long
@pytest.mark.usefixtures("few")
def test_a_work_object_is_moved_until_the_slow_line_to_it_is_shortest(job: Job) -> None:
    """At 100 mm/s the chord decides, and it is shortest straight above home."""
    found = answer(site_of(job, "station:Table", parse_ranges(["x=-200mm..0.04"])), points=4)
    assert found.best is not None
    assert found.steps is not None
    assert found.best.offset[0] == pytest.approx(-OFF[0] * MM, abs=2 * RESOLUTION)
    assert found.steps[0] <= RESOLUTION
    # what is saved is at least the way that is saved, but for the move back
    saved = (np.hypot(*OFF) - OFF[1]) / 100
    assert found.gained == pytest.approx(saved, abs=0.2)
    assert found.present.planned is not None
    assert "table" in found.in_words
    assert not any("a wider one" in line for line in found.remarks)
    moved = f'[FALSE,TRUE,"",[[{found.best.offset[0] / MM:g},0,0],[1,0,0,0]]'
    assert moved in found.site.to_paste(found.best.offset)


@pytest.mark.parametrize(("key", "value"), [("x", 0.05), ("z", -0.04), ("yaw", 12 * DEG)])
def test_a_base_moved_is_a_work_object_moved_the_other_way(job: Job, key: str, value: float) -> None:
    ranges = (Range(key, -0.5, 0.5),)
    seen = [
        tried(site_of(job, what, ranges), (way * value,), Target.RAPID, None)
        for what, way in (("base", 1), ("station:table", -1))
    ]
    assert seen[0].first == pytest.approx(seen[1].first, rel=1e-5)
    assert seen[0].first != pytest.approx(
        tried(site_of(job, "base", ranges), (0.0,), Target.RAPID, None).first, rel=1e-3
    )


@pytest.mark.long
@pytest.mark.usefixtures("few")
def test_the_answer_does_not_depend_on_how_many_processes_look_for_it(job: Job) -> None:
    quick = job.paths[0].with_name("quick.mod")
    quick.write_text(job.paths[0].read_text().replace("v100,", "v200,"))
    quick.with_suffix(".yaml").write_text(CELL)
    site = site_of(read_job(quick), "base", parse_ranges(["x=0.01..0.05"]))
    one, two = (answer(site, points=4, jobs=jobs) for jobs in (1, 2))
    assert one.places == two.places
    assert one.best == two.best
    assert one.best is not None
    # no neighbour that was planned is better, and there are neighbours on all sides
    assert one.steps is not None
    assert one.steps[0] <= RESOLUTION
    for way in (-1, 1):
        assert (site.ranges[0].rounded(one.best.offset[0] + way * one.steps[0]),) in one.places


def test_rows_are_judged_once(job: Job, monkeypatch: pytest.MonkeyPatch) -> None:
    """A full plan with the rows of the first motion is as legal as that; one with others is judged."""
    site, judged = site_of(job, "base", parse_ranges(["x=0..0.1"])), list[str]()

    def judge(*given: Any, **more: Any) -> Any:
        judged.append("once")
        return planning.judge(*given, **more)

    monkeypatch.setattr("trajopt_cli.study.answers.judge", judge)
    first = tried(site, (0.0,), Target.RAPID, None)
    assert len(judged) == 1
    assert tried(site, (0.0,), Target.RAPID, Patience(), first) == replace(first, planned=first.first)
    assert len(judged) == 1
    elsewhere = tried(site, (0.01,), Target.RAPID, Patience(), replace(first, offset=(0.01,)))
    assert len(judged) == 2
    assert elsewhere.rows != first.rows


def test_what_cannot_be_done_is_told_with_the_motion_at_the_nearest_place(job: Job) -> None:
    found = answer(site_of(job, "base", parse_ranges(["x=-3..-2"])), points=4)
    assert found.best is None
    assert not any("a wider one" in line for line in found.remarks)
    assert found.impossible[0].offset == (-2.0,)
    assert "MoveL p_in" in found.impossible[0].why
    assert found.impossible[0].motion == "tiny.mod:7"


def test_a_search_that_is_stopped_keeps_what_it_found(job: Job) -> None:
    patience = Patience()
    patience.interrupt()
    site = site_of(job, "base", parse_ranges(["x=-0.1..0.1"]))
    found = place(site, Target.RAPID, lambda *_: None, patience, 1, 8)
    assert list(found.places) == [(0.0,)]
    assert found.best is found.present
    assert found.steps is None
    assert found.stopped == "stopped by Ctrl-C"


def test_places_are_spread_over_all_of_the_ranges() -> None:
    ranges = (Range("x", -0.2, 0.4), Range("yaw", -0.5, 0.5))
    found = np.array(spread(ranges, 60))
    assert len(np.unique(found, axis=0)) == 60
    assert found.min(axis=0) == pytest.approx([-0.2, -0.5])
    assert found.max(axis=0) == pytest.approx([0.4, 0.5])
    cells = {tuple(one) for one in np.floor((found - [-0.2, -0.5]) / [0.151, 0.251]).astype(int)}
    assert len(cells) == 16  # none of 4 x 4 cells is empty
    assert spread(ranges[:1], 4) == [(-0.2,), (0.0,), (0.2,), (0.4,)]


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (["x=0.3..-0.3"], "--range x=0.3..-0.3: does not go upward; give the lower end first"),
        (["x=0.3"], "--range x=0.3: is not KEY=LOW..HIGH, as in x=-0.3..0.3 or yaw=-30deg..30deg"),
        (["x=-3kg..3"], "--range x=-3kg..3: unit 'kg' of \"-3kg\" is not one of m, cm, mm"),
        (["x=-300..300"], "--range x=-300..300: -300 m is more than 20 m; write millimetres as 300mm"),
        (["yaw=-30..30"], "--range yaw=-30..30: -1718.87 deg is more than half a turn; write degrees as 30deg"),
        (["x=-1..1", "X=0..1"], "--range X=0..1: x has a range already; keep one"),
        ([f"{key}=0..1" for key in "abcde"], "--range: needs 1 to 4 ranges, not 5; as in --range x=-0.3..0.3"),
    ],
)
def test_a_range_that_is_none_is_one_line(texts: list[str], said: str) -> None:
    with pytest.raises(InputError) as refused:
        parse_ranges(texts)
    assert refused.value.shown().strip() == said


@pytest.mark.parametrize(
    ("what", "ranges", "said"),
    [
        ("rail", ["x=0..1"], "--what rail: robot irb140 has no rail; give --what base"),
        ("station", ["x=0..1"], "--what station: is not one of base, rail, station:NAME"),
        (
            "station:tabel",
            ["x=0..1"],
            "--what station:tabel: the program moves in no such work object; did you mean 'table'?",
        ),
        ("station:wobj0", ["x=0..1"], "wobj0 is the world itself"),
        ("base", ["height=0..1"], "--range height: known: x, y, z, yaw"),
    ],
)
def test_what_is_not_there_cannot_be_moved(job: Job, what: str, ranges: list[str], said: str) -> None:
    with pytest.raises(InputError) as refused:
        site_of(job, what, parse_ranges(ranges))
    assert said in refused.value.shown()


def test_a_rail_has_directions_of_its_own_and_carries_the_base() -> None:
    job = read_job(Path(__file__).parents[2] / "programs" / "hinge_cell.mod")
    with pytest.raises(InputError, match="rides a rail, which carries its base; give --what rail"):
        site_of(job, "base", parse_ranges(["x=0..1"]))
    with pytest.raises(InputError, match="along, y name one direction twice"):
        site_of(job, "rail", parse_ranges(["along=0..1", "y=0..1"]))
    site = site_of(job, "rail", parse_ranges(["along=0..1", "across=-1..1", "height=0..1", "yaw=-1..1"]))
    offset = (0.1, 0.2, 0.3, 0.4)
    moved, robot = site.at(offset).plant.robot, job.plant.robot
    q = np.array([0.7, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    turned = np.eye(4)
    turned[:2, :2] = [[np.cos(0.4), -np.sin(0.4)], [np.sin(0.4), np.cos(0.4)]]
    turned[:3, 3] = [-0.2, 0.1, 0.3]  # this rail runs along the world's y
    assert moved.forward(q) == pytest.approx(turned @ robot.forward(q), abs=1e-12)
    # the cell file's copy says the same, and else what it said
    copy = site.changed_cell(offset, "copy.yaml")
    kept = [line for line in copy.splitlines() if "frame:" not in line]
    assert kept == job.cell_path.read_text().splitlines()


def test_a_program_that_asks_where_the_robot_is_is_read_again(job: Job, tmp_path: Path) -> None:
    """A target computed from where the tool stands moves with the base."""
    asking = tmp_path / "asks.mod"
    asking.write_text(
        "MODULE Asks\n PROC main()\n  VAR robtarget p;\n  p:=CRobT(\\Tool:=tool0\\WObj:=wobj0);\n"
        "  p.trans.z:=p.trans.z+100;\n  MoveJ p, v100, fine, tool0;\n ENDPROC\nENDMODULE\n"
    )
    (tmp_path / "asks.yaml").write_text(CELL)
    site = site_of(read_job(asking), "base", parse_ranges(["x=-0.5..0.5"]))
    before, after = (site.at((x,)).program.motions[0] for x in (0.0, 0.25))
    assert after.X_WT[0, 3] - before.X_WT[0, 3] == pytest.approx(0.25)  # type: ignore[union-attr]
    assert replace(site, ranges=()).frame(()) == pytest.approx(np.eye(4))


def of_function(monkeypatch: pytest.MonkeyPatch, cycle: Callable[[float], float]) -> list[tuple[float, bool]]:
    """Cycle times by a function of the place instead of by plans; which places are asked for, and whether fully."""
    asked = list[tuple[float, bool]]()

    def tried(_: Site, offset: tuple[float, ...], target: Target, patience: Any, known: Any = None) -> Tried:
        T = cycle(offset[0])
        asked.append((offset[0], patience is not None))
        return Tried(
            offset, first=1.2 * T if target is Target.STREAM else T, estimate=T, planned=T if patience else None
        )

    monkeypatch.setattr("trajopt_cli.study.place.tried", tried)
    return asked


@pytest.mark.parametrize("target", list(Target))
def test_the_present_place_is_planned_first_and_progress_counts_from_it(
    job: Job, monkeypatch: pytest.MonkeyPatch, target: Target
) -> None:
    asked, told = of_function(monkeypatch, lambda x: 10 + abs(x - 0.13)), list[Progress]()
    site = site_of(job, "base", parse_ranges(["x=-0.3..0.3"]))
    found = place(site, target, lambda _, progress: told.append(progress), Patience(), 1, 12)
    assert asked[:2] == [(0.0, False), (0.0, True)]
    times = [one.incumbent for one in told if one.incumbent is not None]
    assert max(times) <= 10.13
    assert times == sorted(times, reverse=True)
    assert found.gained == pytest.approx(0.13, abs=0.012)
    assert any("less than today's" in one.phase for one in told)


def test_the_search_ends_when_places_do_not_pay_and_says_after_which_rule(
    job: Job, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = of_function(monkeypatch, lambda x: 10 + 0.004 * x * x)
    found = place(site_of(job, "base", parse_ranges(["x=-4m..3m"])), Target.RAPID, lambda *_: None, Patience(), 1, 60)
    assert found.best is found.present
    assert sum(not full for _, full in asked) == 1 + 20
    assert sum(full for _, full in asked) <= 1 + 4 + 2
    assert len(found.ended) == 2
    assert all(line in [*found.remarks] for line in found.ended)
    assert found.steps is not None


@pytest.mark.long
def test_places_are_cut_by_the_time_and_the_answer_is_what_was_found(job: Job) -> None:
    site = site_of(job, "base", parse_ranges(["x=-0.1..0.1"]))
    for ticks in (0, 10, 20):
        clock = iter(range(1 << 30))
        found = place(site, Target.STREAM, lambda *_: None, Patience(ticks, lambda: float(next(clock))), 1, 4)  # noqa: B023
        assert found.present.first is not None
        assert found.stopped is not None
        assert found.best is not None
