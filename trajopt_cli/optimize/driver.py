"""From a chain of waypoints to a clean plan: nested grids, then the exchange loop."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from time import perf_counter
from typing import Any

import numpy as np

from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.blocks import NlpResult
from trajopt_cli.optimize.draft import Draft, Margins
from trajopt_cli.optimize.exchange import back_off, check_leg
from trajopt_cli.optimize.formulation import Formulation
from trajopt_cli.optimize.legs import JointNodes, JointProfiles, LegMotion, PathLeg, parabola
from trajopt_cli.optimize.profiles import hold
from trajopt_cli.optimize.reading import read
from trajopt_cli.optimize.search import Chain
from trajopt_cli.optimize.transcription import Transcription
from trajopt_cli.optimize.tuning import (
    BARRIER_COLD,
    BARRIER_DOUBT,
    BARRIER_FIRST,
    BARRIER_REFINED,
    BARRIER_WARM,
    EXACT,
    FIRST,
    GRID_JOINT,
    LAST,
    LAST_ALONE,
    LEAST_DRAFT,
    MOST_ITERATIONS,
    NEAR_CAP,
    OVER,
    ROUGH,
    ROUNDS,
    SAFE,
    SHARP,
    START,
)
from trajopt_cli.path.line import Line
from trajopt_cli.problem.problem import LegKind, Problem


def first_draft(axes: Axes, problem: Problem, chain: Chain) -> Draft:
    """Rest-to-rest parabolas between the chain's waypoints."""
    legs: list[LegMotion | None] = []
    for k, leg in enumerate(problem.legs):
        q_0, q_1 = chain.q[k], chain.q[k + 1]
        T = max(float(chain.times[k]), LEAST_DRAFT)
        if leg.kind is LegKind.JOINT:
            legs.append(JointProfiles(T, q_0, chain.w[k], np.zeros((axes.n, 4)), np.zeros((axes.n, 3))))
            continue
        if leg.kind is LegKind.DWELL and not leg.rail_moves:
            legs.append(hold(leg.duration or 0.0, q_0))
            continue
        grid = np.linspace(0, 1, FIRST + 1)
        s, v, a = parabola(grid)
        d_0, joints = q_0[axes.layout.rail], q_0[axes.layout.arm]
        way = q_1[axes.layout.rail] - d_0
        d, w, b = d_0 + way * s[:, None], way * v[:, None], way * a[:, None]
        X_WT = problem.waypoints[k].X_WF @ leg.X_FT
        cfx = chain.labels[k].cfx if chain.labels[k].cfx >= 0 else chain.labels[k + 1].cfx
        legs.append(PathLeg(T, leg.segment or Line(X_WT, X_WT), leg.X_FT, cfx, joints, grid, s, v, a, d, w, b))
    return Draft(chain.q, chain.w, tuple(label.cfx for label in chain.labels), tuple(legs))


class NotConverged(Exception):
    """The nonlinear program found no clean answer from this start; the message is the solver's word."""


