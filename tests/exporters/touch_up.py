"""Random programs, random rail positions for them, and what becomes of both texts when points are taught anew."""

from __future__ import annotations

import random
import re
from collections.abc import Mapping

import numpy as np

from trajopt_cli.exporters.rapid import written
from trajopt_cli.exporters.rapid_write import Intent
from trajopt_cli.motion import Move, MoveAbsJ, PoseMove, Program, TextFile, Wait
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import EditableText
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import NO_SETTLING, Scenario, Settling
from trajopt_cli.units import MM

NUMBER = r"-?[\d.]+"
POSITION = re.compile(rf"\[({NUMBER},{NUMBER},{NUMBER})\](?=,\[{NUMBER},{NUMBER},{NUMBER},{NUMBER}\][],])")


def random_program(rng: random.Random) -> str:
    """A module of targets, work objects, loops and routines; every place can be reached by nobody knows whom."""
    return _Text(rng).module()


class _Text:
    def __init__(self, rng: random.Random):
        self.rng, self.pick = rng, rng.choice
        self.points = [f"p{i}" for i in range(rng.randint(2, 5))]
        self.counters = 0
        self.calls = 0

    def module(self) -> str:
        rng = self.rng
        data = [
            f"{self.pick(['CONST', 'PERS', 'LOCAL CONST'])} robtarget {name}:={self.literal()};" for name in self.points
        ]
        data += [f"PERS robtarget pNow:={self.literal()};", "PERS num nRow:=0;", "VAR num nDone;"]
        data += [f"CONST robtarget ps{{3}}:=[{','.join(self.literal() for _ in range(3))}];"]
        data += [
            f'PERS wobjdata w{i}:=[FALSE,TRUE,"",[[{self.place()}],{self.turn()}],[[{self.place()}],[1,0,0,0]]];'
            for i in (1, 2)
        ]
        data += ["PERS tooldata t1:=[TRUE,[[10,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];"]
        data += ["CONST jointtarget jHome:=[[0,-20,30,0,60,0],[150,9E9,9E9,9E9,9E9,9E9]];"]
        switches = self.pick(["ConfJ\\Off; ConfL\\Off;", "ConfL\\Off;", ""])
        main = [switches, "MoveAbsJ jHome,v500,fine,t1;", *self.block(2, (), 6)]
        routines = [
            "PROC serve(robtarget p,num h)",
            *self.block(1, ("p", "h"), 4),
            "ENDPROC",
            "PROC grip()",
            *self.block(0, (), 3),
            "ENDPROC",
            "FUNC robtarget fUp(robtarget p,num h)",
            "p.trans.z:=p.trans.z+h;",
            "RETURN p;",
            "ENDFUNC",
        ]
        rng.shuffle(data)
        lines = ["MODULE m", *data, "PROC main()", *main, "ENDPROC", *routines, "ENDMODULE", ""]
        return "\n".join(line for line in lines if line or line is lines[-1])

    def place(self) -> str:
        return ",".join(str(self.rng.randint(-400, 900)) for _ in range(3))

    def turn(self) -> str:
        return self.pick(["[1,0,0,0]", "[0,0,1,0]", "[0.7071068,0,0.7071068,0]", "[0.9659258,0,0,0.258819]"])

    def literal(self) -> str:
        rail = self.pick(["150", "150", "400", "9E9"])
        return f"[[{self.place()}],{self.turn()},[0,0,0,0],[{rail},9E9,9E9,9E9,9E9,9E9]]"

    def number(self, known: tuple[str, ...]) -> str:
        names = [name for name in known if name != "p"]
        return self.pick([str(self.rng.randint(-90, 90)), *(f"{self.rng.randint(2, 9)}*{name}" for name in names)])

    def target(self, known: tuple[str, ...]) -> str:
        index = self.pick(["1", "2", "3", *(name for name in known if name.startswith("i"))])
        bases = [*self.points, "pNow", f"ps{{{index}}}", *(name for name in known if name == "p")]
        base = self.pick([*bases, *bases, self.literal()])
        given = ",".join(self.number(known) for _ in range(3))
        return self.pick([
            base, base, f"Offs({base},{given})", f"RelTool({base},{given}\\Rz:={self.rng.randint(-30, 30)})",
            f"Offs(RelTool({base},0,0,-50),{given})", f"fUp({base},{self.number(known)})",
        ])  # fmt: skip

    def move(self, known: tuple[str, ...]) -> str:
        frame = self.pick(["", "\\WObj:=w1", "\\WObj:=w2"])
        zone = self.pick(["fine", "z10", "z50"])
        return f"{self.pick(['MoveJ', 'MoveL', 'MoveL'])} {self.target(known)},v500,{zone},t1{frame};"

    def block(self, depth: int, known: tuple[str, ...], count: int) -> list[str]:
        lines: list[str] = []
        for _ in range(self.rng.randint(1, count)):
            lines += self.statement(depth, known)
        return lines

    def statement(self, depth: int, known: tuple[str, ...]) -> list[str]:
        kind = self.rng.randint(0, 13 if depth else 8)
        if kind < 4:
            return [self.move(known)]
        if kind == 4:
            return [self.move(known), self.pick(["WaitTime 0.5;", "WaitTime\\InPos,0.3;"])]
        if kind == 5:
            return [f"pNow:={self.target(known)};"]
        if kind == 6:
            return [self.pick(["nRow:=(nRow+1) MOD 3;", "pNow.trans.z:=pNow.trans.z+20;", "Set do1;"])]
        if kind == 7:
            return [
                self.pick(["PDispSet [[5,10,20],[1,0,0,0]];", "PDispOff;", "EOffsSet [10,0,0,0,0,0];", "EOffsOff;"])
            ]
        if kind == 8:
            return [self.pick(["MoveAbsJ jHome,v500,fine,t1;", "w1.uframe.trans.x:=w1.uframe.trans.x+15;"])]
        inner = (*known, f"i{self.counters}")
        self.counters += 1
        if kind < 11:
            bounds = self.pick(["1 TO 3", "1 TO 3", "3 TO 1 STEP -1", "1 TO 3 STEP 2", "1 TO nRow+1"])
            return [f"FOR {inner[-1]} FROM {bounds} DO", *self.block(depth - 1, inner, 3), "ENDFOR"]
        if kind == 11:
            return ["nDone:=0;", "WHILE nDone<2 DO", *self.block(depth - 1, (*known, "nDone"), 3), "nDone:=nDone+1;",
                    "ENDWHILE"]  # fmt: skip
        if kind == 12:
            return [f"IF {self.pick(['TRUE', 'nRow=1', 'nRow<>1'])} THEN", *self.block(depth - 1, known, 2), "ENDIF"]
        if depth == 2:
            return [f"serve {self.target(known)},{self.number(known)};"]
        return ["grip;"]


