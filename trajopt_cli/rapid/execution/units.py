"""Mechanical units: which are active, and where those stand that are not.

The axes of a unit that is not active hold their place: the controller ignores their values in targets, and CRobT and
CJointT give 9E9 for them. Of the units that share a logical axis, one at a time is active (RAPID reference manual,
ActUnit, DeactUnit, extjoint). Names in lower case; positions in RAPID's units, as in motion.ExternalAxes.
"""

from __future__ import annotations

import re
from collections import Counter
from math import degrees
from typing import TYPE_CHECKING

from trajopt_cli.motion import ExternalAxes
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.language.syntax import Expression, Name, Node
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

_STILL = 0.1  # mm or deg: backups hold measured values of axes that stand
# as ABB's templates and people name conveyors, sensors and robots
_MOVING = re.compile(r"(cnv|conveyor|belt|ssync)\w*|rob_\w+|(t_)?rob(ot)?_?\d+", re.IGNORECASE)


class Units:
    """The cell's units as they stand now.

    axes: of every unit, its logical axes (0 for eax_a). shared: the axes that several units have. active: the units
    that are. parked: where the axes of a positioner stand that is not. stretches: first motion and the one behind the
    last, None for the end, during which the rail's unit is not active. moving: units that carry work objects and are
    known to move on their own.
    """

    def __init__(self, scenario: Scenario):
        self._scenario, rail = scenario, scenario.rail
        self.axes = {name: tuple(axis.eax for axis in axes) for name, axes in scenario.positioners.items()}
        counts = Counter(eax for axes in self.axes.values() for eax in axes)
        self.shared = frozenset(eax for eax, count in counts.items() if count > 1)
        self._rail = rail.unit.lower() if rail is not None and rail.unit is not None else None
        if rail is not None and self._rail is not None:
            self.axes[self._rail] = (rail.eax,)
        given = scenario.active_units
        default = {name for name, axes in self.axes.items() if not self.shared.intersection(axes)}
        self.active = set(default if given is None else given)
        self.parked = {
            name: tuple(degrees(axis.start) for axis in axes)
            for name, axes in scenario.positioners.items()
            if name not in self.active
        }
        self.stretches: list[tuple[int, int | None]] = []
        if self._rail is not None and self._rail not in self.active:
            self.stretches.append((0, None))
        self.moving: set[str] = set()
        self._look()

    def _look(self) -> None:
        driven = {eax: name for name in sorted(self.active) for eax in self.axes[name]}
        self._inactive = {
            eax: [name for name, having in self.axes.items() if eax in having]
            for axes in self.axes.values()
            for eax in axes
            if eax not in driven
        }
        self._wanted = {eax: name for eax, name in driven.items() if name != self._rail}

    def switch(self, run: Execution, node: Node, unit: str, on: bool) -> None:
        """Activate a unit of the cell, or deactivate it. Raises InputError for two on one axis."""
        if self._scenario.active_units is None:
            self._say_start(run, node)
        if on == (unit in self.active):
            return
        axes, position = self.axes[unit], run.position
        if on:
            other = next((name for name in sorted(self.active) if set(axes).intersection(self.axes[name])), None)
            if other is not None:
                eax = "abcdef"[min(set(axes).intersection(self.axes[other]))]
                text = f"{unit} and {other} share eax_{eax}, and {other} is active; write DeactUnit {other} before it"
                raise run.error(node, text)
            self.active.add(unit)
        else:
            self.active.discard(unit)
        if unit == self._rail:
            count = len(run.motions)
            if on:
                self.stretches[-1] = self.stretches[-1][0], count
            else:
                self.stretches.append((count, None))
        elif on:
            position.extax = _with(position.extax, dict(zip(axes, self.parked.pop(unit), strict=True)))
        else:
            at = [position.extax[eax] for eax in axes]
            starts = [degrees(axis.start) for axis in self._scenario.positioners[unit]]
            self.parked[unit] = tuple(s if a is None else a for a, s in zip(at, starts, strict=True))
            position.extax = _with(position.extax, dict.fromkeys(axes))
        self._look()

    def _say_start(self, run: Execution, node: Node) -> None:
        parts = {"active": sorted(self.active), "not active": sorted(self.axes.keys() - self.active)}
        told = "; ".join(f"{what}: {', '.join(names)}" for what, names in parts.items() if names)
        text = f"mechanical units taken at the start as {told}; 'start: {{units: [...]}}' in the cell"
        run.note("units at the start", WarningKind.ASSUMED, f"{text} file lists the active ones", node)

    @property
    def rail_unnamed(self) -> bool:
        """Whether there is a rail, and nobody says what its unit is called."""
        return self._scenario.rail is not None and self._rail is None

    def driven(self, extax: ExternalAxes) -> ExternalAxes:
        """extax without the axes that no active unit drives."""
        return _with(extax, dict.fromkeys(self._inactive)) if self._inactive else extax

    def checked(self, run: Execution, point: Node, extax: ExternalAxes) -> ExternalAxes:
        """As driven, of a move's target: said, once per unit, where a value is ignored, and where one is missing."""
        for eax, units in self._inactive.items():
            value, at = extax[eax], [self._stands(run, unit, eax) for unit in units]
            if value is not None and any(one is None or abs(value - one) > _STILL for one in at):
                run.note(
                    f"{units} ignored",
                    WarningKind.NO_EFFECT,
                    f"{run.text(point)} gives eax_{'abcdef'[eax]} = {value:.6g}, and {' and '.join(units)} "
                    f"{'are' if len(units) > 1 else 'is'} not active: the axis stays, as on the controller",
                    point,
                )
        for eax, unit in self._wanted.items():
            if extax[eax] is None:
                run.note(
                    f"{unit} open",
                    WarningKind.DOUBTFUL,
                    f"{run.text(point)} gives no position for eax_{'abcdef'[eax]} (9E9), and {unit} is active: a "
                    "controller stops here with a missing external axis value, a plan lets it stand. Give the value, "
                    f"deactivate {unit} before, or leave it out of the active ones (start.units in the cell file)",
                    point,
                )
        return self.driven(extax)

    def _stands(self, run: Execution, unit: str, eax: int) -> float | None:
        if unit == self._rail:
            return run.position.extax[eax]
        return self.parked[unit][self.axes[unit].index(eax)]

    def moves_by_itself(self, unit: str) -> bool:
        """Whether a unit is a conveyor, a sensor or another robot, by its name or by what the program does with it."""
        key = unit.lower()
        return key in self.moving or (key not in self.axes and _MOVING.fullmatch(unit) is not None)


def _with(extax: ExternalAxes, values: dict[int, float | None] | dict[int, float]) -> ExternalAxes:
    a, b, c, d, e, f = (values.get(i, old) for i, old in enumerate(extax))
    return a, b, c, d, e, f


def unit_name(run: Execution, node: Expression) -> str:
    """The name of the unit that an argument stands for, as the program spells it. Units are not declared in RAPID."""
    if not isinstance(node, Name):
        raise run.error(node, f"needs the name of a mechanical unit, found {run.text(node)}")
    place = run.find(node.name)
    known = place.value.data if isinstance(place, Datum) and place.type.name == "mecunit" else None
    return node.name if known is None else str(known)
