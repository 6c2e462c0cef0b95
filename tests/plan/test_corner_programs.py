"""The shipped programs with corners and arcs, planned whole: legal, parabolas where a closed form says, never slower
for larger zones."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.geometry import Array
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Move, MoveJ, MoveL, Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, Freedom
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.rapid.zones import stopped_fly_bys
from trajopt_cli.trajectory import hermite

PROGRAMS = Path(__file__).parents[2] / "programs"
MM = 1e-3
TINY = "PERS zonedata z_tiny:=[FALSE,0.03,0.03,0.03,0.003,0.03,0.003];"
RADII = {"z_tiny": 0.03, "z0": 0.3, "z1": 1.0, "z50": 50.0}
SHIPPED = ["bench_irb140", "corners", "contour", "arcs"]


@cache
def program_of(name: str, zone: str | None = None) -> tuple[Program, Plant]:
    """A shipped program; with every fly-by zone as another one, and then with every third point of the cam."""
    cell = load_cell(PROGRAMS / f"{name}.yaml")
    text = (PROGRAMS / f"{name}.mod").read_text(encoding="utf-8")
    text = re.sub(r"MODULE (\w+)\n", rf"MODULE \1\n{TINY}\n", text, count=1)
    if zone is not None:
        text, count = re.subn(r"(, v\d+(?:\\T:=[\d.]+)?, )z\w+(?:\\Z:=\d+)?(?=, t)", rf"\g<1>{zone}", text)
        assert count
        text = text.replace("steps:=60", "steps:=20")
    return run_program([TextFile(f"{name}.mod", text, "utf-8")], cell.scenario), build_plant(cell)


@cache
def plan_of(name: str, zone: str | None = None, freedom: Freedom = AS_WRITTEN) -> Plan:
    program, plant = program_of(name, zone)
    plan = optimize(program, plant, Target.RAPID, freedom, bounded=False)
    assert isinstance(plan, Plan), plan
    return plan


@pytest.mark.parametrize("name", SHIPPED)
def test_plans_of_the_shipped_programs_are_legal(name: str) -> None:
    plan = plan_of(name, freedom=AS_WRITTEN if name == "arcs" else EVERYTHING)
    report = verify(*program_of(name), plan.trajectory, target=Target.RAPID, advice=False)
    assert [f"{f.check} {f.subject} {f.value} > {f.limit}" for f in report.findings if not f.passed] == []


@pytest.mark.parametrize("name", SHIPPED[1:])  # few of the first one's points are passed
def test_a_larger_zone_is_never_slower(name: str) -> None:
    """With the rail where the program has it: a free one is chosen anew for every zone, by a search that is local."""
    times = [plan_of(name, zone).duration for zone in ("fine", "z1", "z50")]
    assert all(later <= earlier + 1e-4 for earlier, later in pairwise(times)), times
    assert times[-1] < times[0] - 0.1


def corners_of_lines(name: str, zone: str) -> list[tuple[int, Array, Array, Array]]:
    """Fly-bys between two lines: index and the points before, at and behind them in the world [m]."""
    program, _ = program_of(name, zone)
    moves = [i for i, motion in enumerate(program.motions) if isinstance(motion, Move)]
    stops = stopped_fly_bys(program)
    out = []
    for a, b, c in zip(moves, moves[1:], moves[2:], strict=False):
        first, here, last = (program.motions[i] for i in (a, b, c))
        if not (isinstance(first, MoveJ | MoveL) and isinstance(here, MoveL) and isinstance(last, MoveL)):
            continue
        if not here.zone.stop and b not in stops:
            out.append((b, first.X_WT[:3, 3], here.X_WT[:3, 3], last.X_WT[:3, 3]))
    return out


@pytest.mark.parametrize("zone", ["z1", "z50"])
@pytest.mark.parametrize("name", ["corners", "contour"])
def test_the_tool_passes_the_middle_of_each_parabola(name: str, zone: str) -> None:
    """P + r (e2 - e1) / 4 at the middle of the corner, r the zone's radius or half the shorter of the ways beside P.

    z50 is more than half of every way of the contour, and of most in the other program.
    """
    program, plant = program_of(name, zone)
    plan = plan_of(name, zone)
    t_1 = {motion.index: motion.t_1 for motion in plan.motions}
    found = corners_of_lines(name, zone)
    assert len(found) >= {"corners": 4, "contour": 19}[name]
    for index, before, here, behind in found:
        ways = here - before, behind - here
        lengths = [float(np.linalg.norm(way)) for way in ways]
        e_1, e_2 = (way / length for way, length in zip(ways, lengths, strict=True))
        r = min(RADII[zone] * MM, *(length / 2 for length in lengths))
        q = hermite(plan.trajectory, np.array([t_1[index]]))[0]
        motion = program.motions[index]
        assert isinstance(motion, MoveL)
        place = (plant.robot.forward(q) @ motion.tool.X_FT)[0, :3, 3]
        np.testing.assert_allclose(place, here + r * (e_2 - e_1) / 4, rtol=0, atol=2e-8)


def tool_path(name: str, zone: str) -> Array:
    """Where the tool is at every row (m, 3) [m]."""
    program, plant = program_of(name, zone)
    tool = next(motion.tool for motion in program.motions if isinstance(motion, MoveL))
    return np.asarray((plant.robot.forward(plan_of(name, zone).trajectory.q) @ tool.X_FT)[:, :3, 3])


def away_from(points: Array, path: Array) -> Array:
    """Distance of each of points (m, 3) from a polyline (n, 3), by the segments beside its nearest vertices."""
    _, near = cKDTree(path).query(points, k=4)
    best = np.full(len(points), np.inf)
    for shift in (-1, 0):
        a, b = path[np.clip(near + shift, 0, len(path) - 2)], path[np.clip(near + shift, 0, len(path) - 2) + 1]
        way = b - a
        share = np.sum((points[:, None] - a) * way, axis=2) / np.maximum(np.sum(way**2, axis=2), 1e-30)
        foot = a + np.clip(share, 0, 1)[..., None] * way
        best = np.minimum(best, np.linalg.norm(points[:, None] - foot, axis=2).min(axis=1))
    return best


def test_as_zones_shrink_the_path_becomes_that_of_the_stops() -> None:
    """Corners between MoveJ, MoveL and MoveAbsJ in all orders; rows are 1 ms apart, their chords 2 um off a bow.

    A parabola is at most half a radius off its ways, where they turn back.
    """
    stops = tool_path("corners", "fine")
    away = {zone: away_from(tool_path("corners", zone), stops).max() for zone in ("z1", "z0", "z_tiny")}
    for zone, most in away.items():
        assert most <= RADII[zone] * MM / 2 + 2e-6
    assert 5 * away["z_tiny"] < away["z0"] < away["z1"] / 2
    times = [plan_of("corners", zone).duration for zone in ("fine", "z_tiny", "z0")]
    assert times[0] >= times[1] >= times[2]


@pytest.mark.long
def test_a_program_of_stops_is_no_slower_than_it_was() -> None:
    """What it took for the RAPID controller before corners were planned; that of hinge_cell the manual shows."""
    assert plan_of("hinge_line", freedom=EVERYTHING).duration <= 12.437 + 5e-4
