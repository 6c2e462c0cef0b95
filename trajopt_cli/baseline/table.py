"""The rows of `compare baseline`, read top to bottom; a saving is counted against the first row that is legal."""

from __future__ import annotations

from dataclasses import dataclass

from trajopt_cli.problem.freedom import AS_WRITTEN, EVERYTHING, FIXED_RAIL, Freedom, RailFreedom
from trajopt_cli.problem.plan import Target


@dataclass(frozen=True)
class Baseline:
    """target: the machine that executes it. freedom: what the plan may change. title: what that means, in a line."""

    target: Target
    freedom: Freedom
    title: str

    @property
    def needs_programmed_rail(self) -> bool:
        """True when the program itself has to say where the rail stands."""
        return self.freedom.rail is RailFreedom.PROGRAMMED

    @property
    def optimum(self) -> bool:
        """True when everything is free, so that the plan's lower bound is one for every plan of this target."""
        return self.freedom == EVERYTHING


BASELINES: dict[str, Baseline] = {
    "as-written": Baseline(Target.RAPID, AS_WRITTEN, "the program's own rail positions and configurations"),
    "fixed-rail": Baseline(Target.STREAM, FIXED_RAIL, "the best rail position per station, the rail still there"),
    "optimum rapid": Baseline(Target.RAPID, EVERYTHING, "everything free that the controller can execute"),
    "optimum stream": Baseline(Target.STREAM, EVERYTHING, "everything free that a joint stream can carry"),
}
