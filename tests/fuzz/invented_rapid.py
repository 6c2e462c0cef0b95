"""RAPID programs out of nothing: from the grammar, the tables of instructions and functions, and values that hurt."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import TYPES
from trajopt_cli.rapid.data.predefined import ERRORS, predefined
from trajopt_cli.rapid.execution.table import FUNCTIONS, INSTRUCTIONS
from trajopt_cli.rapid.language.lexer import KEYWORDS

WORDS = [*sorted(KEYWORDS), *TYPES, *INSTRUCTIONS, *FUNCTIONS, *list(ERRORS)[:5], *list(predefined())[:40]]
NUMBERS = ["0", "-1", "1", "2", "0.5", "9E9", "1E38", "1E39", "1E308", "8388609", "0x10", "1.", ".5", "1E-45"]


class Inventor:
    """A program out of nothing; most of its names exist, and some of its types fit."""

    def __init__(self, rng):
        self.rng = rng
        self.data = {}  # name: type
        self.procedures = []
        self.depth = 0

    def pick(self, *things):
        return self.rng.choice(things)

    def either(self, *things):
        """One of several texts, or of functions that make one: a text is made only when it is chosen."""
        thing = self.rng.choice(things)
        return thing() if callable(thing) else thing

    def number(self):
        return self.pick(*NUMBERS, *(str(self.rng.randint(-400, 1200)) for _ in range(20)))

    def value(self, type_):
        """Something of a type, mostly; often a name."""
        rng = self.rng
        if rng.random() < 0.01:
            type_ = rng.choice(list(TYPES))
        names = [name for name, known in self.data.items() if known == type_]
        if names and rng.random() < 0.5:
            return rng.choice(names)
        self.depth += 1
        try:
            if self.depth > 5:
                return self.number() if type_ == "num" else rng.choice(names or list(self.data) or ["x"])
            match type_:
                case "num" | "dnum":
                    return self.either(
                        self.number,
                        lambda: (
                            f"({self.value('num')}{self.pick('+', '-', '*', '/', ' DIV ', ' MOD ')}{self.value('num')})"
                        ),
                        lambda: f"-{self.value('num')}",
                        self.call if rng.random() < 0.1 else self.number,
                        self.pick("di1", "gi2", "reg1", "ERRNO"),
                    )
                case "bool":
                    return self.either(
                        "TRUE",
                        "FALSE",
                        lambda: f"NOT {self.value('bool')}",
                        lambda: f"({self.value('bool')} {self.pick('AND', 'OR', 'XOR')} {self.value('bool')})",
                        lambda: f"{self.value('num')}{self.pick('<', '>', '=', '<>', '<=', '>=')}{self.value('num')}",
                        self.call if rng.random() < 0.1 else "TRUE",
                    )
                case "string":
                    return self.either(
                        '"abc"', '""', '"\\0A"', f"{self.value('string')}+{self.value('string')}", '"main"'
                    )
                case "pos":
                    return self.either(
                        lambda: f"[{self.value('num')},{self.value('num')},{self.value('num')}]",
                        lambda: f"{self.value('pos')}{self.pick('+', '-', '*')}{self.value('pos')}",
                        lambda: f"({self.value('robtarget')}).trans",
                    )
                case "orient":
                    return self.either("[1,0,0,0]", "[0,0,0,0]", "[0.7071,0,0.7071,0]", "OrientZYX(10,20,30)")
                case "pose":
                    return f"[{self.value('pos')},{self.value('orient')}]"
                case "robtarget":
                    conf = self.pick("[0,0,0,0]", "[0,-1,0,1]", "[1.5,0,0,0]", "[0,0,0]")
                    ext = self.pick("[9E9,9E9,9E9,9E9,9E9,9E9]", "[0,9E9,9E9,9E9,9E9,9E9]")
                    return self.either(
                        lambda: f"[{self.value('pos')},{self.value('orient')},{conf},{ext}]",
                        f"[[500,0,600],[0,0,1,0],{conf},{ext}]",
                        lambda: f"Offs({self.value('robtarget')},{self.value('num')},0,{self.value('num')})",
                        lambda: f"RelTool({self.value('robtarget')},0,0,{self.value('num')}\\Rz:={self.value('num')})",
                        "CRobT()",
                    )
                case "jointtarget":
                    return self.either(
                        lambda: f"[[{','.join(self.value('num') for _ in range(6))}],[0,9E9,9E9,9E9,9E9,9E9]]",
                        "[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
                        "CJointT()",
                        "[[0,0,0,0,30,0]]",
                    )
                case "speeddata":
                    return self.either("v100", "vmax", "v5000", f"[{self.value('num')},500,5000,1000]")
                case "zonedata":
                    return self.either("fine", "z0", "z50", "z200")
                case "tooldata":
                    return self.either("tool0", "tGrip", f"[TRUE,{self.value('pose')},[1,[0,0,1],[1,0,0,0],0,0,0]]")
                case "wobjdata":
                    frames = f"{self.value('pose')},{self.value('pose')}"
                    return self.either("wobj0", f'[FALSE,{self.value("bool")},"",{frames}]')
                case _:
                    return rng.choice([*self.data, "di1", "x", "[1,2]"])
        finally:
            self.depth -= 1

    def call(self):
        name = self.rng.choice(list(FUNCTIONS))
        kinds = ["num", "string", "robtarget", "pos", "pose", "bool", "jointtarget", "tooldata"]
        args = ",".join(self.value(self.rng.choice(kinds)) for _ in range(self.rng.randint(0, 4)))
        return f"{name}({args}{self.option()})"

    def option(self):
        if self.rng.random() > 0.2:
            return ""
        name = self.pick(
            "V", "T", "Z", "WObj", "Inpos", "Conc", "ID", "Rx", "Start", "Off", "On", "X", "Dec", "MaxTime"
        )
        return f"\\{name}" + (
            f":={self.value(self.pick('num', 'wobjdata', 'bool'))}" if self.rng.random() < 0.6 else ""
        )

    def move(self):
        speed, zone, tool = (self.value(kind) for kind in ("speeddata", "zonedata", "tooldata"))
        point, joints = self.value("robtarget"), self.value("jointtarget")
        return self.either(
            lambda: f"MoveJ {point},{speed},{zone},{tool}{self.option()};",
            lambda: f"MoveL {point},{speed},{zone},{tool}\\WObj:={self.value('wobjdata')};",
            lambda: f"MoveC {point},{self.value('robtarget')},{speed},{zone},{tool};",
            lambda: f"MoveAbsJ {joints}{self.option()},{speed},{zone},{tool};",
            lambda: f"MoveExtJ {joints},{speed},{zone};",
            lambda: f"SearchL di1,{point},{self.value('robtarget')},{speed},{tool};",
            lambda: f"TriggL {point},{speed},t1,{zone},{tool};",
            lambda: f"MoveLDO {point},{speed},{zone},{tool},do1,{self.value('num')};",
        )

    def instruction(self):
        kinds = ["num", "string", "robtarget", "bool", "signal", "pose", "speeddata", "tooldata"]
        args = ",".join(self.value(self.rng.choice(kinds)) for _ in range(self.rng.randint(0, 5)))
        option = self.option()
        name = self.rng.choice(list(INSTRUCTIONS))
        return f"{name}{option}{',' if option and args else ' '}{args}{self.option()};"

    def block(self):
        self.depth += 1
        lines = [self.statement() for _ in range(self.rng.randint(0, 3) if self.depth < 5 else 0)]
        self.depth -= 1
        return "\n".join(lines)

    def statement(self):
        name = self.rng.choice([*self.data])
        type_ = self.data.get(name, "num")
        return self.pick(
            self.move,
            self.move,
            self.instruction if self.rng.random() < 0.2 else self.move,
            lambda: f"{name}:={self.value(type_)};",
            lambda: f"IF {self.value('bool')} THEN\n{self.block()}\nELSE\n{self.block()}\nENDIF",
            lambda: f"IF {self.value('bool')} {self.statement() if self.depth < 5 else 'EXIT;'}",
            lambda: f"FOR i FROM {self.value('num')} TO {self.value('num')} DO\n{self.block()}\nENDFOR",
            lambda: f"FOR i FROM 3 TO 1 STEP {self.value('num')} DO\n{self.block()}\nENDFOR",
            lambda: f"WHILE {self.value('bool')} DO\n{self.block()}\nENDWHILE",
            lambda: (
                f"TEST {self.value('num')}\nCASE {self.value('num')},2:\n{self.block()}\n"
                f"DEFAULT:\n{self.block()}\nENDTEST"
            ),
            lambda: f"{self.rng.choice([*self.procedures, 'main'])};",
            lambda: f"%{self.value('string')}%;",
            lambda: self.pick("RETURN;", "EXIT;", "RAISE 5;", "RAISE;", "RETRY;", "TRYNEXT;", "GOTO a;", "a:"),
            lambda: f"a: {self.move()} GOTO a;" if self.rng.random() < 0.2 else "Stop;",
        )()

    def program(self):
        lines = ["MODULE fuzz"]
        types = [
            "num",
            "dnum",
            "bool",
            "string",
            "pos",
            "pose",
            "robtarget",
            "jointtarget",
            "tooldata",
            "wobjdata",
            "r",
        ]
        lines.append("RECORD r\nnum a;\npos b;\nENDRECORD")
        for i in range(self.rng.randint(1, 10)):
            type_, name = self.rng.choice(types), f"d{i}"
            sizes = self.pick("", "", "", "{3}", "{2,2}", f"{{{self.number()}}}")
            first = f":={self.value(type_)}" if not sizes and self.rng.random() < 0.6 else ""
            lines.append(f"{self.pick('VAR', 'PERS', 'CONST', 'LOCAL VAR')} {type_} {name}{sizes}{first};")
            self.data[name] = type_ if not sizes else f"{type_} array"
            if sizes and self.rng.random() < 0.7:
                self.data[f"{name}{{{self.pick('1', '2', '1,1', 'i')}}}"] = type_
        lines.append("VAR triggdata t1;\nVAR intnum i1;")
        self.procedures = [f"p{i}" for i in range(self.rng.randint(0, 3))]
        for name in ["main", *self.procedures]:
            body = "\n".join(self.statement() for _ in range(self.rng.randint(1, 8)))
            handler = f"ERROR\n{self.block()}\n{self.pick('RETRY;', 'TRYNEXT;', 'RETURN;', 'RAISE;', '')}"
            lines.append(f"PROC {name}()\n{body}\n{handler if self.rng.random() < 0.3 else ''}\nENDPROC")
        lines.append("FUNC num f(num a\\switch b)\nIF Present(b) RETURN f(a-1);\nRETURN a;\nENDFUNC\nENDMODULE")
        return "\n".join(lines).encode()
