"""Fuzzing of reader and interpreter: broken and invented programs, for as long as one likes.

python tests/benchmarks/bench_fuzz.py [--minutes M] [--seed S] [--corpus FOLDER ...] [--keep FOLDER]
                                      [--case N [--print]]

Every case is made from seed, number and corpus alone. Half are programs of the corpus (the shipped ones and the golden
pairs, and any folder of modules given) with bytes or words changed; half are invented from the grammar, the tables of
instructions and functions, and values that hurt. A case may end in motions or in an InputError, within SECONDS and
within the memory limit; everything else is a finding, printed with its number and, with --keep, saved as a module; so
is what takes longer than 2 s. What is read is also listed and printed, and the print must read back as the same tree.
What the scenario lacks is given, and the program run again, a few times. --case runs one again; --print shows its text.
"""

from __future__ import annotations

import argparse
import json
import random
import re
import resource
import signal
import sys
import traceback
from collections import Counter
from dataclasses import replace
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[2]))  # run from a checkout without installing
sys.path.insert(0, str(Path(__file__).parents[1] / "rapid"))

from rapid_printer import print_file

from trajopt_cli.errors import InputError
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.data.datatypes import TYPES
from trajopt_cli.rapid.data.predefined import ERRORS, predefined
from trajopt_cli.rapid.execution.functions.table import FUNCTIONS
from trajopt_cli.rapid.execution.instructions.table import INSTRUCTIONS
from trajopt_cli.rapid.language.lexer import KEYWORDS
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.rapid.listing import describe
from trajopt_cli.rapid.reader import try_program
from trajopt_cli.scenario import Scenario

REPOSITORY = Path(__file__).parents[2]
SECONDS = 10  # a case that takes longer hangs
MEMORY = 3 << 30  # bytes of address space
ENDINGS = {".mod", ".prg", ".sys", ".modx", ".sysx"}
SCENARIO = Scenario(endless_passes=2, pass_limit=300, statement_limit=20_000)
WORDS = [*sorted(KEYWORDS), *TYPES, *INSTRUCTIONS, *FUNCTIONS, *list(ERRORS)[:5], *list(predefined())[:40]]
SYMBOLS = [":=", "<=", ">=", "<>", *"-+*/=<>()[]{},;:.\\?|%", '"', "!", "<SMT>", "%%%", "\x00", "\u3000", "\ufeff", "ß"]
NUMBERS = ["0", "-1", "1", "2", "0.5", "9E9", "1E38", "1E39", "1E308", "8388609", "0x10", "1.", ".5", "1E-45"]


class Hang(Exception):
    """A case took too long."""


def alarm(number, frame):
    raise Hang


# ------------------------------------------------------------------------------------------------------- programs


def corpus(folders):
    """The bytes of all modules, in a fixed order."""
    places = [REPOSITORY / "programs", REPOSITORY / "tests" / "rapid" / "golden", *map(Path, folders)]
    files = sorted(f for place in places for f in place.rglob("*") if f.suffix.lower() in ENDINGS and f.is_file())
    return [content for f in files if 0 < len(content := f.read_bytes()) < 200_000]


def mutated(rng, seeds):
    """A program of the corpus with a few things wrong."""
    data = rng.choice(seeds)
    if rng.random() < 0.15:
        raw = bytearray(data)
        for _ in range(rng.randint(1, 20)):
            raw[rng.randrange(len(raw))] = rng.randrange(256)
        return bytes(raw)
    text = decode(data)[0]
    for _ in range(rng.choice([1, 1, 1, 2, 3, 6])):
        i = rng.randrange(len(text) + 1)
        j = min(len(text), i + rng.choice([1, 3, 10, 60, 400]))
        match rng.randrange(10):
            case 0:
                text = text[:i] + text[j:]
            case 1:
                text = text[:j] + text[i:j] * rng.choice([1, 2, 30]) + text[j:]
            case 2:
                text = text[:i] + f" {rng.choice(WORDS)} " + text[i:]
            case 3:
                text = text[:i] + rng.choice(SYMBOLS) + text[i:]
            case 4:
                text = text[:i] + rng.choice(NUMBERS) + text[i:]
            case 5:
                other = decode(rng.choice(seeds))[0]
                k = rng.randrange(len(other) + 1)
                text = text[:i] + other[k : k + rng.choice([20, 200, 2000])] + text[i:]
            case 6 if rng.random() < 0.2:
                text = text[:i]
            case _:  # one word for another
                words = list(re.finditer(r"\w+|[^\w\s]", text))
                if words:
                    word = rng.choice(words)
                    new = rng.choice([rng.choice(words)[0], rng.choice(NUMBERS), rng.choice(WORDS)])
                    text = text[: word.start()] + new + text[word.end() :]
    return text.encode("utf-8", "surrogatepass")


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


