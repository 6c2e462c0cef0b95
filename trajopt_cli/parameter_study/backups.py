"""Every program below a folder, each optimised in a process of its own: what `trajopt batch` does.

And one point of a study, planned the same way: `trajopt study plan`.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, as_completed
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from trajopt_cli import __version__
from trajopt_cli.adopt.backup import cell_from_backup
from trajopt_cli.cell.loader import load_cell
from trajopt_cli.errors import InputError, printable
from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.job import cell_path_for
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.tables import head, linked, points
from trajopt_cli.parameter_study.cell_keys import put
from trajopt_cli.parameter_study.point import cell_data, job_at, without_root
from trajopt_cli.parameter_study.study_file import Study
from trajopt_cli.rapid.language.text import read_text
from trajopt_cli.rapid.program_list import read_list
from trajopt_cli.rapid.sources import LIST_SUFFIX, MAX_ENTRIES, is_module, modules_at, syspar_of
from trajopt_cli.robot.model import load_robot
from trajopt_cli.runs import REPORT, RUN
from trajopt_cli.runs.files import write_file
from trajopt_cli.runs.record import as_json, parse_record
from trajopt_cli.runs.transaction import write_files
from trajopt_cli.table import TextTable, percent, seconds, tabulate

RECORD, INDEX, CELLS = "batch.json", "index.html", "cells"
"""Of a batch's folder: every row, the page of them, the cell files made of backups."""
PLANS = "plans"
"""Of a study's results folder: the results folders of points, by their numbers."""
_MAIN = re.compile(r"(?:\A|[\r\n;])\s*(LOCAL\s+)?PROC\s+main\s*\(", re.IGNORECASE)
_NOISE = ("home", "syspar", "backinfo")  # of a backup
Row = Mapping[str, Any]
_COLUMNS: dict[str, Callable[[Row], str]] = {
    "~program": lambda row: str(row["program"]),
    ">as written [s]": lambda row: seconds(row["as_written_s"]),
    ">rapid [s]": lambda row: seconds(row["rapid_s"], row["status"]),
    ">saves [s]": lambda row: seconds(row["saved_s"]),
    ">of it": lambda row: percent(row["saved"]),
    ">stream [s]": lambda row: seconds(row["stream_s"]),
}


@dataclass(frozen=True)
class BatchProgram:
    """A program below the folder. name: of its results, unlike all others. paths: what optimize is given. cell: where
    its cell file stands, or would be made. why_not: what keeps it from being tried."""

    name: str
    paths: tuple[Path, ...]
    cell: Path
    why_not: str = ""


def programs_below(folder: Path, output: Path) -> tuple[list[BatchProgram], list[str]]:
    """The programs below a folder in the order of their paths, and what is left out, in words.

    A folder with RAPID or PROGMOD in it is one program, of several tasks with a PROC main one each. Elsewhere a program
    list is one, and so is each module with a PROC main; where only one of a folder has it, the others belong to it.
    Hidden folders, links and folders that trajopt wrote are not entered. Raises InputError where folder is none.
    """
    if not folder.is_dir():
        raise InputError("is no folder; give the one that the programs or backups lie in", file=str(folder))
    places, left, waiting, count = list[tuple[Path, ...]](), list[str](), [folder], 0
    while waiting:
        here = waiting.pop()
        entries = sorted(one for one in here.iterdir() if not one.name.startswith(".") and not one.is_symlink())
        count += len(entries)
        if count > MAX_ENTRIES:
            raise InputError(f"holds more than {MAX_ENTRIES} files and folders; give a smaller one", file=str(folder))
        folders = {one.name.lower(): one for one in entries if one.is_dir()}
        if "rapid" in folders or "progmod" in folders:
            inside = folders.get("rapid", here).iterdir()
            tasks = [one for one in inside if one.is_dir() and _has_main(modules_at([one]))]
            places += [(one,) for one in tasks] if "rapid" in folders and len(tasks) > 1 else [(here,)]
            continue
        kept = [one for name, one in folders.items() if name not in _NOISE]
        waiting += [one for one in kept if not (one / RUN).exists() and not (one / RECORD).exists()]
        places += _loose([one for one in entries if one.is_file()], left)
    names = {CELLS}
    return [_named(folder, paths, output, names) for paths in sorted(places)], left


