"""The interpreter: runs a program's entry procedure once, and keeps which statements its motions come from.

What expressions, statements and calls do is in evaluate.py, statements.py and calls.py; what instructions and functions
do is in the tables of instructions and functions, whose handlers take a Context and know no interpreter.
"""

from __future__ import annotations

from contextlib import suppress

from trajopt_cli.errors import InputError
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.rapid.data.datatypes import Array, Value, convertible, is_opaque
from trajopt_cli.rapid.data.errors import Exit
from trajopt_cli.rapid.data.scope import CallFrame, ModuleScope, Part, Place
from trajopt_cli.rapid.execution import calls, statements
from trajopt_cli.rapid.execution import evaluate as expressions
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.endless import cycle_of
from trajopt_cli.rapid.execution.instructions.settings import publish
from trajopt_cli.rapid.execution.operators import computed
from trajopt_cli.rapid.execution.recursion_limit import room
from trajopt_cli.rapid.execution.rests import count_rests
from trajopt_cli.rapid.language.syntax import Expression, Node, Routine
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind


class Execution(Context):
    """One execution of a program."""

    evaluate = expressions.evaluate
    number = expressions.number
    integer = expressions.integer
    condition = expressions.condition
    locate = expressions.locate
    block = statements.run_block
    call_function = calls.function
    knows = calls.knows

    def __init__(self, scenario: Scenario, kinematics: Kinematics | None = None):
        super().__init__(scenario, kinematics)
        publish(self)

    def call_procedure(self, node: Node, name: str) -> None:
        """See Context."""
        calls.call_by_name(self, node, name, ())

    def start(self, routine: Routine, scope: ModuleScope) -> None:
        """Run the entry procedure, which stands in scope, once. Raises InputError for what cannot be run."""
        if any(not parameter.optional for parameter in routine.parameters):
            message = f"PROC {routine.name} needs arguments, so the program cannot start with it"
            raise scope.places.error(routine.start, message)
        wanted, failure = self.scenario.endless_passes or 1, None
        try:
            with self.inside(CallFrame(scope)), room(), suppress(Exit):
                calls.enter(self, routine, scope, (), routine)
        except InputError as error:
            if not any(passes.count > wanted and not passes.leaves for passes in self.endless.values()):
                raise
            failure = error
        self.position.place()
        count_rests(self.motions)
        endless = (one for one in reversed(self.endless.values()) if one.count >= wanted and not one.leaves)
        if (passes := next(endless, None)) is not None:
            self.cycle = cycle_of(self, passes, failure)
        if not self.external.missing:
            for sentence in self.external.unused():
                self.warn(WarningKind.UNUSED, sentence)
        if self.cycle is not None:
            end = max(self.cycle.last, self.cycle.beyond)
            del self.motions[end:], self.links[end:]

    def store(self, place: Place, target: Expression, value: Value) -> None:
        """As assign, for data that is located already; target is where errors are placed."""
        type_ = place.type
        if place.constant:
            raise self.error(target, f"{self.text(target)} is {place.constant} and cannot be changed")
        if value.type is not type_:
            if not convertible(type_, value.type):
                raise self.error(target, f"{self.text(target)} is a {type_.name}, and the value a {value.type.name}")
            value = Value(type_, value.data, value.origin)
        if value.origin is None and type(type_) is not Array and not is_opaque(type_):  # arrays are only copied
            value = computed(self, target, type_, value.data)
        if type(place) is Part:
            whole: Place = place
            while type(whole) is Part:
                whole = whole.base
                self.spend(target, len(whole.value.data))
        place.value = value
