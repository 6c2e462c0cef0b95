"""A plan as files for the machine that executes it."""

from __future__ import annotations

from typing import Literal

from trajopt_cli.exporters.faster import faster_than_programmed
from trajopt_cli.exporters.joint import resample
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.motion import Program
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scenario import Scenario

JOINTS = "joints.csv"


def export(
    plan: Plan,
    kind: Literal["joint", "rapid"] = "joint",
    *,
    rate: float = 1000.0,
    program: Program | None = None,
    plant: Plant | None = None,
    scenario: Scenario | None = None,
) -> dict[str, bytes]:
    """A plan's files, content by name, for a machine that follows a joint stream or for the RAPID controller.

    joint: joints.csv, rows at rate [Hz] and the exact end as last row; given a plant, axes that follow too. rapid: the
    modules of program, by the path they were read from and in their own encoding, with the plan in them; needs the
    program and the plant that the plan was made for, and the scenario the program was read with.

    Raises InputError for a rate outside (0, 1e5] Hz and for what cannot be written as RAPID, with its place; ValueError
    for a kind that there is not, a plan of the other target, or a missing program or plant.
    """
    if kind == "joint":
        rows = plan.trajectory if plant is None else plant.with_followers(plan.trajectory)
        return {JOINTS: write_csv_text(resample(rows, rate)).encode("ascii")}
    if kind != "rapid":
        raise ValueError(f"no export is called {kind!r}: joint or rapid")
    if program is None or plant is None:
        raise ValueError("the RAPID export needs program and plant, as the plan was made for them")
    faster = faster_than_programmed(program, plan, plant)
    written = export_rapid(program, plan, plant, faster, scenario)
    return {path: text.encode(program.files[path].encoding) for path, text in written.texts.items()}
