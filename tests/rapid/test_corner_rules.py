"""Zones of random programs against the manual's rules, worked out from the numbers the programs are written with.

RAPID reference manual, zonedata and Positioning during program execution: half of the shorter way; the extended zones
at least as large, by the smallest share; degrees between turns in place; none from or to one; joint interpolation where
tool or work object change.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin
from random import Random

import numpy as np
import pytest

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.motion import FlyBy, Program, TextFile
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.rapid.zones import effective_radii, fly_bys, stopped_fly_bys

TOOLS = {"a": (0, 0, 100), "a2": (0, 0, 100), "b": (30, 0, 140)}  # mm; a and a2 are one centre point
FRAMES = {"w": (400, 0, 300, 0), "w2": (400, 0, 300, 0), "v": (420, 30, 300, 20), "t": (400, 0, 300, 20)}
# mm, deg; w and w2 are one frame
ZONES = {  # tcp, ori, eax [mm], ori [deg], leax [mm]
    "z10": (10, 15, 15, 1.5, 15),
    "z50": (50, 75, 75, 7.5, 75),
    "[FALSE,20,40,60,4,60,4]": (20, 40, 60, 4, 60),
    "[FALSE,5,60,60,0,0,0]": (5, 60, 60, 0, 0),
    "[FALSE,0,0,0,9,0,0]": (0, 0, 0, 9, 0),
}


@dataclass(frozen=True)
class Step:
    """A move as the test writes it: where the tool goes in its work object [mm], how it is turned about z [deg]."""

    kind: str
    p: tuple[float, float, float]
    turn: float
    tool: str
    frame: str
    zone: str

    @property
    def text(self) -> str:
        half = self.turn * pi / 360
        q = f"[0,{-sin(half):.12f},{cos(half):.12f},0]"
        where = f"[[{self.p[0]},{self.p[1]},{self.p[2]}],{q},[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
        return f"{self.kind} {where},v100,{self.zone},{self.tool}\\WObj:={self.frame};"

    @property
    def X_WT(self) -> Array:
        """The tool in the world; it points down."""
        x, y, z, deg = FRAMES[self.frame]
        X_WO = pose(rotation_about([0, 0, 1], np.radians(deg)), [x, y, z])
        down = rotation_about([0, 0, 1], np.radians(self.turn)) @ np.diag([-1.0, 1.0, -1.0])
        return X_WO @ pose(down, self.p)


def written(steps: list[Step]) -> Program:
    tools = [f"PERS tooldata {n}:=[TRUE,[[{x},{y},{z}],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];"
             for n, (x, y, z) in TOOLS.items()]  # fmt: skip
    frames = []
    for n, (x, y, z, d) in FRAMES.items():
        q = f"[{cos(d * pi / 360):.12f},0,0,{sin(d * pi / 360):.12f}]"
        frames.append(f'PERS wobjdata {n}:=[FALSE,TRUE,"",[[{x},{y},{z}],{q}],[[0,0,0],[1,0,0,0]]];')
    lines = ["MODULE m", *tools, *frames, "PROC main()", *(step.text for step in steps), "ENDPROC", "ENDMODULE"]
    return run_program([TextFile("m.mod", "\n".join(lines), "utf-8")])


def way(before: Step, step: Step) -> tuple[float, float]:
    """How far the centre point of the step's own tool goes [mm], and how far it turns [deg]."""
    X_FT, X_FB = np.eye(4), np.eye(4)
    X_FT[:3, 3], X_FB[:3, 3] = TOOLS[step.tool], TOOLS[before.tool]
    X_0, X_1 = before.X_WT @ np.linalg.inv(X_FB) @ X_FT, step.X_WT
    cosine = (np.trace(X_0[:3, :3].T @ X_1[:3, :3]) - 1) / 2
    return float(np.linalg.norm(X_1[:3, 3] - X_0[:3, 3])), float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def ruled(before: Step, step: Step, after: Step) -> FlyBy | None:
    """The zone at the end of a step in mm, or in degrees between turns in place; None for a stop."""
    tcp, ori, eax, degrees, _ = ZONES[step.zone]
    sides = [way(before, step), way(step, after)]
    lines = step.kind == after.kind == "MoveL"
    other = TOOLS[step.tool] != TOOLS[after.tool] or (lines and FRAMES[step.frame] != FRAMES[after.frame])
    turns = [one.kind == "MoveL" and length < 1e-3 < angle
             for one, (length, angle) in zip((step, after), sides, strict=True)]  # fmt: skip
    if all(turns):
        size = min(degrees, *(angle / 2 for _, angle in sides))
        return FlyBy(size, size, size, True, other) if size > 0 else None
    if tcp == 0 or min(length for length, _ in sides) < 1e-3:
        return None
    half = min(length for length, _ in sides) / 2
    radius = min(tcp, half)
    shares = [degrees / angle * length for length, angle in sides if degrees > 0 and angle > 1e-3]
    return FlyBy(radius, max(radius, min(max(ori, tcp), half, *shares)), min(max(eax, tcp), half), False, other)


