"""The rows of `compare baseline`, read top to bottom; a saving is counted against the first row that is legal."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL, Freedom, RailFreedom
from trajopt_cli.problem.plan import Target
from trajopt_cli.study.cartesian import bang_bang_row
from trajopt_cli.study.case import Answer, Case, NotApplicable, planned
from trajopt_cli.study.practice import practice
from trajopt_cli.study.ruckig_row import ruckig, ruckig_jerk
from trajopt_cli.study.thesis import thesis
from trajopt_cli.study.toppra_row import sampled_turn, toppra


@dataclass(frozen=True)
class Baseline:
    """target: the machine that executes it. title: what it is. moves: what it lets move. make: its motion.

    freedom: of a row that is the program itself under one freedom, None of one that makes a motion of its own. after:
    the row whose plan such a motion starts from, so that it is solved once.
    """

    target: Target
    title: str
    moves: str
    make: Callable[[Case], Answer]
    freedom: Freedom | None = None
    after: str | None = None

    @property
    def optimum(self) -> bool:
        """Whether everything is free, so that the plan's lower bound is one for every plan of this target."""
        return self.freedom == EVERYTHING


def solved(target: Target, freedom: Freedom) -> Callable[[Case], Answer]:
    """A row that is the program itself under one freedom."""

    def make(case: Case) -> Answer:
        if freedom.rail is RailFreedom.PROGRAMMED and not case.gives_rail:
            return NotApplicable("the program gives the rail no position")
        return planned(case.program, case.solve(case.program, target, freedom))

    return make


def _free(target: Target, freedom: Freedom, title: str, moves: str) -> Baseline:
    return Baseline(target, title, moves, solved(target, freedom), freedom)


SAMPLED = "sampled turn"
"""The row that is there only where a tool is free about its axis."""

_RAPID, _STREAM = Target.RAPID, Target.STREAM
_timed = partial(Baseline, _STREAM, after="fixed-rail")  # the fixed-rail plan's path, timed by others

BASELINES: dict[str, Baseline] = {
    "as-written": _free(_RAPID, AS_WRITTEN, "the program's own rail positions and configurations", "timing"),
    "practice": Baseline(_RAPID, "today: home, the rail alone, the arm works", "timing", practice),
    "bang-bang": _timed(
        "generator of Krotký's thesis (2014) on Cartesian axes, no joint limits", "timing", bang_bang_row
    ),
    "thesis": Baseline(
        _RAPID, "rail heuristic of Krotký's thesis (2014), legs timed under all limits", "rail by rule", thesis
    ),
    "fixed-rail": _free(
        _STREAM, FIXED_RAIL, "the best rail position per station, the rail still there", "rail per station, branch"
    ),
    "ruckig": _timed("Ruckig from stop to stop at the fixed rail's positions, jerk free", "timing", ruckig),
    "ruckig jerk": _timed("the same under the profile's jerk limits", "timing", ruckig_jerk),
    "toppra": _timed("the fixed-rail plan's path timed by TOPP-RA", "timing along a path", toppra),
    SAMPLED: Baseline(
        _STREAM, "free tools turned by a ladder graph (Descartes), timed by TOPP-RA", "tool turn, timing", sampled_turn
    ),
    "optimum rapid": _free(_RAPID, EVERYTHING, "everything free that the controller can execute", "everything"),
    "optimum stream": _free(_STREAM, EVERYTHING, "everything free that a joint stream can carry", "everything"),
}
