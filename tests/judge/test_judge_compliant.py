"""The judge of the compliant job: legal folders pass, and every spoiled one is caught by the check that should."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from iiwa_folders import (
    CONTACT,
    PLATE,
    Sequence,
    bump,
    copied,
    edit_sequence,
    edit_table,
    list_files,
    make_folder,
    task_text,
)
from spoiled_iiwa import SPOILED

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_path import Allowed, Lead
from trajopt_cli.iiwa.job.feed_scheduling import ScheduledJob, schedule_feed
from trajopt_cli.iiwa.job.pages import feed_page, simulation_page
from trajopt_cli.iiwa.job.simulation import simulate
from trajopt_cli.iiwa.judge.verify import Judged, verify_folder
from trajopt_cli.iiwa.task.model import AngleMeaning, Feed

REPOSITORY = Path(__file__).parents[2]
FAR = """
v_max: 0.2
omega_max: 1
a_max: 2
epsilon_max: 2
poses:
  - start
  - {name: turned, by: [0, 0, 0, 0, 0, 95 deg]}
  - {name: on, by: [0, 0, 0, 0, 0, 95 deg]}
"""


CHECKS = {
    "path", "orientation", "backward", "pose reached", "poses missing", "first pose", "last pose",
    "rows behind the end", "v_max", "omega_max", "a_max", "epsilon_max", "jerk", "angular_jerk", "dwell", "standing",
    "period", "rows", "position", "angles", "angle jump", "joint position", "joint speed", "joint acceleration", "jump",
    "speed column", "first row", "last row", "tool position", "tool orientation", "position between rows",
    "orientation between rows", "configuration", "arm angle", "arm angle range", "start joints",
    "position fed", "orientation fed", "deviation", "law", "joints", "true force", "believed force", "depth",
    "duration", "lag", "turn lag", "push", "arrival", "force", "pressing", "arm speed", "lag off what it touches",
}  # fmt: skip


def failed(judged: Judged) -> set[str]:
    return {finding.check for report in judged.reports.values() for finding in report.findings if not finding.passed}


def messages(judged: Judged) -> list[str]:
    return [finding.message for report in judged.reports.values() for finding in report.findings if not finding.passed]


@pytest.fixture(scope="module")
def bases(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    made: dict[str, Path] = {}
    place = tmp_path_factory.mktemp("bases")

    def base(name: str) -> Path:
        if name not in made:
            if name == "free":
                made[name] = make_folder(place / name, task_text(poses=FAR), free=True)
            elif name in ("touching", "pressing"):
                made[name] = make_folder(place / name, task_text(poses=PLATE) + CONTACT, joints=False)
            else:
                joints = name in ("joints", "simulated")
                made[name] = make_folder(
                    place / name, task_text("trapezoid" if joints or name == "dosed" else name), joints=joints
                )
            if name in ("simulated", "touching"):
                simulate(made[name], simulation_page, engine="spring" if name == "touching" else None, settle=0.1)
            if name in ("dosed", "pressing"):
                lead, turn = (Lead(30.0), 0.02) if name == "dosed" else (Lead(60.0), None)
                before, made[name] = made[name], place / f"{name}-done"
                done = schedule_feed(before, made[name], Allowed(2e-3, turn, lead), feed_page)
                assert isinstance(done, ScheduledJob), done
        return made[name]

    return base


@pytest.mark.parametrize(
    "name",
    [
        *("joints", "trapezoid", "thesis", "s-curve", "free", "simulated"),
        *("touching", "dosed", "pressing"),
    ],
)
def test_what_is_spoiled_here_was_legal(name: str, bases: Callable[[str], Path]) -> None:
    judged = verify_folder(bases(name))
    assert messages(judged) == []


CHANGING = """
pushes: [{from: 0.1, to: 0.3, force: [5, -3, 8, 0.2, 0, -0.1]}, {from: 0.2001, to: 0.25, force: [0, 10, 0, 0, 0, 0]}]
zero: {components: [fx, mz], frame: [10 deg, 20 deg, 0]}
changes:
  - {at: b, K: [500, 600, 700, 20, 30, 40], zero: {components: [fz], frame: [0.3, 0.2, 0.1]}}
  - {at: a, D: [300, 300, 300, 10, 10, 10], clamps: {force: [4, 4, 4, 1, 1, 1]}}
