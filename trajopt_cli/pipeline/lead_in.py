"""What a loop that never ends drives outside its planned cycle, to the targets that the plan for the RAPID controller
leaves: the way into it, once, and passes that differ."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from trajopt_cli.job import Job
from trajopt_cli.motion import Motion, Move, PoseMove, Span, Wait
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.nearest import is_nearest
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.tool_turns import turned_motion
from trajopt_cli.robot.inverse import confdata


def lead_in(job: Job) -> tuple[tuple[Motion, ...], tuple[Motion, ...]]:
    """What runs before the loop, and in it up to the first stop; none where the program is no such loop."""
    before, cycle = job.program.before or (), job.program.motions
    alike = 0
    while alike < min(len(before), len(cycle)) and _text(before[-1 - alike]) == _text(cycle[-1 - alike]):
        alike += 1
    outside, inside = before[: len(before) - alike], before[len(before) - alike :]
    for k, motion in enumerate(inside):
        if isinstance(motion, Move) and (motion.zone.stop or isinstance([*inside, None][k + 1], Wait)):
            return outside, inside[: k + 1]
    return outside, inside


def differing(job: Job) -> tuple[Motion, ...]:
    """The moves behind the cycle that go elsewhere than in it, by the same text."""
    ends = [(_text(one), one.X_WT) for one in job.program.motions if isinstance(one, PoseMove)]
    return tuple(
        one
        for one in job.program.beyond
        if isinstance(one, PoseMove) and not any(_text(one) == text and np.allclose(one.X_WT, X) for text, X in ends)
    )


def starting(plant: Plant, plan: Plan) -> Plant:
    """The plant from where a motion outside a plan begins: where the program does, or else the plan."""
    return plant if plant.home is None else replace(plant, start=plan.motions[0].q_0)


def to_targets(job: Job, plan: Plan, motions: tuple[Motion, ...]) -> tuple[Motion, ...]:
    """Motions outside the cycle to the targets of its plan: each has one rail position and configuration, wherever it
    is gone to."""
    ends = {_text(job.program.motions[planned.index]): planned for planned in reversed(plan.motions)}
    out: list[Motion] = []
    for motion in motions:
        end = ends.get(_text(motion))
        if end is not None and isinstance(motion, PoseMove):
            q, settings = end.q_1, motion.settings
            if not is_nearest(job.plant, end):  # as an export says it
                settings = replace(settings, conf_j=True, conf_l=True)
            extax = job.plant.with_rail(motion.extax, q[job.plant.layout.rail])
            conf = confdata(job.plant.robot, np.asarray(q[job.plant.layout.arm]))
            motion = turned_motion(motion, plan.turns.get(end.index, 0.0))
            assert isinstance(motion, PoseMove)
            motion = replace(motion, extax=extax, conf=conf, settings=settings)
        out.append(motion)
    return tuple(out)


def kept_for(job: Job, changes: Changes, motions: tuple[Motion, ...]) -> Changes:
    """What a plan may change that leaves the targets of some motions of the lead-in as programmed."""
    texts = {_text(motion) for motion in motions}
    shared = frozenset(i for i, one in enumerate(job.program.motions) if _text(one) in texts)
    ties = (tuple(i for i in group if i not in shared) for group in changes.ties)
    return replace(
        changes,
        values=changes.values - shared,
        ties=tuple(group for group in ties if len(group) > 1),
        droppable=changes.droppable - shared,
    )


def _text(motion: Motion) -> Span:
    return motion.written.statement
