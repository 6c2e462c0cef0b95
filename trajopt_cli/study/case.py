"""What a baseline is given, and what it gives back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from trajopt_cli.motion import Move, Program
from trajopt_cli.problem.decision_scope import Freedom
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG

# The optimiser as baselines see it: a program, a target, what may change. The user's own program may change as far as
# `optimize` would change it; one that a baseline makes is written back by nobody, so there the freedom says all.
Solve = Callable[[Program, Target, Freedom], Plan | Infeasible]


@dataclass(frozen=True)
class RailRule:
    """How the thesis' heuristic may drive the rail.

    phi_min [rad]: least angle of joint 3 from the stretched elbow at a work point (the thesis names no value).
    v_transfer, v_area: V_Dmax between functional areas and V_Dfmax inside one [m/s], the rail's own limit for None.
    """

    phi_min: float = 10 * DEG
    v_transfer: float | None = None
    v_area: float | None = None


@dataclass(frozen=True, eq=False)
class Case:
    """A program on its plant, and the optimiser for those baselines that need one. Equal questions to solve are
    answered once. rule: for the row that goes by it."""

    program: Program
    plant: Plant
    solve: Solve
    rule: RailRule = RailRule()

    @property
    def gives_rail(self) -> bool:
        """Whether the program itself says where the rail stands; a robot without a rail needs no word of it."""
        moves = (motion for motion in self.program.motions if isinstance(motion, Move))
        return not self.plant.rail_eaxes or any(self.plant.asks_rail(move.extax) for move in moves)


@dataclass(frozen=True, eq=False)
class Attempt:
    """A motion a baseline stands for. program: what it carries out, the user's or one with moves the baseline adds.

    plan: the optimiser's, where it made the motion. notes: what a reader must know to compare it, one line each.
    """

    program: Program
    trajectory: Trajectory
    plan: Plan | None = None
    notes: tuple[str, ...] = ()

    @property
    def dropped(self) -> tuple[int, ...]:
        """Indices of the motions it leaves out."""
        return () if self.plan is None else tuple(motion.index for motion in self.plan.motions if motion.dropped)


@dataclass(frozen=True)
class NotApplicable:
    """Why a baseline says nothing about this program, one line."""

    why: str


Answer = Attempt | Infeasible | NotApplicable


def planned(program: Program, answer: Plan | Infeasible, notes: tuple[str, ...] = ()) -> Attempt | Infeasible:
    """The optimiser's answer for program as a baseline's."""
    return answer if isinstance(answer, Infeasible) else Attempt(program, answer.trajectory, answer, notes)
