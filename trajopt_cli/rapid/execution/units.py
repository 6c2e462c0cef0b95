"""Mechanical units: which are active, and where those stand that are not.

The axes of a unit that is not active hold their place: the controller ignores their values in targets, and CRobT and
CJointT give 9E9 for them. Of the units that share a logical axis, one at a time is active (RAPID reference manual,
ActUnit, DeactUnit, extjoint). Names in lower case; positions in RAPID's units, as in motion.ExternalAxes.
"""

from __future__ import annotations

import re
from collections import Counter

from trajopt_cli.motion import ExternalAxes
from trajopt_cli.scenario import Scenario

# as ABB's templates and people name conveyors, sensors and robots
_MOVING = re.compile(r"(cnv|conveyor|belt|ssync)\w*|rob_\w+|(t_)?rob(ot)?_?\d+", re.IGNORECASE)


class Units:
    """The cell's units as they stand now.

    axes: of every unit, its logical axes (0 for eax_a). shared: the axes that several units have. active: the units
    that are. parked: where the axes of a positioner stand that is not. rail_inactive: first motion and the one behind
    the last, None for the end, during which the rail's unit is not active. moving: units that carry work objects and
    are known to move on their own. inactive: the units of each logical axis that no active one drives. wanted: the
    active unit of each that targets must give a value for.
    """

    def __init__(self, scenario: Scenario):
        self._scenario, rail = scenario, scenario.rail
        self.axes = {name: tuple(axis.eax for axis in axes) for name, axes in scenario.positioners.items()}
        counts = Counter(eax for axes in self.axes.values() for eax in axes)
        self.shared = frozenset(eax for eax, count in counts.items() if count > 1)
        self.rail = rail.unit.lower() if rail is not None and rail.unit is not None else None
        if rail is not None and self.rail is not None:
            self.axes[self.rail] = (rail.eax,)
        given = scenario.active_units
        default = {name for name, axes in self.axes.items() if not self.shared.intersection(axes)}
        self.active = set(default if given is None else given)
        self.parked = {
            name: tuple(axis.start / axis.unit for axis in axes)
            for name, axes in scenario.positioners.items()
            if name not in self.active
        }
        self.rail_inactive: list[tuple[int, int | None]] = []
        if self.rail is not None and self.rail not in self.active:
            self.rail_inactive.append((0, None))
        self.moving: set[str] = set()
        self._update()

    def _update(self) -> None:
        driven = {eax: name for name in sorted(self.active) for eax in self.axes[name]}
        self.inactive = {
            eax: [name for name, having in self.axes.items() if eax in having]
            for axes in self.axes.values()
            for eax in axes
            if eax not in driven
        }
        self.wanted = {eax: name for eax, name in driven.items() if name != self.rail}

    def conflict(self, unit: str) -> tuple[str, int] | None:
        """The active unit that shares a logical axis with a unit to be activated, and that axis."""
        axes = set(self.axes[unit])
        other = next((name for name in sorted(self.active) if axes.intersection(self.axes[name])), None)
        return None if other is None else (other, min(axes.intersection(self.axes[other])))

    def switch(self, unit: str, on: bool, extax: ExternalAxes, motions: int) -> ExternalAxes:
        """Activate a unit without conflict, or deactivate it, after so many motions; the external axes then."""
        axes = self.axes[unit]
        (self.active.add if on else self.active.discard)(unit)
        if unit == self.rail and on:
            self.rail_inactive[-1] = self.rail_inactive[-1][0], motions
        elif unit == self.rail:
            self.rail_inactive.append((motions, None))
        elif on:
            extax = _with(extax, dict(zip(axes, self.parked.pop(unit), strict=True)))
        else:
            starts = [axis.start / axis.unit for axis in self._scenario.positioners[unit]]
            at = [extax[eax] for eax in axes]
            self.parked[unit] = tuple(s if a is None else a for a, s in zip(at, starts, strict=True))
            extax = _with(extax, dict.fromkeys(axes))
        self._update()
        return extax

    @property
    def rail_unnamed(self) -> bool:
        """Whether there is a rail, and nobody says what its unit is called."""
        return self._scenario.rail is not None and self.rail is None

    def driven(self, extax: ExternalAxes) -> ExternalAxes:
        """extax without the axes that no active unit drives."""
        return _with(extax, dict.fromkeys(self.inactive)) if self.inactive else extax

    def positions(self, unit: str, extax: ExternalAxes) -> tuple[float, ...]:
        """Where a unit's axes stand [deg or mm], external axes at extax; at their start where that says nothing, and
        where they were left while the unit is not active."""
        if (parked := self.parked.get(unit)) is not None:
            return parked
        axes = self._scenario.positioners[unit]
        given = [extax[axis.eax] for axis in axes]
        return tuple(
            axis.start / axis.unit if value is None else value for axis, value in zip(axes, given, strict=True)
        )

    def moves_by_itself(self, unit: str) -> bool:
        """Whether a unit is a conveyor, a sensor or another robot, by its name or by what the program does with it."""
        key = unit.lower()
        return key in self.moving or (key not in self.axes and _MOVING.fullmatch(unit) is not None)


def _with(extax: ExternalAxes, values: dict[int, float | None] | dict[int, float]) -> ExternalAxes:
    return tuple(values.get(i, old) for i, old in enumerate(extax))
