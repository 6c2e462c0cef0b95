"""Targets, frames and speeds as a second, small reading of the text has them; literal programs, most made up."""

from __future__ import annotations

import random
from collections import defaultdict
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
from plain_reading import pose, readings
from test_golden import run, wanted

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.job import read_job
from trajopt_cli.motion import Move, MoveAbsJ, MoveC, PoseMove, Program, TextFile
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program

HERE = Path(__file__).parent
PROGRAMS = HERE.parents[1] / "programs"
SINGLE = 4e-6  # what the 24 bits of a num make of five frames in a row, metres long [m]
TABLE = ((0.65, 0.5, 0.1), (0.9, 0.1, -0.2, 0.3))
CELL = f"""robot: irb140_rail
rail: {{eax: a, stroke: [-0.2, 2.2]}}
limits: {{rail: {{velocity: 1, acceleration: 3, source: a test}}}}
start: {{joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}}
positioners:
  STN1:
    {{eax: b, frame: {{position: {[*TABLE[0]]}, wxyz: {[float(x) for x in np.array(TABLE[1]) / 0.95**0.5]}}}, \
range: "[-185, 185] deg", velocity: 90 deg/s, acceleration: 180 deg/s2, source: a test}}
"""
# What changes moves, or what stands still (a stationary tool), and the second reading does not follow through loops.
MODAL = ("pdisp", "eoffs", "velset", "speedrefresh", "actunit", "[false,[[")
Pairs = dict[str, list[tuple[Any, Any, str]]]  # both readings, and of what


def asked(move: Move, plant: Plant | None) -> dict[str, Any]:
    """What the interpreter made of a move, under the names that the plain reading has."""
    s, z = move.speed, move.zone
    sizes = (z.radius, z.path_ori, z.path_eax, z.ori, z.leax, z.reax)
    out = {"extax": [nan if value is None else value for value in move.extax]}
    out |= {"speed": (s.v_tcp, s.v_ori, s.v_leax, s.v_reax), "zone": (nan,) * 6 if z.stop else sizes}
    out |= {"time": nan if move.duration is None else move.duration}
    if isinstance(move, PoseMove | MoveAbsJ):
        out["X_FT"] = move.tool.X_FT
    if isinstance(move, MoveAbsJ):
        out["q"] = move.q
    if isinstance(move, PoseMove):
        out |= {"X_WO": move.X_WO, "X_WT": move.X_WT, "conf": move.conf.numbers}
    if isinstance(move, MoveC):
        out["X_WV"] = move.X_WV
    if plant is not None:
        rail = plant.rail_value(move.extax)
        out["rail"] = nan if rail is None else rail[0]
    return out


def pair(program: Program, tables: dict[str, Any], plant: Plant | None, into: Pairs) -> int:
    """Lay both readings of each literal move side by side; how many moves the program has by the second one."""
    plain = {file: readings(content.text, tables) for file, content in program.files.items()}
    for move in program.motions:
        at = move.written.statement if isinstance(move, Move) else None
        if at is None or not isinstance(move, Move) or move.process or at.start not in plain[at.file]:
            continue
        wanted = plain[at.file][at.start]
        if plant is not None:
            wanted = wanted | {"rail": wanted["extax"][0] * 0.001}
        found = asked(move, plant)
        assert found.keys() == wanted.keys()
        for key, value in wanted.items():
            into[key].append((found[key], value, f"{key} of {move.target}, {at.file}:{move.source.line}"))
    return sum(map(len, plain.values()))


def agree(pairs: Pairs) -> None:
    for all_of_a_kind in pairs.values():
        found, wanted, places = zip(*all_of_a_kind, strict=True)
        good = np.isclose(np.array(found, float), np.array(wanted, float), 2e-6, SINGLE, equal_nan=True)
        assert [places[i] for i in np.flatnonzero(~good.reshape(len(good), -1).all(axis=1))] == []


