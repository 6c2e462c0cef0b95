"""The results folder: what is in it, when it may be replaced, and how it is read back."""

from __future__ import annotations

import os
import platform
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.findings import Report, finding_record
from trajopt_cli.motion import Move, Program, SignalEvent, Wait
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.runs.folder import FORMAT, SUMMARY, parse_record, record, sha256
from trajopt_cli.runs.plan_record import read_plan_record

CHOSEN = "trajectory.csv"
CSV = {Target.STREAM: "stream.csv", Target.RAPID: "rapid.csv"}
_SIGNAL_WAIT = "Wait"
_LIBRARIES = ("casadi", "numpy", "pin", "ruckig", "scipy", "toppra")


@dataclass(frozen=True, eq=False)
class Judged:
    """A plan, its trajectory as the text of a CSV file, and what the judge said of that text."""

    plan: Plan
    csv: str
    report: Report


@dataclass(frozen=True)
class InputFile:
    """A file the run was made from: path as the user gave it, copy: its place in the results folder.

    rapid: the place of its optimised version there, None for a file that is no RAPID module.
    """

    path: str
    copy: str
    content: bytes
    rapid: str | None = None

    @property
    def sha256(self) -> str:
        """Of the exact bytes."""
        return sha256(self.content)


@dataclass(frozen=True)
class Results:
    """A results folder read back. modules and cell are the copies of the run's inputs inside it, in their order.

    entry, assume_identity: as the run was asked for. texts: the three CSV files by name. holds: when the chosen plan
    stands still until a signal comes [s], and for what. rapid: each module's path as the user gave it, the copy of the
    program as it was, and the optimised one. added: the path and the place in the folder of each module that the export
    added. no_rapid: why there is no optimised program. notes: what the program's text changes, and what it could not.
    """

    folder: Path
    target: Target
    modules: tuple[Path, ...]
    cell: Path
    entry: str
    assume_identity: tuple[str, ...]
    texts: Mapping[str, str]
    dropped: Mapping[Target, tuple[int, ...]]
    holds: tuple[tuple[float, str], ...]
    rapid: tuple[tuple[str, Path, Path], ...]
    added: tuple[tuple[str, Path], ...] = ()
    no_rapid: str | None = None
    notes: tuple[str, ...] = ()


def distinct_names(paths: Sequence[str]) -> dict[str, str]:
    """A name for each file inside one folder: its own; where two are the same but for case, with the folders that
    tell them apart."""
    names = {path: Path(path).name for path in paths}
    if len({name.lower() for name in names.values()}) == len(names):
        return names
    real = {path: os.path.realpath(path) for path in paths}
    above = os.path.commonpath([os.path.dirname(place) for place in real.values()])
    return {path: Path(place).relative_to(above).as_posix() for path, place in real.items()}


def motion_label(program: Program, index: int) -> tuple[str, str]:
    """The instruction's name and its target (or signal, condition, duration) of one motion, for tables."""
    motion = program.motions[index]
    match motion:
        case Wait(condition=None):
            return "WaitTime", f"{motion.duration:g} s"
        case Wait():
            return _SIGNAL_WAIT, str(motion.condition)
        case SignalEvent():
            return "Signal", f"{motion.signal} = {motion.value:g}"
    return type(motion).__name__, motion.target


def zones_as_stops(program: Program) -> int:
    """How many fly-by zones the plan takes as stops."""
    return sum(isinstance(motion, Move) and not motion.zone.stop for motion in program.motions)


def summary(
    program: Program,
    target: Target,
    judged: Mapping[Target, Judged],
    warnings: Iterable[str],
    limits: Iterable[str],
    unchecked: Iterable[str],
    notes: Iterable[str] = (),
) -> bytes:
    """summary.json: the answer in numbers, SI, the same bytes for the same inputs.

    limits: how sure they are. unchecked: what the judge was given nothing to hold the motion against. notes: what the
    RAPID text changes, and what it could not.
    """
    return record(
        {
            "target": target.value,
            "plans": {one.value: _plan(program, judged[one]) for one in Target},
            "zones_planned_as_stops": zones_as_stops(program),
            "warnings": list(warnings),
            "limits": list(limits),
            "unchecked": list(unchecked),
            "notes": list(notes),
        }
    )