def random_steps(rng: Random) -> list[Step]:
    tool, frame, turn, p = "a", "w", 0.0, (0.0, 0.0, 0.0)
    steps = [Step("MoveJ", p, turn, tool, frame, "z10")]
    for _ in range(12):
        tool = rng.choice([*TOOLS]) if rng.random() < 0.3 else tool
        frame = rng.choice([*FRAMES]) if rng.random() < 0.3 else frame
        if rng.random() < 0.4:
            turn += rng.choice([-30, -6, 12, 25])
        else:
            p = tuple(x + rng.choice([-90, -30, 0, 20, 60]) for x in p)
        kind = "MoveJ" if rng.random() < 0.2 else "MoveL"
        steps.append(Step(kind, p, turn, tool, frame, rng.choice([*ZONES])))
    return steps


@pytest.mark.parametrize("seed", range(20))
def test_zones_of_random_programs(seed: int) -> None:
    steps = random_steps(Random(seed))
    program = written(steps)
    found, stopped, radii = fly_bys(program), stopped_fly_bys(program), effective_radii(program)
    for k in range(1, len(steps) - 1):
        wanted, place = ruled(*steps[k - 1 : k + 2]), f"step {k}: {steps[k]}, then {steps[k + 1]}"
        assert (k in stopped) == (wanted is None), place
        if wanted is None:
            assert radii[k] == 0, place
            continue
        scale = pi / 180 if wanted.in_place else 1e-3
        assert found[k][:3] == pytest.approx([size * scale for size in wanted[:3]], rel=1e-6, abs=1e-9), place
        assert found[k][3:] == wanted[3:], place
        assert radii[k] == (None if wanted.in_place else pytest.approx(wanted.radius * 1e-3, rel=1e-6)), place
    assert stopped[len(steps) - 1] == "no move follows"


def test_random_programs_hold_every_kind_of_corner() -> None:
    zones = [zone for seed in range(20) for zone in fly_bys(written(random_steps(Random(seed)))).values()]
    assert {(zone.in_place, zone.joint) for zone in zones} == {(False, False), (False, True), (True, False)}


A, TURNED = Step("MoveL", (0, 60, 0), 0, "a", "w", "z50"), Step("MoveL", (0, 60, 0), 30, "a", "w", "z50")


def test_a_zone_between_turns_in_place_counts_degrees() -> None:
    """z50 turns over 7.5 deg, and no farther than half of 12 deg; beside a line a turn has no zone."""
    start, more = Step("MoveJ", (0, 0, 0), 0, "a", "w", "z50"), Step("MoveL", (0, 60, 0), 42, "a", "w", "z50")
    found = written([start, A, TURNED, more, Step("MoveL", (0, 60, 0), 80, "a", "w", "z50"), A])
    assert {k: round(np.degrees(zone.turning), 6) for k, zone in fly_bys(found).items()} == {2: 6, 3: 6, 4: 7.5}
    assert sorted(stopped_fly_bys(found)) == [1, 5]


def test_a_zone_between_turns_in_place_in_two_work_objects_counts_degrees_and_is_joint_interpolated() -> None:
    """Both frames have one origin, where the tool stands."""
    turns = [(0, "w"), (30, "w"), (40, "t"), (40, "w")]
    steps = [Step("MoveL", (0, 0, 0), turn, "a", frame, "z50") for turn, frame in turns]
    found = fly_bys(written([Step("MoveJ", (0, 0, 0), 0, "a", "w", "fine"), *steps[1:]]))
    assert {k: (round(np.degrees(zone.turning), 6), *zone[3:]) for k, zone in found.items()} == {
        1: (7.5, True, True), 2: (7.5, True, True),
    }  # fmt: skip


def test_a_displacement_is_no_other_work_object() -> None:
    shifted = TextFile("m.mod", "\n".join([
        'MODULE m\nPERS wobjdata w:=[FALSE,TRUE,"",[[400,0,300],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];',
        "CONST robtarget p:=[[0,0,0],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nPROC main()",
        "MoveJ p,v100,fine,tool0\\WObj:=w;\nMoveL Offs(p,50,0,0),v100,z10,tool0\\WObj:=w;",
        "PDispSet [[0,0,50],[1,0,0,0]];\nMoveL Offs(p,50,0,0),v100,z10,tool0\\WObj:=w;",
        "w.uframe.trans.y:=30;\nPDispOff;\nMoveL p,v100,z10,tool0\\WObj:=w;\nw.uframe.trans.y:=90;",
        "MoveL Offs(p,50,50,0),v100,z10,tool0\\WObj:=w;\nMoveL p,v100,fine,tool0\\WObj:=w;\nENDPROC\nENDMODULE",
    ]), "utf-8")  # fmt: skip
    assert {k: zone.joint for k, zone in fly_bys(run_program([shifted])).items()} == {
        1: False,
        2: False,
        3: True,
        4: False,
    }