def read(text: str, plant: Plant, scenario: Scenario) -> Program:
    """A module's program on a plant."""
    return run_program([TextFile("m.mod", text, "utf-8")], scenario, "main", PlantKinematics(plant))


def random_intents(program: Program, text: EditableText, rng: random.Random) -> dict[int, Intent]:
    """Rail positions that a plan may ask for: one for all motions of a tie, as written where nothing may change."""
    first = {i: group[0] for group in text.changes.ties for i in group}
    wanted: dict[int, float] = {}
    out, now, before = dict[int, Intent](), 0.0, 0.0
    for i, motion in enumerate(program.motions):
        if isinstance(motion, PoseMove | MoveAbsJ):
            offset = motion.settings.eax_offset[0]
            given = motion.extax[0]
            now = now if given is None else given
            free = i in text.changes.values and isinstance(motion, PoseMove)
            rail = (
                wanted.setdefault(first.get(i, i), rng.choice([150.0, round(rng.uniform(0, 900), 3)])) if free else now
            )
            if free or given is not None:
                out[i] = Intent((rail - offset,), moves=rail != before)
                before = rail
        elif isinstance(motion, Wait) and i in text.changes.values:
            rail = wanted.setdefault(first.get(i, i), round(rng.uniform(0, 900), 3))
            move = program.motions[text.dwells[i]]
            assert isinstance(move, Move)
            out[i] = Intent((rail - move.settings.eax_offset[0],), moves=True)
            before = rail
    return out


