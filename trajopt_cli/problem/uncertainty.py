"""Numbers that a cycle time rests on and nobody is sure of: what they are, the plant with their ends, and the interval
that a time or a saving has for them.

Numbers of one kind and one source err together: a guess is all of them at their lower ends, or all at their upper ones.
Different guesses err each by itself, so what their ends change is added as squares.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from trajopt_cli.problem.plant import Plant

WRITTEN = "as_written"
"""The name of the program as it stands, among the motions of an Uncertainty."""
WORTH = 5e-4
"""s, or share of a time: an interval as narrow is none, for times are printed to a millisecond."""
Ends = tuple[float, float]
_AXES = ("velocity", "acceleration", "torque")


@dataclass(frozen=True)
class Guess:
    """Numbers of one kind and one source: of axes, or where these are none of the tool's cap. spread: by axis, or of
    the cap, between which shares of a number the true one is."""

    kind: str
    axes: tuple[str, ...]
    source: str
    spread: tuple[Ends, ...]

    @property
    def name(self) -> str:
        """What it is and its grade: "joint_2 acceleration, grade D", "6 joint accelerations, grade D"."""
        what = {"velocity": "speed"}.get(self.kind, self.kind)
        grade = self.source.rpartition("(grade ")[2].rstrip(")")
        if len(self.axes) > 1:
            whose = f"{len(self.axes)} joint" if len(self.axes) > 2 else " and ".join(self.axes)
            return f"{whose} {what}s, grade {grade}"
        return f"{self.axes[0] if self.axes else 'TCP'} {what}, grade {grade}"

    def at(self, plant: Plant, end: int) -> Plant:
        """The plant with all lower ends for end 0, with all upper ones for 1."""
        if not self.axes:
            cap = getattr(plant.tcp, self.kind) * self.spread[0][end]
            return replace(plant, tcp=replace(plant.tcp, **{self.kind: cap}))
        limits, values = plant.limits, np.array(getattr(plant.limits, self.kind))
        changed: dict[str, Any] = {self.kind: values}
        for axis, ends in zip(self.axes, self.spread, strict=True):
            values[limits.names.index(axis)] *= ends[end]
        return replace(plant, limits=replace(limits, **changed))


def guesses_of(plant: Plant) -> Iterator[Guess]:
    """All there are of a plant, in a fixed order. The cell file's own numbers are none."""
    limits, robot, found = plant.limits, plant.robot, dict[tuple[str, str], list[str]]()
    for kind in _AXES if limits.torque_binds else _AXES[:2]:
        for axis in limits.names:
            low, high = limits.spread.get(f"{axis}.{kind}", (1.0, 1.0))
            if low < high:
                found.setdefault((kind, limits.sources[f"{axis}.{kind}"]), []).append(axis)
    for (kind, source), axes in found.items():
        yield Guess(kind, tuple(axes), source, tuple(limits.spread[f"{axis}.{kind}"] for axis in axes))
    for kind, ends in robot.tcp_spread.items() if plant.tcp is robot.tcp else ():
        if ends[0] < ends[1]:
            yield Guess(kind, (), robot.notes[f"tcp.{kind}"], (ends,))


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """times: of motions by name [s]. steps: by how much each takes longer with the lower ends of a guess and with the
    upper ones [s]; infinite where it cannot be driven then."""

    times: Mapping[str, float]
    steps: Mapping[Guess, Mapping[str, Ends]]

    def range_of(self, name: str) -> Ends | None:
        """Between which times [s] a motion is; None where no guess matters to it, or it is none of them."""
        if name not in self.times:
            return None
        return _around(self.times[name], [step[name] for step in self.steps.values()])

    def saving(self, before: str, after: str) -> Ends | None:
        """Between which shares of the time before is what the one after saves, both with the same ends of each guess;
        None as in range_of, and where one of them cannot be driven."""
        T_0, T_1 = (self.times.get(one, 0.0) for one in (before, after))
        ends = [end for one in (before, after) for end in self.range_of(one) or ()]
        if not (T_0 and T_1 and ends and np.isfinite(ends).all()):
            return None
        saved = 1 - T_1 / T_0
        steps = ([*zip(step[before], step[after], strict=True)] for step in self.steps.values())
        return _around(saved, [[1 - (T_1 + b) / (T_0 + a) - saved for a, b in step] for step in steps])


def _around(value: float, steps: Sequence[Sequence[float]]) -> Ends | None:
    down, up = (float(np.sqrt(sum(max(0.0, *(sign * x for x in one)) ** 2 for one in steps))) for sign in (-1, 1))
    return None if down + up < WORTH else (value - down, value + up)


NOTHING = Uncertainty({}, {})
"""Of no motion."""
