"""CasADi functions written as LLVM IR text, several copies side by side in the lanes of a vector.

An SX function is a flat list of scalar instructions on numbered registers. Each becomes one instruction on vectors
whose lanes are different copies. The list is cut into functions of two hundred instructions; what one of them leaves
for another goes through memory.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from struct import pack

import casadi as ca

CHUNK = 200  # instructions per LLVM function, a part of ours. Measured: see docs/measured.md, Machine code
_BINARY = {ca.OP_ADD: "fadd", ca.OP_SUB: "fsub", ca.OP_MUL: "fmul", ca.OP_DIV: "fdiv"}
_COMPARED = {ca.OP_LT: "olt", ca.OP_LE: "ole", ca.OP_EQ: "oeq", ca.OP_NE: "une"}
_LLVMS = {ca.OP_SQRT: "sqrt", ca.OP_FABS: "fabs", ca.OP_FMAX: "maxnum", ca.OP_FMIN: "minnum"}
_LIBM = {
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TAN: "tan", ca.OP_ASIN: "asin", ca.OP_ACOS: "acos", ca.OP_ATAN: "atan",
    ca.OP_ATAN2: "atan2", ca.OP_EXP: "exp", ca.OP_LOG: "log", ca.OP_POW: "pow", ca.OP_CONSTPOW: "pow",
}  # fmt: skip
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
    V = f"<{lanes} x double>"
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


class _Written:
    """One function: its parts, and the entry that calls them for every group."""

    def __init__(self, name: str, function: ca.Function, lanes: int):
        if function.n_in() > 3 or function.n_out() != 1:
            raise ValueError(f"{name}: {function.n_in()} inputs and {function.n_out()} outputs; wanted at most 3 and 1")
        self.name, self.function, self.lanes, self.V = name, function, lanes, f"<{lanes} x double>"
        n = function.n_instructions()
        self.ops = [function.instruction_id(k) for k in range(n)]
        self.inputs = [function.instruction_input(k) for k in range(n)]
        self.outputs = [function.instruction_output(k) for k in range(n)]
        self.operands: list[list[int]] = []  # the instructions that made them
        self.last = [-1] * n  # the last part that asks for what an instruction made
        self.registers = 1  # in memory
        made: dict[int, int] = {}  # the instruction that made what is in a register
        for k in range(n):
            self.operands.append([] if self.ops[k] == ca.OP_INPUT else [made[r] for r in self.inputs[k]])
            for d in self.operands[k]:
                self.last[d] = k // CHUNK
            if self.ops[k] != ca.OP_OUTPUT:
                made[self.outputs[k][0]] = k

    def lines(self) -> Iterator[str]:
        """The text, line by line."""
        first = range(0, len(self.ops), CHUNK)
        for part, k in enumerate(first):
            yield f"define internal void @{self.name}.{part}(ptr %a0, ptr %a1, ptr %a2, ptr %w, ptr %out) {{"
            yield from self._part(part, range(k, min(k + CHUNK, len(self.ops))))
            yield "ret void\n}"
        yield from self._entry(len(first))

    def _entry(self, parts: int) -> Iterator[str]:
        sizes = [self.function.nnz_in(i) for i in range(self.function.n_in())] + [0, 0, 0]
        yield f"define void @{self.name}(i64 %n, ptr %a0, ptr %a1, ptr %a2, ptr %out) {{"
        yield f"%w = alloca [{self.registers * self.lanes} x double], align 64"
        yield "br label %head\nhead:\n%i = phi i64 [0, %0], [%next, %body]"
        yield "%more = icmp slt i64 %i, %n\nbr i1 %more, label %body, label %end\nbody:"
        for what, size in zip(("a0", "a1", "a2", "out"), (*sizes[:3], self.function.nnz_out(0)), strict=True):
            yield f"%{what}.at = mul i64 %i, {size * self.lanes}"
            yield f"%{what}.p = getelementptr double, ptr %{what}, i64 %{what}.at"
        for part in range(parts):
            yield f"call void @{self.name}.{part}(ptr %a0.p, ptr %a1.p, ptr %a2.p, ptr %w, ptr %out.p)"
        yield "%next = add i64 %i, 1\nbr label %head\nend:\nret void\n}"

    def _part(self, part: int, span: range) -> Iterator[str]:
        names: dict[int, str] = {}
        for k in span:
            op, outputs = self.ops[k], self.outputs[k]
            if op in (ca.OP_CONST, ca.OP_INPUT):  # fetched where they are used
                continue
            for d in self.operands[k]:
                if d not in names:
                    names[d] = f"%v{d}"
                    if self.ops[d] == ca.OP_CONST:
                        names[d] = _constant(self.function.instruction_constant(d), self.lanes)
                    elif self.ops[d] == ca.OP_INPUT:
                        yield from self._loaded(d, f"%a{self.inputs[d][0]}", self.inputs[d][1])
                    else:
                        yield from self._loaded(d, "%w", self.outputs[d][0])
            x = [names[d] for d in self.operands[k]]
            if op == ca.OP_OUTPUT:
                yield from self._stored(k, x[0], "%out", outputs[1])
                continue
            yield from self._operation(k, op, x)
            names[k] = f"%v{k}"
            if self.last[k] > part:
                self.registers = max(self.registers, outputs[0] + 1)
                yield from self._stored(k, names[k], "%w", outputs[0])

    def _loaded(self, k: int, array: str, at: int) -> Iterator[str]:
        yield f"%p{k} = getelementptr double, ptr {array}, i64 {at * self.lanes}"
        yield f"%v{k} = load {self.V}, ptr %p{k}, align 8"

    def _stored(self, k: int, value: str, array: str, at: int) -> Iterator[str]:
        yield f"%q{k} = getelementptr double, ptr {array}, i64 {at * self.lanes}"
        yield f"store {self.V} {value}, ptr %q{k}, align 8"

    def _operation(self, k: int, op: int, x: list[str]) -> Iterator[str]:
        V, lanes = self.V, self.lanes
        if op in _BINARY:
            yield f"%v{k} = {_BINARY[op]} {V} {x[0]}, {x[1]}"
        elif op == ca.OP_SQ:
            yield f"%v{k} = fmul {V} {x[0]}, {x[0]}"
        elif op == ca.OP_TWICE:
            yield f"%v{k} = fadd {V} {x[0]}, {x[0]}"
        elif op == ca.OP_NEG:
            yield f"%v{k} = fneg {V} {x[0]}"
        elif op == ca.OP_INV:
            yield f"%v{k} = fdiv {V} {_constant(1.0, lanes)}, {x[0]}"
        elif op in _COMPARED:
            yield f"%c{k} = fcmp {_COMPARED[op]} {V} {x[0]}, {x[1]}"
            yield f"%v{k} = uitofp <{lanes} x i1> %c{k} to {V}"
        elif op in _LLVMS:
            yield f"%v{k} = call {V} @llvm.{_LLVMS[op]}.v{lanes}f64({', '.join(f'{V} {one}' for one in x)})"
        elif op in _LIBM:
            yield f"%v{k} = call {V} @lanes.{_LIBM[op]}({', '.join(f'{V} {one}' for one in x)})"
        else:
            raise ValueError(f"{self.name}: CasADi's operation {op} has no counterpart in native code")


def _constant(x: float, lanes: int) -> str:
    lane = f"double 0x{pack('>d', x).hex().upper()}"
    return f"<{', '.join([lane] * lanes)}>"
