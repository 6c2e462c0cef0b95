"""Pictures of a program in steps of speed, as written: Krotký 2014, figures 4.3 to 4.6."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Program, SignalEvent, Wait
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report.in_space import CARRIAGE, STANDS, WORLD, Space, path_figure
from trajopt_cli.report.over_time import TIME, legend, mark_times, with_names, xyz_handles
from trajopt_cli.report.stepwise import Analysis, StepMove
from trajopt_cli.report.style import AXIS_STYLES, BLACK, BLUE, GREY, VERMILLION, new_figure
from trajopt_cli.scene import rail_ends
from trajopt_cli.units import MM

# Krotký 2014 draws them red and black; width and line style tell them apart without colour, too.
FUNCTIONAL, OPTIONAL, RAIL = "functional", "optional", "rail"
_KINDS: dict[str, dict[str, Any]] = {
    FUNCTIONAL: {"color": VERMILLION, "linewidth": 3.2, "label": "has to be driven"},
    OPTIONAL: {"color": BLACK, "linewidth": 1.5, "linestyle": (0, (4, 1.5)), "label": "may be left out"},
    RAIL: {"color": BLUE, "linewidth": 1.8, "linestyle": (0, (1.2, 1.6)), "label": "only the rail moves"},
}
_RAIL_ALONE = Patch(color="#cfe3f1", linewidth=0, label="only the rail moves")
_PLACES = 97  # on every way that is drawn: a straight one has points for names to keep away from, too


@dataclass(frozen=True, eq=False)
class Steps:
    """A program, where it runs, its analysis with at least one move, and the line below each heading."""

    program: Program
    plant: Plant
    analysis: Analysis
    below: str

    @property
    def rides(self) -> bool:
        """Whether the rail moves."""
        return self.analysis.rail > 0

    def target(self, move: StepMove) -> str:
        """Where a move goes, as the program writes it."""
        motion = self.program.motions[move.index]
        assert not isinstance(motion, Wait | SignalEvent)
        return motion.target

    def kind(self, move: StepMove) -> str:
        """Key of what the move is drawn as: optional where the program marks it so, else functional; or rail alone."""
        if move.t_arm == 0:
            return RAIL
        motion = self.program.motions[move.index]
        assert not isinstance(motion, Wait | SignalEvent)
        return OPTIONAL if motion.optional else FUNCTIONAL


def steps_of(program: Program, plant: Plant, analysis: Analysis, title: str) -> Steps:
    """What the pictures are drawn from. title: the program's name for people."""
    how = f"{title} · as written, without ramps and waits · "
    sums = f"arm {analysis.arm:.3f} s + rail {analysis.rail:.3f} s" if analysis.rail > 0 else ""
    both = sum(min(move.t_arm, move.t_rail) for move in analysis.moves)
    if sums and both > 0:
        sums += f" − both at once {both:.3f} s"
    cycle = f"{analysis.cycle:.3f} s"
    return Steps(program, plant, analysis, how + (f"{sums} = {cycle}" if sums else cycle))


def speed(steps: Steps) -> Figure:
    """Programmed TCP speed, and the x, y and z speeds it comes to on the straight ways. Figs 4.4 and 4.5."""
    moves, begins = steps.analysis.moves, steps.analysis.begins
    where = ", seen from the carriage" if steps.rides else ""
    figure = new_figure(6.9, f"Programmed speed of the tool centre point{where}", steps.below)
    grid = figure.subplots(2, 1, sharex=True)
    rows: list[tuple[float, float, float, float, float]] = []  # time, programmed speed, velocity along x, y, z
    for begin, move in zip(begins, moves, strict=False):
        if move.t_arm > 0:
            at, velocities = move.velocities
            for i, velocity in enumerate(velocities):
                rows += [(begin + float(share) * move.t_arm, move.v_tcp, *velocity) for share in at[i : i + 2]]
        if move.t_rail > move.t_arm:
            rows += [(begin + after, 0.0, 0.0, 0.0, 0.0) for after in (move.t_arm, move.t_rail)]
    t, *speeds = np.array(rows).T
    programmed, *along = np.array(speeds) / MM
    grid[0].plot(t, programmed, color=BLACK, gid="speed")
    grid[0].set_ylim(0, 1.08 * max(float(programmed.max()), 1.0))
    grid[0].set_ylabel("speed [mm/s]")
    for values, name, (color, line) in zip(along, "xyz", AXIS_STYLES, strict=True):
        grid[1].plot(t, values, color=color, linestyle=line, gid=name)
    grid[1].axhline(0, color=GREY, linewidth=0.7, zorder=1)
    reach = 1.12 * max(float(np.abs(along).max(initial=0.0)), 1.0)
    grid[1].set_ylim(-reach, reach)
    grid[1].set_ylabel("along the axes\n[mm/s]")
    grid[-1].set_xlabel(TIME)
    alone = [(float(b + m.t_arm), m.t_rail - m.t_arm) for b, m in zip(begins, moves, strict=False)]
    bands = [(start, length) for start, length in alone if length > 0]
    mark_times(grid, float(begins[-1]), [float(end) for end in begins[1:]], bands, _RAIL_ALONE)
    legend(figure, [*xyz_handles(("along x", "along y", "along z")), *([_RAIL_ALONE] if bands else [])])
    ends = [(float(end), steps.target(m)) for end, m in zip(begins[1:], moves, strict=True) if m.duration > 0]
    return with_names(figure, grid[0], ends)


def path(steps: Steps) -> Figure:
    """The ways between the points, straight or along their arcs, in the real space and as the carriage sees them. Figs
    4.3 and 4.6.

    What the carriage sees is drawn along the world's axes, and agrees with the real space where the carriage starts.
    """
    moves = steps.analysis.moves
    carriage = [m.X_WT_0 @ inverse_pose(m.X_BT_0) for m in moves] + [moves[-1].X_WT_1 @ inverse_pose(moves[-1].X_BT_1)]
    real = [m.real for m in moves]
    seen = [m.seen @ carriage[0][:3, :3].T + carriage[0][:3, 3] for m in moves]
    spaces = [_space(WORLD, real, rail_ends(steps.plant))]
    if steps.rides:
        spaces.append(_space(CARRIAGE, seen, carriage[0][None, :3, 3]))
    names = ["start", *(steps.target(m) for m in moves)]
    size = _PLACES
    parts = [
        (slice(k * size, (k + 1) * size), steps.kind(m))
        for k, m in enumerate(moves)
        if max(float(np.ptp(way, axis=0).max()) for way in (real[k], seen[k])) > STANDS
    ]
    ride = np.ptp([X[:3, 3] for X in carriage], axis=0)
    across = ride if ride[:2].max() > STANDS else np.ptp(spaces[0].path, axis=0)
    heading = "Path of the tool centre point as programmed, straight through every point"
    ends = [(k + 1) * size - 1 for k in range(len(moves))]
    return path_figure(heading, steps.below, spaces, names, parts, ends, int(np.argmax(across[:2])), _KINDS)


def _space(name: str, ways: Sequence[Array], ground: Array) -> Space:
    """Ways (k, 3) one after the other, with their ends as places."""
    return Space(name, np.vstack([_dense(way) for way in ways]), np.array([ways[0][0], *(w[-1] for w in ways)]), ground)


def _dense(way: Array) -> Array:
    """A way (n, 3) in as many places as every other."""
    share, wanted = np.linspace(0.0, 1.0, len(way)), np.linspace(0.0, 1.0, _PLACES)
    return np.column_stack([np.interp(wanted, share, column) for column in way.T])
