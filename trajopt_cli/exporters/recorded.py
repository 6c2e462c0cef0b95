"""The joint motion of a results folder, whichever command made it, at any rate."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.exporters.joint import resample
from trajopt_cli.exporters.sampled import at_rate, period_of
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.runs.folder import PLAN, TASK, kind_of, read_run
from trajopt_cli.runs.record import RunRecord
from trajopt_cli.runs.results import CHOSEN, read_results
from trajopt_cli.trajectory import Trajectory

_JOINTS = "joints.csv"


@dataclass(frozen=True, eq=False)
class Recorded:
    """A motion of all axes as a folder holds it: what it is, and when [s] it waits for what.

    period [s]: of a motion that is its rows and nothing else, as a controller is fed; None for one that is the cubic
    Hermite between its rows.
    """

    name: str
    trajectory: Trajectory
    holds: tuple[tuple[float, str], ...] = ()
    period: float | None = None

    def at(self, rate: float | None, rests: bool = True) -> tuple[Trajectory, str]:
        """The motion at rate [Hz], as recorded for None, and what a user should know of it. rests: False leaves two
        rows of a rest in a motion that is more than its rows. Raises InputError for a rate that cannot be."""
        if rate is None:
            return self.trajectory, ""
        return (resample(self.trajectory, rate, rests), "") if self.period is None else at_rate(self.trajectory, rate)


@of_kind(ErrorKind.RESULTS)
def recorded(folder: Path) -> Recorded:
    """The motion in a folder of `trajopt optimize` or `trajopt iiwa`.

    Raises InputError for a folder that is none, of another kind, without joints, or changed since it was written.
    """
    kind = kind_of(folder) if folder.exists() else PLAN
    if kind == PLAN:
        results = read_results(folder)
        trajectory = read_csv_text(results.texts[CHOSEN], str(folder / CHOSEN))[0]
        return Recorded(f"the {results.target.value} plan", trajectory, tuple(results.holds))
    if kind != TASK:
        raise InputError("holds no joint motion; give a folder of trajopt optimize or trajopt iiwa", file=str(folder))
    run = read_run(folder, RunRecord[Any])
    if _JOINTS not in run.contents:
        raise InputError(f"has no {_JOINTS}; make it with trajopt iiwa joints", file=str(folder))
    trajectory = read_csv_text(run.text(_JOINTS), str(folder / _JOINTS))[0]
    return Recorded("the arm's joints", trajectory, period=period_of(trajectory))
