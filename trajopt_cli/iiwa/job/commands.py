"""The commands of `trajopt iiwa`: each works in folders and gives one answer for any renderer."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_path import Allowed, Lead
from trajopt_cli.iiwa.job import texts
from trajopt_cli.iiwa.job.folder import check_place, open_folder, read_summary
from trajopt_cli.iiwa.job.force import pressing
from trajopt_cli.iiwa.job.joints import follow_joints, stops_nothing
from trajopt_cli.iiwa.job.segments import make_segments
from trajopt_cli.iiwa.report.answer import Answer, Refused
from trajopt_cli.iiwa.task.joints import Unfollowable
from trajopt_cli.iiwa.task.model import AngleMeaning, Feed, Integration
from trajopt_cli.quantity import ANGLE, FORCE, LENGTH, MOMENT, option_value
from trajopt_cli.runs.files import check_writable
from trajopt_cli.table import TextTable

Tell = Callable[[str], None]


def segments(
    task: Path, output: Path | None, task_file: Path | None, angles: str | None, tell: Tell
) -> Answer | Refused:
    """Interpolate a task's poses and write the sequence. output: its folder, None for results/TASK; task_file: of a
    RAPID program or CSV path; angles: "relative" or "absolute", None for the task's own."""
    folder = output or Path("results") / task.stem
    made = make_segments(task, folder, task_file, AngleMeaning(angles) if angles else None, tell)
    if isinstance(made, Refused):
        return made
    line = texts.sequence_line(made.opened.equilibrium)
    notes = [f"note: {note}" for note in made.notes]
    passed = texts.passing_lines(made.facts, made.opened.task.route)
    return Answer(
        read_summary(folder)["sequence"],
        line,
        [texts.segments_table(task.name, made.facts), [*passed, line, *notes]],
        folder,
        f"written to {folder}",
    )


def joints(results: Path, arm_angle: str, goal: str | None, plots: Path | None, tell: Tell) -> Answer | Refused:
    """The arm's joints along a folder's sequence, written into it unless they would stop the controller's loop.

    arm_angle: "fixed", "free" or "optimal"; goal: what it is best for then.
    """
    _check_places(results, plots)
    if goal is not None and arm_angle != "optimal":
        raise InputError(f"--for {goal}: says what --arm-angle optimal is best for; the arm angle is {arm_angle} here")
    wanted = None
    if arm_angle == "optimal":
        from trajopt_cli.iiwa.task.arm_plan import Goal

        wanted = Goal(goal or "limits")
    opened, found = follow_joints(results, arm_angle == "free", wanted, tell)
    assert opened.folder is not None
    ahead = [] if opened.plan is None else [texts.ahead_line(opened)]
    if isinstance(found, Unfollowable):
        return Refused("out of reach", [f"{opened.task.file}: {found.message}", *ahead])
    line, written = texts.arm_line(found), stops_nothing(found)
    parts: list[TextTable | Sequence[str]] = [texts.joints_table(opened.robot.name, found.findings)]
    parts += [[line, texts.ease_line(opened.robot, found)]]
    if found.plan is not None:
        parts += [texts.chosen_table(found.plan), texts.chosen_lines(found.plan)]
    parts.append([f"note: {note}" for note in found.notes])
    failed = [one.message for one in found.findings if not one.passed]
    record = {"feasible": False, "answer": "limits broken", "why": failed}
    broken = (ahead or texts.failure_lines(found.findings)) if failed else []
    if not written:
        why = "" if ahead else ": the controller's loop would stop there"
        broken = [*broken, f"NOTHING WRITTEN{why}"]

    place = results / "joints.csv" if written else None
    where = f"written to {place}" if written else ""
    record = read_summary(results)["joints"] if written else record
    return Answer(record, line, parts, place, where, broken, lambda: _drawing().joint_pictures(opened, found))


