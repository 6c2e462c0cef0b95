"""`trajopt parse PROGRAM`: the flat motions, each with its place."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from trajopt_cli.cli.options import AsJson, AssumeIdentity, CellPath, Entry, ProgramPaths, Quiet
from trajopt_cli.cli.process import reading
from trajopt_cli.warnings import ProgramWarning, WarningKind

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from trajopt_cli.cell.model import Cell
    from trajopt_cli.errors import InputError
    from trajopt_cli.motion import Program
    from trajopt_cli.problem.configurations import ConfigurationFinding
    from trajopt_cli.problem.plant import Plant
    from trajopt_cli.rapid.listing import Listing, Row
    from trajopt_cli.scenario import Missing

_SHOWN = 20  # configuration findings in text; --json has them all
_COMPLETE = "nothing is missing: the program runs with this cell file"
_TARGET = 44  # characters of one in a sentence
_UNCALLED = 10  # routines that did not run


def parse(
    program: ProgramPaths,
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    as_json: AsJson = False,
    scenario_template: Annotated[
        bool,
        typer.Option(
            "--scenario-template", help="Print what the cell file must still say about signals, answers, ... and stop."
        ),
    ] = False,
    quiet: Quiet = False,
) -> None:
    """Run PROGRAM on paper and print its motions in order, each with file and line, in the units of RAPID.

    Needs no cell file; where there is one, its scenario is used, and confdata is held against its robot.

    \b
    Example:
      trajopt parse programs/hinge_cell.mod
      trajopt parse programs/bench_irb140.mod --scenario-template
    """
    from trajopt_cli.errors import InputError
    from trajopt_cli.job import MAIN, cell_for, from_backup, scenario_of
    from trajopt_cli.rapid.listing import describe
    from trajopt_cli.rapid.missing_modules import with_hints
    from trajopt_cli.rapid.reader import try_paths
    from trajopt_cli.scenario import missing_error

    loaded = cell_for(program, cell)
    plant = None if loaded is None else _plant(loaded)
    kinematics = None
    if plant is not None:
        from trajopt_cli.problem.programmed import PlantKinematics

        kinematics = PlantKinematics(plant)
    try:
        with reading(program):
            flat, missing = try_paths(program, scenario_of(loaded, assume_identity or ()), entry or MAIN, kinematics)
    except InputError as error:
        missing = _missing_of(error)
        if not missing:
            raise
        if not scenario_template:
            raise _with_template(error, program) from error
    if scenario_template:
        from trajopt_cli.rapid.template import template

        typer.echo(template(missing) if missing else _COMPLETE, nl=not missing, err=not missing)
        return
    if missing:
        raise _with_template(with_hints(missing_error(missing), [*flat.files.values()], entry or MAIN), program)
    if plant is not None:
        from trajopt_cli.problem.configurations import at_cycle

        plant = at_cycle(flat, plant)
        kinematics = PlantKinematics(plant)
    listing = describe(flat, kinematics)
    found = None
    if plant is not None:
        from trajopt_cli.problem.configurations import check_configurations
        from trajopt_cli.problem.controller import differences
        from trajopt_cli.problem.plannable import target_doubts
        from trajopt_cli.problem.plant import unwatched

        found = check_configurations(flat, plant)
        doubts = [ProgramWarning(WarningKind.DOUBTFUL, text) for text in target_doubts(flat, plant)]
        assert loaded is not None
        doubts += differences(program, loaded, plant, flat.files)
        told = (*unwatched(loaded, plant.robot), *flat.warnings, *loaded.doubts, *doubts)
        flat = replace(flat, warnings=told)
    notes = [*notes_on(flat, listing, plant)]
    if loaded is None and (command := from_backup(program)):
        notes.append(f"the backup's SYSPAR is not read: {command} makes a cell file of its MOC.cfg")
    if as_json:
        from trajopt_cli.cli.listing_record import json_text, listing_record

        typer.echo(json_text(listing_record(flat, listing, found, notes)))
        return
    from trajopt_cli.cli.listing import listing_lines, terminal_width
    from trajopt_cli.cli.remarks import remarks, told_first
    from trajopt_cli.table import by_name

    files = [*flat.files, *([] if loaded is None else [loaded.file])]
    head, said = told_first(flat.warnings)
    warnings = [*remarks("warning", said, files, "--json lists them all")]
    if quiet:
        typer.echo(", ".join(_sums(listing)))
        for line in (*head, *warnings):
            typer.echo(line, err=True)
        return
    title = " ".join(str(path) for path in program)
    lines = [*head, *listing_lines(title, listing, terminal_width()), "", *_sums(listing)]
    lines += [by_name(note, files) for note in notes]
    lines += warnings
    if any(row.conf is not None for row in listing.rows):
        lines += [by_name(line, files) for line in _configurations(found, plant)]
    typer.echo("\n".join(lines))


def _plant(cell: Cell) -> Plant:
    """The cell's robot without the bodies around it: nothing is planned here, and their meshes take time to load."""
    from trajopt_cli.problem.plant import build_plant

    return build_plant(replace(cell, obstacles=(), attached=(), may_touch=(), grips=()))


