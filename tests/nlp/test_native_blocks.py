"""Every relation compiled for this computer against CasADi's evaluation of the same functions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest
from heavy_cells import heavy_on_rail
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.limits import CoupledRange
from trajopt_cli.native.machine import machine
from trajopt_cli.nlp.block import Block, Expressed
from trajopt_cli.nlp.block_cache import Library, Maps, library
from trajopt_cli.nlp.formulation import DWELL, JOINTS, Formulation
from trajopt_cli.nlp.interior_point import NlpResult
from trajopt_cli.nlp.mesh_refinement import first_iterate
from trajopt_cli.nlp.transcription import Transcription
from trajopt_cli.path.arc import ArcSymbols
from trajopt_cli.path.line import LineSymbols
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.limits.joint_torque import JointTorque
from trajopt_cli.trajectories.limits.tool_limit import ToolCap, ToolKind, ToolLimit

SIDES = ("l", "r", "lr")
TRACKS = [symbols(turning) for symbols in (LineSymbols, ArcSymbols) for turning in (False, True)]
KINDS: dict[str, list[tuple[object, ...]]] = {
    "node": [(track, sides) for track in (TRACKS[0], TRACKS[-1], JOINTS, DWELL) for sides in SIDES]
    + [(TRACKS[1], "lr"), (TRACKS[2], "lr"), (TRACKS[0], "lr", True), (DWELL, "lr", True)],
    "law_interval": [(10,)],
    "clear_path": [(track,) for track in (TRACKS[0], TRACKS[-1], DWELL)],
}
NO_ARGUMENTS = (
    "integration", "zoned_integration", "zones", "axis_reach", "waypoint", "resting_waypoint", "velocity_link", "equal",
    "tool_chord", "axes_effort", "elapsed", "acceleration_link", "clear_axes", "passed_waypoint",
    "rate_link", "near_point", "sector",
)  # fmt: skip
KINDS |= {name: [()] for name in NO_ARGUMENTS}
LIMITED: dict[str, list[tuple[object, ...]]] = {  # of a plant whose torques and sums of axes are limited
    "limit_node": [
        *((ToolLimit, ToolKind((*ToolCap,), along=True), place, "lr") for place in (JOINTS, TRACKS[0], TRACKS[-1])),
        (JointTorque, tuple(range(7)), TRACKS[-1], "l", True),
        (JointTorque, tuple(range(7)), DWELL, "lr"),
        (JointTorque, tuple(range(7)), JOINTS, "lr"),
    ],
    "sums": [()],
}
KINDS |= LIMITED


@dataclass
class Once:
    """A library to which expressions are written down once, whoever asked first."""

    inner: Library
    written: dict[str, Expressed]
    notice: None = None

    def block(self, name: str, key: str, express: Callable[[], Expressed]) -> Block:
        def known() -> Expressed:
            if key not in self.written:
                self.written[key] = express()
            return self.written[key]

        return self.inner.block(name, key, known)


def compiled_and_not(axes: Axes) -> tuple[Formulation, Formulation]:
    written: dict[str, Expressed] = {}
    return Formulation(axes, Once(library(), written)), Formulation(axes, Once(Maps(), written))


def limited() -> Plant:
    plant = heavy_on_rail(np.eye(4))
    coupled = (CoupledRange(("joint_2", "joint_3"), (1.0, 1.0), -1.0, 1.0, "made up (grade D)"),)
    return replace(plant, limits=replace(plant.limits, coupled=coupled))


PLANTS: dict[str, Callable[[], Plant]] = dict.fromkeys(LIMITED, limited)
both = cache(lambda plant: compiled_and_not(Axes.of(plant())))


def of_axes(arguments: tuple[object, ...], formulation: Formulation) -> tuple[object, ...]:
    """Limits made for the formulation's axes."""
    return tuple(one(formulation.axes) if isinstance(one, type) else one for one in arguments)


def test_no_kind_of_relation_is_left_out() -> None:
    public = {name for name, what in vars(Formulation).items() if callable(what) and not name.startswith("_")}
    assert public == set(KINDS)


@pytest.mark.long
@pytest.mark.parametrize("kind", [*KINDS, "node with turns"])
def test_native_functions_equal_casadis(kind: str) -> None:
    """To 1e-13 of the largest entry, at as many copies as leave lanes without one."""
    rng, n = np.random.default_rng(21), machine().lanes + 3
    name, _, turning = kind.partition(" ")
    for arguments in [(TRACKS[1], "lr"), (DWELL, "l")] if turning else KINDS[kind]:
        pair = both(PLANTS.get(kind, plant_with_rail))
        formulations = [one.with_turns for one in pair] if turning else pair
        ours, casadis = (getattr(one, name)(*of_axes(arguments, one)).block for one in formulations)
        n_z, n_p, m = ours.sizes
        z, p, lam = (rng.uniform(0.2, 1.0, (n, k)) for k in (n_z, n_p, m))
        for got, wanted in zip(
            (*ours.values(z, p), ours.curvature(z, p, lam)),
            (*casadis.values(z, p), casadis.curvature(z, p, lam)),
            strict=True,
        ):
            assert np.all(np.isfinite(wanted))
            assert len(np.unique(wanted, axis=0)) == n or kind in (
                "equal",
                "integration",
                "zones",
                "velocity_link",
                "elapsed",
                "clear_axes",
                "sums",
            )
            np.testing.assert_allclose(got, wanted, rtol=0, atol=1e-13 * np.abs(wanted).max(initial=0.0))


def test_a_program_has_one_answer_whoever_evaluates_it() -> None:
    plant = plant_with_rail()
    axes, moves = Axes.of(plant), "MoveAbsJ j_home,v1000,fine,tool0;MoveJ p_in,v1000,fine,tool0;"
    problem = problem_of(rapid(f"{moves}MoveL p_low,v200,fine,tool0;WaitTime 0.4;"), plant)
    route = search(axes, problem)
    assert route is not None
    cfx = tuple(label.cfx for label in route.labels)
    iterate = first_iterate(axes, problem, route.q, route.w, cfx, route.times)
    margins = [Margins.full(axes, m.N, on_path=True) if hasattr(m, "N") else None for m in iterate.legs]

    def solved(library: Library) -> NlpResult:
        return Transcription(axes, Formulation(axes, library), problem, iterate, margins).nlp.solve(mu=1e-2)

    native, casadis = solved(library()), solved(Maps())
    assert native.converged
    np.testing.assert_allclose(native.x, casadis.x, rtol=0, atol=1e-9)
    assert native.iterations == casadis.iterations