"""


@pytest.mark.parametrize(
    ("rotation", "more", "feed", "engine"),
    [
        ("slerp", CHANGING, Feed.POSITION, "spring"),
        ("tait-bryan", CHANGING, Feed.POSITION, "spring"),
        (
            "slerp",
            "integration: exact\n" + CHANGING.replace("at: b", "at: 0.4").replace("at: a", "at: 0.2"),
            None,
            "spring",
        ),
        ("tait-bryan", "integration: exact\n", Feed.VELOCITY, None),
        ("slerp", "", Feed.VELOCITY, None),
    ],
)
def test_what_the_controller_makes_of_everything_is_legal(
    rotation: str, more: str, feed: Feed | None, engine: str | None, tmp_path: Path
) -> None:
    folder = make_folder(tmp_path / "out", task_text("trapezoid", rotation, more=more), joints=False)
    simulate(folder, simulation_page, feed=feed, engine=engine, settle=0.1)
    judged = verify_folder(folder)
    assert messages(judged) == []
    checks = {finding.check for finding in judged.reports["simulation.csv"].findings}
    assert {"law", "joints", "believed force"} <= checks


@pytest.mark.parametrize("digits", [15, 12, 10])
def test_a_sequence_of_fewer_digits_is_legal(digits: int, bases: Callable[[str], Path], tmp_path: Path) -> None:
    folder = copied(bases("s-curve"), tmp_path / "short")
    for name in ("equilibrium.csv", "equilibrium_quaternion.csv"):
        head, *rows = (folder / name).read_text().splitlines()
        short = (",".join(f"{float(field):.{digits}g}" for field in row.split(",")) for row in rows)
        (folder / name).write_text("\n".join([head, *short]) + "\n")
    assert messages(verify_folder(folder)) == []
    edit_table(folder, "equilibrium.csv", lambda rows: np.where(np.arange(rows.shape[1]) == 2, rows + 1e-8, rows))
    assert failed(verify_folder(folder)) == {"position"}


@pytest.mark.parametrize("name", sorted(SPOILED))
def test_a_spoiled_folder_is_caught(name: str, bases: Callable[[str], Path], tmp_path: Path) -> None:
    spoil, base, checks, besides = SPOILED[name]
    folder = copied(bases(base), tmp_path / "spoiled")
    spoil(folder)
    found = verify_folder(folder)
    assert checks <= failed(found) <= checks | besides, messages(found)
    assert all(len(message.splitlines()) == 1 for message in messages(found))


def test_the_spoil_book_breaks_every_check() -> None:
    every = set[str]().union(*(checks for _, _, checks, _ in SPOILED.values()))
    assert len(SPOILED) >= 20
    assert every == CHECKS


def shipped(name: str) -> str:
    """A task of ours with a row every 4 ms instead of every one."""
    before, after = (REPOSITORY / "programs" / f"iiwa_{name}.yaml").read_text(encoding="utf-8").split("h: 1 ms")
    return f"{before}h: 4 ms{after}"


@pytest.mark.parametrize("name", ["cube", "wall", "polish"])
def test_what_the_shipped_tasks_make_is_legal(name: str, tmp_path: Path) -> None:
    judged = verify_folder(make_folder(tmp_path / name, shipped(name)))
    assert messages(judged) == []
    assert judged.unchecked == ()
    assert list(judged.reports) == ["equilibrium.csv", "equilibrium_quaternion.csv", "joints.csv"]


HALF = """
v_max: 0.5
omega_max: 3
a_max: 4
epsilon_max: 8
poses:
  - start
  - {by: [0, 0, 0, 0, 0, 180 deg], dwell: 0.01}
  - {by: [0, 0, 0, 0, 0, 0], dwell: 0.0305}
  - {by: [0.01, 0, 0, 0, 0, -180 deg]}
  - {by: [0, 0, 0, 0, 0, -90 deg], dwell: 0.2 ms}
  - {by: [0, 0, 0, 0, 0, 300 deg]}
