"""`trajopt study optimize`: the best point of what a study varies, searched for by optuna on the same cluster."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import optuna
from optuna.trial import TrialState

from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.analysis import ANSWERS, MORE_IS_BETTER
from trajopt_cli.parameter_study.cluster import Evaluate, Pool
from trajopt_cli.parameter_study.point import PointInputs, Row, evaluate, worked_out
from trajopt_cli.parameter_study.results import new_or_same
from trajopt_cli.parameter_study.sampling import Design, Factor, Point
from trajopt_cli.parameter_study.study_file import Study
from trajopt_cli.pipeline.planning import Listener
from trajopt_cli.problem.progress import Progress
from trajopt_cli.runs.files import holding

if TYPE_CHECKING:
    from distributed import Client

_EDGE = 1e-6  # of a distribution's shares: those of Gauss' begin at -infinity
_CONSTRAINT = re.compile(r"([^<>=]+)(<=|>=)([^<>=]+)")
optuna.logging.set_verbosity(optuna.logging.ERROR)


@dataclass(frozen=True)
class Goal:
    """What is searched for. answer: the column that is to be least, of saved_s greatest; over several programs their
    sum. constraints: as `price <= 20000`, of columns and keys, SI. points, seed: of the search. at_once: points tried
    before the search learns from them."""

    answer: str
    constraints: tuple[str, ...] = ()
    points: int = 100
    seed: int = 0
    at_once: int = 8

    def __post_init__(self) -> None:
        if self.answer not in ANSWERS:
            raise InputError(f"no column '{self.answer}' of answers; one of {', '.join(ANSWERS)}")
        for one in self.constraints:
            if not _CONSTRAINT.fullmatch(one):
                raise InputError(f"constraint '{one}': give two expressions with <= or >= between, 'price <= 20000'")

    def excess(self, inputs: PointInputs, point: Point, row: Row) -> list[float]:
        """By how much a point breaks each constraint; 0 or less where it keeps it."""
        out = []
        for one in self.constraints:
            left, sign, right = _CONSTRAINT.fullmatch(one).groups()  # type: ignore[union-attr]
            over = worked_out(left, inputs, point, row) - worked_out(right, inputs, point, row)
            out.append(over if sign == "<=" else -over)
        return out


def search(
    study: Study,
    goal: Goal,
    folder: Path,
    client: Client,
    listen: Listener = lambda *_: None,
    work: Evaluate = evaluate,
) -> Row | None:
    """The best point of what a study varies; None where no point has an answer and keeps the constraints.

    Args:
        study: whose programs, cell and levels these are; its own sampling is not used.
        goal: what is best.
        folder: of the results, as run_study writes them; a search that was stopped goes on.
        client: of a Dask cluster; the answer does not depend on how many workers it has.
        listen: hears how far it is.
        work: makes the row of a point.

    Raises InputError where the folder is of something else, and for constraints that cannot be worked out.
    """
    inputs, programs, sign = study.inputs, len(study.inputs.programs), -1 if goal.answer in MORE_IS_BETTER else 1
    text = f"{study.text.rstrip()}\n# trajopt study optimize: {goal}\n"
    study = replace(study, text=text, design=Design(study.design.factors, programs, "random", goal.points))
    results = new_or_same(folder, study)
    trials = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=goal.seed))
    best: tuple[float, Row] | None = None
    with holding(folder):
        known = {row["point"]: row for row in results.rows().to_pylist()}
        seen = dict[tuple[int, str], Row]()
        for first in range(0, goal.points, goal.at_once):
            asked = [trials.ask() for _ in range(min(goal.at_once, goal.points - first))]
            values = [tuple(x for one in study.design.factors for x in _suggested(trial, one)) for trial in asked]
            points = [
                [Point(program * goal.points + trial.number, program, at) for program in range(programs)]
                for trial, at in zip(asked, values, strict=True)
            ]
            every = [(one, (one.program, repr(one.values))) for some in points for one in some]
            new = {key: one for one, key in reversed(every) if one.index not in known and key not in seen}
            done = [*Pool(client, inputs, work).done(new.values())] if new else []
            known |= (found := {row["point"]: row for one in done for row in one.rows})
            for one, key in every:  # levels that were tried before have the same row
                if key not in seen:
                    seen[key] = known.get(one.index) or known[new[key].index]
                if one.index not in known:
                    known[one.index] = found[one.index] = {**seen[key], "point": one.index}
            if found:
                results.write_part([*found.values()], [timing for one in done for timing in one.timings])
            for trial, own in zip(asked, points, strict=True):
                value = _tell(trials, trial, goal, inputs, [(one, known[one.index]) for one in own], sign)
                if value is not None and (best is None or value < best[0]):
                    best = value, known[own[0].index]
            said = f"{first + len(asked)} of {goal.points} points"
            listen("search", Progress(said, None if best is None else sign * best[0]))
        results.finish()
    return None if best is None else best[1]


def _suggested(trial: optuna.Trial, factor: Factor) -> tuple[Any, ...]:
    """What the keys of a factor take in a trial."""
    if factor.quantile is not None:
        return factor.at(trial.suggest_float(factor.written, _EDGE, 1 - _EDGE))
    levels = factor.levels
    if all(isinstance(one, int | float) and not isinstance(one, bool) for level in levels for one in level):
        return levels[trial.suggest_int(factor.written, 0, len(levels) - 1)]  # near levels give near answers
    return levels[trial.suggest_categorical(factor.written, range(len(levels)))]


def _tell(
    trials: optuna.Study, trial: optuna.Trial, goal: Goal, inputs: PointInputs, own: list[tuple[Point, Row]], sign: int
) -> float | None:
    """Tell optuna what a trial came to; its value, less is better, where it has one and keeps the constraints."""
    values = [row[goal.answer] for _, row in own if row["status"] == "ok" and row[goal.answer] is not None]
    every = [goal.excess(inputs, *one) for one in own] if len(values) == len(own) else []
    excess = [max(one) for one in zip(*every, strict=True)] if every else [math.inf] * len(goal.constraints)
    for name, amount in zip(goal.constraints, excess, strict=True):
        trial.set_constraint(name, amount)
    if not every:
        trials.tell(trial, state=TrialState.PRUNED)
        return None
    trials.tell(trial, sign * sum(values))
    return sign * sum(values) if all(one <= 0 for one in excess) else None
