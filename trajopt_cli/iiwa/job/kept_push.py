"""Whether a scheduled sequence pushes on what the tool touches as the programmed one does, and how it comes to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.job.folder import Opened
from trajopt_cli.iiwa.job.simulation import diagonal, run_controller
from trajopt_cli.iiwa.report.answer import Refused
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.model import Feed, Task
from trajopt_cli.iiwa.world.contact import BallOnBoxes
from trajopt_cli.iiwa.world.worlds import Engine

PUSH_KEPT = 0.2
"""Share by which the push on what the tool touches may differ from what is programmed."""
_GENTLER = 7  # times that the way onto a surface is tried, each at half the speed of the one before
_NEARLY = 2e-3  # m above a surface from which on the tool comes slowly
_LEVEL = 0.99  # cosine between normals of one surface


@dataclass(frozen=True)
class KeptPush:
    """Forces [N] on what the tool touches, springs for obstacles: the greatest as programmed and as scheduled; of each
    leg that lies in one surface its ends' names, what the springs press with at rest there, and the mean push."""

    programmed: float
    largest: float
    legs: tuple[tuple[str, str, float, float], ...] = ()

    @property
    def kept(self) -> bool:
        """Whether all of them are within PUSH_KEPT."""
        near = all(abs(mean - wanted) <= PUSH_KEPT * wanted for *_, wanted, mean in self.legs)
        return near and self.largest <= (1 + PUSH_KEPT) * self.programmed

    @property
    def apart(self) -> str:
        """What is not kept, and what to do."""
        if self.largest > (1 + PUSH_KEPT) * self.programmed:
            what = f"the tool would push with {self.largest:.1f} N, programmed are {self.programmed:.1f} N"
        else:
            origin, goal, rest, mean = max(self.legs, key=lambda leg: abs(leg[3] / leg[2] - 1))
            what = f"from {origin} to {goal} the tool would push with {mean:.1f} N in the mean, at rest {rest:.1f} N"
        return (
            f"{what}, more than {100 * PUSH_KEPT:g} % apart; lower v_max where it touches, or dose the free path alone"
        )

    def record(self) -> dict[str, Any]:
        """As plain data."""
        keys = ("from", "to", "at_rest_N", "mean_N")
        legs = [dict(zip(keys, leg, strict=True)) for leg in self.legs]
        return {"programmed_N": self.programmed, "largest_N": self.largest, "legs": legs}


def pushed(opened: Opened, programmed: float | None = None) -> KeptPush | Refused | None:
    """What a sequence pushes with on what the task lets it touch, springs for obstacles; None where the task has
    nothing to touch. programmed [N]: the greatest force of the sequence as it was, None for its own."""
    if opened.task.contact is None:
        return None
    task = replace(opened.task, pushes=(), sensor=None)
    run = run_controller(replace(opened, task=task), task.contact, Engine.SPRING.value, Feed.POSITION, None, None)
    if isinstance(run, Refused):
        return run
    assert run.loop is not None
    if run.loop.stop is not None:
        return Refused("no sequence", [f"where the tool touches, {run.loop.stop.message}", "NOTHING WRITTEN"])
    plan, force = opened.plan or opened.equilibrium, run.loop.contact_true[:, :3]
    largest = float(np.linalg.norm(force, axis=1).max())
    depth, normal, wanted = _at_rest(task, plan)
    legs = []
    for one in plan.pieces:
        rows = slice(one.first, one.last + 1)
        if depth[rows].min() > 0 and (normal[rows] @ normal[one.first]).min() > _LEVEL:
            mean = float(np.mean(np.sum(force[rows] * normal[rows], axis=1)))
            legs.append((one.origin, one.goal, float(wanted[rows].mean()), mean))
    return KeptPush(largest if programmed is None else programmed, largest, tuple(legs))


def gentler(task: Task, sequence: Equilibrium, programmed: KeptPush | None) -> Iterator[Array | None]:
    """Shares (n - 1,) of each step's programmed speed to try in turn, None for all of it: ever slower onto surfaces and
    off them."""
    if programmed is None or not programmed.largest:
        yield None
        return
    at_rest = _at_rest(task, sequence)
    room = max(PUSH_KEPT * programmed.largest, (1 + PUSH_KEPT) * programmed.largest - float(at_rest[2].max()))
    for halvings in range(_GENTLER):
        yield _slower(task, sequence, at_rest, room / 2**halvings)


def _at_rest(task: Task, sequence: Equilibrium) -> tuple[Array, Array, Array]:
    """At each row (n,): how deep [m] the tip's ball is in what it may touch, the normal (n, 3), and the force [N] that
    the springs press with when all is at rest there."""
    assert task.contact is not None
    ball, K = BallOnBoxes(task.contact), diagonal(task, "K", sequence.t)
    rows = [ball.pressed(tuple(p), tuple(k)) for p, k in zip(sequence.pose[:, :3].tolist(), K.tolist(), strict=True)]
    depth, normal, force = zip(*rows, strict=True)
    return np.array(depth), np.array(normal), np.array(force)


def _slower(task: Task, sequence: Equilibrium, at_rest: tuple[Array, Array, Array], most: float) -> Array:
    """Shares (n - 1,) of the programmed speed at which no surface, nor what is right above it, is approached or left by
    more than what the damper turns into the force most [N]."""
    depth, normal, _ = at_rest
    D = diagonal(task, "D", sequence.t)[1:]
    steps = np.sum(np.diff(sequence.pose[:, :3], axis=0) * normal[1:], axis=1) / sequence.h
    force = np.abs(steps) * np.sum(D * normal[1:] ** 2, axis=1)
    return np.where((depth[1:] > -_NEARLY) & (force > most), most / np.maximum(force, 1e-300), 1.0)
