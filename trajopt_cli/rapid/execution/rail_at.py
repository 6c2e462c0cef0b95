"""Where the cell file says that the rail stands, for targets that leave it open (9E9)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from trajopt_cli.motion import ExternalAxes
from trajopt_cli.rapid.data.scope import CallFrame, Datum, ExternalDatum
from trajopt_cli.rapid.execution.context import Context, RailPlaces
from trajopt_cli.rapid.execution.named import Modules, check_name
from trajopt_cli.rapid.language.syntax import DataDeclaration, Expression, Name, walk
from trajopt_cli.scenario import condition_key
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind


class CellRailPlaces(RailPlaces):
    """The rail_at of a cell file while a program runs: of a target's point, of the routines that run from the innermost
    on, and of the output that was set last, the first that it names says where the rail stands."""

    def __init__(self, run: Context, modules: Modules):
        """Raises InputError for a name that the program does not have."""
        self._run, self._used, self._last = run, set[str](), ""
        self._given = run.scenario.rail_at
        self._declared = {
            places.span(node.start, node.end): node.name.lower()
            for module, places in modules
            for node in walk(module)
            if isinstance(node, DataDeclaration)
        }
        for key, one in self._given.items():
            name = re.split(r"\W", key, maxsplit=1)[0]
            check_name(modules, name, f"rail_at.{one.name}: the program has no '{name}'", one.place)

    def set(self, signal: str, value: float) -> bool:
        """An output is set; whether that drives the rail."""
        if (key := condition_key(f"{signal}={value:.15g}")) in self._given:
            self._last = key
        return key == self._last

    def fill(self, point: Expression, extax: ExternalAxes) -> ExternalAxes:
        """The external axes [mm or deg] of a target with the rail where the cell file has it."""
        rail = self._run.scenario.rail
        if rail is None or extax[rail.eax] is not None:
            return extax
        key = next((key for key in self._keys(point) if key in self._given), None)
        if key is None:
            return extax
        self._used.add(key)
        return tuple(self._given[key].d / MM if i == rail.eax else old for i, old in enumerate(extax))

    def _keys(self, point: Expression) -> Iterator[str]:
        run = self._run
        yield condition_key(run.text(point))
        for node in walk(point):
            if isinstance(node, Name):
                yield node.name.lower()
                place = run.find(node.name)  # a parameter stands for the data that the caller gives
                is_read = isinstance(place, ExternalDatum)  # and the next reading may give another value
                origin = place.value.origin if isinstance(place, Datum) and not is_read else None
                if origin is not None and origin.declaration is not None:
                    yield self._declared.get(origin.declaration, "")  # none of a module that is loaded later
        frame: CallFrame | None = run.frame
        while frame is not None:
            if frame.routine is not None:
                yield frame.routine.name.lower()
            frame = frame.caller
        yield self._last

    def warn_unused(self) -> None:
        """Tell of the entries that no target took."""
        for key, one in self._given.items():
            if key not in self._used:
                text = f"rail_at in the cell file: no target took {one.name}; those that give a position keep it"
                self._run.warn(WarningKind.UNUSED, text, one.place)