class Refiner:
    """Solves one target of one problem from a chain."""

    def __init__(self, axes: Axes, formulation: Formulation, problem: Problem):
        self.axes, self.formulation, self.problem = axes, formulation, problem
        self.last = LAST_ALONE if len(problem.legs) == 1 else LAST
        self.seconds = {"build": 0.0, "solve": 0.0, "check": 0.0}

    def _solve(
        self, draft: Draft, margins: list[Margins | None], mu: float, tolerance: float = SHARP,
        warm: Sequence[Any] | None = None,
    ) -> tuple[Draft, Transcription, NlpResult | None]:  # fmt: skip
        start = perf_counter()
        t = Transcription(self.axes, self.formulation, self.problem, draft, margins)
        if t.nlp.empty:
            return read(t, t.nlp.guess), t, None
        if warm is None:
            t.nlp.build()
        else:
            t.nlp.adopt(warm[0].nlp)
        middle = perf_counter()
        result = t.nlp.solve(warm[1] if warm else None, mu=mu, tolerance=tolerance, most=MOST_ITERATIONS)
        self.seconds["build"] += middle - start
        self.seconds["solve"] += perf_counter() - middle
        try:
            out = read(t, result.x) if result.converged else draft
        except ValueError as odd:  # a joint move whose switches cannot be told apart in a file
            raise NotConverged(str(odd)) from odd
        if not result.converged:
            raise NotConverged(result.status)
        return out, t, result

    def run(self, draft: Draft, progress: Callable[[str], None]) -> Draft:
        """From a draft on its grid to the clean draft with the shortest time found. Raises NotConverged."""
        margins: list[Margins | None] = [
            Margins.full(m.N, self.axes.n, START) if isinstance(m, PathLeg) else None for m in draft.legs
        ]
        draft, warm = self._first(draft, margins)
        while True:
            progress("solve")
            good = draft, margins, warm
            n = max((m.N for m in draft.legs if isinstance(m, PathLeg)), default=self.last)
            opened = self._open_grids(draft, margins)
            if n >= self.last and not opened:
                break
            draft = self._with_grids(draft, margins)
            if n < self.last:
                margins = [
                    m.refined() if m and isinstance(leg, PathLeg) else m
                    for m, leg in zip(margins, draft.legs, strict=True)
                ]
                draft = replace(draft, legs=tuple(m.refined() if isinstance(m, PathLeg) else m for m in draft.legs))
            if opened:
                self._watch(draft, margins)
            try:
                draft, *warm = self._solve(draft, margins, BARRIER_REFINED, SHARP if 2 * n >= self.last else ROUGH)
            except NotConverged:
                # the coarser grid's answer is a motion too; cleaned, it is only a little slower
                draft, margins, warm = good
                break
        return self._exchange(draft, margins, warm, progress)

    def _first(self, draft: Draft, margins: list[Margins | None]) -> tuple[Draft, list[Any]]:
        """The first solve: a rough one from estimates, a sharp one from a draft already on the last grid."""
        n = max((m.N for m in draft.legs if isinstance(m, PathLeg)), default=FIRST)
        mu, tolerance = (BARRIER_REFINED, SHARP) if n >= self.last else (BARRIER_FIRST, ROUGH)
        try:
            out, *warm = self._solve(draft, margins, mu, tolerance)
        except NotConverged:
            out, *warm = self._solve(draft, margins, BARRIER_DOUBT, tolerance)
        return out, warm

    def _exchange(
        self, draft: Draft, margins: list[Margins | None], warm: Sequence[Any],
        progress: Callable[[str], None],
    ) -> Draft:  # fmt: skip
        """Check densely, back_off where a limit is passed, solve again, until nothing is passed."""
        for _ in range(ROUNDS):
            start = perf_counter()
            worst, changed, opened = 0.0, False, self._open_grids(draft, margins)
            draft = self._with_grids(draft, margins)
            for leg, motion, m in zip(self.problem.legs, draft.legs, margins, strict=True):
                if motion is None:
                    continue
                ratios = check_leg(self.axes, leg, motion)
                worst = max(worst, ratios.worst)
                if m is not None:
                    resting = leg.kind is LegKind.DWELL and leg.duration is not None
                    rail = self.axes.acceleration_on(leg)[self.axes.layout.rail] if resting else None
                    changed |= back_off(m, ratios, motion, SAFE, rail)
            self.seconds["check"] += perf_counter() - start
            if not (changed or opened):
                return draft
            if self._watch(draft, margins, SAFE) or opened:
                draft, *warm = self._solve(draft, margins, BARRIER_REFINED)
            else:
                try:
                    draft, *warm = self._solve(draft, margins, BARRIER_WARM, warm=warm)
                except NotConverged:  # a warm start keeps to the limits it knows; a cold one finds its way round
                    draft, *warm = self._solve(draft, margins, BARRIER_COLD)
            progress("exchange")
        raise NotConverged(f"a limit is still passed by {worst - 1:.2e} after {ROUNDS} rounds of tightening")

    def _open_grids(self, draft: Draft, margins: list[Margins | None]) -> bool:
        """Joint moves whose closed-form profiles break a tool cap or a range go on a grid."""
        start = perf_counter()
        opened = False
        for k, (leg, motion) in enumerate(zip(self.problem.legs, draft.legs, strict=True)):
            if leg.kind is LegKind.JOINT and isinstance(motion, JointProfiles):
                ratios = check_leg(self.axes, leg, motion)
                if max(np.max(ratios.tool), np.max(ratios.position)) > 1 + OVER:
                    margins[k] = Margins.full(GRID_JOINT, self.axes.n, EXACT)
                    opened = True
        self.seconds["check"] += perf_counter() - start
        return opened

    def _watch(self, draft: Draft, margins: list[Margins | None], share: float = NEAR_CAP) -> bool:
        """Put tool caps in force at nodes of gridded joint moves that use this share of them; True when any is new."""
        added = False
        for k, (leg, motion) in enumerate(zip(self.problem.legs, draft.legs, strict=True)):
            m = margins[k]
            if isinstance(motion, JointNodes) and m is not None:
                near = check_leg(self.axes, leg, motion).tool > share
                rows = np.zeros_like(m.rows)
                rows[:-1] |= near
                rows[1:] |= near
                added |= bool(np.any(rows & ~m.rows))
                m.rows |= rows
        return added

    def _with_grids(self, draft: Draft, margins: list[Margins | None]) -> Draft:
        legs = list(draft.legs)
        for k, motion in enumerate(legs):
            m = margins[k]
            if isinstance(motion, JointProfiles) and m is not None:
                legs[k] = self._on_grid(motion, len(m.tool) - 1)
        return replace(draft, legs=tuple(legs))

    def _on_grid(self, motion: JointProfiles, N: int) -> JointNodes:
        grid = np.linspace(0, 1, N + 1)
        sample = motion.sample(self.axes, grid * motion.T)
        v = sample.qd * motion.T
        return JointNodes(motion.T, grid, sample.q, v, np.diff(v, axis=0) * N)
