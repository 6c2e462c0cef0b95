"""`trajopt robot add MODEL.urdf --name NAME`: a URDF becomes a robot's two files, and what was read is told."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from trajopt_cli.cli.options import AsJson, Quiet
from trajopt_cli.cli.process import tidied
from trajopt_cli.errors import InputError, printable

if TYPE_CHECKING:
    from trajopt_cli.adopt.add import NewRobot
    from trajopt_cli.robot.model import RobotModel
    from trajopt_cli.robot.srs import SrsRobot
    from trajopt_cli.table import TextTable

_LENGTHS = {
    "a1": "axis 2 in front of axis 1",
    "a2": "axis 3 above axis 4, upper arm forward",
    "b": "arm's plane left of axis 1",
    "c1": "axis 2 above the base",
    "c2": "axis 2 to axis 3",
    "c3": "axis 3 to the wrist centre, along axis 4; to axis 4 where it is parallel to axis 3",
    "c4": "wrist centre to the flange",
    "wrist along": "axis 6 beside axis 4, along axis 5",
    "wrist across": "axis 6 above axis 4, at right angles to axis 5",
    "axis 5 off axis 4": "axis 5 beside axis 4",
    "wrist along axis 5": "axis 4 to where axes 5 and 6 meet, along axis 5",
    "bs": "base to shoulder",
    "se": "shoulder to elbow",
    "ew": "elbow to wrist centre",
    "wf": "wrist centre to the flange",
}


def add(
    model: Annotated[Path, typer.Argument(metavar="MODEL.urdf", help="The robot's URDF, as its maker or ROS has it.")],
    name: Annotated[str, typer.Option("--name", metavar="NAME", help="What to call it: NAME.urdf and NAME.yaml.")],
    tip: Annotated[
        str | None,
        typer.Option(
            "--tip",
            metavar="LINK",
            help="The flange's link; default: tool0, flange, or the last one.",
            show_default=False,
        ),
    ] = None,
    base: Annotated[
        str | None,
        typer.Option("--base", metavar="LINK", help="The chain's first link; default: the root.", show_default=False),
    ] = None,
    confdata: Annotated[
        Literal["abb_six_axis", "none"] | None,
        typer.Option(
            "--confdata",
            help="What RAPID's confdata means on it; default: ABB's rule if the URDF speaks of ABB, else none.",
            show_default=False,
        ),
    ] = None,
    rail: Annotated[bool, typer.Option("--rail", help="Write NAME_rail too: the same on a linear track.")] = False,
    output: Annotated[Path, typer.Option("--output", metavar="FOLDER", help="Where the two files go.")] = Path("."),
    force: Annotated[
        bool, typer.Option("--force", help="Replace files of that name; the old ones stay as .bak.")
    ] = False,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Make a robot of the URDF of nearly any six-axis arm, alone or on a sliding axis, or of a seven-axis arm with
    spherical shoulder and wrist, as a KUKA LBR iiwa.

    Writes a clean URDF of the chain, and a YAML file with what a URDF cannot say, guessed and marked.

    \b
    Example:
      trajopt robot add welder_arm.urdf --name welder
    """
    from trajopt_cli.adopt.add import new_robot
    from trajopt_cli.cli import console
    from trajopt_cli.robot.model import load_robot
    from trajopt_cli.robot.srs import load_srs
    from trajopt_cli.runs.transaction import replace_files

    made = new_robot(model, name, tip, base, confdata, rail)
    if output.exists() and not output.is_dir():
        raise InputError("is a file; --output names a folder", file=str(output))
    places = {output / file: content for file, content in made.files.items()}
    tidied(places)
    there = [path for path in places if path.exists() or path.is_symlink()]
    if there and not force:
        raise InputError("exists; choose another --name or --output, or --force to replace it", file=str(there[0]))
    for path in there:
        if path.resolve() == model.resolve():
            raise InputError("is the URDF to read; choose another --name or --output", file=str(path))
    old = {path: (path.read_bytes(), places[path]) for path in there}
    kept = replace_files(old, {path: content for path, content in places.items() if path not in old})
    load: Any = load_srs if made.chain.turning == 7 else load_robot
    robot = load(str(output / f"{name}.yaml"))
    files = [str(path) for path in places]
    if as_json:
        console.print_json({"files": files, "kept": [str(path) for path in kept.values()]} | _record(made, robot))
        return
    if quiet:
        console.result(f"written: {', '.join(files)}")
        return
    out = console.stdout()
    for part in _told(made, robot):
        if isinstance(part, str):
            console.tell(out, part.split("\n"))
        else:
            console.show(out, part)
    console.tell(out, [f"written: {', '.join(files)}", *(f"kept: {path}" for path in kept.values())])
    shown = output / f"{name}.yaml"
    console.tell(out, [f"next: trajopt robot show {shown if shown.parent != Path('.') else f'./{shown}'}"])


