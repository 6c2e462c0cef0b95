"""One axis of a program in the plane of state, as a double integrator drives it: figures 3.1 and 3.2 of Krotký 2014.

Every move of the axis begins at rest and ends at the origin: at full acceleration until the curve on which full braking
ends there, or until the speed programmed for it, which figure 3.2 adds.
"""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report.stepwise import Analysis
from trajopt_cli.report.style import BLACK, GREY, JOINT_STYLES, SMALL, files, house_style, new_figure, settle
from trajopt_cli.timing.double_integrator import fastest_profile
from trajopt_cli.units import MM

AXES = ("x", "y", "z", "rail")
"""Of the tool as the carriage sees it, and the carriage itself."""
_STILL = 1e-6  # m: less is no move of the axis
_FINE = 60  # places of each phase


def axis_moves(analysis: Analysis, plant: Plant, axis: str) -> tuple[list[tuple[int, float, float]], float]:
    """Moves of an axis, each its number in the program, displacement [m] and greatest speed [m/s]; acceleration [m/s2].

    Raises InputError for a rail that the robot has not, and for an axis that never moves.
    """
    if axis == "rail" and plant.layout.r != 1:
        raise InputError(f"--axis rail: {plant.robot.name} has {plant.layout.r or 'none'} of them; give x, y or z")
    out = []
    for move in analysis.moves:
        if axis == "rail":
            D, t = move.rail_1 - move.rail_0, move.t_rail
        else:
            D, t = float((move.X_BT_1 - move.X_BT_0)[AXES.index(axis), 3]), move.t_arm
        if abs(D) > _STILL and t > 0:
            out.append((move.index, D, float(plant.limits.velocity[0]) if axis == "rail" else abs(D) / t))
    if not out:
        raise InputError(f"--axis {axis}: no move of the program goes along it")
    return out, float(plant.limits.acceleration[0]) if axis == "rail" else plant.tcp.acceleration


def fastest_curve(D: float, V: float, A: float) -> tuple[Array, Array]:
    """Distance from the goal [m] and speed [m/s] (n,) of the fastest move over D from rest to rest."""
    breaks, accelerations = fastest_profile(D, 0.0, 0.0, V, A)
    s, v, at, speed = [-D], [0.0], -D, 0.0
    for T, a in zip(np.diff(breaks), accelerations, strict=True):
        t = np.linspace(0.0, T, _FINE)[1:]
        s += (at + speed * t + a * t * t / 2).tolist()
        v += (speed + a * t).tolist()
        at, speed = s[-1], v[-1]
    return np.array(s), np.array(v)


def phase_pictures(analysis: Analysis, plant: Plant, axis: str, title: str) -> dict[str, bytes]:
    """phase_plane.svg and .png: file name -> contents."""
    moves, A = axis_moves(analysis, plant, axis)
    with house_style():
        return files("phase_plane", phase_figure(moves, A, axis, title), title)


def phase_figure(moves: list[tuple[int, float, float]], A: float, axis: str, title: str) -> Figure:
    """Phase curves of an axis' moves (number, displacement, greatest speed) to the origin at accelerations up to A."""
    figure = new_figure(7.0, title, f"axis {axis}, |a| at most {A:g} m/s², every move from rest to rest")
    axes = figure.subplots()
    far = max(abs(D) for _, D, _ in moves) * 1.05
    top = max(min(V, np.sqrt(A * abs(D))) for _, D, V in moves) * 1.2
    v = np.linspace(-top, top, 400)
    curve = -v * np.abs(v) / (2 * A)
    axes.fill_betweenx(v, -far, np.clip(curve, -far, far), color="#d8e8f4", linewidth=0, gid="A")
    axes.fill_betweenx(v, np.clip(curve, -far, far), far, color="#f4e3d3", linewidth=0, gid="D")
    axes.plot(curve, v, color=BLACK, linewidth=1.4, gid="switching curve")
    for name, place, side in (("A: full acceleration", 0.03, "left"), ("D: full deceleration", 0.97, "right")):
        axes.annotate(name, (place, 0.06), xycoords="axes fraction", ha=side, size=SMALL, color=GREY)
    for k, (number, D, V) in enumerate(moves):
        color, line = JOINT_STYLES[k % len(JOINT_STYLES)]
        s, speed = fastest_curve(D, V, A)
        axes.plot(s, speed, color=color, linestyle=line, linewidth=1.8, gid=f"move {number}")
        axes.plot(s[0], 0.0, "o", color=color, markersize=5)
    axes.set_xlim(-far, far)
    axes.set_ylim(-top, top)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value / MM:g}")
    axes.set_xlabel("distance from the goal [mm]")
    axes.set_ylabel("speed [m/s]")
    settle(figure)
    return figure
