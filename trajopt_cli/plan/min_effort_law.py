"""The law of least effort that drives a path in a given time: a small nonlinear program over the rates at its nodes.

With x the squared rate and u its half slope the effort of an interval is a square of what is linear in u and x over the
sum of two roots of x: convex; so is the time, and every limit is linear. The program is solved in the rates, where it
is smooth at the stops, too; what it finds is the least on the nodes.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.nlp_assembly import BlockNlp
from trajopt_cli.path_timing.path_timing import PathMargins, in_force, time_optimal_law
from trajopt_cli.path_timing.sampled_path import SampledPath
from trajopt_cli.problem.problem import Problem
from trajopt_cli.timing.topp import TimeLaw
from trajopt_cli.trajectories.axes import Axes

_SPARE = 1e-4  # share of a law's time that is left before a gentler one is looked for


def min_effort_law(
    axes: Axes, formulation: Formulation, problem: Problem, path: SampledPath, margins: PathMargins, seconds: float
) -> TimeLaw | None:
    """The law of a run's path that takes so many seconds with the least effort, from rest to rest; None where it
    takes longer, or hardly less, as fast as may be."""
    settings = axes.settings
    fast = time_optimal_law(axes, problem, path, margins)
    if fast is None or fast.duration > seconds * (1 - _SPARE):
        return None
    start = fast.slowed(seconds / fast.duration)
    top, begins, ends = in_force(axes, problem, path, margins)
    # the unit of sigma is the whole way, that of time the seconds, that of effort what the fast law has of it
    L, N = float(path.sigma[-1]), len(path.part)
    steps, rate, slope, bend = np.diff(path.sigma) / L, L / seconds, L / seconds**2, (L / seconds) ** 2
    r_0, t_0 = start.rates / rate, start.times / seconds
    dq, ddq = path.along.dq / axes.acceleration * slope, path.along.ddq / axes.acceleration * bend
    squared = np.column_stack([np.sum(x * y, axis=1) for x, y in ((dq, dq), (dq, ddq), (ddq, ddq))])
    squared_0, squared_1 = squared[path.first], squared[path.first + 1]
    x, u = r_0**2, np.diff(r_0**2) / (2 * steps)
    mean = (_square(squared_0, u, x[:-1]) + _square(squared_1, u, x[1:])) / 2
    effort = np.diff(t_0) * mean
    whole = float(effort.sum())
    if not whole:
        return None
    nlp = BlockNlp()
    most = top / rate * np.r_[0.0, np.ones(N - 1), 0.0]
    r = nlp.variables(np.minimum(r_0, most), 0.0, most)
    t = nlp.variables(t_0, np.r_[np.zeros(N), 1.0], np.r_[0.0, np.ones(N)])
    e = nlp.variables(effort / whole, 0.0, np.inf)
    for one in e:
        nlp.minimise(int(one))
    p = {"step": steps, "squared_0": squared_0 / whole, "squared_1": squared_1 / whole}
    for end, (slopes, bends, rest) in enumerate((begins, ends)):
        room = 1 - np.abs(rest)  # of both signs of a torque the less, as these rows are symmetric
        p |= {f"slope_{end}": slopes * slope / room, f"bend_{end}": bends * bend / room}
    z = {"r_0": r[:-1], "r_1": r[1:], "t_0": t[:-1], "t_1": t[1:], "e": e}
    formulation.law_interval(begins[0].shape[1]).holds(nlp, z, p)
    result = nlp.solve(mu=settings.barrier_refined, tolerance=settings.tolerance, most=settings.most_iterations)
    if not result.converged:
        return None
    law = TimeLaw(path.sigma, result.x[r] * rate)
    return law.slowed(seconds / law.duration)


def _square(squared: Array, u: Array, x: Array) -> Array:
    return squared[:, 0] * u**2 + 2 * squared[:, 1] * u * x + squared[:, 2] * x**2
