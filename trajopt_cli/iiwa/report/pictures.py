"""Pictures of the compliant controller: the figures of Číhala 2020, chapter 6, for any run, robot and task.

Every function gives file name -> contents, each picture as .svg and as .png; the same input gives the same bytes. Data
are SI; pictures show mm, deg, N, Nm and s. Runs are Following; shapes that do not fit raise ValueError.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.iiwa.report import arm as space_of_arm
from trajopt_cli.iiwa.report import arm_angle, charts, follow, forces
from trajopt_cli.iiwa.report.arm_angle import ArmAngleSeries
from trajopt_cli.iiwa.report.pareto import front_figure
from trajopt_cli.iiwa.report.runs import Following
from trajopt_cli.iiwa.task.arm_map import ArmMap
from trajopt_cli.limits import JointLimits
from trajopt_cli.report.style import files, house_style
from trajopt_cli.shapes import Box, Capsule

__all__ = [
    "ArmAngleSeries",
    "Following",
    "arm",
    "arm_angle_map",
    "contact",
    "dosing",
    "family",
    "following",
    "guided",
    "joints",
    "loop_time",
    "stability",
    "steps",
    "table_bars",
    "zeroing",
]


def following(run: Following, title: str) -> dict[str, bytes]:
    """A run over time with its deviation (following), and in space (path)."""
    with house_style():
        return files("following", follow.following_figure(run, title), title) | files(
            "path", follow.path_figure(run, title), f"{title}: path"
        )


def family(runs: Sequence[Following], parameter: str, name: str, title: str) -> dict[str, bytes]:
    """Runs along one path with another value of a parameter each: name_deviation and name_path. Graf 6.11 to 6.16.

    parameter: heads the legend, like "speed v [m/s]"; the runs' labels are its values.
    """
    with house_style():
        return files(f"{name}_deviation", follow.family_figure(runs, parameter, title), f"{title}: deviation") | files(
            f"{name}_path", follow.family_path_figure(runs, parameter, title), f"{title}: path"
        )


def dosing(undosed: Following, others: Sequence[Following], bound: float, title: str) -> dict[str, bytes]:
    """Deviation and fed speed of an undosed run beside others, against a bound [m]: dosing and dosing_path."""
    with house_style():
        return files("dosing", follow.dosing_figure(undosed, others, bound, title), title) | files(
            "dosing_path", follow.dosing_path_figure(undosed, others, title), f"{title}: path"
        )


def arm(
    run: Following, moments: Sequence[tuple[str, Sequence[Capsule]]], obstacles: Sequence[Box], title: str
) -> dict[str, bytes]:
    """The arm's links in the world at one to three moments (name, capsules), obstacles, both paths in space: arm."""
    with house_style():
        return files("arm", space_of_arm.arm_figure(run, moments, obstacles, title), title)


def front(
    leads: Sequence[float],
    curves: Mapping[str, Sequence[float | None]],
    chosen: tuple[float, float],
    unit: tuple[float, str],
    programmed: float,
    title: str,
) -> dict[str, bytes]:
    """Least time of every feed by the lead that is allowed, as front.front_figure: dosing_front."""
    with house_style():
        figure = front_figure(leads, curves, chosen, unit, programmed, title)
        return files("dosing_front", figure, f"{title}: front")


def contact(run: Following, depth: ArrayLike, axis: int, title: str) -> dict[str, bytes]:
    """A collision along axis 0, 1 or 2, contact where depth (n,) [m] is over 0: contact. Graf 6.18. Needs force."""
    with house_style():
        return files("contact", forces.contact_figure(run, depth, axis, title), title)


def steps(
    panels: Sequence[tuple[str, Following]], coordinates: Sequence[int], name: str, title: str
) -> dict[str, bytes]:
    """Forces above, the controller's answer below, a column per (label, run): name. Graf 6.2, 6.4, 6.6 and 6.7.

    coordinates: which of x, y, z, α, β, γ (0 to 5) are shown. Needs forces.
    """
    with house_style():
        return files(name, forces.steps_figure(panels, coordinates, title), title)


def guided(run: Following, phases: Sequence[tuple[str, float, float]], name: str, title: str) -> dict[str, bytes]:
    """Forces of a hand and the path it leads along, in the colours of phases (label, from, to [s]): name. Graf 6.8."""
    with house_style():
        return files(name, forces.guided_figure(run, phases, title), title)


def zeroing(
    run: Following, force_before: ArrayLike, force_after: ArrayLike, axis_free: ArrayLike, title: str
) -> dict[str, bytes]:
    """Forces (n, 6) before and after zeroing, and the path along the axis (3,) that is left free: zeroing. Graf 6.9."""
    with house_style():
        return files("zeroing", forces.zeroing_figure(run, force_before, force_after, axis_free, title), title)


def stability(
    k: ArrayLike,
    d: ArrayLike,
    verdict: ArrayLike,
    m: float,
    h: float,
    points: Sequence[tuple[str, float, float]],
    title: str,
) -> dict[str, bytes]:
    """Map of verdicts (a, b) over stiffness k (a,) [N/m] and damping d (b,) [N s/m] for m [kg], h [s]. Graf 6.10.

    verdict: 0 unstable, 1 marginal, 2 stable; k and d grow and may begin with 0. points: (name, k, d) to be marked.
    """
    with house_style():
        return files("stability", charts.stability_figure(k, d, verdict, m, h, points, title), title)


def table_bars(
    rows: Sequence[tuple[str, float, float]],
    quantity: str,
    unit: str,
    name: str,
    title: str,
    names: tuple[str, str] = ("thesis", "ours"),
) -> dict[str, bytes]:
    """The thesis' number beside ours: name. rows: (label, thesis, ours) in SI; unit: mm, deg, m, N, Nm, s, ms or µs.

    names: what the legend calls both.
    """
    with house_style():
        return files(name, charts.table_figure(rows, quantity, unit, title, names), title)


def loop_time(
    parts: Sequence[tuple[str, float, float, float]], thesis_worst: float, title: str, period: float = 1e-3
) -> dict[str, bytes]:
    """Time of each part of a step (label, least, mean, longest) [s], the thesis' worst and the period. Graf 6.19."""
    with house_style():
        return files("loop_time", charts.loop_time_figure(parts, thesis_worst, title, period), title)


def joints(
    t: ArrayLike,
    q: ArrayLike,
    lower: ArrayLike,
    upper: ArrayLike,
    velocity: ArrayLike,
    title: str,
    delta: ArrayLike | None = None,
) -> dict[str, bytes]:
    """Joints q (n, c) [rad] over t (n,) [s] against their limits (c,), speeds as steps of the period: joints.

    delta (n,) [rad]: the arm angle, drawn where it changes.
    """
    with house_style():
        return files("joints", charts.joints_figure(t, q, lower, upper, velocity, title, delta), title)


def arm_angle_map(
    t: ArrayLike,
    chart: ArmMap,
    limits: JointLimits,
    courses: Sequence[ArmAngleSeries],
    definition: str,
    title: str,
    places: Sequence[tuple[float, str]] = (),
) -> dict[str, bytes]:
    """What each arm angle means along the path, and one or two courses over times t (n,) [s]: arm_angle.

    Colour: least distance from a position limit, or the joint that is out of its range. places: (time [s], name).
    """
    with house_style():
        figure = arm_angle.map_figure(np.asarray(t), chart, limits, courses, definition, title, places)
        return files("arm_angle", figure, title)
