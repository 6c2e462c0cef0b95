"""The nonlinear program of a problem as CasADi expressions, for anybody's solver."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.nlp.block import MapKernel
from trajopt_cli.nlp.block_cache import Maps
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import Grids, MeshRefinement, first_iterate, on_grid
from trajopt_cli.nlp.transcription import LegVariables, Transcription
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.route import Route


@dataclass(frozen=True, eq=False)
class CasadiProgram:
    """min f(x) subject to lbx <= x <= ubx, lbg <= g(x) <= ubg: `casadi.nlpsol("s", "ipopt", program.nlp)` takes nlp,
    and what that gives takes program.start. x: times [s], path parameters, metres and radians, and derivatives of
    these by the scaled time of a leg; f: the cycle time without programmed waits [s], and a hair of curvature where
    many motions take the same time.

    x_names: "leg 3.T", "leg 3.s[5]", "waypoint 2.q[1]". g_names: a relation of the formulation, which of its copies,
    which of its rows: "path[12][3]".
    """

    nlp: dict[str, ca.MX]
    x0: Array
    lbx: Array
    ubx: Array
    lbg: Array
    ubg: Array
    x_names: tuple[str, ...]
    g_names: tuple[str, ...]
    transcription: Transcription

    @property
    def start(self) -> dict[str, Array]:
        """Arguments of a solver: x0, lbx, ubx, lbg, ubg."""
        return {"x0": self.x0, "lbx": self.lbx, "ubx": self.ubx, "lbg": self.lbg, "ubg": self.ubg}

    def solve(self, tolerance: float | None = None) -> dict[str, Any]:
        """What trajopt's own interior point finds from the same start, as CasADi's solvers give it: x, f, g, lam_x,
        lam_g; and status, in words."""
        found = self.transcription.nlp.solve(
            tolerance=self.transcription.axes.settings.tolerance if tolerance is None else tolerance
        )
        values = ca.Function("values", [self.nlp["x"]], [self.nlp["f"], self.nlp["g"]])
        f, g = values(found.x)
        return {"x": found.x, "f": float(f), "g": np.asarray(g).ravel(), "lam_x": found.lam_x, "lam_g": found.lam_g,
                "status": found.status}  # fmt: skip


def as_casadi(problem: Problem, start: Route | Iterate, intervals: int = 24) -> CasadiProgram:
    """The nonlinear program of a problem, no limit tightened beyond rounding.

    Args:
        problem: of `trajopt_cli.build_problem`.
        start: a route that a search found, `trajopt_cli.graph_search.search.search(Axes.of(problem.plant), problem)`,
            or a candidate motion. It says the branch of the inverse kinematics at every waypoint, and x0.
        intervals: of every line, arc, wait and joint move, a multiple of 6; a motion that is given has its own grids.

    Returns:
        The program; without rows that keep bodies apart.

    Raises:
        ValueError: the robot has no inverse kinematics in closed form, or intervals are no multiple of 6.
    """
    axes = Axes.of(problem.plant)
    if not axes.robot.closed_form:
        raise ValueError(f"as_casadi: {axes.robot.name} has no inverse kinematics in closed form")
    if intervals < 6 or intervals % 6:
        raise ValueError(f"as_casadi: intervals must be a multiple of 6, got {intervals}")
    if isinstance(start, Route):
        start = _from_route(axes, problem, start, intervals)
    refiner = MeshRefinement(axes, Formulation(axes, Maps()), problem, Patience())
    return expressed(refiner.transcription(start, refiner.margins(start)))


def _from_route(axes: Axes, problem: Problem, route: Route, intervals: int) -> Iterate:
    """Parabolas between a route's waypoints, all legs on grids."""
    cfx = tuple(label.cfx for label in route.labels)
    grids = Grids(intervals, intervals)
    joints = frozenset(range(len(problem.legs)))
    iterate = first_iterate(axes, problem, route.q, route.w, cfx, route.times, grids, joints)
    return on_grid(axes, problem, iterate, grids)


def expressed(program: Transcription) -> CasadiProgram:
    """A transcription, whose blocks CasADi evaluates, as expressions."""
    nlp = program.nlp
    x = ca.MX.sym("x", len(nlp.guess))
    rows, names, first = [], list[str](), Counter[str]()
    for block, z, p in nlp.copies():
        assert isinstance(block.g, MapKernel)
        of_all = block.g.function.map(len(z))
        at = ca.reshape(x[z.ravel().tolist()], z.shape[1], z.shape[0])
        rows.append(ca.vec(of_all(at, ca.DM(p.T))))
        copies = range(first[block.name], first[block.name] + len(z))
        names += [f"{block.name}[{i}][{j}]" for i in copies for j in range(len(block.shape.lower))]
        first[block.name] += len(z)
    bounds = nlp.bounds()
    cost, weights = nlp.cost()
    f = ca.dot(ca.DM(cost), x) + ca.dot(ca.DM(weights), x**2) / 2
    return CasadiProgram(
        {"x": x, "f": f, "g": ca.vertcat(*rows)}, nlp.guess, bounds.lower, bounds.upper, bounds.g_lower, bounds.g_upper,
        _names(program, len(nlp.guess)), tuple(names), program,
    )  # fmt: skip


def _names(program: Transcription, count: int) -> tuple[str, ...]:
    names = [f"x[{i}]" for i in range(count)]

    def name(what: str, indices: object) -> None:
        for place, i in np.ndenumerate(np.asarray(indices, dtype=np.intp)):
            names[int(i)] = what + "".join(f"[{k}]" for k in place)

    for k, leg in enumerate(program.legs):
        for part in LegVariables.__dataclass_fields__ if leg is not None else ():
            name(f"leg {k}.{part}", getattr(leg, part))
    for what in ("q", "qd", "qdd"):
        for k, indices in enumerate(getattr(program, f"waypoint_{what}")):
            name(f"waypoint {k}.{what}", indices)
    return tuple(names)
