"""The page that holds the theses against trajopt: its commands exist, its figures are those that come out."""

from __future__ import annotations

import re
import shlex
from functools import cache, partial
from pathlib import Path

import pytest
from typer.main import get_command

from trajopt_cli.cli import app
from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import Program, Wait
from trajopt_cli.pipeline.planning import changes_of
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import Freedom
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.study.case import Attempt, Case
from trajopt_cli.study.table import BASELINES

REPOSITORY = Path(__file__).parents[1]
PAGE = (REPOSITORY / "docs" / "parity.md").read_text(encoding="utf-8")
COMMANDS = sorted({command for command in re.findall(r"`(trajopt [a-z][^`]*)`", PAGE)})
# Of the tables' rows: the program, the row of `compare baseline`, and how the page calls it.
HELD = [
    ("hinge_line", "practice", "practice ("),
    ("hinge_line", "thesis", "thesis' heuristic"),
    ("hinge_line", "fixed-rail", "best fixed rail"),
    ("hinge_cell", "practice", "practice"),
    ("hinge_cell", "as-written", "as written"),
    ("hinge_cell", "thesis", "thesis"),
    ("hinge_cell", "fixed-rail", "fixed rail"),
    ("hinge_cell", "ruckig", "ruckig"),
]


@pytest.mark.parametrize("line", COMMANDS)
def test_a_command_of_the_page_is_one(line: str) -> None:
    command, words = get_command(app), shlex.split(line)[1:]
    while words and words[0] in getattr(command, "commands", {}):
        command = command.commands[words.pop(0)]  # type: ignore[attr-defined]
    context = command.make_context(line, words, resilient_parsing=not words)
    assert not getattr(command, "commands", {}) or not words, f"no such command: {words}"
    assert all(not word.startswith("--") or word in {o for p in command.params for o in p.opts} for word in words)
    assert context is not None
    for word in words:
        if word.startswith(("programs/", "robots/")):
            assert (REPOSITORY / word).is_file(), word


@cache
def job_of(name: str) -> Job:
    return read_job(REPOSITORY / "programs" / f"{name}.mod")


@cache
def planned(name: str, target: Target, freedom: Freedom) -> Plan | Infeasible:
    job = job_of(name)
    return optimize(job.program, job.plant, target, freedom, bounded=False, changes=changes_of(job, target))


def solve(name: str, program: Program, target: Target, freedom: Freedom) -> Plan | Infeasible:
    job = job_of(name)
    if program is job.program:
        return planned(name, target, freedom)
    return optimize(program, job.plant, target, freedom, bounded=False)


@pytest.mark.long
@pytest.mark.parametrize(("name", "row", "called"), HELD)
def test_a_figure_of_the_page_is_the_one_that_comes_out(name: str, row: str, called: str) -> None:
    part = PAGE[PAGE.index("The line, in numbers" if name == "hinge_line" else "Where a figure differs") :]
    line = next(one for one in part.splitlines() if one.startswith(f"| {called}"))
    figure = re.findall(r"\d+\.\d{3}", line)[0]
    made = BASELINES[row].make(Case(job_of(name).program, job_of(name).plant, partial(solve, name)))
    assert isinstance(made, Attempt)
    assert f"{made.trajectory.duration:.3f}" == figure


@pytest.mark.long
def test_the_generator_of_the_thesis_takes_what_the_page_says() -> None:
    """Without the waits; and its heuristic finds the two functional areas of the text."""
    job = job_of("hinge_line")
    case = Case(job.program, job.plant, partial(solve, "hinge_line"))
    made, ruled = (BASELINES[row].make(case) for row in ("bang-bang", "thesis"))
    assert isinstance(made, Attempt)
    assert isinstance(ruled, Attempt)
    waits = sum(motion.duration for motion in job.program.motions if isinstance(motion, Wait))
    said = re.search(r"the row `bang-bang` here needs (\d+\.\d{3}) s without\s+waits", PAGE)
    assert said is not None
    assert f"{made.trajectory.duration - waits:.3f}" == said[1]
    assert ruled.notes[0].startswith("2 functional areas")