def _plan(program: Program, judged: Judged) -> dict[str, Any]:
    plan = judged.plan
    motions = []
    for motion in plan.motions:
        instruction, target = motion_label(program, motion.index)
        motions.append(
            {
                "index": motion.index,
                "source": str(motion.source),
                "instruction": instruction,
                "target": target,
                "start_s": motion.t_0,
                "time_s": motion.t_1 - motion.t_0,
                "binding": motion.binding,
                "dropped": motion.dropped,
                "axes_at_end": motion.q_1.tolist(),
            }
        )
    return {
        "cycle_time_s": plan.duration,
        "lower_bound_s": plan.lower_bound,
        "gap": plan.gap,
        "grid": plan.grid,
        "axes": list(plan.trajectory.names),
        "motions": motions,
        "judge": {
            "legal": judged.report.legal,
            "findings": [finding_record(finding) for finding in judged.report.findings],
            "advice": [finding_record(finding) for finding in judged.report.advice],
        },
    }


def run_record(
    options: Mapping[str, Any],
    inputs: Mapping[str, InputFile],
    others: Iterable[InputFile],
    files: Mapping[str, bytes],
    timing: Mapping[str, Any],
    added: Mapping[str, str] | None = None,
    no_rapid: str | None = None,
) -> bytes:
    """run.json: what made this folder. The only file with clock times; files lists all others with their hashes.

    added: the modules that the export added, the path each would have beside the program and its place in the folder.
    no_rapid: why the plan could not be written as RAPID; then there are no such modules.
    inputs: "program" and "cell", the two that verify starts from (of several modules the first).
    """
    every = {one.copy: one for one in (*inputs.values(), *others)}
    return record(
        {
            "trajopt": __version__,
            "format": FORMAT,
            "versions": {"python": platform.python_version(), **{name: version(name) for name in _LIBRARIES}},
            "options": dict(options),
            "inputs": {
                "program": inputs["program"].copy,
                "cell": inputs["cell"].copy,
                "files": [
                    {
                        "path": one.path,
                        "copy": one.copy,
                        "sha256": one.sha256,
                        "rapid": one.rapid if no_rapid is None else None,
                        "module": one.rapid is not None,
                    }
                    for one in every.values()
                ],
            },
            "no_rapid": no_rapid,
            "added": [{"path": path, "rapid": place} for path, place in (added or {}).items()],
            "files": {name: sha256(content) for name, content in sorted(files.items())},
            **timing,
        }
    )


def read_results(folder: Path, judged: bool = False) -> Results:
    """Read a results folder; judged: its CSV files as they stand, for who decides whether they are legal.

    Raises InputError for a folder that is none or is newer, or where any other file was changed since the run.
    """
    plans = (CHOSEN, *CSV.values())
    run = read_plan_record(folder, (SUMMARY, *plans), plans if judged else ())
    digest = parse_record(run.contents[SUMMARY], str(folder / SUMMARY))
    try:
        target = Target(digest["target"])
        rows = {one: digest["plans"][one.value]["motions"] for one in Target}
        dropped = {one: tuple(m["index"] for m in motions if m["dropped"]) for one, motions in rows.items()}
        waits = [m for m in rows[target] if m["instruction"] == _SIGNAL_WAIT]
        holds = tuple((float(m["start_s"] + m["time_s"]), str(m["target"])) for m in waits)
        notes = tuple(str(note) for note in digest.get("notes", ()))
    except (KeyError, TypeError, ValueError) as error:
        raise InputError("is not what trajopt wrote; run trajopt optimize again", file=str(folder / SUMMARY)) from error
    rapid = tuple((one.path, folder / one.copy, folder / one.rapid) for one in run.inputs if one.rapid is not None)
    return Results(
        folder=folder,
        target=target,
        modules=tuple(folder / one.copy for one in run.inputs if one.module),
        cell=folder / run.cell,
        entry=run.entry,
        assume_identity=run.assume_identity,
        texts={name: run.contents[name].decode("ascii", "replace") for name in plans},
        dropped=dropped,
        holds=holds,
        rapid=rapid,
        added=tuple((path, folder / place) for path, place in run.added),
        no_rapid=run.no_rapid,
        notes=notes,
    )