class Written:
    """A literal program out of nothing: frames in frames, tools, tables, displacements, all kinds of moves."""

    def __init__(self, seed: int):
        self.rng = random.Random(seed)

    def row(self, low: float, high: float, count: int) -> str:
        digits = self.rng.choice([0, 1, 3, 6])
        return "[" + ",".join(f"{self.rng.uniform(low, high):.{digits}f}" for _ in range(count)) + "]"

    def orient(self) -> str:
        q = np.array([self.rng.gauss(0, 1) for _ in range(4)])
        return "[" + ",".join(f"{x:.8f}" for x in q / np.linalg.norm(q)) + "]"

    def frame(self, size: float) -> str:
        return f"[{self.row(-size, size, 3)},{self.orient() if self.rng.random() < 0.8 else '[1,0,0,0]'}]"

    def extax(self) -> str:
        a, b = (f"{self.rng.uniform(low, 180):.2f}" if self.rng.random() < 0.7 else "9E9" for low in (0, -180))
        return f"[{a},{b},9E9,9e9,9E+09,9E9]"

    def target(self) -> str:
        conf = (
            f"[{self.rng.randint(-2, 1)},{self.rng.randint(-2, 1)},{self.rng.randint(-2, 1)},{self.rng.randint(0, 7)}]"
        )
        return f"[{self.row(-1500, 1500, 3)},{self.orient()},{conf},{self.extax()}]"

    def pick(self, *choices: str) -> str:
        one = self.rng.choice(choices)
        return self.rng.choice([one, one, one.upper(), one.lower()])

    def point(self, *names: str) -> str:
        shift = ",".join(f"{self.rng.uniform(-300, 300):.1f}" for _ in range(3))
        turns = "".join(f"\\R{x}:={self.rng.uniform(-90, 90):.1f}" for x in "xyz" if self.rng.random() < 0.5)
        p = self.rng.choice([*names, self.target()])
        return self.rng.choice([p, p, f"Offs({p}, {shift})", f"RelTool({p},{shift}{turns})"])

    def move(self) -> str:
        rng = self.rng
        speed = rng.choice([self.pick("v5", "v50", "v800", "v1500", "v7000", "vmax"), "sOwn", self.row(1, 900, 4)])
        speed += rng.choice(["", "", "", f"\\V:={rng.uniform(9, 900):.1f}", f"\\T:={rng.uniform(0.1, 9):.2f}"])
        zone = self.pick("fine", "fine", "z0", "z1", "z5", "z15", "z50", "z150", "z200", "zOwn")
        zone += rng.choice(["", "", f"\\Z:={rng.uniform(0, 99):.1f}", "\\Inpos:=inpos50"])
        tail = f"{speed}, {zone}, {self.pick('tool0', 'tOne', 'tTwo')}"
        wobj = rng.choice(["", *(f"\\WObj:={self.pick(w)}" for w in ("wobj0", "wOne", "wTwo", "wTable"))])
        match rng.choice(["J", "L", "L", "C", "AbsJ", "ExtJ", "PDispSet", "PDispOff", "VelSet"]):
            case "C":
                return f"MoveC {self.point()},{self.point()}, {tail}{wobj};"
            case "AbsJ":
                q = rng.choice(["j1", f"[{self.row(-170, 170, 6)},{self.extax()}]"])
                return f"MoveAbsJ {q}\\NoEOffs, {tail}{wobj};"
            case "ExtJ":
                return rng.choice(["MoveExtJ j1, vrot10, fine;", "MoveExtJ jRail, vlin100, fine;"])
            case "PDispSet":
                return "PDispSet dOne;"
            case "PDispOff":
                return "PDispOff;"
            case "VelSet":
                return f"VelSet {rng.randint(20, 100)}, {rng.randint(100, 3000)};"
            case kind:
                return f"{self.pick(f'Move{kind}')}  {self.point('p1', 'p2', 'p3')},\n   {tail} {wobj}; ! v9, z9; tool9"

    def text(self) -> str:
        table = f'[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],{self.frame(200)}]'
        data = [
            *(f"CONST robtarget p{i}:={self.target()};" for i in (1, 2, 3)),
            f"CONST jointtarget j1:=[{self.row(-170, 170, 6)},{self.extax()}];",
            f"CONST jointtarget jRail:=[{self.row(-170, 170, 6)},[{self.rng.uniform(0, 999):.3f}{',9E9' * 5}]];",
            *(f"PERS tooldata {t}:=[TRUE,{self.frame(300)},[1,[0,0,50],[1,0,0,0],0,0,0]];" for t in ("tOne", "tTwo")),
            *(f'PERS wobjdata {w}:=[FALSE,TRUE,"",{self.frame(2000)},{self.frame(900)}];' for w in ("wOne", "wTwo")),
            f"PERS wobjdata wTable:={table};",
            f"CONST pose dOne:={self.frame(400)};",
            f"VAR speeddata sOwn:={self.row(1, 900, 4)};",
            f"CONST zonedata zOwn:=[FALSE,{self.row(0, 90, 6)[1:]};",
        ]
        self.rng.shuffle(data)
        body = [self.move() for _ in range(self.rng.randint(1, 4))]
        return "MODULE Written\n" + "\n".join(data) + "\nPROC main()\n" + "\n".join(body) + "\nENDPROC\nENDMODULE\n"


def test_a_thousand_literal_programs_are_read_as_they_are_written() -> None:
    cell = parse_cell(CELL, "cell.yaml")
    plant, tables = build_plant(cell), {"STN1": pose(np.multiply(TABLE[0], 1000), TABLE[1])}
    pairs: Pairs = defaultdict(list)
    for seed in range(1000):
        program = run_program([TextFile("w.mod", Written(seed).text(), "utf-8")], cell.scenario)
        moves = [motion for motion in program.motions if isinstance(motion, Move)]
        assert pair(program, tables, plant, pairs) == len(moves)
    assert len(pairs["speed"]) > 1500
    agree(pairs)


def test_literal_moves_of_shipped_and_golden_programs_are_read_as_they_are_written() -> None:
    tables = {"STN1": pose((650, 500, 100), (1, 0, 0, 0))}  # of positioner.yaml and round_seam.yaml
    pairs: Pairs = defaultdict(list)
    for path in sorted(PROGRAMS.glob("*.mod")):
        job = read_job(path)
        pair(job.program, tables, job.plant, pairs)
    assert len(pairs["rail"]) > 100
    assert len(pairs["X_WV"]) > 5
    for path in sorted((HERE / "golden").glob("*.mod")):
        content = path.read_text(encoding="latin-1").lower()
        if not any(word in content for word in MODAL) and "error" not in wanted(path.stem):
            pair(run(path.stem)[0], {}, None, pairs)
    assert len(pairs["X_WT"]) > 180
    agree(pairs)
