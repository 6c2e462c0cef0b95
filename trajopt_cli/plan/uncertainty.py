"""What motions take where the numbers they were planned with are not quite the true ones.

The programs stay as they are, and each motion is timed anew on its own path. Numbers of one kind and one source err
together: all at their lower ends, or all at their upper ones. Different ones err each by itself, so what their ends
change is added as squares. What one motion saves against another is found with the same ends for both.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from trajopt_cli.motion import Program, Wait
from trajopt_cli.path_timing.retiming import MotionPath
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.plan import Infeasible, Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg
from trajopt_cli.problem.tool_turns import turned
from trajopt_cli.runs.uncertainty import WRITTEN, Guess, Uncertainty
from trajopt_cli.scenario import Settling
from trajopt_cli.trajectories.axes import Axes

_WORTH = 5e-4  # s, or share of a time: an interval as narrow is none, for times are printed to a millisecond
_SLOWER = 0.98  # share of its time in which a motion's path may be driven, below which it is slow by intent
_KINDS = {"velocity": "speed", "acceleration": "acceleration", "torque": "torque"}
_Ends = tuple[float, float]


def uncertainty(
    program: Program, plant: Plant, settle: Settling, plans: Mapping[str, Plan], before: str = WRITTEN
) -> Uncertainty:
    """Of plans of one program on one plant, by name, each with all its rows. settle: what settling rests on, which
    takes as long in all of them. before: the plan that others save against, if it is there."""
    unsure = [*_unsure(plant)]
    again = {name: _Again(program, plant, plan) for name, plan in plans.items()} if unsure else {}
    guesses, found = list[Guess](), list[dict[str, _Ends]]()
    settling = sum(one.duration for one in program.motions if isinstance(one, Wait) and one.settles)
    least, most = ((share - 1) * settling for share in settle.spread)
    if most - least > _WORTH:
        found.append(dict.fromkeys(plans, (least, most)))
        name, shares = f"settling, {_grade(settle.source)}", {"stops": settle.spread}
        guesses.append(Guess(name=name, source=settle.source, shares=shares, longer_s=found[-1]))
    for name, source, shares, (low, high) in unsure:
        slower = {plan: one.longer(low) for plan, one in again.items()}
        # what binds nowhere when it is lower does not when it is higher
        if max(slower.values(), default=0.0) > _WORTH or any(least == 1.0 for least, _ in shares.values()):
            found.append({plan: (slower[plan], one.longer(high)) for plan, one in again.items()})
            guesses.append(Guess(name=name, source=source, shares=shares, longer_s=found[-1]))
    T = {name: plan.duration for name, plan in plans.items()}
    ranges = {name: around(T[name], [one[name] for one in found]) for name in plans}
    saved = {
        name: saving(T[before], T[name], [(one[before], one[name]) for one in found])
        for name in plans
        if before in plans and name != before and found and abs(T[name] - T[before]) > _WORTH * T[before]
    }
    kept = [{name: ends for name, ends in one.items() if ends is not None} for one in (ranges, saved)]
    return Uncertainty(cycle_time_range_s=kept[0], saving_range=kept[1], guesses=guesses)


def around(value: float, steps: Sequence[Sequence[float]]) -> _Ends | None:
    """The interval of a value that guesses change by steps, each guess by one of them; None where it is no wider than
    what is printed."""
    down, up = (float(np.sqrt(sum(max(0.0, *(sign * x for x in one)) ** 2 for one in steps))) for sign in (-1, 1))
    return None if down + up < _WORTH else (value - down, value + up)


def saving(T_0: float, T_1: float, steps: Sequence[tuple[_Ends, _Ends]]) -> _Ends | None:
    """The same of the share of T_0 that T_1 saves, by the steps of both; None as well where one may take for ever."""
    if not np.isfinite(steps).all():
        return None
    changes = [[T_1 / T_0 - (T_1 + b) / (T_0 + a) for a, b in zip(*both, strict=True)] for both in steps]
    return around(1 - T_1 / T_0, changes)


def _unsure(plant: Plant) -> Iterator[tuple[str, str, dict[str, _Ends], list[Plant]]]:
    """Name and source of what nobody is sure of, between which shares it is, and the plant with either end. The cell
    file's own numbers are sure."""
    limits, robot, found = plant.limits, plant.robot, dict[tuple[str, str], list[str]]()
    for kind in _KINDS:
        for axis in limits.names if kind != "torque" or limits.torque_binds else ():
            low, high = limits.spread.get(f"{axis}.{kind}", (1.0, 1.0))
            if low < high:
                found.setdefault((kind, limits.sources[f"{axis}.{kind}"]), []).append(axis)
    for (kind, source), axes in found.items():
        shares = {axis: limits.spread[f"{axis}.{kind}"] for axis in axes}
        ends = [[shares.get(axis, (1.0, 1.0))[end] for axis in limits.names] for end in (0, 1)]
        plants = [replace(plant, limits=limits.changed(kind, getattr(limits, kind) * end)) for end in ends]
        whose = f"{len(axes)} joint" if len(axes) > 2 else " and ".join(axes)
        yield f"{whose} {_KINDS[kind]}{'s' * (len(axes) > 1)}, {_grade(source)}", source, shares, plants
    for kind, share in robot.tcp_spread.items() if plant.tcp is robot.tcp else ():
        if share[0] < share[1]:
            caps: list[dict[str, Any]] = [{kind: getattr(plant.tcp, kind) * end} for end in share]
            plants = [replace(plant, tcp=replace(plant.tcp, **one)) for one in caps]
            source = robot.notes[f"tcp.{kind}"]
            yield f"TCP {kind}, {_grade(source)}", source, {"tcp": share}, plants


def _grade(source: str) -> str:
    return source.rpartition("(")[2].rstrip(")")


class _Again:
    """A plan, to be timed again. One that is slower than it could be on its path (least effort, limits of jerk) keeps
    its pace where that can be kept."""

    def __init__(self, program: Program, plant: Plant, plan: Plan):
        self._program = with_detours(turned(program, plan.turns), plant, plan.detours)
        self._plan = unfolded(plan)
        self._driven = [one for one in self._plan.motions if one.t_1 > one.t_0]
        ends = np.array([one.t_1 for one in self._driven])
        self._path = MotionPath(plan.trajectory, Axes.of(plant), self._legs(plant), ends)
        self._T, self._paced = 0.0, False
        self._paced = self.longer(plant) / plan.duration < _SLOWER
        self._T = self.longer(plant)

    def longer(self, plant: Plant) -> float:
        """By how much it takes longer [s] on a plant with other numbers."""
        return self._path.duration(Axes.of(plant), self._legs(plant), self._paced) - self._T

    def _legs(self, plant: Plant) -> list[Leg]:
        """The leg of each motion that takes a time."""
        dropped = frozenset(one.index for one in self._plan.motions if one.dropped)
        problem = build_problem(self._program, plant, EVERYTHING, self._plan.target, None, dropped)
        assert not isinstance(problem, Infeasible)  # it has a plan
        first = {leg.motion: leg for leg in reversed(problem.legs)}
        return [first[one.index] for one in self._driven]