def simulate(
    results: Path,
    contact: Path | None,
    engine: str | None,
    feed: str | None,
    integration: str | None,
    settle: float | None,
    plots: Path | None,
) -> Answer | Refused:
    """Run the controller on a folder's sequence and write what it does into it; arguments as of simulation.simulate."""
    from trajopt_cli.iiwa.job.pages import simulation_page
    from trajopt_cli.iiwa.job.simulation import simulate as run

    _check_places(results, plots)
    if settle is not None and not settle < float("inf"):
        raise InputError(f"--settle: needs a time of 0 to 600 s, not {settle}")
    how = Integration(integration) if integration else None
    found = run(results, simulation_page, contact, engine, Feed(feed) if feed else None, how, settle)
    if isinstance(found, Refused):
        return found

    lag = texts.lag_lines(found)
    return Answer(
        read_summary(results)["simulation"],
        lag[0],
        [
            *([texts.law_table(found.axes, found.opened.equilibrium.h)] if found.axes else []),
            [*lag, *texts.contact_lines(found), *texts.loop_time_line(found)],
            *([texts.force_table(found)] if found.forces else []),
        ],
        results / "simulation.csv",
        f"written to {results}: report.html (open it in a browser), simulation.csv",
        found.broken,
        lambda: _drawing().simulation_pictures(found),
    )


def schedule_feed(
    results: Path,
    max_lag: str,
    max_turn_lag: str | None,
    max_lead: str | None,
    max_turn_lead: str | None,
    unbounded: bool,
    front: bool,
    output: Path | None,
    plots: Path | None,
) -> Answer | Refused:
    """Retime a folder's sequence within bounds given as text with units, into output, None for RESULTS-dosed.

    unbounded: no lead is assumed where none is given.
    """
    from trajopt_cli.iiwa.job import feed_scheduling
    from trajopt_cli.iiwa.job.pages import feed_page

    # '.' and '..' have no name of their own
    beside = results if results.name not in ("", "..") else results.resolve()
    folder = output or beside.with_name(f"{beside.name}-dosed")
    check_place(plots, "--plots")
    if plots is not None and folder.absolute() in (plots.absolute(), *plots.absolute().parents):
        raise InputError("--plots: is the folder of the results or lies in it; choose another", file=str(plots))
    lead = _lead(max_lead, FORCE, LENGTH, "--max-lead")
    if front and lead is None:
        raise InputError("--front: needs a bound on the lead; give --max-lead")
    allowed = Allowed(
        option_value(max_lag, LENGTH, "--max-lag"),
        None if max_turn_lag is None else option_value(max_turn_lag, ANGLE, "--max-turn-lag"),
        lead,
        _lead(max_turn_lead, MOMENT, ANGLE, "--max-turn-lead"),
    )
    found = feed_scheduling.schedule_feed(results, folder, allowed, feed_page, front, unbounded)
    if isinstance(found, Refused):
        return found

    lines = texts.feed_lines(found)
    return Answer(
        read_summary(folder)["dosing"],
        "; ".join([lines[0], *found.remarks()]),
        [
            texts.feeds_table(f"{results.name}: {found.scheduled.allowed}", found),
            lines,
            *([texts.front_table(found)] if found.front else []),
        ],
        folder,
        f"written to {folder}: report.html (open it in a browser) and the sequence",
        draw=lambda: _drawing().feed_pictures(found),
    )


def commanded(results: Path) -> tuple[Array, Array, Array, Array, Array, Array]:
    """What a folder's controller is commanded: times (n,) [s], positions (n, 3) [m] and orientations (n, 3, 3) of the
    tool in the world, the wrench it is told to press with (n, 6) [N, Nm], its stiffness (6,), the base X_WB (4, 4)."""
    opened = open_folder(results)
    task, sequence, R_start = opened.task, opened.equilibrium, opened.X_start[:3, :3]
    asked = pressing(task, opened.plan or sequence, R_start) if task.wrench else None
    wrench = np.zeros((len(sequence.pose), 6)) if asked is None else asked.wrench
    poses = sequence.t, sequence.pose[:, :3], sequence.rotations(R_start)
    return *poses, wrench, task.compliance.K, task.X_WB


def _drawing() -> Any:
    """What draws, which loads Matplotlib."""
    from trajopt_cli.iiwa.job import drawing

    return drawing


def _check_places(results: Path, plots: Path | None) -> None:
    """Before the work: what the command finds can be written into RESULTS, and pictures into their folder."""
    check_place(plots, "--plots")
    if results.is_dir():
        check_writable(results, into=True)


def _lead(text: str | None, pushes: Mapping[str, float], stretches: Mapping[str, float], option: str) -> Lead | None:
    """A bound on the lead: a force or moment, or what a spring that pushes as much is stretched by."""
    if text is None:
        return None
    stretch = any(text.strip().endswith(unit) for unit in stretches) and not text.strip().endswith(tuple(pushes))
    return Lead(option_value(text, {**pushes, **stretches}, option), stretch)