def _loose(files: Sequence[Path], left: list[str]) -> Iterator[tuple[Path, ...]]:
    """The programs among the files of one folder. left: is told which modules belong to none."""
    lists = [one for one in files if one.suffix.lower() == LIST_SUFFIX]
    listed = set[str]()
    for one in lists:
        with suppress(InputError):  # said where the program is read
            listed |= {name.lower() for name, _ in read_list(one)}
        yield (one,)
    modules = [one for one in files if is_module(one) and one.name.lower() not in listed]
    mains = [one for one in modules if _has_main([one])]
    rest = [one for one in modules if one not in mains]
    if len(mains) == 1 and not lists:
        yield (*mains, *rest)
        return
    yield from ((one,) for one in mains)
    left += [f"{one}: not tried, it holds no PROC main" for one in rest]


def _has_main(modules: Iterable[Path]) -> bool:
    for one in modules:
        with suppress(InputError):  # said where the program is read
            if is_module(one) and _MAIN.search(read_text(one).text):
                return True
    return False


def _named(folder: Path, paths: tuple[Path, ...], output: Path, names: set[str]) -> BatchProgram:
    """A program with a name that is not among names, and its cell file: beside it, or made of its backup."""
    own = paths[0].with_suffix("") if paths[0].is_file() else paths[0]
    name = base = re.sub(r"[^\w.-]+", "_", "_".join(own.relative_to(folder).parts) or folder.resolve().name)
    i = 1
    while name.lower() in names:
        name, i = f"{base}_{i + 1}", i + 1
    names.add(name.lower())
    made = output / CELLS / f"{name}.yaml"
    try:
        beside = cell_path_for(paths)
    except InputError as error:
        return BatchProgram(name, paths, made, str(error))
    places = [beside, paths[0].parent / "cell.yaml"] if paths[0].is_file() else [beside]
    there = next((one for one in places if one.exists()), None)
    if there is None and syspar_of(paths[0]) is None:
        why = f"{paths[0]}: has no cell file {beside}, and no backup's MOC.cfg to make one of"
        return BatchProgram(name, paths, beside, why)
    return BatchProgram(name, paths, there or made)


def batch(
    programs: Sequence[BatchProgram],
    output: Path,
    executor: Executor,
    options: Sequence[str] = (),
    jobs: int = 1,
    tell: Callable[[Row, int], None] = lambda row, left: None,
) -> list[Row]:
    """A row for every program, in their order: from a process of its own, or as batch.json in output has it of the same
    inputs. batch.json and the page are written anew behind every program.

    executor: of concurrent.futures, or a cluster's. options: of trajopt optimize, besides. jobs: worker processes of
    each program. tell: hears each new row and how many are left. Raises InputError where output holds something else.
    """
    known, rows, waiting = _known(output), dict[str, Row](), {}
    for one in programs:
        made = one.cell.parent == output / CELLS
        row: dict[str, Any] = {"program": one.name, "paths": [*map(str, one.paths)], "cell": str(one.cell)}
        try:
            if one.why_not:
                raise InputError(one.why_not)
            if made and not one.cell.exists():  # a cell file that the user has corrected stays
                write_file(one.cell, cell_from_backup(one.paths[0], one.cell, None)[0].encode())
        except InputError as error:
            rows[one.name] = {**row, **failed_row(str(error))}
            continue
        row |= {"cell_made": made, "inputs": _digest(one, options)}
        if known.get(one.name, row).get("inputs") == row["inputs"] and (output / one.name / RUN).is_file():
            rows[one.name] = known[one.name]
            continue
        words = ["optimize", *row["paths"], "--cell", row["cell"], "--output", str(output / one.name)]
        words += ["--json", "--jobs", str(jobs), *options]
        waiting[executor.submit(run_command, words, str(Path.cwd()))] = one.name, row
    _write(output, programs, rows)
    try:
        for left, done in enumerate(as_completed(waiting), 1 - len(waiting)):
            name, row = waiting[done]
            rows[name] = {**row, **outcome(*done.result())}
            _write(output, programs, rows)
            tell(rows[name], -left)
    except BaseException:  # Ctrl-C: what runs here is ended, and its folder appears whole or not
        for future in waiting:
            future.cancel()
        for process in tuple(_running):
            process.terminate()
        raise
    return [rows[one.name] for one in programs]


