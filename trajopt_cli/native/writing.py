"""CasADi functions written as LLVM IR text, several copies side by side in the lanes of a vector.

An SX function is a flat list of scalar instructions on numbered registers. Each becomes one instruction on vectors
whose lanes are different copies, once: what is found in several places, a tenth of all, is the same step. The list is
cut into functions of two hundred steps; what one of them leaves for another goes through memory, and so do constants:
vectors of them within instructions are not for LLVM's fast selection, and it takes twice as long.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from struct import pack
from typing import Any

import casadi as ca

CHUNK = 200  # steps per LLVM function, a part of ours. Measured: see docs/measured.md, Machine code
_BINARY = {ca.OP_ADD: "fadd", ca.OP_SUB: "fsub", ca.OP_MUL: "fmul", ca.OP_DIV: "fdiv"}
_WITH_ITSELF = {ca.OP_SQ: ca.OP_MUL, ca.OP_TWICE: ca.OP_ADD}
_OF_A_CONSTANT = {ca.OP_NEG: (ca.OP_SUB, -0.0), ca.OP_INV: (ca.OP_DIV, 1.0)}
_COMPARED = {ca.OP_LT: "olt", ca.OP_LE: "ole", ca.OP_EQ: "oeq", ca.OP_NE: "une"}
_LLVMS = {ca.OP_SQRT: "sqrt", ca.OP_FABS: "fabs", ca.OP_FMAX: "maxnum", ca.OP_FMIN: "minnum"}
_LIBM = {
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TAN: "tan", ca.OP_ASIN: "asin", ca.OP_ACOS: "acos", ca.OP_ATAN: "atan",
    ca.OP_ATAN2: "atan2", ca.OP_EXP: "exp", ca.OP_LOG: "log", ca.OP_POW: "pow", ca.OP_CONSTPOW: "pow",
}  # fmt: skip
_GIVEN = "%a0.p", "%a1.p", "%a2.p", "%w", "%out.p"  # what a part works on, and constants behind it
_WORK, _OUT, _CONSTANTS = 3, 4, 5  # their places
LIBM = {name: 2 if name in ("atan2", "pow") else 1 for name in _LIBM.values()}
"""The functions of the C library that may be called, with their numbers of arguments."""


def module_text(functions: Mapping[str, ca.Function], lanes: int) -> str:
    """LLVM IR of a module with an entry per function, by name: void name(i64 n, ptr in_0, ptr in_1, ptr in_2, ptr out).

    It evaluates n groups of copies one after the other. Inputs, at most three, and the one output are dense vectors; in
    memory a group is an array (length, lanes). Raises ValueError for an operation that has no counterpart here.
    """
    body = "\n".join(line for name, one in functions.items() for line in _Written(name, one, lanes).lines())
    called = [name for name in LIBM if f"@lanes.{name}(" in body]
    return "\n".join([*_declared(called, lanes), body])


def _declared(called: Sequence[str], lanes: int) -> Iterator[str]:
    """LLVM's own functions, and those of the C library that are called, lane by lane."""
    V = "%V"
    yield f"{V} = type <{lanes} x double>"
    for name, n in (("sqrt", 1), ("fabs", 1), ("maxnum", 2), ("minnum", 2)):
        yield f"declare {V} @llvm.{name}.v{lanes}f64({', '.join([V] * n)})"
    for name in called:
        n = LIBM[name]
        yield f"declare double @{name}({', '.join(['double'] * n)})"
        yield f"define internal {V} @lanes.{name}({', '.join(f'{V} %x{i}' for i in range(n))}) noinline {{"
        last = "poison"
        for k in range(lanes):
            for i in range(n):
                yield f"%x{i}.{k} = extractelement {V} %x{i}, i32 {k}"
            yield f"%y.{k} = call double @{name}({', '.join(f'double %x{i}.{k}' for i in range(n))})"
            yield f"%v.{k} = insertelement {V} {last}, double %y.{k}, i32 {k}"
            last = f"%v.{k}"
        yield f"ret {V} {last}\n}}"


_Step = tuple[int, tuple[int, ...], tuple[Any, ...]]
"""An operation, the numbers of the steps that it is of, and what else it takes: a constant's bits, which input, and the
place in an input or in the output."""


def _steps(function: ca.Function) -> list[_Step]:
    """All that a function does, each thing once."""
    numbers: dict[_Step, int] = {}
    made: dict[int, int] = {}  # the step that made what is in a register

    def constant(x: float) -> int:
        return numbers.setdefault((ca.OP_CONST, (), (pack(">d", x).hex(),)), len(numbers))

    for k in range(function.n_instructions()):
        op, of, to = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        if op == ca.OP_CONST:
            made[to[0]] = constant(function.instruction_constant(k))
            continue
        step: _Step
        if op in _BINARY:
            step = op, (made[of[0]], made[of[1]]), ()
        elif op == ca.OP_INPUT:
            step = op, (), tuple(of)
        elif op == ca.OP_OUTPUT:
            step = op, (made[of[0]],), (to[1],)
        elif op in _WITH_ITSELF:
            step = _WITH_ITSELF[op], (made[of[0]],) * 2, ()
        elif op in _OF_A_CONSTANT:
            op, x = _OF_A_CONSTANT[op]
            step = op, (constant(x), made[of[0]]), ()
        else:
            step = op, tuple([made[r] for r in of]), ()
        number = numbers.setdefault(step, len(numbers))
        if op != ca.OP_OUTPUT:
            made[to[0]] = number
    return list(numbers)