def _lengths(robot: RobotModel | SrsRobot) -> dict[str, float]:
    from trajopt_cli.robot.srs import SrsRobot

    return asdict(robot.lengths) if isinstance(robot, SrsRobot) else dict(robot.arm.lengths)


def _zero(robot: RobotModel | SrsRobot) -> Any:
    import numpy as np

    return robot.forward(np.zeros(len(robot.axis_names)))


def _record(made: NewRobot, robot: RobotModel | SrsRobot) -> dict[str, Any]:
    """What was read, SI."""

    X = _zero(robot)
    axes = [
        {
            "name": joint.name,
            "in_urdf": made.chain.named[joint.name],
            "lower": joint.lower,
            "upper": joint.upper,
            "velocity": joint.velocity,
        }
        for joint in made.chain.axes
    ]
    return {
        "name": made.name,
        "base": made.chain.base,
        "tip": made.chain.tip,
        "confdata": made.confdata,
        "axes": axes,
        "lengths_m": _lengths(robot),
        "flange_at_zero_m": X[:3, 3].tolist(),
        "flange_z_at_zero": X[:3, 2].tolist(),
        "bodies": {link: len(parts) for link, parts in made.bodies.items()},
        "self_pairs": [list(pair) for pair in made.pairs],
        "meshes_missing": list(made.missing),
        "notes": list(made.chain.notes),
    }


def _told(made: NewRobot, robot: RobotModel | SrsRobot) -> Iterator[TextTable | str]:
    from trajopt_cli.table import TextTable
    from trajopt_cli.units import DEG, MM

    chain = made.chain
    yield f"{made.name}: from {chain.base} to {chain.tip} of {chain.tree.path}\n"
    rows = []
    for joint in chain.axes:
        factor, unit = (MM, "mm") if joint.kind == "prismatic" else (DEG, "deg")
        figures = [f"{value / factor:.6g}" for value in (joint.lower, joint.upper, joint.velocity)]
        rows.append((joint.name, chain.named[joint.name], *figures[:2], unit, figures[2], f"{unit}/s"))
    yield TextTable("axes", ("axis", "in the URDF", ">from", ">to", "unit", ">speed", "unit"), tuple(rows))
    lengths = ((what, f"{value / MM:.6g}", _LENGTHS[what]) for what, value in _lengths(robot).items())
    yield TextTable("dimensions", ("length", ">mm", "what it is"), tuple(lengths))
    six = made.chain.turning == 6
    if not getattr(robot, "closed_form", True):
        yield "axes 4, 5 and 6 do not meet in one point: configurations are sought step by step, so planning takes"
        yield "minutes, and no nonlinear program improves the plan\n"
    X = _zero(robot)
    place, out, ahead = (
        " ".join(f"{v + 0.0:.6g}" for v in row) for row in (_row(X[:3, 3]) / MM, _row(X[:3, 2]), _row(X[:3, 0]))
    )
    yield f"with all axes at 0 the flange is at {place} mm, its z along {out}, its x along {ahead}: hold that against"
    yield "the robot or its data sheet\n"
    if six:
        yield f"confdata: {made.confdata}" + (
            ", so the confdata of targets is not looked at"
            if made.confdata == "none"
            else "; --confdata none where it is not ABB's"
        )
    yield f"bodies: {', '.join(made.bodies) or 'none, so self-collision and obstacles are not looked at'}"
    if made.bodies and (bare := [name for name in robot.link_names if name not in made.bodies]):
        yield f"no bodies: {', '.join(bare)}, which may touch anything unseen"
    for line in (*made.missing, *chain.notes):
        yield f"note: {printable(line)}"
    guesses = "accelerations, jerks" + (", tcp caps" if six else "")
    yield f"guessed, marked REPLACE in {made.name}.yaml: {guesses}"


def _row(values: Any) -> Any:
    import numpy as np

    return np.where(np.abs(values) < 1e-9, 0.0, values)