_running = set[subprocess.Popen[str]]()


def run_command(words: Sequence[str], folder: str) -> tuple[int, str, str]:
    """Run trajopt in a process of its own, in a folder; its exit code, stdout and stderr. Ctrl-C does not reach it."""
    if not Path(folder).is_dir():
        return 2, "", f"{folder}: this worker does not see the folder; batch needs one that all workers share"
    command, pipe = [sys.executable, "-m", "trajopt_cli.cli", *words], subprocess.PIPE
    with subprocess.Popen(
        command, cwd=folder, text=True, start_new_session=True, stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe
    ) as process:
        _running.add(process)
        try:
            out, err = process.communicate()
        finally:
            _running.discard(process)
    return process.returncode, out, err


def outcome(code: int, out: str, err: str) -> dict[str, Any]:
    """What a run of `optimize --json` came to: status, times [s], and why it failed, in one line."""
    if code < 0:
        return failed_row(f"ended by signal {-code}")
    record = parse_record(out.encode(), "optimize --json") if out.strip() else {}
    if code:
        lines = record.get("why") or err.strip().splitlines() or [f"exit code {code}"]
        return failed_row(lines[0].removesuffix(":"))
    written = record["as_written"]
    before = written["cycle_time_s"]
    rapid, stream = (record["plans"][one]["cycle_time_s"] for one in ("rapid", "stream"))
    saved = None if before is None else before - rapid
    times = {"as_written_s": before, "rapid_s": rapid, "stream_s": stream, "saved_s": saved}
    why = f"no RAPID text: {record['no_rapid']}" if record["no_rapid"] else ""
    why = why or (f"as written: {written['why_not']}" if before is None else "")
    return {"status": "ok", **times, "saved": saved / before if saved is not None and before else None, "reason": why}


def failed_row(why: str) -> dict[str, Any]:
    """Status, times and reason of a program without an answer."""
    none = dict.fromkeys(("as_written_s", "rapid_s", "stream_s", "saved_s", "saved"))
    return {"status": "failed", **none, "reason": printable(why)}


def failed(rows: Sequence[Row]) -> list[Row]:
    """The rows without an answer."""
    return [row for row in rows if row["status"] != "ok"]


def remarks(rows: Sequence[Row]) -> list[str]:
    """A line on each program that has a reason, and on the cell files that were made of backups."""
    names = ", ".join(f"{row['program']}.yaml" for row in rows if row.get("cell_made"))
    made = [f"made of MOC.cfg, check every line: {CELLS}/ {names}"] if names else []
    return [*(f"{row['program']}: {row['reason']}" for row in rows if row["reason"]), *made]


def batch_line(rows: Sequence[Row]) -> str:
    """How many were done, and what that saves."""
    shares = [row["saved"] for row in rows if row["saved"] is not None]
    said = f"; RAPID plans save {percent(median(shares))} (median), {percent(max(shares))} at most" if shares else ""
    return f"{len(rows) - len(failed(rows))} of {len(rows)} programs optimised, {len(failed(rows))} failed{said}"


def batch_table(title: str, rows: Sequence[Row]) -> TextTable:
    """A row per program."""
    return tabulate(title, rows, _COLUMNS)