def case(seed, number, seeds):
    """The bytes of one case."""
    rng = random.Random(f"{seed}:{number}")
    return mutated(rng, seeds) if rng.random() < 0.5 else Inventor(rng).program()


# ------------------------------------------------------------------------------------------------------------- runs


def run(data):
    """One case: how it ended. Raises what the reader must not raise."""
    text, encoding = decode(data)
    file = TextFile("fuzz.mod", text, encoding)
    try:
        tree = parse_module(text, file.path)
    except InputError as error:
        str(error)
        return "not parsed"
    try:
        assert parse_module(print_file(tree), file.path) == tree, "printed, it reads as another tree"
    except InputError as error:
        if "nested deeper" not in str(error):  # the print has parentheses of its own, each a level
            raise
    scenario = SCENARIO
    for _ in range(3):
        try:
            program, lacks = try_program([file], scenario)
        except InputError as error:
            str(error)
            return "refused"
        if not lacks:
            json.dumps([repr(row) for row in describe(program).rows])
            return "run"
        given = {lack.section: {} for lack in lacks}
        for lack in lacks:
            given[lack.section][lack.name.lower()] = 1.0 if lack.section != "searches" else 0.5
        scenario = replace(
            scenario,
            signals={**scenario.signals, **given.get("signals", {})},
            answers={**scenario.answers, **given.get("answers", {})},
            searches={**scenario.searches, **given.get("searches", {})},
            assume_identity=scenario.assume_identity | set(given.get("assume_identity", {})),
        )
    return "lacking"


def guarded(data):
    """How a case ended, the seconds it took, and the traceback of a finding."""
    start = perf_counter()
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        return run(data), perf_counter() - start, None
    except BaseException as error:  # a fuzzer must survive whatever it finds
        if isinstance(error, KeyboardInterrupt):
            raise
        return type(error).__name__, perf_counter() - start, traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--corpus", action="append", default=[])
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--case", type=int)
    parser.add_argument("--print", action="store_true")
    options = parser.parse_args()
    signal.signal(signal.SIGALRM, alarm)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    seeds = corpus(options.corpus)
    if options.case is not None:
        data = case(options.seed, options.case, seeds)
        if options.print:
            print(decode(data)[0])
        outcome, seconds, finding = guarded(data)
        print(finding or outcome, f"{seconds:.3f} s")
        return
    outcomes, places, slowest = Counter(), Counter(), []
    start, number = perf_counter(), 0
    while perf_counter() - start < options.minutes * 60:
        data = case(options.seed, number, seeds)
        outcome, seconds, finding = guarded(data)
        outcomes[outcome] += 1
        if seconds > 2 and options.keep and finding is None:
            options.keep.mkdir(parents=True, exist_ok=True)
            (options.keep / f"slow_{options.seed}_{number}.mod").write_bytes(data)
        slowest = sorted([*slowest, (seconds, number)], reverse=True)[:3]
        if finding is not None:
            lines = [line.strip() for line in finding.splitlines() if "File" in line and "trajopt_cli" in line]
            place = f"{outcome} {lines[-1] if lines else finding.splitlines()[-1]}"
            places[place] += 1
            if places[place] == 1:
                print(f"case {number}: {place}: {finding.splitlines()[-1]}", flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / f"case_{options.seed}_{number}.mod").write_bytes(data)
                    (options.keep / f"case_{options.seed}_{number}.txt").write_text(finding)
        number += 1
    minutes = (perf_counter() - start) / 60
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        f"{number} cases in {minutes:.1f} min, corpus of {len(seeds)} modules, seed {options.seed}, peak {peak:.0f} MiB"
    )
    print("ended: " + ", ".join(f"{name} {count}" for name, count in outcomes.most_common()))
    print("slowest: " + ", ".join(f"case {case} {seconds:.2f} s" for seconds, case in slowest))
    print(f"findings: {sum(places.values())} in {len(places)} places")
    for place, count in places.most_common():
        print(f"  {count} x {place}")
    sys.exit(bool(places))


if __name__ == "__main__":
    main()
