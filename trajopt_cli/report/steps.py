"""Pictures of a program in steps of speed, as written: Krotký 2014, figures 4.3 to 4.6."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Program, SignalEvent, Wait
from trajopt_cli.problem.stepwise import Analysis, StepMove
from trajopt_cli.report.in_space import SAME, path_figure
from trajopt_cli.report.marks import mark_times
from trajopt_cli.report.names import by_place
from trajopt_cli.report.over_time import TIME, legend, with_names
from trajopt_cli.report.style import AXIS_STYLES, BLACK, BLUE, GREY, VERMILLION, new_figure
from trajopt_cli.units import MM

# The thesis draws functional parts red and detours black; width and line style tell them apart without colour too.
FUNCTIONAL, OPTIONAL, RAIL = "functional", "optional", "rail"
_KINDS: dict[str, dict[str, Any]] = {
    FUNCTIONAL: {"color": VERMILLION, "linewidth": 3.2, "label": "functional (red in the thesis)"},
    OPTIONAL: {"color": BLACK, "linewidth": 1.5, "linestyle": (0, (4, 1.5)), "label": "optional detour (black there)"},
    RAIL: {"color": BLUE, "linewidth": 1.8, "linestyle": (0, (1.2, 1.6)), "label": "rail alone"},
}
_RAIL_ALONE = Patch(color="#cfe3f1", linewidth=0, label="rail alone")
_PLACES = 97  # on every way that is drawn: a straight one has points for names to keep away from, too
_STANDS = 1e-6  # m: no way to show


@dataclass(frozen=True, eq=False)
class Steps:
    """A program, its analysis with at least one move, and the line below each heading."""

    program: Program
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


def steps_of(program: Program, analysis: Analysis, title: str) -> Steps:
    """What the pictures are drawn from. title: the program's name for people."""
    how = f"{title} · steps of speed, no waits · "
    sums = f"arm {analysis.arm:.3f} s + rail {analysis.rail:.3f} s" if analysis.rail > 0 else ""
    both = sum(min(move.t_arm, move.t_rail) for move in analysis.moves)
    if sums and both > 0:
        sums += f" − both at once {both:.3f} s"
    cycle = f"{analysis.cycle:.3f} s"
    return Steps(program, analysis, how + (f"{sums} = {cycle}" if sums else cycle))


def speed(steps: Steps) -> Figure:
    """Programmed TCP speed, and the x, y and z speeds it comes to on the straight ways. Figs 4.4 and 4.5."""
    moves, begins = steps.analysis.moves, steps.analysis.begins
    where = ", as the carriage sees it" if steps.rides else ""
    figure = new_figure(10.0, f"Programmed speed of the tool centre point{where}", steps.below)
    grid = figure.subplots(4, 1, sharex=True, height_ratios=[3, 2, 2, 2])
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
    reach = 1.12 * max(float(np.abs(along).max(initial=0.0)), 1.0)
    for i, (axes, name) in enumerate(zip(grid[1:], "xyz", strict=True)):
        axes.plot(t, along[i], color=AXIS_STYLES[i][0], gid=name)
        axes.axhline(0, color=GREY, linewidth=0.7, zorder=1)
        axes.set_ylim(-reach, reach)
        axes.set_ylabel(f"along {name}\n[mm/s]")
    grid[-1].set_xlabel(TIME)
    alone = [(float(b + m.t_arm), m.t_rail - m.t_arm) for b, m in zip(begins, moves, strict=False)]
    bands = [(start, length) for start, length in alone if length > 0]
    mark_times(grid, float(begins[-1]), [float(end) for end in begins[1:]], bands, _RAIL_ALONE)
    if bands:
        legend(figure, [_RAIL_ALONE])
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
    ways = [("real space", real)] + ([("relative to the carriage", seen)] if steps.rides else [])
    spaces, tags = [], []
    for name, ends in ways:
        spaces.append((name, np.vstack([_dense(way) for way in ends])))
        names = ["start", *(steps.target(m) for m in moves)]
        tags.append(by_place(np.array([ends[0][0], *(way[-1] for way in ends)]), names, SAME))
    size = _PLACES
    parts = [
        (slice(k * size, (k + 1) * size), steps.kind(m))
        for k, m in enumerate(moves)
        if max(float(np.ptp(way, axis=0).max()) for way in (real[k], seen[k])) > _STANDS
    ]
    ride = np.ptp([X[:3, 3] for X in carriage], axis=0)
    across = ride if ride[:2].max() > _STANDS else np.ptp(spaces[0][1], axis=0)
    heading = "Path of the tool centre point as programmed, through every point"
    return path_figure(heading, steps.below, spaces, parts, tags, int(np.argmax(across[:2])), _KINDS)


def _dense(way: Array) -> Array:
    """A way (n, 3) in as many places as every other."""
    share, wanted = np.linspace(0.0, 1.0, len(way)), np.linspace(0.0, 1.0, _PLACES)
    return np.column_stack([np.interp(wanted, share, column) for column in way.T])