def _missing_of(error: BaseException | None) -> tuple[Missing, ...]:
    """What the run lacked that ended with an error; the error may have been given hints since."""
    from trajopt_cli.scenario import MissingError

    while error is not None and not isinstance(error, MissingError):
        error = error.__cause__
    return error.missing if error is not None else ()


def _with_template(error: InputError, paths: Sequence[Path]) -> InputError:
    """The error of a program whose world is not told, with the way to the lines that tell it."""
    from trajopt_cli.errors import InputError, InputErrorGroup

    errors = error.errors if isinstance(error, InputErrorGroup) else (error,)
    command = f"trajopt parse {' '.join(str(path) for path in paths)} --scenario-template"
    return InputErrorGroup([*errors, InputError(f"'{command}' prints the lines missing from the cell file")])


def _sums(listing: Listing) -> Iterator[str]:
    count = len(listing.rows)
    parts = [f"{count} motion{'s' * (count != 1)}, {listing.line_length:.1f} mm of lines"]
    if any(row.kind == "MoveC" for row in listing.rows):
        parts.append(f"{listing.arc_length:.1f} mm of arcs")
    unknown = f", {listing.unmeasured} without" if listing.unmeasured else ""
    yield f"{' and '.join(parts)} with a known start{unknown}"


def notes_on(flat: Program, listing: Listing, plant: Plant | None) -> Iterator[str]:
    """What a reader of the table should know: what has no effect, and what becomes of it in a plan."""
    from collections import Counter

    from trajopt_cli.motion import Move
    from trajopt_cli.rapid.entry import moves_nothing

    if not any(isinstance(motion, Move) for motion in flat.motions):
        yield moves_nothing(flat)
    if flat.uncalled:
        more = f" and {len(flat.uncalled) - _UNCALLED} more" if len(flat.uncalled) > _UNCALLED else ""
        yield f"not run: {', '.join(flat.uncalled[:_UNCALLED])}{more} (names in them are not checked)"
    yield from flat.without_effect
    if listing.fly_by:
        yield f"{listing.fly_by} fly-by zone{'s' * (listing.fly_by > 1)}, planned as corners where the point is passed"
    yield from _stopped(listing)
    first = {one.kind: one for one in reversed(flat.refusals)}
    for one in reversed(first.values()):
        others = sum(other.kind == one.kind for other in flat.refusals) - 1
        yield f"{one.source}: {one.message}{f' ({others} more)' if others else ''}"
    if plant is None:
        return
    from trajopt_cli.problem.configurations import unsure_nearest
    from trajopt_cli.problem.plannable import planned_otherwise, refusals
    from trajopt_cli.rapid.execution.rail import held_by_default

    if plant.rail_eaxes and (held := held_by_default(flat)):
        yield held
    yield from planned_otherwise(flat)
    yield from unsure_nearest(flat, plant)
    if refused := Counter(one.kind for one in refusals(flat, plant)):
        yield f"optimize will refuse this program: {', '.join(f'{kind} {count}' for kind, count in refused.items())}"


def _stopped(listing: Listing) -> Iterator[str]:
    """Fly-by points that are stops all the same: the first one of each reason, and how many more there are."""
    from trajopt_cli.cli.listing import shortened

    found: dict[str, list[Row]] = {}
    for row in listing.rows:
        if row.stop_reason is not None:
            found.setdefault(row.stop_reason, []).append(row)
    for reason, (row, *others) in found.items():
        target = shortened(row.target or "", _TARGET)
        more = f" ({len(others)} more)" if others else ""
        yield f"{row.source}: {row.zone} at {target} is a stop: {reason}{more}"


def _configurations(found: Sequence[ConfigurationFinding] | None, plant: Plant | None) -> Iterator[str]:
    """What is wrong with confdata, each statement once per trouble."""
    if found is None or plant is None:
        yield "configurations not checked: no cell file"
        return
    from trajopt_cli.robot.structure import NO_CONFDATA

    yield from plant.angle_unchecked
    unruled = plant.robot.confdata_rule == NO_CONFDATA
    blind = f" (confdata is not looked at: robot {plant.robot.name} has no rule for it)" if unruled else ""
    if not found:
        yield f"configurations: every point and line fits the robot{blind}"
        return
    first: dict[tuple[object, object], list[ConfigurationFinding]] = {}
    for one in found:
        first.setdefault((one.source, one.misfit), []).append(one)
    count = f"{len(found)} motions do" if len(found) > 1 else "1 motion does"
    yield f"configurations: {count} not fit the robot{blind}"
    for group in list(first.values())[:_SHOWN]:
        again = f" (and {len(group) - 1} more passes)" if len(group) > 1 else ""
        yield f"  {group[0].source}: {group[0].message}{again}"
    if len(first) > _SHOWN:
        yield f"  and {len(first) - _SHOWN} more; --json lists them all"
