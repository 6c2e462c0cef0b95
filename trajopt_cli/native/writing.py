"""CasADi functions written as LLVM IR text, several copies side by side in the lanes of a vector.

An SX function is a flat list of scalar instructions on numbered registers. Each becomes one instruction on vectors
whose lanes are different copies. The list is cut into functions of two hundred instructions; what one of them leaves
for another goes through memory.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from struct import pack

import casadi as ca

CHUNK = 200  # instructions per LLVM function. Measured: see CONTRIBUTING.md, Machine code
_BINARY = {ca.OP_ADD: "fadd", ca.OP_SUB: "fsub", ca.OP_MUL: "fmul", ca.OP_DIV: "fdiv"}
_COMPARED = {ca.OP_LT: "olt", ca.OP_LE: "ole", ca.OP_EQ: "oeq", ca.OP_NE: "une"}
_OF_ONE = {ca.OP_SQRT: "llvm.sqrt", ca.OP_FABS: "llvm.fabs"}
_OF_TWO = {ca.OP_FMAX: "llvm.maxnum", ca.OP_FMIN: "llvm.minnum"}
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
    return "\n".join(
        [*_libm(lanes), *(line for name, one in functions.items() for line in _Written(name, one, lanes).lines())]
    )


def _libm(lanes: int) -> Iterator[str]:
    """The C library's functions lane by lane."""
    V = f"<{lanes} x double>"
    for name, n in (("sqrt", 1), ("fabs", 1), ("maxnum", 2), ("minnum", 2)):
        yield f"declare {V} @llvm.{name}.v{lanes}f64({', '.join([V] * n)})"
    for name, n in LIBM.items():
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
    """One function: its chunks, and the entry that calls them for every group."""

    def __init__(self, name: str, function: ca.Function, lanes: int):
        if function.n_in() > 3 or function.n_out() != 1:
            raise ValueError(f"{name}: {function.n_in()} inputs and {function.n_out()} outputs; wanted at most 3 and 1")
        self.name, self.function, self.lanes, self.V = name, function, lanes, f"<{lanes} x double>"
        self.sizes = [function.nnz_in(i) for i in range(function.n_in())] + [0] * (3 - function.n_in())
        self.registers: set[int] = set()

    def lines(self) -> Iterator[str]:
        """The text, line by line."""
        f = self.function
        n = f.n_instructions()
        ops = [f.instruction_id(k) for k in range(n)]
        inputs, outputs = [f.instruction_input(k) for k in range(n)], [f.instruction_output(k) for k in range(n)]
        chunk = [k // CHUNK for k in range(n)]
        # the instruction that made each operand, and the last chunk in which a value is asked for
        made: dict[int, int] = {}
        operands: list[list[int]] = []
        last = [-1] * n
        for k in range(n):
            operands.append([] if ops[k] == ca.OP_INPUT else [made[r] for r in inputs[k]])
            for d in operands[k]:
                last[d] = chunk[k]
            if ops[k] != ca.OP_OUTPUT and outputs[k]:
                made[outputs[k][0]] = k
        chunks = range(0, n, CHUNK)
        bodies: list[str] = []
        for number, first in enumerate(chunks):
            bodies.append(f"define internal void @{self.name}.{number}(ptr %a0, ptr %a1, ptr %a2, ptr %w, ptr %out) {{")
            bodies += self._chunk(number, range(first, min(first + CHUNK, n)), ops, inputs, outputs, operands, last)
            bodies.append("ret void\n}")
        yield from bodies
        yield from self._entry(len(chunks))

    def _entry(self, chunks: int) -> Iterator[str]:
        registers = max(self.registers, default=0) + 1
        steps = [*self.sizes, self.function.nnz_out(0)]
        yield f"define void @{self.name}(i64 %n, ptr %a0, ptr %a1, ptr %a2, ptr %out) {{"
        yield f"%w = alloca [{registers * self.lanes} x double], align 64"
        yield "br label %head\nhead:\n%i = phi i64 [0, %0], [%next, %body]"
        yield "%more = icmp slt i64 %i, %n\nbr i1 %more, label %body, label %end\nbody:"
        for what, size in zip(("a0", "a1", "a2", "out"), steps, strict=True):
            yield f"%{what}.at = mul i64 %i, {size * self.lanes}"
            yield f"%{what}.p = getelementptr double, ptr %{what}, i64 %{what}.at"
        for number in range(chunks):
            yield f"call void @{self.name}.{number}(ptr %a0.p, ptr %a1.p, ptr %a2.p, ptr %w, ptr %out.p)"
        yield "%next = add i64 %i, 1\nbr label %head\nend:\nret void\n}"

    def _chunk(
        self, number: int, span: range, ops: list[int], inputs: list[list[int]], outputs: list[list[int]],
        operands: list[list[int]], last: list[int],
    ) -> Iterator[str]:  # fmt: skip
        f, V, lanes = self.function, self.V, self.lanes
        names: dict[int, str] = {}

        def value(d: int) -> str:
            """The name of the value that instruction d made; fetched where it was made elsewhere."""
            if d not in names:
                if ops[d] == ca.OP_CONST:
                    names[d] = _constant(f.instruction_constant(d), lanes)
                    return names[d]
                names[d] = f"%v{d}"
                if ops[d] == ca.OP_INPUT:
                    i, at = inputs[d]
                    pointer, offset = f"%a{i}", at * lanes
                else:
                    pointer, offset = "%w", outputs[d][0] * lanes
                    self.registers.add(outputs[d][0])
                found.append(f"%p{d} = getelementptr double, ptr {pointer}, i64 {offset}")
                found.append(f"%v{d} = load {V}, ptr %p{d}, align 8")
            return names[d]

        for k in span:
            op = ops[k]
            if op in (ca.OP_CONST, ca.OP_INPUT):
                continue
            found: list[str] = []
            x = [value(d) for d in operands[k]]
            yield from found
            if op == ca.OP_OUTPUT:
                yield f"%q{k} = getelementptr double, ptr %out, i64 {outputs[k][1] * lanes}"
                yield f"store {V} {x[0]}, ptr %q{k}, align 8"
                continue
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
            elif op in _OF_ONE or op in _OF_TWO:
                intrinsic = (_OF_ONE | _OF_TWO)[op]
                yield f"%v{k} = call {V} @{intrinsic}.v{lanes}f64({', '.join(f'{V} {one}' for one in x)})"
            elif op in _LIBM:
                yield f"%v{k} = call {V} @lanes.{_LIBM[op]}({', '.join(f'{V} {one}' for one in x)})"
            else:
                raise ValueError(f"{self.name}: CasADi's operation {op} has no counterpart in native code")
            names[k] = f"%v{k}"
            if last[k] > number:
                self.registers.add(outputs[k][0])
                yield f"%q{k} = getelementptr double, ptr %w, i64 {outputs[k][0] * lanes}"
                yield f"store {V} %v{k}, ptr %q{k}, align 8"


def _constant(x: float, lanes: int) -> str:
    lane = f"double 0x{pack('>d', x).hex().upper()}"
    return f"<{', '.join([lane] * lanes)}>"