def batch_page(rows: Sequence[Row]) -> bytes:
    """The page of all programs, the largest saving first, with a link to each one's own."""
    done = sorted((row for row in rows if row["status"] == "ok"), key=lambda row: -(row["saved"] or 0.0))
    made = linked(batch_table("Programs that are optimised", done), f'<a href="{{0}}/{REPORT}">{{0}}</a>')
    lead = "The largest saving first. A name leads to its own page."
    sections = [Section("programs", "Programs", made + points(remarks(done)), lead)]
    if bad := failed(rows):
        why = "Called again, these alone are tried again."
        sections.append(Section("failed", "Failed", points(remarks(bad)), why))
    top = head("All programs", f"trajopt batch · {batch_line(rows)}", [])
    return document("All programs · trajopt", top, sections, {}, ())


def _digest(one: BatchProgram, options: Sequence[str]) -> str:
    """Of all that the answer depends on: version, options, and every file's path and bytes."""
    files = [*modules_at(one.paths), one.cell]
    with suppress(InputError):  # an answer by itself, from the files above
        cell = load_cell(one.cell)
        files += [*cell.mesh_files, *cell.robot_files()]
        files += cell.robot_files(load_robot(cell.robot).files)
    made = sha256(json.dumps([__version__, *options]).encode())
    for path in dict.fromkeys(files):
        made.update(f"\0{path}\0".encode(errors="surrogateescape"))
        made.update(path.read_bytes() if path.is_file() else b"")
    return made.hexdigest()


def _known(output: Path) -> dict[str, Row]:
    """The rows of the batch that output holds and that have an answer, by program."""
    record = output / RECORD
    if not output.exists() or not any(output.iterdir()):
        return {}
    if not record.is_file():
        raise InputError(f"is not empty and holds no {RECORD}; choose another folder by --output", file=str(output))
    try:
        rows = parse_record(record.read_bytes(), str(record))["programs"]
        return {row["program"]: row for row in rows if row["status"] == "ok"}
    except (KeyError, TypeError) as error:
        raise InputError("was not written by trajopt batch; move it away", file=str(record)) from error


def _write(output: Path, programs: Sequence[BatchProgram], rows: Mapping[str, Row]) -> None:
    there = [rows[one.name] for one in programs if one.name in rows]
    write_file(output / RECORD, as_json({"trajopt": __version__, "programs": there}))
    write_file(output / INDEX, batch_page(there))


def keep_plan(study: Study, index: int, folder: Path, options: Sequence[str] = ()) -> dict[str, Any]:
    """Write a point's program and cell out as files, and have trajopt optimize plan them in a process of its own.

    folder: of the study's results; the plan's is PLANS/index in it. options: of optimize, besides. Gives status, times
    [s] and the reason of a failure as a row of a batch has them. Raises InputError for a point that the study does not
    have.
    """
    if not 0 <= index < len(study.design):
        raise InputError(f"has no point {index}, but 0 to {len(study.design) - 1}", file=str(study.path))
    inputs, point = study.inputs, study.design.point(index)
    try:
        job = job_at(inputs, point)
    except InputError as error:
        return failed_row(without_root(inputs, str(error)))
    data = cell_data(inputs, dict(zip(inputs.keys, point.values, strict=True)))
    if any(key.startswith(("place.base.", "place.rail.")) for key in inputs.keys):
        rail = job.cell.rail
        X = job.cell.X_WB if rail is None else rail.X_WR
        frame = {"position": X[:3, 3].tolist(), "wxyz": wxyz_from_rotation(X[:3, :3]).tolist()}
        put(data, "base" if rail is None else "rail.frame", frame)
    texts = {Path(one.path).name: one.text.encode(one.encoding) for one in job.program.files.values()}
    with TemporaryDirectory(prefix="trajopt-plan-") as place:
        cell = json.dumps(data, indent=1).encode()  # which YAML reads, too
        write_files(Path(place), {**inputs.beside, **texts, inputs.cell_file: cell})
        out = folder.resolve() / PLANS / str(index)
        words = ["optimize", *texts, "--cell", inputs.cell_file, "--entry", inputs.entry]
        return outcome(*run_command([*words, "--output", str(out), "--json", *options], place))