def taught(text: str) -> str:
    """A text whose points and frames are shifted by random millimetres, which depend on where they are alone."""

    def shifted(match: re.Match[str]) -> str:
        rng = random.Random(match[1])
        return "[" + ",".join(f"{float(one) + rng.uniform(-15, 15):.3f}" for one in match[1].split(",")) + "]"

    return "\n".join(POSITION.sub(shifted, line) if "tooldata" not in line else line for line in text.split("\n"))


def export(
    program: Program, plant: Plant, scenario: Scenario, rng: random.Random, loops: Loops
) -> tuple[str, Mapping[int, Intent]]:
    """The text with random rail positions in it, and these."""
    text = EditableText(program, plant, scenario, loops)
    intents = random_intents(program, text, rng)
    return written(program, plant, scenario, intents, loops).texts["m.mod"], intents


def differences(program: Program, exported: Program, plant: Plant, intents: Mapping[int, Intent]) -> list[str]:
    """Where an exported program takes the tool otherwise than the program, or the rail otherwise than asked."""
    out: list[str] = []
    left, place = iter(exported.motions), None
    lines = {program.motions[i].written.statement for i, one in intents.items() if one.moves}
    for i, motion in enumerate(program.motions):
        other = next(left, None)
        if isinstance(motion, Wait) and motion.written.statement in lines and i in intents:
            if not isinstance(other, PoseMove) or place is None or np.abs(other.X_WT - place).max() > 1e-6:
                out.append(f"{motion.source}: the tool does not stand still while it waits")
        elif type(other) is not type(motion):
            return [*out, f"{motion.source}: {type(motion).__name__} became {type(other).__name__}"]
        elif isinstance(motion, PoseMove) and isinstance(other, PoseMove):
            if np.abs(motion.X_WT - other.X_WT).max() > 1e-6:
                out.append(f"{motion.source}: {motion.target} is elsewhere")
            place = motion.X_WT
        elif isinstance(motion, MoveAbsJ) and isinstance(other, MoveAbsJ):
            q = plant.layout.join(np.array([motion.extax[0] or 0.0]) * MM, motion.q[None])[0]
            place = plant.robot.forward(q) @ motion.tool.X_FT
        wish = intents.get(i)
        if wish is not None and isinstance(other, Move) and wish.rail is not None:
            rail = other.extax[0]
            asked = wish.rail[0] + other.settings.eax_offset[0]
            if rail is None and not wish.moves:
                continue
            if rail is None or abs(rail - asked) > 1e-3:
                out.append(f"{motion.source}: the rail at {rail}, asked for {asked}")
    return out if next(left, None) is None else [*out, "motions too many"]


def touch_up(seed: int, plant: Plant) -> list[str]:
    """What is wrong with the export of one random program, before and after its points are taught anew; every second
    one settles at its stops."""
    rng, scenario = random.Random(seed), Scenario(settle=Settling(0.1, 0.2) if seed % 2 else NO_SETTLING)
    text = random_program(rng)
    program = read(text, plant, scenario)
    loops = rng.choice([Loops.KEEP, Loops.KEEP, Loops.UNROLL])
    exported, intents = export(program, plant, scenario, rng, loops)
    same = [f"as exported: {one}" for one in differences(program, read(exported, plant, scenario), plant, intents)]
    new, new_exported = (read(taught(one), plant, scenario) for one in (text, exported))
    return [*same, *(f"taught anew: {one}" for one in differences(new, new_exported, plant, intents))]