class _Written:
    """One function: its parts, and the entry that calls them for every group."""

    def __init__(self, name: str, function: ca.Function, lanes: int):
        if function.n_in() > 3 or function.n_out() != 1:
            raise ValueError(f"{name}: {function.n_in()} inputs and {function.n_out()} outputs; wanted at most 3 and 1")
        self.name, self.function, self.lanes = name, function, lanes
        self.steps = _steps(function)
        self.last: dict[int, int] = {}  # the last part that asks for what a step made
        for k, (_, of, _) in enumerate(self.steps):
            for d in of:
                self.last[d] = k // CHUNK
        self.constants: dict[str, int] = {}  # places of constants in memory, by their bits
        self.places: dict[int, int] = {}  # and of what steps leave for other parts
        self.places_until: dict[int, list[int]] = defaultdict(list)  # by the last part that asks for them
        self.free: list[int] = []
        self.count = 0  # of places

    def lines(self) -> Iterator[str]:
        """The text, line by line."""
        first = range(0, len(self.steps), CHUNK)
        for part, k in enumerate(first):
            yield f"define internal void @{self.name}.{part}({', '.join(['ptr'] * (_CONSTANTS + 1))}) {{"
            yield from self._part(part, range(k, min(k + CHUNK, len(self.steps))))
            yield "ret void\n}"
            self.free += self.places_until[part]
        yield from self._entry(len(first))

    def _entry(self, parts: int) -> Iterator[str]:
        sizes = [self.function.nnz_in(i) for i in range(self.function.n_in())] + [0, 0, 0]
        constants = ", ".join(f"%V splat (double 0x{bits})" for bits in self.constants)
        yield f"@{self.name}.c = internal constant [{len(self.constants)} x %V] [{constants}], align 64"
        yield f"define void @{self.name}(i64 %n, ptr %a0, ptr %a1, ptr %a2, ptr %out) {{"
        yield f"%w = alloca [{self.count} x %V], align 64"
        yield "br label %head\nhead:\n%i = phi i64 [0, %0], [%next, %body]"
        yield "%more = icmp slt i64 %i, %n\nbr i1 %more, label %body, label %end\nbody:"
        for what, size in zip(("a0", "a1", "a2", "out"), (*sizes[:3], self.function.nnz_out(0)), strict=True):
            yield f"%{what}.at = mul i64 %i, {size * self.lanes}"
            yield f"%{what}.p = getelementptr double, ptr %{what}, i64 %{what}.at"
        given = ", ".join(f"ptr {one}" for one in (*_GIVEN, f"@{self.name}.c"))
        for part in range(parts):
            yield f"call void @{self.name}.{part}({given})"
        yield "%next = add i64 %i, 1\nbr label %head\nend:\nret void\n}"

    def _part(self, part: int, span: range) -> Iterator[str]:
        # values have no names, which LLVM would have to read: they count on from the arguments and the block
        known: dict[int, int] = {}  # by the steps that they are of
        free = _CONSTANTS + 2
        for k in span:
            op, of, more = self.steps[k]
            if op in (ca.OP_CONST, ca.OP_INPUT):  # fetched where they are used
                continue
            for d in of:
                if d not in known:
                    array, at = self._kept(d)
                    yield f"getelementptr %V, ptr %{array}, i64 {at}\nload %V, ptr %{free}, align 8"
                    known[d] = free + 1
                    free += 2
            if op == ca.OP_OUTPUT:
                yield f"getelementptr %V, ptr %{_OUT}, i64 {more[0]}\nstore %V %{known[of[0]]}, ptr %{free}, align 8"
                free += 1
                continue
            if op in _COMPARED:
                one, other = (known[d] for d in of)
                yield f"fcmp {_COMPARED[op]} %V %{one}, %{other}\nuitofp <{self.lanes} x i1> %{free} to %V"
                free += 1
            else:
                yield self._operation(op, [known[d] for d in of])
            known[k] = free
            free += 1
            if self.last[k] > part:
                if not self.free:
                    self.free.append(self.count)
                    self.count += 1
                place = self.places[k] = self.free.pop()
                self.places_until[self.last[k]].append(place)
                yield f"getelementptr %V, ptr %{_WORK}, i64 {place}\nstore %V %{known[k]}, ptr %{free}, align 8"
                free += 1

    def _kept(self, k: int) -> tuple[int, int]:
        """The argument, and the place in it, that hold what a step made before this part."""
        op, _, more = self.steps[k]
        if op == ca.OP_CONST:
            return _CONSTANTS, self.constants.setdefault(more[0], len(self.constants))
        return (more[0], more[1]) if op == ca.OP_INPUT else (_WORK, self.places[k])

    def _operation(self, op: int, of: Sequence[int]) -> str:
        if op in _BINARY:
            return f"{_BINARY[op]} %V %{of[0]}, %{of[1]}"
        given = ", ".join(f"%V %{d}" for d in of)
        if op in _LLVMS:
            return f"call %V @llvm.{_LLVMS[op]}.v{self.lanes}f64({given})"
        if op in _LIBM:
            return f"call %V @lanes.{_LIBM[op]}({given})"
        raise ValueError(f"{self.name}: CasADi's operation {op} has no counterpart in native code")
