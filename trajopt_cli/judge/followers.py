"""Whether external axes that others lead stand where these take them, in the rows and in the program's targets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.findings import finding
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.tolerances import FOLLOWER_TARGET, HELD, REST_LINEAR
from trajopt_cli.motion import Hold, Move, Program, motion_name
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import MM


def without_followers(
    plant: Machine, trajectory: Trajectory, resolution: Resolution | None
) -> tuple[Trajectory, Resolution | None, list[Finding]]:
    """The rows of the robot's own axes, how finely these are printed, and what is found about the columns of axes that
    others lead ("rail_f"). A file need not have them."""
    names, k = trajectory.names, len(trajectory.names)
    led = {one.column: one for one in plant.followers if one.column in names}
    leaders = {name: plant.limits.names[plant.rail_eaxes.index(one.leader)] for name, one in led.items()}
    if not led or not {*leaders.values()} <= {*names}:  # whoever reads the axes' names says what is missing
        return trajectory, resolution, []
    printed = (np.zeros((1, k)),) * 2 if resolution is None else (resolution.q, resolution.qd)
    steps, found = [np.broadcast_to(step, (len(step), k)) for step in printed], list[Finding]()
    kinds = (("follower", "m", trajectory.q, HELD), ("follower speed", "m/s", trajectory.qd, REST_LINEAR))
    for name, one in led.items():
        i, j = names.index(name), names.index(leaders[name])
        for order, (check, unit, x, limit) in enumerate(kinds):
            if x is not None:
                wanted = one.ratio * x[:, j] + (0.0 if order else one.offset)
                doubt = (steps[order][:, i] + abs(one.ratio) * steps[order][:, j]) / 2
                off = np.maximum(np.abs(x[:, i] - wanted) - doubt, 0.0)
                row = int(np.argmax(off))
                when = float(trajectory.t[row])
                found.append(finding(check, name, off[row], limit, unit, off[row] <= limit, time=when))
    own = [i for i, name in enumerate(names) if name not in led]
    if resolution is not None:
        resolution = replace(resolution, q=steps[0][:, own], qd=steps[1][:, own])
    return trajectory.of([names[i] for i in own]), resolution, found


def check_targets(program: Program, plant: Machine) -> Iterator[Finding]:
    """Targets of the program that say where both a leader and the axis it leads are."""
    moves = [one for one in program.motions if isinstance(one, Move) and one.hold is not Hold.UNIT]
    for one, move in product(plant.followers, moves):
        value, leader = move.extax[one.eax], move.extax[one.leader]
        if value is not None and leader is not None:
            off = abs(value * MM - one.ratio * leader * MM - one.offset)
            yield finding("follower in target", one.column, off, FOLLOWER_TARGET, "m", off <= FOLLOWER_TARGET,
                          source=move.source, note=f" in {motion_name(move)}")  # fmt: skip