"""
MOUNTED = """
h: 2 ms
base: {position: [0.4, -0.2, 0.1], rpy: [0.1, -0.2, 0.5]}
arm_angle: {value: 20 deg, definition: swivel}
"""


@pytest.mark.parametrize(
    ("text", "angles"),
    [
        (task_text("trapezoid", "slerp"), None),
        (task_text("s-curve", "slerp"), AngleMeaning.ABSOLUTE),
        (task_text("s-curve", "tait-bryan", more="angles: absolute\n"), None),
        (task_text("trapezoid", "tait-bryan"), AngleMeaning.ABSOLUTE),
        (task_text("trapezoid", "tait-bryan", more="angles: absolute\n"), AngleMeaning.RELATIVE),
        (task_text("thesis", "slerp", poses=HALF), None),
        (task_text("trapezoid", "tait-bryan", poses=HALF), None),
        (task_text("trapezoid", "tait-bryan", more=MOUNTED), None),
        (task_text("trapezoid", more="limits: default\nrobot: iiwa7\narm_angle: {value: -15 deg}\n"), None),
    ],
)
def test_every_way_to_write_a_task_is_judged(text: str, angles: AngleMeaning | None, tmp_path: Path) -> None:
    judged = verify_folder(make_folder(tmp_path / "one", text, joints="poses:\n  - start" not in text, angles=angles))
    assert messages(judged) == []
    assert judged.unchecked == ()


def test_joints_of_steps_at_full_speed_break_accelerations_and_nothing_else(tmp_path: Path) -> None:
    judged = verify_folder(make_folder(tmp_path / "one", task_text("thesis")))
    assert failed(judged) == {"joint acceleration"}


def test_an_equilibrium_that_leads_the_arm_is_not_its_path(bases: Callable[[str], Path], tmp_path: Path) -> None:
    """Where a folder has the path apart from what is fed, the one is judged and the other only against its twin."""
    folder = copied(bases("trapezoid"), tmp_path / "led")
    for end in (".csv", "_quaternion.csv"):
        shutil.copy(folder / f"equilibrium{end}", folder / f"plan{end}")

    def lead(rows: Sequence, _: Path) -> None:
        rows.p[1:-1] += np.gradient(rows.p, axis=0)[1:-1] * 200

    edit_sequence(folder, lead)
    list_files(folder, "plan.csv", "plan_quaternion.csv")
    judged = verify_folder(folder)
    assert messages(judged) == []
    assert list(judged.reports) == [
        f"{name}{end}.csv" for name in ("equilibrium", "plan") for end in ("", "_quaternion")
    ]
    assert "angle jump" in {finding.check for finding in judged.reports["equilibrium.csv"].findings}
    assert "path" in {finding.check for finding in judged.reports["plan_quaternion.csv"].findings}
    assert "path" not in {finding.check for finding in judged.reports["equilibrium_quaternion.csv"].findings}
    assert "equilibrium.csv: its way and speeds, because it leads the arm along plan.csv" in judged.unchecked[0]

    def aside(rows: Array) -> None:
        rows[30:220, 3] += 2e-6 * bump(190)

    edit_table(folder, "plan_quaternion.csv", aside)
    assert {"path", "position"} <= failed(verify_folder(folder))


def test_a_dosed_sequence_keeps_its_path_and_its_caps(bases: Callable[[str], Path], tmp_path: Path) -> None:
    dosed = schedule_feed(bases("joints"), tmp_path / "dosed", Allowed(3e-3, lead=Lead(30.0)), feed_page)
    assert isinstance(dosed, ScheduledJob)
    judged = verify_folder(tmp_path / "dosed")
    assert messages(judged) == []
    checks = {finding.check for finding in judged.reports["plan_quaternion.csv"].findings}
    assert {"path", "v_max", "dwell"} <= checks
    assert not checks & {"a_max", "standing"}


def test_a_plan_that_passes_its_corners_at_speed_has_rows_at_them(tmp_path: Path) -> None:
    make_folder(tmp_path / "cube", shipped("cube").replace("profile: trapezoid", "profile: thesis"), joints=False)
    dosed = schedule_feed(tmp_path / "cube", tmp_path / "dosed", Allowed(5e-3, lead=Lead(150.0)), feed_page)
    assert isinstance(dosed, ScheduledJob)
    assert any("slowed down" in note for note in dosed.scheduled.notes)  # or the joints would break theirs
    assert dosed.scheduled.lag.maximum > 4e-3  # corners are cut
    judged = verify_folder(tmp_path / "dosed")
    assert messages(judged) == []
    assert {"pose reached", "v_max"} <= {finding.check for finding in judged.reports["plan_quaternion.csv"].findings}
