"""A plan as pictures: the figures of Krotký 2014, chapters 4 to 6, for any program, robot and target."""

from __future__ import annotations

from collections.abc import Callable

from matplotlib.figure import Figure

from trajopt_cli.motion import Program
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report import arm, in_space, over_time, steps
from trajopt_cli.report.bars import Bar, comparison, savings
from trajopt_cli.report.stepwise import Analysis
from trajopt_cli.report.style import files, house_style
from trajopt_cli.trajectories.plan_series import PlanSeries, follow

__all__ = ["PICTURES", "Bar", "comparison", "draw", "savings", "stepwise"]

# File name without ending -> the figure, or None where the plan has nothing to show there.
PICTURES: dict[str, Callable[[PlanSeries], Figure | None]] = {
    "joints": over_time.joints,
    "rail": over_time.rail,
    "tcp_speed": over_time.tcp_speed,
    "path": in_space.path,
    "workspace": in_space.workspace,
    "effector": over_time.effector,
    "arm": arm.arm,
}
# The same for a program in steps of speed.
STEP_PICTURES: dict[str, Callable[[steps.Steps], Figure]] = {"steps_speed": steps.speed, "steps_path": steps.path}


def draw(program: Program, plant: Plant, plan: Plan, title: str) -> dict[str, bytes]:
    """All pictures of a plan: file name -> contents, each picture as .svg and as .png. Without a rail no rail picture.

    title: the program's name for people; target and cycle time are added to it. The same input gives the same bytes.
    Raises ValueError for a trajectory without speeds.
    """
    out: dict[str, bytes] = {}
    with house_style():
        series = follow(program, plant, plan, title)
        for name, picture in PICTURES.items():
            figure = picture(series)
            if figure is not None:
                out |= files(name, figure, f"{title}: {name.replace('_', ' ')}")
    return out


def stepwise(program: Program, plant: Plant, analysis: Analysis, title: str) -> dict[str, bytes]:
    """Pictures of a program as written, in steps of speed: steps_speed and steps_path, each as .svg and as .png.

    analysis: of this program. title: the program's name for people; its times are added to it. A program without moves
    gives no pictures; the same input gives the same bytes.
    """
    out: dict[str, bytes] = {}
    if analysis.moves:
        with house_style():
            shown = steps.steps_of(program, plant, analysis, title)
            for name, picture in STEP_PICTURES.items():
                out |= files(name, picture(shown), f"{title}: {name.replace('_', ' ')}")
    return out
