"""The ladder of plans: from the fastest that is found for a target down to the first that the judge accepts.

1. The initial plan, refined: `solve.optimize`. Where rows of the file would pass a limit, or the judge refuses what is
   driven in a stream, the legs there are mended (plan.repair); where they cannot be, it is the initial plan.
2. The plan of the rung below, which may change less: the RAPID plan for a stream, the program as written for RAPID.
3. The fallback plan, which stops at every point: `solve.slow_plan`.

So cycle times are ordered, stream <= rapid <= as written; `out_of_order` asserts it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Protocol, TypeVar

from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan, Target


class Verdict(Protocol):
    """What the judge says, of whom planners know no more."""

    @property
    def legal(self) -> bool:
        """Whether the plan keeps every limit."""

    @property
    def excesses(self) -> Sequence[tuple[float, float]]:
        """When [s] it is too fast, and by what shares of limits; empty where that is not all that is wrong."""

    @property
    def refusal(self) -> str:
        """Why it is not legal, as the end of a sentence."""


class JudgedPlan(Protocol):
    """A plan with what the judge says of it."""

    @property
    def plan(self) -> Plan:
        """The plan."""

    @property
    def report(self) -> Verdict:
        """What the judge says."""


Judged = TypeVar("Judged", bound=JudgedPlan)

BELOW = {Target.STREAM: "rapid plan", Target.RAPID: "program as written"}
"""Which plan a target can always have, as it may change less."""

_ROUNDING = 1e-6  # of a cycle time: rows are a few of them longer where switches would not stand apart
_NOTHING = 5e-4  # of a cycle time: a saving that is shown as 0.0 %, for which no program is changed


def first_legal(
    target: Target,
    found: Judged | Infeasible | NoPlan,
    below: Plan | None,
    judged: Callable[[Plan], Judged],
    slow_plan: Callable[[str], Plan | None],
) -> Judged | Infeasible | NoPlan:
    """The answer for a target: the plan found for it, that of the rung below, or the fallback plan.

    Args:
        target: whose plan is wanted.
        found: what the planner answered.
        below: a legal plan that may change less; None where there is none.
        judged: writes a plan's rows and has them judged.
        slow_plan: the fallback plan, told why it is wanted; None where there is none.

    Returns:
        The first legal plan of the three; found where none is.
    """
    failure = _failure(target, found)
    if below is not None:
        plan = None if isinstance(found, Infeasible | NoPlan) else found.plan
        better = instead_of(plan, below, target, failure)
        return found if better is None else judged(better)
    if failure is None:
        return found
    slow = slow_plan(
        _said(found) if isinstance(found, Infeasible | NoPlan) else f"the one found {found.report.refusal}"
    )
    if slow is None or slow.duration == 0.0:
        return found
    last = judged(slow)
    return last if last.report.legal else found


def instead_of(plan: Plan | None, below: Plan, target: Target, failure: str | None = None) -> Plan | None:
    """A plan that may change less, as the one of a target; None where the target's own plan is as good.

    Args:
        plan: the target's own, None where there is none.
        below: the other plan, which this target can have as well.
        target: whose plan is wanted.
        failure: why the own plan cannot be had, in words; None where it can.
    """
    if plan is not None and failure is None and not _better(below, plan, target):
        return None
    word = "faster" if below.eased is None else "gentler"
    note = f"the plan is the {BELOW[target]}: {failure or f'nothing {word} was found'}"
    if plan is not None and failure is not None:
        note += f" ({plan.duration:.3f} s; this one takes {below.duration:.3f} s)"
    cut = plan is not None and plan.stopped
    if failure is None and target is Target.RAPID and below.eased is None and not cut:
        note = "the program as written is already the fastest under these limits"
    if plan is None:
        return replace(below, target=target, lower_bound=None, notes=(note,))
    notes = (note, *plan.notes) if target is Target.STREAM or cut else (note,)
    bound, bound_cut = plan.lower_bound, plan.bound_cut
    return replace(
        below, target=target, lower_bound=bound, bound_cut=bound_cut, seconds=plan.seconds, notes=notes, stopped=cut
    )


def out_of_order(plans: Mapping[str, Plan]) -> str | None:
    """What is wrong where a plan takes longer than the next one, which may change less; None where nothing is.

    plans: by name, those that may change most first: stream, rapid, as written.
    """
    for (free, plan), (bound, other) in pairwise(plans.items()):
        if plan.duration > other.duration * (1 + _ROUNDING):
            return (
                f"an error in trajopt: the {free} plan takes {plan.duration:.6f} s, the {bound} plan, which may change "
                f"less, {other.duration:.6f} s"
            )
    return None


def _better(one: Plan, other: Plan, target: Target) -> bool:
    """Whether a plan is faster than another; of two within a given time, whether it is gentler. The program as written
    is where the other one saves nothing that is worth a change."""
    if one.eased is None or other.eased is None:
        worth = _NOTHING if target is Target.RAPID else 0.0
        return other.eased is None and one.duration * (1 - worth) < other.duration
    return one.duration <= other.duration * (1 + _ROUNDING) and one.eased.planned.effort < other.eased.planned.effort


def _failure(target: Target, found: JudgedPlan | Infeasible | NoPlan) -> str | None:
    """Why an answer is no legal plan, in words; None where it is one."""
    if isinstance(found, NoPlan) and found.stopped:
        return found.message
    if isinstance(found, Infeasible | NoPlan):
        return f"no other one was found ({_said(found)}): an error in trajopt; please report it"
    return None if found.report.legal else f"the {target} plan that was found {found.report.refusal}"


def _said(answer: Infeasible | NoPlan) -> str:
    return answer.message if isinstance(answer, NoPlan) else str(answer)
